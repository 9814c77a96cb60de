#!/usr/bin/env python3
"""./dev in a copy of a checkout whose scripts only tell how they are called.  The last line is "N passed, N failed"."""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

TELL = "import os, sys\nprint(os.getcwd(), *sys.argv[1:], sep='\\n')\n"


def script(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


with tempfile.TemporaryDirectory() as scratch:
    checkout, stands = Path(scratch).resolve() / "my check out", Path(scratch).resolve() / "elsewhere"
    stands.mkdir()
    script(checkout / "tools/install_packages.sh", "#!/bin/sh\n")
    script(Path(scratch, "bin/cmake"), "#!/bin/sh\n")
    for name in ("tests/fuzz/fuzz.py", "tools/docs_site/build.py"):
        script(checkout / name, TELL)
    shutil.copy(ROOT / "dev", checkout)
    for words in (["fuzz", "mtn", "--show", "crash-1"], ["docs", "-o", "my site"]):
        done = subprocess.run([checkout / "dev", *words], cwd=stands, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, env={**os.environ, "PATH": f"{scratch}/bin:{os.environ['PATH']}"})
        said = done.stdout.splitlines()
        verdict(f"a name for ./dev {words[0]} belongs to the folder where the person stands",
                said == [str(stands), *words[1:]], str(said))

sys.exit(finish())
