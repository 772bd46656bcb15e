"""A real Chromium, without a display, that opens a page from the disk and is driven by mouse, touch and keys."""
import base64
import json
import shutil
import tempfile
import time
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

# Runs before the page: notes how long each animation frame keeps the main thread, and what is downloaded.
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
"""

KEYS = {"PageDown": 34, "PageUp": 33, "End": 35, "Home": 36, "Escape": 27, "Enter": 13, "F5": 116, "F1": 112}


class Browser:
    """One tab, with the profile of a user who comes back if `profile` is given again."""

    def __init__(self, size=(1280, 800), touch=False, profile=None):
        self.size, self.own = size, profile is None
        self.profile = profile or tempfile.mkdtemp(prefix="pinhole-page-")
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                         "--enable-unsafe-swiftshader", f"--user-data-dir={self.profile}",
                         f"--window-size={size[0]},{size[1]}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.cdp("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1],
                 deviceScaleFactor=1, mobile=touch)
        if touch:
            self.cdp("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        self.cdp("Page.addScriptToEvaluateOnNewDocument", source=BEFORE)

    def cdp(self, command, **parameters):
        return self.driver.execute_cdp_cmd(command, parameters)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, path, fragment=""):
        """Opens a page from the disk. Returns the milliseconds until its first picture."""
        self.driver.get("about:blank")
        self.driver.get(Path(path).resolve().as_uri() + (fragment and "#" + fragment))
        return self.started()

    def started(self, seconds=20):
        mark = "return performance.getEntriesByName('first picture')[0]?.startTime"
        self.wait(lambda: self.run(mark), seconds, "no first picture")
        time.sleep(0.5)
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
        return self.run("return document.getElementById('message')?.innerText")

    def log(self):
        return [line["message"] for line in self.driver.get_log("browser")]

    def shot(self, path):
        Path(path).write_bytes(base64.b64decode(self.cdp("Page.captureScreenshot")["data"]))

    def mouse(self, kind, x, y, button="none", clicks=0):
        self.cdp("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, clickCount=clicks,
                 buttons={"none": 0, "left": 1, "right": 2}[button])

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, "left", 1)
        self.mouse("mouseReleased", x, y, "left", 1)
        time.sleep(0.3)

    def drag(self, start, end, button="left", steps=40):
        """Drags, and returns the milliseconds that each frame kept the main thread."""
        self.mouse("mouseMoved", *start)
        self.mouse("mousePressed", *start, button, 1)
        self.run("window.frames_ms.length = 0")
        for step in range(1, steps + 1):
            x, y = (a + (b - a) * step / steps for a, b in zip(start, end))
            self.mouse("mouseMoved", x, y, button)
        times = self.run("return window.frames_ms")
        self.mouse("mouseReleased", *end, button, 1)
        time.sleep(0.3)
        return times

    def measured_drag(self, start, end, button):
        """Drags. Returns the milliseconds of the main thread's own work a frame, and those that each frame took."""
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

    def key(self, name, modifiers=0):
        code = KEYS.get(name) or ord(name.upper())
        text = {} if name in KEYS or modifiers else {"text": name}
        for kind in ("keyDown", "keyUp"):
            self.cdp("Input.dispatchKeyEvent", type=kind, key=name, code=name if name in KEYS else f"Key{name.upper()}",
                     windowsVirtualKeyCode=code, modifiers=modifiers, **(text if kind == "keyDown" else {}))
        time.sleep(0.3)

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

    def close(self):
        self.driver.quit()
        if self.own:
            shutil.rmtree(self.profile, ignore_errors=True)
