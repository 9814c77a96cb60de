#!/usr/bin/env python3
"""tools/moving_picture.py, with programs in place of openr, node and ffmpeg.  The last line is "N passed, N failed"."""
import contextlib
import io
import os
import signal
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import browser_test  # noqa: E402
import moving_picture  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

RUN = """#!/bin/sh
trap 'exit 0' INT
echo 'panel: http://127.0.0.1:1/?token=abc' >&2
while true; do sleep 0.1; done
"""


def script(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


with tempfile.TemporaryDirectory() as scratch:
    # A shell that has begun this test with '&' lets it and its programs ignore Ctrl-C.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    folder = Path(scratch)
    script(folder / "build/bin/openr", RUN)
    script(folder / "bin/node", f'#!/bin/sh\necho "$OPENR_PANEL_URL" >{folder}/url\n')
    script(folder / "bin/ffmpeg", '#!/bin/sh\nfor file; do :; done\necho picture >"$file"\n')
    os.environ["PATH"] = f"{folder}/bin:{os.environ['PATH']}"
    browser_test.missing = lambda build: ""
    moving_picture.PICTURE = folder / "panel.gif"
    sys.argv = ["moving_picture.py", "--build", f"{folder}/build"]
    with contextlib.redirect_stdout(io.StringIO()):
        moving_picture.main()
    url = (folder / "url").read_text()
    verdict("the browser gets the address of the page", url == "http://127.0.0.1:1/?token=abc\n", url)
    verdict("the picture is made", moving_picture.PICTURE.read_text() == "picture\n")

sys.exit(finish())
