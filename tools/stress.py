#!/usr/bin/env python3
"""Runs programs again and again on a busy machine, whose runs must be those of a quiet machine.

    stress.py --build build/release [--rounds-two 1000] [--rounds 50] [--seed 1] [--jobs 2]
              [--only WORD] [--examples NAME...]

Meanwhile a process for each processor computes, one writes to the disk, and the processes of each
run are stopped (SIGSTOP) and continued (SIGCONT) at random.  A round runs a program in one process
and with each object in a process of its own.  The hashes of trace and state in both reports must be
those of a run in one process on the quiet machine, which must end well: status 0, all tests pass,
nothing differs, the client has its answers.  The examples ManyToMany and StandUp have --rounds-two
rounds.  All other examples have --rounds rounds, and so have the default stick, the conformance
tests and `openr explore --verify`.  Examples on the network are asked by a client; such a run cannot
be repeated, so its recording is replayed.

A run that ends because a process was not heard for too long, with the reason in its report, is a
refusal.  Refusals are counted apart from differences, and at most 2 % of the runs of a program may
be refused.  Stops are much shorter than the leases, and one more run, with a worker that is stopped
for longer than its lease, must be refused.  The last line is "N passed, N failed".
"""
import argparse
import collections
import concurrent.futures
import contextlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/examples")]
import network_checks  # noqa: E402: the folders are put into the path first
from example import Example, Running, isolated, objects_of  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

TWO = ("ManyToMany", "StandUp")
LIVE = ("EchoClient", "EchoServer", "HttpServer", "UdpEcho")
OTHERS = ("BallChaser", "Camera", "Ears", "Hello", "Lights", "PowerMonitor", "Recorder", "Sensors",
          "TalkListen", "Tone", *LIVE)
SEEDS = 5
HANG_S = 600
# Virtual time of a run.  BallChaser looks at camera images, which take longer.
TIMES = collections.defaultdict(lambda: "2s", BallChaser="1s")
LONGEST_PAUSE_S = 0.06  # between two stops
LONGEST_STOP_S = 0.3
# A domain of its own, because other tests kill processes whose leases last an hour.
DOMAIN = ("--dds-domain", "79")
# None is expected, but a machine may be busier than the limits in real time allow.
REFUSALS_MOST = 0.02
# Reasons with which a run or an exploration gives up because a process was not heard for too long.
REFUSAL = re.compile(r"[^\n]*(cannot be reached any more|did not join|has not joined|\(--join-wait\)"
                     r"|did not end within \d+ s of real time)[^\n]*")

# The result of a run: what must be equal, or the reason of a refusal.
Outcome = collections.namedtuple("Outcome", "text refusal")


def family(pid):
    """Returns the ids of a process and of all its descendants."""
    found = [pid]
    for parent in found:
        with contextlib.suppress(OSError):  # a process may end meanwhile
            for thread in os.listdir(f"/proc/{parent}/task"):
                children = pathlib.Path(f"/proc/{parent}/task/{thread}/children").read_text()
                found += map(int, children.split())
    return found


class Stops:
    """Stops and continues the processes of a run at random, while the context lasts."""

    def __init__(self, pid, dice):
        self.pid, self.dice = pid, dice
        self.count = 0
        self.is_over = threading.Event()
        self.thread = threading.Thread(target=self.run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.is_over.set()
        self.thread.join()

    def run(self):
        while not self.is_over.wait(self.dice.random() * LONGEST_PAUSE_S):
            self.stop(self.dice.choice(family(self.pid)), self.dice.random() ** 3 * LONGEST_STOP_S)

    def stop(self, pid, seconds):
        try:
            handle = os.pidfd_open(pid)
        except OSError:
            return
        try:
            # The handle belongs to a process of the run only if the run still has the id.
            if pid not in family(self.pid):
                return
            signal.pidfd_send_signal(handle, signal.SIGSTOP)
            self.count += 1
            self.is_over.wait(seconds)
            signal.pidfd_send_signal(handle, signal.SIGCONT)
        except ProcessLookupError:
            pass
        finally:
            os.close(handle)


def run_stopped(command, dice):
    """Runs a command, with stops if there are dice; returns status, outputs and number of stops."""
    process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, errors="replace")
    try:
        with Stops(process.pid, dice) if dice else contextlib.nullcontext() as stops:
            out, err = process.communicate(timeout=HANG_S)
    finally:
        process.kill()
        process.wait()
    return process.returncode, out, err, stops.count if stops else 0


def parse(out, key):
    """Returns the JSON object that a program has printed, or None if it lacks `key`."""
    with contextlib.suppress(ValueError):
        answer = json.loads(out)
        return answer if key in answer else None
    return None


def outcome_of(text, said):
    """Returns an outcome whose text is empty because the run was refused, or which is compared."""
    refusal = REFUSAL.search(said)
    return Outcome(text, "") if refusal is None else Outcome("", refusal[0])


class Stick:
    """The programs of a stick, for a span of virtual time without anybody outside."""

    good = r"status 0, trace \w+ state \w+ of [1-9]"  # the begin of the outcome of a quiet run

    def __init__(self, openr, name, stick, scratch, span):
        self.name, self.openr, self.stick, self.scratch, self.span = name, openr, stick, scratch, span
        self.objects = objects_of(parse(self.run(1, (), None)[1], "objects"))

    def run(self, seed, more, dice):
        # Each run has a stick of its own, because some programs write files.
        with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
            stick = pathlib.Path(folder) / "stick"
            shutil.copytree(self.stick, stick)
            return run_stopped([self.openr, "run", "--stick", stick, "--rate", "max", "--no-panel",
                                "--rc-port", "0", "--json", "--for", self.span, "--seed", seed,
                                "--console", os.devnull, *more], dice)

    def outcome(self, seed, apart, dice):
        """Runs once; returns the outcome and the number of stops."""
        status, out, err, stops = self.run(
            seed, (*isolated(self.objects), *DOMAIN) if apart else (), dice)
        report = parse(out, "trace_hash")
        if report is None:
            return outcome_of(f"status {status}, no report: {out}{err}", out + err), stops
        findings = [finding["text"] for finding in report["findings"]]
        text = f"status {status}, trace {report['trace_hash']} state {report['state_hash']} of {report['messages']} " \
               f"messages, findings {findings}"
        return outcome_of(text, f"{report['ended_why']}\n{findings}" if status else ""), stops


class Suite:
    """The conformance tests; the outcome is the result of each test."""

    name = "conformance tests"
    good = "all tests pass$"

    def __init__(self, build):
        self.commands = {False: [build / "bin/conformance_tests"],
                         True: [build / "bin/distribution_tests", "--gtest_filter=*Conformance.*"]}

    def outcome(self, seed, apart, dice):
        status, out, err, stops = run_stopped(self.commands[apart], dice)
        results = sorted(set(re.findall(r"^\[ +(?:OK|FAILED) +\] \w+\.\w+", out, re.M)))
        failed = [line for line in results if "FAILED" in line]
        said = "\n".join(re.findall(r"^.*: Failure\n(?:.*\n){1,12}", out + err, re.M))
        text = "all tests pass" if status == 0 and results else \
            f"status {status}, {len(results)} results, failed {failed}\n{said}{err[-2000:]}"
        return outcome_of(text, said), stops


class Exploration:
    """Seeds of the default stick, explored twice each."""

    name = "explore --verify"
    good = r"digest \w+, 0 differences, 0 depend on addresses, 0 broken$"

    def __init__(self, openr):
        self.openr = openr

    def outcome(self, seed, apart, dice):
        """`apart` means two jobs in place of one; explored objects are never apart."""
        _, out, err, stops = run_stopped(
            [self.openr, "explore", "--verify", "--runs", "10", "--for", "1s", "--seed",
             str(10 * seed), "--jobs", "2" if apart else "1", "--keep-going", "--json"], dice)
        result = parse(out, "digest")
        if result is None:
            return outcome_of(f"no result: {out}{err}", ""), stops
        text = f"digest {result['digest']}, {result['differences']} differences, " \
               f"{result['address_dependent']} depend on addresses, {result['broken']} broken"
        return outcome_of(text, err), stops


class Live:
    """An example on the network, asked by a client; the recording of each run is replayed."""

    good = "equal$"

    def __init__(self, example):
        self.name, self.example = example.name, example
        self.lock = threading.Lock()  # the port is compiled in, so there is one run at a time

    def outcome(self, seed, apart, dice):
        with self.lock:
            example = self.example
            example.apart, example.complaints = apart, []
            more = DOMAIN if apart else ("--record", str(example.recording))
            with Running(example, "--seed", str(seed), *more, rate=network_checks.RATE) \
                    as robot, Stops(robot.process.pid, dice) if dice else contextlib.nullcontext() \
                    as stops:
                try:
                    getattr(self, f"ask_{self.name}")(robot)
                except (OSError, RuntimeError) as error:
                    example.complaints.append(f"the client fails: {error!r}")
                if stops:
                    stops.is_over.set()
                robot.press_pause()
            if not apart:  # otherwise press_pause() has replayed the recording
                example.replay()
            text = "\n".join(example.complaints)
            return outcome_of(text or "equal", text), stops.count if stops else 0

    def ask_EchoServer(self, robot):
        with robot.connect(self.port) as client:
            for text in (b"hello\n", bytes(range(256)) * 20):
                client.sendall(text)
                answer = network_checks.receive_all(client, len(text))
                self.example.expect(answer == text, f"{text} comes back as {answer}")

    def ask_UdpEcho(self, robot):
        robot.wait_for("listening")
        with network_checks.socket.socket(type=network_checks.socket.SOCK_DGRAM) as client:
            answer = network_checks.ask_udp(client, self.port, b"hello\n")
            self.example.expect(answer == b"hello\n", f"hello comes back as {answer}")

    def ask_HttpServer(self, robot):
        robot.wait_for("http on")
        with robot.connect(self.port) as client:
            client.sendall(b"GET /joints HTTP/1.0\r\n\r\n")
            answer = network_checks.receive_all(client, 100000)
            self.example.expect(b" 200 OK" in answer or b" 503 " in answer, f"answer {answer}")

    def ask_EchoClient(self, robot):
        robot.wait_for("closed")


def make_live(example):
    """Builds an example on the network with a free port, and returns it."""
    live = Live(example)
    if example.name == "EchoClient":
        listener = network_checks.socket.create_server(("127.0.0.1", 0))
        live.port = listener.getsockname()[1]
        example.replace("MS/OPEN-R/MW/CONF/ECHO.CFG", "127.0.0.1 7000", f"127.0.0.1 {live.port}\r")

        def serve():
            while True:
                with contextlib.suppress(OSError):
                    network_checks.echo_in_pieces(listener)
        threading.Thread(target=serve, daemon=True).start()
    else:
        port = {"EchoServer": 7000, "UdpEcho": 7001, "HttpServer": 8080}[example.name]
        kind = network_checks.socket.SOCK_DGRAM if example.name == "UdpEcho" else \
            network_checks.socket.SOCK_STREAM
        live.port = example.use_free_port(f"{example.name}/{example.name}.h", port, kind)
    example.build()
    return live


@contextlib.contextmanager
def busy_machine(folder):
    """Keeps all processors and the disk busy while the context lasts."""
    write = "import os, sys\nwhile True:\n with open(sys.argv[1], 'wb') as file:\n" \
            "  file.write(os.urandom(1 << 22))\n  file.flush()\n  os.fsync(file.fileno())"
    loads = [subprocess.Popen([sys.executable, "-c", "while True: pass"])
             for _ in range(os.cpu_count())]
    loads.append(subprocess.Popen([sys.executable, "-c", write, str(folder / "busy")]))
    try:
        yield
    finally:
        for load in loads:
            load.kill()
            load.wait()


class Tally:
    """The outcomes of all runs of one program."""

    def __init__(self, program, rounds):
        self.program, self.rounds = program, rounds
        self.wanted = {}  # seed: outcome in one process on the quiet machine
        self.bad = []  # outcomes on the quiet machine with which nothing can be compared
        self.compared = self.stops = 0
        self.refusals, self.differences = [], []

    def note_quiet(self):
        for seed in range(1, SEEDS + 1):
            if seed <= self.rounds:
                outcome = self.program.outcome(seed, False, None)[0]
                self.wanted[seed] = outcome.text
                if not re.match(self.program.good, outcome.text):
                    self.bad.append(f"seed {seed}: {outcome.text}{outcome.refusal}")

    def play(self, number, dice):
        """Plays a round: one run in one process, and one with the objects apart."""
        seed = 1 + number % min(SEEDS, self.rounds)
        for apart in (False, True):
            outcome, stops = self.program.outcome(seed, apart, dice)
            self.stops += stops
            where = f"round {number}, seed {seed}, {'apart' if apart else 'in one process'}"
            if outcome.refusal:
                self.refusals.append(f"{where}: {outcome.refusal}")
                continue
            self.compared += 1
            if outcome.text != self.wanted[seed]:
                self.differences.append(f"{where}: {outcome.text}\n  instead of {self.wanted[seed]}")

    def tell(self):
        verdict(f"{self.program.name}: the runs on the quiet machine are good", not self.bad,
                "\n".join(self.bad))
        runs = self.compared + len(self.refusals)
        verdict(f"{self.program.name}: at most one run, or {REFUSALS_MOST:.0%} of the runs, are refused",
                len(self.refusals) <= max(1, REFUSALS_MOST * runs), f"{len(self.refusals)} of {runs} are")
        verdict(f"{self.program.name}: {self.compared} runs without difference",
                self.compared > 0 and not self.differences,
                f"{len(self.differences)} of {self.compared} differ:\n" + "\n".join(self.differences[:5]))
        print(f"figures: {self.program.name}: {self.rounds} rounds, {self.compared} runs compared, "
              f"{len(self.differences)} differences, {len(self.refusals)} refusals, "
              f"{self.stops} stops", flush=True)
        for refusal in self.refusals[:5]:
            print(f"  refused: {refusal}")


def check_long_stop(stick):
    """Checks that a worker that is stopped for longer than its lease ends the run with a reason."""
    process = subprocess.Popen(
        [stick.openr, "run", "--stick", stick.stick, "--body", "ideal", "--for", "1h", "--no-panel",
         "--rc-port", "0", "--json", "--console", os.devnull, "--isolate", stick.objects[-1],
         "--dds-lease", "2", *DOMAIN], stdin=subprocess.DEVNULL, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE)
    try:
        workers = []
        while not workers and process.poll() is None:
            workers = family(process.pid)[1:]
        time.sleep(2)  # so that the worker has probably joined; before, the reason is another one
        os.kill(workers[0], signal.SIGSTOP)
        out, err = process.communicate(timeout=HANG_S)
    finally:
        process.kill()
        process.wait()
    why = json.loads(out)["ended_why"] if out else err
    verdict("a worker that is stopped for longer than its lease ends the run with a reason",
            process.returncode == 1 and REFUSAL.search(why), f"status {process.returncode}: {why}")
    print(f"figures: a worker stopped for longer than its lease of 2 s: {why}")


def make_programs(build, scratch, flags):
    """Returns the programs and their numbers of rounds."""
    openr = build / "bin/openr"
    programs = []
    for name in TWO + OTHERS:
        if flags.only not in name:
            continue
        example = Example(openr, ROOT / "examples" / name, scratch)
        if name in LIVE:
            program = make_live(example)
        else:
            example.build()
            program = Stick(openr, name, example.folder / "MS", scratch, TIMES[name])
        programs.append((program, flags.rounds_two if name in TWO else flags.rounds))
        for complaint in example.complaints:
            verdict(f"{name} is built", False, complaint)
    for program in (lambda: Stick(openr, "default stick", build / "stick", scratch, "2s"),
                    lambda: Suite(build), lambda: Exploration(openr)):
        programs.append((program(), flags.rounds))
    return [(program, rounds) for program, rounds in programs if flags.only in program.name]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--rounds-two", type=int, default=1000, help="of the two examples")
    parser.add_argument("--rounds", type=int, default=50, help="of everything else")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="rounds at the same time")
    parser.add_argument("--only", default="", help="only programs whose name contains this")
    flags = parser.parse_args()
    begin = time.monotonic()
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="openr-stress-"))
    try:
        tallies = [Tally(*each) for each in make_programs(flags.build.resolve(), scratch, flags)]
        for tally in tallies:
            tally.note_quiet()
        print(f"{len(tallies)} programs built, and run quietly, in {time.monotonic() - begin:.0f} s",
              flush=True)
        rounds = [(tally, number) for tally in tallies for number in range(tally.rounds)]
        random.Random(flags.seed).shuffle(rounds)
        with busy_machine(scratch), concurrent.futures.ThreadPoolExecutor(flags.jobs) as pool:
            def play(tally, number):
                tally.play(number, random.Random(f"{flags.seed}/{tally.program.name}/{number}"))
            for done, _ in enumerate(pool.map(lambda each: play(*each), rounds), 1):
                if done % 100 == 0:
                    print(f"{done} of {len(rounds)} rounds in {time.monotonic() - begin:.0f} s, "
                          f"{sum(len(tally.differences) for tally in tallies)} differences, "
                          f"{sum(len(tally.refusals) for tally in tallies)} refusals", flush=True)
        for tally in tallies:
            tally.tell()
        verdict("processes were stopped", sum(tally.stops for tally in tallies) > 0)
        sticks = [tally.program for tally in tallies if isinstance(tally.program, Stick)]
        if sticks:
            check_long_stop(sticks[0])
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    print(f"seed {flags.seed}, {time.monotonic() - begin:.0f} s")
    return finish()


if __name__ == "__main__":
    sys.exit(main())
