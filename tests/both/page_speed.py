#!/usr/bin/env python3
"""Measures how much a page that reads all events slows down a run at full speed.

    page_speed.py --build DIR [--seconds S] [--rounds N]

Runs the default stick on the body with physics for S seconds of virtual time, with a panel that
nobody has opened and with a page that watches poses, values, graph and clock, by turns.  Prints the
speed with the page as a share of the speed without it, and the median of all rounds.
"""
import argparse
import pathlib
import re
import statistics
import time

from page import Page, Run

EVENTS = ["pose", "values", "graph", "clock"]


def duration(openr, seconds, has_page):
    """The wall time of a run, in seconds, and the poses that its page got."""
    run = Run(openr, f"page-speed-{time.monotonic_ns()}", "--rate", "max", "--for", f"{seconds}s")
    poses = 0
    if has_page:
        page = Page(run.url)
        page.send({"do": "watch", "period_ms": 16, "events": EVENTS})
        try:
            while True:
                poses += page.message().get("event") == "pose"
        except RuntimeError:  # the run has ended, and the server has closed the page
            page.close()
    run.process.wait()
    return float(run.need(r"in ([\d.]+) s, [\d.]+ x real time")[1]), poses


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=2000)
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    openr = arguments.build.resolve() / "bin/openr"
    shares = []
    for _ in range(arguments.rounds):
        without, _ = duration(openr, arguments.seconds, False)
        with_page, poses = duration(openr, arguments.seconds, True)
        shares.append(without / with_page)
        print(f"{without:.2f} s without, {with_page:.2f} s with a page that got {poses} poses: "
              f"{shares[-1]:.3f}", flush=True)
    print(f"median {statistics.median(shares):.3f}")


if __name__ == "__main__":
    main()
