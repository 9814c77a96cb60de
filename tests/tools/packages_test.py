#!/usr/bin/env python3
"""tools/packages.sh and tools/service.sh, as far as the folders that a person names, with programs that do nothing.
The last line is "N passed, N failed"."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

with tempfile.TemporaryDirectory() as scratch:
    stands = Path(scratch).resolve() / "elsewhere"
    stands.mkdir()
    programs = Path(scratch, "bin")
    programs.mkdir()
    for name in ("dpkg-shlibdeps", "file", "debootstrap", "systemd-nspawn", "id"):
        (programs / name).write_text("#!/bin/sh\necho 0\n")
        (programs / name).chmod(0o755)
    for words, complaint in ((["packages.sh", "--only-make", "--build", "my build"], f"{stands}/my build is no build folder"),
                             (["service.sh", "--packages", "my packages"], f"{stands}/my packages has no package")):
        done = subprocess.run([ROOT / "tools" / words[0], *words[1:]], cwd=stands, capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"})
        verdict(f"a folder for {words[0]} belongs to the folder where the person stands",
                done.returncode == 1 and complaint in done.stderr, done.stderr)

sys.exit(finish())
