#!/usr/bin/env python3
"""Makes docs/pictures/panel.gif, the moving picture of the panel, from a real run.

Needs chromium, node, the built page, and ffmpeg (Debian packages of these names).
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import browser_test  # noqa: E402: the folder is put into the path first
from run_process import RunProcess  # noqa: E402

PICTURE = browser_test.ROOT / "docs/pictures/panel.gif"
# All frames have the same palette; pixels that stay the same are not stored again.
FILTER = "scale=1080:-1:flags=area,split[a][b];[a]palettegen=max_colors=128:stats_mode=diff[p];[b][p]paletteuse=dither=none"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    why = browser_test.missing(build)
    if why:
        sys.exit(why)
    with tempfile.TemporaryDirectory(prefix="openr-picture-") as name:
        os.environ["XDG_RUNTIME_DIR"] = name
        run = RunProcess(build / "bin/openr", "--panel", "--panel-port", "0")
        try:
            address = run.wait_for(browser_test.ADDRESS, browser_test.START_LIMIT_S)
            if not address:
                sys.exit("".join(run.said) + "the run has no panel")
            environment = {**os.environ, "OPENR_PANEL_URL": address[1], "OPENR_PANEL_SHOTS": f"{name}/shots"}
            subprocess.run(["node", "test/browser/frames.mjs"], cwd=browser_test.ROOT / "panel",
                           env=environment, check=True)
        finally:
            run.end(browser_test.END_LIMIT_S)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-framerate", "6.25", "-i",
                        f"{name}/shots/%03d.png", "-vf", FILTER, str(PICTURE)], check=True)
    print(f"{PICTURE}: {PICTURE.stat().st_size} bytes")


if __name__ == "__main__":
    main()
