#!/usr/bin/env python3
"""tools/remote_load.py --fastest: which answers are failures; a robot that is pretended here gives them.  The last
line is "N passed, N failed"."""
import collections
import random
import socket
import struct
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import remote_load as load  # noqa: E402
import remote_run as rc  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

OTHER_TAG, LONG, LEFT_OUT, BUSY, CLOSED = "another tag", "too long", "left out", "BUSY", "closed"


def answer(request, case):
    """Returns the bytes of an answer to the bytes of a GET."""
    _, _, version, command, tag = rc.REQUEST.unpack_from(request)
    size, status = (20, rc.STATUS_BUSY) if case == BUSY else (13 if case == LONG else 12, rc.STATUS_OK)
    return rc.ANSWER.pack(b"RC", rc.ANSWER.size + size, version, command, tag + (case == OTHER_TAG), 0,
                          status, 0) + bytes(size)


def serve(listener, case, is_always):
    """Serves one client; the first answer, or with `is_always` each one, is that of the case."""
    connection = listener.accept()[0]
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    data, count = b"", 0
    while more := connection.recv(1 << 16):
        data += more
        while len(data) > rc.REQUEST.size:
            size = struct.unpack_from("<2sH", data)[1]
            now = case if count == 0 or is_always else ""
            if now == CLOSED:
                connection.close()
                return
            if now != LEFT_OUT:
                connection.sendall(answer(data[:size], now))
            data, count = data[size:], count + 1


class Run:
    """The clock and the memory of a run that goes on for half a second whenever it is looked at."""

    def __init__(self):
        self.time_s = 0.0

    def clock(self):
        self.time_s += 0.5
        return {"time_s": self.time_s, "speed": 1.0}

    def memory_kb(self):
        return 1000


class GetClient(load.LoadClient):
    """A client whose commands are all GET."""

    KINDS = {"get": 1}


def failures(case="", is_always=False):
    """Returns the names of the failed verdicts about a client of a robot that answers so."""
    listener = socket.create_server(("127.0.0.1", 0))
    threading.Thread(target=serve, args=(listener, case, is_always), daemon=True).start()
    client = GetClient(listener.getsockname()[1], random.Random(1), may_be_busy=True)
    load.load_fastest(Run(), [client], 1)
    said = collections.deque()
    kept, load.verdict = load.verdict, lambda name, good, why="": good or said.append(name)
    try:
        load.tell_fastest([client])
    finally:
        load.verdict = kept
        client.close()
    return " / ".join(said)


def main():
    verdict("right answers in order are good", failures() == "", failures())
    verdict("some answers may be BUSY", failures(BUSY) == "")
    verdict("not all answers may be BUSY", "its commands is answered" in failures(BUSY, True))
    verdict("an answer with another tag is a failure", "in order" in failures(OTHER_TAG))
    verdict("an answer of another size is a failure", "as asked" in failures(LONG))
    load.rc.HANG_S = 1  # for the answer that does not come
    verdict("an answer that is left out is a failure", "in order" in failures(LEFT_OUT))
    verdict("a connection that is closed is a failure", "is not closed" in failures(CLOSED))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
