#!/usr/bin/env python3
"""How many lines of the runtime, the body and the distribution the tests run.

    tools/coverage.py [--build DIR] [--least PERCENT] [--keep]

Runs the test programs of a build with gcov's counters (preset coverage; `./dev coverage` makes it) and
prints the share of lines that ran, for each folder of FOLDERS and for each file below the limit.
--keep counts on from the last time.  The last line is "N passed, N failed": a folder passes when at
least PERCENT (90) of its lines ran, and the tests are one pass more.  Some tests fail here because
they expect images without counters: at most MOST_OTHERS, each of which must pass in the build of the
preset release (--other).
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("runtime", "virtualrobot", "distribution")
# Programs that are left out: they compile, or test what is in other folders, and take long.
LEFT_OUT = ("kit_tests", "data_tests", "examples_tests", "objects_tests", "fuzz_tests", "controllers_tests",
            "tutorial_tests", "allocation_tests")


# Tests that fail because of the counters in the images.
MOST_OTHERS = 2


def run_tests(build, other):
    """Runs the test programs, which leave their counters in the build; returns what is wrong with them.

    `other`: the build in which a test that fails must pass.
    """
    programs = [p.name for p in sorted((build / "bin").glob("*_tests")) if p.name not in LEFT_OUT]
    command = [sys.executable, ROOT / "tools/run_tests.py", "--build", build, "--programs", *programs]
    lines = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line.rstrip("\n"))
    failed = failed_tests(lines)
    if process.returncode != 0 and not failed:
        return ["the tests fail, and no failed test is named"]
    wrong = [f"{program}: {test or 'fails, and names no test'}" for program, test in failed
             if not (test and passes(other / "bin" / program, test))]
    if not wrong and len(failed) > MOST_OTHERS:
        wrong = [f"{len(failed)} tests pass in {other} only; {MOST_OTHERS} were known"]
    return wrong


def failed_tests(lines):
    """Returns the failed tests (program, test) that run_tests.py names; the test is "" if it knows none."""
    found, program = [], None
    for line in lines:
        if heading := re.match(r"FAILED in (\S+).*, kept in .*:$", line):
            program = heading[1]
        elif program and line.startswith("  "):
            found.append((program, "" if line.startswith("  (") else line.strip()))
        else:
            program = None
    return found


def passes(program, test):
    """Returns whether a test of this program passes."""
    with tempfile.TemporaryDirectory() as scratch:
        try:
            done = subprocess.run([program, f"--gtest_filter={test}"], cwd=scratch, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                  check=False)
        except OSError:
            return False
    return done.returncode == 0 and re.search(r"^\[       OK \] ", done.stdout, re.MULTILINE) is not None


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
    parser.add_argument("--other", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--least", type=float, default=90)
    parser.add_argument("--keep", action="store_true")
    arguments = parser.parse_args()
    if not arguments.keep:
        for counter in arguments.build.rglob("*.gcda"):
            counter.unlink()
    wrong = run_tests(arguments.build.resolve(), arguments.other.resolve())
    totals = collections.defaultdict(lambda: [0, 0])
    counts = count_lines(arguments.build)
    for file, (ran, lines) in sorted(counts.items(), key=lambda item: item[1][0] - item[1][1]):
        total = totals[file.split("/")[0]]
        total[0] += ran
        total[1] += lines
        if lines and 100 * ran < arguments.least * lines:
            print(f"{100 * ran / lines:5.1f} % of {lines:4} lines  {file}")
    failed = bool(wrong)
    for line in wrong:
        print(f"FAILED: {line}")
    for name in FOLDERS:
        ran, lines = totals[name]
        share = 100 * ran / lines if lines else 0
        failed += share < arguments.least
        print(f"{name}: {share:.1f} % of {lines} lines")
    print(f"{len(FOLDERS) + 1 - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
