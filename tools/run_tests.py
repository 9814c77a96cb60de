#!/usr/bin/env python3
"""Runs the test programs of a build, a few at a time, and the script tests.

Every program prints "N passed, N failed" (", N skipped") as its last line; the last line here
is the sum.  A program that crashes or hangs counts as one failure more.  Programs whose tests
mostly wait are run in parts, all at a time and beside the others.

The names of failed tests stand above the last line.  What a program with failures printed is kept
in the build folder, failed/DATE_TIME/NAME.log, with the commands that run it again at its begin.  The
folders of the last 20 runs with failures stay.
"""
import argparse
import concurrent.futures
import fcntl
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from failure_logs import FailureLogs
from job_pool import JobPool

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOTALS = re.compile(r"^(\d+) passed, (\d+) failed(?:, (\d+) skipped)?$")
LIMIT_S = 1800  # for one program: enough with sanitizers on two busy cores
# distribution_tests wait for leases (ros2_run.h has 4 domains), openr_tests for runs in real time.
SHARDS = {"distribution_tests": 4, "openr_tests": 2}
# kit_tests compile objects, the others step physics.
BUSY_SHARDS = {"kit_tests": 3, "testing_tests": 2, "graph_tests": 2, "virtualrobot_tests": 2}
# The programs that take longest, in the order in which they begin.  If one of them began last, a
# processor would have nothing to do until its end.  both_dogs_test.py mostly waits for two runs in
# real time, run_docs.py and run_examples.py compile objects.
BEGIN_FIRST = ["kit_tests", "both_dogs_test.py", "run_docs.py", "graph_tests", "run_examples.py",
               "python_tests.py", "check_headers.sh", "original_names_test.py", "explore_tests"]


def environment(shard):
    env = {**os.environ, **shard}
    # ./dev sets it for its own build; objects of tests have debug information with their own folders.
    env.pop("CCACHE_NOHASHDIR", None)
    env.setdefault("ASAN_OPTIONS", "detect_leaks=0:detect_stack_use_after_return=0")
    env.setdefault("LSAN_OPTIONS", "print_suppressions=0")
    env.setdefault("UBSAN_OPTIONS", "print_stacktrace=1")
    return env


def compiler_cache():
    """Returns the variables with which tests compile objects through ccache, where it is installed.

    Tests run in folders of their own, with other homes, so the folder of the cache has to be named.
    The headers of such a test are new, and ccache would not trust the times of new files.  CI begins
    with an empty cache, which would only take time.
    """
    if not shutil.which("ccache") or os.environ.get("CI") == "true":
        return {}
    cache = subprocess.run(["ccache", "--get-config", "cache_dir"], stdout=subprocess.PIPE, text=True,
                           check=True).stdout.strip()
    return {"OPENR_HOST_CXX": "ccache g++", "OPENR_HOST_CC": "ccache gcc", "CCACHE_DIR": cache,
            "CCACHE_SLOPPINESS": "include_file_ctime,include_file_mtime"}


def owns_scratch(build):
    """Returns whether no other run of the tests of this build uses its folder `scratch`."""
    lock = os.open(build / "scratch.lock", os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o666)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # kept until this process ends
    except BlockingIOError:
        return False
    return True


def run(name, command, shard, scratch_root):
    """Returns (name, passed, failed, skipped, output, seconds).

    `scratch_root`: the folder for a folder of the program that has the same name each time, because
    the compiler's cache has only what was compiled at the same place; None without a cache.
    """
    begin = time.monotonic()
    same = None
    if scratch_root:
        same = scratch_root / re.sub(r"[^\w.]+", "-", name)
        shutil.rmtree(same, ignore_errors=True)
        same.mkdir(parents=True)
        shard = {**shard, "OPENR_TEST_SCRATCH": str(same)}
    with tempfile.TemporaryDirectory(prefix="openr-test-") as scratch:
        try:
            done = subprocess.run(command, cwd=scratch, env=environment(shard), timeout=LIMIT_S,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
            output, status = done.stdout.decode(errors="replace"), done.returncode
        except subprocess.TimeoutExpired as late:
            output = (late.stdout or b"").decode(errors="replace")
            output += f"\n{name}: not done after {LIMIT_S} s\n"
            status = -1
    if same:
        shutil.rmtree(same, ignore_errors=True)
    lines = output.strip().splitlines()
    totals = TOTALS.match(lines[-1]) if lines else None
    seconds = time.monotonic() - begin
    if totals is None:  # no totals: a script without totals, or a program that has crashed
        good = status == 0 and name.endswith(".sh")
        if status < 0:
            output += f"\n{name}: ended by signal {-status} ({signal.strsignal(-status)})\n"
        return name, int(good), int(not good), 0, output, seconds
    passed, failed, skipped = (int(n or 0) for n in totals.groups())
    if status != 0 and failed == 0:
        failed = 1
    return name, passed, failed, skipped, output, seconds


def parts(name, count):
    """Splits a test program into parts; returns name and environment variables of each part."""
    return [(f"{name} {i + 1}/{count}",
             {"GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(i)}) for i in range(count)]


def longest_first(found):
    """Returns the programs in the order in which they begin: first those of BEGIN_FIRST."""
    def place(job):
        program = job[0].split(" ")[0]
        return BEGIN_FIRST.index(program) if program in BEGIN_FIRST else len(BEGIN_FIRST)
    return sorted(found, key=place)


def quick_programs(build):
    """Returns the test programs that run in one process, from the list that CMake has written."""
    return [build / "bin" / name for name in (build / "quick_tests.txt").read_text().split()]


def jobs(build, pattern, quick, names):
    """Returns three lists of (name, command, environment).

    The lists: programs that mostly wait, the other programs, programs that have to run alone.  With
    `names`, only these test programs, and no scripts.
    """
    waiting, found, alone = [], [], []
    gtest = [f"--gtest_filter=*{pattern}*"] if pattern else []
    programs = quick_programs(build) if quick else sorted((build / "bin").glob("*_tests"))
    for program in [build / "bin" / name for name in names] or programs:
        command = [str(program)] + gtest
        if program.name in SHARDS:
            waiting += [(name, command, shard)
                        for name, shard in parts(program.name, SHARDS[program.name])]
        elif program.name in BUSY_SHARDS:
            found += [(name, command, shard)
                      for name, shard in parts(program.name, BUSY_SHARDS[program.name])]
        else:
            found.append((program.name, command, {}))
    if quick or names:
        return waiting, longest_first(found), alone
    header_check = ROOT / "tests/runtime/include/check_headers.sh"
    if pattern in header_check.name:
        found.append((header_check.name, ["sh", str(header_check), str(ROOT / "runtime/include"),
                                          "headers"], {}))
    for script in sorted(ROOT.glob("tests/surface/*_test.py")) + sorted(ROOT.glob("tests/tools/*_test.py")):
        if pattern in script.name:
            found.append((script.name, [sys.executable, str(script)], {}))
    examples = ROOT / "tests/examples/run_examples.py"
    if pattern in examples.name:
        found.append((examples.name, [sys.executable, str(examples), "--build", str(build)],
                      {}))
    for docs in sorted(ROOT.glob("tests/docs/run_docs*.py")):
        if pattern in docs.name:
            found.append((docs.name, [sys.executable, str(docs), "--build", str(build)], {}))
    python = ROOT / "tests/python/python_tests.py"
    if pattern in python.name:
        found.append((python.name, [sys.executable, str(python), "--build", str(build)], {}))
    both = ROOT / "tests/both/both_dogs_test.py"
    if pattern in both.name:
        found.append((both.name, [sys.executable, str(both), "--build", str(build)], {}))
    browser = ROOT / "tools/browser_test.py"
    if pattern in browser.name:
        # The browser draws without a graphics card and needs both cores, while its run has to keep
        # up with real time: no other test may run beside them.
        alone.append((browser.name, [sys.executable, str(browser), "--build", str(build)], {}))
    page = ROOT / "tools/page_test.py"
    if pattern in page.name:
        found.append((page.name, [sys.executable, str(page), "--build", str(build)], {}))
    for script in sorted(ROOT.glob("tests/data/*_test.py")) + sorted(ROOT.glob("tests/distribution/*_test.py")):
        if pattern in script.name:
            found.append((script.name, [sys.executable, str(script), "--build", str(build)], {}))
    return waiting, longest_first(found), alone


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--filter", default="")
    parser.add_argument("--quick", action="store_true", help="only tests that run in one process")
    parser.add_argument("--programs", nargs="+", default=[], help="only these test programs")
    arguments = parser.parse_args()
    sums = [0, 0, 0]
    build = arguments.build.resolve()
    cache = compiler_cache()
    scratch_root = build / "scratch" if cache and owns_scratch(build) else None
    if scratch_root:
        os.environ.update(cache)
    logs = FailureLogs(build)
    waiting, others, alone = jobs(build, arguments.filter, arguments.quick,
                                  arguments.programs)
    failures = []

    def count(job, result):
        name, passed, failed, skipped, output, seconds = result
        if failed:
            print(output)
            _, command, shard = job
            failures.append((name, *logs.keep(name, command, environment(shard), output)))
        extra = f", {skipped} skipped" if skipped else ""
        print(f"{name}: {passed} passed, {failed} failed{extra} ({seconds:.1f} s)", flush=True)
        sums[:] = [a + b for a, b in zip(sums, (passed, failed, skipped))]

    with JobPool(max(1, len(waiting))) as waiters, JobPool(os.cpu_count()) as pool:
        todo = {waiters.submit(run, *job, scratch_root): job for job in waiting}
        todo.update({pool.submit(run, *job, scratch_root): job for job in others})
        for future in concurrent.futures.as_completed(todo):
            count(todo[future], future.result())
    for job in alone:
        count(job, run(*job, scratch_root))
    for name, file, tests in failures:
        print(f"FAILED in {name}, kept in {file}:")
        print("\n".join(f"  {test}" for test in tests or ["(it names no test)"]))
    if logs.folder:
        print(f"logs of this run: {logs.folder}")
    if sum(sums) == 0:
        print(f"no test matches '{arguments.filter}'")
        sums[1] = 1
    print(f"{sums[0]} passed, {sums[1]} failed" + (f", {sums[2]} skipped" if sums[2] else ""))
    return 1 if sums[1] else 0


if __name__ == "__main__":
    sys.exit(main())
