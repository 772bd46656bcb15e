"""A real browser that opens a page from the disk and is driven by mouse, keys and touch, by its WebDriver.

Chromium needs no display; WebKit and Firefox get one of their own, from Xvfb.
"""
import contextlib
import os
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver.chrome.service import Service as ChromiumService
from selenium.webdriver.firefox.service import Service as FirefoxService
from selenium.webdriver.webkitgtk.options import Options as WebKitOptions

ENGINES = ("chromium", "webkit", "firefox")

# Stands in the page before its own scripts: notes how long each animation frame keeps the main thread, what is
# downloaded, and what the console is told.
BEFORE = """
window.frames_ms = [];
const request = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = (frame) => request((time) => {
  const began = performance.now();
  frame(time);
  window.frames_ms.push(performance.now() - began);
});
window.downloads = {};
const click = HTMLAnchorElement.prototype.click;
HTMLAnchorElement.prototype.click = function () {
  if (!this.download) return click.call(this);
  const name = this.download;
  fetch(this.href).then((answer) => answer.text()).then((text) => { window.downloads[name] = text; });
};
window.console_lines = [];
for (const kind of ["warn", "error"]) {
  const tell = console[kind].bind(console);
  console[kind] = (...parts) => { window.console_lines.push(parts.join(" ")); tell(...parts); };
}
"""

# WebDriver's names of keys that type no letter.
KEYS = {"PageDown": "\ue00f", "PageUp": "\ue00e", "End": "\ue010", "Home": "\ue011", "Escape": "\ue00c",
        "Enter": "\ue007", "F5": "\ue035", "F1": "\ue031"}
CONTROL = "\ue009"
BUTTONS = {"left": 0, "right": 2}


class Browser:
    """One tab, with the profile of a user who comes back if `profile` is given again."""

    # The engine of every browser that is started.
    engine = "chromium"

    def __init__(self, size=(1280, 800), touch=False, profile=None):
        # A window of the others is not as narrow as a phone.
        self.size = size if self.engine == "chromium" else (max(size[0], 640), size[1])
        self.own = profile is None
        self.profile = profile or tempfile.mkdtemp(prefix="pinhole-page-")
        # Pages with something before their scripts.
        self.pages = Path(self.profile) / "pages"
        self.display = None
        self.driver = getattr(self, self.engine)(touch)
        if self.engine != "chromium":
            self.resize()

    def chromium(self, touch):
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                         "--enable-unsafe-swiftshader", f"--user-data-dir={self.profile}",
                         f"--window-size={self.size[0]},{self.size[1]}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=ChromiumService(shutil.which("chromedriver")), options=options)
        self.cdp("Emulation.setDeviceMetricsOverride", width=self.size[0], height=self.size[1],
                 deviceScaleFactor=1, mobile=touch)
        if touch:
            self.cdp("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        return self.driver

    def screen(self):
        """Starts a display for this browser alone."""
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "2048x1280x24", "-nolisten", "tcp"]
        self.display = subprocess.Popen(command, pass_fds=[write], stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with open(read) as answer:
            os.environ["DISPLAY"] = ":" + answer.readline().strip()

    def webkit(self, _):
        self.screen()
        options = WebKitOptions()
        options.binary_location = str(next(Path("/usr/lib").glob("*/webkit2gtk-4.1/MiniBrowser")))
        options.add_argument("--automation")
        return webdriver.WebKitGTK(executable_path=shutil.which("WebKitWebDriver"), options=options)

    def firefox(self, _):
        # Without a display, it has no WebGL.
        self.screen()
        options = webdriver.FirefoxOptions()
        options.binary_location = shutil.which("firefox-esr") or shutil.which("firefox")
        for argument in ("-profile", self.profile):
            options.add_argument(argument)
        service = FirefoxService(shutil.which("geckodriver"), log_path=os.devnull)
        return webdriver.Firefox(service=service, options=options)

    def resize(self):
        """Makes the page, not the window, as large as it is asked to be."""
        self.driver.get("data:text/html,")

        def fits():
            # A window follows late, so it is asked again.
            sizes = self.run("return [[innerWidth, outerWidth], [innerHeight, outerHeight]]")
            if [inner for inner, _ in sizes] == list(self.size):
                return True
            self.driver.set_window_rect(0, 0, *(outer + wanted - inner for wanted, (inner, outer) in zip(self.size, sizes)))
            time.sleep(0.3)
            return False
        self.wait(fits, 20, "the window is not as large as it is asked to be")

    def cdp(self, command, **parameters):
        """Asks what Chromium alone can do."""
        return self.driver.execute_cdp_cmd(command, parameters)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, path, fragment="", before=""):
        """Opens a page from the disk, after a script. Returns the milliseconds until its first picture."""
        self.go(path, fragment, before)
        return self.started()

    def go(self, path, fragment="", before=""):
        """Opens a page from the disk, after a script, and does not wait for a picture."""
        self.driver.get("about:blank")
        self.driver.get(self.prepared(path, before).as_uri() + (fragment and "#" + fragment))

    def prepared(self, path, before=""):
        """The page with what the tests need before its own scripts."""
        self.pages.mkdir(exist_ok=True)
        page = self.pages / Path(path).name
        text = Path(path).read_text()
        page.write_text(text.replace("<head>", f"<head><script>{BEFORE}{before}</script>", 1))
        return page

    def started(self, seconds=20):
        mark = "return performance.getEntriesByName('first picture')[0]?.startTime"
        self.wait(lambda: self.run(mark), seconds, "no first picture")
        time.sleep(0.5)
        # A start that fails after its first picture is tried again.
        self.wait(lambda: self.run(mark), seconds, "no first picture")
        return self.run(mark)

    def wait(self, is_done, seconds, otherwise):
        end = time.time() + seconds
        while not is_done():
            if time.time() > end:
                raise AssertionError(f"{otherwise}; the page says: {self.message()}; log: {self.log()}")
            time.sleep(0.05)

    def told(self):
        """What a screen reader hears."""
        return self.run("return document.getElementById('told').textContent")

    def message(self):
        return self.run("return document.querySelector('#message:not([hidden])')?.innerText ?? ''")

    def log(self):
        lines = self.run("return window.console_lines ?? []")
        if self.engine == "chromium":
            lines += [line["message"] for line in self.driver.get_log("browser")]
        return lines

    def shot(self, path):
        Path(path).write_bytes(self.driver.get_screenshot_as_png())

    def act(self, kind, actions):
        source = {"type": kind, "id": kind, "actions": actions}
        if kind == "pointer":
            source["parameters"] = {"pointerType": "mouse"}
        self.driver.execute("actions", {"actions": [source]})

    def mouse(self, *acts):
        """Moves the mouse to a place, which is a pair, or presses or releases a button: `("pointerDown", 0)`."""
        def written(first, second):
            if isinstance(first, str):
                return {"type": first, "button": second}
            return {"type": "pointerMove", "x": round(first), "y": round(second), "duration": 0}
        self.act("pointer", [written(*act) for act in acts])

    def click(self, x, y):
        self.mouse((x, y), ("pointerDown", 0), ("pointerUp", 0))
        time.sleep(0.3)

    def drag(self, start, end, button="left", steps=40):
        """Drags, and returns the milliseconds that each frame kept the main thread."""
        self.run("window.frames_ms.length = 0")
        # At once, because a button that was pressed before is another one for Chromium's driver.
        path = [tuple(a + (b - a) * step / steps for a, b in zip(start, end)) for step in range(1, steps + 1)]
        self.mouse(start, ("pointerDown", BUTTONS[button]), *path, ("pointerUp", BUTTONS[button]))
        time.sleep(0.3)
        return self.run("return window.frames_ms")

    def measured_drag(self, start, end, button):
        """Drags. Returns the milliseconds of the main thread's own work a frame, which Chromium alone tells, and
        those that each frame took."""
        if self.engine != "chromium":
            return None, self.drag(start, end, button)
        self.cdp("Performance.enable", timeDomain="threadTicks")
        before = self.script_seconds()
        times = self.drag(start, end, button)
        return 1000 * (self.script_seconds() - before) / len(times), times

    def script_seconds(self):
        metrics = self.cdp("Performance.getMetrics")["metrics"]
        return next(metric["value"] for metric in metrics if metric["name"] == "ScriptDuration")

    def touch(self, kind, *points):
        self.cdp("Input.dispatchTouchEvent", type=kind,
                 touchPoints=[{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)])

    def tap(self, x, y):
        self.touch("touchStart", (x, y))
        self.touch("touchEnd")
        time.sleep(0.3)

    def key(self, name, control=False):
        """Presses a key: a letter, or one of `KEYS`."""
        pressed = [CONTROL] * control + [KEYS.get(name, name)]
        self.act("key", [{"type": "keyDown", "value": value} for value in pressed]
                 + [{"type": "keyUp", "value": value} for value in reversed(pressed)])
        time.sleep(0.3)

    def write(self, text):
        self.act("key", [{"type": kind, "value": letter} for letter in text for kind in ("keyDown", "keyUp")])
        time.sleep(0.5)

    def drop(self, *files):
        """Drops files into the page, each as its name and text."""
        self.run("""
            const data = new DataTransfer();
            for (const [name, text] of arguments[0]) data.items.add(new File([text], name));
            const event = new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true });
            document.getElementById("canvas").dispatchEvent(event);
        """, files)
        time.sleep(0.5)

    def downloads(self):
        time.sleep(0.3)
        return self.run("return window.downloads")

    def download(self, ending):
        """Name and text of a file that was saved: a busy machine takes its time."""
        for _ in range(30):
            for name, text in self.downloads().items():
                if name.endswith(ending):
                    return name, text
        raise AssertionError(f"no file {ending} was saved, but {list(self.downloads())}")

    def crash(self):
        """Ends the browser as a crash does."""
        if self.engine == "chromium":
            # The tab is gone, which is what is asked for.
            with contextlib.suppress(WebDriverException):
                self.cdp("Page.crash")
        else:
            os.kill(self.driver.capabilities["moz:processID"], signal.SIGKILL)
        self.quit()

    def quit(self):
        with contextlib.suppress(WebDriverException):
            self.driver.quit()
        if self.display:
            self.display.terminate()
            self.display.wait()

    def close(self):
        self.quit()
        if self.own:
            shutil.rmtree(self.profile, ignore_errors=True)
