#!/usr/bin/python3
"""A page in a headless Chromium, by Selenium: for tests of pages, and for looking at them.

    plots/browser.py PAGE.html OUT.png [--width 390] [--height 800] [--dark]   takes a picture of the whole page
"""
import argparse
import base64
import json
import pathlib
import shutil

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:  # tests are skipped then
    webdriver = None

OPTIONS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars")


def missing():
    """The Debian package that is missing, or None."""
    if webdriver is None:
        return "python3-selenium"
    return next((name for name, program in (("chromium", "chromium"), ("chromium-driver", "chromedriver"))
                 if shutil.which(program) is None), None)


class Browser:
    """One page in one browser. Collects what goes to the console, errors, and requests other than for the page itself (of a served page:
    elsewhere than below its address)."""

    def __init__(self, width=1280, height=900, dark=False):
        self.problems = []
        self.requests = []
        self._page = self._own = None
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for option in OPTIONS:
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self._driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.show_as(width, height, dark)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._driver.quit()

    def show_as(self, width, height, dark):
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600}
        self._driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self._driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})

    def open(self, page):
        """Opens a file, or an address that begins with http://. Returns when the page is loaded, with its scripts run."""
        is_address = str(page).startswith("http://")
        address = str(page) if is_address else pathlib.Path(page).resolve().as_uri()
        self._page = address.split("#")[0]
        self._own = self._page if is_address else None
        self._driver.get("about:blank")  # so that an address with another part behind # is loaded, too
        self._driver.get(address)

    def save_downloads_in(self, folder):
        self._driver.execute_cdp_cmd("Page.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder)})

    def dispatch(self, command, **parameters):
        """Sends an event as of a mouse, a finger or a key: a command of Chromium's Input domain."""
        self._driver.execute_cdp_cmd(f"Input.{command}", parameters)

    def choose_file(self, selector, path):
        self._driver.find_element("css selector", selector).send_keys(str(path))

    def value(self, expression):
        """The value of a JavaScript expression."""
        return self._driver.execute_script(f"return ({expression});")

    def run(self, statements):
        """Runs JavaScript statements."""
        self._driver.execute_script(statements)

    def press(self, keys):
        """Sends keys (selenium.webdriver.common.keys.Keys) to the element that has the focus."""
        self._driver.switch_to.active_element.send_keys(keys)

    def collect(self):
        """Adds what the page logged and requested since the last call to `problems` and `requests`."""
        self.problems += [entry["message"] for entry in self._driver.get_log("browser")]
        for entry in self._driver.get_log("performance"):
            event = json.loads(entry["message"])["message"]
            if event["method"] == "Network.requestWillBeSent":
                url = event["params"]["request"]["url"]
                is_own = url.split("#")[0] == self._page or self._own is not None and url.startswith(self._own)
                if not is_own and not url.startswith(("data:", "about:", "blob:")):
                    self.requests.append(url)

    def picture(self, path):
        """Writes the whole page as PNG."""
        parameters = {"format": "png", "captureBeyondViewport": True}
        answer = self._driver.execute_cdp_cmd("Page.captureScreenshot", parameters)
        pathlib.Path(path).write_bytes(base64.b64decode(answer["data"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page")
    parser.add_argument("output")
    parser.add_argument("--width", type=int, default=1280)
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--dark", action="store_true")
    arguments = parser.parse_args()
    with Browser(arguments.width, arguments.height, arguments.dark) as browser:
        browser.open(arguments.page)
        browser.picture(arguments.output)
        browser.collect()
        for problem in browser.problems + browser.requests:
            print(problem)


if __name__ == "__main__":
    main()
