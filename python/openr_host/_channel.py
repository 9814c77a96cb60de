"""The pipe to the process of a run, and how the program is found and started."""
from __future__ import annotations

import json
import os
import pathlib
import select
import shutil
import socket
import struct
import subprocess
from typing import Any, Mapping, Optional, Sequence

from .errors import Refused, RunEnded, ProcessError
from .finding import findings_of

PROGRAM = "OPENR_HOST_PROGRAM"  # environment variable with the path of the program openr
_SIZES = struct.Struct("<II")
_REQUEST_MAX = 64 << 20  # largest request that the process takes (openr/serve/request_pipe.h)
_RECEIVE = 1 << 16  # bytes; recv() would ask the system for new memory each time for a larger buffer

# Processes of runs that were closed while copies of these runs still ran.  Such a process ends with its
# last copy, so close() does not wait for it.
_leftover: list["subprocess.Popen[bytes]"] = []


def find_program(program: Optional[str] = None) -> str:
    """Returns the path of the program openr.

    This is the first that is given of: `program`, the value of OPENR_HOST_PROGRAM, the path of the
    program that was installed or built beside this module, the path of the program in PATH.
    """
    named = program or os.environ.get(PROGRAM)
    if named:
        if not os.access(named, os.X_OK):
            raise ProcessError(f"{named} is no program that can be run")
        return str(pathlib.Path(named).absolute())
    here = pathlib.Path(__file__).resolve()
    candidates = [parent / "bin" / "openr" for parent in here.parents]
    candidates.append(here.parents[2] / "build" / "release" / "bin" / "openr")
    for candidate in candidates:
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    found = shutil.which("openr")
    if found:
        return found
    raise ProcessError(f"the program openr was not found; name it in {PROGRAM}, or build it: ./dev build")


class Channel:
    """The process of a run, or a copy of one, and the socket to it."""

    def __init__(self, program: Optional[str] = None, stick: str = "") -> None:
        ours, theirs = socket.socketpair()
        command = [find_program(program), "serve", *(["--stick", stick] if stick else [])]
        try:
            popen = subprocess.Popen(command, stdin=theirs.fileno(), stdout=theirs.fileno())
        except OSError as error:
            ours.close()
            raise ProcessError(f"{command[0]}: {error.strerror}") from error
        finally:
            theirs.close()
        self._popen: Optional["subprocess.Popen[bytes]"] = popen
        self.process = popen.pid
        self._socket: Optional[socket.socket] = ours
        self._rest = b""  # bytes after the last answer: the beginning of the next answer
        # The ids of the processes of open copies, and of the copies of these copies.  Copies share this
        # set with their original.  The set has ids and not channels, because a channel in it would keep
        # a copy alive that nobody uses.
        self._copies: set[int] = set()

    @classmethod
    def _of_copy(cls, process: int, ours: socket.socket, copies: "set[int]") -> "Channel":
        channel = cls.__new__(cls)
        channel._popen = None
        channel.process = process
        channel._socket = ours
        channel._rest = b""
        channel._copies = copies
        return channel

    def ask(self, request: bytes, data: bytes = b"",
            descriptors: Sequence[int] = ()) -> tuple[dict[str, Any], bytes]:
        """Sends a request, which is JSON text and `data`.  Returns the answer and its bytes."""
        if self._socket is None:
            raise ProcessError("this run is closed")
        if len(request) + len(data) > _REQUEST_MAX:
            # Not sent, because the process ends after a request that is too long.
            raise Refused(f"a request has {len(request) + len(data)} bytes, at most {_REQUEST_MAX} are allowed")
        message = _SIZES.pack(len(request), len(data)) + request + data
        try:
            if descriptors:
                socket.send_fds(self._socket, [message], descriptors)
            else:
                self._socket.sendall(message)
            return self.hear()
        except OSError as error:
            raise self._lost(str(error)) from error
        except KeyboardInterrupt:
            self.close()  # because the next request would get the answer to this request
            raise

    def hear(self) -> tuple[dict[str, Any], bytes]:
        """Waits for an answer and returns it with its bytes."""
        assert self._socket is not None
        received = self._rest or self._socket.recv(_RECEIVE)
        needed = _SIZES.size
        while True:
            if len(received) >= _SIZES.size:
                text_size, data_size = _SIZES.unpack_from(received)
                needed = _SIZES.size + text_size + data_size
                if len(received) >= needed:
                    break
            more = self._socket.recv(max(_RECEIVE, needed - len(received)))
            if not more:
                raise self._lost("it has ended")
            received += more
        self._rest = received[needed:]
        end = _SIZES.size + text_size
        answer = json.loads(received[_SIZES.size:end])
        if "error" in answer:
            self._raise(answer)
        return answer, received[end:needed]

    def _raise(self, answer: Mapping[str, Any]) -> None:
        if answer.get("kind") == "ended":
            ended, words = answer["ended"], self._last_words()
            self.close()
            raise RunEnded(ended["by"], ended["why"], answer["error"], findings_of(words.get("findings", [])),
                           words.get("console", []), words.get("report"))
        raise Refused(answer["error"])

    def _last_words(self) -> dict[str, Any]:
        """Returns findings, console and report, which the process of a crashed run sends before it
        ends; {} if the process could not send them.

        The wait ends with the process, which ends within 10 s of a crash (openr/ending/ending.cc), also
        if another process still holds the other end of the pipe.
        """
        try:
            received = self._rest + self._receive_to_the_end()
        except OSError:
            return {}
        if len(received) < _SIZES.size:
            return {}
        text_size, _ = _SIZES.unpack_from(received)
        text = received[_SIZES.size:_SIZES.size + text_size]
        words: dict[str, Any] = json.loads(text) if len(text) == text_size else {}
        return words

    def _receive_to_the_end(self) -> bytes:
        """Returns all bytes that come until the pipe is closed or the process has ended."""
        assert self._socket is not None
        poll = select.poll()
        poll.register(self._socket, select.POLLIN)
        ended = -1  # a descriptor that is readable once the process has ended
        try:
            ended = os.pidfd_open(self.process)
        except ProcessLookupError:  # a copy that has ended already; its bytes are in the pipe
            ended = os.open(os.devnull, os.O_RDONLY)
        except OSError:
            pass  # a system without such descriptors; the pipe alone shows the end
        try:
            if ended >= 0:
                poll.register(ended, select.POLLIN)
            received = b""
            while self._socket.fileno() in dict(poll.poll()):
                more = self._socket.recv(_RECEIVE)
                if not more:
                    break
                received += more
            return received
        finally:
            if ended >= 0:
                os.close(ended)

    def _lost(self, why: str) -> ProcessError:
        status = None
        if self._popen is not None:
            try:
                status = self._popen.wait(5)
            except subprocess.TimeoutExpired:
                self._popen.kill()
                status = self._popen.wait()
        self.close()
        said = "" if status is None else f" (exit status {status}; standard error says more)"
        return ProcessError(f"the process of the run cannot be reached: {why}{said}")

    def fork(self, record: str) -> "Channel":
        """Copies the process.  Returns the channel to the copy."""
        ours, theirs = socket.socketpair()
        request = json.dumps({"do": "fork", "record": record}).encode()
        try:
            answer, _ = self.ask(request, descriptors=[theirs.fileno()])
        except BaseException:
            ours.close()
            raise
        finally:
            theirs.close()
        copy = Channel._of_copy(answer["process"], ours, self._copies)
        self._copies.add(copy.process)
        copy.hear()  # the first answer of the copy says that it runs
        return copy

    def is_closed(self) -> bool:
        return self._socket is None

    def close(self) -> None:
        """Ends the process.  The process that has started the run ends only with the last copy of the run."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None
            self._copies.discard(self.process)
        popen, self._popen = self._popen, None
        _leftover[:] = [each for each in _leftover if each.poll() is None]
        if popen is None:
            return
        if self._copies:
            _leftover.append(popen)
            return
        try:
            popen.wait(10)
        except subprocess.TimeoutExpired:
            popen.kill()
            popen.wait()

    def __del__(self) -> None:
        if getattr(self, "_socket", None) is not None:
            self.close()
