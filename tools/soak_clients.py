"""Clients of the remote control that come and go, for soak.py.

A client is a generator: it sends, yields while the run goes on for a step, and receives.
"""
import collections
import random
import select
import socket
import struct

import remote_load as load
import remote_run as rc

ANSWER_STEPS = 50  # an answer that has not come after so many steps is missing
# Motions of the stick, and the largest number of loops.  Only WALK.MTN ends where it begins; the
# others jump at the end of a loop, which is a finding.
MOTIONS = {"BOW.MTN": 1, "LIE.MTN": 1, "SIT.MTN": 1, "STAND.MTN": 1, "WALK.MTN": 5}
UPLOADED = tuple(f"SOAK{i}.MTN" for i in range(10))
BUSY_TOO = (rc.STATUS_OK, rc.STATUS_BUSY)


class Clients:
    """The clients that are connected to a run, and the failures of all."""

    def __init__(self, run, seed):
        self.run, self.seed = run, seed
        self.guests = []  # the generators
        self.number = 0  # of clients so far
        self.boots = 0
        self.uploads_image = False  # whether a client uploads CONTROLL.BIN
        self.is_off = False  # from the answer to REBOOT until the robot takes connections again
        self.counts = collections.Counter()
        self.wrong = []
        self.time_s = run.clock(pause=True)["time_s"]
        self.motion = (run.stick / rc.FOLDERS[rc.MOTION] / "STAND.MTN").read_bytes()
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
            client = load.LoadClient(self.run.port, dice, may_be_busy=True)
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

    def player(self, client, dice):
        """Plays motions, with events of their key frames."""
        yield from self.ask(client, (rc.SUBSCRIBE, struct.pack("<BH", 1, 0)))
        for _ in range(dice.randint(1, 3)):
            name, loops_max = dice.choice(list(MOTIONS.items()))
            request = struct.pack(f"<{len(name) + 1}pHB", name.encode(), dice.randint(1, loops_max),
                                  dice.choice([0, 4]))
            play, = yield from self.ask(client, (rc.MTN_PLAY, request))
            if play.status == rc.STATUS_OK:
                self.counts["motions"] += 1
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
        """Uploads a motion, plays it, and perhaps deletes it again.

        Each name belongs to one client at a time, because two uploads of one name replace each other.
        """
        name = UPLOADED[self.number % len(UPLOADED)]
        data = self.motion + dice.randbytes(dice.randint(1, 50000))
        yield from self.upload(client, rc.MOTION, name, data)
        text = struct.pack(f"<{len(name) + 1}p", name.encode())
        part, = yield from self.ask(client, (rc.DOWNLOAD, b"\0" + text + struct.pack("<I", 0)))
        if part.payload != struct.pack("<I", len(data)) + data[:len(part.payload) - 4]:
            raise ValueError(f"{name} is downloaded as another file")
        yield from self.ask(client, (rc.MTN_LIST, b"\0\0"), (rc.MTN_PLAY, text + b"\1\0\0"))
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
