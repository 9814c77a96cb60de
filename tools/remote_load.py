#!/usr/bin/env python3
"""Lets eight clients of the remote control send 100 commands per second of virtual time each.

    remote_load.py --build build/release [--seconds 600] [--seed 1] [--fastest] [--keep FOLDER]

The run goes on in steps of 5 frames (40 ms of virtual time).  Before each step every client sends 4
commands, so the load does not depend on how fast the machine is.  Each command must get its answer,
in order and within the step.  All clients have subscribed to events meanwhile, and a ninth client
is turned away.  At the end the memory of the run is compared, and its recording is replayed.  The
last line is "N passed, N failed".

With --fastest the run goes on in real time, and each client sends without a pause for --seconds of
virtual time: it has UNDER_WAY commands under way, and sends the next as soon as an answer comes.
Each command must get its answer, in order; the answer may be BUSY, because JointMover takes only so
many commands at a time.  How fast the run and the clients are depends on the machine and is only
printed.

A failed check can be seen again with the same seed; --keep leaves the recording in FOLDER.
"""
import argparse
import collections
import pathlib
import random
import select
import struct
import sys
import tempfile
import time

import remote_run as rc

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import finish, verdict  # noqa: E402: the folder is put into the path first

CLIENTS = 8
STEP_FRAMES, STEP_COMMANDS = 5, 4
STEPS_PER_SECOND = 25
IDLE_SECONDS = 10  # the robot answers a silent ninth client after this time
WARM_UP_STEPS = 5 * STEPS_PER_SECOND
# Clients at their fastest: commands that each has under way, and turns after which the clock of the
# run is looked at.  The robot answers in its frames, so a client with one command under way would wait
# most of the time.
UNDER_WAY, LOOK_TURNS = 50, 20
# The memory of a run does not depend on the number of commands: with 480,000 commands in 600 s it
# grew by 72 and 88 KiB.  A leak of 16 bytes a command, the smallest answer, would be 7500 KiB.
GROWTH_KB = 1024

Expected = collections.namedtuple("Expected", "version command tag status size step")
Stream = collections.namedtuple("Stream", "tag size")
# Size of the payload of an answer to SENSORS, for the ERS-210: 8 bytes of counts, and
# 18 + 6 + 7 + 2 + 1 values of 4 bytes.
SENSORS_SIZE = 8 + 4 * 34
# Smallest payload of an event of each stream.  Stream 0: sensor values.  Stream 1: set values, with
# a name of 0 bytes.
STREAM_SIZES = {0: 4 + SENSORS_SIZE, 1: 4 + 8 + 4 + 1 + 2 * 4 * 18}
# Joints of head, mouth and tail: smallest and largest angle that the load commands, in degrees.
ANGLES = {0: (-70, 40), 1: (-80, 80), 2: (-25, 25), 3: (-40, -5), 16: (-20, 20), 17: (-20, 20)}
# The angles while motions may begin: the head stays so near to the first key frame of each motion of
# the stick (0 or -25 degrees of joint 0, 0 of the others) that its set points do not jump there.
NEAR_ANGLES = {**ANGLES, 0: (-25, 0), 1: (-25, 25)}


class LoadClient(rc.Client):
    """A client of the load: sends random commands, and compares each answer with its command."""

    def __init__(self, port, dice, may_be_busy=False, angles=ANGLES):
        """may_be_busy: the robot may answer BUSY, for example because it plays a motion.

        angles: the smallest and the largest angle of each joint that moves.
        """
        super().__init__(port)
        self.dice = dice
        self.may_be_busy = may_be_busy
        self.angles = angles
        self.expected = collections.deque()
        self.held = b""  # last bytes of a packet, sent in the next step
        self.streams = {}  # the subscriptions for which answers have come
        self.asked_streams = collections.deque()
        self.answered = self.busy = self.events = self.late = 0
        self.wrong = []

    def send(self, data):
        try:
            super().send(data)
        except OSError:  # the robot has closed the connection: check() counts that as a failure
            self.is_closed = True

    # ---- Commands: each returns version, command, payload, status and size of the answer's payload.

    def move(self):
        joint, (low, high) = self.dice.choice(list(self.angles.items()))
        value = self.dice.randint(100 * low, 100 * high)
        return 1, rc.MOVE, struct.pack("<Bi", joint, value), rc.STATUS_OK, 4

    def speed(self):
        joint = self.dice.choice(list(ANGLES))
        return 1, rc.SPEED, struct.pack("<Bi", joint, self.dice.randint(3000, 20000)), rc.STATUS_OK, 4

    def get(self):
        return self.dice.choice([1, 2]), rc.GET, bytes([self.dice.randrange(18)]), rc.STATUS_OK, 12

    def sensors(self):
        return 1, rc.SENSORS, b"", rc.STATUS_OK, SENSORS_SIZE

    def led(self):
        return 1, rc.LED, bytes([self.dice.randrange(9), self.dice.randrange(2)]), rc.STATUS_OK, 1

    def power(self):
        return 2, rc.POWER, b"", rc.STATUS_OK, 20

    def batch(self):
        parts = [self.dice.choice([self.move, self.speed, self.get, self.led])()
                 for _ in range(self.dice.randint(1, 8))]
        payload = b"".join(rc.packet(command, data, i, version)
                           for i, (version, command, data, _, _) in enumerate(parts))
        return 2, rc.BATCH, payload, rc.STATUS_OK, sum(rc.ANSWER.size + part[4] for part in parts)

    def subscribe(self):
        stream = self.dice.randrange(2)
        self.asked_streams.append(stream)
        period = 4 * self.dice.randint(1, 10)
        return 2, rc.SUBSCRIBE, struct.pack("<BH", stream, period), rc.STATUS_OK, 2

    def unsubscribe(self):
        stream = self.dice.randrange(2)
        self.asked_streams.append(stream)
        return 2, rc.UNSUBSCRIBE, bytes([stream]), rc.STATUS_OK, 0

    def refused(self):
        """Returns a command that the robot refuses; the size of the answer is not checked."""
        return self.dice.choice([(1, rc.GET, b"\x63", rc.STATUS_NO_SUCH_DEVICE, None),
                                 (2, rc.MOVE, b"\x01", rc.STATUS_MALFORMED, None),
                                 (1, rc.POWER, b"", rc.STATUS_UNKNOWN_COMMAND, None)])

    KINDS = {"move": 30, "speed": 10, "get": 20, "sensors": 10, "led": 10, "power": 5, "batch": 8,
             "subscribe": 3, "unsubscribe": 1, "refused": 3}  # percent of the commands

    def send_commands(self, step, is_last, count=STEP_COMMANDS):
        """Sends the commands of a step; now and then keeps the last bytes for the next step."""
        data = self.held
        for kind in self.dice.choices(list(self.KINDS), self.KINDS.values(), k=count):
            version, command, payload, status, size = getattr(self, kind)()
            tag = next(self.tags) % 0x10000
            data += rc.packet(command, payload, tag, version)
            self.expected.append(Expected(version, command, tag, status, size, step))
        cut = len(data)
        if not is_last and self.dice.random() < 0.1:
            cut -= self.dice.randint(1, 7)  # fewer bytes than the smallest packet has
            self.expected[-1] = self.expected[-1]._replace(step=step + 1)
        self.held = data[cut:]
        self.send(data[:cut])

    # ---- Answers

    def receive(self, step):
        """Compares the answers received in a step with their commands; acknowledges events."""
        if self.is_closed:
            return
        acknowledges = False
        for answer in self.take(wait=False):
            if answer.command == rc.EVENT:
                acknowledges = True
                self.compare_event(answer)
            else:
                self.compare(answer, step)
        if acknowledges and not self.held:
            self.send(rc.packet(rc.EVENT))

    def compare(self, answer, step):
        if not self.expected:
            self.wrong.append(f"{answer} answers nothing")
            return
        asked = self.expected.popleft()
        self.answered += 1
        self.late += step > asked.step
        is_good = answer[:3] == asked[:3] and (
            answer.status == asked.status or self.is_busy(answer.status))
        has_size = asked.size is not None and not (
            self.may_be_busy and (answer.command == rc.BATCH or answer.status == rc.STATUS_BUSY))
        if is_good and has_size:
            is_good = len(answer.payload) == asked.size
        self.busy += answer.status == rc.STATUS_BUSY
        if is_good and answer.command == rc.BATCH:
            is_good = self.is_good_batch(answer.payload)
        if not is_good:
            self.wrong.append(f"{answer} answers {asked}")
        if answer.command in (rc.SUBSCRIBE, rc.UNSUBSCRIBE) and is_good:
            stream = self.asked_streams.popleft()
            self.streams.pop(stream, None)
            if answer.command == rc.SUBSCRIBE:
                self.streams[stream] = Stream(answer.tag, STREAM_SIZES[stream])

    def is_busy(self, status):
        return self.may_be_busy and status == rc.STATUS_BUSY

    def is_good_batch(self, payload):
        """Returns whether all parts are answers with good status and tags 0, 1, 2 and so on."""
        at = number = 0
        while at < len(payload):
            _, size, _, _, tag, _, status, _ = rc.ANSWER.unpack_from(payload, at)
            if tag != number or not (status == rc.STATUS_OK or self.is_busy(status)):
                return False
            at += size
            number += 1
        return True

    def compare_event(self, event):
        self.events += 1
        stream = self.streams.get(event.payload[0]) if event.payload else None
        if stream is None or event.tag != stream.tag or event.status != rc.STATUS_OK \
                or len(event.payload) < stream.size:
            self.wrong.append(f"{event} belongs to none of {self.streams}")


class NinthClient:
    """A client that connects while all 8 places are taken; it sends a request or nothing."""

    def __init__(self, port, asks):
        self.asks = asks
        self.client = rc.Client(port)
        self.answers = []
        self.steps = 0
        if asks:
            self.client.send(rc.packet(rc.INFO, tag=4711))

    def receive(self):
        if not self.client.is_closed:
            self.answers += self.client.take(wait=False)
            self.steps += 1

    def find_problem(self):
        """Returns how the answers differ from docs/remote-control.md, or "" if they do not."""
        head = (2, rc.INFO, 4711) if self.asks else (1, 0, 0)
        if len(self.answers) != 1 or not self.client.is_closed:
            return f"got {self.answers}, {'closed' if self.client.is_closed else 'not closed'}"
        answer = self.answers[0]
        if answer[:3] != head or answer.status != rc.STATUS_BUSY \
                or "all 8 places are taken" not in rc.error_text(answer):
            return str(answer)
        if not self.asks and self.steps < IDLE_SECONDS * STEPS_PER_SECOND:
            return f"was told unasked after {self.steps} steps"
        return ""


def load_step(run, clients, step, is_last, time_s):
    """Sends the commands of a step, lets the run go on and receives; returns the virtual time."""
    for client in clients:
        client.send_commands(step, is_last)
    time_s = run.step(STEP_FRAMES, time_s)
    for client in clients:
        client.receive(step)
    return time_s


def load(run, clients, steps):
    """Sends the commands of all steps, and receives the answers.

    Returns the memory of the run after the warm-up, the virtual time passed, and the ninth clients.
    """
    ninths = []
    memory_kb = 0
    begin_s = time_s = run.clock(pause=True)["time_s"]
    for step in range(steps):
        if step == WARM_UP_STEPS:
            memory_kb = run.memory_kb()
        if step in (steps // 8, steps // 4):
            ninths.append(NinthClient(run.port, asks=step == steps // 8))
        time_s = load_step(run, clients, step, step == steps - 1, time_s)
        for ninth in ninths:
            ninth.receive()
    return memory_kb, time_s - begin_s, ninths


def load_fastest(run, clients, seconds):
    """Lets each client keep UNDER_WAY commands under way, until so much virtual time is over.

    Returns the memory of the run after the warm-up, and the state of its clock at the end.
    """
    clock = run.clock()
    begin_s, warm_up_s = clock["time_s"], WARM_UP_STEPS / STEPS_PER_SECOND
    memory_kb = 0
    while clock["time_s"] < begin_s + seconds and not all(client.is_closed for client in clients):
        if not memory_kb and clock["time_s"] >= begin_s + warm_up_s:
            memory_kb = run.memory_kb()
        for _ in range(LOOK_TURNS):
            send_next(clients)
            receive_some(clients)
        clock = run.clock()
    end = time.monotonic() + rc.HANG_S
    while any(client.expected and not client.is_closed for client in clients) and time.monotonic() < end:
        receive_some(clients)
    return memory_kb, clock


def receive_some(clients):
    """Waits until a client has received something, for at most a second; compares what has come."""
    sockets = {client.socket: client for client in clients if not client.is_closed}
    for ready in select.select(list(sockets), [], [], 1 if sockets else 0)[0]:
        sockets[ready].receive(0)


def send_next(clients):
    """Lets each client send so many commands that UNDER_WAY are under way."""
    for client in clients:
        count = UNDER_WAY - len(client.expected)
        if count > 0 and not client.is_closed:
            client.send_commands(0, True, count)


def check_fastest(run, seconds, seed):
    clients = [LoadClient(run.port, random.Random(f"{seed}/{i}"), may_be_busy=True) for i in range(CLIENTS)]
    run.wait_until_standing(clients[0])
    begin = time.monotonic()
    begin_kb, clock = load_fastest(run, clients, seconds)
    wall_s = time.monotonic() - begin
    growth_kb = run.memory_kb() - begin_kb
    tell_fastest(clients)
    verdict(f"the memory grows by at most {GROWTH_KB} KiB", growth_kb <= GROWTH_KB,
            f"it grew by {growth_kb} KiB")
    answered, busy, events = (sum(getattr(client, name) for client in clients)
                              for name in ("answered", "busy", "events"))
    print(f"figures: {CLIENTS} clients at their fastest, {answered} commands, {busy} of them answered by "
          f"BUSY, and {events} events in {seconds} s of virtual time and "
          f"{wall_s:.1f} s; {clock['speed']:.2f} x real time at the end; memory {begin_kb} KiB after "
          f"{WARM_UP_STEPS // STEPS_PER_SECOND} s, {growth_kb:+} KiB at the end", flush=True)


def tell_fastest(clients):
    """Prints the verdicts about the answers that the clients at their fastest have got."""
    for number, client in enumerate(clients):
        verdict(f"client {number}: each of its commands is answered",
                client.answered > client.busy and not client.expected,
                f"{client.answered} answers, {client.busy} of them BUSY, {len(client.expected)} are missing")
        verdict(f"client {number}: answers as asked and in order, events as subscribed", not client.wrong,
                f"{len(client.wrong)} are wrong, the first: {' '.join(client.wrong[:1])}")
        verdict(f"client {number}: is not closed", not client.is_closed)


def check(run, seconds, seed):
    clients = [LoadClient(run.port, random.Random(f"{seed}/{i}")) for i in range(CLIENTS)]
    for client in clients:
        run.wait_until_standing(client)
    steps = seconds * STEPS_PER_SECOND
    begin = time.monotonic()
    begin_kb, virtual_s, ninths = load(run, clients, steps)
    wall_s = time.monotonic() - begin
    growth_kb = run.memory_kb() - begin_kb
    count = steps * STEP_COMMANDS
    for number, client in enumerate(clients):
        verdict(f"client {number}: {client.answered} answers to {count} commands",
                client.answered == count and not client.expected)
        verdict(f"client {number}: answers as asked and events as subscribed", not client.wrong,
                f"{len(client.wrong)} are wrong, the first: {' '.join(client.wrong[:1])}")
        verdict(f"client {number}: answers within their step", client.late == 0,
                f"{client.late} came later")
        verdict(f"client {number}: is not closed", not client.is_closed)
        verdict(f"client {number}: gets events", client.events > 0)
    verdict(f"the load lasts {seconds} s of virtual time", abs(virtual_s - seconds) < 0.001,
            f"it lasted {virtual_s:.3f} s")
    for ninth in ninths:
        name = "that asks" if ninth.asks else "that is silent"
        verdict(f"a ninth client {name} is turned away", not ninth.find_problem(), ninth.find_problem())
    verdict(f"the memory grows by at most {GROWTH_KB} KiB", growth_kb <= GROWTH_KB,
            f"it grew by {growth_kb} KiB")
    events = sum(client.events for client in clients)
    print(f"figures: {CLIENTS} clients, {CLIENTS * count} commands and {events} events in "
          f"{virtual_s:.0f} s of virtual time and {wall_s:.0f} s; memory {begin_kb} KiB after "
          f"{WARM_UP_STEPS // STEPS_PER_SECOND} s, {growth_kb:+} KiB at the end", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=20, help="of virtual time, at least 16")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fastest", action="store_true",
                        help="in real time, without a pause between the commands")
    parser.add_argument("--keep", type=pathlib.Path, help="new folder for stick, recording and report")
    flags = parser.parse_args()
    if flags.seconds < 16:
        parser.error("--seconds is at least 16: a silent ninth client needs 10 s")
    with tempfile.TemporaryDirectory(prefix="openr-load-") as scratch:
        folder = flags.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        run = rc.Run(flags.build.resolve() / "bin/openr", folder, "--rate", "1" if flags.fastest else "max")
        try:
            try:
                (check_fastest if flags.fastest else check)(run, flags.seconds, flags.seed)
                run.clock(pause=False)
            except (rc.Refused, OSError, ValueError) as error:
                verdict("the run and its clients go on to the end", False, repr(error))
            run.check_end(f", seed {flags.seed}")
        finally:
            run.kill()
    return finish()


if __name__ == "__main__":
    sys.exit(main())
