#!/usr/bin/env python3
"""A run whose host's clock jumps by a day, forward and back: it is the same run.

    clock_jump_test.py --build BUILD

libfaketime changes the time of day that the processes of a run see, one of which has an object alone,
while the run goes on in real time.  Without libfaketime (Debian package faketime) the test is skipped.
The last line is "N passed, N failed", or with ", N skipped".
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

LIBRARIES = ("/usr/lib/x86_64-linux-gnu/faketime/libfaketimeMT.so.1",
             "/usr/lib/aarch64-linux-gnu/faketime/libfaketimeMT.so.1")
LIMIT_S = 120


def run(openr, *words, environment=None):
    command = [openr, "run", "--body", "ideal", "--for", "3s", "--rc-port", "0", "--no-panel", *words]
    return subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, text=True)


def state(text):
    found = re.search(r"state ([0-9a-f]{16})", text)
    return found[1] if found else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True)
    openr = parser.parse_args().build / "bin/openr"
    library = next(filter(os.path.exists, LIBRARIES), None)
    if library is None:
        print("libfaketime is not here")
        print("0 passed, 0 failed, 1 skipped")
        return 0
    usual = run(openr, "--rate", "max").communicate(timeout=LIMIT_S)[1]
    with tempfile.NamedTemporaryFile("w") as offset:
        offset.write("+0\n")
        offset.flush()
        jumping = run(openr, "--place", "PowerMonitor=away", environment={
            **os.environ, "LD_PRELOAD": library, "FAKETIME_TIMESTAMP_FILE": offset.name, "FAKETIME_NO_CACHE": "1",
            # The clock by which the system measures durations never jumps.
            "FAKETIME_DONT_FAKE_MONOTONIC": "1"})
        for jump in ("+1d", "-1d"):
            time.sleep(1)  # not a limit: a jump before or after the run only shows nothing
            Path(offset.name).write_text(jump + "\n")
        said = jumping.communicate(timeout=LIMIT_S)[1]
    verdict("the run ends by time", jumping.returncode == 0 and "ended by time" in said, said)
    verdict("its state is that of other runs", state(said) is not None and state(said) == state(usual), said + usual)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
