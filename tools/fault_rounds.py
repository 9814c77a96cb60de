#!/usr/bin/env python3
"""Lets the n-th system call of each kind fail in turn, and checks what openr makes of it.

    fault_rounds.py --build build/release [--scenario NAME ...] [--call NAME ...]
                    [--most N] [--last N] [--one SCENARIO CALL N]

strace makes the calls fail, so no part of openr is built for it.  In a program of several processes
the n-th call of each of them fails.  After each failure these must hold:

- the program ends, by itself and not by a signal, with a status that its documents know;
- a status other than 0 comes with a reason;
- with status 0, all that the run has written is there, byte by byte as without the failure, or the
  program has printed a line more, which says what is missing;
- no file, socket or process is left behind, after 10 s at most; after a crash, or if a file could not be
  removed, the next start removes it;
- the next start, without a failure, works and comes to the same hash.

The run of the default stick is also done with limits of memory (prlimit --data), from 200 KiB up in
steps of 200 KiB, so that small allocations fail as well.

At last all calls that open, read and write are slow, as on a worn-out stick: the command must do the
same as otherwise.

--most N takes N calls of each kind, spread over the program, --last N the last N of each kind; without
them all are taken.  --one shows one failure again.  The last line is "N passed, N failed".
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import finish, verdict  # noqa: E402: the folder is put into the path first

# The calls that fail, each with the error that it most likely has on a host in trouble.  brk is not
# among them: the kernel reports its failure otherwise than strace can.
ERRORS = {
    "openat": "EMFILE", "read": "EIO", "pread64": "EIO", "mmap": "ENOMEM",
    "write": "ENOSPC", "writev": "ENOSPC", "pwrite64": "ENOSPC", "sendfile": "ENOSPC",
    "copy_file_range": "ENOSPC", "ftruncate": "ENOSPC", "fsync": "EIO", "fdatasync": "EIO", "close": "EIO",
    "mkdir": "ENOSPC", "symlink": "ENOSPC", "rename": "EACCES", "unlink": "EACCES", "unlinkat": "EACCES",
    "getdents64": "EIO", "flock": "ENOLCK", "mprotect": "ENOMEM",
    "socket": "EMFILE", "bind": "EADDRINUSE", "listen": "EADDRINUSE", "accept4": "EMFILE",
    "connect": "ECONNREFUSED", "sendto": "ECONNRESET", "sendmsg": "ENOBUFS", "recvfrom": "ECONNRESET",
    "recvmsg": "ENOBUFS", "pipe2": "EMFILE", "clone": "EAGAIN", "clone3": "EAGAIN", "vfork": "EAGAIN",
    "eventfd2": "EMFILE", "epoll_create1": "EMFILE", "memfd_create": "EMFILE", "execve": "ENOENT",
}
LIMIT_S = 120  # for one run: generous, since a machine may be slow
REASON = re.compile(r"^(openr|\S*/openr|error): |ended by |^EXCEPTION |error while loading shared libraries", re.M)
# Calls without which temporary files cannot be removed.
REMOVING = ("unlink", "unlinkat", "rmdir", "getdents64", "openat", "close")
# The calls that fail in a scenario, if not all do.  A picture takes seconds, and most of its calls
# load libraries of Mesa.
ONLY = {"picture": ("clone", "clone3")}
# Cyclone DDS ends the process itself, with a line that says why, when it gets no thread, no stack or no pipe.
DDS_ABORTS = ("clone3", "pipe2", "mmap", "mprotect")
# Statuses of the documents, and 127: the dynamic linker could not load the program.
STATUSES = (0, 1, 2, 127)


class Scenario:
    """A command of openr in a folder of its own."""

    def __init__(self, openr, folder, name):
        self.openr, self.folder, self.name = openr, folder / name, name
        self.home = self.folder / "home"
        self.temp = self.folder / "temp"
        self.live = self.folder / "live"
        self.out = self.folder / "out"
        for path in (self.home, self.temp, self.live, self.out):
            path.mkdir(parents=True)
        self.env = {**os.environ, "HOME": str(self.home), "TMPDIR": str(self.temp), "NO_COLOR": "1",
                    "XDG_RUNTIME_DIR": str(self.live), "XDG_CACHE_HOME": str(self.home / "cache")}
        self.words = getattr(self, f"words_of_{name}")()

    def run_words(self, seconds):
        return ["run", "--body", "ideal", "--rate", "max", "--for", f"{seconds}s", "--rc-port", "0",
                "--report", str(self.out / "report.json"), "--record", str(self.out / "run.rec")]

    def words_of_run(self):
        """A run that writes all files of a run but pictures, from a stick of its own."""
        stick = self.folder / "stick"
        subprocess.run([self.openr, "stick", "host", "-o", str(stick)], env=self.env, check=True,
                       stdout=subprocess.DEVNULL)
        return self.run_words(2) + ["--no-panel", "--stick", str(stick),
                                    "--log-data", str(self.out / "run.csv"),
                                    "--timeline", str(self.out / "run.json"),
                                    "--console", str(self.out / "console.txt")]

    def words_of_default(self):
        """A run of the default stick."""
        return self.run_words(1) + ["--no-panel"]

    def words_of_picture(self):
        """A run that draws a picture, with Mesa."""
        return self.run_words(1) + ["--no-panel", "--snapshot", "t=end,size=64x48", "-o", str(self.out / "dog.png")]

    def words_of_panel(self):
        """A run with a panel, which is a process of its own."""
        return self.run_words(1) + ["--panel", "--panel-port", "0"]

    def words_of_apart(self):
        """A run with an object in a process of its own, over Cyclone DDS."""
        return self.run_words(1) + ["--no-panel", "--place", "PowerMonitor=away"]

    def words_of_replay(self):
        recording = self.folder / "run.rec"
        subprocess.run([self.openr, "run", "--body", "ideal", "--rate", "max", "--for", "2s", "--rc-port", "0",
                        "--no-panel", "--record", str(recording)], env=self.env, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return ["replay", str(recording)]

    def command(self, strace=()):
        """Runs the command; returns (status or None, what it printed)."""
        shutil.rmtree(self.out)
        self.out.mkdir()
        process = subprocess.Popen([*strace, self.openr, *self.words], env=self.env, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            text = process.communicate(timeout=LIMIT_S)[0].decode(errors="replace")
            console = self.out / "console.txt"  # text of the objects, which may tell of a failure as well
            return process.returncode, text + (console.read_text() if console.exists() else "")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return None, process.communicate()[0].decode(errors="replace")

    def written(self):
        """Returns the content of each file that the command has written, without times of this host."""
        found = {}
        for file in sorted(self.out.iterdir()):
            found[file.name] = file.read_bytes()
            if file.name == "report.json":
                report = json.loads(found[file.name] or b"{}")
                found[file.name] = (report.get("state_hash"), report.get("trace_hash"))
            elif file.name == "run.json":  # has times that were measured
                found[file.name] = bool(json.loads(found[file.name]))
        return found

    def left_behind(self):
        """Returns what a run must not leave: sockets, temporary files."""
        folders = [self.live / "openr-host", self.temp]
        return [str(path) for folder in folders if folder.exists() for path in folder.iterdir()]

    def processes(self):
        """Returns the command lines of processes that belong to this scenario."""
        mark = f"TMPDIR={self.temp}".encode()
        found = []
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if mark in (process / "environ").read_bytes().split(b"\0"):
                    found.append((process / "cmdline").read_bytes().replace(b"\0", b" ").decode())
            except OSError:
                continue  # the process has ended meanwhile
        return found

    def wait_for_end(self):
        """Waits until no process of this scenario runs.  Returns those that still run after 10 s."""
        for _ in range(100):
            if not self.processes():
                return []
            time.sleep(0.1)
        return self.processes()

    def counts(self, words=None):
        """Returns how often each system call is made."""
        trace = self.folder / "counts"
        strace = ["strace", "-f", "-qq", "-o", str(trace)]
        if words is None:
            self.command(strace)
        else:
            subprocess.run([*strace, self.openr, *words], env=self.env, stdout=subprocess.DEVNULL, check=True)
        counts = {}
        for name in re.findall(r"^\d+ +(\w+)\(", trace.read_text(errors="replace"), re.M):
            counts[name] = counts.get(name, 0) + 1
        return counts


def without_numbers(text):
    """Returns the lines of `text`, with numbers and hashes left out."""
    return {re.sub(r"[0-9a-f]*[0-9][0-9a-f]*", "", line) for line in text.splitlines()}


class Rounds:
    def __init__(self, scenario):
        self.scenario = scenario
        status, text = scenario.command()
        if status != 0:
            sys.exit(f"{scenario.name}: fails without a failure, status {status}\n{text}")
        self.expected = scenario.written()
        self.usual = without_numbers(text)
        self.kept = scenario.left_behind()
        self.injected = self.reported = 0

    def fail(self, call, n):
        """Lets call number n fail.  Returns the complaints, and what the program printed."""
        scenario = self.scenario
        trace = scenario.folder / "trace"
        status, text = scenario.command(["strace", "-f", "-qq", "-o", str(trace), "-e", f"trace={call}",
                                         "-e", f"inject={call}:error={ERRORS[call]}:when={n}"])
        if "(INJECTED)" not in trace.read_text(errors="replace"):
            return None, text  # no process makes so many calls
        wrong = [f"leaves the process {line}" for line in scenario.wait_for_end()]
        if status is None:
            wrong.append(f"does not end within {LIMIT_S} s")
        elif status not in STATUSES and not (call in DDS_ABORTS and "Cyclone DDS: " in text):
            wrong.append(f"ends with status {status}")
        elif status != 0 and not REASON.search(self.said_more(text)):
            wrong.append(f"status {status} without a reason")
        elif status == 0 and without_numbers(text) <= self.usual:
            try:
                wrong += [f"status 0 and no word, but {name} is another" for name in self.expected
                          if scenario.written().get(name) != self.expected[name]]
            except ValueError as error:
                wrong.append(f"status 0, but the files cannot be read: {error}")
        self.reported += status != 0
        left = [path for path in scenario.left_behind() if path not in self.kept]
        # Files that a crashed run, a killed worker or a failed removal leaves must go with the next start.
        is_clean = call not in REMOVING and scenario.name != "apart" and "ended by crash" not in text
        if left and is_clean:
            wrong.append(f"leaves {' '.join(left)}")
        status, again = scenario.command()
        if status != 0 or scenario.written() != self.expected:
            wrong.append(f"the next start: status {status}\n{again}")
        stays = [path for path in left if os.path.lexists(path)]
        if stays:
            wrong.append(f"the next start does not remove {' '.join(stays)}")
        for path in stays:
            shutil.rmtree(path, ignore_errors=True)
            pathlib.Path(path).unlink(missing_ok=True) if not os.path.isdir(path) else None
        self.injected += 1
        return wrong, text

    def said_more(self, text):
        """Returns the lines that the command does not print without a failure."""
        return "\n".join(line for line in text.splitlines() if not without_numbers(line) <= self.usual)

    def slow(self):
        """Lets all opens, reads and writes take 1 ms longer.  Returns the complaints."""
        calls = "openat,read,pread64,write,writev,pwrite64"
        status, text = self.scenario.command(["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={calls}",
                                              "-e", f"inject={calls}:delay_exit=1000"])
        if status != 0:
            return [f"status {status}\n{text}"]
        return [f"{name} is another" for name, content in self.scenario.written().items()
                if content != self.expected[name]]

    def low_memory(self):
        """Runs the command with little memory, and with a little more each time.  Lets small allocations fail,
        too.  Ends at the first limit that changes nothing."""
        for kib in range(200, 1 << 16, 200):
            limit = ["prlimit", f"--data={kib << 10}"]
            if subprocess.run([*limit, self.scenario.openr, "--version"], capture_output=True).returncode != 0:
                continue  # the kernel or the dynamic linker could not start the program
            status, text = self.scenario.command(limit)
            wrong = [f"leaves the process {line}" for line in self.scenario.wait_for_end()]
            # libdw, which names the calls of a crash, ends the process itself when it gets no memory.
            if status not in STATUSES and "libdw" not in text:
                wrong.append(f"ends with status {status}")
            elif status != 0 and not REASON.search(text) and "ended by time" not in text:
                wrong.append(f"status {status} without a reason")
            if re.search(r"^openr: std::bad_alloc$", text, re.M):
                wrong.append("the reason does not say what to do")
            again, text_again = self.scenario.command()
            stays = [path for path in self.scenario.left_behind() if path not in self.kept]
            if again != 0 or self.scenario.written() != self.expected or stays:
                wrong.append(f"the next start: status {again}, leaves {stays}\n{text_again}")
            verdict(f"{self.scenario.name}: {kib} KiB of memory", not wrong, "\n".join(wrong) + "\n" + text)
            if status == 0:
                return

    def run(self, calls, most, last):
        # The dynamic linker and the C library make these calls before the program begins.
        before = self.scenario.counts(["--version"])
        for call, count in sorted(self.scenario.counts().items()):
            if call not in ERRORS or (calls and call not in calls) or call not in ONLY.get(self.scenario.name, ERRORS):
                continue
            numbers = range(before.get(call, 0) + 1 if call != "execve" else 2, count + 1)
            numbers = numbers[-last:] if last else numbers
            for n in numbers if not most else numbers[::max(1, len(numbers) // most)][:most]:
                wrong, text = self.fail(call, n)
                if wrong is None:
                    break
                verdict(f"{self.scenario.name}: {call} {n} of {count} ({ERRORS[call]})", not wrong,
                        "\n".join(wrong) + "\n" + "\n".join(f"  | {line}" for line in text.splitlines()[-12:]))


def main():
    names = [name[len("words_of_"):] for name in vars(Scenario) if name.startswith("words_of_")]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--scenario", action="append", choices=names, help="default: all")
    parser.add_argument("--call", action="append", choices=sorted(ERRORS), help="default: all")
    parser.add_argument("--most", type=int, default=0, help="failures of one call in one scenario; 0: all")
    parser.add_argument("--last", type=int, default=0, help="only the last N calls of each kind; 0: all")
    parser.add_argument("--one", nargs=3, metavar=("SCENARIO", "CALL", "N"))
    flags = parser.parse_args()
    if not shutil.which("strace"):
        sys.exit("strace is not installed (Debian package strace)")
    openr = str((flags.build / "bin/openr").resolve())
    with tempfile.TemporaryDirectory(prefix="faults-") as folder:
        if flags.one:
            wrong, text = Rounds(Scenario(openr, pathlib.Path(folder), flags.one[0])).fail(
                flags.one[1], int(flags.one[2]))
            print(text + "\n".join(["no process makes so many calls"] if wrong is None else wrong))
            return 1 if wrong else 0
        for name in flags.scenario or names:
            begin = time.monotonic()
            rounds = Rounds(Scenario(openr, pathlib.Path(folder), name))
            rounds.run(flags.call, flags.most, flags.last)
            if flags.last:
                # strace counts the calls of each thread by itself, so the last calls of a program
                # with several threads may be calls that no thread makes.
                verdict(f"{name}: calls have failed", rounds.injected > 0)
            wrong = rounds.slow()
            verdict(f"{name}: slow files", not wrong, "\n".join(wrong))
            if name == "default" and not flags.call:
                rounds.low_memory()
            print(f"figures: {name}: {rounds.injected} failures, of which {rounds.reported} ended the program "
                  f"with a reason, {time.monotonic() - begin:.0f} s", flush=True)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
