#!/usr/bin/env python3
"""Runs the tests of python/openr_host, with the program of a build folder.

    tests/python/python_tests.py --build build/release [WORD]

Each test_*.py beside this file is a module of unittest.  The last line is "N passed, N failed"
(", N skipped").
"""
import argparse
import os
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


class Verdicts(unittest.TextTestResult):
    """Names failed tests as the programs of GoogleTest do, for tools/run_tests.py."""

    def addFailure(self, test, error):
        super().addFailure(test, error)
        self.stream.writeln(f"[  FAILED  ] {type(test).__name__}.{test._testMethodName}")

    def addError(self, test, error):
        super().addError(test, error)
        self.stream.writeln(f"[  FAILED  ] {type(test).__name__}.{getattr(test, '_testMethodName', 'setUp')}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("word", nargs="?", default="", help="only tests whose names contain it")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    os.environ["OPENR_HOST_PROGRAM"] = str(build / "bin/openr")
    os.environ["OPENR_HOST_BUILD"] = str(build)
    os.environ["PYTHONPATH"] = str(ROOT / "python")  # for programs that tests start
    sys.path[:0] = [str(ROOT / "python"), str(ROOT / "examples/python"), str(HERE)]
    loader = unittest.TestLoader()
    if arguments.word:
        loader.testNamePatterns = [f"*{arguments.word}*"]
    suite = loader.discover(str(HERE), pattern="test_*.py", top_level_dir=str(HERE))
    result = unittest.TextTestRunner(stream=sys.stdout, resultclass=Verdicts, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    passed = result.testsRun - failed - len(result.skipped)
    skipped = f", {len(result.skipped)} skipped" if result.skipped else ""
    print(f"{passed} passed, {failed} failed{skipped}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
