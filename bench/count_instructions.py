#!/usr/bin/env python3
"""./dev bench --callgrind [--record]: counts the instructions of a message.

Each row of bench/instructions.json is a run of PingPong (bench/ping_pong.h).  Callgrind counts the instructions
of two runs that differ only in the number of messages; the difference of the counts, divided by the
difference of the numbers, is the cost of a message.  Unlike times, these counts are the same on a
busy machine.  Exits with 1 if a count is more than 5 % above the recorded one.  With --record, writes
the counts into the file instead.  Writes build/instructions.json.  The last line of a comparison is
"N passed, N failed" or "N passed, N failed, N skipped", which .ci/run adds up.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
RECORD = ROOT / "bench" / "instructions.json"
PLAY = ROOT / "build" / "release" / "bin" / "play_messages"
RESULT = ROOT / "build" / "instructions.json"
ROOM = 1.05  # a count may be this much above the recorded one


def instructions(row, messages):
    """The instructions of a whole run of `row` with so many messages."""
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(PLAY),
               str(row["pairs"]), str(int(row["hash"])), str(messages)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or found is None:
        sys.exit(f"{' '.join(command)} has failed:\n{run.stderr}")
    return int(found.group(1))


def count(row):
    """The instructions of one message of `row`."""
    few, many = row["messages"]
    with ThreadPoolExecutor(2) as pool:
        first, second = pool.map(lambda messages: instructions(row, messages), (few, many))
    return round((second - first) / (many - few), 1)


def give_up(rows, why):
    """Ends without counting.  In CI that is a failure, because Valgrind can be installed there."""
    print(f"instructions of a message: not counted, {why}")
    is_failure = os.environ.get("CI") == "true"
    print(f"0 passed, {rows} failed" if is_failure else f"0 passed, 0 failed, {rows} skipped")
    sys.exit(1 if is_failure else 0)


def main():
    record = json.loads(RECORD.read_text())
    if shutil.which("valgrind") is None:
        give_up(len(record["rows"]),
                "because valgrind is not installed; as root: apt-get install valgrind")
    about = subprocess.run([PLAY, "about"], capture_output=True, text=True, check=True).stdout.strip()
    is_recording = sys.argv[1:] == ["--record"]
    if sys.argv[1:] and not is_recording:
        sys.exit(f"{sys.argv[1]}: only --record may follow --callgrind")
    if about != record["about"] and not is_recording:
        print(f"instructions of a message: not compared, because the record is for {record['about']} "
              f"and this build is for {about}; ./dev bench --callgrind --record makes a new one")
        print(f"0 passed, 0 failed, {len(record['rows'])} skipped")
        return 0
    failed = 0
    print(f"{'instructions of a message':46} {'counted':>8} {'recorded':>9} {'change':>8}")
    for row in record["rows"]:
        counted = count(row)
        change = counted / row["instructions"] - 1
        failed += not is_recording and counted > ROOM * row["instructions"]
        print(f"{row['name']:46} {counted:8.1f} {row['instructions']:9.1f} {change:+8.1%}", flush=True)
        row["counted"] = counted
    RESULT.write_text(json.dumps(record, indent=2) + "\n")
    if is_recording:
        for row in record["rows"]:
            row["instructions"] = row.pop("counted")
        RECORD.write_text(json.dumps({"about": about, "rows": record["rows"]}, indent=2) + "\n")
        print(f"recorded for {about}")
        return 0
    if failed:
        print(f"{failed} counts are more than 5 % above bench/instructions.json.  If the change is worth "
              "it, record them with ./dev bench --callgrind --record and say so in the commit.")
    print(f"{len(record['rows']) - failed} passed, {failed} failed")
    return 1 if failed else 0


sys.exit(main())
