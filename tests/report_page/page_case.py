"""What the tests of the page share: one synthetic run, its page, one browser, and questions to it."""
import atexit
import functools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

import synthetic_run
from browser import Browser

DRIVER = shutil.which("chromedriver")
BENCH, SCREENSHOTS = (os.path.abspath(path) for path in sys.argv[1:3])


@functools.cache
def start():
    """One run, one page and one browser for all tests; each test loads the page anew."""
    folder = tempfile.TemporaryDirectory()
    atexit.register(folder.cleanup)
    results = synthetic_run.write(folder.name)
    subprocess.run([BENCH, "report", results], check=True, stdout=subprocess.DEVNULL)
    os.makedirs(SCREENSHOTS, exist_ok=True)
    Page.html = os.path.join(folder.name, "results.html")
    with open(results) as file:
        Page.cells = [e for e in json.load(file)["benchmarks"] if e["run_type"] == "aggregate"]
    Page.browser = Browser(DRIVER)
    atexit.register(Page.browser.quit)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start()

    def setUp(self):
        self.browser.open(self.html)
        self.browser.console()

    def tearDown(self):
        self.assertEqual(self.browser.console(), [])

    def count(self, selector):
        return self.browser.run("return document.querySelectorAll(arguments[0]).length", selector)

    def find(self, selector):
        return self.browser.driver.find_element(By.CSS_SELECTOR, selector)

    def points(self, part=0):
        return self.browser.run(
            "return [...document.querySelectorAll('.canvas')[arguments[0]]"
            ".querySelectorAll('.points path')].length", part)

    def expected(self, scene, **keys):
        return [e for e in self.cells if e["scene"] == scene and e["status"] == "ok" and
                not e["contamination"] and all(e[k] in v for k, v in keys.items())]

    def press(self, *keys):
        ActionChains(self.browser.driver).send_keys(*keys).perform()

    def focused(self, expression):
        return self.browser.run("return document.activeElement." + expression)
