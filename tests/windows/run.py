"""Drives target/pinhole.exe under Wine as users of Windows do, and prints a line for each check.

    apt-get install xvfb openbox xdotool x11-utils imagemagick xclip python3-gi gir1.2-gtk-3.0
    .ci/windows && cargo build && /usr/bin/python3 tests/windows/run.py [--pictures FOLDER] [--program PINHOLE.exe] [CHECK...]

Wine is that of Debian's unstable suite, by .ci/debian: Rust's standard library needs Wine 9 or newer. What the program
writes is held against that of PINHOLE_BINARY, a program for Linux, by default target/debug/pinhole. Every check is a
function whose name says what holds; CHECK is a part of some. Wine shows no real DirectX, no sizes of text other than
100 %, no dark title bars, no Explorer.
"""
import argparse
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2]
ROOT = Path(os.environ.get("PINHOLE_DEBIAN_ROOT", SOURCES / "target/debian-unstable"))
LINUX = os.environ.get("PINHOLE_BINARY", str(SOURCES / "target/debug/pinhole"))
# The display, and the window at its left.
DISPLAY, SIZE = "1500x860x24", ("1270", "760")
SCENE = """# A ball. Its comment stays.
pinhole = 1

[camera]
eye = [0.0, 0.0, 0.0] # the origin
at = [0.0, 0.0, -1.0]
up = [0.0, 1.0, 0.0]

[[sphere]]
center = [0.0, 0.0, -5.0]
radius = 1.0
"""
# Where *at* is in a window of that size with that scene, and where it is dragged.
AT, TO = (586, 409), (660, 360)
# The first answer of the dialog about unsaved changes, on the display.
RESTORE = ("436", "439")


class Windows:
    """Wine's Windows in a folder of its own, with a display of its own."""

    def __init__(self, program):
        self.program = program
        # Keeps what .ci/debian has mounted until its input ends.
        self.debian = subprocess.Popen([SOURCES / ".ci/debian", "wine wine64", "sh", "-c", "echo ready && cat"],
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        if self.debian.stdout.readline().strip() != "ready":
            print("no Wine: NOTHING IS TESTED")
            sys.exit(self.debian.wait())
        self.folder = Path(tempfile.mkdtemp(prefix="wine-", dir=ROOT / "tmp"))
        self.server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", DISPLAY, "-nolisten", "tcp"],
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.outside = {**os.environ, "DISPLAY": ":" + self.server.stdout.readline().strip()}
        self.manager = subprocess.Popen(["openbox"], env=self.outside, stderr=subprocess.DEVNULL)
        drive = self.folder / "drive_c"
        # The folder in which everything happens.
        self.home, self.roaming = drive / "Stunde", drive / "users/root/AppData/Roaming"
        subprocess.run(self.command("wineboot", "--init", folder="/"), check=True, timeout=300, capture_output=True)
        self.home.mkdir()
        shutil.copy(program, self.home / "pinhole.exe")

    def command(self, *command, folder=None):
        inside = [f"/{path.relative_to(ROOT)}" for path in (self.folder, self.home if folder is None else self.folder)]
        return ["chroot", ROOT, "env", "-i", "-C", inside[1], "PATH=/usr/bin:/bin", "HOME=/root", "LANG=C.UTF-8",
                f"WINEPREFIX={inside[0]}", f"DISPLAY={self.outside['DISPLAY']}", "WINEDEBUG=-all",
                "WINEDLLOVERRIDES=mscoree,mshtml,winemenubuilder.exe=", *command]

    def run(self, *command):
        return subprocess.run(self.command("wine", *command), capture_output=True, timeout=300)

    def pinhole(self, *arguments, status=0):
        """Runs a command in C:\\Stunde. Returns what it prints."""
        ran = self.run("pinhole.exe", *arguments)
        printed = (ran.stdout + ran.stderr).decode()
        assert ran.returncode == status, (arguments, ran.returncode, printed)
        return printed

    def write(self, name, text):
        path = self.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
        return path

    def holder(self, name):
        """Another program that has a file open, as Windows' own programs do: nobody else may replace it."""
        held = subprocess.Popen(self.command("wine", "cmd", "/c", f"ping -n 120 127.0.0.1 < {name} > nul"))
        time.sleep(2)
        return held

    def end(self):
        subprocess.run(self.command("wine", "wineboot", "-k"), stderr=subprocess.DEVNULL)
        time.sleep(1)
        for process in (self.manager, self.server):
            process.terminate()
            process.wait()
        self.debian.stdin.close()
        self.debian.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Window:
    """The program's window."""

    def __init__(self, windows, *arguments):
        self.windows = windows
        self.program = subprocess.Popen(windows.command("wine", "pinhole.exe", *arguments), stderr=subprocess.DEVNULL)
        self.id = self.wait(lambda: self.x("search", "--onlyvisible", "--name", "Pinhole$").split("\n")[0], "no window")
        self.x("windowsize", "--sync", self.id, *SIZE)
        self.x("windowmove", self.id, "0", "20")
        self.x("windowactivate", "--sync", self.id)
        self.settle()

    def x(self, *command):
        ran = subprocess.run(["xdotool", *command], env=self.windows.outside, capture_output=True, text=True)
        return ran.stdout.strip()

    def wait(self, holds, reason, seconds=60):
        end = time.monotonic() + seconds
        while not (value := holds()):
            assert time.monotonic() < end, f"{reason} in {seconds} s"
            time.sleep(0.2)
        return value

    def title(self):
        return self.x("getwindowname", self.id)

    def titled(self, begin):
        self.wait(lambda: self.title().startswith(begin), f"no {begin} in the title {self.title()}", 20)

    def picture(self, path=None):
        """A picture of the display; also written if a path is given."""
        shot = subprocess.run(["import", "-window", "root", "ppm:-"], env=self.windows.outside, capture_output=True)
        if path:
            subprocess.run(["convert", "ppm:-", path], input=shot.stdout, check=True)
        return shot.stdout

    def settle(self):
        """Waits until the picture stays the same."""
        before = b""
        for _ in range(40):
            time.sleep(0.4)
            now = self.picture()
            if now == before:
                break
            before = now

    def key(self, *keys):
        self.x("key", "--delay", "60", *keys)
        self.settle()

    def paste(self, text):
        """Pastes a text, as what is typed by xdotool reaches Wine in ASCII alone."""
        with subprocess.Popen(["xclip", "-quiet", "-selection", "clipboard"], stdin=subprocess.PIPE, env=self.windows.outside,
                              stderr=subprocess.DEVNULL) as clipboard:
            clipboard.stdin.write(text.encode())
            clipboard.stdin.close()
            time.sleep(1)
            self.key("ctrl+v")
            clipboard.terminate()

    def drag(self, begin=AT, end=TO, within=True):
        frame = ["--window", self.id] if within else []
        self.x("mousemove", *frame, *map(str, begin))
        time.sleep(0.3)
        self.x("mousedown", "1")
        for step in range(1, 21):
            self.x("mousemove", *frame, *(str(round(a + (b - a) * step / 20)) for a, b in zip(begin, end)))
            time.sleep(0.05)
        time.sleep(0.5)
        self.x("mouseup", "1")
        self.settle()

    def kill(self):
        """Ends the program as the task manager does."""
        self.windows.run("taskkill", "/f", "/im", "pinhole.exe")
        self.program.wait(60)

    def close(self):
        self.key("alt+F4")
        self.program.wait(60)


def vector(path, name):
    found = re.search(rf"^{name} = \[(.*?)\]", path.read_text(), re.M)
    return [float(part) for part in found.group(1).split(",")]


def linux(*arguments, folder=None):
    ran = subprocess.run([LINUX, *arguments], capture_output=True, cwd=folder)
    return (ran.stdout + ran.stderr).decode()


def the_file_is_what_windows_wants_of_it(windows, _pictures):
    program = windows.program.read_bytes()
    header = struct.unpack_from("<I", program, 0x3c)[0]
    subsystem = struct.unpack_from("<H", program, header + 24 + 68)[0]
    assert subsystem == 2, f"a double click would open a terminal: subsystem {subsystem}"
    version = re.search(r'^version = "(.*)"', (SOURCES / "Cargo.toml").read_text(), re.M).group(1)
    at = program.index("FileVersion".encode("utf-16-le"))
    assert version.encode("utf-16-le") in program[at:at + 60], "no version"
    assert "ProductName\0Pinhole\0".encode("utf-16-le") in program.replace(b"\0\0\0\0", b"\0\0"), "no name"
    icon = (SOURCES / "assets/windows/pinhole.ico").read_bytes()
    assert icon[-10_000:] in program, "no icon"
    for path in (SOURCES, Path.home() / ".cargo"):
        assert str(path).encode() not in program, f"it names {path}"


def output_goes_to_terminals_pipes_and_files(windows, _pictures):
    version = windows.pinhole("--version")
    assert version.startswith("pinhole ") and "windows" in version, version
    windows.run("cmd", "/c", "pinhole.exe --version > version.txt")
    assert (windows.home / "version.txt").read_text() == version
    command = subprocess.list2cmdline(map(str, windows.command("wine", "cmd", "/c", "start /wait pinhole.exe --version")))
    terminal = subprocess.run(["script", "-qec", command, "/dev/null"], capture_output=True, timeout=60).stdout
    assert version.strip() in terminal.decode(), terminal
    assert "unexpected argument" in windows.pinhole("--nonsense", status=2)


def render_writes_the_bytes_that_linux_writes(windows, _pictures):
    for scene in ("look-at", "grazing", "planet"):
        windows.pinhole("render", scene, "-o", "there.png", "--aov", "there.exr")
        with tempfile.TemporaryDirectory() as folder:
            linux("render", scene, "-o", f"{folder}/here.png", "--aov", f"{folder}/here.exr")
            for ending in ("png", "exr"):
                here, there = Path(folder, f"here.{ending}").read_bytes(), (windows.home / f"there.{ending}").read_bytes()
                assert here == there, f"{scene}, {ending}: {len(here)} bytes, {len(there)} there"


def figure_writes_the_bytes_that_linux_writes(windows, _pictures):
    for view in ("world", "camera", "derivation"):
        for ending in ("svg", "pdf", "png"):
            windows.pinhole("figure", "look-at", "--view", view, "-o", f"there.{ending}")
            with tempfile.TemporaryDirectory() as folder:
                linux("figure", "look-at", "--view", view, "-o", f"{folder}/here.{ending}")
                same = Path(folder, f"here.{ending}").read_bytes() == (windows.home / f"there.{ending}").read_bytes()
                assert same, f"{view}.{ending} is not that of Linux"


def check_grades_a_class_with_line_ends_of_windows(windows, _pictures):
    answers = {"Jörg Groß.csv": "row,column,t\n100,150,6\n", "Ben.csv": "row,column,t\n100,150,7\n"}
    for ends in ("\n", "\r\n"):
        for name, text in answers.items():
            windows.write(f"class/{name}", text.replace("\n", ends))
        told = windows.pinhole("check", "canonical", "--answers", "class", status=1)
        assert told == linux("check", "canonical", "--answers", "class", folder=windows.home), told
        assert "Jörg Groß" in told, told


def report_has_the_errors_that_linux_has(windows, _pictures):
    def errors(told):
        methods = [method for case in json.loads(told)["cases"] for method in case["methods"]]
        # Kahan's formula asks the C library to multiply and add at once, and mingw's rounds that twice.
        return {method["name"]: [method["wrong"], method["name"].startswith("kahan") or method["ulp"]] for method in methods}
    there, here = (errors(run("report", "canonical", "--json")) for run in (windows.pinhole, linux))
    assert len(there) > 10 and there == here, (there, here)
    windows.pinhole("report", "canonical", "--plot", "plot.svg")
    assert "</svg>" in (windows.home / "plot.svg").read_text()


def a_lecture_is_paged_through(windows, pictures):
    window = Window(windows, "--lesson", "1")
    titles, shots = [], set()
    for page in range(60):
        if not titles or titles[-1] != window.title():
            titles.append(window.title())
            window.picture(pictures / f"lesson-{len(titles)}.png")
        shots.add(window.picture())
        if len(titles) == 8:
            break
        window.key("Next")
    window.close()
    print(f"    {len(titles)} titles, {len(shots)} pictures: {titles}")
    assert len(titles) == 8, titles


def at_is_dragged_and_saved_by_the_dialog_of_windows(windows, pictures):
    windows.write("Übung 3 für Jörg/Ball.toml", SCENE)
    window = Window(windows, "Übung 3 für Jörg\\Ball.toml")
    window.drag()
    window.picture(pictures / "dragged.png")
    window.key("ctrl+shift+s")
    window.picture(pictures / "save-dialog.png")
    window.key("ctrl+a")
    window.paste("Größe 1.toml")
    window.key("Return")
    saved = windows.home / "Übung 3 für Jörg/Größe 1.toml"
    window.wait(saved.exists, "nothing is saved", 20)
    window.titled("Größe 1.toml - ")
    window.picture(pictures / "saved.png")
    window.close()
    assert vector(saved, "at") != vector(saved.with_name("Ball.toml"), "at"), saved.read_text()
    assert saved.read_text().startswith("# A ball. Its comment stays.\npinhole = 1\n"), saved.read_text()
    assert not list(saved.parent.glob(".pinhole-*")), "a temporary file is left"


def a_scene_is_opened_by_argument_and_by_drop(windows, pictures):
    windows.write("Übung 3/Würfel.toml", SCENE)
    for path in ("Übung 3\\Würfel.toml", "C:\\Stunde\\Übung 3\\Würfel.toml", "C:/Stunde/Übung 3/Würfel.toml"):
        window = Window(windows, path)
        window.titled("Würfel.toml - ")
        window.close()
    dropped = windows.write("Übung 3/mit Blank.toml", SCENE.replace("radius = 1.0", "radius = 2.0"))
    window = Window(windows, "canonical")
    command = ["/usr/bin/python3", SOURCES / "tests/windows/drag_source.py", f"/{dropped.relative_to(ROOT)}"]
    source = subprocess.Popen(command, env=windows.outside)
    other = window.wait(lambda: window.x("search", "--onlyvisible", "--name", "drag source"), "no source")
    window.x("windowmove", other, "1380", "200")
    time.sleep(1)
    window.drag((1420, 260), (700, 400), within=False)
    window.picture(pictures / "dropped.png")
    try:
        window.titled("mit Blank.toml - ")
    finally:
        source.terminate()
        window.kill()


def unsaved_work_is_found_after_a_kill(windows, pictures):
    scene = windows.write("Kill.toml", SCENE)
    window = Window(windows, "Kill.toml")
    window.drag()
    # Unsaved changes are written a second after the last.
    time.sleep(3)
    window.kill()
    assert vector(scene, "at") == [0, 0, -1]
    window = Window(windows)
    window.picture(pictures / "found.png")
    window.x("mousemove", *RESTORE, "click", "1")
    window.titled("Kill.toml")
    window.key("ctrl+s")
    window.picture(pictures / "restored.png")
    window.close()
    assert vector(scene, "at") != [0, 0, -1], "the change is lost"


def settings_are_kept_in_appdata(windows, pictures):
    state = windows.roaming / "Pinhole/pinhole/data/state.json"
    window = Window(windows, "canonical")
    before = window.picture()
    window.key("ctrl+plus")
    window.key("ctrl+plus")
    zoomed = window.picture(pictures / "zoomed.png")
    assert zoomed != before
    window.close()
    zoom = json.loads(state.read_text())["settings"]["zoom"]
    assert zoom > 1.1, zoom
    window = Window(windows, "canonical")
    again = window.picture(pictures / "zoomed-again.png")
    window.key("ctrl+0")
    assert window.picture() != again, "the zoom is not kept"
    window.close()
    assert json.loads(state.read_text())["settings"]["zoom"] == 1
    strays = [path for path in (windows.roaming.parent / "Local").rglob("*inhole*")]
    assert not strays, strays


def line_ends_of_windows_are_kept(windows, _pictures):
    scene = windows.write("crlf.toml", SCENE.replace("\n", "\r\n"))
    window = Window(windows, "crlf.toml")
    window.drag()
    window.key("ctrl+s")
    window.close()
    written = scene.read_bytes().decode()
    assert vector(scene, "at") != [0, 0, -1], "not saved"
    assert written.count("\n") == written.count("\r\n") == SCENE.count("\n"), repr(written)
    assert "# the origin\r\n" in written and written.startswith("# A ball. Its comment stays.\r\n"), repr(written)


def paths_have_backslashes_and_drive_letters(windows, pictures):
    windows.write("tables/balls.csv", "x,y,z,r\r\n0,0,-5,1\r\n1,1,-6,1\r\n")
    for spheres in ("C:\\Stunde\\tables\\balls.csv", "../tables/balls.csv", "..\\tables\\balls.csv"):
        windows.write("scenes/many.toml", f"spheres = '{spheres}'\n" + SCENE)
        told = windows.pinhole("inspect", ".\\scenes\\many.toml", "--uv", "0,0")
        assert "sphere" in told, told
    window = Window(windows, "C:\\Stunde\\scenes\\many.toml")
    window.key("ctrl+shift+s")
    window.key("ctrl+a")
    (windows.home / "deep/er").mkdir(parents=True)
    window.paste("C:\\Stunde\\deep\\er\\copy.toml")
    window.key("Return")
    copy = windows.home / "deep/er/copy.toml"
    window.wait(copy.exists, "nothing is saved", 20)
    window.picture(pictures / "table.png")
    window.close()
    # Any system reads it.
    assert re.match("spheres = [\"']../../tables/balls.csv[\"']\n", copy.read_text()), copy.read_text()


def a_file_that_another_program_has_open_is_left_alone(windows, pictures):
    scene = windows.write("held.toml", SCENE)
    picture = windows.home / "held.png"
    windows.pinhole("render", "held.toml", "-o", "held.png")
    before = picture.read_bytes()
    window = Window(windows, "held.toml")
    window.drag()
    holders = [windows.holder("held.toml"), windows.holder("held.png")]
    window.key("ctrl+s")
    window.picture(pictures / "held.png")
    told = windows.pinhole("render", "canonical", "-o", "held.png", status=1)
    assert told == "error: held.png: cannot be written: access is denied, or another program has it open\n", told
    assert scene.read_text() == SCENE and picture.read_bytes() == before
    assert not list(windows.home.glob(".pinhole-*")), "a temporary file is left"
    for holder in holders:
        window.wait(lambda: windows.run("taskkill", "/f", "/im", "ping.exe") and holder.poll() is not None, "still held")
    window.key("Escape")
    window.key("ctrl+s")
    window.close()
    assert vector(scene, "at") != [0, 0, -1], "the change is lost"
    windows.pinhole("render", "canonical", "-o", "held.png")
    assert picture.read_bytes() != before


def names_that_windows_refuses_have_a_clear_error(windows, _pictures):
    before = sorted(windows.home.iterdir())
    device, letter = "is the name of a device of Windows", "in a name"
    refused = {"con.png": device, "AUX.png": device, "nul.tar.png": device, "com1.png": device, "lpt².png": device,
               "a:b.png": "there is no drive a:", "one:two.png": "no : in a name", "why?.png": letter, "a<b.png": letter,
               "a|b.png": letter, "st*r.png": letter, 'quote".png': letter, "dot.png.": "dot or blank at the end",
               "blank.png ": "dot or blank at the end"}
    for name, reason in refused.items():
        status = 2 if name[-1] in ". " else 1
        told = windows.pinhole("render", "canonical", "-o", name, status=status)
        assert reason in told or status == 2 and "png" in told, (name, told)
    assert sorted(windows.home.iterdir()) == before, "something is written"


def a_camera_is_pasted_from_the_clipboard(windows, pictures):
    scene = windows.write("paste.toml", SCENE)
    window = Window(windows, "paste.toml")
    window.paste("gluLookAt(1, 2, 3, 0, 0, -4, 0, 1, 0);")
    window.picture(pictures / "pasted.png")
    window.key("Return")
    window.key("ctrl+s")
    window.picture(pictures / "pasted-2.png")
    window.close()
    assert vector(scene, "eye") == [1, 2, 3], scene.read_text()


CHECKS = [
    the_file_is_what_windows_wants_of_it,
    output_goes_to_terminals_pipes_and_files,
    render_writes_the_bytes_that_linux_writes,
    figure_writes_the_bytes_that_linux_writes,
    check_grades_a_class_with_line_ends_of_windows,
    report_has_the_errors_that_linux_has,
    names_that_windows_refuses_have_a_clear_error,
    a_lecture_is_paged_through,
    at_is_dragged_and_saved_by_the_dialog_of_windows,
    a_scene_is_opened_by_argument_and_by_drop,
    unsaved_work_is_found_after_a_kill,
    settings_are_kept_in_appdata,
    line_ends_of_windows_are_kept,
    paths_have_backslashes_and_drive_letters,
    a_file_that_another_program_has_open_is_left_alone,
    a_camera_is_pasted_from_the_clipboard,
]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--pictures", type=Path, default=SOURCES / "target/windows-pictures")
    arguments.add_argument("--program", type=Path, default=SOURCES / "target/pinhole.exe")
    arguments.add_argument("checks", nargs="*", metavar="CHECK")
    chosen = arguments.parse_args()
    chosen.pictures.mkdir(parents=True, exist_ok=True)
    checks = [check for check in CHECKS if not chosen.checks or any(part in check.__name__ for part in chosen.checks)]
    windows, failed = Windows(chosen.program), 0
    try:
        for number, check in enumerate(checks, 1):
            began = time.monotonic()
            try:
                check(windows, chosen.pictures)
                outcome = "pass"
            except Exception:
                failed += 1
                outcome = "FAIL"
                traceback.print_exc()
                subprocess.run(windows.command("wine", "taskkill", "/f", "/im", "pinhole.exe"), capture_output=True)
            print(f"{outcome} {number:2} of {len(checks)}: {check.__name__.replace('_', ' ')} ({time.monotonic() - began:.0f} s)", flush=True)
    finally:
        windows.end()
    print(f"{len(checks) - failed} of {len(checks)} checks pass; pictures in {chosen.pictures}")
    sys.exit(1 if failed else 0)


main()
