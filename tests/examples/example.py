"""Builds and runs a copy of an example, and collects what is wrong with it."""
import json
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import time

PATIENCE_S = 120  # the longest wait for anything, in wall time
SYSTEM = ("oobjectManager", "OVirtualRobotComm", "OVirtualRobotAudioComm", "IPStack")


def free_port(kind=socket.SOCK_STREAM):
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Outcome:
    """The outcome of a run: status, text that the objects printed, report."""

    def __init__(self, status, console, report_text, complaint_text):
        self.status = status
        # Without the table of objects that the console begins with.
        self.lines = [line for line in console.splitlines()
                      if not re.match(r"\[oid:0x[0-9a-f]+\] ", line)]
        self.report = json.loads(report_text) if report_text else {}
        self.said = complaint_text


def objects_of(report):
    return [entry["name"] for entry in report.get("objects", []) if entry["name"] not in SYSTEM]


def isolated(objects):
    return [word for name in objects for word in ("--isolate", name)]


class Example:
    def __init__(self, openr, source, scratch, apart=False):
        """apart: whoever answers live does so from processes of its own."""
        self.openr = str(openr)
        self.name = source.name
        self.apart = apart
        self.folder = scratch / source.name
        self.work = scratch / f"{source.name}.work"
        self.console = scratch / f"{source.name}.console"
        self.recording = scratch / f"{source.name}.rec"
        self.complaints = []
        self.skipped = []
        self.hashes = []  # arguments and hash of the trace of each call of run(), as in hashes.txt
        # Without what somebody's own build and run left there.
        shutil.copytree(source, self.folder,
                        ignore=shutil.ignore_patterns("OBJS", "*.PPM", "*.WAV"))

    # ---- what it says of itself

    def readme_block(self, number):
        """Lines of the number-th indented block of README.md; block 0 is the commands."""
        text = (self.folder / "README.md").read_text()
        blocks = re.findall(r"(?:^    .*\n)+", text, re.M)
        return [line[4:] for line in blocks[number].splitlines()]

    # ---- changing the copy

    def replace(self, file, old, new):
        path = self.folder / file
        text = path.read_text()
        if old not in text:
            raise RuntimeError(f"{file}: there is no '{old}' to be replaced")
        path.write_text(text.replace(old, new))

    def use_free_port(self, header, port, kind=socket.SOCK_STREAM):
        free = free_port(kind)
        self.replace(header, f"PORT = {port};", f"PORT = {free};")
        return free

    # ---- building and running

    def flag(self, beginning):
        """The flag of `openr run` that begins so, or None, which is noted as skipped."""
        text = subprocess.run([self.openr, "run", "--help"], capture_output=True, text=True,
                              timeout=PATIENCE_S).stdout
        found = re.search(rf"^ *({beginning}[a-z-]*)", text, re.M)
        if found is None:
            self.skipped.append(f"openr run has no {beginning}...")
            return None
        return found.group(1)

    def build(self):
        done = subprocess.run([self.openr, "build", str(self.folder), "--work", str(self.work),
                               "-j", "1"], capture_output=True, text=True, timeout=PATIENCE_S * 2)
        if done.returncode != 0:
            raise RuntimeError(f"openr build fails:\n{done.stdout}{done.stderr}")
        self.expect("warning:" not in done.stderr, f"the compiler warns:\n{done.stderr}")
        done = subprocess.run([self.openr, "check", str(self.folder)], capture_output=True,
                              text=True, timeout=PATIENCE_S)
        self.expect(done.stdout == "0 errors, 0 warnings, 0 notes\n",
                    f"openr check: {done.stdout}{done.stderr}")

    def command(self, *arguments, rate="max"):
        return [self.openr, "run", "--stick", str(self.folder / "MS"), "--no-panel", "--strict",
                "--rate", rate, "--console", str(self.console), "--json", *arguments]

    def run(self, *arguments):
        """Once in one process and once with each object in its own, which has to be the same."""
        stick, before = self.folder / "MS", self.folder / "MS.before"
        shutil.copytree(stick, before)
        one = self.run_once(*arguments)
        objects = objects_of(one.report)
        recording = self.recording.read_bytes()
        shutil.rmtree(stick)
        before.rename(stick)
        other = self.run_once(*arguments, *isolated(objects))
        self.expect(self.recording.read_bytes() == recording,
                    f"with {' and '.join(objects)} in other processes it is another run")
        self.expect_lines(other.lines, one.lines)
        self.expect(other.report.get("state_hash") == one.report.get("state_hash"),
                    "other processes give another state")
        words = [pathlib.Path(word).name if word.startswith("/") else word for word in arguments]
        self.hashes.append(f"{self.name} {' '.join(words)}  {one.report.get('trace_hash')}")
        return other

    def run_once(self, *arguments):
        done = subprocess.run(self.command("--record", str(self.recording), *arguments),
                              capture_output=True, text=True, timeout=PATIENCE_S,
                              stdin=subprocess.DEVNULL)
        console = self.console.read_text() if self.console.exists() else ""
        return self.judge(Outcome(done.returncode, console, done.stdout, done.stderr))

    def replay(self):
        done = subprocess.run([self.openr, "replay", str(self.recording)], capture_output=True,
                              text=True, timeout=PATIENCE_S)
        self.expect(done.returncode == 0,
                    f"openr replay in one process: {done.stdout}{done.stderr}")

    def objects(self):
        """Returns the objects of the stick, from the report of a run of no time."""
        done = subprocess.run([self.openr, "run", "--stick", str(self.folder / "MS"), "--for", "0s",
                               "--rate", "max", "--no-panel", "--json"], capture_output=True,
                              text=True, timeout=PATIENCE_S, stdin=subprocess.DEVNULL)
        return objects_of(json.loads(done.stdout))

    def judge(self, outcome):
        self.expect(outcome.status == 0, f"exit status {outcome.status}:\n{outcome.said}")
        for finding in outcome.report.get("findings", []):
            self.complaints.append(f"{finding['severity']}: {finding['object']}: {finding['text']}")
        return outcome

    # ---- complaining

    def expect(self, good, complaint):
        if not good:
            self.complaints.append(complaint)

    def expect_lines(self, found, wanted):
        self.expect(found == wanted, "printed\n  " + "\n  ".join(found) + "\ninstead of\n  " +
                    "\n  ".join(wanted))


class Running:
    """A run in the background, in its own time, until its pause button is pressed."""

    def __init__(self, example, *arguments, rate="1"):
        self.example = example
        self.outcome = None
        example.console.write_text("")
        if example.apart:
            arguments += ("--record", str(example.recording), *isolated(example.objects()))
        self.process = subprocess.Popen(
            example.command("--body", "ideal", *arguments, rate=rate), text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, kind, value, trace):
        if self.outcome is None:
            self.process.kill()
            self.process.communicate()

    def wait_for(self, text, count=1):
        end = time.monotonic() + PATIENCE_S
        while self.example.console.read_text().count(text) < count:
            if self.process.poll() is not None or time.monotonic() > end:
                raise RuntimeError(f"'{text}' was not printed {count} times:\n" +
                                   self.example.console.read_text())
            time.sleep(0.02)

    def press_pause(self):
        self.process.send_signal(signal.SIGTERM)
        said, complaints = self.process.communicate(timeout=PATIENCE_S)
        self.outcome = self.example.judge(Outcome(
            self.process.returncode, self.example.console.read_text(), said, complaints))
        if self.example.apart:
            self.example.replay()
        return self.outcome

    def connect(self, port):
        """A TCP connection; the robot listens at one of its next frames."""
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                client = socket.create_connection(("127.0.0.1", port), timeout=PATIENCE_S)
                return client
            except ConnectionRefusedError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.02)
