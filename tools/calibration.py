#!/usr/bin/env python3
"""The plots and the figures of docs/calibration.md.

Steps of each joint and the distance sensor come from `openr model measure`.  Our WALK.MTN is played
in a run that this script starts, for its commanded and measured positions.

usage: tools/calibration.py [--build build/release] [-o FOLDER] [--no-plots]
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODELS = ["ers210", "ers7"]  # the ERS-220 has the joints of the ERS-210
MOTION = "WALK.MTN"
STANDS_S = 20
ADDRESS = re.compile(r"openr rc (127\.0\.0\.1:\d+) info")


class Run:
    """A run at full speed, which is ended with the `with` block."""

    def __init__(self, openr, folder, *flags):
        self.openr = openr
        self.said = open(folder / f"said-{time.monotonic_ns()}", "w+")
        self.process = subprocess.Popen(
            [openr, "run", "--no-panel", "--rc-port", "0", "--console", "/dev/null", *flags],
            stdout=self.said, stderr=self.said)

    def __enter__(self):
        while True:
            found = ADDRESS.search(pathlib.Path(self.said.name).read_text())
            if found:
                self.address = found[1]
                return self
            if self.process.poll() is not None:
                sys.exit(f"openr run has ended: {pathlib.Path(self.said.name).read_text()}")
            time.sleep(0.05)

    def rc(self, *words):
        done = subprocess.run([self.openr, "rc", self.address, "--json", *map(str, words)],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"openr rc {' '.join(map(str, words))}: {done.stderr}")
        return [json.loads(line) for line in done.stdout.splitlines()]

    def wait_until_s(self, time_s):
        """Waits until this virtual time; a frame has 8 ms."""
        while (self.rc("info")[0]["frame"] or 0) * 0.008 < time_s:
            time.sleep(0.1)

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.said.close()


def join_letters(picture):
    """Puts the letters of each text on one line, so that the file has a third of the lines."""
    text = picture.read_text()
    picture.write_text(re.sub(r"\n *(<use |</g>)", r"\1", text))


def measure(openr, pictures):
    for model in MODELS:
        words = [openr, "model", "measure", model]
        if pictures:
            words += ["--servo", pictures / f"calibration-steps-{model}.svg"]
            if model == "ers210":
                words += ["--distance", pictures / "calibration-distance.svg"]
        answer = json.loads(subprocess.run(words, capture_output=True, text=True,
                                           check=True).stdout)
        print(f"{answer['model']}\n  joint          from    to   90 %  over  error  current")
        for step in answer["steps"]:
            print(f"  {step['joint']:<12} {step['from_deg']:6.1f} {step['to_deg']:6.1f} "
                  f"{step['rise_ms']:5.0f} {step['overshoot_deg']:5.2f} "
                  f"{step['end_error_deg']:6.2f} {step['current_ma_max']:7.0f}")
        for reading in answer["distances"]:
            print(f"  wall at {reading['distance_mm']:4.0f} mm, reflectance "
                  f"{reading['reflectance']:.2f}: {reading['min_mm']:.0f} "
                  f"{reading['mean_mm']:.0f} {reading['max_mm']:.0f}")


def play(openr, folder, pictures):
    """Plays the walk once and draws it."""
    log = folder / "walk.log"
    with Run(openr, folder, "--rate", "8") as run:
        run.wait_until_s(STANDS_S)
        run.rc("mtn", "play", MOTION, "--log", log)
    words = [openr, "log", "compare", log, "--group", "commanded", "--other-group", "measured"]
    if pictures:
        words += ["-o", pictures / "calibration-walk.svg"]
    print(subprocess.run(words, capture_output=True, text=True, check=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=ROOT / "build/release", help="build folder")
    parser.add_argument("-o", "--output", default=ROOT / "docs/pictures", help="folder of the plots")
    parser.add_argument("--no-plots", action="store_true")
    arguments = parser.parse_args()
    openr = str(pathlib.Path(arguments.build, "bin/openr").resolve())
    pictures = None if arguments.no_plots else pathlib.Path(arguments.output)
    measure(openr, pictures)
    with tempfile.TemporaryDirectory() as name:
        play(openr, pathlib.Path(name), pictures)
    for picture in sorted(pictures.glob("calibration-*.svg")) if pictures else []:
        join_letters(picture)
    return 0


if __name__ == "__main__":
    sys.exit(main())
