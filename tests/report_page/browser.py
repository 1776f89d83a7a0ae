"""A headless Chromium on one file, and what its logs say. Needs Debian's chromium, chromium-driver
and python3-selenium.
"""
import base64
import json
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service


class Browser:
    def __init__(self, driver_path):
        options = Options()
        # As root in a container: no sandbox, and no large /dev/shm.
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                         "--disable-gpu", "--hide-scrollbars", "--window-size=1440,900"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(driver_path), options=options)
        self.driver.set_page_load_timeout(30)

    def quit(self):
        self.driver.quit()

    def shape(self, width, height=900, dark=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})

    def open(self, path, **shape):
        self.shape(**{"width": 1440, **shape})
        self.driver.get("file://" + path)
        self.wait_drawn(0)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def drawn(self):
        """How many times all plots have been drawn."""
        return int(self.run("return document.documentElement.dataset.drawn || 0"))

    def wait_drawn(self, before):
        self.wait(lambda: self.drawn() > before, "the plots are not drawn")

    def redraw(self, action):
        before = self.drawn()
        action()
        self.wait_drawn(before)

    def wait(self, done, what):
        end = time.monotonic() + 10
        while not done():
            if time.monotonic() > end:
                raise AssertionError(what + ": " + str(self.console()))
            time.sleep(0.02)

    def console(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """URLs asked for since the last call."""
        out = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                out.append(message["params"]["request"]["url"])
        return out

    def screenshot(self, path, whole=True):
        height = self.run("return document.documentElement.scrollHeight") if whole else 900
        picture = self.driver.execute_cdp_cmd("Page.captureScreenshot", {
            "captureBeyondViewport": True,
            "clip": {"x": 0, "y": 0, "width": self.run("return innerWidth"), "height": height,
                     "scale": 1}})
        with open(path, "wb") as file:
            file.write(base64.b64decode(picture["data"]))
