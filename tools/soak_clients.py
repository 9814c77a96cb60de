"""Clients of the remote control that come and go, for soak.py.

A client is a generator: it sends, yields while the run goes on for a step, and receives.
"""
import collections
import random
import select
import socket
import struct
import subprocess

import remote_load as load
import remote_run as rc

ANSWER_STEPS = 50  # an answer that has not come after so many steps is missing
# Motions of the stick, and the largest number of loops.  Only WALK.MTN ends where it begins; the
# others jump at the end of a loop, which is a finding.
MOTIONS = {"BOW.MTN": 1, "LIE.MTN": 1, "SIT.MTN": 1, "STAND.MTN": 1, "WALK.MTN": 5}
# JointMover begins a motion at once if no joint is 45 degrees or more from its first key frame, and
# otherwise moves the joints there before (MoverCore.h).  A set point that jumps by more than 30 degrees
# is a finding.  So a motion begins without a finding if all joints are nearer than NEAR_DEG, or if a
# joint of a leg, which only motions and their players move, is further away than FAR_DEG.
NEAR_DEG, FAR_DEG = 28, 47
HEAD, LEGS = range(3), range(4, 16)  # numbers of joints, in the order of the columns of a motion
# The robot must be ready for a motion in GOOD_LOOKS looks, one in each step, because a person may turn a
# joint for two steps (INPUTS in soak.py), and the set point of this joint is elsewhere then.  The legs
# must also be still: a motion that was stopped goes on for up to two vectors (256 ms), and joints that
# MOVE has sent somewhere may come nearer than FAR_DEG before the motion begins.
GOOD_LOOKS, LOOKS_MAX = 4, 100
STILL_DEG = 0.5  # a joint that has moved less since the look before is still
UPLOADED = tuple(f"SOAK{i}.MTN" for i in range(10))
BUSY_TOO = (rc.STATUS_OK, rc.STATUS_BUSY)


def first_angles(openr, motion):
    """Returns {joint: angle in degrees} of the first key frame of a motion file."""
    lines = subprocess.run([openr, "mtn", "dump", motion], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    angles = lines[1].split(",")[-len([*HEAD, *LEGS]):]
    return dict(zip([*HEAD, *LEGS], map(float, angles), strict=True))


def legs_are_still(degrees, before):
    """Returns whether no joint of a leg has moved between two looks; `before` may be None."""
    return before is not None and all(abs(degrees[joint] - before[joint]) < STILL_DEG for joint in LEGS)


def far_joints(degrees, first):
    """Returns the joints that keep a motion from beginning without a finding.

    `degrees`: the angles of all joints.  `first`: first_angles() of the motion.
    """
    ways = {joint: abs(degrees[joint] - angle) for joint, angle in first.items()}
    if any(ways[joint] > FAR_DEG for joint in LEGS):
        return []
    return [joint for joint, way in ways.items() if way >= NEAR_DEG]


class Clients:
    """The clients that are connected to a run, and the failures of all."""

    def __init__(self, run, seed):
        self.run, self.seed = run, seed
        self.guests = []  # the generators
        self.number = 0  # clients so far
        self.boots = 0
        self.uploads_image = False  # whether a client uploads CONTROLL.BIN
        self.uploading = set()  # the names of UPLOADED that clients use now
        self.is_off = False  # from the answer to REBOOT until the robot takes connections again
        self.counts = collections.Counter()
        self.wrong = []
        self.time_s = run.clock(pause=True)["time_s"]
        self.motion = (run.stick / rc.FOLDERS[rc.MOTION] / "STAND.MTN").read_bytes()
        self.first = {name: first_angles(run.openr, run.stick / rc.FOLDERS[rc.MOTION] / name)
                      for name in MOTIONS}
        self.is_beginning = False  # whether a client lets the robot get ready for a motion
        self.image = (run.stick / rc.FOLDERS[rc.IMAGE] / "CONTROLL.BIN").read_bytes()

    def welcome(self, kind):
        """Adds a client; `kind` is one of the methods that KINDS names."""
        self.number += 1
        self.counts[f"clients: {kind.__name__}"] += 1
        dice = random.Random(f"{self.seed}/{self.number}")
        self.guests.append(self.visit(kind, dice, f"{kind.__name__} {self.number}", self.boots))

    def visit(self, kind, dice, name, boots):
        """Lets a client of this kind act until it leaves, and keeps its failures.

        `boots`: the number of reboots when it came, because a reboot closes all connections.
        """
        client = None
        try:
            client = load.LoadClient(self.run.port, dice, may_be_busy=True, angles=load.NEAR_ANGLES)
            yield from kind(client, dice)
        except OSError as error:
            if self.boots == boots:
                self.fail(f"{name}: {error!r}")
            self.counts["connections that a reboot closed"] += 1
        except (rc.Refused, ValueError, AssertionError) as error:
            self.fail(f"{name}: {error!r}")
        finally:
            if client is not None:
                client.close()

    def fail(self, text):
        self.wrong.append(f"t={self.time_s:.3f} s: {text}")

    def receive(self, client):
        """Returns the answers that have come; acknowledges events."""
        answers = client.take(wait=False)
        if client.is_closed:
            raise ConnectionError("the robot closed the connection")
        found = [answer for answer in answers if answer.command != rc.EVENT]
        if len(found) < len(answers):
            self.counts["events"] += len(answers) - len(found)
            client.send(rc.packet(rc.EVENT))
        return found

    def ask(self, client, *requests, statuses=BUSY_TOO):
        """Sends requests and waits for their answers, which it returns."""
        asked = client.send_requests(requests)
        answers = []
        for _ in range(ANSWER_STEPS):
            yield
            answers += self.receive(client)
            if len(answers) >= len(asked):
                break
        client.check_answers(answers, asked, statuses)
        self.counts["answers"] += len(answers)
        return answers

    # ---- Kinds of clients

    def commander(self, client, dice):
        """Sends commands of all kinds, then leaves in one of three ways."""
        steps = dice.randint(1, 40)
        leaves = dice.choice(["after the last answer", "at once", "by half-close"])
        for step in range(steps):
            client.send_commands(step, step == steps - 1)
            if step == steps - 1 and leaves == "at once":
                return
            if step == steps - 1 and leaves == "by half-close":
                client.socket.shutdown(socket.SHUT_WR)
            yield
            client.receive(step)
            if client.is_closed and step < steps - 1:
                raise ConnectionError("the robot closed the connection")
        self.counts["answers"] += client.answered
        self.counts["events"] += client.events
        if client.expected and client.is_closed:
            raise ConnectionError("the robot closed the connection before the last answer")
        if client.wrong or client.expected or client.late:
            raise ValueError(f"{client.wrong[:1]}, {client.late} late, {len(client.expected)} missing")

    def get_ready(self, client, first):
        """Waits until a motion begins without a finding, and moves joints that are far from `first`.

        Returns False if the robot does not get ready, for example because it plays a longer motion.
        """
        good_looks, before = 0, None
        for _ in range(LOOKS_MAX):
            look, = yield from self.ask(client, (rc.SENSORS, b""), statuses=(rc.STATUS_OK,))
            degrees = [value / 100 for value in struct.unpack_from("<18i", look.payload, 8)]
            far = far_joints(degrees, first)
            is_standing = look.payload[5] == rc.READY and legs_are_still(degrees, before)
            before = degrees
            good_looks = good_looks + 1 if is_standing and not far else 0
            if good_looks == GOOD_LOOKS:
                return True
            if is_standing and far:
                yield from self.ask(client, *((rc.MOVE, struct.pack("<Bi", joint, round(100 * first[joint])))
                                              for joint in far))
        self.counts["motions given up"] += 1
        return False

    def play(self, client, name, like, loops=1, key_frames=0):
        """Plays a motion whose first key frame is that of `like`; one client at a time begins one."""
        while self.is_beginning:
            yield
        self.is_beginning = True
        try:
            if (yield from self.get_ready(client, self.first[like])):
                request = struct.pack(f"<{len(name) + 1}pHB", name.encode(), loops, key_frames)
                play, = yield from self.ask(client, (rc.MTN_PLAY, request))
                self.counts["motions"] += play.status == rc.STATUS_OK
        finally:
            self.is_beginning = False

    def player(self, client, dice):
        """Plays motions, with events of their key frames."""
        yield from self.ask(client, (rc.SUBSCRIBE, struct.pack("<BH", 1, 0)))
        for _ in range(dice.randint(1, 3)):
            name, loops_max = dice.choice(list(MOTIONS.items()))
            yield from self.play(client, name, name, dice.randint(1, loops_max), dice.choice([0, 4]))
            for _ in range(dice.randint(1, 100)):
                look, = yield from self.ask(client, (rc.SENSORS, b""))
                if look.payload[5] == rc.READY:
                    break
            yield from self.ask(client, (rc.MTN_STOP, b""), (rc.LOG, struct.pack("<I", 0xFFFFFFFF)))

    def upload(self, client, kind, name, data):
        """Uploads a file, and compares what is then on the stick."""
        packets = rc.upload_packets(kind, name, data)
        for at in range(0, len(packets), 30):
            yield from self.ask(client, *packets[at:at + 30], statuses=(rc.STATUS_OK,))
        self.counts["uploads"] += 1
        if (self.run.stick / rc.FOLDERS[kind] / name).read_bytes() != data:
            raise ValueError(f"{name} on the stick is another file")

    def motion_uploader(self, client, dice):
        """Uploads a motion under a name that no other client uses now, plays it, and perhaps deletes it again.

        Two uploads of one name would replace each other.
        """
        at = self.number % len(UPLOADED)
        # A name is always free, because there are fewer clients than names.
        name = next(each for each in UPLOADED[at:] + UPLOADED[:at] if each not in self.uploading)
        self.uploading.add(name)
        try:
            yield from self.upload_and_play(client, dice, name)
        finally:
            self.uploading.discard(name)

    def upload_and_play(self, client, dice, name):
        data = self.motion + dice.randbytes(dice.randint(1, 50000))
        yield from self.upload(client, rc.MOTION, name, data)
        text = struct.pack(f"<{len(name) + 1}p", name.encode())
        part, = yield from self.ask(client, (rc.DOWNLOAD, b"\0" + text + struct.pack("<I", 0)))
        if part.payload != struct.pack("<I", len(data)) + data[:len(part.payload) - 4]:
            raise ValueError(f"{name} is downloaded as another file")
        yield from self.ask(client, (rc.MTN_LIST, b"\0\0"))
        yield from self.play(client, name, "STAND.MTN")
        if dice.random() < 0.5:
            yield from self.ask(client, (rc.DELETE, b"\0" + text))

    def controller_uploader(self, client, dice):
        """Uploads the controller, with other bytes behind its end, and perhaps reboots the robot."""
        if self.uploads_image:
            return
        self.uploads_image = True
        try:
            data = self.image + dice.randbytes(dice.randint(1, 20000))
            yield from self.upload(client, rc.IMAGE, "CONTROLL.BIN", data)
        finally:
            self.uploads_image = False
        if dice.random() < 0.5 and not self.is_off:
            yield from self.ask(client, (rc.REBOOT, b""))
            self.boots += 1
            self.is_off = True
            for _ in range(ANSWER_STEPS):
                yield
                self.receive(client)
            raise ValueError("REBOOT does not close the connection")

    def photographer(self, client, dice):
        """Takes a picture of layer L."""
        answer, = yield from self.ask(client, (rc.CAMERA, b"\2"))
        if answer.status == rc.STATUS_BUSY:
            return
        for _ in range(ANSWER_STEPS):
            first, = yield from self.ask(client, (rc.CAMERA_PART, b"\0\0"))
            if first.status == rc.STATUS_OK:
                break
        count = struct.unpack_from("<H", first.payload, 2)[0]
        yield from self.ask(client, *((rc.CAMERA_PART, struct.pack("<H", i)) for i in range(count)),
                            statuses=(rc.STATUS_OK,))
        self.counts["pictures"] += 1

    def rude(self, client, dice):
        """Sends garbage, of which the robot says so and closes the connection; or part of a packet."""
        data = dice.choice([b"no packet", b"RC\xff\xff\2\1\0\0", b"RC\4\0\2\1\0\0" * 3, b"RC\x10", b""])
        client.send(data)
        if len(data) < rc.REQUEST.size:
            if dice.random() < 0.5:
                yield
            return
        answers = []
        for _ in range(ANSWER_STEPS):
            yield
            if not client.is_closed:
                answers += client.take(wait=False)
        if [answer.status for answer in answers] != [rc.STATUS_BAD_PACKET] or not client.is_closed:
            raise ValueError(f"garbage is answered by {answers}")

    def reads_nothing(self, client, dice):
        """Sends requests without reading answers, until the robot reads no more of them.

        Then another client must get its answers, and afterwards this one all of its own.
        """
        client.socket.setblocking(False)
        request = rc.packet(rc.SENSORS)
        sent = quiet_steps = 0
        while quiet_steps < 5:
            before = sent
            try:
                while select.select([], [client.socket], [], 0)[1] and sent - before < 1 << 18:
                    piece = request * 2048
                    sent += client.socket.send(piece[sent % len(request):])
            except BlockingIOError:
                pass
            quiet_steps = 0 if sent > before else quiet_steps + 1
            yield
        self.counts["bytes sent by clients that read nothing"] += sent
        other = rc.Client(self.run.port)
        try:
            for _ in range(5):
                yield from self.ask(other, (rc.GET, b"\1"), (rc.SENSORS, b""), (rc.POWER, b""),
                                    statuses=(rc.STATUS_OK,))
                self.counts["answers beside a client that reads nothing"] += 3
        finally:
            other.close()
        if dice.random() < 0.5:
            return
        answers = 0
        for _ in range(40 * ANSWER_STEPS):
            while select.select([client.socket], [], [], 0)[0]:
                for answer in self.receive(client):
                    if answer.command != rc.SENSORS or answer.status != rc.STATUS_OK:
                        raise ValueError(f"{answer} answers SENSORS")
                    answers += 1
            if answers == sent // len(request):
                return
            yield
        raise ValueError(f"{answers} answers to {sent // len(request)} requests, read late")

    def asker(self, client, dice):
        """Connects, asks one question and leaves."""
        yield from self.ask(client, (rc.INFO, b""), statuses=(rc.STATUS_OK,))

    KINDS = {"commander": 60, "player": 12, "motion_uploader": 8, "asker": 8, "rude": 6,
             "photographer": 4, "controller_uploader": 1.5, "reads_nothing": 0.5}  # percent
