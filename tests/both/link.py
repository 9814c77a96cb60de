#!/usr/bin/env python3
"""A link with delay, loss and stops between a client and a server of TCP, for tests and trials.

    link.py --to 127.0.0.1:54001 [--port 55001] [--delay-ms 50] [--loss 0.02]

prints "link: 127.0.0.1:PORT control: 127.0.0.1:PORT" and passes bytes on in both directions.  A
lost packet of TCP is a pause here, as for programs at its ends: what was lost, and all behind it,
comes RETRANSMIT_S later.  The control port takes lines:

    delay MS     one way, from now on
    loss SHARE   of the pieces that come
    stop         nothing gets through any more; connections stay
    go           all gets through again
    cut          connections are reset, and new ones until "go"
"""
import argparse
import collections
import random
import socket
import struct
import sys
import threading
import time

RETRANSMIT_S = 0.2
PIECE = 1400
WAITING_MAX = 64  # pieces on their way in one direction; more are not read from the sender


class Link:
    def __init__(self, to, port=0, delay_ms=0, loss=0.0, seed=1):
        self.to = to
        self.delay_s = delay_ms / 1000
        self.loss = loss
        self.is_stopped = False
        self.is_cut = False
        self.passed = 0  # bytes that have got through
        self.random = random.Random(seed)
        self.changed = threading.Condition()
        self.connections = []
        self.listener = socket.create_server(("127.0.0.1", port))
        self.address = "127.0.0.1:%d" % self.listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def set(self, **values):
        with self.changed:
            for name, value in values.items():
                setattr(self, name, value)
            self.changed.notify_all()

    def cut(self):
        with self.changed:
            self.is_cut = True
            connections, self.connections = self.connections, []
        for each in connections:
            reset(each)

    def _accept(self):
        while True:
            client, _ = self.listener.accept()
            try:
                server = socket.create_connection(self.to, timeout=10)
            except OSError:
                reset(client)
                continue
            with self.changed:
                if self.is_cut:
                    reset(client)
                    reset(server)
                    continue
                self.connections += [client, server]
            for each in client, server:
                each.settimeout(None)
                each.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            Pipe(self, client, server)
            Pipe(self, server, client)


class Pipe:
    """Passes on the bytes of a connection in one direction."""

    def __init__(self, link, source, sink):
        self.link, self.source, self.sink = link, source, sink
        self.pieces = collections.deque()  # (time at which it arrives, bytes); b"": the end
        threading.Thread(target=self._read, daemon=True).start()
        threading.Thread(target=self._write, daemon=True).start()

    def _read(self):
        link, arrives = self.link, 0.0
        while True:
            try:
                piece = self.source.recv(PIECE)
            except OSError:
                piece = b""
            with link.changed:
                pause = RETRANSMIT_S if link.random.random() < link.loss else 0
                # Bytes of TCP keep their order.
                arrives = max(arrives, time.monotonic() + link.delay_s + pause)
                self.pieces.append((arrives, piece))
                link.changed.notify_all()
                link.changed.wait_for(lambda: len(self.pieces) < WAITING_MAX)
            if not piece:
                return

    def _write(self):
        link = self.link
        while True:
            with link.changed:
                link.changed.wait_for(lambda: self.pieces and not link.is_stopped)
                wait_s = self.pieces[0][0] - time.monotonic()
                if wait_s > 0:
                    link.changed.wait(wait_s)
                    continue
                piece = self.pieces.popleft()[1]
                link.passed += len(piece)
                link.changed.notify_all()
            try:
                if not piece:
                    self.sink.shutdown(socket.SHUT_WR)
                    return
                self.sink.sendall(piece)
            except OSError:
                return


def reset(connection):
    """Closes a connection as a network that has failed does: with RST."""
    try:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        connection.shutdown(socket.SHUT_RDWR)
    except OSError:
        pass
    connection.close()


def obey(link, line):
    words = line.split()
    if words[:1] == ["delay"]:
        link.set(delay_s=float(words[1]) / 1000)
    elif words[:1] == ["loss"]:
        link.set(loss=float(words[1]))
    elif words == ["stop"]:
        link.set(is_stopped=True)
    elif words == ["go"]:
        link.set(is_stopped=False, is_cut=False)
    elif words == ["cut"]:
        link.cut()
    else:
        raise ValueError("unknown: " + line)


def serve_control(link, listener):
    while True:
        connection, _ = listener.accept()
        with connection, connection.makefile("rw") as lines:
            for line in lines:
                try:
                    obey(link, line)
                    lines.write("ok\n")
                except (ValueError, IndexError) as problem:
                    lines.write(f"{problem}\n")
                lines.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--to", required=True)
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--delay-ms", type=float, default=0)
    parser.add_argument("--loss", type=float, default=0)
    arguments = parser.parse_args()
    host, port = arguments.to.rsplit(":", 1)
    link = Link((host, int(port)), arguments.port, arguments.delay_ms, arguments.loss)
    control = socket.create_server(("127.0.0.1", 0))
    print(f"link: {link.address} control: 127.0.0.1:{control.getsockname()[1]}", flush=True)
    serve_control(link, control)


if __name__ == "__main__":
    sys.exit(main())
