#!/usr/bin/env python3
"""read_flags of tools/clean_root.sh, in a script that is written here.  The last line is "N passed, N failed"."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

SCRIPT = r"""#!/usr/bin/env bash
# The text at the top.
#
#   probe.sh [--build DIR]
set -euo pipefail
. tools/clean_root.sh
suite=bookworm
build=build/release
only_make=false
read_flags --build=build --only-make=only_make --suite=suite -- "$@"
printf '%s\n' "$build" "$only_make" "$suite" "$keep" "$mirror"
"""
HELP = "The text at the top.\n\n  probe.sh [--build DIR]\n"
DEFAULTS = ["build/release", "false", "bookworm", "false", "http://deb.debian.org/debian"]
# Arguments, and the values of the variables after them; a text: what the script says when it gives up.
CASES = [
    ([], {}),
    (["--build", "a b"], {"build": "a b"}),
    (["--only-make"], {"only_make": "true"}),
    (["--keep", "--mirror", "http://x", "--suite", "trixie"], {"keep": "true", "mirror": "http://x", "suite": "trixie"}),
    (["--build", "x", "--build", "y"], {"build": "y"}),
    (["--keep", "--keep"], {"keep": "true"}),
    (["--build", "false", "--build", "x"], {"build": "x"}),
    (["--suite", "true"], {"suite": "true"}),
    (["--build", "-x"], {"build": "-x"}),
    (["--build", "*"], {"build": "*"}),
    (["--build"], "probe: --build needs a value\n"),
    (["--build", ""], "probe: --build needs a value\n"),
    (["--suite", "--keep"], "probe: --suite needs a value\n"),
    *[([word], HELP) for word in ("", "*", "@", "--", "--*", "--@", "-h", "--help", "--keep=true", "x", "--x]", "--x[0]", "--$(id)")],
    (["--keep", "x"], HELP),
]
NAMES = ("build", "only_make", "suite", "keep", "mirror")


def main():
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tools").mkdir()
        shutil.copy(ROOT / "tools/clean_root.sh", Path(folder, "tools"))
        probe = Path(folder, "tools/probe.sh")
        probe.write_text(SCRIPT)
        for arguments, wanted in CASES:
            done = subprocess.run(["bash", "tools/probe.sh", *arguments], cwd=folder, capture_output=True, text=True)
            got = (done.returncode, done.stdout.splitlines(), done.stderr)
            if isinstance(wanted, dict):
                right = (0, list({**dict(zip(NAMES, DEFAULTS)), **wanted}.values()), "")
            else:
                right = (2 if wanted == HELP else 1, [], wanted)
            verdict(f"arguments {arguments}", got == right, f"{got}, not {right}")
    return finish()


if __name__ == "__main__":
    sys.exit(main())
