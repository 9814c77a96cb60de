#!/usr/bin/env python3
"""tools/stress.py: which runs on the quiet machine are good, and how many refusals pass.  The last line is
"N passed, N failed"."""
import contextlib
import io
import random
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import stress  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

GOOD = stress.Outcome("equal", "")
BAD = stress.Outcome("the client fails: OSError()", "")
REFUSED = stress.Outcome("", "process 'probe' did not join")


class Program:
    """A program with these outcomes, one after the other."""

    name = "pretended"
    good = stress.Live.good

    def __init__(self, outcomes):
        self.outcomes = iter(outcomes)

    def outcome(self, seed, apart, dice):
        return next(self.outcomes), 1


def told(quiet, *busy):
    """Returns what Tally.tell() says of a program with these outcomes on the quiet and on the busy machine."""
    said = []
    tally = stress.Tally(Program([quiet, *busy]), 1)
    tally.note_quiet()
    for number in range(len(busy) // 2):
        tally.play(number, random.Random(1))
    kept, stress.verdict = stress.verdict, lambda name, good, why="": said.append((name, bool(good)))
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            tally.tell()
    finally:
        stress.verdict = kept
    return [name for name, good in said if not good]


def check(name, failed, *wanted):
    verdict(name, len(failed) == len(wanted) and all(map(str.__contains__, failed, wanted)), failed)


def main():
    check("equal runs are good", told(GOOD, GOOD, GOOD))
    check("a run that differs is a failure", told(GOOD, GOOD, BAD), "without difference")
    check("a client that fails each time is a failure", told(BAD, BAD, BAD), "on the quiet machine are good")
    check("a quiet run that is refused is a failure", told(REFUSED, GOOD, GOOD), "on the quiet machine",
          "without difference")
    check("some refusals may be", told(GOOD, REFUSED, *[GOOD] * 99))
    check("many refusals are a failure", told(GOOD, *[REFUSED] * 3, *[GOOD] * 97), "are refused")
    check("a program that is only refused is a failure", told(GOOD, REFUSED, REFUSED), "are refused",
          "without difference")
    for kind, good, *bad in (
            (stress.Stick, "status 0, trace 1a state 2b of 30 messages, findings []",
             "status 1, trace 1a state 2b of 30 messages, findings ['a crash']", "status 1, no report: ",
             "status 0, trace 1a state 2b of 0 messages, findings []"),
            (stress.Suite, "all tests pass", "status 1, 20 results, failed []\n", "status 0, 0 results, failed []\n"),
            (stress.Exploration, "digest 1a, 0 differences, 0 depend on addresses, 0 broken",
             "digest 1a, 10 differences, 0 depend on addresses, 0 broken", "no result: "),
            (stress.Live, "equal", "the client fails: OSError()", "")):
        verdict(f"{kind.__name__}: a good run", re.match(kind.good, good))
        for text in bad:
            verdict(f"{kind.__name__}: a bad run", not re.match(kind.good, text), text)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
