"""The page by keyboard alone: walking points, reaching everything, copying, sorting, large pictures."""
from selenium.webdriver.common.keys import Keys

from page_case import By, Page


class Keyboard(Page):
    def test_arrows_walk_the_points(self):
        self.browser.run("document.querySelector('.canvas .point[tabindex=\"0\"]').focus()")
        self.press(Keys.HOME)
        seen = [self.focused("dataset.cell")]
        for _ in range(len(self.expected("layers")) - 1):
            self.press(Keys.ARROW_RIGHT)
            seen.append(self.focused("dataset.cell"))
        self.assertEqual(len(set(seen)), len(self.expected("layers")))
        times = [self.cells[int(cell)]["cpu_time"] for cell in seen]
        self.assertEqual(times, sorted(times))
        self.assertEqual(self.find(".details").get_attribute("data-cell"),
                         self.cells[int(seen[-1])]["run_name"])
        self.assertNotEqual(self.browser.run(
            "return getComputedStyle(document.activeElement).outlineStyle"), "none")

    def test_tab_reaches_all_that_can_be_used(self):
        # One stop a plot; hidden details and the closed dialog are no stops.
        expected = self.browser.run("""
            window.wanted = new Set([...document.querySelectorAll(
              'a, button, input, select, summary, [tabindex="0"]')].filter((n) =>
                n.checkVisibility() && !n.matches('.point[tabindex="-1"]') &&
                !(n.type === 'radio' && !n.checked)));
            document.activeElement.blur();
            window.scrollTo(0, 0);
            window.unmarked = [];
            document.addEventListener('focusin', ({target}) => {
              window.wanted.delete(target);
              const {outlineStyle, outlineWidth} = getComputedStyle(target);
              if (outlineStyle === 'none' || parseFloat(outlineWidth) < 2)
                window.unmarked.push(target.outerHTML.slice(0, 90));
            });
            return window.wanted.size""")
        self.assertGreater(expected, 100)
        for _ in range(expected // 40 + 2):
            self.press(*[Keys.TAB] * 40)
        self.assertEqual(
            self.browser.run("return [...window.wanted].map(n => n.outerHTML.slice(0, 90))"), [])
        self.assertEqual(self.browser.run("return window.unmarked"), [])

    def test_copy_button(self):
        button = self.find(".details .copy")
        command = self.find(".details .command code").text
        self.browser.run("window.copied = []; document.addEventListener('copy', () =>"
                         "window.copied.push(document.activeElement.value))")
        button.send_keys(Keys.ENTER)
        said = self.find(".details .said")
        self.browser.wait(lambda: said.text, "the copy button says nothing")
        self.assertEqual(said.text, "copied")
        # Without the clipboard's interface the page copies from a field of its own.
        self.browser.run("Object.defineProperty(navigator, 'clipboard', {value: undefined});"
                         "document.querySelector('.said').value = ''")
        button.send_keys(Keys.ENTER)
        self.browser.wait(lambda: said.text, "the copy button says nothing")
        self.assertEqual((said.text, self.browser.run("return window.copied.pop()")),
                         ("copied", command))

    def test_tables_sort_both_ways_with_absent_values_last(self):
        def column():
            return self.browser.run("""
                return [...document.querySelector('table.cells').tBodies[0].rows].map((r) =>
                  r.cells[6].dataset.value === undefined ? null : Number(r.cells[6].dataset.value))""")
        header = self.find("table.cells thead th:nth-child(7)")
        for direction, reverse in (("ascending", False), ("descending", True)):
            header.find_element(By.TAG_NAME, "button").send_keys(Keys.ENTER)
            self.assertEqual(header.get_attribute("aria-sort"), direction)
            values = column()
            numbers = [v for v in values if v is not None]
            self.assertEqual(numbers, sorted(numbers, reverse=reverse))
            self.assertEqual(values[len(numbers):], [None] * (len(values) - len(numbers)))
            self.assertGreater(len(values), len(numbers))

    def test_a_picture_opens_large_and_closes(self):
        self.find(".gallery .card:not(.truth) .zoom").send_keys(Keys.ENTER)
        self.assertTrue(self.find("dialog img").is_displayed())
        before = self.find("dialog img").get_attribute("src")
        self.find("dialog button[data-role=truth]").send_keys(Keys.SPACE)
        self.assertEqual(self.find("dialog button[data-role=truth]").get_attribute("aria-pressed"), "true")
        self.assertTrue(before)
        self.press(Keys.ESCAPE)
        self.assertFalse(self.find("dialog").is_displayed())
