#!/usr/bin/env python3
"""tools/soak.py and its clients: when a client begins a motion, and which findings fail a soak.  The last line is
"N passed, N failed"."""
import struct
import sys
import types
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import remote_load as load  # noqa: E402
import remote_run as rc  # noqa: E402
import soak  # noqa: E402
import soak_clients  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

FIRST = dict.fromkeys([*soak_clients.HEAD, *soak_clients.LEGS], 0.0)


def far(**degrees):
    """Returns far_joints() of a robot whose joints j0, j1 and so on are at these angles, the others at 0."""
    return soak_clients.far_joints([degrees.get(f"j{joint}", 0.0) for joint in range(18)], FIRST)


def finding(text, where="JointMover", severity="warning"):
    return {"text": text, "object": where, "severity": severity}


JUMP = finding("PRM:/r1/c1-Joint2:j1: set point jumps from -43.4 to -0.0 degrees in one frame")
PRESSED = finding("PRM:/r4/c1: MECHA_LOAD_HIGH", "the robot", "error")


class Pretended(soak_clients.Clients):
    """Clients of a robot that answers SENSORS with the `looks`, one after the other.

    A look is (state, angle of neck_pan) or (state, angle of neck_pan, angle of LH_j1).
    """

    def __init__(self, looks):
        self.looks, self.asked = iter(looks), []
        self.counts = dict.fromkeys(["motions", "motions given up"], 0)
        self.first = {"WALK.MTN": FIRST}
        self.is_beginning = False

    def ask(self, client, *requests, statuses=()):
        self.asked += [request[0] for request in requests]
        yield
        if requests[0][0] != rc.SENSORS:
            return [types.SimpleNamespace(status=rc.STATUS_OK)] * len(requests)
        state, neck, *leg = next(self.looks)
        joints = struct.pack("<18i", 0, 100 * neck, *[0] * 5, 100 * sum(leg), *[0] * 10)
        return [types.SimpleNamespace(status=rc.STATUS_OK, payload=bytes([18, 6, 7, 2, 1, state, 0, 0]) + joints)]


def plays(name, looks, moves, does_play):
    """Checks how often a client moves joints, and whether it plays."""
    clients = Pretended(looks)
    for _ in clients.play(None, "WALK.MTN", "WALK.MTN"):
        pass
    verdict(name, (clients.asked.count(rc.MOVE), clients.asked.count(rc.MTN_PLAY), clients.is_beginning)
            == (moves, does_play, False), clients.asked)


def main():
    verdict("a robot in the first key frame may begin", far() == [])
    verdict("joints that are a little away do not matter", far(j1=27, j7=-27) == [])
    verdict("a joint from which the set point would jump is far", far(j1=40, j7=-40) == [1, 7])
    verdict("a head that is further away is far as well, because it may move", far(j1=60) == [1])
    verdict("with a leg that is further away JointMover prepares the motion", far(j1=40, j7=60) == [])
    ready, busy = rc.READY, rc.READY + 2
    good = [(ready, 0)] * 4
    plays("a client plays after four good looks at a robot that was still", [(ready, 0), *good], 0, 1)
    plays("a client moves a joint that is far, and waits",
          [(ready, 40), (ready, 40), (ready, 30), *[(ready, 20)] * 4], 2, 1)
    plays("a client waits for the end of a motion", [(busy, 40), *good], 0, 1)
    plays("a joint that is turned does not count as near", [*good, (ready, 40), *good], 1, 1)
    plays("a leg that is on its way does not count as far away",
          [(ready, 0, 60), (ready, 0, 58), (ready, 0, 54), (ready, 0, 48), *[(ready, 0, 20)] * 5], 0, 1)
    plays("a client moves nothing while a leg is on its way", [(ready, 40, 10), (ready, 40, 5), (ready, 0, 0), *good],
          0, 1)
    plays("a client gives up", [(busy, 0)] * soak_clients.LOOKS_MAX, 0, 0)
    for joint, (low, high) in load.NEAR_ANGLES.items():
        verdict(f"commands keep joint {joint} near the first key frames",
                joint not in soak_clients.HEAD or max(-low, high) < soak_clients.NEAR_DEG)
    verdict("the ideal body has no finding",
            not soak.is_expected(JUMP, "ideal") and not soak.is_expected(PRESSED, "ideal"))
    verdict("the physical body may have fallen", soak.is_expected(JUMP, "ode") and soak.is_expected(PRESSED, "ode"))
    verdict("the physical body may have no other finding", not soak.is_expected(finding("a leak"), "ode"))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
