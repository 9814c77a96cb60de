#!/usr/bin/env python3
"""Runs the fuzz targets (docs/reliability.md): ./dev fuzz.

  fuzz.py                            the targets, and what each reads
  fuzz.py TARGET SECONDS [--seed N]  one target
  fuzz.py all SECONDS [--seed N]     all targets, which share the seconds, two at a time
  fuzz.py planted [TARGET]           each target must find its planted bug within 60 s
                                     of processor time
  fuzz.py TARGET --show FILE         one input again
"""
import argparse
import base64
import concurrent.futures
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools"))
from job_pool import JobPool  # noqa: E402: the folder is put into the path first

WORK = os.path.join(ROOT, "build", "fuzz")  # corpora, crashes and logs
PROGRAM = os.path.join(ROOT, "build", "clang-asan", "bin", "openr_fuzz")
PROCESSES = 2
WORD_BYTES = 40  # the longest word of a dictionary
PLANTED_SECONDS = 60  # processor time in which a planted bug must be found
PLANTED_WAIT = 10  # a busy machine may take this many times as long
MIN_BYTES, MAX_BYTES = 512, 2048  # limits for the bytes of an input (bytes_limit())
SHOWN_BYTES = 4096  # a larger input is not printed
INPUT_SECONDS = 10  # limit for an input: wall time in a search, processor time when it runs alone
INPUT_WAIT = 10  # times as long a busy machine may take for an input that runs alone
# A line that says why an input crashed: of FuzzCheck(), of ASSERT(), of UndefinedBehaviorSanitizer, of an
# exception, of AddressSanitizer or libFuzzer.  What a target itself prints may have the word ERROR, too.
ERROR_LINE = re.compile(
    r"(?m)^(?:openr_fuzz: .*|.+:\d+: ASSERT\(.*|.+: runtime error: .*| +what\(\): .*|==\d+== ?ERROR: .*)$")
OPTIONS = ["-rss_limit_mb=1536", "-malloc_limit_mb=600", "-print_final_stats=1",
           "-mutate_depth=3",  # an input with more changes is hardly ever valid
           "-len_control=0",  # else no input is longer than the longest seed for a long time
           "-detect_leaks=0",  # else an input that leaves memory behind runs twice
           # Inputs with rare features are changed next, but looking for these inputs must not take
           # longer than a run; inputs that run fast are changed more often, too.
           "-entropic_number_of_rarest_features=10"]
# Objects of a robot may leave memory behind, so leaks are no findings (docs/hacking.md).
ENVIRONMENT = {**os.environ,
               # Files of a target in memory: a stick is written and removed for each input.
               **({"TMPDIR": "/dev/shm"} if os.access("/dev/shm", os.W_OK) else {}),
               "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=0",
               "UBSAN_OPTIONS": "print_stacktrace=1"}


QUIET_SECONDS = 2  # before a progress line is shown, as openr does
PAUSE_SECONDS = 0.5  # between two drawings of the progress line


def progress_text(done, total, elapsed, seconds=None):
    """Returns the text of the progress line.  `seconds` is how long all targets take; None: this
    is not known, and the time left follows from the targets that are done."""
    text = f"fuzz: {done} of {total} targets done"
    if seconds is None and done == 0:
        return text
    left = elapsed / done * (total - done) if seconds is None else seconds - elapsed
    return f"{text}, about {max(0, round(left))} s left"


class ProgressLine:
    """Shows on a terminal how many targets are done and how long the others take."""

    def __init__(self, stream):
        self.stream = stream
        self.lock = threading.Lock()  # targets report from threads
        self.is_drawn = False

    def draw(self, text):
        with self.lock:
            if self.stream.isatty():
                self.stream.write(f"\r\x1b[K{text}")
                self.stream.flush()
                self.is_drawn = True

    def say(self, text=None):
        """Clears the line, and prints `text`, if there is one, on standard output."""
        with self.lock:
            if self.is_drawn:
                self.stream.write("\r\x1b[K")
                self.stream.flush()
                self.is_drawn = False
            if text is not None:
                print(text, flush=True)


LINE = ProgressLine(sys.stderr)


def targets():
    with open(os.path.join(ROOT, "tests", "fuzz", "targets.json"), encoding="utf-8") as file:
        return json.load(file)


def seed_folders(name, found):
    """Returns the folders of seeds: the corpus, and copies of the files that targets.json names."""
    import glob
    folder = os.path.join(WORK, "seeds", name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for pattern in found["seeds"]:
        for path in glob.glob(os.path.join(ROOT, pattern)):
            copy = os.path.relpath(path, ROOT).replace(os.sep, "_")
            shutil.copyfile(path, os.path.join(folder, copy))
    own = os.path.join(ROOT, "tests", "fuzz", "corpus", name)
    return [folder] + ([own] if os.path.isdir(own) else [])


def seed_list(name, folders):
    """Writes the paths of the seeds in these folders, one in a line.  Returns the file."""
    path = os.path.join(WORK, "seeds", f"{name}.list")
    with open(path, "w", encoding="utf-8") as file:
        for folder in folders:
            file.writelines(f"{os.path.join(folder, seed)}\n" for seed in sorted(os.listdir(folder)))
    return path


def dictionary(name, found, folders):
    """Writes the words of the target: the texts in the sources of its reader, which targets.json
    names, and the words of its seeds.  Returns two files: a dictionary of libFuzzer, which has the
    numbers of the format as well, in 4 bytes, and the words for our mutator, one in a line."""
    import glob
    words = set()
    for pattern in found.get("words", []):
        for path in glob.glob(os.path.join(ROOT, pattern)):
            with open(path, encoding="utf-8") as source:
                text = re.sub(r"(?m)^#include.*$|//.*$", "", source.read())
            words.update(match for match in re.findall(r'"((?:[^"\\\n]|\\.)*)"', text)
                         if 1 <= len(match) <= WORD_BYTES and "{" not in match
                         and "\\" not in match and match.count(" ") < 2)
    for folder in folders:
        for file in os.listdir(folder):
            with open(os.path.join(folder, file), "rb") as seed:
                text = seed.read().decode("latin-1")
            words.update(word for word in re.findall(r"[A-Za-z_][\w.]*", text)
                         if len(word) <= WORD_BYTES and word.isascii())
    path = os.path.join(WORK, "seeds", f"{name}.dict")
    with open(path, "w", encoding="utf-8") as file:
        for number, word in enumerate(sorted(words)):
            file.write(f'word{number}="{word}"\n')
        for number in found.get("numbers", []):
            word = "".join(f"\\x{byte:02x}" for byte in number.to_bytes(4, "little"))
            file.write(f'number{number}="{word}"\n')
    lines = os.path.join(WORK, "seeds", f"{name}.words")
    with open(lines, "w", encoding="utf-8") as file:
        file.writelines(f"{word}\n" for word in sorted(words))
    return path, lines


def bytes_limit(found, largest):
    """Returns how many bytes an input may have: max_bytes of targets.json, or twice as many as the
    largest seed, because long inputs of a short format are mostly junk, or the largest seed."""
    limit = found.get("max_bytes", min(MAX_BYTES, max(MIN_BYTES, 2 * largest)))
    return max(limit, largest)


def write_times(folder):
    """Returns when each file of the folder was written."""
    return {file.name: file.stat().st_mtime_ns for file in os.scandir(folder)}


def written_since(before, folder):
    """Returns the files that were written in the folder since write_times(folder) returned `before`.
    An input that crashed in an earlier run as well is written again, under the same name."""
    return [os.path.join(folder, file) for file, time_ns in sorted(write_times(folder).items())
            if before.get(file) != time_ns]


def is_slow(name, path):
    """Runs one input alone, whose time was over in a search.  Returns whether the input takes too
    much processor time, waits for ever, or crashes.  The search counts wall time, which says little
    on a busy machine."""
    run = subprocess.run(["prlimit", f"--cpu={INPUT_SECONDS}", PROGRAM, name,
                          f"-timeout={INPUT_SECONDS * INPUT_WAIT}", path], env=ENVIRONMENT,
                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return run.returncode != 0


def search(name, command, folders, seconds, crashes):
    """Runs libFuzzer for these seconds, and goes on after an input whose time was over only because
    the machine was busy.  Returns the last status, the whole output, and the sum of executions."""
    end = time.monotonic() + seconds
    texts, executions = [], 0
    while True:
        before = write_times(crashes)
        left = max(1, round(end - time.monotonic()))
        run = subprocess.run(command + [f"-max_total_time={left}"] + folders, env=ENVIRONMENT,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        texts.append(run.stdout.decode(errors="replace"))
        counts = (re.findall(r"stat::number_of_executed_units:\s*(\d+)", texts[-1])
                  or re.findall(r"^#(\d+)", texts[-1], re.MULTILINE))
        executions += int(counts[-1]) if counts else 0
        late = [path for path in written_since(before, crashes)
                if os.path.basename(path).startswith("timeout-")]
        if not late or any(is_slow(name, path) for path in late):
            return run.returncode, "".join(texts), executions
        for path in late:
            os.remove(path)
        texts[-1] = re.sub(r"(?m)^==\d+== ?ERROR: libFuzzer: timeout", "a busy machine: timeout",
                           texts[-1])
        if end - time.monotonic() < 1:
            return 0, "".join(texts), executions


def fuzz(name, found, seconds, seed, planted=False):
    """Runs one target.  Returns what libFuzzer has counted, and the inputs that crash."""
    kept = os.path.join(WORK, "planted" if planted else "corpus", name)
    crashes = os.path.join(WORK, "planted-found" if planted else "crashes", name)
    if planted or seed is not None:  # an empty corpus, because inputs that earlier runs have found must not help
        kept += f"-{os.getpid()}"
    for folder in (kept, crashes):
        os.makedirs(folder, exist_ok=True)
    before = write_times(crashes)
    seeds = seed_folders(name, found)
    words, lines = dictionary(name, found, seeds)
    command = [PROGRAM, name, "--words", lines, "--seeds", seed_list(name, seeds)]
    command += (["--planted"] if planted else []) + OPTIONS
    input_seconds = INPUT_SECONDS
    if planted:  # processor time, so that a busy machine finds what an idle one does
        command = ["prlimit", f"--cpu={seconds}"] + command
        seconds *= PLANTED_WAIT
        input_seconds *= INPUT_WAIT
    command += [f"-timeout={input_seconds}", f"-artifact_prefix={crashes}/"]
    folders = [kept] + seeds
    # Else an input is also kept for taking a known branch another number of times.
    command += [] if found.get("counts", True) else ["-use_counters=0"]
    command += [f"-dict={words}"] if os.path.getsize(words) > 0 else []  # libFuzzer refuses an empty dictionary
    sizes = [os.path.getsize(os.path.join(folder, file))
             for folder in folders for file in os.listdir(folder)]
    command += [f"-max_len={bytes_limit(found, max(sizes, default=0))}"]
    command += [f"-seed={seed}"] if seed is not None else []
    status, text, executions = search(name, command, folders, seconds, crashes)
    if planted or seed is not None:
        shutil.rmtree(kept)
    with open(os.path.join(WORK, f"{name}.log"), "w", encoding="utf-8") as log:
        log.write(text)
    edges = re.findall(r"cov: (\d+)", text)
    return {"status": status, "text": text, "executions": executions,
            "edges": max(map(int, edges), default=0),
            "crashes": written_since(before, crashes)}


def report(name, result):
    LINE.say(f"{name:16} {result['executions']:>10,} executions  {result['edges']:>6,} edges  "
             f"{len(result['crashes'])} crashes")
    if result["status"] == 0:
        return True
    for crash in result["crashes"]:
        LINE.say(f"  {os.path.relpath(crash, ROOT)}")
        LINE.say(f"  again: ./dev fuzz {name} --show {os.path.relpath(crash, ROOT)}")
        with open(crash, "rb") as file:
            content = file.read()
        if len(content) <= SHOWN_BYTES:
            LINE.say(f"  its content, for base64 -d: {base64.b64encode(content).decode()}")
    if not result["crashes"]:
        LINE.say(f"  openr_fuzz ended with status {result['status']}")
    for line in ERROR_LINE.findall(result["text"])[:5]:
        LINE.say(f"  {line}")
    LINE.say(f"  its output: build/fuzz/{name}.log")
    return False


def seconds_each(seconds, count):
    """Returns the share of each of `count` targets in `seconds`, rounded up, so that all together
    do not get less."""
    return -(-seconds // count)


def run_all(names, work, seconds=None, quiet=QUIET_SECONDS, clock=time.monotonic):
    """Calls work(name) for all names, two at a time.  Shows the progress meanwhile; `seconds` is
    how long one call takes, if that is known.  Returns how many calls returned True."""
    whole = None if seconds is None else seconds * -(-len(names) // PROCESSES)
    begin = clock()
    with JobPool(PROCESSES) as pool:
        calls = [pool.submit(work, name) for name in names]
        waiting = set(calls)
        while waiting:
            _, waiting = concurrent.futures.wait(waiting, PAUSE_SECONDS)
            elapsed = clock() - begin
            if waiting and elapsed >= quiet:
                LINE.draw(progress_text(len(names) - len(waiting), len(names), elapsed, whole))
    LINE.say()
    return sum(call.result() for call in calls)


def main():
    known = targets()
    parser = argparse.ArgumentParser(prog="./dev fuzz", usage="\n" + __doc__)
    parser.add_argument("target", nargs="?")
    parser.add_argument("argument", nargs="?")
    parser.add_argument("--seed", type=int)
    parser.add_argument("--show", metavar="FILE")
    options = parser.parse_args()
    if options.target is None:
        for name, found in known.items():
            print(f"{name:16} {found['reads']}")
        return 0
    if options.target not in [*known, "all", "planted"]:
        parser.error(f"there is no target '{options.target}'; ./dev fuzz lists them")
    if options.show:
        return subprocess.run([PROGRAM, options.target, options.show], env=ENVIRONMENT,
                              check=False).returncode
    if options.target == "planted":
        return planted_bugs(known, options)
    if options.argument is None or not options.argument.isdigit() or int(options.argument) < 1:
        parser.error("the seconds are missing: ./dev fuzz TARGET SECONDS")
    names = list(known) if options.target == "all" else [options.target]
    seconds = seconds_each(int(options.argument), len(names))

    good = run_all(names, lambda name: report(name, fuzz(name, known[name], seconds, options.seed)),
                   seconds)
    print(f"{good} passed, {len(names) - good} failed")
    return 0 if good == len(names) else 1


def planted_line(name, result, is_found):
    """Returns the line that says how the search for the planted bug of a target has ended."""
    line = f"{name:16} {'found' if is_found else 'NOT FOUND'} after {result['executions']:,} executions"
    if not is_found and result["status"] == 0:  # libFuzzer has ended, and not the limit of processor time
        line += (f"; the machine was too busy: {PLANTED_SECONDS * PLANTED_WAIT} s did not give the target "
                 f"its {PLANTED_SECONDS} s of processor time")
    return line


def planted_bugs(known, options):
    if options.argument and options.argument not in known:
        sys.exit(f"fuzz: there is no target '{options.argument}'")

    def find(name):
        result = fuzz(name, known[name], PLANTED_SECONDS, options.seed or 1, planted=True)
        is_found = "openr_fuzz: the planted bug" in result["text"]
        LINE.say(planted_line(name, result, is_found))
        return is_found

    names = [options.argument] if options.argument else list(known)
    good = run_all(names, find)
    print(f"{good} passed, {len(names) - good} failed")
    return 0 if good == len(names) else 1


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    sys.exit(main())
