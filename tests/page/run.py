"""Drives target/pinhole.html in a real browser as users do, from the disk, and prints what it measures.

    apt-get install python3-selenium brotli zbar-tools
    apt-get install chromium chromium-driver | webkit2gtk-driver xvfb | firefox-esr xvfb; cargo install geckodriver
    python3 tests/page/run.py [PAGE.html] [--engine chromium|webkit|firefox] [--starts N] [--pictures FOLDER]

Every check is a function whose name says what holds. `LEFT_OUT` says what an engine's driver cannot do.
"""
import argparse
import base64
import functools
import gzip
import http.server
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from browser import ENGINES, Browser, WebDriverException  # noqa: E402

SCENE = "pinhole = 1\n[camera]\neye = [0, 0, 3]\nat = [0, 0, -5]\nup = [0, 1, 0]\n"
# Where *at* and the ball are in a window of 1600 x 900.
AT = (895, 384)
# The first answer of the dialog about unsaved changes there.
RESTORE = (600, 479)


def number(told, name):
    """The numbers of a vector in what the page tells."""
    found = re.search(re.escape(name) + r" [=≈] \((.*)\)", told)
    assert found, f"no {name} in {told}"
    return [float(part.replace("−", "-")) for part in found.group(1).split(", ")]


def choose(browser, command):
    """Chooses a command in the palette."""
    browser.key("p", control=True)
    browser.write(command)
    browser.key("Enter")
    time.sleep(0.5)


def saved_scene(browser):
    """The scene file that is downloaded: at once or, from a lesson, after a question for its name."""
    browser.key("s", control=True)
    time.sleep(0.5)
    if not any(name.endswith(".toml") for name in browser.downloads()):
        browser.key("Enter")
    return browser.download(".toml")[1]


def sizes(page):
    text = Path(page).read_text()
    packed = re.search(r'id="program">([^<]*)<', text).group(1)
    program = gzip.decompress(base64.b64decode(packed))
    brotli = ["brotli", "--best", "--lgwin=24", "--stdout", "-"]
    small = subprocess.run(brotli, input=program, capture_output=True).stdout if shutil.which("brotli") else b""
    print(f"bytes: file {len(text.encode())}; of it the program: raw {len(program)}, in the file {len(packed)}, "
          f"brotli {len(small)}")
    assert len(text.encode()) <= 5_000_000, "more than 5.0 MB"


def the_first_picture_comes_at_once(page):
    times = []
    for _ in range(3):
        browser = Browser((1600, 900))
        times.append(browser.open(page))
        browser.close()
    print(f"first picture after {statistics.median(times):.0f} ms, of {[round(time) for time in times]}")


def a_drag_is_rehearsed_and_changes_nothing(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    # Settings are stored by the program itself, at any time.
    state = """return [document.getElementById('told').textContent, document.title,
        Object.keys(localStorage).filter((key) => !key.endsWith('state.json'))]"""
    before = browser.run(state)
    rehearsed = "return performance.getEntriesByName('rehearsed')[0]?.detail"
    browser.wait(lambda: browser.run(rehearsed), 20, "no rehearsal")
    told = browser.run(rehearsed)
    assert number(told, "u (right)") != number(before[0], "u (right)"), f"at was not moved by the rehearsal: {told}"
    browser.mouse((700, 500))
    time.sleep(0.5)
    assert browser.run(state) == before, (browser.run(state), before)
    browser.shot(pictures / "rehearsed.png")
    browser.close()


def a_drag_moves_what_is_dragged(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    before = number(browser.told(), "u (right)")
    browser.drag(AT, (960, 330))
    assert number(browser.told(), "u (right)") != before, "at was not moved"
    # Unsaved changes are written a second after the last.
    time.sleep(3)
    count = len(browser.run("return window.frames_ms"))
    time.sleep(2)
    assert len(browser.run("return window.frames_ms")) == count, "frames although nothing changes"
    browser.shot(pictures / "drag.png")
    print_frame("canonical", browser)
    browser.close()
    browser = Browser((1600, 900))
    browser.open(page)
    browser.drop(["crowd.toml", crowd()])
    print_frame("1,000 spheres", browser)
    browser.shot(pictures / "crowd.png")
    browser.close()


def crowd():
    """A scene of 1,000 spheres in sight."""
    spheres = (f"[[sphere]]\ncenter = [{k % 10 - 4.5}, {k // 10 % 10 - 4.5}, {-6 - k // 100}]\nradius = 0.3\n"
               for k in range(1000))
    return SCENE + "".join(spheres)


def print_frame(scene, browser):
    """Prints how long looking round keeps the main thread: its own work, and with what it waits for. Without a
    graphics adapter, it waits for a drawing process on the same cores."""
    work, times = browser.measured_drag((1200, 405), (1350, 411), "right")
    own = "" if work is None else f"{work:.1f} ms of work, "
    print(f"main thread a frame while looking round, {scene}: {own}with waiting median "
          f"{statistics.median(times):.1f} ms, longest {max(times):.0f} ms")


def beside(program):
    """Prints how long the desktop's program takes for a frame while the same is dragged, on one thread."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "crowd.toml"
        scene.write_text(crowd())
        subprocess.run(["tests/drag-latency.sh", "1600x900", "canonical", scene], check=True,
                       env={**os.environ, "RAYON_NUM_THREADS": "1", "PINHOLE_BINARY": program})


def a_lesson_goes_on_by_keys(page, pictures):
    browser = Browser((1280, 800))
    browser.open(page, "7.1")
    seen = [browser.told()]
    for _ in range(12):
        browser.key("PageDown")
        if browser.told() != seen[-1]:
            seen.append(browser.told())
    assert len(seen) >= 6 and any("Lesson 7, step 3" in told for told in seen), seen
    browser.shot(pictures / "lesson.png")
    browser.close()


def a_pixel_is_pinned(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    before = browser.told()
    browser.click(1360, 300)
    assert "row" in browser.told() and browser.told() != before, browser.told()
    browser.shot(pictures / "pinned.png")
    browser.close()


def a_file_is_dropped_changed_and_saved(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    browser.drop(["mine.toml", SCENE + "[[sphere]]\nname = \"</script>\"\ncenter = [0, 0, -5]\nradius = 1\n"])
    assert browser.told().startswith("mine.toml"), browser.told()
    browser.key("s", control=True)
    saved = browser.downloads()["mine.toml"]
    assert "</script>" in saved and "-5" in saved, saved
    browser.drop(["table.toml", 'spheres = "balls.csv"\n' + SCENE], ["balls.csv", "x,y,z,r\n0,0,-5,1\n"])
    assert "hits sphere 0" in browser.told() or browser.told().startswith("table.toml"), browser.told()
    browser.key("s", control=True)
    assert 'spheres = "balls.csv"' in browser.downloads()["table.toml"], browser.downloads()
    browser.drop(["mine.toml", SCENE])
    browser.drop(["broken.toml", "pinhole = 1\n[camera]\neye = 3\n"])
    assert browser.told().startswith("mine.toml"), "a broken file replaced the scene"
    browser.shot(pictures / "broken.png")
    browser.close()


def a_link_is_shared_and_opened(page, pictures):
    browser = Browser((1920, 1080))
    browser.open(page, "7.3")
    there = browser.told()
    command = ["cargo", "run", "--quiet", "--", "share", "--lesson", "7", "--step", "3", "--base", "https://a.b/p.html"]
    link = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    assert link == "https://a.b/p.html#7.3", link
    browser.drag((800, 500), (860, 450))
    browser.key("q")
    time.sleep(0.5)
    browser.shot(pictures / "share.png")
    browser.key("Escape")
    for wrong in ("7.99", "v9/scene", "v1/canonical/00000000", "x" * 100_000):
        browser.open(page, wrong)
        browser.shot(pictures / f"link-{wrong[:4].replace('/', '-')}.png")
    browser.open(page, "7.3")
    assert browser.told() == there
    browser.wait(lambda: browser.run("return location.hash") == "", 20, "a reload would go back to the link")
    browser.run("location.hash = '8.1'")
    time.sleep(0.5)
    assert browser.told().startswith("Lesson 8, step 1"), browser.told()
    browser.driver.refresh()
    browser.started()
    assert browser.told().startswith("Lesson 8, step 1"), browser.told()
    browser.close()


def another_program_reads_the_code_of_a_link(page, pictures):
    """From a server, because a file has no address that others could open; on a phone, whose dialog is narrow."""
    folder = functools.partial(QuietHandler, directory=Path(page).resolve().parent)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), folder) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/{Path(page).name}"
        browser = Browser((390, 844), touch=True)
        browser.driver.get(address + "#7.3")
        browser.started()
        browser.key("q")
        time.sleep(0.5)
        picture = pictures / "code.png"
        browser.shot(picture)
        read = subprocess.run(["zbarimg", "--quiet", "--raw", picture], capture_output=True, text=True).stdout.strip()
        assert read == address + "#7.3", f"read {read!r}"
        browser.close()
        server.shutdown()


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    """Serves a folder, and logs nothing."""

    def log_message(self, *_):
        pass


def a_page_is_saved_and_opens_at_its_step(page, pictures):
    browser = Browser((1280, 800))
    browser.open(page, "7.3")
    there = browser.told()
    assert there
    choose(browser, "Save as a page")
    browser.key("a", control=True)
    browser.write("week 3/4")
    browser.shot(pictures / "name.png")
    browser.key("Enter")
    name, text = browser.download(".html")
    assert name == "week 3-4.html", f"not the name that is asked for, and its slash is not replaced: {name}"
    with tempfile.TemporaryDirectory() as folder:
        saved = Path(folder) / "lesson.html"
        saved.write_text(text)
        browser.open(saved)
        assert browser.told() == there, f"{browser.told()}\n\n{there}"
        broken = Path(folder) / "broken.html"
        broken.write_text(text.replace('"lesson":"7.3"', '"lesson":"7.99"'))
        browser.close()
        browser = Browser((1280, 800))
        browser.open(broken)
        browser.shot(pictures / "broken-part.png")
        assert browser.told().startswith("canonical"), browser.told()
    browser.close()


def a_scene_in_a_page_runs_no_script(page, pictures):
    script = "</script><script>document.title = 'run'</script>"
    scene = f"# {script}\n{SCENE}[[sphere]]\nname = \"{script}\"\ncenter = [0, 0, -5]\nradius = 1\n"
    browser = Browser((1280, 800))
    browser.open(page)
    browser.drop(["script.toml", scene])
    choose(browser, "Save as a page")
    browser.key("Enter")
    _, text = browser.download(".html")
    with tempfile.TemporaryDirectory() as folder:
        saved = Path(folder) / "script.html"
        saved.write_text(text)
        browser.open(saved)
        assert browser.run("return document.title") != "run", "a name or a note was run"
        assert saved_scene(browser).count(script) == 2
    browser.close()


def unsaved_changes_outlive_the_page(page, pictures):
    profile = tempfile.mkdtemp()
    browser = Browser((1600, 900), profile=profile)
    browser.open(page)
    browser.drag(AT, (960, 330))
    changed = number(browser.told(), "u (right)")
    time.sleep(2)
    browser.driver.refresh()
    browser.started()
    browser.shot(pictures / "offered.png")
    browser.click(*RESTORE)
    assert number(browser.told(), "u (right)") == changed, "not restored after a reload"
    browser.drag((960, 330), (900, 380))
    changed = number(browser.told(), "u (right)")
    time.sleep(2)
    if Browser.engine == "webkit":
        # Its driver begins every session without anything stored.
        browser.close()
        return
    browser.crash()
    browser = Browser((1600, 900), profile=profile)
    browser.open(page)
    browser.click(*RESTORE)
    assert number(browser.told(), "u (right)") == changed, "not restored after a crash"
    browser.close()
    shutil.rmtree(profile, ignore_errors=True)


def a_full_storage_is_told_once(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    browser.run("for (let n = 0; n < 64; n++) try { localStorage['full' + n] = 'x'.repeat(100000) } catch { break }"
                "for (let n = 0; n < 9999; n++) try { localStorage['f' + n] = 'x'.repeat(100) } catch { break }")
    browser.drag(AT, (960, 330))
    time.sleep(2)
    browser.shot(pictures / "full.png")
    browser.key("s", control=True)
    browser.key("Enter")
    assert browser.downloads(), "saving needs no storage"
    browser.close()


def every_pixel_is_the_desktops(page, pictures):
    scenes = tempfile.NamedTemporaryFile(suffix=".json")
    command = ["cargo", "test", "--quiet", "--package", "pinhole", "--test", "pinhole", "--", "doors::pictures"]
    subprocess.run(command, check=True, env={**os.environ, "PINHOLE_PAGE_SCENES": scenes.name})
    wanted = json.loads(Path(scenes.name).read_text())
    browser = Browser((390, 844))
    browser.open(page)
    found = browser.run("return arguments[0].map((text) => wasm_bindgen.picture_digest(text))",
                        [text for text, _ in wanted])
    differing = sum(digest != own for digest, (_, own) in zip(found, wanted))
    print(f"scenes whose pictures differ from the desktop's in any bit: {differing} of {len(wanted)}")
    assert not differing and len(found) == len(wanted)
    digest = "return wasm_bindgen.picture_digest(arguments[0])"
    with tempfile.TemporaryDirectory() as folder:
        lesson = Path(folder) / "lesson.html"
        command = ["cargo", "run", "--quiet", "--", "page", "--lesson", "7.3", "--page", page, "-o", lesson]
        subprocess.run(command, check=True)
        for opened, fragment in ((page, "7.3"), (lesson, "")):
            browser.open(opened, fragment)
            assert browser.run(digest, saved_scene(browser)) == wanted[0][1], f"7.3 differs in {opened}"
    browser.close()


def it_stands_on_a_phone(page, pictures):
    browser = Browser((390, 844), touch=True)
    browser.open(page)
    browser.shot(pictures / "phone.png")
    browser.tap(80, 470)
    assert "row" in browser.told(), f"a tap pins no pixel: {browser.told()}"
    browser.open(page, "7.3")
    browser.shot(pictures / "phone-lesson.png")
    before = browser.told()
    browser.touch("touchStart", (150, 300), (250, 300))
    for step in range(20):
        browser.touch("touchMove", (150 - 3 * step, 300), (250 + 3 * step, 300))
    browser.touch("touchEnd")
    browser.shot(pictures / "phone-pinched.png")
    assert browser.told() == before, "two fingers move the observer alone"
    browser.touch("touchStart", (300, 560))
    for step in range(1, 11):
        browser.touch("touchMove", (300 - 20 * step, 560))
        time.sleep(0.02)
    browser.touch("touchEnd")
    time.sleep(0.5)
    assert "the parallelogram's area" in browser.told(), f"a swipe does not answer: {browser.told()}"
    browser.close()


# On a phone: the menu of all menus, its entry View and there the entry Present; while presenting, what leads on
# and ends it.
MENU, VIEW, PRESENT = (25, 18), (40, 146), (180, 146)
NEXT, END = (324, 820), (366, 820)


def a_finger_presents_and_goes_on(page, pictures):
    browser = Browser((390, 844), touch=True)
    browser.open(page, "7.3")
    there = browser.told()
    fills = "return Boolean(document.fullscreenElement)"
    for name, place in (("menu", MENU), ("view", VIEW), ("presenting", PRESENT)):
        browser.tap(*place)
        time.sleep(0.7)
        browser.shot(pictures / f"finger-{name}.png")
    assert browser.run(fills), "Menu, View, Present does not present"
    # The step's two lines come first.
    for _ in range(3):
        browser.tap(*NEXT)
        time.sleep(0.7)
    browser.shot(pictures / "finger-next.png")
    assert browser.told() != there, "no next step while presenting"
    browser.tap(*END)
    time.sleep(0.7)
    assert not browser.run(fills), "presenting does not end"
    browser.shot(pictures / "finger-ended.png")
    assert not [line for line in browser.log() if "panicked" in line], browser.log()
    browser.close()


def it_stands_at_three_sizes(page, pictures):
    for size in ((390, 844), (1280, 800), (1920, 1080)):
        browser = Browser(size)
        browser.open(page)
        browser.shot(pictures / f"{size[0]}x{size[1]}.png")
        assert not browser.log(), browser.log()
        browser.close()


# Faults of a start and of a running program, made by a script before the page's own: an error thrown into the
# program, as a trap is, at the first or at every start, or when it is asked for; and a first frame that comes late.
THROWN = """addEventListener("DOMContentLoaded", () => {
  const rest = pinhole.rest;
  pinhole.rest = (seconds) => { if (%s) throw new WebAssembly.RuntimeError("made by a test"); rest(seconds); };
});"""
ONCE = THROWN % "!history.state"
ALWAYS = THROWN % "true"
ASKED = THROWN % "window.asked"
LATE = """const observe = ResizeObserver.prototype.observe;
ResizeObserver.prototype.observe = function (...what) { setTimeout(() => observe.apply(this, what), %d); };"""


def a_start_that_fails_is_tried_again(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page, "7.3", before=ONCE)
    kind = "return performance.getEntriesByType('navigation')[0].type"
    assert browser.run(kind) == "reload" and browser.told().startswith("Lesson 7, step 3"), browser.told()
    left = "return [location.hash, history.state]"
    browser.wait(lambda: browser.run(left) == ["", None], 20, "a mark or the link is left")
    browser.go(page, "7.3", before=ALWAYS)
    browser.wait(lambda: "made by a test" in browser.message(), 20, "no message")
    assert "internal error" in browser.message() and "Save the report" in browser.message(), browser.message()
    browser.run("document.querySelectorAll('#message button')[2].click()")
    report = browser.download(".txt")[1]
    assert report.count("A start before this one failed, too") == 3 and "Mozilla" in report, report
    browser.shot(pictures / "start-failed.png")
    browser.close()


def an_error_that_is_no_panic_is_shown_and_loses_nothing(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page, before=ASKED)
    # What fails in somebody else's script does not end the program, nor does what it waits for.
    browser.run("setTimeout(() => { throw new Error('a platform') }); Promise.reject(new Error('an extension'))")
    browser.drag(AT, (960, 330))
    changed = number(browser.told(), "u (right)")
    assert not browser.message(), browser.message()
    # Before the change is stored, which takes a second.
    browser.run("window.asked = true")
    browser.mouse((700, 500), (705, 505))
    browser.wait(lambda: "made by a test" in browser.message(), 5, "no message")
    assert "Unsaved changes are kept" in browser.message(), browser.message()
    browser.shot(pictures / "failed.png")
    browser.run("document.querySelector('#message button').click()")
    time.sleep(0.5)
    browser.started()
    browser.click(*RESTORE)
    assert number(browser.told(), "u (right)") == changed, "the last change is lost"
    browser.close()


def a_lost_picture_is_told(page, pictures):
    browser = Browser((1600, 900))
    browser.open(page)
    # Before it is used, the page would start again.
    browser.key("Escape")
    browser.run("document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()")
    browser.wait(lambda: "taken the picture away" in browser.message(), 5, "no message")
    browser.run("document.querySelector('#message button').click()")
    time.sleep(0.5)
    browser.started()
    browser.close()


def a_start_without_a_picture_says_so(page, pictures):
    browser = Browser((1280, 800))
    browser.go(page, before=LATE % 1e9)
    browser.wait(lambda: "no picture yet" in browser.message(), 30, "no message")
    assert "Try again" in browser.message() and "compiled" in browser.message(), browser.message()
    browser.shot(pictures / "no-picture.png")
    # A slow browser has it after all.
    browser.go(page, before=LATE % 20000)
    browser.wait(lambda: "no picture yet" in browser.message(), 30, "no message")
    browser.wait(lambda: not browser.message(), 20, "the message stays before the picture")
    browser.close()


def starts(page, count):
    """Starts the page again and again. Counts the starts that failed, at first and in the end."""
    retried, failed, times = 0, 0, []
    for number in range(count):
        if number % 25 == 0:
            browser = Browser()
        try:
            times.append(browser.open(page, before="window.first_failures = history.state?.failed;"))
            if browser.run("return performance.getEntriesByType('navigation')[0].type") == "reload":
                retried += 1
                print(f"start {number} failed, and was tried again: {browser.run('return window.first_failures')}")
        except AssertionError as error:
            failed += 1
            print(f"start {number} failed: {error}", flush=True)
        if number % 25 == 24 or number == count - 1:
            browser.close()
            print(f"starts: {number + 1}, failed at first: {retried}, failed: {failed}, first picture after "
                  f"{statistics.median(times or [0]):.0f} ms", flush=True)
    return retried + failed


# What the driver of an engine cannot do.
LEFT_OUT = {
    "chromium": {},
    **{engine: {
        it_stands_on_a_phone: "it emulates no phone",
        a_finger_presents_and_goes_on: "it emulates no phone",
    } for engine in ("webkit", "firefox")},
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", nargs="?", default="target/pinhole.html")
    parser.add_argument("--engine", choices=ENGINES, default="chromium")
    parser.add_argument("--starts", type=int, metavar="N", help="only start it N times, and count those that fail")
    parser.add_argument("--only", metavar="WORD", default="", help="only the checks with this word in their names")
    parser.add_argument("--pictures", default="target/page-pictures", type=Path)
    parser.add_argument("--beside", metavar="PROGRAM", help="measure the desktop's program, too")
    arguments = parser.parse_args()
    Browser.engine = arguments.engine
    pictures = arguments.pictures / arguments.engine
    pictures.mkdir(parents=True, exist_ok=True)
    browser = Browser()
    print(browser.driver.capabilities["browserName"], browser.driver.capabilities["browserVersion"])
    browser.close()
    if arguments.starts:
        sys.exit(min(starts(arguments.page, arguments.starts), 1))
    if not arguments.only:
        sizes(arguments.page)
        the_first_picture_comes_at_once(arguments.page)
    checks = [
        a_drag_is_rehearsed_and_changes_nothing, a_drag_moves_what_is_dragged, a_lesson_goes_on_by_keys,
        a_pixel_is_pinned, a_file_is_dropped_changed_and_saved, a_link_is_shared_and_opened,
        another_program_reads_the_code_of_a_link, a_page_is_saved_and_opens_at_its_step,
        a_scene_in_a_page_runs_no_script, every_pixel_is_the_desktops, unsaved_changes_outlive_the_page,
        a_full_storage_is_told_once, it_stands_on_a_phone, a_finger_presents_and_goes_on, it_stands_at_three_sizes,
        a_start_that_fails_is_tried_again, an_error_that_is_no_panic_is_shown_and_loses_nothing,
        a_lost_picture_is_told, a_start_without_a_picture_says_so,
    ]
    if arguments.beside:
        beside(arguments.beside)
    failed = 0
    for check in (check for check in checks if arguments.only in check.__name__):
        name = check.__name__.replace("_", " ")
        if check in LEFT_OUT[Browser.engine]:
            print("left out:", name, "-", LEFT_OUT[Browser.engine][check])
            continue
        try:
            check(arguments.page, pictures)
            print("holds:", name, flush=True)
        except (AssertionError, WebDriverException) as error:
            failed += 1
            print("FAILS:", name, "-", error, flush=True)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
