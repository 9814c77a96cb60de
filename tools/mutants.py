#!/usr/bin/env python3
"""Checks the tests: changes the product in small ways, one at a time, and runs the tests.

    mutants.py [--only AREA] [--count N] [--seed N] [--build FOLDER]
    mutants.py --list              # the mutants that would be tried
    mutants.py --one NAME ...      # these mutants only, by the names that a run prints

A changed product is a mutant.  Tests that fail, crash or do not end kill it; a mutant that no test
kills is a survivor and shows a gap in the tests, or a change without effect.
tests/mutants/targets.json says which sources are changed, which tests have to notice, and how many
mutants an area has; tests/mutants/accepted.json lists survivors with the reason why no test can
kill them.  A mutant that does not compile does not count, and another one takes its place.

The mutants are made in a copy of the tree (FOLDER/source, default build/mutants), which has its own
build, so the tree itself is never changed.  The choice depends only on the seed and on the lines of
code themselves: after an edit, the other lines keep their mutants.

The last line is "N passed, N failed": failed are survivors that are not listed, and entries of the
list that name no mutant.
"""
import argparse
import collections
import hashlib
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time

from mutant_operators import mutants_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGETS = ROOT / "tests/mutants/targets.json"
ACCEPTED = ROOT / "tests/mutants/accepted.json"
# Tests of a mutant may use this much processor time: what they need without a change, five times,
# and at least 20 s.  Tests that wait for ever use none, so there is a limit of time as well; it is long,
# because other work may slow the tests down.
PROCESSOR_FACTOR, PROCESSOR_MIN_S, WAIT_MAX_S = 5, 20, 3600
MEMORY_MAX = 8 << 30  # bytes of address space: a mutant that allocates without end must not harm

Result = collections.namedtuple("Result", "area mutant outcome")  # killed, survived, accepted


def one_line(code):
    return " ".join(code.split())


def run_group(command, seconds_max=None, **options):
    """Runs a command; returns its exit status, or -1 if it needs more than `seconds_max`.

    Ends the processes that it has started, also when this program is interrupted.
    """
    process = subprocess.Popen(command, start_new_session=True, stdin=subprocess.DEVNULL, **options)
    try:
        return process.wait(seconds_max)
    except subprocess.TimeoutExpired:
        return -1
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()


class Choice:
    """A mutant of an area, with the texts that name it."""

    def __init__(self, area, mutant, source):
        self.area, self.mutant, self.source = area, mutant, source
        changed = one_line(mutant.changed)
        original = one_line(mutant.original)
        if changed == f"!({original})":
            changed = "!(...)"
        column = mutant.begin - source.rfind("\n", 0, mutant.begin)
        self.name = f"{mutant.file}:{mutant.line}:{column} '{original}' to '{changed}'"
        # The part of the line before the change, so that two equal tokens of a line differ.
        self.key = (mutant.file, mutant.text, mutant.occurrence,
                    source[source.rfind("\n", 0, mutant.begin) + 1:mutant.begin].strip(),
                    original, changed)

    def source_changed(self):
        return self.source[:self.mutant.begin] + self.mutant.changed + \
            self.source[self.mutant.end:]

    def order(self, seed):
        return hashlib.sha256(repr((seed, self.key)).encode()).hexdigest()

    def diff(self):
        begin = self.source.rfind("\n", 0, self.mutant.begin) + 1
        end = self.source.find("\n", self.mutant.end)
        old = self.source[begin:end]
        new = self.source[begin:self.mutant.begin] + self.mutant.changed + \
            self.source[self.mutant.end:end]
        return "\n".join([f"- {line}" for line in old.splitlines()] +
                         [f"+ {line}" for line in new.splitlines()])


def choices_of(name, area, seed):
    """Returns the mutants of an area in the order in which they are tried.

    Lines take turns: each line gets a second mutant only after all lines had one.
    """
    by_line = collections.defaultdict(list)
    for file in area["files"]:
        source = (ROOT / file).read_text()
        for mutant in mutants_of(file, source):
            by_line[file, mutant.line].append(Choice(name, mutant, source))
    ranked = []
    for found in by_line.values():
        found.sort(key=lambda choice: choice.order(seed))
        ranked += [(turn, choice.order(seed), choice) for turn, choice in enumerate(found)]
    return [choice for _, _, choice in sorted(ranked, key=lambda entry: entry[:2])]


class Copy:
    """The copy of the tree in which the mutants are made, and its build."""

    def __init__(self, folder, areas):
        self.source, self.build = folder / "source", folder / "build"
        self.areas = areas
        self.environment = dict(os.environ, CCACHE_NOHASHDIR="1", CCACHE_BASEDIR=str(self.source))
        self.changed = None

    def prepare(self):
        """Makes the copy equal to the tree, and configures its build."""
        listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT,
                                stdout=subprocess.PIPE, check=True).stdout.decode().split("\0")
        names = {name for name in listed if name and (ROOT / name).is_file()}
        for name in names:
            self.copy(name)
        for file in self.source.rglob("*"):
            if not file.is_dir() and str(file.relative_to(self.source)) not in names:
                file.unlink()
        sources = sorted({file for area in self.areas.values() for file in area["files"]})
        # Mutants are compiled alone, not in batches.  Without debug information this is faster.
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DOPENR_OPTIMISATION=-O1 -g0",
                        f"-DOPENR_ALONE={';'.join(sources)}"],
                       env=self.environment, stdout=subprocess.DEVNULL, check=True)

    def copy(self, name):
        """Copies a file unless the copy has the same bytes already."""
        old, new = ROOT / name, self.source / name
        if new.is_file() and new.read_bytes() == old.read_bytes():
            return
        new.parent.mkdir(parents=True, exist_ok=True)
        new.write_bytes(old.read_bytes())
        new.chmod(old.stat().st_mode)

    def change(self, choice):
        self.restore(unless=choice.mutant.file)
        (self.source / choice.mutant.file).write_text(choice.source_changed())
        self.changed = choice.mutant.file

    def restore(self, unless=None):
        if self.changed not in (None, unless):
            self.copy(self.changed)
            self.changed = None

    def make(self, area, output=subprocess.DEVNULL):
        """Builds the test programs of an area; returns whether that succeeded."""
        programs = sorted({test["program"] for test in area["tests"]})
        environment = dict(self.environment)
        if self.changed:
            environment["CCACHE_DISABLE"] = "1"  # a mutant is compiled once
        return run_group(["cmake", "--build", self.build, "-j1", "--target", *programs],
                         env=environment, stdout=output, stderr=output) == 0

    def run_test(self, test, processor_max_s):
        """Runs one test program; returns whether it passed, and its processor time in s."""
        def limit():
            seconds = int(processor_max_s)
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY_MAX, MEMORY_MAX))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        command = [self.build / "bin" / test["program"],
                   f"--gtest_filter={test.get('filter', '*')}"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        with tempfile.TemporaryDirectory(prefix="openr-mutant-") as scratch:
            status = run_group(command, WAIT_MAX_S, cwd=scratch, preexec_fn=limit,
                               env={**os.environ, "GTEST_FAIL_FAST": "1"},
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return status == 0, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


class Runner:
    """Runs mutants and keeps the results."""

    def __init__(self, copy, areas, accepted):
        self.copy, self.areas, self.accepted = copy, areas, accepted
        self.results, self.limits = [], {}

    def check_unchanged(self, name):
        """The tests of an area must pass without a change; measures the time that they need."""
        area = self.areas[name]
        if not self.copy.make(area, output=None):
            sys.exit(f"{name}: the copy of the tree does not build")
        self.limits[name] = []
        for test in area["tests"]:
            good, seconds = self.copy.run_test(test, WAIT_MAX_S)
            if not good:
                sys.exit(f"{name}: {test['program']} fails without a change")
            self.limits[name].append(max(PROCESSOR_MIN_S, PROCESSOR_FACTOR * seconds))

    def try_one(self, choice):
        """Returns whether the mutant compiles; if so, adds its result."""
        area = self.areas[choice.area]
        begin = time.monotonic()
        self.copy.change(choice)
        if not self.copy.make(area):
            return False
        built = time.monotonic()
        killed = not all(self.copy.run_test(test, limit)[0]
                         for test, limit in zip(area["tests"], self.limits[choice.area]))
        outcome = ("killed" if killed else
                   "accepted" if choice.key in self.accepted else "survived")
        self.results.append(Result(choice.area, choice, outcome))
        print(f"{len(self.results):4} {outcome:8} {choice.area} {choice.name} "
              f"({built - begin:.0f} s + {time.monotonic() - built:.0f} s)", flush=True)
        return True

    def run_area(self, name, choices, count):
        """Runs the first `count` mutants that compile, file by file: that builds least."""
        self.check_unchanged(name)
        waiting = list(choices)
        while count > 0 and waiting:
            batch, waiting = waiting[:count], waiting[count:]
            for choice in sorted(batch, key=lambda one: (one.mutant.file, one.mutant.begin)):
                count -= self.try_one(choice)
        self.copy.restore()


def accepted_keys():
    """Returns the key (Choice.key) of each entry of accepted.json."""
    return {tuple(entry[part] for part in ("file", "line", "occurrence", "before", "original",
                                           "changed"))
            for entry in json.loads(ACCEPTED.read_text())}


def unknown_entries(areas, accepted):
    """Returns the entries of accepted.json that name no mutant, since their line has changed."""
    keys = {choice.key for name, area in areas.items() for choice in choices_of(name, area, 0)}
    return sorted(accepted - keys)


def table(results, areas):
    lines = ["| area | mutants | killed | survivors with a reason | other survivors |",
             "|---|---|---|---|---|"]
    for name in [*areas, "all"]:
        outcomes = [result.outcome for result in results if name in (result.area, "all")]
        if outcomes:
            lines.append(f"| {name} | {len(outcomes)} | {outcomes.count('killed')} | "
                         f"{outcomes.count('accepted')} | {outcomes.count('survived')} |")
    return "\n".join(lines)


def print_survivors(results):
    for result in results:
        if result.outcome == "survived":
            print(f"\nsurvived: {result.mutant.name}\n{result.mutant.diff()}")
            keys = ("file", "line", "occurrence", "before", "original", "changed")
            print(json.dumps({**dict(zip(keys, result.mutant.key)), "reason": ""}))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/mutants",
                        help="folder of the copy and its build")
    parser.add_argument("--only", metavar="AREA", help="only this area")
    parser.add_argument("--count", type=int, help="mutants of each area, instead of the table's")
    parser.add_argument("--seed", type=int, default=1, help="another choice of mutants (1)")
    parser.add_argument("--list", action="store_true", help="print the mutants; run nothing")
    parser.add_argument("--one", nargs="+", metavar="NAME", help="run these mutants again")
    arguments = parser.parse_args()
    areas = json.loads(TARGETS.read_text())
    if arguments.only and arguments.only not in areas:
        sys.exit(f"no area '{arguments.only}'; there are: {', '.join(areas)}")
    accepted = accepted_keys()
    unknown = unknown_entries(areas, accepted)
    names = [arguments.only] if arguments.only else list(areas)
    choices = {name: choices_of(name, areas[name], arguments.seed) for name in names}
    counts = {name: arguments.count or areas[name]["count"] for name in names}
    if arguments.one:
        choices = {name: [choice for choice in found if choice.name in arguments.one]
                   for name, found in choices.items()}
        missing = set(arguments.one) - {one.name for found in choices.values() for one in found}
        if missing:
            sys.exit(f"no mutant has the name {sorted(missing)[0]}")
        choices = {name: found for name, found in choices.items() if found}
        counts = {name: len(found) for name, found in choices.items()}
    if arguments.list:
        for name, found in choices.items():
            for choice in found[:counts[name]]:
                print(f"{name} {choice.name}")
        return 0

    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended by a signal"))
    begin = time.monotonic()
    copy = Copy(arguments.build.resolve(), areas)
    copy.prepare()
    runner = Runner(copy, areas, accepted)
    try:
        for name, found in choices.items():
            runner.run_area(name, found, counts[name])
    finally:
        copy.restore()
        print_survivors(runner.results)
        print(f"\n{table(runner.results, areas)}\n")
    for key in unknown:
        print(f"accepted.json names no mutant of the tree: {' '.join(map(str, key))}")
    outcomes = [result.outcome for result in runner.results]
    failed = outcomes.count("survived") + len(unknown)
    if outcomes:
        print(f"{outcomes.count('killed') / len(outcomes):.1%} killed, "
              f"{outcomes.count('accepted')} survivors have a reason, "
              f"{time.monotonic() - begin:.0f} s")
    print(f"{len(outcomes) - outcomes.count('survived')} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
