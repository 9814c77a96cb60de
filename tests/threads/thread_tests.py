#!/usr/bin/env python3
"""Runs what has threads under ThreadSanitizer (docs/reliability.md): ./dev sanitize --threads.

watched.json lists the test programs and which of their tests run.  Every race that ThreadSanitizer
reports counts as a failure, whether it was in the test program or in a program that a test has
started.  Races that are planted must be found, which shows that the check can fail.

The last line is "N passed, N failed" (", N skipped").  The reports of ThreadSanitizer are in the
build folder until the next run, threads/PROGRAM/report.PROCESS; races and what failed programs
printed are kept as those of other tests are, in failed/DATE_TIME (tools/failure_logs.py).
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import run_tests  # noqa: E402  (found in the folder above)
from failure_logs import FailureLogs  # noqa: E402
from job_pool import JobPool  # noqa: E402

HERE = ROOT / "tests/threads"
SUPPRESSIONS = HERE / "suppressions.txt"
PLANTED_LIMIT_S = 300
# The word that a report of each planted race must name; None: no race is planted, so no report may come.
PLANTED = {"threads": "AddWithoutLock", "threads-good": None,
           "fibers": "GoHomeFromDepth", "fibers-good": None, "fibers-of-copy-good": None,
           "dds": "TakeLine", "dds-good": None,
           "answers": "forgetful_answer_queue.h", "answers-good": None,
           "errors-good": None}

LINE = "=" * 18 + "\n"  # stands before and after each report
SUMMARY = re.compile(r"^SUMMARY: ThreadSanitizer: (.*)$", re.MULTILINE)
# A crash, or an error for which ThreadSanitizer itself has ended the program.
CRASH = re.compile(r"^(?:==\d+==(?:ERROR: )?|FATAL: |(?=ThreadSanitizer: CHECK))"
                   r"(ThreadSanitizer:? .*)$", re.MULTILINE)
MATCHED = re.compile(r"^ *(\d+) ([a-z_]+:\S+)$", re.MULTILINE)


def options(folder):
    """Returns the settings with which ThreadSanitizer writes its reports into `folder`.

    A report does not change the exit status (exitcode), because tests check that of the programs
    they start.  The report counts here instead.
    """
    return ":".join([f"suppressions={SUPPRESSIONS}", f"log_path={folder}/report", "exitcode=0",
                     "print_suppressions=1", "second_deadlock_stack=1", "history_size=4"])


def reports_in(folder):
    """Returns the reports that ThreadSanitizer has written into `folder`, as a dict from the last
    line of a report, which names the kind and the place, to (report, count); and how often each
    suppression was used."""
    found, used = {}, collections.Counter()
    for file in sorted(folder.glob("report.*")):
        text = file.read_text(errors="replace")
        for report in text.split(LINE):
            if not report.startswith("WARNING: ThreadSanitizer:"):
                continue
            summary = SUMMARY.search(report)
            key = summary.group(1) if summary else report.splitlines()[0]
            first, count = found.get(key, (report, 0))
            found[key] = (first, count + 1)
        for crash in CRASH.findall(text):
            found[crash] = (text, 1)
        for hits, name in MATCHED.findall(text):
            used[name] += int(hits)
    return found, used


def list_tests(program, chosen):
    """Returns the names of the tests of `program` that the filter `chosen` lets run."""
    listed = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={chosen}"],
                            check=True, stdout=subprocess.PIPE, text=True).stdout
    names, suite = [], ""
    for line in listed.splitlines():
        name = line.split("#")[0].rstrip()
        if name.endswith(".") and not name.startswith(" "):
            suite = name
        elif name.startswith("  "):
            names.append(suite + name.strip())
    return names


def tests_of(program, watched, pattern):
    """Returns the names of the tests of `program` that run."""
    chosen = ":".join(watched["tests"]) + "-" + ":".join(watched.get("without", {}))
    return [name for name in list_tests(program, chosen) if pattern in name]


def names_without_test(program, watched):
    """Returns the names in watched.json that name no test of `program`, such as a renamed test."""
    return [name for name in [*watched["tests"], *watched.get("without", {})]
            if not list_tests(program, name)]


def check_planted(program, folder):
    """Runs the planted races; returns (passed, failed)."""
    passed = 0
    for name, place in PLANTED.items():
        reports = folder / name
        reports.mkdir(parents=True)
        # Cyclone DDS leaves its cyclonedds.log in the folder where the program runs.
        done = subprocess.run([program, name], cwd=reports, stdout=subprocess.DEVNULL,
                              env={**os.environ, "TSAN_OPTIONS": options(reports)},
                              timeout=PLANTED_LIMIT_S)
        found, _ = reports_in(reports)
        wrong = ""
        if done.returncode != 0:
            wrong = f"ended with {done.returncode}"
        elif place and not any(place in report for report, _ in found.values()):
            wrong = f"no report names {place}, where the race was planted"
        elif not place and found:
            wrong = f"a report, and there is no race: {next(iter(found))}"
        passed += not wrong
        print(f"planted race {name}: {wrong or 'as it must be'}", flush=True)
    return passed, len(PLANTED) - passed


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--filter", default="", help="only tests whose name contains this word")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    folder = build / "threads"
    shutil.rmtree(folder, ignore_errors=True)
    logs = FailureLogs(build)
    passed = failed = skipped = 0
    if not arguments.filter:
        passed, failed = check_planted(build / "bin/planted_races", folder / "planted_races")
    races, used, jobs = {}, collections.Counter(), []
    for name, watched in json.loads((HERE / "watched.json").read_text()).items():
        program = str(build / "bin" / name)
        for missing in [] if arguments.filter else names_without_test(program, watched):
            print(f"FAILED: watched.json names {missing}, and {name} has no such test")
            failed += 1
        tests = tests_of(program, watched, arguments.filter)
        if not tests:
            continue
        (folder / name).mkdir(parents=True)
        for part, shard in run_tests.parts(name, watched.get("parts", 1)):
            shard["TSAN_OPTIONS"] = options(folder / name)
            jobs.append((part, [program, "--gtest_filter=" + ":".join(tests)], shard))
    with JobPool(os.cpu_count()) as pool:
        todo = {pool.submit(run_tests.run, *job, None): job for job in jobs}
        for future in concurrent.futures.as_completed(todo):
            name, good, bad, left_out, output, seconds = future.result()
            if bad:
                print(output)
                _, command, shard = todo[future]
                file, tests = logs.keep(name, command, run_tests.environment(shard), output)
                print(f"FAILED in {name}, kept in {file}: {' '.join(tests)}")
            passed, failed, skipped = passed + good, failed + bad, skipped + left_out
            extra = f", {left_out} skipped" if left_out else ""
            print(f"{name}: {good} passed, {bad} failed{extra} ({seconds:.1f} s)", flush=True)
    for name in {pathlib.Path(job[1][0]).name for job in jobs}:
        found, hits = reports_in(folder / name)
        used += hits
        for key, (report, count) in found.items():
            before = races.get(key, (report, 0))
            races[key] = (before[0], before[1] + count)
    for key, (report, count) in races.items():
        print(f"{report}\nFAILED: {key} ({count} times)")
    if races:
        command = [sys.executable, __file__, "--build", build, "--filter", arguments.filter]
        file, _ = logs.keep("races", command, {}, "\n".join(report for report, _ in races.values()))
        print(f"the reports of these races are kept in {file}")
    for suppression, hits in sorted(used.items()):
        print(f"suppressed {hits} times: {suppression}")
    failed += len(races)
    if passed + failed + skipped == 0:
        print(f"no test matches '{arguments.filter}'")
        failed = 1
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
