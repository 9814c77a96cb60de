#!/usr/bin/env python3
"""Kills workers of a distributed run, which restarts them, again and again.

Payer and Payee are in workers; with Ledger (tests/images/Coins) they count the coins that are paid
and received.  In each round one of them is killed with SIGKILL at a random moment and restarted by
the run.  In half of the rounds the other one is killed too, at the same time or as soon as the first
is back, when it is being connected; then coins must arrive again before the next round.  In the end
no coin may have arrived twice, and no coin that a ready has acknowledged may be missing.  The last line is "N passed, N failed", with one check for each property.

    kill_rounds.py --build build/release --rounds 10000 [--free-running] [--seed 1]
"""
import argparse
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

CONNECTIONS = """\
OVirtualRobotComm.Sensor.OSensorFrameVectorData.S Payer.Sensor.OSensorFrameVectorData.O
Payer.Coins.Coin.S Payee.Coins.Coin.O
Payer.Book.Entry.S Ledger.Paid.Entry.O
Payee.Book.Entry.S Ledger.Got.Entry.O
"""
GONE = re.compile(r"; (the others go on|the run waits for it to come back)( \(\d+ times\))?$")
# Printed by Payer and Payee once in each life: a coin has gone all the way to Ledger.
WORKS = re.compile(r"(Payer)'s first coin has been got|(Payee) has booked its first coin")
BACK = re.compile(r"process '(\w+)' is back \(pid (\d+)")
SUM = re.compile(r"got (\d+) twice (\d+) missed (\d+) lost (\d+) series (\d+)")
WAIT_S = 120  # a generous limit, since a machine may be slow
# A domain of its own.  Other tests kill processes with a lease of an hour; this run would keep data
# for them, and send all of it to each worker that is restarted.
DOMAIN = 77


def make_stick(folder, images):
    objects = os.path.join(folder, "OPEN-R", "MW", "OBJS")
    config = os.path.join(folder, "OPEN-R", "MW", "CONF")
    os.makedirs(objects)
    os.makedirs(config)
    names = ["LEDGER.BIN", "PAYER.BIN", "PAYEE.BIN"]
    for name in names:
        shutil.copy(os.path.join(images, name), objects)
    with open(os.path.join(config, "OBJECT.CFG"), "w") as file:
        file.writelines(f"/MS/OPEN-R/MW/OBJS/{name}\n" for name in names)
    with open(os.path.join(config, "CONNECT.CFG"), "w") as file:
        file.write(CONNECTIONS)


def children_of(pid):
    """Name of the process in the run -> pid."""
    found = {}
    with open(f"/proc/{pid}/task/{pid}/children") as file:
        for child in file.read().split():
            try:
                with open(f"/proc/{child}/cmdline") as line:
                    words = line.read().split("\0")
                found[words[words.index("--process") + 1]] = int(child)
            except (OSError, ValueError, IndexError):
                pass  # the process has just ended, or is just starting
    return found


class Run:
    """openr run, what it says, and which process is back."""

    def __init__(self, build, stick, rounds, free):
        command = [os.path.join(build, "bin", "openr"), "run", "--stick", stick, "--body", "ideal",
                   "--no-panel", "--rc-port", "0", "--place", "Payer=payer", "--place",
                   "Payee=payee", "--restart", str(2 * rounds), "--dds-domain", str(DOMAIN),
                   "--dds-lease", "10"]
        command += ["--free-running"] if free else ["--rate", "max"]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                                        text=True, errors="replace")
        self.changed = threading.Condition()
        self.returns = 0
        self.working = set()  # workers whose first coin has arrived since their last start
        self.lives = 0  # lives of Payer in which it has paid
        self.lines = []
        self.has_ended = False
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stderr:
            with self.changed:
                back, works = BACK.search(line), WORKS.search(line)
                if back:
                    self.returns += 1
                    self.working.discard(back.group(1))
                elif works:
                    self.working.add((works.group(1) or works.group(2)).lower())
                    self.lives += works.group(1) is not None
                elif not GONE.search(line):
                    self.lines.append(line.rstrip())
                    del self.lines[:-200]
                self.changed.notify_all()
        with self.changed:
            self.has_ended = True
            self.changed.notify_all()

    def wait_for_returns(self, count):
        with self.changed:
            return self.changed.wait_for(lambda: self.has_ended or self.returns >= count, WAIT_S) \
                and self.returns >= count


    def wait_for_work(self):
        """Until coins of both lives that are there now have been got."""
        with self.changed:
            return self.changed.wait_for(lambda: self.has_ended or len(self.working) == 2, WAIT_S) \
                and len(self.working) == 2


def kill(run, victim, kills):
    """Whether there was a process to kill."""
    pid = children_of(run.process.pid).get(victim)
    if pid is None:
        return False
    os.kill(pid, signal.SIGKILL)
    kills[victim] += 1
    return True


def play_round(run, dice, kills):
    """Whether all that were killed in this round came back, and worked after a round with two."""
    time.sleep(dice.random() * 0.02)
    victims = dice.sample(["payer", "payee"], 2)
    kind = dice.choice(["one", "one", "both", "one after the other"])
    if not kill(run, victims[0], kills):
        return False
    if kind == "one":
        return run.wait_for_returns(sum(kills.values()))
    if kind == "one after the other":
        if not run.wait_for_returns(sum(kills.values())):
            return False
        # The run connects the objects of a process within a millisecond or two.
        time.sleep(dice.random() * 0.002)
    return kill(run, victims[1], kills) and run.wait_for_returns(sum(kills.values())) \
        and run.wait_for_work()


def play(run, rounds, dice, kills):
    """Plays `rounds` rounds; the number of those that went well."""
    if not run.wait_for_work():
        return 0
    for number in range(rounds):
        if not play_round(run, dice, kills):
            return number
        if (number + 1) % 1000 == 0:
            print(f"{number + 1} rounds", flush=True)
    return rounds


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True)
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--free-running", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    flags = parser.parse_args()
    checks = []
    with tempfile.TemporaryDirectory() as stick:
        make_stick(stick, os.path.join(os.path.abspath(flags.build), "images"))
        run = Run(flags.build, stick, flags.rounds, flags.free_running)
        begin = time.monotonic()
        kills = {"payer": 0, "payee": 0}
        done = play(run, flags.rounds, random.Random(flags.seed), kills)
        taken = time.monotonic() - begin
        checks.append(("coins got after the last return", run.wait_for_work()))
        kill_count = sum(kills.values())
        checks.append((f"{done} of {flags.rounds} rounds, {kill_count} kills",
                       done == flags.rounds))
        run.process.send_signal(signal.SIGINT)
        try:
            run.process.wait(WAIT_S)
        except subprocess.TimeoutExpired:
            run.process.kill()
        with run.changed:
            run.changed.wait_for(lambda: run.has_ended, WAIT_S)
        sums = [SUM.search(line) for line in run.lines if SUM.search(line)]
    if sums:
        got, twice, missed, lost, series = map(int, sums[-1].groups())
        print(f"{done} rounds with {kill_count} kills in {taken:.0f} s: {got} coins got, "
              f"{lost} came back unread, {series} lives of Payer")
        checks += [("no coin twice", twice == 0),
                   ("no acknowledged coin missing", missed == 0),
                   ("more coins than rounds", got > flags.rounds),
                   (f"{series} series of {run.lives} lives that paid, with {kills['payer']} kills",
                    run.lives <= series <= kills["payer"] + 1)]
    else:
        checks.append(("the sum of Ledger", False))
    failed = [name for name, good in checks if not good]
    for name in failed:
        print(f"failed: {name}")
    if failed:
        print("\n".join(run.lines[-30:]))
    print(f"{len(checks) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
