#!/usr/bin/env python3
"""Lets a run go on for a day of virtual time, with clients of its remote control and inputs.

    soak.py --build build/release [--hours 24] [--seed 1] [--body ideal] [--connections 10000]
            [--keep FOLDER]

The run goes on in steps of 25 frames (0.2 s of virtual time).  Before each step, clients come and
go, send their requests and compare the answers: they send commands, play motions, upload motions
and controllers, reboot the robot, take pictures, send garbage, or read nothing.  People press
sensors, turn joints and lift the dog, through the socket of the run, `openr poke` and
`openr attach`.  Once in an hour all clients leave, eight clients send 100 commands per second each
for 10 s, and memory and descriptors of the run are noted.  At the end, clients connect one after
the other, --connections in all.

The checks: every request has its answer, the run goes on while a client reads nothing, memory and
number of descriptors stay what they were, the report has no finding (on the physical body, none but
those of a robot that was pushed over), and the recording replays to equal hashes.  The last line is
"N passed, N failed".

A failed check can be seen again with the same seed; --keep leaves stick, recording, console and
report in FOLDER.
"""
import argparse
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import remote_load as load
import remote_run as rc
from soak_clients import Clients

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import finish, verdict  # noqa: E402: the folder is put into the path first

STEP_FRAMES = 25
STEPS_PER_HOUR = 3600 * 5
GUESTS = 6  # clients at the same time; 8 places, of which some belong to clients that just left
BURST_STEPS = 10 * load.STEPS_PER_SECOND
# A boot needs 3 s and the way to the standing posture 12 s.
BOOT_STEPS = 250
# The head is where the eight clients have sent it: 160 degrees take 5.3 s at their lowest speed.
REST_STEPS = 30
GROWTH_KB = 2048
# Inputs of people (docs/inputs.md) after which the robot is again as it was.
INPUTS = ("press chin for 300ms", "press back 80% for 200ms", "press head for 1s", "release head",
          "set distance 300000 for 500ms", "turn neck_pan 30 for 400ms", "turn LF_j3 20 for 200ms",
          "lift 0.1", "hold", "setdown", "letgo", "battery 90%", "charger on", "charger off",
          "break chin stuck for 1s", "break distance noisy 5% for 2s",
          "break neck_pan weak 50% for 1s", "break paw_LF dead for 400ms",
          "heat body 40 for 5s", "repair all")
PHYSICS_INPUTS = ("push 0 4 0 for 100ms", "push 5 0 0 at body")
LOOKS = "status\nobjects\nobject RCServer\nsensors\njoints\nfindings\n"

# Findings that a robot on the physical body may have.  PHYSICS_INPUTS push it over sooner or later,
# and nobody puts it back on its feet.  The joints on which it lies press against the floor, which is an
# error after 30 s.  They do not follow their set points, so a client that sees them near the first key
# frame of a motion may begin it although the set points are up to 45 degrees away.
PRESSED = re.compile(r"MECHA_LOAD_HIGH")
JUMP = re.compile(r"set point jumps from (-?[\d.]+) to (-?[\d.]+) degrees")
JUMP_DEG = 45


def is_expected(finding, body):
    if body != "ode":
        return False
    jump = JUMP.search(finding["text"])
    return PRESSED.search(finding["text"]) is not None or \
        (finding["object"] == "JointMover" and finding["severity"] == "warning" and
         jump is not None and abs(float(jump[1]) - float(jump[2])) < JUMP_DEG)


class Soak(Clients):
    """A run that goes on step by step, and the people and clients around it."""

    def __init__(self, run, seed, inputs):
        super().__init__(run, seed)
        self.inputs = inputs
        self.dice = random.Random(seed)
        self.marks = []  # memory in KiB and number of descriptors, once in an hour
        self.begin_s = self.time_s

    # ---- Steps

    def step(self, frames=STEP_FRAMES):
        self.time_s = self.run.step(frames, self.time_s)
        self.counts["steps"] += 1

    def go_on(self):
        """Lets each client act, and the run go on for a step."""
        self.guests = [guest for guest in self.guests if next(guest, "end") != "end"]
        self.step()

    # ---- People

    def give_input(self):
        line = self.dice.choice(self.inputs)
        answer = self.run.control(do="input", robot=0, line=line)
        if "error" in answer:
            self.fail(f"input {line}: {answer}")
        self.counts["inputs"] += 1

    def run_command(self, *words, typed=""):
        """Runs `openr` with these words; counts a failure unless it ends well."""
        done = subprocess.run([self.run.openr, *words], input=typed, capture_output=True, text=True,
                              env=self.run.environment, timeout=rc.HANG_S, check=False)
        if done.returncode != 0 or done.stderr:
            self.fail(f"openr {' '.join(words)}: {done.stdout}{done.stderr}")
        self.counts[f"openr {words[0]}"] += 1

    def people(self):
        if self.dice.random() < 0.05:
            self.give_input()
        if self.dice.random() < 0.001:
            self.run_command("poke", "check", self.dice.choice(self.inputs))
        if self.dice.random() < 0.001:
            self.run_command("attach", "check", typed=LOOKS)

    # ---- Hours

    def let_boot(self):
        """Waits until the robot takes connections again after a reboot."""
        for _ in range(BOOT_STEPS):
            self.step()
            try:
                rc.Client(self.run.port).close()
            except OSError:
                continue
            self.is_off = False
            self.counts["reboots"] += 1
            return
        raise RuntimeError("the robot takes no connections after a reboot")

    def everyday(self, steps):
        """Lets clients and people come and go for so many steps."""
        for _ in range(steps):
            if self.is_off and not self.guests:
                self.let_boot()
            if not self.is_off and len(self.guests) < GUESTS and self.dice.random() < 0.25:
                kind = self.dice.choices(list(self.KINDS), self.KINDS.values())[0]
                self.welcome(getattr(self, kind))
            self.people()
            self.go_on()

    def quiet(self):
        """Waits until all clients have left and the robot stands; nobody acts then."""
        while self.guests:
            self.go_on()
        if self.is_off:
            self.let_boot()
        for line in ("repair all", "release head", "letgo"):
            self.run.control(do="input", robot=0, line=line)
        for _ in range(5):
            self.step()
        state = self.look()
        for _ in range(BOOT_STEPS):
            if state == rc.READY:
                return
            state = self.look()
        self.fail(f"JointMover is in state {state} after {BOOT_STEPS} quiet steps")

    def look(self):
        """Returns the state of JointMover, seen by a client that then leaves."""
        client = rc.Client(self.run.port)
        try:
            asking = self.ask(client, (rc.MTN_STOP, b""), (rc.SENSORS, b""))
            while True:
                try:
                    next(asking)
                except StopIteration as end:
                    return end.value[1].payload[5]
                self.step()
        finally:
            client.close()
            self.step()

    def burst(self):
        """Eight clients send 100 commands per second of virtual time each."""
        self.number += 1
        clients = [load.LoadClient(self.run.port, random.Random(f"{self.seed}/{self.number}/{i}"))
                   for i in range(load.CLIENTS)]
        for step in range(BURST_STEPS):
            self.time_s = load.load_step(self.run, clients, step, step == BURST_STEPS - 1, self.time_s)
        for number, client in enumerate(clients):
            client.close()
            self.counts["answers of eight clients"] += client.answered
            if client.wrong or client.expected or client.late or client.is_closed:
                self.fail(f"client {number} of eight: {client.wrong[:1]}, {client.late} late, "
                          f"{len(client.expected)} missing, closed: {client.is_closed}")
        for _ in range(REST_STEPS):
            self.step()

    def mark(self):
        """Notes memory and descriptors of the run."""
        count = len(os.listdir(f"/proc/{self.run.process.pid}/fd"))
        self.marks.append((self.run.memory_kb(), count))
        size = (self.run.folder / "run.rec").stat().st_size >> 20
        print(f"t={self.time_s / 3600:.2f} h: memory {self.marks[-1][0]} KiB, {count} descriptors, "
              f"recording {size} MiB, {self.counts['answers']} answers", flush=True)

    def hour(self, steps):
        self.everyday(steps)
        self.quiet()
        for kind in (self.controller_uploader, self.reads_nothing):
            self.welcome(kind)
            self.quiet()
        self.burst()
        self.mark()

    def connect_in_a_row(self, count):
        """Lets so many clients connect one after the other."""
        for _ in range(count):
            self.welcome(self.asker)
            while self.guests:
                self.guests = [guest for guest in self.guests if next(guest, "end") != "end"]
                self.step(load.STEP_FRAMES)
        self.mark()


def soak(run, flags):
    """Lets the run go on for all hours; prints verdicts and figures."""
    inputs = INPUTS + (PHYSICS_INPUTS if flags.body == "ode" else ())
    day = Soak(run, flags.seed, inputs)
    begin = time.monotonic()
    for _ in range(BOOT_STEPS):
        if day.look() == rc.READY:
            break
    parts = max(4, round(flags.hours))
    for _ in range(parts):
        day.hour(round(flags.hours * STEPS_PER_HOUR / parts))
    hours_s = day.time_s - day.begin_s
    day.connect_in_a_row(flags.connections)
    wrong = day.wrong
    verdict("all clients are served and all inputs taken", not wrong,
            f"{len(wrong)} failures, the first:\n" + "\n".join(wrong[:10]))
    for what in (*(f"clients: {kind}" for kind in day.KINDS), "inputs", "uploads", "motions",
                 "answers beside a client that reads nothing"):
        verdict(f"{what}: at least one", day.counts[what] > 0)
    # The first quarter fills what is filled once: pools, tables and buffers.
    first = day.marks[parts // 4 - 1]
    last, end = day.marks[-2:]
    for name, (memory, count), (memory_0, count_0) in (
            ("the hours", last, first), (f"{flags.connections} connections", end, last)):
        verdict(f"memory grows by at most {GROWTH_KB} KiB in {name}", memory - memory_0 <= GROWTH_KB,
                f"from {memory_0} to {memory} KiB")
        verdict(f"descriptors are as many after {name} as before", count == count_0,
                f"{count_0} before, {count} after")
    counts = ", ".join(f"{count} {what}" for what, count in sorted(day.counts.items()))
    print(f"figures: {hours_s / 3600:.2f} h of virtual time and {day.number} clients in "
          f"{time.monotonic() - begin:.0f} s: {counts}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--hours", type=float, default=24, help="of virtual time")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--body", choices=["ideal", "ode"], default="ideal")
    parser.add_argument("--connections", type=int, default=10000)
    parser.add_argument("--keep", type=pathlib.Path, help="new folder for stick, recording and report")
    flags = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="openr-soak-") as scratch:
        folder = flags.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        run = rc.Run(flags.build.resolve() / "bin/openr", folder, "--rate", "max", "--no-payloads",
                     body=flags.body)
        try:
            try:
                soak(run, flags)
                run.clock(pause=False)
            except (rc.Refused, OSError, ValueError, RuntimeError) as error:
                verdict("the run and its clients go on to the end", False, repr(error))
            begin = time.monotonic()
            run.check_end(f", seed {flags.seed}", lambda finding: is_expected(finding, flags.body))
            report = json.loads((folder / "report.json").read_text())
            others = [finding for finding in report["findings"] if not is_expected(finding, flags.body)]
            verdict("the report has no finding other than those of a fallen robot", not others, others[:10])
            print(f"figures: trace hash {report['trace_hash']}, state hash {report['state_hash']}; "
                  f"end and replay in {time.monotonic() - begin:.0f} s")
        finally:
            run.kill()
    return finish()


if __name__ == "__main__":
    sys.exit(main())
