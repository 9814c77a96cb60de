"""A recorded run and a client of its remote control, for the scripts that check it.

The protocol is docs/remote-control.md.  The limits in seconds only end a check whose run hangs; no
other result depends on them.
"""
import collections
import itertools
import json
import os
import pathlib
import re
import select
import signal
import socket
import struct
import subprocess
import sys
import time
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import verdict  # noqa: E402: the folder is put into the path first

INFO, DESCRIBE, BATCH, GET, MOVE, SPEED, LED = 0x01, 0x02, 0x03, 0x10, 0x11, 0x12, 0x20
SENSORS, POWER, SUBSCRIBE, UNSUBSCRIBE, CAMERA, CAMERA_PART, EVENT = *range(0x30, 0x36), 0x3F
MTN_PLAY, MTN_STOP, MTN_LIST = 0x40, 0x41, 0x42
UPLOAD_BEGIN, UPLOAD_DATA, UPLOAD_END, DELETE, DOWNLOAD = range(0x50, 0x55)
LOG, REBOOT = 0x60, 0x70
STATUS_OK, STATUS_BAD_PACKET, STATUS_UNKNOWN_COMMAND, STATUS_MALFORMED = 0, 1, 3, 5
STATUS_NO_SUCH_DEVICE, STATUS_BUSY = 6, 7
MOTION, IMAGE = 0, 1  # kinds of files
FOLDERS = {MOTION: "OPEN-R/MW/DATA/P", IMAGE: "OPEN-R/MW/OBJS"}
DATA_SIZE = 1012  # the most data of one UPLOAD_DATA
READY = 6  # state of JointMover in which the robot stands and plays nothing
HANG_S = 300
REQUEST = struct.Struct("<2sHBBH")
ANSWER = struct.Struct("<2sHBBHIHH")
ADDRESS = re.compile(r"openr rc 127\.0\.0\.1:(\d+) info")

Answer = collections.namedtuple("Answer", "version command tag frame status payload")


def packet(command, payload=b"", tag=0, version=2):
    """Returns the bytes of a request."""
    return REQUEST.pack(b"RC", REQUEST.size + len(payload), version, command, tag) + payload


def upload_packets(kind, name, data):
    """Returns the requests of an upload, in order."""
    name = name.encode()
    begin = struct.pack(f"<B{len(name) + 1}pII", kind, name, len(data), zlib.crc32(data))
    parts = [struct.pack("<I", at) + data[at:at + DATA_SIZE] for at in range(0, len(data), DATA_SIZE)]
    return [(UPLOAD_BEGIN, begin), *((UPLOAD_DATA, part) for part in parts), (UPLOAD_END, b"")]


def error_text(answer):
    return answer.payload[1:].decode("ascii", "replace")


class Refused(Exception):
    """Raised when the status of an answer is not 0."""


class Client:
    """A connection to the remote control: sends requests, receives answers and events."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), HANG_S)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.bytes = b""
        self.is_closed = False
        self.tags = itertools.count()

    def send(self, data):
        self.socket.sendall(data)

    def take(self, wait):
        """Receives bytes, and returns the packets that are complete.

        With `wait`, waits until bytes come; otherwise returns at once.
        """
        if not select.select([self.socket], [], [], HANG_S if wait else 0)[0]:
            if wait:
                raise TimeoutError(f"no answer within {HANG_S} s")
            return []
        try:
            more = self.socket.recv(1 << 16)
        except ConnectionResetError:
            more = b""
        self.is_closed = not more
        self.bytes += more
        return self.split()

    def split(self):
        """Removes the complete packets from the received bytes, and returns them."""
        found, at = [], 0
        while len(self.bytes) - at >= ANSWER.size:
            magic, size, version, command, tag, frame, status, zero = ANSWER.unpack_from(self.bytes, at)
            if magic != b"RC" or not ANSWER.size <= size <= 1024 or zero != 0:
                raise ValueError(f"no answer: {self.bytes[at:at + 16].hex(' ')}")
            if len(self.bytes) - at < size:
                break
            payload = self.bytes[at + ANSWER.size:at + size]
            found.append(Answer(version, command, tag, frame, status, payload))
            at += size
        self.bytes = self.bytes[at:]
        return found

    def send_requests(self, requests):
        """Sends all requests (command, payload) at once; returns command and tag of each."""
        asked = [(command, next(self.tags) % 0x10000) for command, _ in requests]
        self.send(b"".join(packet(*request, tag) for request, (_, tag) in zip(requests, asked)))
        return asked

    @staticmethod
    def check_answers(answers, asked, statuses=(STATUS_OK,)):
        """Raises an exception unless each answer belongs to its request and has one of `statuses`."""
        for answer, request in zip(answers, asked, strict=True):
            if (answer.command, answer.tag) != request:
                raise ValueError(f"{answer} answers command {request[0]:#x} with tag {request[1]}")
            if answer.status not in statuses:
                raise Refused(f"command {request[0]:#x}: status {answer.status}, {error_text(answer)}")

    def ask_all(self, requests):
        """Sends all requests at once; returns the answers, all of which must have status 0."""
        asked = self.send_requests(requests)
        answers = []
        while len(answers) < len(requests):
            answers += self.take(wait=True)
            if self.is_closed:
                raise ConnectionError("the robot closed the connection")
        self.check_answers(answers, asked)
        return answers

    def ask(self, command, payload=b""):
        return self.ask_all([(command, payload)])[0]

    def close(self):
        self.socket.close()


class Run:
    """A process of `openr run` with its own stick, a recording, and a battery that stays full.

    `stick` is the folder of a stick that is there already; without it, the run gets a new copy of the
    default stick.  `prefix` are the words of a program that runs it, such as strace.  With `waits` False
    the port is not known yet; wait_for_port() returns it.
    """

    def __init__(self, openr, folder, *flags, body="ideal", prefix=(), waits=True, stick=None):
        self.openr, self.folder = str(openr), pathlib.Path(folder)
        self.stick = stick or self.folder / "stick"
        self.said = self.folder / "run.txt"
        # The run makes its control socket below this folder; clock() finds it there.
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder)}
        if stick is None:
            subprocess.run([self.openr, "stick", "host", "-o", str(self.stick)], check=True,
                           stdout=subprocess.DEVNULL)
        command = [self.openr, "run", "--stick", str(self.stick), "--body", body, "--battery", "100%",
                   "--rc-port", "0", "--no-panel", "--run-name", "check", *flags, "--record",
                   str(self.folder / "run.rec"), "--report", str(self.folder / "report.json"),
                   "--console", str(self.folder / "console.txt")]
        with self.said.open("w") as stream:
            self.process = subprocess.Popen([*prefix, *command], stdin=subprocess.DEVNULL, stdout=stream,
                                            stderr=stream, env=self.environment)
        self.port = self.wait_for_port() if waits else None
        self.lines = None  # the connection of control(), which it opens

    def wait_for_port(self):
        end = time.monotonic() + HANG_S
        while time.monotonic() < end and self.process.poll() is None:
            found = ADDRESS.search(self.said.read_text(errors="replace"))
            if found:
                return int(found[1])
            time.sleep(0.01)
        raise RuntimeError("the run has no remote control:\n" + self.said.read_text(errors="replace"))

    def wait_until_standing(self, client):
        while client.ask(SENSORS).payload[5] != READY:
            pass

    def control(self, **request):
        """Sends a request to the socket of the run (inputs.md, "The socket of a run").

        Returns the answer.
        """
        if self.lines is None:
            sockets = list((self.folder / "openr-host").glob("*.*"))
            self.control_socket = socket.socket(socket.AF_UNIX)
            self.control_socket.settimeout(HANG_S)
            self.control_socket.connect(str(sockets[0]))
            self.lines = self.control_socket.makefile("rwb")
        self.lines.write(json.dumps(request).encode() + b"\n")
        self.lines.flush()
        return json.loads(self.lines.readline())

    def clock(self, **request):
        """Changes the clock of the run as `request` says; returns its state afterwards."""
        return self.control(do="clock", **request)

    def step(self, frames, time_s):
        """Lets the paused run go on for so many frames from `time_s`, and waits until they are over.

        Returns the virtual time.
        """
        until_s = time_s + frames * 0.008
        time_s = self.clock(step="frame", count=frames)["time_s"]
        while time_s < until_s - 0.001:
            time_s = self.clock()["time_s"]
        return time_s

    def memory_kb(self):
        """Returns the resident memory of the run."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+) kB", status)[1])

    def end(self, expects=lambda finding: False):
        """Presses the pause button; returns a text if the run does not end well, else "".

        `expects` tells of a finding of the report whether the run may have it although it is an error.
        """
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            status = self.process.wait(HANG_S)
        except subprocess.TimeoutExpired:
            self.kill()
            return f"the run has not ended {HANG_S} s after the pause button"
        report_file = self.folder / "report.json"
        report = json.loads(report_file.read_text()) if report_file.exists() else {"findings": []}
        errors = [finding for finding in report["findings"] if finding["severity"] == "error"]
        if status != (1 if errors else 0) or not report_file.exists():
            return f"the run ended with status {status}"
        wrong = [finding["text"] for finding in errors if not expects(finding)]
        if report["ended_by"] != "pause" or wrong:
            return f"the run was ended by {report['ended_by']}; errors: {wrong}"
        return ""

    def check_end(self, more="", expects=lambda finding: False):
        """Ends the run and replays it; prints verdicts, and figures that end with `more`.

        `expects` is that of end().
        """
        why = self.end(expects)
        verdict("the run ends as the pause button asks", not why, why)
        messages, why = self.replay()
        verdict("the recording replays to equal hashes", not why, why)
        print(f"figures: {messages} messages replayed, recording "
              f"{(self.folder / 'run.rec').stat().st_size >> 20} MiB{more}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()

    def replay(self):
        """Replays the recording; returns the number of messages, and a text if the replay fails."""
        done = subprocess.run([self.openr, "replay", str(self.folder / "run.rec"), "--json"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              env=self.environment, check=False)
        try:
            answer = json.loads(done.stdout)
        except ValueError:
            return 0, f"openr replay has no answer, status {done.returncode}: {done.stdout}"
        is_good = done.returncode == 0 and answer.get("equal") and answer.get("at_end")
        return answer.get("messages", 0), "" if is_good else f"the replay differs: {done.stdout}"
