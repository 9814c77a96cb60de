"""The remote control of the default stick (docs/remote-control.md), over a connection of a run."""
from __future__ import annotations

import os
import pathlib
import struct
import zlib
from typing import NamedTuple, Union

from .errors import Error, NotMet
from .run import Run

PORT = 54000
READY = 6  # Sensors.state of a robot that stands and plays no motion
_INFO, _MOVE, _SENSORS, _MTN_PLAY, _MTN_STOP, _MTN_LIST = 0x01, 0x11, 0x30, 0x40, 0x41, 0x42
_UPLOAD_BEGIN, _UPLOAD_DATA, _UPLOAD_END = 0x50, 0x51, 0x52
_REQUEST = struct.Struct("<2sHBBH")
_ANSWER = struct.Struct("<2sHBBHIHH")
_BUSY = 7


class RemoteError(Error):
    """The robot has refused a request; `status` is the number of the error."""

    def __init__(self, status: int, text: str) -> None:
        super().__init__(text)
        self.status = status


class Sensors(NamedTuple):
    state: int
    joints: tuple[float, ...]  # degrees, in the order of Run.joint_names
    key_frame: int             # number of the key frame of the motion that plays; -1: none plays


class Remote:
    """A client of the object RCServer.  Requests take virtual time: the robot reads them between frames."""

    def __init__(self, run: Run, robot: int = 0) -> None:
        self._run = run
        self._connection = run.connect(PORT, robot)
        self._tag = 0  # tag of the next request; changes when an answer does not come in time

    def ask(self, command: int, payload: bytes = b"", version: int = 2) -> bytes:
        """Sends a request and returns the payload of its answer."""
        size = _REQUEST.size + len(payload)
        self._connection.send(_REQUEST.pack(b"RC", size, version, command, self._tag) + payload)
        try:
            while True:
                head = _ANSWER.unpack(self._connection.receive(_ANSWER.size))
                rest = head[1] - _ANSWER.size
                answer = self._connection.receive(rest) if rest > 0 else b""
                if head[4] == self._tag:
                    break
        except NotMet:
            self._tag = self._tag % 0xffff + 1  # another number, because the answer may still come
            raise
        if head[6] != 0:
            raise RemoteError(head[6], answer[1:].decode("ascii", "replace"))
        return answer

    def sensors(self) -> Sensors:
        answer = self.ask(_SENSORS)
        count = answer[0]
        joints = struct.unpack_from(f"<{count}i", answer, 8)
        return Sensors(answer[5], tuple(each / 100 for each in joints),
                       struct.unpack_from("<i", answer, len(answer) - 4)[0])

    def move(self, joint: Union[int, str], degrees: float) -> None:
        """Moves a joint within its limits of speed and acceleration."""
        index = self._run.joint_names.index(joint) if isinstance(joint, str) else joint
        self.ask(_MOVE, struct.pack("<Bi", index, round(degrees * 100)))

    def upload(self, name: str, data: bytes) -> None:
        """Puts a motion on the robot's stick."""
        encoded = name.encode("ascii")
        begin = struct.pack(f"<B{len(encoded) + 1}pII", 0, encoded, len(data), zlib.crc32(data))
        room = struct.unpack("<H", self.ask(_UPLOAD_BEGIN, begin))[0]
        for i in range(0, len(data), room):
            self.ask(_UPLOAD_DATA, struct.pack("<I", i) + data[i:i + room])
        self.ask(_UPLOAD_END)

    def upload_file(self, file: Union[str, "os.PathLike[str]"]) -> str:
        path = pathlib.Path(file)
        self.upload(path.name, path.read_bytes())
        return path.name

    def motions(self) -> list[str]:
        """Returns the names of the motions on the stick, the first 50."""
        answer = self.ask(_MTN_LIST, struct.pack("<H", 0))
        names, at = [], 5
        for _ in range(answer[4]):
            length = answer[at]
            names.append(answer[at + 1:at + 1 + length].decode("ascii"))
            at += 1 + length + 4
        return names

    def play(self, name: str, loops: int = 1) -> float:
        """Begins to play a motion.  Returns how long all loops take, in s."""
        encoded = name.encode("ascii")
        answer = self.ask(_MTN_PLAY, struct.pack(f"<{len(encoded) + 1}pHB", encoded, loops, 0))
        duration_ms: int = struct.unpack_from("<I", answer)[0]
        return duration_ms / 1000 * loops

    def stop(self) -> None:
        self.ask(_MTN_STOP)

    def wait(self, within_s: float = 60.0) -> None:
        """Runs until the robot stands and plays no motion."""
        end_s = self._run.time_s + within_s
        while self.sensors().state != READY:
            if self._run.time_s >= end_s:
                raise NotMet(f"the robot is not ready within {within_s} s")
            self._run.run(0.032)

    def close(self) -> None:
        self._connection.close()
