#!/usr/bin/env python3
"""Runs the tests of the page's modules, which need no browser: npm test in panel/.

The last line is "N passed, N failed, N skipped".  Skips, with the reason, where npm or the packages
of the page are missing; where the variable CI is true, that is a failure.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "panel"
PASSED = re.compile(r"^\s*Tests .*?(\d+) passed", re.MULTILINE)
FAILED = re.compile(r"^\s*Tests .*?(\d+) failed", re.MULTILINE)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path, help="is not used")
    parser.parse_args()
    why = ""
    if not shutil.which("npm"):
        why = "npm is missing (Debian package npm)"
    elif not (PAGE / "node_modules/vitest").exists():
        why = "the packages of the page are not installed (target panel_page)"
    if why:
        is_wrong = os.environ.get("CI") == "true"
        print(f"tests of the page {'impossible' if is_wrong else 'skipped'}: {why}")
        print("0 passed, 1 failed" if is_wrong else "0 passed, 0 failed, 1 skipped")
        return int(is_wrong)
    result = subprocess.run(["npm", "test"], cwd=PAGE, stdout=subprocess.PIPE, text=True,
                            stderr=subprocess.STDOUT, env={**os.environ, "NO_COLOR": "1"}, check=False)
    print(result.stdout, end="")
    passed, failed = (int(found[1]) if found else 0 for found in
                      (PASSED.search(result.stdout), FAILED.search(result.stdout)))
    if result.returncode != 0 and failed == 0:
        failed = 1
    print(f"{passed} passed, {failed} failed")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
