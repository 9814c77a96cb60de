"""Run: a robot, its objects and its simulated body.  Time passes only when a call asks for it.

    import openr_host
    with openr_host.Run() as run:
        run.until_standing()
        run.press("chin", for_s=0.3)
        run.run(1)
        print(run.joints()["neck_pan"], run.value("height_mm"))
"""
from __future__ import annotations

import array
import base64
import json
import math
import os
import pathlib
import subprocess
from typing import Any, Callable, Iterable, Mapping, NamedTuple, Optional, Sequence, TypeVar, Union, overload

from ._channel import Channel, find_program
from ._commands import Commands
from .errors import Error, NotMet, RunEnded
from .finding import Finding, findings_of

Value = Union[float, str]
Kind = TypeVar("Kind", float, str)
READY = "objects.JointMover.state == accepting-commands"


class Message(NamedTuple):
    """A message that an object has handled.

    `data` has the bytes of the message.  Messages of the network stack contain addresses in memory, so
    for these `data` has a description.  `text` is the content in words, a line for each value: "move
    neck_pan to 30.00 deg".  Content of a type that only your objects know becomes text or numbers.
    """

    number: int
    cause: int
    time_s: float
    kind: str
    sender: str
    receiver: str
    entry: str
    data: bytes
    text: str = ""

    def __repr__(self) -> str:
        text = "; ".join(self.text.splitlines())
        if len(text) > 120:
            text = text[:117] + "..."
        return (f"Message(#{self.number} t={self.time_s:.6f} {self.kind} {self.sender} -> "
                f"{self.receiver}, {len(self.data)} bytes{text and ': ' + text})")


class State:
    """A state of a run that `Run.save` has kept.  A process holds the state until `drop()`."""

    def __init__(self, channel: Channel, run: "Run") -> None:
        self._channel = channel
        self._about = run._about
        self._actuators, self._observed = run.actuators, run.observed
        self.time_s = run.time_s

    def drop(self) -> None:
        self._channel.close()

    def __enter__(self) -> "State":
        return self

    def __exit__(self, *_: object) -> None:
        self.drop()


def _message(fields: Mapping[str, Any], data: bytes) -> Message:
    return Message(fields["number"], fields["cause"], fields["time_s"], fields["kind"], fields["from"],
                   fields["to"], fields["entry"], data, fields["text"])


def _seconds(time_s: float) -> str:
    return f"{round(time_s * 1e6)}us"


class Run:
    """A run in a process of its own.  `boot=False` leaves the robot off until `boot()`.

    The parameters are flags of `openr run`; docs/python.md lists them.  Without `stick`, the run
    has the default stick, whose objects make the dog stand up and wait for commands.
    """

    def __init__(self, stick: Union[str, "os.PathLike[str]"] = "", *, robot: str = "ers210",
                 body: str = "ode", world: Union[str, "os.PathLike[str]"] = "", seed: int = 1,
                 robots: int = 1, together: bool = False, battery: str = "drain",
                 images: str = "world", cost: str = "", strict: bool = False,
                 network: str = "inside", rc_port: int = 0, writable: bool = True,
                 record: Union[str, "os.PathLike[str]"] = "", payloads: bool = True,
                 log: str = "info", echo: bool = False, handler_limit_s: float = 10.0,
                 boot: bool = True, program: Optional[str] = None) -> None:
        self._take(Channel(program, os.fspath(stick)))
        self.record = os.fspath(record)
        try:
            about, _ = self._commands.start(
                stick=os.fspath(stick), robot=robot, world=os.fspath(world), body=body, seed=seed,
                robots=robots, together=together, battery=battery, images=images, cost=cost,
                strict=strict, network=network, rc_port=rc_port, writable=writable,
                record=self.record, payloads=payloads, log=log, echo=echo,
                handler_limit_s=handler_limit_s)
        except BaseException:
            self.close()
            raise
        self._learn(about)
        self.time_s: float = 0.0
        if boot:
            self.boot()

    def _learn(self, about: Mapping[str, Any]) -> None:
        self._about = about
        self.model: str = about["model"]
        self.joint_names: tuple[str, ...] = tuple(about["joints"])
        self.sensor_names: tuple[str, ...] = tuple(about["sensors"])
        self.locators: dict[str, str] = dict(zip(about["joints"], about["locators"]))
        # By the name of a joint: smallest and largest set point, in degrees, and speed, in degrees/s.
        self.limits: dict[str, tuple[float, float, float]] = {
            name: (low, high, speed) for name, (low, high, speed) in zip(about["joints"], about["limits"])}
        self.actuators: tuple[str, ...] = self.joint_names
        self.observed: tuple[str, ...] = ()

    def _take(self, channel: Channel) -> None:
        self._channel = channel
        self._commands = Commands(channel)
        self._act: dict[tuple[int, bool], bytes] = {}

    # ---- Methods that begin and end a run

    def boot(self) -> None:
        """Begins the boot.  The objects start while the run goes on."""
        self._commands.boot()

    def finish(self) -> dict[str, Any]:
        """Ends the run, completes its recording, and returns the report."""
        return self._commands.finish()[0]

    def close(self) -> None:
        """Ends the process of the run, and completes its recording."""
        self._channel.close()

    @property
    def closed(self) -> bool:
        return self._channel.is_closed()

    def __enter__(self) -> "Run":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _goes_on(self, answer: tuple[dict[str, Any], bytes]) -> tuple[dict[str, Any], bytes]:
        """Sets `time_s` to the time in an answer.  Raises RunEnded if the run is over."""
        members = answer[0]
        self.time_s = members["time_s"]
        if "ended" in members:
            raise RunEnded(members["ended"]["by"], members["ended"]["why"], "", self.findings(),
                           self.console(), self.report())
        return answer

    # ---- Methods that let time pass

    def run(self, for_s: float) -> None:
        """Runs for `for_s` seconds of virtual time."""
        self._goes_on(self._commands.run(for_s=for_s))

    def run_to(self, to_s: float) -> None:
        """Runs until the virtual time is `to_s`."""
        self._goes_on(self._commands.run(to_s=to_s))

    def step(self, over: str = "frame", count: int = 1) -> None:
        """Runs over the next `count` frames of 8 ms, messages ("message") or sensor vectors ("vector")."""
        self._goes_on(self._commands.step(over=over, count=count))

    def until(self, condition: Union[str, Callable[["Run"], object]], within_s: float = 10.0) -> None:
        """Runs until a condition holds at the end of a frame.

        `condition` is a text such as "robots[0].pitch_deg > 10", or a function that gets this run.  Raises
        NotMet if the condition does not hold within `within_s` seconds of virtual time.
        """
        if isinstance(condition, str):
            met = self._goes_on(self._commands.until(condition=condition, within_s=within_s))[0]["met"]
        else:
            end_s = self.time_s + within_s
            while not (met := bool(condition(self))) and self.time_s < end_s:
                self.step()
        if not met:
            raise NotMet(f"{condition} did not hold within {within_s} s, up to t={self.time_s} s")

    def until_standing(self, within_s: float = 30.0) -> None:
        """Runs until JointMover of the default stick has made the dog stand."""
        self.until(READY, within_s)

    # ---- Methods for a loop of control, which moves joints and reads values again and again

    def actuate(self, *names: str) -> tuple[str, ...]:
        """Chooses the joints that `act` moves, and their order; without `names`, all joints."""
        self.actuators = tuple(self._commands.actuate(names=names)[0]["names"])
        return self.actuators

    def observe(self, *names: str) -> tuple[str, ...]:
        """Chooses the values that `act` and `observation` return: quantities such as "x_m",
        "joint.LF_j1" or "sensor.chin", and groups such as "joints".  Without `names`, keeps the values
        that were chosen before.  Returns their full names."""
        self.observed = tuple(self._commands.observe(names=names)[0].get("names", self.observed))
        return self.observed

    def observation(self) -> "array.array[float]":
        """Returns the chosen values as they are now."""
        values: "array.array[float]" = array.array("d")
        values.frombytes(self._commands.observe()[1])
        return values

    def act(self, targets: Optional[Iterable[float]] = None, frames: int = 4,
            ramp: bool = True) -> "array.array[float]":
        """Gives the chosen joints set points in degrees, runs frames of 8 ms, and returns the chosen
        values.  With `ramp` the set points move evenly in these frames, else they jump."""
        request = self._act.get((frames, ramp))
        if request is None:
            request = json.dumps({"do": "act", "frames": frames, "ramp": ramp}).encode()
            self._act[frames, ramp] = request
        data = b"" if targets is None else array.array("d", targets).tobytes()
        answer = self._goes_on(self._channel.ask(request, data))
        values: "array.array[float]" = array.array("d")
        values.frombytes(answer[1])
        return values

    # ---- Methods that do what people do to the robot (docs/inputs.md)

    def input(self, line: str, robot: int = 0) -> None:
        """Gives the run an input in the form of docs/inputs.md, such as "press chin for 300ms"."""
        self._commands.input(line=line, robot=robot)

    def inputs(self, robot: int = 0) -> list[str]:
        """Returns a line for each input that shows how the input is written."""
        return [each["usage"] for each in self._commands.inputs(robot=robot)[0]["inputs"]]

    def set_joints(self, degrees: Mapping[str, float], in_s: float = 0.0, robot: int = 0) -> None:
        """Gives servos set points that replace those of the objects until `release_joints`."""
        goals = " ".join(f"{name} {value:.5f}" for name, value in degrees.items())
        self.input(f"target {goals}" + (f" in {_seconds(in_s)}" if in_s > 0 else ""), robot)

    def release_joints(self, robot: int = 0) -> None:
        """Gives all joints back to the objects of the robot."""
        self.input("target off", robot)

    def press(self, sensor: str, for_s: float = 0.0, robot: int = 0) -> None:
        self.input(f"press {sensor}" + (f" for {_seconds(for_s)}" if for_s > 0 else ""), robot)

    def release(self, sensor: str, robot: int = 0) -> None:
        self.input(f"release {sensor}", robot)

    def push(self, x_n: float, y_n: float, z_n: float = 0.0, for_s: float = 0.1, robot: int = 0) -> None:
        """Pushes the body with a force in N: forward (x_n), to its left (y_n) and up (z_n)."""
        self.input(f"push {x_n} {y_n} {z_n} for {_seconds(for_s)}", robot)

    def inject(self, observer: str, data: bytes, subject: str = "", robot: int = 0) -> None:
        """Sends `data` to an observer, as if a connected subject had sent a notification."""
        sender = f" from {subject}" if subject else ""
        self.input(f"send {observer}{sender} hex:{data.hex()}", robot)

    # ---- Methods that wait for messages and keep them

    def expect(self, sender: str = "", receiver: str = "", *, kind: str = "", entry: str = "",
               within_s: float = 1.0) -> Message:
        """Runs until a message with these properties has been handled, and returns the message.

        `sender` and `receiver` are an object, "RCServer", or the first parts of a service,
        "RCServer.Mover".  Raises NotMet if no such message comes within `within_s` seconds.
        """
        members, data = self._goes_on(self._commands.expect(
            kind=kind, sender=sender, receiver=receiver, entry=entry, within_s=within_s))
        if not members["met"]:
            raise NotMet(f"no {members['wanted']} within {within_s} s, up to t={self.time_s} s")
        return _message(members["message"], data)

    def watch(self, sender: str = "", receiver: str = "", *, kind: str = "", entry: str = "") -> None:
        """Keeps all messages with these properties from now on; `watched` returns them."""
        self._commands.watch(kind=kind, sender=sender, receiver=receiver, entry=entry)

    def watched(self) -> list[Message]:
        """Returns the messages that `watch` has kept, at most the last 10,000, and forgets them."""
        members, data = self._commands.watched()
        messages, at = [], 0
        for fields in members["messages"]:
            messages.append(_message(fields, data[at:at + fields["size"]]))
            at += fields["size"]
        return messages

    def connect(self, port: int, robot: int = 0) -> "Connection":
        """Connects to a TCP port of the robot without a socket, so that the run can be repeated exactly."""
        return Connection(self, self._commands.connect(port=port, robot=robot)[0]["connection"])

    # ---- Methods that copy the run, and that keep states and go back to them

    def fork(self, record: Union[str, "os.PathLike[str]"] = "") -> "Run":
        """Copies the run.  The run and its copy go on from here, each in its own process.

        `record` names the file in which the copy goes on with the recording of this run; without
        it, the copy records nothing.
        """
        copy = Run.__new__(Run)
        copy.record = os.fspath(record)
        copy._take(self._channel.fork(copy.record))
        copy._learn(self._about)
        copy.actuators, copy.observed, copy.time_s = self.actuators, self.observed, self.time_s
        return copy

    def save(self) -> State:
        """Keeps the present state, for `go_back`."""
        return State(self._channel.fork(""), self)

    def go_back(self, state: State, record: Union[str, "os.PathLike[str]"] = "") -> None:
        """Goes back to `state`, or forward to a state of another run.  All that this run did since is lost.

        `act` moves the same joints and returns the same values as before, unless `state` is of a robot of
        another model: then what `act` does is as in `state`.  If this run has chosen no values, `act`
        returns those that were chosen in `state`.

        The recording of this run ends here.  `record` names the file of a new recording, which has the
        run from its begin to `state`, and all that follows.
        """
        channel = state._channel.fork(os.fspath(record))
        self._channel.close()
        self._take(channel)
        self.record = os.fspath(record)
        actuators, observed = state._actuators, state._observed
        if state._about == self._about:
            actuators, observed = self.actuators, self.observed or observed
        self._learn(state._about)
        self.actuators, self.observed = state._actuators, state._observed
        if actuators != self.actuators:
            self.actuate(*actuators)
        if observed != self.observed:
            self.observe(*observed)
        self.time_s = state.time_s

    # ---- Methods that read values

    def read(self, *names: str) -> dict[str, Value]:
        """Reads values, which have the names that `observe` takes.  Values may be texts, too.  The keys of
        the result are the full names.  A number that is not known, such as `command.neck_pan` before the
        first command, is NaN."""
        values: dict[str, Optional[Value]] = self._commands.read(names=names)[0]["values"]
        return {name: math.nan if value is None else value for name, value in values.items()}  # JSON has no NaN

    @overload
    def value(self, name: str) -> Any: ...

    @overload
    def value(self, name: str, kind: type[Kind]) -> Kind: ...

    def value(self, name: str, kind: Any = None) -> Any:
        """Reads one value: `run.value("height_mm")`, `run.value("objects.JointMover.state")`.

        With `kind`, `float` or `str`, the result has this type, also for type checkers.  If the value is a
        text and `kind` is `float`, or the other way round, the method raises Error.
        """
        if kind not in (None, float, str):
            raise Error(f"kind {kind!r} is neither float nor str")
        values = list(self.read(name).values())
        if len(values) != 1:
            raise Error(f"'{name}' are {len(values)} values; use read()")
        value = values[0]
        if kind is None:
            return value
        if isinstance(value, str) != (kind is str):
            raise Error(f"'{name}' is {value!r}, which is no {kind.__name__}")
        return kind(value)

    def joints(self, robot: int = 0) -> dict[str, float]:
        """Returns the measured angles of the joints in degrees."""
        return {each["name"]: each["deg"] for each in self._commands.joints(robot=robot)[0]["joints"]}

    def targets(self, robot: int = 0) -> dict[str, float]:
        """Returns the commanded angles of the joints in degrees."""
        joints = self._commands.joints(robot=robot)[0]["joints"]
        return {each["name"]: each["target_deg"] for each in joints}

    def sensors(self, robot: int = 0) -> dict[str, int]:
        """Returns the values of the sensors, in their OPEN-R units."""
        sensors = self._commands.sensors(robot=robot)[0]["sensors"]
        return {each["name"]: each["value"] for each in sensors}

    def objects(self) -> list[dict[str, Any]]:
        """Returns the objects with their states."""
        objects: list[dict[str, Any]] = self._commands.objects()[0]["objects"]
        return objects

    def object(self, name: str, robot: int = 0) -> dict[str, Any]:
        """Returns an object with its services, their connections, and findings about it."""
        return self._commands.object(name=name, robot=robot)[0]

    def status(self) -> dict[str, Any]:
        return self._commands.status()[0]

    def findings(self) -> list[Finding]:
        return findings_of(self._commands.findings()[0]["findings"])

    def console(self, first: int = 0) -> list[str]:
        """Returns the lines that objects have printed, at most the last 1000."""
        lines: list[str] = self._commands.console(first=first)[0]["lines"]
        return lines

    def hashes(self) -> tuple[str, str]:
        """Returns the hash of all messages, and the hash of the state."""
        members = self._commands.hashes()[0]
        return members["trace_hash"], members["state_hash"]

    def report(self) -> dict[str, Any]:
        """Returns the report, as `openr run --report` writes it."""
        return self._commands.report()[0]

    def camera(self, layer: str = "picture", robot: int = 0) -> bytes:
        """Returns the picture of the robot's camera as PNG."""
        return base64.b64decode(self._commands.camera(layer=layer, robot=robot)[0]["png"])

    def picture(self, file: Union[str, "os.PathLike[str]"], view: str = "iso", size: str = "1280x720",
                robot: int = 0) -> None:
        """Writes a picture of the robot to a PNG file."""
        self._commands.picture(file=os.fspath(file), view=view, size=size, robot=robot)

    def motion(self, csv: str, name: str = "motion") -> bytes:
        """Returns a motion file (MTN) with the key frames `csv`, a table as of `openr mtn dump`."""
        return self._commands.motion(csv=csv, name=name)[1]


class Connection:
    """A TCP connection to a robot."""

    def __init__(self, run: Run, number: int) -> None:
        self._run = run
        self._number = number

    def send(self, data: bytes) -> None:
        """Sends bytes.  The robot sees them at its next frame boundary."""
        self._run._commands.send(connection=self._number, data=data)

    def receive(self, count: int = 0, within_s: float = 1.0) -> bytes:
        """Runs until `count` bytes have come, and returns them; with 0, returns what has come already.

        Raises NotMet if the bytes do not come within `within_s` seconds of virtual time.
        """
        answer = self._run._commands.receive(connection=self._number, count=count, within_s=within_s)
        members, data = self._run._goes_on(answer)
        if len(data) < count:
            end = "" if members["open"] else "; the robot has ended the connection"
            raise NotMet(f"the robot has not sent {count} bytes within {within_s} s{end}")
        return data

    def close(self) -> None:
        self._run._commands.disconnect(connection=self._number)


class Replay(NamedTuple):
    """The result of `replay`."""

    equal: bool
    messages: int
    time_s: float
    difference: str


def replay(recording: Union[str, "os.PathLike[str]"], stick: Union[str, "os.PathLike[str]"] = "",
           program: Optional[str] = None) -> Replay:
    """Runs a recording again and compares each message with the recording, as `openr replay` does."""
    command = [find_program(program), "replay", "--json", os.fspath(recording)]
    if stick:
        command += ["--stick", os.fspath(stick)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        answer = json.loads(done.stdout)
    except json.JSONDecodeError:
        raise Error(f"{recording}: {done.stderr.strip()}") from None
    if "equal" not in answer:
        raise Error(f"{recording}: {answer.get('error', done.stderr.strip())}")
    return Replay(answer["equal"], answer["messages"], answer["virtual_time_s"], answer["difference"])


def default_motion(name: str, program: Optional[str] = None) -> pathlib.Path:
    """Returns the path of the file of a motion, such as "WALK.MTN", on the default stick."""
    root = pathlib.Path(find_program(program)).resolve().parent.parent
    for stick in (root / "stick", root / "share/openr-host/stick"):
        file = stick / "OPEN-R/MW/DATA/P" / name
        if file.is_file():
            return file
    raise Error(f"the default stick has no motion {name}")
