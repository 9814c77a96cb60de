#!/usr/bin/env python3
"""How many lines of the runtime, the body and the distribution the tests run.

    tools/coverage.py [--build DIR] [--least PERCENT] [--keep]

Runs the test programs of a build with gcov's counters (preset coverage; `./dev coverage` makes it) and
prints the share of lines that ran, for each folder of FOLDERS and for each file below the limit.
--keep counts on from the last time.  The last line is "N passed, N failed": a folder passes when at
least PERCENT (90) of its lines ran.  Tests that fail are printed and do not count: some expect the
code of another build, and ./dev test decides about them.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("runtime", "virtualrobot", "distribution")
# Programs that are left out: they compile, or test what is in other folders, and take long.
LEFT_OUT = ("kit_tests", "data_tests", "examples_tests", "objects_tests", "fuzz_tests", "controllers_tests",
            "tutorial_tests", "allocation_tests")


def run_tests(build):
    """Runs the test programs, which leave their counters in the build."""
    programs = [p.name for p in sorted((build / "bin").glob("*_tests")) if p.name not in LEFT_OUT]
    command = [sys.executable, ROOT / "tools/run_tests.py", "--build", build, "--programs", *programs]
    subprocess.run(command, check=False)


def count_lines(build):
    """Returns {file: (lines that ran, all lines)} from the counters in the build."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        subprocess.run(["gcovr", "--root", ROOT, "--object-directory", build, "--json", out.name, "-j", "2",
                        "--exclude-unreachable-branches", *(f"--filter={ROOT}/{name}/" for name in FOLDERS), build],
                       check=True, stdout=subprocess.DEVNULL)
        files = json.load(open(out.name))["files"]
    counts = {}
    for file in files:
        lines = [line for line in file["lines"] if not line.get("gcovr/noncode")]
        counts[file["file"]] = (sum(line["count"] > 0 for line in lines), len(lines))
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/coverage")
    parser.add_argument("--least", type=float, default=90)
    parser.add_argument("--keep", action="store_true")
    arguments = parser.parse_args()
    if not arguments.keep:
        for counter in arguments.build.rglob("*.gcda"):
            counter.unlink()
    run_tests(arguments.build)
    totals = collections.defaultdict(lambda: [0, 0])
    counts = count_lines(arguments.build)
    for file, (ran, lines) in sorted(counts.items(), key=lambda item: item[1][0] - item[1][1]):
        total = totals[file.split("/")[0]]
        total[0] += ran
        total[1] += lines
        if lines and 100 * ran < arguments.least * lines:
            print(f"{100 * ran / lines:5.1f} % of {lines:4} lines  {file}")
    failed = 0
    for name in FOLDERS:
        ran, lines = totals[name]
        share = 100 * ran / lines if lines else 0
        failed += share < arguments.least
        print(f"{name}: {share:.1f} % of {lines} lines")
    print(f"{len(FOLDERS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
