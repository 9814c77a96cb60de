#!/usr/bin/env python3
"""The checks a user would make by command: stand up, obey, play motions.

    check_run.py --build DIR [--motions DIR]

Runs DIR/bin/openr.  Motions of a real robot are not part of the project; where --motions names a
folder with some, they are played from a copy of the default stick that is removed afterwards.
The last line is "N passed, N failed".
"""
import argparse
import csv
import io
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

PATIENCE_S = 240  # the longest wait for anything, in wall time


class Checks:
    def __init__(self):
        self.passed = self.failed = 0

    def expect(self, name, good, details=""):
        self.passed += bool(good)
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'} {name}{'' if good else ': ' + str(details)}", flush=True)


class Robot:
    """openr run in the background until it is told to stop."""

    def __init__(self, openr, *arguments, rate="max", wait_for="state: accepting-commands"):
        self.openr = openr
        self.report = tempfile.NamedTemporaryFile(suffix=".json", delete=False).name
        self.process = subprocess.Popen(
            [openr, "run", "--rate", rate, "--no-panel", "--rc-port", "0", "--report", self.report,
             *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, text=True)
        self.address = None
        for line in self.process.stderr:
            found = re.search(r"openr rc (\S+) info", line)
            if found:
                self.address = found.group(1)
            if wait_for in line:
                break

    def rc(self, *words):
        done = subprocess.run([self.openr, "rc", self.address, "--json", *map(str, words)],
                              capture_output=True, text=True, timeout=PATIENCE_S)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip())
        return json.loads(done.stdout)

    def sensors_when(self, condition):
        end = time.monotonic() + PATIENCE_S
        while True:
            sensors = self.rc("sensors")
            if condition(sensors) or time.monotonic() > end:
                return sensors

    def idle(self):
        return self.sensors_when(lambda s: s["state"] == "accepting-commands")

    def play(self, file, loops=1):
        """Plays to the end and half a second on; returns the answer, the largest key frame
        heard of, and the sensors after it."""
        answer = self.rc("mtn", "play", file, "--loops", loops)
        largest = -1
        while True:
            sensors = self.rc("sensors")
            largest = max(largest, sensors["key_frame"])
            if sensors["state"] == "accepting-commands":
                break
        after = sensors["frame"] + 63
        return answer, largest, self.sensors_when(lambda s: s["frame"] >= after)

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        self.process.stderr.read()
        self.process.wait(timeout=PATIENCE_S)
        with open(self.report) as file:
            report = json.load(file)
        os.remove(self.report)
        return report


def run_report(openr, *arguments):
    done = subprocess.run([openr, "run", "--rate", "max", "--no-panel", "--rc-port", "0", "--json",
                           *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=PATIENCE_S)
    return json.loads(done.stdout)


def check_standing(checks, openr):
    report = run_report(openr, "--for", "30s")
    robot = report["robots"][0]
    states = {o["name"].lower(): o["state"] for o in report["objects"]}
    roll, pitch, _ = robot["base_rpy_deg"]
    paws = [v for k, v in robot["sensors"].items() if k.endswith("-Sensor:s4")]
    checks.expect("JointMover accepts commands after 30 s",
                  states.get("jointmover") == "accepting-commands", states)
    checks.expect("the dog stands", robot["standing"], robot)
    checks.expect("roll is within 2 degrees of 0", abs(roll) < 2, roll)
    checks.expect("pitch is within 2 degrees of +2.6", abs(pitch - 2.6) < 2, pitch)
    checks.expect("all paws touch", paws == [1, 1, 1, 1], paws)
    errors = [f for f in report["findings"] if f["severity"] == "error"]
    checks.expect("no error finding", not errors, errors)
    again = run_report(openr, "--for", "30s")
    for field in ("state_hash", "trace_hash"):
        checks.expect(f"the same run has the same {field}", report[field] == again[field],
                      (report[field], again[field]))


def check_remote(checks, openr):
    # Twice real time: a question takes some ms of wall time, which must not be many frames.
    robot = Robot(openr, rate="2")
    answer = robot.rc("move", "neck_pan", 30)
    limit = answer["frame"] + 375  # 3 s
    sensors = robot.sensors_when(lambda s: s["frame"] >= limit - 8)
    pan = sensors["joints_deg"]["neck_pan"]
    checks.expect("the head turns to 30 degrees within 3 s",
                  abs(pan - 30) <= 2 and sensors["frame"] <= limit + 40, (pan, sensors["frame"]))
    answer = robot.rc("move", "neck_pan", 120)
    checks.expect("a command beyond the limit ends at the limit", answer["in_force"] == 89.6, answer)
    wait = answer["frame"] + 375
    pan = robot.sensors_when(lambda s: s["frame"] >= wait)["joints_deg"]["neck_pan"]
    checks.expect("and so does the head", abs(pan - 89.6) <= 2, pan)
    robot.stop()


def check_recording(checks, openr):
    """A run in real time with three clients and the pause button, recorded and replayed."""
    with tempfile.TemporaryDirectory(prefix="openr-record-") as scratch:
        file = str(pathlib.Path(scratch) / "live.rec")
        robot = Robot(openr, "--record", file, rate="1", wait_for="remote control")
        clients = [subprocess.Popen([openr, "rc", robot.address, "sensors", "--watch"],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                   for _ in range(2)]
        for _ in range(20):
            robot.rc("get", "neck_pan")
        for client in clients:
            client.kill()
            client.wait()
        report = robot.stop()
        replay = json.loads(subprocess.run([openr, "replay", "--json", file], capture_output=True,
                                           text=True, timeout=PATIENCE_S).stdout)
        checks.expect("a live run with three clients replays without difference",
                      replay["equal"] and replay["at_end"], replay)
        checks.expect("and message by message", replay["messages"] == report["messages"],
                      (replay, report["messages"]))


def check_idle_clients(checks, openr):
    robot = Robot(openr, rate="max", wait_for="remote control")
    host, port = robot.address.rsplit(":", 1)
    silent = [socket.create_connection((host, int(port))) for _ in range(8)]
    info = {}
    deadline = time.monotonic() + PATIENCE_S
    while "frame" not in info and time.monotonic() < deadline:
        try:
            info = robot.rc("info")
        except RuntimeError as refusal:  # none of them has been silent for 10 s yet
            if "all 8 places are taken" not in str(refusal):
                info = {"refusal": str(refusal), "frame": None}
                break
    checks.expect("eight silent clients give way to another", info.get("frame") is not None, info)
    for client in silent:
        client.close()
    robot.stop()


def key_frames(openr, file):
    """Locators, and the angles of the first and the last key frame, in degrees."""
    dump = subprocess.run([openr, "mtn", "dump", str(file)], capture_output=True, text=True,
                          check=True).stdout
    rows = list(csv.DictReader(io.StringIO(dump)))
    angles = [{k: float(v) for k, v in row.items() if k.startswith("PRM:")} for row in rows]
    return angles[0], angles[-1]


def begins_sitting(first):
    fore, hind = first["PRM:/r2/c1-Joint2:j1"], first["PRM:/r3/c1-Joint2:j1"]
    return hind < -60 and fore < 40


def begins_lying(first):
    return first["PRM:/r3/c1-Joint2:j1"] < -60 and not begins_sitting(first)


def check_motion(checks, openr, stick, file, model="ers210"):
    first, last = key_frames(openr, file)
    robot = Robot(openr, "--stick", stick, "--robot", model)
    try:
        if model == "ers210" and begins_sitting(first):
            robot.play("STANDSIT.MTN")
        robot.play(file.name)
    except RuntimeError as refusal:
        checks.expect(f"{file.name} plays", False, refusal)
        robot.stop()
        return
    dog = robot.stop()["robots"][0]
    # The motions of an ERS-7 also have ears, which have no sensors.
    off = {k: dog["joints_deg"][k] - v for k, v in last.items() if k in dog["joints_deg"]}
    worst = max(off, key=lambda k: abs(off[k]))
    checks.expect(f"{file.name} ends at its last key frame", abs(off[worst]) < 8,
                  (worst, off[worst]))
    if model == "ers7" or not begins_lying(first):
        roll = dog["base_rpy_deg"][0]
        checks.expect(f"{file.name} ends upright", abs(roll) < 20, roll)


def check_walk(checks, openr, stick, model, begin, walk):
    start = run_report(openr, "--for", "20s", "--robot", model)["robots"][0]["base_position_m"]
    robot = Robot(openr, "--stick", stick, "--robot", model)
    robot.play(begin)
    robot.play(walk, 5)
    end = robot.stop()["robots"][0]["base_position_m"]
    forward, sideways = (1000 * (e - s) for e, s in zip(end[:2], start[:2]))
    checks.expect(f"{begin} and five times {walk} go 150 mm forward", forward >= 150, forward)
    checks.expect("and less than 100 mm sideways", abs(sideways) < 100, sideways)


def check_motions(checks, openr, build, motions):
    with tempfile.TemporaryDirectory(prefix="openr-motions-") as scratch:
        stick = pathlib.Path(scratch) / "stick"
        shutil.copytree(build / "stick", stick)
        files = sorted(motions.glob("*.MTN"))
        for file in files:
            shutil.copyfile(file, stick / "OPEN-R/MW/DATA/P" / file.name)
        for file in files:
            check = subprocess.run([openr, "mtn", "check", str(file)], capture_output=True,
                                   text=True)
            if file.name.startswith("7"):  # for an ERS-7
                checks.expect(f"{file.name} is refused by an unknown locator",
                              check.returncode == 1 and "PRM:" in check.stderr, check.stderr)
                check_motion(checks, openr, str(stick), file, "ers7")
                continue
            checks.expect(f"{file.name} fits the ERS-210", check.returncode == 0, check.stderr)
            if check.returncode == 0:
                check_motion(checks, openr, str(stick), file)
        check_walk(checks, openr, str(stick), "ers210", "SWSDK.MTN", "WWFWD.MTN")
        check_walk(checks, openr, str(stick), "ers7", "7STDWLK.MTN", "7WWFWD.MTN")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--motions", type=pathlib.Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    openr = str(build / "bin/openr")
    checks = Checks()
    check_standing(checks, openr)
    check_remote(checks, openr)
    check_recording(checks, openr)
    check_idle_clients(checks, openr)
    if arguments.motions and arguments.motions.is_dir():
        check_motions(checks, openr, build, arguments.motions)
    else:
        print("no motions of a real robot here: left out")
    print(f"{checks.passed} passed, {checks.failed} failed")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
