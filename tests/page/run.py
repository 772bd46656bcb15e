"""Drives target/pinhole.html in a real Chromium as users do, from the disk, and prints what it measures.

    apt-get install chromium chromium-driver python3-selenium brotli zbar-tools
    python3 tests/page/run.py [PAGE.html] [--pictures FOLDER]

Every check is a function whose name says what holds.
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
from browser import Browser  # noqa: E402

CTRL = 2
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
    browser.key("p", CTRL)
    for letter in command:
        browser.cdp("Input.insertText", text=letter)
    time.sleep(0.3)
    browser.key("Enter")
    time.sleep(0.5)


def saved_scene(browser):
    """The scene file that is downloaded: at once or, from a lesson, after a question for its name."""
    browser.key("s", CTRL)
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
    print(f"main thread a frame while looking round, {scene}: {work:.1f} ms of work, "
          f"with waiting median {statistics.median(times):.1f} ms")


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
    browser.key("s", CTRL)
    saved = browser.downloads()["mine.toml"]
    assert "</script>" in saved and "-5" in saved, saved
    browser.drop(["table.toml", 'spheres = "balls.csv"\n' + SCENE], ["balls.csv", "x,y,z,r\n0,0,-5,1\n"])
    assert "hits sphere 0" in browser.told() or browser.told().startswith("table.toml"), browser.told()
    browser.key("s", CTRL)
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
    assert browser.run("return location.hash") == "", "a reload would go back to the link"
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
    browser.key("a", CTRL)
    browser.cdp("Input.insertText", text="week 3/4")
    time.sleep(0.5)
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
    try:
        browser.cdp("Page.crash")
    except Exception:  # The tab is gone, which is what is asked for.
        pass
    browser.driver.quit()
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
    browser.key("s", CTRL)
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
    assert browser.told().startswith("Lesson 7, step 4"), f"a swipe does not go on: {browser.told()}"
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", nargs="?", default="target/pinhole.html")
    parser.add_argument("--pictures", default="target/page-pictures", type=Path)
    parser.add_argument("--beside", metavar="PROGRAM", help="measure the desktop's program, too")
    arguments = parser.parse_args()
    arguments.pictures.mkdir(parents=True, exist_ok=True)
    print(subprocess.run(["chromium", "--version"], capture_output=True, text=True).stdout.strip())
    sizes(arguments.page)
    the_first_picture_comes_at_once(arguments.page)
    checks = [
        a_drag_moves_what_is_dragged, a_lesson_goes_on_by_keys, a_pixel_is_pinned,
        a_file_is_dropped_changed_and_saved, a_link_is_shared_and_opened,
        another_program_reads_the_code_of_a_link, a_page_is_saved_and_opens_at_its_step,
        a_scene_in_a_page_runs_no_script, every_pixel_is_the_desktops, unsaved_changes_outlive_the_page,
        a_full_storage_is_told_once, it_stands_on_a_phone, a_finger_presents_and_goes_on, it_stands_at_three_sizes,
    ]
    if arguments.beside:
        beside(arguments.beside)
    failed = 0
    for check in checks:
        try:
            check(arguments.page, arguments.pictures)
            print("holds:", check.__name__.replace("_", " "))
        except AssertionError as error:
            failed += 1
            print("FAILS:", check.__name__.replace("_", " "), "-", error)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
