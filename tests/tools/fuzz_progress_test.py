#!/usr/bin/env python3
"""tests/fuzz/fuzz.py: the progress line and the reports of ./dev fuzz, the limits of inputs and the shares of targets.  The last line is "N passed, N failed"."""
import contextlib
import io
import sys
import tempfile
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/fuzz")]
import fuzz  # noqa: E402
from verdicts import finish, verdict  # noqa: E402


class Stream(io.StringIO):
    """A stream that says whether it is a terminal, and tells when something is written to it."""

    def __init__(self, is_terminal):
        super().__init__()
        self.is_terminal = is_terminal
        self.is_written = threading.Event()

    def isatty(self):
        return self.is_terminal

    def write(self, text):
        self.is_written.set()
        return super().write(text)


def drawn(is_terminal, quiet=0):
    """Returns what run_all() writes to the stream, while its calls wait for a drawing."""
    stream = Stream(is_terminal)
    fuzz.LINE = fuzz.ProgressLine(stream)
    waits = is_terminal and quiet == 0

    def work(name):
        return name != "bad" and (not waits or stream.is_written.wait(60))

    good = fuzz.run_all(["mtn", "bad", "cfg"], work, 10, quiet, clock=lambda: 0)
    verdict(f"calls that return True are counted ({is_terminal}, {quiet})", good == 2, str(good))
    return stream.getvalue()


def check(name, text, expected):
    verdict(name, text == expected, f"{text!r}, not {expected!r}")


check("a known duration gives the time left", fuzz.progress_text(0, 4, 30, 100),
      "fuzz: 0 of 4 targets done, about 70 s left")
check("a target that ends late leaves no negative time", fuzz.progress_text(3, 4, 105, 100),
      "fuzz: 3 of 4 targets done, about 0 s left")
check("else the time left follows from the targets that are done", fuzz.progress_text(1, 4, 20),
      "fuzz: 1 of 4 targets done, about 60 s left")
check("and is not known before the first", fuzz.progress_text(0, 4, 20),
      "fuzz: 0 of 4 targets done")

verdict("an input may be twice as long as the largest seed",
        [fuzz.bytes_limit({}, size) for size in (0, 24, 600, 1500, 9000)]
        == [512, 512, 1200, 2048, 9000])
verdict("a target limits its inputs, but not its seeds",
        [fuzz.bytes_limit({"max_bytes": 256}, size) for size in (24, 300)] == [256, 300])

shown = drawn(is_terminal=True)
verdict("a terminal shows the line", " of 3 targets done, about 20 s left" in shown, shown)
verdict("the line is cleared at the end", shown.endswith("\r\x1b[K"), repr(shown))
check("a pipe shows nothing", drawn(is_terminal=False), "")
check("a short run shows nothing", drawn(is_terminal=True, quiet=60), "")
verdict("targets that share seconds do not get less in all",
        [fuzz.seconds_each(*share) for share in ((300, 35), (35, 35), (1, 35), (60, 1))] == [9, 1, 1, 60])


def reported(text, content, status=77):
    """Returns what report() prints of a run that has printed `text`, and in which `content` crashed."""
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
        crash = Path(folder, "crash-1")
        crash.write_bytes(content)
        good = fuzz.report("mtn", {"status": status, "text": text, "executions": 5, "edges": 6,
                                   "crashes": [str(crash)] if status else []})
        verdict(f"status {status} is {'a failure' if status else 'good'}", good == (status == 0))
    return printed.getvalue().splitlines()


REASONS = ["a.cc:3:4: runtime error: signed integer overflow", "  what():  no number",
           "==12==ERROR: AddressSanitizer: heap-use-after-free", "==12== ERROR: libFuzzer: deadly signal",
           "openr_fuzz: each request has an answer"]
NOISE = [f"[oid:0x1] ERROR: {i}" for i in range(9)]
lines = reported("\n".join(NOISE + REASONS + NOISE), b"\0\xff")
verdict("a crash is reported with its reasons, and not with what the target has printed",
        lines[-6:-1] == [f"  {reason}" for reason in REASONS] and not [line for line in lines if "[oid" in line],
        "\n".join(lines))
check("a small input is printed", [line for line in lines if "base64" in line],
      ["  its content, for base64 -d: AP8="])
for size in (fuzz.SHOWN_BYTES, fuzz.SHOWN_BYTES + 1):
    shown = [line for line in reported(REASONS[0], bytes(size)) if "base64" in line]
    verdict(f"an input of {size} bytes is {'printed' if size == fuzz.SHOWN_BYTES else 'too large'}",
            len(shown) == (size == fuzz.SHOWN_BYTES), "\n".join(shown))
check("a good run is one line", reported("ERROR", b"", status=0),
      ["mtn                       5 executions       6 edges  0 crashes"])


def arguments_of(found, seed=None, planted=False):
    """Returns the arguments with which fuzz() starts the fuzz program for the target mtn."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "openr_fuzz"
        program.write_text("#!/bin/sh\nprintf '%s\\n' \"$@\"\n", encoding="utf-8")
        program.chmod(0o755)
        before, fuzz.PROGRAM, fuzz.WORK = (fuzz.PROGRAM, fuzz.WORK), str(program), folder
        try:
            return fuzz.fuzz("mtn", found, 5, seed, planted)["text"].splitlines()
        finally:
            fuzz.PROGRAM, fuzz.WORK = before


SEEDS = {"seeds": ["tests/fuzz/corpus/mtn/*"]}
verdict("counts of branches keep an input, unless the target says that they do not",
        ["-use_counters=0" in arguments_of({**SEEDS, **counts})
         for counts in ({}, {"counts": True}, {"counts": False})] == [False, False, True])
verdict("the program is told the seed of a run, and none if there is none",
        [[word for word in arguments_of(SEEDS, seed) if word.startswith("-seed=")]
         for seed in (7, 0, None)] == [["-seed=7"], ["-seed=0"], []])
verdict("a search for the planted bug may take ten times as long as its processor time",
        [[word for word in arguments_of(SEEDS, 1, planted) if word.startswith("-max_total_time")]
         for planted in (False, True)] == [["-max_total_time=5"], ["-max_total_time=50"]])


def crashes_of_two_runs():
    """Returns the names of the inputs that crash in each of two runs of a program that finds the same bug."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "openr_fuzz"
        program.write_text(f"#!/bin/sh\necho 1 >'{folder}/crashes/mtn/crash-1'\nexit 77\n", encoding="utf-8")
        program.chmod(0o755)
        other = Path(folder, "crashes/mtn/crash-0")  # found by an earlier run
        other.parent.mkdir(parents=True)
        other.touch()
        before, fuzz.PROGRAM, fuzz.WORK = (fuzz.PROGRAM, fuzz.WORK), str(program), folder
        try:
            return [[Path(crash).name for crash in fuzz.fuzz("mtn", SEEDS, 5, 1)["crashes"]] for _ in range(2)]
        finally:
            fuzz.PROGRAM, fuzz.WORK = before


found = crashes_of_two_runs()
verdict("an input that crashes again is reported again", found == [["crash-1"], ["crash-1"]], str(found))


def result_of_late_input(alone):
    """Returns what fuzz() finds with a program whose first search ends at a time limit, and which
    runs the shell command `alone` for the input by itself.  Searches after the first are good."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "openr_fuzz"
        program.write_text(f"""#!/bin/sh
for word; do
  case $word in
    -artifact_prefix=*) late=${{word#*=}}timeout-1 ;;
    */timeout-1) {alone} ;;
  esac
done
echo 'stat::number_of_executed_units: 5'
[ -e {folder}/begun ] && exit 0
echo x | tee {folder}/begun >$late
echo '==7== ERROR: libFuzzer: timeout after 12 seconds'
exit 70
""", encoding="utf-8")
        program.chmod(0o755)
        before = fuzz.PROGRAM, fuzz.WORK, fuzz.INPUT_SECONDS
        fuzz.PROGRAM, fuzz.WORK, fuzz.INPUT_SECONDS = str(program), folder, 1
        try:
            return fuzz.fuzz("mtn", SEEDS, 5, 1)
        finally:
            fuzz.PROGRAM, fuzz.WORK, fuzz.INPUT_SECONDS = before


late = result_of_late_input("exit 0")
check("an input that was late on a busy machine is no crash, and the search goes on",
      (late["status"], late["crashes"], late["executions"], fuzz.ERROR_LINE.findall(late["text"])),
      (0, [], 10, []))
for alone, why in (("while :; do :; done", "takes too much processor time"), ("exit 70", "waits for ever")):
    late = result_of_late_input(alone)
    check(f"an input that {why} is a crash",
          (late["status"], [Path(crash).name for crash in late["crashes"]], late["executions"]),
          (70, ["timeout-1"], 5))

ENDED_BY_CPU, ENDED_BY_CLOCK = -24, 0  # statuses; the first is SIGXCPU
check("a search that had its processor time says only that it found nothing",
      fuzz.planted_line("mtn", {"executions": 5000, "status": ENDED_BY_CPU}, False),
      "mtn              NOT FOUND after 5,000 executions")
check("a search that the clock ended says so",
      fuzz.planted_line("mtn", {"executions": 5, "status": ENDED_BY_CLOCK}, False),
      "mtn              NOT FOUND after 5 executions; the machine was too busy: "
      "600 s did not give the target its 60 s of processor time")
check("a bug that is found needs no reason",
      fuzz.planted_line("mtn", {"executions": 5, "status": 77}, True),
      "mtn              found after 5 executions")


def seconds_of_main(*arguments):
    """Returns the seconds that main() gives to each target."""
    given = []
    fuzz.targets = lambda: dict.fromkeys(["mtn", "cfg", "wav"], {})
    fuzz.fuzz = lambda name, found, seconds, seed: given.append(seconds)
    fuzz.report = lambda name, result: True
    sys.argv = ["fuzz.py", *arguments]
    with contextlib.redirect_stdout(io.StringIO()):
        fuzz.main()
    return given


check("all targets share the seconds", seconds_of_main("all", "10"), [4, 4, 4])
check("one target gets all seconds", seconds_of_main("cfg", "10"), [10])

sys.exit(finish())
