#!/usr/bin/env python3
"""Kills clients of the remote control while they upload files, again and again.

    kill_uploads.py --build build/release [--rounds 1000] [--seed 1] [--keep FOLDER]
    kill_uploads.py --build build/release --seed 1 --round 17    # one round again

In each round one to three processes upload a motion or an image, some with `openr rc`, some with a
client of this file that sends at a random pace, stalls or sends garbage.  They are killed with
SIGKILL at a random moment.  The file on the stick must always be the old or the new one, whole;
when the connections have ended, no temporary file may be left, and a good upload must succeed.
Other clients are asked all the time.  In the end the recording is replayed.  The last line is
"N passed, N failed", with one check for each property.

What a round does depends on seed and number alone; the moment of a kill also depends on how busy
the machine is.  --keep leaves stick, recording and console in FOLDER.
"""
import argparse
import collections
import os
import pathlib
import random
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zlib

import remote_run as rc

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import finish, verdict  # noqa: E402: the folder is put into the path first

MOTION, IMAGE = rc.MOTION, rc.IMAGE
NAMES = {MOTION: "KILLED.MTN", IMAGE: "CONTROLL.BIN"}
# A killed client can leave its whole upload in the buffers of the network.  The robot reads 16 KB
# of a client in a frame, so the largest upload here takes 40 frames.  Because the run does not wait
# for this process, a connection counts as left open only if it still exists after END_FRAMES_MAX
# frames (10 s of the robot's clock) and after END_LOOKS_MIN checks.
END_FRAMES_MAX, END_LOOKS_MIN = 1250, 300
WRONG_ANSWER = 3  # exit status of a client of this file
RATE = "20"  # virtual seconds per second
SIZES = (3000, 60000, 600000)  # make_data() appends at most so many random bytes

WHOLE = "the file is always the old or the new one"
DONE = "an upload that has succeeded is on the stick"
KEPT = "CONTROLL.OLD is an image that was replaced"
REST = "no temporary file is left and no other file is touched"
OTHERS = "other clients are answered"
ENDS = f"connections end within {END_FRAMES_MAX} frames"
GOOD = "a good upload follows"
PROPERTIES = (WHOLE, DONE, KEPT, REST, OTHERS, ENDS, GOOD)


# ---- The client of this file, which runs in a process of its own -------------------------

Plan = collections.namedtuple("Plan", "stream stop garbage reads pause_s seed")


def make_plan(dice, kind, data):
    """Decides where the upload stops, which garbage follows, and how fast the client sends."""
    packets = [rc.packet(*request) for request in rc.upload_packets(kind, NAMES[kind], data)]
    stream = b"".join(packets)
    stop = dice.choice([len(stream), dice.randrange(len(stream)),
                        sum(map(len, packets[:dice.randrange(len(packets))]))])
    garbage = dice.choice([b"", b"", dice.randbytes(dice.randint(1, 4000)), b"RC\x05\x00" * 4,
                           rc.packet(rc.UPLOAD_DATA, struct.pack("<I", 1 << 30) + b"part"),
                           rc.packet(rc.UPLOAD_END), rc.packet(rc.UPLOAD_END) + packets[0]])
    return Plan(stream, stop, garbage if stop < len(stream) else b"", dice.random() < 0.7,
                dice.choice([0, 0.0002, 0.002]), dice.random())


def follow_plan(port, plan, told):
    """Sends the bytes in pieces, tells the parent when all are sent, and waits to be killed."""
    dice = random.Random(plan.seed)
    client = rc.Client(port)
    at = 0
    while at < plan.stop:
        size = min(dice.randint(1, 4000), plan.stop - at)
        client.send(plan.stream[at:at + size])
        at += size
        if plan.reads:
            client.take(wait=False)
        time.sleep(dice.random() * plan.pause_s)
    client.send(plan.garbage)
    os.write(told, b".")
    signal.pause()


class Child:
    """A process that uploads, and the moment at which it is killed."""

    def __init__(self, run, dice, number, kind, data):
        self.kind, self.data = kind, data
        self.status = None  # exit status; negative: the signal that has killed it
        self.told = None  # pipe: gets a byte when the plan of a client is done
        self.can_finish = True
        if dice.random() < 0.5:
            self.start_rc(run, number)
            self.kill_at_size = dice.choice([None, dice.randrange(len(data))])
            self.kill_after_s = None if self.kill_at_size is not None else dice.random() * 0.15
            self.what = "openr rc"
        else:
            plan = make_plan(dice, kind, data)
            self.start_own(run, plan)
            self.kill_at_size = None
            self.kill_after_s = dice.choice([None, dice.random() * 0.1])
            self.stall_s = dice.choice([0, 0, 0.05])
            self.can_finish = plan.stop == len(plan.stream) or rc.packet(rc.UPLOAD_END) in plan.garbage
            self.what = f"own client, {plan.stop} of {len(plan.stream)} bytes, " \
                        f"{len(plan.garbage)} of garbage"
        self.begin = time.monotonic()

    def start_rc(self, run, number):
        folder = run.folder / f"child{number}"
        folder.mkdir(exist_ok=True)
        file = folder / NAMES[self.kind]
        file.write_bytes(self.data)
        words = ["mtn"] if self.kind == MOTION else ["controller"]
        process = subprocess.Popen([run.openr, "rc", f"127.0.0.1:{run.port}", "--timeout", "60s", *words,
                                    "upload", str(file)], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.pid, self.process = process.pid, process

    def start_own(self, run, plan):
        self.told, tells = os.pipe()
        os.set_blocking(self.told, False)
        self.pid, self.process = os.fork(), None
        if self.pid == 0:
            status = 1
            try:
                follow_plan(run.port, plan, tells)
            except ValueError:
                status = WRONG_ANSWER
            except OSError:
                pass  # the robot has closed the connection, because of the garbage
            finally:
                os._exit(status)
        os.close(tells)

    def has_ended(self):
        if self.status is None and self.process is not None:
            self.status = self.process.poll()
        elif self.status is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid != 0:
                self.status = os.waitstatus_to_exitcode(status)
                os.close(self.told)
        return self.status is not None

    def has_stopped(self):
        """Returns whether a client of this file has come to the end of its plan."""
        try:
            return self.told is not None and os.read(self.told, 1) == b"."
        except BlockingIOError:
            return False

    def kill_in_time(self, uploaded):
        """Kills the process when it is old enough, or when its temporary file is large enough.

        `uploaded`: the size of the largest temporary file on the stick.
        """
        age_s = time.monotonic() - self.begin
        if self.kill_after_s is None and self.has_stopped():
            self.kill_after_s = age_s + self.stall_s
        is_time = self.kill_after_s is not None and age_s >= self.kill_after_s
        if is_time or (self.kill_at_size is not None and uploaded > self.kill_at_size):
            os.kill(self.pid, signal.SIGKILL)  # the process is not reaped yet, so the pid is its own


# ---- The rounds --------------------------------------------------------------------------


def server_sockets(run):
    """Returns the number of sockets of the run, and of TCP connections that it has not closed yet.

    A connection that the run has not accepted yet counts, too.
    """
    links = pathlib.Path(f"/proc/{run.process.pid}/fd").iterdir()
    accepted = sum(os.readlink(link).startswith("socket:") for link in links)
    open_states = ("01", "08")  # ESTABLISHED, CLOSE_WAIT of /proc/net/tcp
    rows = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
    port = f"0100007F:{run.port:04X}"
    return accepted, sum(row[1] == port and row[3] in open_states for row in rows)


class Rounds:
    """Plays rounds, and collects the failures of each property."""

    def __init__(self, run, seed):
        self.run, self.seed = run, seed
        self.wrong = collections.defaultdict(list)
        self.counts = collections.Counter()
        self.slowest_end = 0  # in frames, see wait_for_ends()
        self.round = 0
        self.others = [rc.Client(run.port) for _ in range(2)]
        for other in self.others:
            run.wait_until_standing(other)
        self.quiet_sockets = server_sockets(run)
        stand = self.path(MOTION).with_name("STAND.MTN").read_bytes()
        # The robot ignores bytes behind a motion or an image.  make_data() appends random bytes, so
        # that each upload differs from the others.
        self.bases = {MOTION: stand, IMAGE: self.path(IMAGE).read_bytes()[:20000]}
        self.current = {IMAGE: self.path(IMAGE).read_bytes()}
        self.kept = None  # contents of CONTROLL.OLD
        self.upload(MOTION, stand)
        self.rest = self.other_files()

    def path(self, kind):
        return self.run.stick / rc.FOLDERS[kind] / NAMES[kind]

    def fail(self, name, text):
        line = f"round {self.round}: {text}"
        if line not in self.wrong[name][-1:]:  # look() finds one fault many times
            self.wrong[name].append(line)

    def make_data(self, dice, kind):
        return self.bases[kind] + dice.randbytes(dice.randint(1, dice.choice(SIZES)))

    def other_files(self):
        """Returns name and CRC of all files except the targets of uploads and CONTROLL.OLD.

        A temporary file that an upload has left behind is among them.
        """
        targets = [*map(self.path, NAMES), self.path(IMAGE).with_suffix(".OLD")]
        files = sorted(path for path in self.run.stick.rglob("*") if path.is_file())
        return {str(path.relative_to(self.run.stick)): zlib.crc32(path.read_bytes())
                for path in files if path not in targets}

    def uploaded(self):
        """Returns the size of the largest temporary file of an upload, or 0."""
        sizes = [0]
        for folder in rc.FOLDERS.values():
            for path in (self.run.stick / folder).glob("UPLOAD*.TMP"):
                try:
                    sizes.append(path.stat().st_size)
                except FileNotFoundError:
                    pass
        return max(sizes)

    def ask_others(self):
        """Lets the other clients send requests; returns the frame of the last answer."""
        for other in self.others:
            answers = other.ask_all([(rc.GET, b"\x01"), (rc.SENSORS, b""), (rc.POWER, b"")])
            self.counts["answers to other clients"] += len(answers)
        return answers[-1].frame

    def upload(self, kind, data):
        """Uploads `data` completely, and keeps it as the contents that are expected from now on."""
        client = rc.Client(self.run.port)
        packets = rc.upload_packets(kind, NAMES[kind], data)
        try:
            for at in range(0, len(packets), 30):
                client.ask_all(packets[at:at + 30])
        finally:
            client.close()
        if kind == IMAGE:
            self.kept = self.current[kind]
        self.current[kind] = data

    def allowed(self, kind, children):
        """Returns the contents that the file may have: old ones, and those of the children."""
        return [self.current[kind]] + [child.data for child in children
                                       if child.kind == kind and child.can_finish]

    def look(self, children):
        """Checks that each file is the old one or a whole new one, while uploads go on."""
        for kind in NAMES:
            found = zlib.crc32(self.path(kind).read_bytes())
            if found not in [zlib.crc32(data) for data in self.allowed(kind, children)]:
                self.fail(WHOLE, f"{NAMES[kind]} is another file")

    def kill_all(self, children):
        """Kills the children, each at its moment.

        Until all are dead, checks the files and the answers to the other clients.
        """
        end = time.monotonic() + rc.HANG_S
        largest = 0
        alive = children
        while alive:
            self.ask_others()
            uploaded = self.uploaded()
            largest = max(largest, uploaded)
            self.look(children)
            for child in alive:
                if not child.has_ended():
                    child.kill_in_time(uploaded)
            alive = [child for child in alive if not child.has_ended()]
            if time.monotonic() > end:
                raise TimeoutError(f"clients have not ended: {[child.what for child in alive]}")
        if any(child.status == WRONG_ANSWER for child in children):
            self.fail(OTHERS, "a client that uploads got bytes that are no answer")
        self.counts["ended before"] += sum(child.status == 0 for child in children)
        self.counts["killed"] += sum(child.status == -signal.SIGKILL for child in children)
        self.counts["rounds with a temporary file"] += largest > 0

    def wait_for_ends(self, children):
        """Waits until the run has closed the connections of the killed children."""
        begin = frame = self.ask_others()
        looks = 0
        while server_sockets(self.run) != self.quiet_sockets:
            self.look(children)
            frame = self.ask_others()
            looks += 1
            if frame - begin > END_FRAMES_MAX and looks > END_LOOKS_MIN:
                self.fail(ENDS, f"sockets {server_sockets(self.run)}, {self.quiet_sockets} before")
                break
        self.slowest_end = max(self.slowest_end, frame - begin)

    def compare(self, kind, children):
        """Checks the file, and CONTROLL.OLD, after all children have ended."""
        mine = [child for child in children if child.kind == kind]
        found = self.path(kind).read_bytes()
        is_new = found != self.current[kind]
        if mine:
            self.counts["new files" if is_new else "old files"] += 1
        if not is_new and any(child.status == 0 for child in mine):
            self.fail(DONE, NAMES[kind])
        if kind == IMAGE:
            old = self.path(IMAGE).with_suffix(".OLD")
            kept = old.read_bytes() if old.exists() else None
            may_be = [self.current[kind]] if is_new else [self.kept]
            if len(mine) > 1:  # several uploads may have succeeded
                may_be = [self.kept, *self.allowed(kind, children)]
            if kept not in may_be:
                self.fail(KEPT, "it is another file")
            self.kept = kept
        self.current[kind] = found

    def follow_up(self, dice):
        """Uploads a good file, in turn a motion and an image, and checks the files on the stick."""
        kind = self.round % 2
        data = self.make_data(dice, kind)
        try:
            self.upload(kind, data)
        except (rc.Refused, OSError, ValueError) as error:
            self.fail(GOOD, f"{NAMES[kind]}: {error}")
            return
        old = self.path(IMAGE).with_suffix(".OLD")
        if self.path(kind).read_bytes() != data:
            self.fail(GOOD, f"{NAMES[kind]} is another file")
        if kind == IMAGE and old.read_bytes() != self.kept:
            self.fail(KEPT, "after a good upload it is another file")

    def play(self, number):
        self.round = number
        dice = random.Random(f"{self.seed}/{number}")
        children = []
        for i in range(dice.choice([1, 1, 2, 3])):
            kind = dice.choice(list(NAMES))
            children.append(Child(self.run, dice, i, kind, self.make_data(dice, kind)))
        try:
            self.kill_all(children)
            self.wait_for_ends(children)
        finally:
            for child in children:
                if not child.has_ended():
                    os.kill(child.pid, signal.SIGKILL)
        self.look(children)
        for kind in NAMES:
            self.compare(kind, children)
        rest = self.other_files()
        if rest != self.rest:
            changed = sorted(dict(rest.items() ^ self.rest.items()))
            self.fail(REST, f"{', '.join(changed)} after {', '.join(child.what for child in children)}")
        self.follow_up(dice)


def play_all(run, numbers, seed):
    """Plays the rounds and prints figures; returns the Rounds, with their failures."""
    rounds = Rounds(run, seed)
    begin = time.monotonic()
    try:
        for number in numbers:
            rounds.play(number)
            if number % 100 == 0:
                print(f"{number} rounds", flush=True)
    except (rc.Refused, OSError, ValueError) as error:
        rounds.fail(OTHERS, str(error))
    counts = ", ".join(f"{count} {what}" for what, count in sorted(rounds.counts.items()))
    print(f"figures: {len(numbers)} rounds in {time.monotonic() - begin:.0f} s: {counts}; the last "
          f"connection of a round ended after {rounds.slowest_end} frames at most", flush=True)
    return rounds


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=40)
    parser.add_argument("--round", type=int, help="only the round of this number")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="new folder for stick, recording and console")
    flags = parser.parse_args()
    numbers = range(1, flags.rounds + 1) if flags.round is None else [flags.round]
    with tempfile.TemporaryDirectory(prefix="openr-kill-") as scratch:
        folder = flags.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        run = rc.Run(flags.build.resolve() / "bin/openr", folder, "--rate", RATE, "--no-payloads")
        try:
            rounds = play_all(run, numbers, flags.seed)
            for name in PROPERTIES:
                verdict(name, not rounds.wrong[name], "\n".join(rounds.wrong[name][:20]))
            if flags.round is None:
                for what in ("killed", "new files", "old files", "rounds with a temporary file"):
                    verdict(f"{what}: at least one", rounds.counts[what] > 0)
            run.check_end()
        finally:
            run.kill()
    if any(rounds.wrong.values()):
        print(f"see a round again: {sys.argv[0]} --build {flags.build} --seed {flags.seed} --round NUMBER")
    print(f"seed {flags.seed}")
    return finish()


if __name__ == "__main__":
    sys.exit(main())
