#!/usr/bin/env python3
"""Drives the page of the panel with a browser: runs panel/test/browser/panel_test.mjs.

The page is that of a real run.  The test program finds in its environment OPENR_PANEL_URL, the
address of the page with its token; OPENR_PANEL_SHOTS and OPENR_PANEL_SCALE, the folder for its
pictures and how large they are;
OPENR_PANEL_MOTION and OPENR_PANEL_CONTROLLER, files to upload; OPENR_PANEL_SECOND and
OPENR_PANEL_LINK, a second run and the control of the link to it (tests/both/link.py);
OPENR_CHROMIUM, the browser.  Its last line is "N passed, N failed".  Afterwards the recording of the
run is replayed: what a person does in the page is recorded input, so the replay must have equal
hashes.

The last line is "N passed, N failed, N skipped".  Skips, with the reason, where something is
missing; where the variable CI is true, that is a failure.
"""
import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

from run_process import RunProcess

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCRIPT = ROOT / "panel/test/browser/panel_test.mjs"
TOTALS = re.compile(r"^(\d+) passed, (\d+) failed$", re.MULTILINE)
ADDRESS = re.compile(r"panel: (http://\S+)")
ROBOT = re.compile(r"openr rc (127\.0\.0\.1:\d+) info")
LINK = re.compile(r"link: (\S+) control: (\S+)")
LINK_DELAY_MS = 20
# Without a graphics card each pixel takes time of a processor.  With half as many in width and height
# the test needs half of the processor's time.
SCALE = 0.5
LIMIT_S = 900  # until the test in the browser is done
START_LIMIT_S = 120  # until the run has printed the address
END_LIMIT_S = 120  # until the run has ended, and again until its recording was replayed


def missing(build):
    """Returns a text that names the first thing the test needs and does not find, or ""."""
    if not SCRIPT.exists():
        return "panel/test/browser/panel_test.mjs does not exist"
    if not shutil.which("node"):
        return "node is missing (Debian package nodejs)"
    if not (build / "panel/index.html").exists():
        return "the page is not built (target panel_page, which needs npm)"
    if not (build / "lib/libopenr_panel.so").exists():
        return "the panel's server is not built (Debian package libwebsockets-dev)"
    if not shutil.which("chromium"):
        return "chromium is missing (Debian package chromium)"
    return ""


def end_others(folder):
    """Ends the runs that the page has branched off; the name of a socket ends in a process id."""
    for socket in (folder / "openr-host").glob("*.*"):
        try:
            os.kill(int(socket.suffix[1:]), signal.SIGTERM)
        except ProcessLookupError:
            pass


class SecondRobot:
    """The second robot of the test: a run with remote control, and the link that the page uses."""

    def __init__(self, openr):
        # Without physics this run needs little of the processor, so that more is left for the
        # browser, which draws without a graphics card.
        self.run = RunProcess(openr, "--no-panel", "--body", "ideal", "--run-name", "second")
        robot = self.run.wait_for(ROBOT, START_LIMIT_S)[1]
        self.link = subprocess.Popen(
            [sys.executable, str(ROOT / "tests/both/link.py"), "--to", robot, "--delay-ms",
             str(LINK_DELAY_MS)], stdout=subprocess.PIPE, text=True)
        self.address, self.control = LINK.match(self.link.stdout.readline()).groups()

    def end(self):
        self.link.kill()
        self.link.wait()
        self.run.end(END_LIMIT_S)


def steps(address, second, folder, openr, shots, scale, only):
    """Runs the test in the browser; returns how many of its steps passed and failed."""
    motion = folder / "MINE.MTN"
    shutil.copyfile(pathlib.Path(openr).parent.parent / "stick/OPEN-R/MW/DATA/P/BOW.MTN", motion)
    controller = pathlib.Path(openr).parent.parent / "images/TIMERUN.BIN"
    environment = {**os.environ, "OPENR_PANEL_URL": address, "OPENR_PANEL_SHOTS": str(shots),
                   "OPENR_PANEL_SCALE": str(scale),
                   "OPENR_PANEL_MOTION": str(motion), "OPENR_PANEL_SECOND": second.address,
                   "OPENR_PANEL_CONTROLLER": str(controller) if controller.exists() else "",
                   "OPENR_PANEL_LINK": second.control, "OPENR_CHROMIUM": shutil.which("chromium")}
    output = folder / "browser.txt"
    with output.open("w") as stream:
        try:
            subprocess.run(["node", str(SCRIPT), only], cwd=ROOT / "panel", env=environment, stdout=stream,
                           stderr=subprocess.STDOUT, timeout=LIMIT_S, check=False)
        except subprocess.TimeoutExpired:
            stream.write(f"the browser is not done after {LIMIT_S} s\n")
    text = output.read_text(errors="replace")
    print(text, end="")
    totals = TOTALS.findall(text)
    return (int(totals[-1][0]), int(totals[-1][1])) if totals else (0, 1)


def drive(openr, folder, shots, scale, only):
    """Runs the browser test and replays the recording of its run.

    Returns how many tests passed and how many failed; prints the reason of each failure.
    """
    # Runs make their sockets in this folder.  Because the folder is new, the page does not list
    # other runs of this machine.
    os.environ["XDG_RUNTIME_DIR"] = str(folder)
    run = RunProcess(openr, "--panel", "--panel-port", "0", "--run-name", "browser", "--record",
              str(folder / "run.rec"))
    address = run.wait_for(ADDRESS, START_LIMIT_S)
    if not address:
        run.end(END_LIMIT_S)
        print("".join(run.said), "the run has no panel", sep="")
        return 0, 1
    second = SecondRobot(openr)
    passed, failed = steps(address[1], second, folder, openr, shots, scale, only)
    second.end()
    status = run.end(END_LIMIT_S)
    end_others(folder)
    if failed or status != 0:
        print("".join(run.said), f"the run has ended with status {status}", sep="")
    replay = subprocess.run([openr, "replay", str(folder / "run.rec")], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, timeout=END_LIMIT_S, text=True, check=False)
    if replay.returncode != 0:
        print(replay.stdout, "the recording of the run does not replay", sep="")
    wrong = int(status != 0) + int(replay.returncode != 0)
    return passed + 2 - wrong, failed + wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--shots", type=pathlib.Path,
                        help="folder for pictures of full size; default: pictures of half the size in "
                        "panel-shots in the build folder")
    parser.add_argument("--only", default="", help="only steps whose names contain this")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    why = missing(build)
    if why:
        is_wrong = os.environ.get("CI") == "true" and SCRIPT.exists()
        print(f"browser test {'impossible' if is_wrong else 'skipped'}: {why}")
        print("0 passed, 1 failed" if is_wrong else "0 passed, 0 failed, 1 skipped")
        return int(is_wrong)
    shots = (arguments.shots or build / "panel-shots").resolve()
    if not arguments.shots:  # in a folder of a person, only pictures of the same names are written anew
        shutil.rmtree(shots, ignore_errors=True)
    shots.mkdir(parents=True, exist_ok=True)
    sys.stdout.reconfigure(line_buffering=True)
    with tempfile.TemporaryDirectory(prefix="openr-browser-") as folder:
        passed, failed = drive(str(build / "bin/openr"), pathlib.Path(folder), shots,
                               1 if arguments.shots else SCALE, arguments.only)
    print(f"{passed} passed, {failed} failed")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
