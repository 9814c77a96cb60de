"""The commands of openr serve, a method for each.

Made by tools/python_commands.py of openr/serve/command_table.cc.  Do not change it by hand.
"""
from __future__ import annotations

import json
from typing import Any, Sequence

from ._channel import Channel

Answer = tuple[dict[str, Any], bytes]


class Commands:
    """Asks the process of a run.  Each method returns the members of the answer and its further bytes."""

    def __init__(self, channel: Channel) -> None:
        self.channel = channel

    def ask(self, name: str, parameters: dict[str, Any], data: bytes = b"") -> Answer:
        return self.channel.ask(json.dumps({"do": name, **parameters}).encode(), data)

    def start(
            self, *,
            stick: str = '',
            robot: str = 'ers210',
            world: str = '',
            body: str = 'ode',
            seed: int = 1,
            robots: int = 1,
            together: bool = False,
            battery: str = 'drain',
            images: str = 'world',
            cost: str = '',
            strict: bool = False,
            network: str = 'inside',
            rc_port: int = 0,
            writable: bool = True,
            record: str = '',
            payloads: bool = True,
            log: str = 'info',
            echo: bool = False,
            handler_limit_s: float = 10.0,
    ) -> Answer:
        """Makes the run, ready to boot.

        stick: folder that holds OPEN-R; without it the default stick.
        robot: model: ers210, ers220 or ers7.
        world: world file.
        body: ode: physics; ideal: joints follow exactly.
        seed: seed of the run.
        robots: number of robots.
        together: all robots are in one world.
        battery: drain, 100% or N%.
        images: what cameras see: world, pattern or a folder.
        cost: cost file of handlers.
        strict: enforce the limits of the robot.
        network: inside: connections are made by connect; host: by sockets of this computer.
        rc_port: with network host: port of the remote control, 0: any free one.
        writable: objects may write to the stick.
        record: file of a recording.
        payloads: the recording has the bytes of messages.
        log: log lines of objects that are kept: error, warning, info.
        echo: print on standard error what objects print.
        handler_limit_s: processor time after which a handler ends the run; 0: never.
        Answers model: text, joints, sensors, leds: texts, limits: for each joint [min, max, speed]
        in degrees.
        """
        return self.ask("start", {
            "stick": stick,
            "robot": robot,
            "world": world,
            "body": body,
            "seed": seed,
            "robots": robots,
            "together": together,
            "battery": battery,
            "images": images,
            "cost": cost,
            "strict": strict,
            "network": network,
            "rc_port": rc_port,
            "writable": writable,
            "record": record,
            "payloads": payloads,
            "log": log,
            "echo": echo,
            "handler_limit_s": handler_limit_s,
        })

    def boot(self) -> Answer:
        """Begins the boot: DoInit and DoStart of all objects follow.

        Answers time_s: number.
        """
        return self.ask("boot", {})

    def run(self, *, for_s: float = 0.0, to_s: float = -1.0) -> Answer:
        """Runs for a time, or to a time.

        for_s: virtual time.
        to_s: virtual time to run to; -1: for_s says how long.
        Answers time_s: number.
        """
        return self.ask("run", {"for_s": for_s, "to_s": to_s})

    def step(self, *, over: str = 'frame', count: int = 1) -> Answer:
        """Runs over messages, to the ends of frames of 8 ms, or over sensor vectors.

        over: message, frame or vector.
        count: how many.
        Answers time_s: number.
        """
        return self.ask("step", {"over": over, "count": count})

    def until(self, *, condition: str, within_s: float) -> Answer:
        """Runs until a comparison holds at the end of a frame.

        condition: QUANTITY OP VALUE, as in docs/exploring.md.
        within_s: the longest virtual time.
        Answers time_s: number, met: flag.
        """
        return self.ask("until", {"condition": condition, "within_s": within_s})

    def expect(
            self, *,
            kind: str = '',
            sender: str = '',
            receiver: str = '',
            entry: str = '',
            within_s: float,
    ) -> Answer:
        """Runs until a message that fits has been handled.

        kind: notify, ready, not ready, reply or other; empty: any.
        sender: object or service of the sender; empty: any.
        receiver: object or service of the receiver; empty: any.
        entry: name of the receiver's handler; empty: any.
        within_s: the longest virtual time.
        Answers time_s: number, met: flag, message: its number, cause, time_s, kind, from, to,
        entry, text (content in words); bytes: its content.
        """
        return self.ask("expect", {
            "kind": kind,
            "sender": sender,
            "receiver": receiver,
            "entry": entry,
            "within_s": within_s,
        })

    def watch(
            self, *,
            kind: str = '',
            sender: str = '',
            receiver: str = '',
            entry: str = '',
    ) -> Answer:
        """Keeps messages that fit from now on.

        kind: as in expect.
        sender: as in expect.
        receiver: as in expect.
        entry: as in expect.
        Answers time_s: number.
        """
        return self.ask("watch", {
            "kind": kind,
            "sender": sender,
            "receiver": receiver,
            "entry": entry,
        })

    def watched(self) -> Answer:
        """Takes the messages that were kept, at most the last 10,000, with at most 64 MiB.

        Answers messages: as in expect, each with size; lost: integer, those that gave way since the
        start; bytes: their contents.
        """
        return self.ask("watched", {})

    def observe(self, *, names: Sequence[str] = ()) -> Answer:
        """Chooses the values that act and observe answer, and answers them.

        names: quantities and groups; empty: those chosen before.
        Answers names: texts, where they were chosen; bytes: numbers.
        """
        return self.ask("observe", {"names": list(names)})

    def actuate(self, *, names: Sequence[str]) -> Answer:
        """Chooses the joints whose set points act has.

        names: joints; empty: all.
        Answers names: texts.
        """
        return self.ask("actuate", {"names": list(names)})

    def act(self, *, frames: int = 4, ramp: bool = True, data: bytes = b"") -> Answer:
        """Gives the chosen joints set points, runs some frames, and answers the chosen values. Without
        set points the joints keep theirs.

        data: set points in degrees, one for each chosen joint
        frames: frames of 8 ms.
        ramp: set points move evenly in these frames; else they jump.
        Answers time_s: number; bytes: numbers.
        """
        return self.ask("act", {"frames": frames, "ramp": ramp}, data)

    def input(self, *, line: str, robot: int = 0) -> Answer:
        """Gives the run an input (docs/inputs.md) for the next frame boundary.

        line: press chin for 300ms.
        robot: number of the robot.
        Answers time_s: number.
        """
        return self.ask("input", {"line": line, "robot": robot})

    def inputs(self, *, robot: int = 0) -> Answer:
        """Lists the inputs that the run knows.

        robot: number of the robot.
        Answers inputs: usage and help of each.
        """
        return self.ask("inputs", {"robot": robot})

    def connect(self, *, port: int, robot: int = 0) -> Answer:
        """Connects to a TCP port of a robot.

        port: 54000 is the remote control.
        robot: number of the robot.
        Answers connection: integer.
        """
        return self.ask("connect", {"port": port, "robot": robot})

    def send(self, *, connection: int, data: bytes = b"") -> Answer:
        """Sends bytes to the robot.

        data: what to send
        connection: the number that connect answered.
        Answers time_s: number.
        """
        return self.ask("send", {"connection": connection}, data)

    def receive(self, *, connection: int, count: int = 0, within_s: float = 1.0) -> Answer:
        """Takes bytes that the robot has sent; runs until so many are there.

        connection: the number that connect answered.
        count: bytes to wait for; 0: takes those that are there.
        within_s: the longest virtual time to wait.
        Answers time_s: number, open: flag; bytes: what came.
        """
        return self.ask("receive", {"connection": connection, "count": count, "within_s": within_s})

    def disconnect(self, *, connection: int) -> Answer:
        """Closes a connection.

        connection: the number that connect answered.
        Answers time_s: number.
        """
        return self.ask("disconnect", {"connection": connection})

    def read(self, *, names: Sequence[str]) -> Answer:
        """Reads values by their names.

        names: quantities and groups; texts are allowed.
        Answers values: by name.
        """
        return self.ask("read", {"names": list(names)})

    def motion(self, *, csv: str, name: str = 'motion') -> Answer:
        """Makes a motion file (MTN); needs no run.

        csv: its key frames, as openr mtn dump prints them.
        name: name of the motion in the file.
        Answers bytes: the file.
        """
        return self.ask("motion", {"csv": csv, "name": name})

    def status(self) -> Answer:
        """Time, robots, messages, who waits.

        Answers as in docs/inputs.md.
        """
        return self.ask("status", {})

    def objects(self) -> Answer:
        """The objects with their states.

        Answers objects.
        """
        return self.ask("objects", {})

    def object(self, *, name: str, robot: int = 0) -> Answer:
        """An object with its services and connections.

        name: name of the object.
        robot: number of the robot.
        Answers subjects, observers, findings.
        """
        return self.ask("object", {"name": name, "robot": robot})

    def sensors(self, *, robot: int = 0) -> Answer:
        """The sensors by name, in OPEN-R's units.

        robot: number of the robot.
        Answers sensors.
        """
        return self.ask("sensors", {"robot": robot})

    def joints(self, *, robot: int = 0) -> Answer:
        """The joints: measured and commanded angle.

        robot: number of the robot.
        Answers joints.
        """
        return self.ask("joints", {"robot": robot})

    def findings(self) -> Answer:
        """Errors, warnings and notes about programs.

        Answers findings.
        """
        return self.ask("findings", {})

    def hashes(self) -> Answer:
        """Hashes of messages and state.

        Answers trace_hash, state_hash: texts.
        """
        return self.ask("hashes", {})

    def console(self, *, first: int = 0) -> Answer:
        """What objects have printed: the last 1000 lines.

        first: number of the first line wanted.
        Answers first, next: integers, lines: texts.
        """
        return self.ask("console", {"first": first})

    def camera(self, *, layer: str = 'picture', robot: int = 0) -> Answer:
        """The picture of a robot's camera.

        layer: picture or colour.
        robot: number of the robot.
        Answers width, height: integers, png: Base64.
        """
        return self.ask("camera", {"layer": layer, "robot": robot})

    def picture(
            self, *,
            file: str,
            view: str = 'iso',
            size: str = '1280x720',
            robot: int = 0,
    ) -> Answer:
        """Writes a picture of the robot to a PNG file.

        file: the file.
        view: iso, side, front, top, follow, world or camera.
        size: width and height.
        robot: number of the robot.
        Answers time_s: number.
        """
        return self.ask("picture", {"file": file, "view": view, "size": size, "robot": robot})

    def report(self) -> Answer:
        """The report, as openr run writes it.

        Answers docs/cli.md, The report.
        """
        return self.ask("report", {})

    def finish(self) -> Answer:
        """Ends the run, and completes its recording. The run can be read still, but not go on.

        Answers the report.
        """
        return self.ask("finish", {})
