#!/usr/bin/env python3
"""tests/threads/thread_tests.py: what it reads of the files of ThreadSanitizer, and which tests it
chooses.  The last line is "N passed, N failed"."""
import json
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/threads")]
import thread_tests  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

LINE = "=" * 18


def race(place):
    return (f"{LINE}\nWARNING: ThreadSanitizer: data race (pid=7)\n  Write of size 4 by main thread:\n"
            f"    #0 {place}\n\nSUMMARY: ThreadSanitizer: data race {place}\n{LINE}\n")


CRASH = ("==9==ERROR: ThreadSanitizer: SEGV on unknown address 0x000000000008\n    #0 main\n"
         "SUMMARY: ThreadSanitizer: SEGV in main\n")
ENDED = ("==9==ThreadSanitizer: library 'libx.so' that was matched against called_from_lib "
         "suppression 'libx.so' is unloaded\n")
USED = "ThreadSanitizer: Matched 3 suppressions (pid=7):\n2 race:libx.so\n1 mutex:Later\n"

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    found, used = thread_tests.reports_in(folder)
    verdict("no file is no race", not found and not used)
    (folder / "report.7").write_text(race("a.cc:1 in A()") + race("b.cc:2 in B()") + USED)
    (folder / "report.8").write_text(race("a.cc:1 in A()") + "ThreadSanitizer: reported 1 warnings\n")
    found, used = thread_tests.reports_in(folder)
    verdict("each place counts once", sorted(found) == ["data race a.cc:1 in A()", "data race b.cc:2 in B()"],
            str(list(found)))
    verdict("the reports of one place are counted", found["data race a.cc:1 in A()"][1] == 2)
    verdict("a report is kept without the text around it",
            found["data race b.cc:2 in B()"][0].startswith("WARNING") and LINE not in str(found))
    verdict("suppressions are counted", used == {"race:libx.so": 2, "mutex:Later": 1}, str(used))
    (folder / "report.9").write_text(CRASH)
    verdict("a crash is found", any("SEGV" in key for key in thread_tests.reports_in(folder)[0]))
    (folder / "report.9").write_text(USED + ENDED)
    found, _ = thread_tests.reports_in(folder)
    verdict("an end by ThreadSanitizer itself is found",
            any("is unloaded" in key for key in found), str(list(found)))
    verdict("the count of suppressions is no crash", len(found) == 3, str(list(found)))

    program = folder / "some_tests"
    program.write_text(f"#!/bin/sh\necho \"$2\" >{folder}/filter\n"
                       "case $2 in *=DTest*) ;; *) printf 'ATest.\\n  One\\n  Two  # comment\\n"
                       "BTest/0.\\n  One\\n' ;; esac\n")
    program.chmod(0o755)
    watched = {"tests": ["*"], "without": {"CTest.*": "a reason", "DTest.One": "a reason"}}
    tests = thread_tests.tests_of(str(program), watched, "One")
    verdict("the word chooses tests", tests == ["ATest.One", "BTest/0.One"], str(tests))
    verdict("tests are left out by name",
            (folder / "filter").read_text() == "--gtest_filter=*-CTest.*:DTest.One\n")
    missing = thread_tests.names_without_test(str(program), watched)
    verdict("a name that names no test is found", missing == ["DTest.One"], str(missing))

lines = (ROOT / "tests/threads/suppressions.txt").read_text().splitlines()
bare = [line for before, line in zip([""] + lines, lines)
        if line and not line.startswith("#") and not before.startswith("#")]
verdict("each suppression has its reason in the line above", not bare, str(bare))
for program, watched in json.loads((ROOT / "tests/threads/watched.json").read_text()).items():
    bare = [name for name, reason in watched.get("without", {}).items() if not reason]
    verdict(f"each test of {program} that is left out has a reason", not bare, str(bare))
sys.exit(finish())
