#!/usr/bin/env python3
"""A run whose host's clock jumps by a day, forward and back: it is the same run.

    clock_jump_test.py --build BUILD

libfaketime changes the time of day that the processes of a run see, one of which has an object alone.
The run goes as fast as it can, because libfaketime does not let a program sleep.  Without libfaketime (Debian package faketime) the test is skipped.
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
    command = [openr, "run", "--body", "ideal", "--rate", "max", "--for", "3600s", "--rc-port", "0", "--no-panel", *words]
    return subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, text=True)


def is_sanitized(program):
    """Returns whether the program has the library of AddressSanitizer, which no other may precede."""
    return "libasan" in subprocess.run(["ldd", program], capture_output=True, text=True).stdout


def set_offset(file, offset):
    """Writes the file at once, because programs read it at each look at the clock."""
    new = file.with_suffix(".new")
    new.write_text(offset + "\n")
    os.replace(new, file)


def state(text):
    found = re.search(r"state ([0-9a-f]{16})", text)
    return found[1] if found else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True)
    openr = parser.parse_args().build / "bin/openr"
    library = next(filter(os.path.exists, LIBRARIES), None)
    if library is None or is_sanitized(openr):
        print("libfaketime is not here, or cannot be used")
        print("0 passed, 0 failed, 1 skipped")
        return 0
    usual = run(openr).communicate(timeout=LIMIT_S)[1]
    with tempfile.TemporaryDirectory() as folder:
        offset = Path(folder) / "offset"
        environment = {
            **os.environ, "LD_PRELOAD": library, "FAKETIME_TIMESTAMP_FILE": str(offset), "FAKETIME_NO_CACHE": "1",
            # The clock by which the system measures durations never jumps.
            "FAKETIME_DONT_FAKE_MONOTONIC": "1"}
        set_offset(offset, "+1d")
        shown = int(subprocess.run(["date", "+%s"], env=environment, capture_output=True, text=True).stdout)
        verdict("programs see the other time", shown > time.time() + 80000, str(shown))
        set_offset(offset, "+0")
        jumping = run(openr, "--place", "PowerMonitor=away", environment=environment)
        first = jumping.stderr.readline()  # printed at the begin of the run, which takes seconds
        for jump in ("+1d", "-1d"):
            time.sleep(0.3)
            set_offset(offset, jump)
        is_over = jumping.poll() is not None
        said = first + jumping.communicate(timeout=LIMIT_S)[1]
    if is_over:  # on a computer that is much faster than ours
        print("the run was over before the second jump; let it be longer")
        print("1 passed, 0 failed, 1 skipped")
        return 0
    verdict("the run ends by time", jumping.returncode == 0 and "ended by time" in said, said)
    verdict("its state is that of other runs", state(said) is not None and state(said) == state(usual), said + usual)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
