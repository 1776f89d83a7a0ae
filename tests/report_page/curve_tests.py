"""Plots of lines: hard cases over their dangerous parameter, and figures over theirs."""
from page_case import Page


class Curves(Page):
    def plot(self, section, place):
        return self.find(f"{section} .curve:nth-child({place}) .lines")

    def lines(self, section, place):
        """Lines of values and of limits, and crosses where it breaks."""
        return self.browser.run("""
            const paths = [...arguments[0].querySelectorAll('.mark-line path')];
            const dashed = (path) => path.getAttribute('stroke-dasharray') === '2,4';
            return [paths.filter((p) => !dashed(p)).length, paths.filter(dashed).length,
                    arguments[0].querySelectorAll('.breaks path').length];""",
                                self.plot(section, place))

    def test_each_numeric_case_has_a_curve(self):
        self.assertEqual(self.count("#stability .lines svg"), 2)
        # Both techniques on both APIs; one limit for all. OpenGL breaks where there is no number,
        # which has no place on the plot; its line is named below it.
        self.assertEqual(self.lines("#stability", 1), [4, 1, 0])
        self.assertEqual(self.lines("#stability", 2), [2, 1, 2])
        text = self.find("#stability .curve:first-child figcaption").text
        self.assertIn("breaks at 1000000", text)
        self.assertNotIn("undefined", self.find("#stability").text)

    def test_axes_span_magnitudes_and_hold_zero(self):
        labels = self.browser.run("""
            return [...arguments[0].querySelectorAll('.role-axis-label text')]
              .map((t) => t.textContent)""", self.plot("#stability", 1))
        self.assertIn("1e+6", labels)
        self.assertIn("0", labels)
        self.assertIn("1e-3", labels)

    def test_filters_act_on_curves_and_verdicts(self):
        self.browser.redraw(self.find("input[value=opengl]").click)
        self.assertEqual(self.lines("#stability", 1), [2, 1, 0])
        self.browser.redraw(self.find("input[value=CSSM2]").click)
        self.assertEqual(self.lines("#stability", 1), [1, 1, 0])
        self.assertIn("No line", self.plot("#stability", 2).text)
        self.assertEqual(self.count(".verdicts thead th:not([hidden])"), 2)

    def test_verdicts_open_to_what_was_found(self):
        cell = self.find(".verdicts tbody tr:nth-child(2) td:nth-child(3)")
        self.assertEqual(cell.text, "✕ FAIL 1/2")
        cell.find_element("css selector", "summary").click()
        for words in ("half a step", "no number at offset, m 1000000", "why of G2", "must hold"):
            self.assertIn(words, cell.text)

    def test_figures_have_plots_tables_and_pictures_of_their_kind(self):
        # Four times over the knob, on two APIs.
        self.assertEqual(self.count("#figure0 .lines svg"), 4)
        self.assertEqual(self.lines("#figure0", 4), [2, 0, 0])
        self.assertEqual(self.browser.run("""
            return [...document.querySelectorAll('.figure-of')].map((section) =>
              [section.querySelectorAll('table').length > 0,
               section.querySelectorAll('.gallery .card').length])"""),
                         [[True, 0], [True, 9], [True, 4], [True, 4], [True, 0]])
        self.assertIn("three, <b>stated</b>", self.find("#figure4").text)
        self.assertEqual(self.count(".figure-of b"), 0)
        # Each picture stands beside its truth, and opens large.
        self.assertEqual(self.browser.run(
            "return [...document.querySelectorAll('#figure1 .card')].filter("
            "(card) => card.querySelectorAll('img').length !== 3).length"), 1)  # the ray tracer's
        self.find("#figure1 .zoom").click()
        self.assertTrue(self.find("dialog[open] img").get_attribute("src"))

    def test_figures_say_what_was_reproduced_and_what_is_missing(self):
        verdicts = [node.text for node in self.browser.driver.find_elements(
            "css selector", "#figure0 .statements .verdict")]
        self.assertEqual(verdicts, ["– not measured", "✓ reproduced", "✕ NOT reproduced"])
        text = self.find("#figure0").text
        for words in ("kernel:63/128x128", "Why: <b>otherwise</b>", "(vulkan)", "1 cell is missing"):
            self.assertIn(words, text if "kernel:63" not in words else self.find(
                "#figure0 .notice").get_attribute("textContent"))
