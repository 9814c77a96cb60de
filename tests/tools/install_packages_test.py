#!/usr/bin/env python3
"""tools/install_packages.sh, with programs in place of apt-get, dpkg-query, id and sudo.  The last line is
"N passed, N failed"."""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

# Each program writes its name and arguments to the file `calls`.
PROGRAMS = {
    "dpkg-query": 'for package; do :; done; [ "$package" = there ] && echo installed',
    "id": "echo $USER_ID",
    "apt-get": 'echo "apt-get $*, $DEBIAN_FRONTEND" >>calls; [ "$1" != "$FAILS" ] || { echo no network; exit 100; }',
    "sudo": 'echo "sudo $1" >>calls; if [ "$1" = -n ]; then shift; fi; exec "$@"',
}


def install(text, user_id=0, fails="nothing", flags=("--no-questions",)):
    """Runs the script with a list; returns its status, the calls of programs and what it has said."""
    with tempfile.TemporaryDirectory() as folder:
        for name, body in PROGRAMS.items():
            Path(folder, name).write_text(f"#!/bin/sh\n{body}\n")
            Path(folder, name).chmod(0o755)
        Path(folder, "list").write_text(text)
        done = subprocess.run([ROOT / "tools/install_packages.sh", *flags, "list"], cwd=folder, capture_output=True, text=True,
                              env={"PATH": f"{folder}:/usr/bin:/bin", "USER_ID": str(user_id), "FAILS": fails})
        calls = Path(folder, "calls")
        return done.returncode, calls.read_text().splitlines() if calls.exists() else [], done.stderr


def check(name, got, wanted):
    verdict(name, got == wanted, f"{got}, not {wanted}")


LIST = "# a comment\none  # another one\nthere\ntwo\n"
UPDATE, INSTALL = "apt-get update -q, ", "apt-get install -y -q --no-install-recommends one two, noninteractive"

status, calls, said = install(LIST)
check("missing packages are installed, without questions, from new lists", calls, [UPDATE, INSTALL])
check("this ends well, and says what is installed", (status, said), (0, "install_packages: installing one two\n"))
check("nobody becomes root for packages that are there", install("there\n", user_id=1000)[:2], (0, []))
check("another user than root becomes root without a password", install(LIST, user_id=1000)[1],
      ["sudo -n", UPDATE, "sudo -n", INSTALL])
check("a person is asked for the password", install(LIST, user_id=1000, flags=())[1],
      ["sudo apt-get", UPDATE, "sudo env", INSTALL])
for call in ("update", "install"):
    status, _, said = install(LIST, fails=call)
    verdict(f"a failure of {call} is one of the script, with its reason",
            status == 1 and "no network" in said and "one two cannot be installed" in said, said)

# Debian 12 and 13 have other versions of compilers, so the lists name none of them.
names = " ".join(line for path in ROOT.glob("cmake/debian-packages*.txt") for line in path.read_text().splitlines()
                 if not line.startswith("#")).split()
check("no package of the lists is a version of a compiler", [name for name in names if re.search(r"-\d+(-|$)", name)], [])

sys.exit(finish())
