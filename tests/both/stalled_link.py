#!/usr/bin/env python3
"""Measures whether a second robot delays a run: its speed while the link stands still, and while it
works, as a share of the speed without a second robot, in one run.

    tests/both/stalled_link.py --build build/release [--rounds 5] [--rate 0]

A page is connected, and the second robot follows the simulation.  --rate 0 is as fast as possible,
where a delay would show most.  A measurement for docs/panel-server.md, and no test.
"""
import argparse
import pathlib
import statistics
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from link import Link  # noqa: E402
from page import Page, Run, private_runs  # noqa: E402

PHASE_S = 2.0  # shorter than the 3 s of silence after which a robot counts as lost
SETTLE_S = 0.3


def speed(page):
    """Virtual seconds per second, for PHASE_S."""
    time.sleep(SETTLE_S)
    begin, virtual = time.monotonic(), page.ask({"do": "status"})["time_s"]
    time.sleep(PHASE_S)
    passed, now = time.monotonic() - begin, page.ask({"do": "status"})["time_s"]
    return (now - virtual) / passed


def measure(page, link, rate):
    """Speeds without a second robot, with one, and with one behind a link that stands still."""
    page.ask({"do": "clock", "rate": rate})
    without = speed(page)
    link.set(is_cut=False, is_stopped=False)
    answer = page.pair("connect", endpoint=link.address)
    if "error" in answer:
        sys.exit(answer["error"])
    page.pair("set", follow="robot")
    page.ask({"do": "clock", "rate": rate})
    connected = speed(page)
    link.set(is_stopped=True)
    stalled = speed(page)
    link.cut()
    page.wait_for("pair", lambda e: e["state"] == "lost", "the stop is not noticed")
    return without, connected, stalled


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--rate", type=float, default=0)
    arguments = parser.parse_args()
    openr = str(arguments.build.resolve() / "bin/openr")
    with tempfile.TemporaryDirectory(prefix="openr-both-") as folder:
        private_runs(folder)
        first, second = Run(openr, "first"), Run(openr, "second", panel=False)
        for run in first, second:
            run.need("state: accepting-commands")
        host, port = second.robot.split(":")
        link, page = Link((host, int(port)), delay_ms=20), Page(first.url)
        rounds = [measure(page, link, arguments.rate) for _ in range(arguments.rounds)]
        first.end()
        second.end()
    for name, index in ("a link that works", 1), ("a link that stands still", 2):
        shares = [round_[index] / round_[0] for round_ in rounds]
        print(f"{name}: {statistics.median(shares):.3f} of the speed without a second robot "
              f"({min(shares):.3f} to {max(shares):.3f})")
    print(f"without: {statistics.median(r[0] for r in rounds):.2f} virtual seconds per second")


if __name__ == "__main__":
    main()
