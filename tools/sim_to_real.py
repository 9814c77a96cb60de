#!/usr/bin/env python3
"""The sim-to-real figure: one motion on two runs with different servos, and what a log says of it.

One run takes the part of the real dog: its servos get other gains.  Both dogs are lifted, so that
no paw touches the floor, and play the same motion, in which every joint swings.  The log of the
synchronised play-back (docs/motion-logs.md) gives lag and gain of each servo in both runs.  The
differences are compared with those that the gains should make, by the equation of the servo
(docs/body.md), and the exit status is 1 when one is beyond the bounds.

usage: tools/sim_to_real.py [--build build/release] [-o PICTURE] [--log LOG] [--json]
"""
import argparse
import cmath
import contextlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODEL = json.loads((ROOT / "virtualrobot/model/ers210.json").read_text())
JOINTS = [row for row in MODEL["joints"]["rows"] if "mtn" in row]

FRAME_S = 0.008
DRIVE_FULL = 255        # virtualrobot/dynamics/servo.h
AD_STEPS = 1023
NO_LOAD_RATIO = 2.0

KEY_FRAME_S = 0.016
SWING_HZ = 1.25
SWINGS = 4
RAMP_S = 0.8            # time in which the swing grows at the start, and fades at the end

# The factor of each joint's P gain in the run that takes the part of the real dog.
FACTORS = [0.6, 0.7, 1.4, 0.5, 0.6, 0.7, 0.75, 0.5, 0.6, 1.0, 0.8, 0.5, 1.3, 0.7, 0.9]

# Bounds of the errors: by how much the lag difference and the gain ratio from the log may differ
# from those that the equation predicts.  The joint neck_tilt has bounds of its own, because the
# equation has no weight: near the upright pose the weight of the head pushes the joint away from
# the middle, so that the servo acts softer.
LAG_BOUND_MS, GAIN_BOUND = 1.0, 0.005
WEIGHT_LAG_BOUND_MS, WEIGHT_GAIN_BOUND = 6.0, 0.02


def amplitude_deg(joint):
    return 8 if joint["name"].endswith("_j2") else 12  # J2 can move only 11 degrees inwards


def swing_csv():
    """Returns a motion as CSV (openr mtn from-csv): each joint swings about the standing pose."""
    stand = MODEL["postures"]["rows"]
    stand = next(row for row in stand if row["name"] == "stand")["degrees"]
    middle = dict(zip((row["name"] for row in MODEL["joints"]["rows"]), stand))
    duration = SWINGS / SWING_HZ
    lines = ["key_frame,time_ms,roll_deg,pitch_deg,yaw_deg," +
             ",".join(joint["locator"] for joint in JOINTS)]
    for k in range(round(duration / KEY_FRAME_S) + 1):
        t = k * KEY_FRAME_S
        ramp = min(1, t / RAMP_S, max(0, duration - t) / RAMP_S)
        size = (1 - math.cos(math.pi * ramp)) / 2
        angles = [middle[joint["name"]] + size * amplitude_deg(joint) *
                  math.sin(2 * math.pi * SWING_HZ * t + 0.7 * i)
                  for i, joint in enumerate(JOINTS)]
        lines.append(f"{k},{16 * k},0,0,0," + ",".join(f"{a:.5f}" for a in angles))
    return "\n".join(lines) + "\n"


def response(joint, gains):
    """Returns lag in ms and gain of a servo at the frequency of the swing, for no load and inertia.

    The drive is P e + I sum(e) + D (r - v), with error e, commanded speed r and measured speed v.
    Without load, drive / 255 = v / no-load speed.  A speed is the difference between two frames.
    """
    low, high = joint["hard"]
    counts = AD_STEPS / math.radians(high - low)
    p, i, d = (g * 2.0 ** (shift - 16) * counts for g, shift in zip(gains, joint["pid"][3:]))
    damping = DRIVE_FULL / (NO_LOAD_RATIO * math.radians(joint["speed"][1]))
    omega = 2 * math.pi * SWING_HZ
    s = (1 - cmath.exp(-1j * omega * FRAME_S)) / FRAME_S
    d *= FRAME_S
    i /= FRAME_S
    h = (p + d * s + i / s) / (p + (d + damping) * s + i / s)
    return -cmath.phase(h) / omega * 1000, abs(h)


def p_gain_of(joint, gains, lag_ms):
    """Returns the P gain with which the servo has this lag.

    Because a larger gain makes the lag smaller, the search can halve the interval.
    """
    low, high = 1.0, 127.0
    for _ in range(60):
        middle = (low + high) / 2
        if response(joint, [middle, *gains[1:]])[0] > lag_ms:
            low = middle
        else:
            high = middle
    return (low + high) / 2


class Run:
    """A process of `openr run` whose dog is lifted, so that its paws are in the air."""

    def __init__(self, openr, folder, name):
        self.openr = openr
        events = folder / "lift.events"
        events.write_text("17s lift 0.25\n")
        self.said = open(folder / f"{name}.txt", "w+")
        self.process = subprocess.Popen(
            [openr, "run", "--no-panel", "--rc-port", "0", "--rate", "8", "--for", "10min",
             "--events", str(events)], stdout=subprocess.DEVNULL, stderr=self.said)
        self.address = None

    def __enter__(self):
        self.address = self.wait_for(r"openr rc (127\.0\.0\.1:\d+)")
        return self

    def wait_for(self, pattern):
        while self.process.poll() is None:
            found = re.search(pattern, pathlib.Path(self.said.name).read_text())
            if found:
                return found[1]
            time.sleep(0.05)
        sys.exit(f"openr run has ended: {pathlib.Path(self.said.name).read_text()}")

    def rc(self, *words):
        done = subprocess.run([self.openr, "rc", self.address, "--json", *map(str, words)],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"openr rc {' '.join(map(str, words))}: {done.stderr}")
        return [json.loads(line) for line in done.stdout.splitlines()]

    def wait_until_lifted(self):
        while True:
            answer = self.rc("info")[0]
            if answer["frame"] is not None and answer["frame"] * FRAME_S > 20:
                return
            time.sleep(0.1)

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.said.close()


def play(openr, folder, log):
    """Plays the swing on both dogs; returns for each joint the gains of the real and other dog."""
    table, motion = folder / "swing.csv", folder / "SWING.MTN"
    table.write_text(swing_csv())
    subprocess.run([openr, "mtn", "from-csv", table, "-o", motion], check=True)
    with contextlib.ExitStack() as runs:
        real, simulated = (runs.enter_context(Run(openr, folder, name))
                           for name in ("real", "simulated"))
        for run in real, simulated:
            run.wait_until_lifted()
            run.rc("mtn", "upload", motion)
        put_in = []
        for joint, factor in zip(JOINTS, FACTORS):
            p, i, d = joint["pid"][:3]
            changed = [round(p * factor), i, d]
            real.rc("gains", joint["name"], *changed)
            put_in.append((changed, [p, i, d]))
        real.rc("mtn", "play", motion.name, "--log", log, "--with", simulated.address)
        return put_in


def compare(openr, log, group, *more):
    words = [openr, "log", "compare", log, "--json", "--group", "commanded", "--other-group", group]
    done = subprocess.run([*words, *more], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["joints"]


def rows_of(openr, log, put_in):
    """Returns a row for each joint: lag difference and gain ratio of both dogs.

    Keys with "put_in" are predicted by response(); the others come from the log.
    """
    rows = []
    for joint, gains, real, simulated in zip(JOINTS, put_in, compare(openr, log, "measured"),
                                             compare(openr, log, "simulated")):
        real_lag, real_gain = response(joint, gains[0])
        simulated_lag, simulated_gain = response(joint, gains[1])
        rows.append({"joint": joint["name"], "p_real": gains[0][0], "p_simulated": gains[1][0],
                     "p_given_back": p_gain_of(joint, gains[0], real["lag_ms"]),
                     "lag_put_in_ms": real_lag - simulated_lag,
                     "lag_ms": real["lag_ms"] - simulated["lag_ms"],
                     "gain_put_in": real_gain / simulated_gain,
                     "gain": real["gain"] / simulated["gain"]})
    return rows


def is_within(row):
    has_weight = row["joint"] == "neck_tilt"
    lag_bound_ms = WEIGHT_LAG_BOUND_MS if has_weight else LAG_BOUND_MS
    gain_bound = WEIGHT_GAIN_BOUND if has_weight else GAIN_BOUND
    return (abs(row["lag_ms"] - row["lag_put_in_ms"]) <= lag_bound_ms and
            abs(row["gain"] - row["gain_put_in"]) <= gain_bound)


def show(rows):
    print("                    P gain          lag, real - simulated      gain, real / simulated")
    print("joint         sim   real   back    put in    back   error    put in    back   error")
    for r in rows:
        print(f"{r['joint']:<12} {r['p_simulated']:4d} {r['p_real']:6d} {r['p_given_back']:6.1f} "
              f"{r['lag_put_in_ms']:9.1f} {r['lag_ms']:7.1f} {r['lag_ms'] - r['lag_put_in_ms']:7.1f}"
              f" {r['gain_put_in']:9.3f} {r['gain']:7.3f} {r['gain'] - r['gain_put_in']:7.3f}"
              f"{'' if is_within(r) else '  beyond the bound'}")
    print(f"bounds of the errors: {LAG_BOUND_MS} ms and {GAIN_BOUND}; of neck_tilt, which carries "
          f"the head, {WEIGHT_LAG_BOUND_MS} ms and {WEIGHT_GAIN_BOUND}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=ROOT / "build/release", help="build folder")
    parser.add_argument("-o", "--output", help="chart of both dogs, .svg or .png")
    parser.add_argument("--log", help="where to keep the log")
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    openr = str(pathlib.Path(arguments.build, "bin/openr").resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log = arguments.log or str(folder / "swing.log")
        put_in = play(openr, folder, log)
        rows = rows_of(openr, log, put_in)
        if arguments.output:
            subprocess.run([openr, "log", "compare", log, "-o", arguments.output], check=True,
                           stdout=subprocess.DEVNULL)
    print(json.dumps(rows)) if arguments.json else show(rows)
    return 0 if all(map(is_within, rows)) else 1


if __name__ == "__main__":
    sys.exit(main())
