#!/usr/bin/env python3
"""tools/browser_test.py: which folder of pictures it empties, with a browser that only pretends.  The last line is
"N passed, N failed"."""
import contextlib
import io
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import browser_test  # noqa: E402
from verdicts import finish, verdict  # noqa: E402


class Text(io.StringIO):
    def reconfigure(self, **_):
        """Is called by main()."""


def drive(openr, folder, shots, scale, only):
    """Makes one picture; is called in place of browser_test.drive()."""
    (shots / "new.png").touch()
    return 1, 0


def files_after(build, folder, *flags):
    """Runs main() when a file is in the folder; returns the files in it afterwards."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "old.txt").touch()
    sys.argv = ["browser_test.py", "--build", str(build), *flags]
    with contextlib.redirect_stdout(Text()):
        browser_test.main()
    return sorted(path.name for path in folder.iterdir())


browser_test.missing = lambda build: ""
browser_test.drive = drive
with tempfile.TemporaryDirectory() as scratch:
    build, own = Path(scratch, "build"), Path(scratch, "Pictures")
    verdict("old pictures of the build folder are removed", files_after(build, build / "panel-shots") == ["new.png"])
    found = files_after(build, own, "--shots", str(own))
    verdict("files in a folder of a person are left alone", found == ["new.png", "old.txt"], str(found))

sys.exit(finish())
