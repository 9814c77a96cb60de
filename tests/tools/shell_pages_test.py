#!/usr/bin/env python3
"""cmake/MakeShellPages.cmake in a checkout whose path has blanks.  The last line is
"N passed, N failed"."""
import gzip
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

PROGRAM = """#!/bin/sh
case $1 in
  completion) echo "completion for $2" ;;
  man) echo "a page" >"$3/openr.1"; echo "another page" >"$3/openr-run.1"; echo "two pages" ;;
esac
"""


def make(program, folder):
    """Runs the script; returns its status and what it has printed."""
    (folder / "openr").write_text(program)
    (folder / "openr").chmod(0o755)
    done = subprocess.run(["cmake", f"-DOPENR={folder}/openr", f"-DGZIP={shutil.which('gzip')}",
                           f"-DCOMPLETION={folder}/completions/openr", f"-DPAGES={folder}/man1",
                           "-P", ROOT / "cmake/MakeShellPages.cmake"], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def files(folder):
    return {path.name: gzip.decompress(path.read_bytes()).decode() for path in folder.iterdir()}


with tempfile.TemporaryDirectory() as scratch:
    checkout = Path(scratch, "my check out")
    checkout.mkdir()
    (checkout / "man1").mkdir()
    (checkout / "man1/openr-gone.1.gz").write_bytes(gzip.compress(b"of an older version"))
    said = make(PROGRAM, checkout)
    verdict("pages and completion are made, without a word", said == (0, ""), str(said))
    verdict("the pages are those of the program, packed",
            files(checkout / "man1") == {"openr.1.gz": "a page\n", "openr-run.1.gz": "another page\n"})
    completion = (checkout / "completions/openr").read_text()
    verdict("the completion is that of the program", completion == "completion for bash\n", completion)
    verdict("a program that fails is an error", make("#!/bin/sh\nexit 1\n", checkout)[0] != 0)

build = (ROOT / "openr/CMakeLists.txt").read_text()
verdict("the build makes them by this script, and by no shell, which would split the path",
        "cmake/MakeShellPages.cmake" in build and "sh -c" not in build)

sys.exit(finish())
