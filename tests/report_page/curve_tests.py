"""Plots of lines: hard cases over their dangerous parameter."""
from page_case import Page


class Curves(Page):
    def lines(self, curve):
        """Lines of values and of limits, and crosses where it breaks."""
        return self.browser.run("""
            const plot = document.querySelector(`.lines[data-curve="${arguments[0]}"]`);
            const paths = [...plot.querySelectorAll('.mark-line path')];
            const dashed = (path) => path.getAttribute('stroke-dasharray') === '2,4';
            return [paths.filter((p) => !dashed(p)).length, paths.filter(dashed).length,
                    plot.querySelectorAll('.breaks path').length];""", str(curve))

    def test_each_numeric_case_has_a_curve(self):
        self.assertEqual(self.count("#stability .lines svg"), 2)
        # Both techniques on both APIs; one limit for all. OpenGL breaks where there is no number,
        # which has no place on the plot; its line is named below it.
        self.assertEqual(self.lines(0), [4, 1, 0])
        self.assertEqual(self.lines(1), [2, 1, 2])
        text = self.find("#stability .curve:first-child figcaption").text
        self.assertIn("breaks at 1000000", text)
        self.assertNotIn("undefined", self.find("#stability").text)

    def test_axes_span_magnitudes_and_hold_zero(self):
        labels = self.browser.run("""
            return [...document.querySelectorAll('.lines[data-curve="0"] .role-axis-label text')]
              .map((t) => t.textContent)""")
        self.assertIn("1e+6", labels)
        self.assertIn("0", labels)
        self.assertIn("1e-3", labels)

    def test_filters_act_on_curves_and_verdicts(self):
        self.browser.redraw(self.find("input[value=opengl]").click)
        self.assertEqual(self.lines(0), [2, 1, 0])
        self.browser.redraw(self.find("input[value=CSSM2]").click)
        self.assertEqual(self.lines(0), [1, 1, 0])
        self.assertIn("No line", self.find(".lines[data-curve='1']").text)
        self.assertEqual(self.count(".verdicts thead th:not([hidden])"), 2)

    def test_verdicts_open_to_what_was_found(self):
        cell = self.find(".verdicts tbody tr:nth-child(2) td:nth-child(3)")
        self.assertEqual(cell.text, "✕ FAILS 1/2")
        cell.find_element("css selector", "summary").click()
        for words in ("half a step", "no number at offset, m 1000000", "why of G2", "must hold"):
            self.assertIn(words, cell.text)
