"""A run, and a page of its panel without a browser, for scripts."""
import json
import os
import pathlib
import re
import socket
import struct
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from run_process import RunProcess  # noqa: E402: the folder is put into the path first

PATIENCE_S = 120  # the longest wait for anything, in wall time


class Run(RunProcess):
    """`openr run`, with a panel if it has a page."""

    def __init__(self, openr, name, *flags, panel=True):
        panel_flags = ["--panel", "--panel-port", "0"] if panel else ["--no-panel"]
        super().__init__(openr, "--run-name", name, *panel_flags, *flags)
        self.robot = self.need(r"openr rc (127\.0\.0\.1:\d+) info")[1]
        self.url = self.need(r"panel: (http://\S+)")[1] if panel else ""

    def need(self, pattern):
        """Waits for a line of standard error with `pattern`, and returns the match."""
        found = self.wait_for(pattern, PATIENCE_S)
        if not found:
            raise RuntimeError(f"no line has {pattern}:\n" + "".join(self.said))
        return found

    def rc(self, *words):
        """Answers of `openr rc --json` at this run's robot."""
        done = subprocess.run([self.openr, "rc", self.robot, "--json", *words], text=True,
                              capture_output=True, timeout=PATIENCE_S, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def end(self, seconds=PATIENCE_S):
        return super().end(seconds)


class Page:
    """The WebSocket of a page.  Events are kept, the newest of each name."""

    def __init__(self, url):
        address, token = re.match(r"http://([\d.]+:\d+)/\?token=(\w+)", url).groups()
        host, port = address.split(":")
        self.socket = socket.create_connection((host, int(port)), timeout=PATIENCE_S)
        self.received = b""
        self.events = {}
        self.id = 0
        self.socket.sendall(
            (f"GET /ws HTTP/1.1\r\nHost: {address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
             f"Sec-WebSocket-Protocol: openr.{token}\r\n\r\n").encode())
        while b"\r\n\r\n" not in self.received:
            self._receive()
        self.received = self.received.split(b"\r\n\r\n", 1)[1]

    def close(self):
        self.socket.close()

    def _receive(self):
        more = self.socket.recv(1 << 16)
        if not more:
            raise RuntimeError("the server has closed the page")
        self.received += more

    def _take(self, count):
        while len(self.received) < count:
            self._receive()
        taken, self.received = self.received[:count], self.received[count:]
        return taken

    def message(self):
        head = self._take(2)
        size = head[1] & 127
        if size == 126:
            size = struct.unpack(">H", self._take(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self._take(8))[0]
        payload = self._take(size)
        if head[0] & 15 == 8:
            raise RuntimeError(f"the server has closed the page: {payload[2:].decode()}")
        message = json.loads(payload)
        if "event" in message:
            self.events[message["event"]] = message
        return message

    def send(self, request):
        self.id += 1
        payload = json.dumps({**request, "id": self.id}).encode()
        size = len(payload)
        head = bytes([0x81, 0x80 | size]) if size < 126 else bytes([0x81, 0xfe]) + struct.pack(">H", size)
        self.socket.sendall(head + bytes(4) + payload)
        return self.id

    def ask(self, request):
        number = self.send(request)
        while True:
            message = self.message()
            if message.get("id") == number and "event" not in message:
                return message

    def wait_for(self, event, is_good, what):
        """Waits for an event that is good, and returns it."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            message = self.message()
            if message.get("event") == event and is_good(message):
                return message
        raise RuntimeError(f"{what}; the last event is {self.events.get(event)}")

    def rc(self, call, endpoint="run", **more):
        return self.ask({"do": "rc", "call": call, "endpoint": endpoint, "robot": 0, **more})

    def pair(self, call, **more):
        return self.ask({"do": "pair", "call": call, "robot": 0, **more})


def private_runs(folder):
    """Lets runs have their sockets in `folder`, where no other program finds them."""
    os.environ["XDG_RUNTIME_DIR"] = str(folder)
