#!/usr/bin/env python3
"""Both dogs: a page and `openr rc` with a second `openr run`, over links that are slow, lose packets,
stand still or break.

Nothing here asserts wall time.  The first run is recorded and replayed afterwards: all that came
from the second robot is recorded input, so the replay must have equal hashes.  The last line is "N
passed, N failed".
"""
import argparse
import base64
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from link import Link  # noqa: E402
from page import PATIENCE_S, Page, Run, private_runs  # noqa: E402

RATE = 2.0  # rate of the first run while no second robot is connected


def need(is_good, what):
    if not is_good:
        raise AssertionError(what)


class Dogs:
    """Two runs, a page of the first one, and a link to the second one."""

    def __init__(self, openr, folder):
        private_runs(folder)
        self.openr, self.folder = openr, folder
        self.recording = folder / "first.rec"
        self.first = Run(openr, "first", "--rate", str(RATE), "--record", str(self.recording))
        self.second = Run(openr, "second", panel=False)
        for run in self.first, self.second:
            run.need("state: accepting-commands")
        host, port = self.second.robot.split(":")
        self.link = Link((host, int(port)))
        self.page = Page(self.first.url)

    def connect(self, **more):
        answer = self.page.pair("connect", endpoint=self.link.address, **more)
        need("error" not in answer, f"not connected: {answer}")
        return answer

    def disconnect(self):
        self.page.pair("disconnect")
        self.page.wait_for("pair", lambda e: e["state"] == "closed", "the pair does not end")

    def begin_anew(self):
        """Undoes what a test has left that has failed."""
        self.page.close()
        self.page = Page(self.first.url)
        self.set_link()
        self.page.ask({"do": "clock", "pause": False})
        for _ in range(1000):
            if self.rate() == RATE:
                return

    def rate(self):
        return self.page.ask({"do": "clock"})["rate"]

    def set_link(self, delay_ms=0, loss=0.0):
        self.link.set(delay_s=delay_ms / 1000, loss=loss, is_stopped=False, is_cut=False)

    def angle(self, run, joint):
        return run.rc("get", joint)[0]["position_deg"]

    def move(self, endpoint, joint, deg):
        answer = self.page.rc("move", endpoint, joint=joint, deg=deg)
        need(answer.get("value") == deg, f"{joint} does not move: {answer}")

    def wait_for_angles(self, joint, deg):
        """Waits until both dogs have the joint near `deg`, by the event of the page."""
        index = [j["name"] for j in self.page.rc("connect")["joints"]].index(joint)
        self.page.wait_for("pair", lambda e: e.get("deg") and abs(e["deg"][index] - deg) < 2,
                           f"{joint} of the robot does not come to {deg}")
        for _ in range(1000):
            if abs(self.angle(self.first, joint) - deg) < 2:
                return
        raise AssertionError(f"{joint} of the simulation does not come to {deg}")


def refuses_what_cannot_be(dogs):
    for endpoint, why in ((dogs.first.robot, "remote control of this run itself"),
                          ("127.0.0.1:1", "no program listens there"),
                          ("no host:1", "HOST:PORT"), ("x" * 300, "HOST:PORT"),
                          ("127.0.0.1:99999", "no port from 1 to 65535")):
        answer = dogs.page.pair("connect", endpoint=endpoint)
        need(why in answer.get("error", ""), f"{endpoint}: {answer}")
    for call in "set", "disconnect":
        need("no second robot" in dogs.page.pair(call)["error"], f"{call} without a robot")
    need(dogs.rate() == RATE, "the rate has changed")


def refuses_another_model(dogs):
    other = Run(dogs.openr, "other", "--robot", "ers220", panel=False)
    try:
        answer = dogs.page.pair("connect", endpoint=other.robot)
        need("ERS-220" in answer["error"] and "ERS-210" in answer["error"], str(answer))
    finally:
        other.end()


def bears_garbage(dogs):
    def serve(listener, text):
        connection, _ = listener.accept()
        with connection:
            connection.sendall(text)
            connection.recv(1000)

    half = b"RC" + (1024).to_bytes(2, "little") + b"\x02\x01\x01\x00"
    for text in b"HTTP/1.1 400 Bad Request\r\n\r\n", bytes(range(256)) * 40, b"RC\xff\xff", half:
        with socket.create_server(("127.0.0.1", 0)) as listener:
            threading.Thread(target=serve, args=(listener, text), daemon=True).start()
            endpoint = "127.0.0.1:%d" % listener.getsockname()[1]
            need("error" in dogs.page.pair("connect", endpoint=endpoint), "garbage is no robot")
    need("runs" in dogs.page.ask({"do": "runs"}), "the server does not answer any more")


def takes_limits_and_real_time(dogs):
    dogs.second.rc("speed", "neck_pan", "77")
    dogs.second.rc("accel", "neck_pan", "99")
    light = "Tail light (blue)"  # the controller of the default stick leaves it alone
    index = [led["name"] for led in dogs.page.rc("connect")["leds"]].index(light)
    dogs.first.rc("led", light, "on")
    dogs.page.ask({"do": "watch", "events": ["pose"]})
    dogs.page.wait_for("pose", lambda e: e["robots"][0]["leds"][index] == 1,
                       "the light is not on")
    answer = dogs.connect()
    dogs.page.wait_for("pose", lambda e: e["robots"][0]["leds"][index] == 0,
                       "the light stays on")
    dogs.first.rc("led", light, "on")
    need(answer["first_time"] and answer["model"] == "ERS-210", str(answer))
    pan = next(j for j in answer["joints"] if j["name"] == "neck_pan")
    need((pan["speed"], pan["accel"]) == (77, 99), f"limits of the robot: {pan}")
    limits = dogs.first.rc("get", "neck_pan")[0]
    need((limits["speed_deg_s"], limits["acceleration_deg_s2"]) == (77, 99), f"of the simulation: {limits}")
    need(dogs.rate() == 1, "the run does not go on in real time")
    refused = dogs.page.ask({"do": "rewind", "back_s": 1})
    need("cannot go back" in refused.get("error", ""), f"going back: {refused}")
    clock = dogs.page.ask({"do": "clock"})
    need(not clock["rewind"]["possible"] and dogs.link.address in clock["rewind"]["why"], str(clock))
    need("already" in dogs.page.pair("connect", endpoint="127.0.0.1:1")["error"], "a second pair")
    other = Page(dogs.first.url)
    need("another page" in other.pair("connect", endpoint=dogs.link.address)["error"], "two pages")
    other.close()
    dogs.disconnect()
    need(dogs.rate() == RATE, "the rate before does not come back")
    need(dogs.page.ask({"do": "clock"})["rewind"]["why"] == "", "the run still cannot go back")
    need(not dogs.connect()["first_time"], "it is the first time again")
    dogs.page.rc("sensors")
    dogs.page.wait_for("pair", lambda e: e["state"] == "connected", "the pair is lost")
    pose = dogs.page.wait_for("pose", lambda e: True, "no pose comes")
    need(pose["robots"][0]["leds"][index] == 1, "lights are reset again")
    dogs.page.ask({"do": "watch", "events": []})
    dogs.disconnect()


def ends_with_its_page(dogs):
    other = Page(dogs.first.url)
    need("error" not in other.pair("connect", endpoint=dogs.link.address), "not connected")
    need(dogs.rate() == 1, "the run does not go on in real time")
    other.close()
    dogs.page.ask({"do": "watch", "events": ["clock"]})
    dogs.page.wait_for("clock", lambda e: e["rate"] == RATE, "the rate before does not come back")
    dogs.page.ask({"do": "watch", "events": []})


def keeps_a_rate_that_a_person_has_chosen(dogs):
    dogs.connect()
    dogs.page.ask({"do": "clock", "rate": 0.5})
    dogs.disconnect()
    need(dogs.rate() == 0.5, "the chosen rate is gone")
    dogs.page.ask({"do": "clock", "rate": RATE})


def follows_in_both_directions(dogs, delay_ms, loss):
    dogs.set_link(delay_ms, loss)
    for run in dogs.first, dogs.second:
        run.rc("speed", "neck_pan", "170")
        run.rc("accel", "neck_pan", "300")
    dogs.connect()
    for follow, leader, deg in (("simulation", dogs.second.robot, 40), ("robot", "run", -35)):
        need("error" not in dogs.page.pair("set", follow=follow), "cannot follow")
        dogs.page.wait_for("pair", lambda e: e["follow"] == follow, "it does not follow")
        dogs.move(leader, "neck_pan", deg)
        dogs.wait_for_angles("neck_pan", deg)
        # The lag needs some movement.  It is at least one way of the link.
        dogs.move(leader, "neck_pan", 0)
        lag = dogs.page.wait_for("pair", lambda e: e["lag_ms"] is not None, "no lag is measured")
        need(lag["lag_ms"] >= delay_ms * 0.5, f"the lag is {lag['lag_ms']} ms")
        dogs.wait_for_angles("neck_pan", 0)
        # A server that has waited for a processor takes an old time for that of the answer.
        dogs.page.wait_for("pair", lambda e: (e["round_trip_ms"] or 0) >= 2 * delay_ms - 1,
                           "no round trip is as long as the link")
    refused = dogs.page.pair("set", follow="simulation", simulation=False)
    need("not controlled" in refused.get("error", ""), f"follows without control: {refused}")
    dogs.disconnect()


def limits_of(run):
    return [(j["speed_deg_s"], j["acceleration_deg_s2"])
            for j in (run.rc("get", str(i))[0] for i in range(18))]


def plays_on_both(dogs):
    dogs.set_link(20)
    dogs.connect()
    before = limits_of(dogs.first)
    answer = dogs.page.rc("play", dogs.link.address, name="WALK.MTN", loops=4)
    need(answer.get("loops") == 4, f"the robot does not play: {answer}")
    # Few key frames are enough: a server that waits for a processor follows only some of them.
    event = dogs.page.wait_for("pair", lambda e: e["motion"] == "WALK.MTN" and e["key_frames"] > 5,
                               "no key frames come")
    need(event["refusal"]["simulation"] == "", f"the simulation refuses: {event}")
    need(dogs.first.rc("sensors")[0]["state"] == "accepting-commands", "the simulation plays itself")
    seen = [dogs.angle(dogs.first, "LF_j1") for _ in range(20)]
    need(max(seen) - min(seen) > 5, f"the leg of the simulation stays where it is: {seen}")
    need(limits_of(dogs.first) == before, "limits have changed while a motion plays")
    done = dogs.page.wait_for("pair", lambda e: e["motion"] == "" and e["robot_state"] ==
                              "accepting-commands", "the motion does not end")
    need(done["key_frames"] > event["key_frames"],
         f"no key frame was followed after the first {event['key_frames']}")
    need(limits_of(dogs.first) == before, "limits have changed after a motion")
    # Without the box, the simulation stays where it is.
    need("error" not in dogs.page.pair("set", simulation=False), "the box")
    dogs.page.rc("play", dogs.link.address, name="BOW.MTN", loops=1)
    dogs.page.wait_for("pair", lambda e: e["motion"] == "BOW.MTN", "BOW.MTN does not begin")
    last = dogs.page.wait_for("pair", lambda e: e["motion"] == "" and e["robot_state"] ==
                              "accepting-commands", "BOW.MTN does not end")
    need(last["key_frames"] == done["key_frames"], "the simulation was sent key frames")
    dogs.disconnect()


def plays_a_local_file(dogs):
    motion = next(pathlib.Path(dogs.openr).parent.parent.glob("stick/OPEN-R/MW/DATA/P/BOW.MTN"))
    before = dogs.page.rc("motions")["motions"]
    dogs.connect()
    answer = dogs.page.rc("upload", kind="motion", name="MINE.MTN", loops=1,
                          data=base64.b64encode(motion.read_bytes()).decode())
    need(answer.get("loops") == 1, f"the file is not played: {answer}")
    need(dogs.page.rc("motions")["motions"] == before, "the file is still on the simulated stick")
    need(dogs.page.rc("motions", dogs.link.address)["motions"] == before, "the robot got the file")
    need(dogs.first.rc("sensors")[0]["state"] in ("mtn", "prepare-mtn"), "nothing plays")
    dogs.page.rc("stop")
    dogs.disconnect()


def loses_the_connection_in_a_motion(dogs):
    dogs.set_link(20)
    dogs.connect()
    before = limits_of(dogs.first)
    dogs.page.rc("play", dogs.link.address, name="WALK.MTN", loops=50)
    dogs.page.wait_for("pair", lambda e: e.get("key_frames", 0) > 10, "no key frames come")
    dogs.link.cut()
    lost = dogs.page.wait_for("pair", lambda e: e["state"] == "lost", "the loss is not noticed")
    need(dogs.link.address in lost["why"], f"no reason: {lost}")
    need(dogs.rate() == RATE, "the rate before does not come back")
    need(limits_of(dogs.first) == before, "limits have changed")
    dogs.move("run", "neck_pan", 10)
    dogs.second.rc("mtn", "stop")


def a_stop_is_a_loss(dogs):
    dogs.set_link(20)
    dogs.connect()
    dogs.page.pair("set", follow="robot")
    dogs.link.set(is_stopped=True)
    before = dogs.page.ask({"do": "status"})["time_s"]
    for i in range(20):
        dogs.page.rc("move", joint="neck_pan", deg=(-1) ** i * 20)
    lost = dogs.page.wait_for("pair", lambda e: e["state"] == "lost", "the stop is not noticed")
    need("silent" in lost["why"], f"no reason: {lost}")
    # The run has gone on all the time: 3 s of silence are about as much virtual time.
    need(dogs.page.ask({"do": "status"})["time_s"] > before + 1, "the run stood still")
    dogs.link.cut()
    dogs.set_link()


def a_pause_of_the_run_is_no_loss(dogs):
    dogs.set_link()
    dogs.connect()
    dogs.page.pair("set", follow="simulation")
    dogs.page.ask({"do": "clock", "pause": True})
    for i in range(25):  # 5 s of events
        dogs.page.wait_for("pair", lambda e: e["state"] == "connected", "the pair is lost")
    dogs.page.ask({"do": "clock", "pause": False})
    dogs.move(dogs.second.robot, "neck_pan", 25)
    dogs.wait_for_angles("neck_pan", 25)
    dogs.disconnect()


def rc_acts_at_both(dogs):
    answers = dogs.first.rc("--with", dogs.second.robot, "move", "neck_pan", "-15")
    need({a["robot"] for a in answers} == {dogs.first.robot, dogs.second.robot}, str(answers))
    for run in dogs.first, dogs.second:
        need(any(abs(dogs.angle(run, "neck_pan") + 15) < 2 for _ in range(1000)), "it did not move")
    try:
        dogs.first.rc("--with", "127.0.0.1:1", "move", "neck_pan", "0")
        raise AssertionError("a second robot that is not there is no error")
    except RuntimeError as error:
        need("no program listens there" in str(error), str(error))


def rc_follows(dogs):
    dogs.set_link(50, 0.02)
    rc = subprocess.Popen([dogs.openr, "rc", dogs.first.robot, "--json", "follow", dogs.link.address,
                           "--track"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        rc.stdout.readline()
        dogs.second.rc("move", "neck_pan", "30")
        need(any(abs(dogs.angle(dogs.first, "neck_pan") - 30) < 2 for _ in range(1000)),
             "the first robot does not follow")
    finally:
        rc.send_signal(signal.SIGINT)
        rest, said = rc.communicate(timeout=PATIENCE_S)
    need(rc.returncode == 0, f"openr rc follow: {said}")
    need("lag_ms" in rest or rest == "", rest)


TESTS = [
    ("what cannot be is refused with the reason", refuses_what_cannot_be),
    ("another model is refused", refuses_another_model),
    ("garbage does not break the server", bears_garbage),
    ("limits and real time while connected", takes_limits_and_real_time),
    ("the pair ends with its page", ends_with_its_page),
    ("a rate that a person has chosen stays", keeps_a_rate_that_a_person_has_chosen),
    ("5 ms: each follows the other", lambda dogs: follows_in_both_directions(dogs, 5, 0)),
    ("50 ms, 2 % loss: each follows the other", lambda dogs: follows_in_both_directions(dogs, 50, 0.02)),
    ("200 ms: each follows the other", lambda dogs: follows_in_both_directions(dogs, 200, 0)),
    ("a motion plays on both", plays_on_both),
    ("a local file plays in the simulation only", plays_a_local_file),
    ("the connection is lost in a motion", loses_the_connection_in_a_motion),
    ("a link that stands still is a loss", a_stop_is_a_loss),
    ("a pause of the run is no loss", a_pause_of_the_run_is_no_loss),
    ("openr rc --with acts at both", rc_acts_at_both),
    ("openr rc follow", rc_follows),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--filter", default="", help="only tests whose names contain this")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    if not (build / "lib/libopenr_panel.so").exists():
        print("skipped: the panel's server is not built (Debian package libwebsockets-dev)")
        print("0 passed, 0 failed, 1 skipped")
        return 0
    passed = failed = 0

    def take(name, test):
        nonlocal passed, failed
        try:
            test()
            passed += 1
            print(f"ok      {name}", flush=True)
        except Exception:  # pylint: disable=broad-except
            failed += 1
            print(f"FAILED  {name}\n{traceback.format_exc()}", flush=True)

    with tempfile.TemporaryDirectory(prefix="openr-both-") as folder:
        dogs = Dogs(str(build / "bin/openr"), pathlib.Path(folder))
        for name, test in TESTS:
            if arguments.filter in name:
                dogs.begin_anew()
                take(name, lambda: test(dogs))
        take("both runs end well", lambda: need(
            (dogs.first.end(), dogs.second.end()) == (0, 0), "".join(dogs.first.said)))
        replay = subprocess.run([dogs.openr, "replay", str(dogs.recording)], capture_output=True,
                                text=True, timeout=PATIENCE_S, check=False)
        take("the recording replays with equal hashes", lambda: need(
            replay.returncode == 0, replay.stdout + replay.stderr))
    print(f"{passed} passed, {failed} failed")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
