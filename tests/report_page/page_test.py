#!/usr/bin/env python3
"""The report's page in a real browser: what it asks for, draws, filters and switches, by pointer and
by keyboard, at the width of a phone and of a desk.

Run as: page_test.py BENCH SCREENSHOT_FOLDER [unittest arguments]. Exit code 77: no browser here.
"""
import os
import sys
import unittest

import synthetic_run

try:
    from selenium.webdriver.common.action_chains import ActionChains
except ImportError:
    print("python3-selenium is not there")
    # Where everything must be tested, this is a failure.
    sys.exit(1 if os.environ.get("SHADOWBENCH_REQUIRE") else 77)

from curve_tests import Curves  # the test runner finds them here
from keyboard_tests import Keyboard
from page_case import DRIVER, SCREENSHOTS, By, Page


class Loading(Page):
    def test_nothing_is_asked_for_and_nothing_complains(self):
        self.browser.driver.get("about:blank")
        self.browser.requests()
        self.browser.open(self.html)
        self.assertEqual(self.browser.console(), [])
        urls = [u for u in self.browser.requests() if not u.startswith("data:")]
        self.assertEqual(urls, ["file://" + self.html])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource')"
                                          ".filter(e => !e.name.startsWith('data:')).length"), 0)

    def test_hostile_text_stays_text(self):
        titles = self.browser.run("return [...document.querySelectorAll('h2')].map(h => h.textContent)")
        self.assertIn(synthetic_run.HOSTILE + ", 128×128", titles)
        self.assertEqual(self.count("script:not([type])"), 2)
        self.assertEqual(self.count("b"), 0)

    def test_the_policy_stops_scripts_that_are_not_ours(self):
        self.browser.run("const s = document.createElement('script'); s.textContent = 'window.bad = 1';"
                         "document.body.append(s)")
        self.assertIsNone(self.browser.run("return window.bad"))
        self.assertIn("Content Security Policy", " ".join(self.browser.console()))

    def test_every_shown_picture_has_its_file(self):
        self.assertEqual(self.browser.run(
            "return [...document.images].filter(i => !i.complete || !i.naturalWidth).length"), 0)
        self.assertGreater(self.count(".gallery img"), 40)
        self.assertEqual(self.browser.run("""
            const sources = document.documentElement.outerHTML.match(/src="data:/g).length;
            return new Set([...document.images].map(i => i.src)).size <= sources"""), True)

    def test_tables_stay_without_scripts(self):
        self.browser.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
        try:
            self.browser.driver.get("file://" + self.html)
            self.assertEqual(len(self.browser.driver.find_elements(
                By.CSS_SELECTOR, "table.cells tbody tr")), len(self.cells))
            self.assertTrue(self.find("table.cells").is_displayed())
            self.assertTrue(self.find("noscript p").is_displayed())
            self.assertFalse(self.find(".filters").is_displayed())
            self.assertFalse(self.find("figure.plot").is_displayed())
        finally:
            self.browser.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled",
                                                {"value": False})


class Plots(Page):
    def test_every_cell_with_time_and_error_is_a_point(self):
        for part, scene in enumerate(synthetic_run.SCENES):
            expected = len(self.expected(scene))
            self.assertGreater(expected, 10)
            self.assertEqual(self.points(part), expected)
        self.assertEqual(self.count(".point"), sum(len(self.expected(s)) for s in
                                                   synthetic_run.SCENES))
        self.assertEqual(self.count(".zero-label text"), 2)

    def test_points_off_the_front_are_faint_and_the_front_goes_through_the_others(self):
        for part, scene in enumerate(synthetic_run.SCENES):
            states = self.browser.run("""
                const canvas = document.querySelectorAll('.canvas')[arguments[0]];
                const faint = [...canvas.querySelectorAll('.points path')].filter(
                  (path) => Number(path.getAttribute('fill-opacity')) < 0.5).length;
                return [faint, canvas.querySelectorAll('.mark-line path').length];""", part)
            self.assertEqual(states, [2, 2])  # kernel:1 on each API; a front on each

    def test_filters_act_on_plots_tables_and_pictures(self):
        rows = self.count("table.cells tbody tr")
        self.browser.redraw(self.find("input[value=ShadowMap]").click)
        left = [e for e in self.expected("layers") if e["technique"] != "ShadowMap"]
        self.assertEqual(self.points(), len(left))
        hidden = self.browser.run("return document.querySelectorAll('[data-technique=ShadowMap]')"
                                  ".length === document.querySelectorAll("
                                  "'[data-technique=ShadowMap][hidden]').length")
        self.assertTrue(hidden)
        self.browser.redraw(self.find("input[value=opengl]").click)
        self.assertEqual(self.points(), len([e for e in left if e["backend"] != "opengl"]))
        self.assertGreater(self.count(".card:not([hidden])"), 5)
        self.browser.redraw(self.find("select[name=scene] option[value=layers]").click)
        self.assertEqual(self.count("section.scene:not([hidden])"), 1)
        self.assertRegex(self.find("#shown").text, rf"^\d+ of {rows} cells$")
        self.browser.redraw(self.find("button[type=reset]").click)
        self.assertEqual(self.points(), len(self.expected("layers")))
        self.assertEqual(self.count("section.scene:not([hidden])"), 2)

    def test_all_filtered_out_says_so(self):
        for value in ("none", "ShadowMap", "CSSM2", "RayTraced"):
            self.browser.redraw(self.find(f"input[value={value}]").click)
        self.assertEqual(self.points(), 0)
        self.assertIn("No point", self.find(".canvas").text)

    def test_the_kind_of_error_switches_axis_points_and_tables(self):
        self.assertIn("Visibility RMSE", self.find(".canvas svg").get_attribute("textContent"))
        before = self.find(".points path:last-child").get_attribute("transform")
        self.browser.redraw(self.find("input[value=image]").click)
        self.assertIn("Image RMSE", self.find(".canvas svg").get_attribute("textContent"))
        self.assertEqual(self.points(), len(self.expected("layers")))
        self.assertNotEqual(before, self.find(".points path:last-child").get_attribute("transform"))
        self.assertEqual(self.count(".pair[data-kind=visibility]:not([hidden])"), 0)
        self.assertEqual(self.count(".pair[data-kind=image]:not([hidden])"), 2)

    def test_pointer_shows_a_cell_and_a_click_keeps_it(self):
        button = self.find(".canvas .point[data-cell='14']")
        name = self.cells[14]["run_name"]
        self.browser.run("arguments[0].scrollIntoView({block: 'center'})", button)
        move = ActionChains(self.browser.driver, duration=0).move_to_element(button)
        move.perform()
        self.assertEqual(self.find(".details").get_attribute("data-cell"), name)
        self.assertEqual(self.find(".details .command code").text, self.cells[14]["command"])
        self.assertIn("RMSE", self.find(".details dl").text)
        self.assertTrue(self.find(".details img").get_attribute("src").startswith("data:image/png"))
        move.click().perform()
        other = self.find(".canvas .point[data-cell='1']")
        ActionChains(self.browser.driver, duration=0).move_to_element(other).perform()
        self.assertEqual(self.find(".details").get_attribute("data-cell"), name)

    def test_a_button_lies_on_each_point(self):
        off = self.browser.run("""
            const centre = (n) => { const b = n.getBoundingClientRect();
                                    return [b.x + b.width / 2, b.y + b.height / 2]; };
            const marks = [...document.querySelectorAll('.points path')].map(centre);
            return [...document.querySelectorAll('.point')].map(centre).map(([x, y]) =>
              Math.min(...marks.map(([a, b]) => Math.hypot(a - x, b - y))));""")
        self.assertLess(max(off), 2.5)


class Shapes(Page):
    def test_no_sideways_scrolling_and_screenshots(self):
        for width in (390, 1440):
            for dark in (False, True):
                self.browser.open(self.html, width=width, dark=dark)
                self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"),
                                     width)
                for plot in (".canvas svg", ".lines svg"):
                    self.assertLessEqual(self.browser.run(
                        "return Math.max(...[...document.querySelectorAll(arguments[0])].map("
                        "(svg) => svg.getBoundingClientRect().right))", plot), width)
                name = f"{width}-{'dark' if dark else 'light'}.png"
                self.browser.screenshot(os.path.join(SCREENSHOTS, name))

    def test_plots_follow_light_and_dark_and_width(self):
        fill = "return document.querySelector('.points path').getAttribute('fill')"
        before = self.browser.run(fill)
        self.browser.redraw(lambda: self.browser.shape(1440, dark=True))
        self.assertNotEqual(before, self.browser.run(fill))
        self.browser.redraw(lambda: self.browser.shape(390, dark=True))
        self.assertEqual(self.points(), len(self.expected("layers")))
        self.assertLess(self.find(".canvas svg").size["width"], 391)


if __name__ == "__main__":
    if DRIVER is None:
        print("chromium-driver is not there")
        sys.exit(1 if os.environ.get("SHADOWBENCH_REQUIRE") else 77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
