#!/usr/bin/env python3
"""tools/dds_security.sh, as a user who is not root calls it.  The last line is "N passed, N failed"."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

PATH = "/usr/local/bin:/usr/bin:/bin"  # Debian's, for users other than root


def make(folder, *names, path=PATH):
    done = subprocess.run(["bash", ROOT / "tools/dds_security.sh", folder, *names], capture_output=True, text=True,
                          env={"PATH": path})
    return done.returncode, done.stdout + done.stderr


if not shutil.which("openssl"):
    print("skipped: openssl is missing")
    sys.exit(finish(1))
with tempfile.TemporaryDirectory() as scratch:
    said = make(f"{scratch}/my keys", "alpha")
    verdict("settings are made without a word", said == (0, ""), str(said))
    verdict("they name three plugins", Path(scratch, "my keys/alpha.xml").read_text().count("<Library path=") == 3)
    key = Path(scratch, "my keys/ca.key").read_bytes()
    make(f"{scratch}/my keys", "beta")
    verdict("a second call keeps the authority", Path(scratch, "my keys/ca.key").read_bytes() == key)

    # The certificate of the authority cannot be made.
    tools = Path(scratch, "tools")
    tools.mkdir()
    (tools / "openssl").write_text('#!/bin/sh\n[ "$1" != req ] || exit 1\nexec /usr/bin/openssl "$@"\n')
    (tools / "openssl").chmod(0o755)
    failed = make(f"{scratch}/keys", "alpha", path=f"{tools}:{PATH}")
    verdict("a failure is one of the script", failed[0] != 0, str(failed))
    again = make(f"{scratch}/keys", "alpha")
    verdict("the next call makes the authority that was not finished", again[0] == 0, str(again))

sys.exit(finish())
