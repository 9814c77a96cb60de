#!/usr/bin/env python3
"""tools/failure_logs.py and tools/run_tests.py: what is kept of failed tests, and for how long.  The last line is
"N passed, N failed"."""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import failure_logs  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

# A test program with a test that fails and prints a seed.
PROGRAM = """#!/bin/sh
cat <<END
[ RUN      ] A.One
seed=42: 3 is not 4
[  FAILED  ] A.One (1 ms)
1 passed, 1 failed
END
exit 1
"""
GOOD = "#!/bin/sh\necho 2 passed, 0 failed\n"


def run_tests(build, *flags):
    """Runs tools/run_tests.py for the programs of the build; returns what it printed."""
    done = subprocess.run([sys.executable, ROOT / "tools/run_tests.py", "--build", build, *flags],
                          capture_output=True, text=True, env={**os.environ, "CI": "true"}, check=False)
    return done.stdout + done.stderr


def write(build, name, text):
    file = build / "bin" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


def check_runs():
    with tempfile.TemporaryDirectory() as name:
        build = Path(name).resolve()
        write(build, "bad_tests", PROGRAM)
        write(build, "good_tests", GOOD)
        said = run_tests(build, "--programs", "bad_tests", "good_tests")
        folders = list((build / "failed").iterdir())
        verdict("a run with failures has a folder, named by its time",
                len(folders) == 1 and re.fullmatch(r"\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d", folders[0].name), said)
        verdict("the folder has the logs of programs with failures",
                [file.name for file in folders[0].iterdir()] == ["bad_tests.log"])
        verdict("the failed names and the folder stand above the last line", said.endswith(
            f"FAILED in bad_tests, kept in {folders[0]}/bad_tests.log:\n  A.One\n"
            f"logs of this run: {folders[0]}\n3 passed, 1 failed\n"), said)
        log = (folders[0] / "bad_tests.log").read_text()
        program = build / "bin/bad_tests"
        again = log.splitlines()[1]
        verdict("the log begins with the commands and the seed",
                again.endswith(str(program)) and "only the tests that failed:\n" in log and
                f"{program} --gtest_filter=A.One\nseeds that it printed: 42\n\n[ RUN " in log, log)
        outcome = subprocess.run(["sh", "-c", again], capture_output=True, text=True, check=False)
        verdict("the command shows the failure again", "[  FAILED  ] A.One" in outcome.stdout, again)
        said = run_tests(build, "--programs", "good_tests")
        verdict("a good run keeps the logs of others", log == (folders[0] / "bad_tests.log").read_text() and
                len(list((build / "failed").iterdir())) == 1 and "logs of this run" not in said, said)


def check_folders():
    with tempfile.TemporaryDirectory() as name:
        build = Path(name)
        (build / "failed").mkdir()
        (build / "failed/notes").mkdir()
        (build / "failed/old.log").touch()
        for day in range(1, 26):
            (build / f"failed/2001-01-{day:02}_00-00-00").mkdir()
        logs = [failure_logs.FailureLogs(build) for _ in range(2)]
        logs[1].begin = logs[0].begin
        folders = [log.keep("a_tests 1/2", ["/b/a_tests"], {}, "")[0].parent for log in logs]
        verdict("two runs of the same second have their own folders",
                folders[1].name == folders[0].name + "-2", str(folders))
        left = sorted(path.name for path in (build / "failed").iterdir())
        verdict("the last 20 runs are kept, and what is no run",
                left[:2] == ["2001-01-08_00-00-00", "2001-01-09_00-00-00"] and len(left) == 20 + 2 and
                left[-2:] == ["notes", "old.log"], str(left))
        logs[1].begin, logs[1].folder = "1999-01-01_00-00-00", None
        logs[1].keep("a", ["a"], {}, "")
        verdict("a clock that was set back removes no log of this run", logs[1].folder.is_dir())


def check_commands():
    def text(output, command=("/b/x_tests",), variables=None):
        return failure_logs.again(list(command), variables or {}, output)

    failed = "[  FAILED  ] B/0.Two\n[  FAILED  ] A.One, where GetParam() = 3\n"
    parts = {"GTEST_TOTAL_SHARDS": "2", "GTEST_SHARD_INDEX": "1", "SOME_VARIABLE": "two words"}
    said = text(failed, ["/b/x_tests", "--gtest_filter=*word*"], parts)
    verdict("all of a part is run again as it was",
            "GTEST_SHARD_INDEX=1 GTEST_TOTAL_SHARDS=2 SOME_VARIABLE='two words' /b/x_tests '--gtest_filter=*word*'\n"
            in said, said)
    verdict("its failed tests run without the split into parts",
            "\nSOME_VARIABLE='two words' /b/x_tests --gtest_filter=A.One:B/0.Two\n" in said, said)
    verdict("variables that the shell has are left out", "PATH" not in text("", variables={"PATH": os.environ["PATH"]}))
    said = text("Note: Randomizing tests' orders with a seed of 7 .\n" + failed)
    verdict("the order of a shuffled program is kept",
            said.count("/b/x_tests --gtest_shuffle --gtest_random_seed=7") == 2 and "printed: 7\n" in said, said)
    said = text(failed, ["/b/script.py"])
    verdict("a script has no filter of GoogleTest", "gtest_filter" not in said, said)
    said = text("seed 5, seed=6\nrun --seed 5; Seed: 8; seeds 9; exceed 3; seed of 11\n")
    verdict("seeds are found", "seeds that it printed: 5, 6, 8, 11\n" in said, said)
    verdict("a log without seeds has no such line", "seeds" not in text("no number"))


check_runs()
check_folders()
check_commands()
sys.exit(finish())
