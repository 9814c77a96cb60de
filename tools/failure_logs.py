"""Keeps what failed test programs printed: in the folder `failed` of a build, a folder for each run."""
import os
import re
import shlex
import shutil
import time

RUNS_KEPT = 20  # the runs with failures whose logs stay
RUN = re.compile(r"\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d(-\d+)?")
FAILED = re.compile(r"^\[  FAILED  \] ([\w/]+\.[\w/]+)", re.MULTILINE)
# Words before a seed: "seed 5", "seed=5", "seed: 5", "--seed 5"; GoogleTest prints "a seed of 5".
SEED = re.compile(r"\bseed(?:\s*[=:]\s*|\s+of\s+|\s+)(\d+)", re.IGNORECASE)
SHUFFLED = re.compile(r"^Note: Randomizing tests' orders with a seed of (\d+)", re.MULTILINE)
STARTED_WITH = dict(os.environ)


def as_text(command, variables):
    """Returns what a person types in a shell for the command with these environment variables."""
    return " ".join([f"{name}={shlex.quote(value)}" for name, value in sorted(variables.items())] +
                    [shlex.quote(str(word)) for word in command])


def again(command, variables, output):
    """Returns the lines that say how to run a failed program again, all of it and only its failed tests."""
    # The shell of a person has the variables that this script was started with, and not the others.
    variables = {name: value for name, value in variables.items() if STARTED_WITH.get(name) != value}
    shuffled = SHUFFLED.search(output)
    if shuffled:
        command = [*command, "--gtest_shuffle", f"--gtest_random_seed={shuffled[1]}"]
    text = f"to run it again, in an empty folder:\n{as_text(command, variables)}\n"
    tests = sorted(set(FAILED.findall(output)))
    if tests and str(command[0]).endswith("_tests"):
        words = [word for word in command if not str(word).startswith("--gtest_filter=")]
        # A part of a program runs every nth test only, so a failed test would be left out.
        variables = {name: value for name, value in variables.items()
                     if name not in ("GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX")}
        only = as_text([*words, f"--gtest_filter={':'.join(tests)}"], variables)
        text += f"only the tests that failed:\n{only}\n"
    seeds = list(dict.fromkeys(SEED.findall(output)))
    if seeds:
        text += f"seeds that it printed: {', '.join(seeds)}\n"
    return text


class FailureLogs:
    """The logs of one run, in build/failed/DATE_TIME; the folder is made for the first failure."""

    def __init__(self, build):
        self.parent = build / "failed"
        self.begin = time.strftime("%Y-%m-%d_%H-%M-%S")
        self.folder = None

    def keep(self, name, command, variables, output):
        """Writes the output of a failed program to a file.

        Returns the file and the names of the failed tests.
        """
        if self.folder is None:
            self._make_folder()
        file = self.folder / (re.sub(r"[^\w.]+", "-", name) + ".log")
        file.write_text(f"{again(command, variables, output)}\n{output}")
        return file, sorted(set(FAILED.findall(output)))

    def _make_folder(self):
        """Makes the folder of this run, and removes those of the oldest runs."""
        count = 1
        while self.folder is None:
            folder = self.parent / (self.begin if count == 1 else f"{self.begin}-{count}")
            try:
                folder.mkdir(parents=True)
                self.folder = folder
            except FileExistsError:  # another run of the same second has it
                count += 1
        others = sorted(path for path in self.parent.iterdir()
                        if RUN.fullmatch(path.name) and path != self.folder)
        for old in others[:max(0, len(others) + 1 - RUNS_KEPT)]:
            shutil.rmtree(old, ignore_errors=True)
