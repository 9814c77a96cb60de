#!/usr/bin/env python3
"""Kills a run at each of its writes to the Memory Stick, and looks at the stick.

    power_cuts.py --build build/release [--most N] [--one CALL N [--refuse | --term]]

A client uploads a motion and then an image, which replaces one that is there.  strace kills the run
with SIGKILL at its n-th call of a kind on the files of the uploads: an open, a write, a close, a
rename, a removal.  After each of these ends must hold:

- the motion is not there, or whole; the image is the old or the new one, whole; CONTROLL.OLD is not
  there, or is the old image, whole;
- an upload that the run has acknowledged is there;
- the next start works, and leaves no temporary file of an upload.

The same again on a file system that refuses to rename a file to a name that exists: strace lets these
renames fail, and both uploads replace a file.  There the old file may be without its name after a
kill, until the next start, or until the one after that if it is the image.  The stick has no
CONTROLL.OLD before, so no upload renames one here.

The same again with SIGTERM.  After that the run has to end by itself with status 0, or by the signal
if it has said nothing yet, and must leave no temporary file and no socket.

Then one run that is not killed: its bytes before each rename of an upload, and the folder directly
after it, are written through to the disk (fsync), as a cut of the host's power demands.  The client
gets the answer to its last packet only after that.  The same holds for the folder of a motion that the
client lets the robot delete.
--most N takes N calls of each kind, spread over the uploads.  --one CALL N ends one run; with
--refuse its renames fail, with --term it gets SIGTERM.  The last line is "N passed, N failed".
"""
import argparse
import ast
import collections
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

import remote_run as rc

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/support"))
from verdicts import finish, verdict  # noqa: E402: the folder is put into the path first

CALLS = ("openat", "write", "writev", "close", "rename", "unlink")
MOTION_NAME, IMAGE_NAME = "KILLED.MTN", "CONTROLL.BIN"
LIMIT_S = 10  # for a run that is to be killed; ends a check only
TEMPORARY = re.compile(r"UPLOAD\d\.|\.~")
# The renames of the uploads, numbered from 1, that find a file of the new name: those of the motion,
# and of the image.  The third and the last try of each upload follow when the old file is away.
REFUSE = "inject=rename:error=EEXIST:when=1+4"
# Without "rename", because strace does one thing to a call.  Without the writes, which come before
# the first rename.
REFUSED_CALLS = ("openat", "close", "unlink")


def upload_paths(folder):
    """Returns flags of strace: only calls on the files of the uploads count.

    So the numbers of the calls are those of the next run.
    """
    names = {rc.MOTION: ("UPLOAD0.TMP", MOTION_NAME, "KILLED.~TN"),
             rc.IMAGE: ("UPLOAD0.TMP", "UPLOAD0.OLD", IMAGE_NAME, "CONTROLL.OLD", "CONTROLL.~IN", "CONTROLL.~LD")}
    paths = [f"--trace-path={folder}/stick/{rc.FOLDERS[kind]}/{name}" for kind in names for name in names[kind]]
    return [*paths, "-e", "trace=" + ",".join(CALLS)]


class Uploads:
    """A run under strace, with its stick, and the files that a client uploads to it."""

    def __init__(self, openr, folder, *strace, refuses=False):
        self.trace = pathlib.Path(folder) / "trace"
        stick = pathlib.Path(folder) / "stick"
        subprocess.run([openr, "stick", "host", "-o", str(stick)], check=True, stdout=subprocess.DEVNULL)
        self.motion_path = stick / rc.FOLDERS[rc.MOTION] / MOTION_NAME
        self.image_path = stick / rc.FOLDERS[rc.IMAGE] / IMAGE_NAME
        self.old_image = self.image_path.read_bytes()
        self.motion = self.motion_path.with_name("STAND.MTN").read_bytes() + bytes(2000)
        self.image = self.old_image + bytes(20000)  # the robot ignores bytes behind an image
        self.old_motion = None
        if refuses:
            strace += ("-e", REFUSE)
            self.old_motion = self.motion + b"old"
            self.motion_path.write_bytes(self.old_motion)
        self.acknowledged = []
        self.run = rc.Run(openr, folder, "--rate", "max", "--no-payloads", waits=False, stick=stick,
                          prefix=["strace", "-f", "-qq", "-y", "-o", str(self.trace), *strace])

    def count(self, call):
        """Returns how many calls of this kind the run has made."""
        return len(re.findall(rf"^\d+ +{call}\(", self.trace.read_text(errors="replace"), re.M))

    def upload(self, deletes=False):
        """Uploads both files; returns False if the run has ended meanwhile.

        With `deletes`, lets the robot delete the motion after that.
        """
        try:
            client = rc.Client(self.run.wait_for_port())
            self.run.wait_until_standing(client)
            for kind, name, data in ((rc.MOTION, MOTION_NAME, self.motion), (rc.IMAGE, IMAGE_NAME, self.image)):
                packets = rc.upload_packets(kind, name, data)
                for at in range(0, len(packets), 30):
                    client.ask_all(packets[at:at + 30])
                self.acknowledged.append(name)
            if deletes:
                client.ask(rc.DELETE, bytes([rc.MOTION, len(MOTION_NAME)]) + MOTION_NAME.encode())
            return True
        except (OSError, RuntimeError):
            return False

    def end(self):
        """Kills the run, if it still goes on, and waits for strace, which ends with it."""
        subprocess.run(["pkill", "-KILL", "-P", str(self.run.process.pid)], check=False)
        self.run.process.wait()

    def has_ended(self, limit_s):
        """Waits for the end of the run; returns whether it came within the limit."""
        try:
            self.run.process.wait(timeout=limit_s)
        except subprocess.TimeoutExpired:
            return False
        return True

    def was_killed(self, limit_s):
        """Waits for the end of the run; returns whether strace has killed it within the limit."""
        return self.has_ended(limit_s) and self.run.process.returncode in (-signal.SIGKILL, 128 + signal.SIGKILL)

    def left(self):
        """Returns the temporary files and the sockets that the run has left behind."""
        files = [path.name for path in self.run.stick.rglob("*") if TEMPORARY.search(path.name)]
        return files + [path.name for path in self.run.folder.rglob("*") if path.is_socket()]

    def wrong(self, may_lack):
        """Returns what is wrong with the stick; `may_lack`: files may be without their names."""
        found = []
        motion = self.motion_path.read_bytes() if self.motion_path.exists() else None
        image = self.image_path.read_bytes() if self.image_path.exists() else None
        old_path = self.image_path.with_suffix(".OLD")
        lack = {None} if may_lack else set()
        if motion not in {self.old_motion, self.motion} | lack:
            found.append("the motion is in part, or gone")
        if image not in {self.old_image, self.image} | lack:
            found.append("the image is in part, or gone")
        if old_path.exists() and old_path.read_bytes() != self.old_image:
            found.append("CONTROLL.OLD is in part")
        if MOTION_NAME in self.acknowledged and motion != self.motion:
            found.append("the acknowledged motion is lost")
        if IMAGE_NAME in self.acknowledged and image != self.image:
            found.append("the acknowledged image is lost")
        return found

    def start_again(self):
        """Starts the stick again; returns what is wrong with that."""
        # Without its image, the robot does not boot.  Here it boots with CONTROLL.OLD, an error is
        # reported, RCServer gives the image its name back, and the start after that must be good.
        starts = 1 if self.image_path.exists() else 2
        for _ in range(starts):
            again = subprocess.run([self.run.openr, "run", "--stick", str(self.run.stick), "--body", "ideal",
                                    "--rate", "max", "--for", "2s", "--rc-port", "0", "--no-panel"],
                                   capture_output=True, text=True, env=self.run.environment)
        found = [] if again.returncode == 0 else [f"the next start: status {again.returncode}\n{again.stderr}"]
        left = [path.name for path in self.run.stick.rglob("*") if TEMPORARY.search(path.name)]
        return found + ([f"after the next start {left} is there"] if left else []) + self.wrong(may_lack=False)


def cut(openr, call, number, refuses):
    """Ends a run at one call.  Returns what is wrong, or None if the run makes fewer calls."""
    with tempfile.TemporaryDirectory(prefix="cut-") as folder:
        uploads = Uploads(openr, folder, *upload_paths(folder), "-e", f"inject={call}:signal=SIGKILL:when={number}",
                          refuses=refuses)
        whole = uploads.upload()
        # After the last answer the run makes only a few more calls on the files, the last of which may
        # be the one at which it is killed.
        killed = uploads.was_killed(LIMIT_S)
        uploads.end()
        wrong = uploads.wrong(may_lack=refuses) + uploads.start_again()
        if not whole and not killed:
            wrong.append(f"the uploads failed, and the run was not killed: {uploads.run.said.read_text()}")
        return None if whole and not killed and not wrong else wrong


def ask_to_end(openr, call, number):
    """Sends SIGTERM to a run at one call.  Returns what is wrong, or None as cut() does."""
    with tempfile.TemporaryDirectory(prefix="cut-") as folder:
        uploads = Uploads(openr, folder, *upload_paths(folder), "-e", f"inject={call}:signal=SIGTERM:when={number}")
        whole = uploads.upload()
        # A run that was asked to end has to do so in order, also at its last calls, for which strace
        # needs time on a busy machine.
        has_ended = uploads.has_ended(LIMIT_S)
        was_asked = "--- SIGTERM" in uploads.trace.read_text(errors="replace")
        uploads.end()
        wrong = uploads.wrong(may_lack=False)
        if has_ended:
            status, left, said = uploads.run.process.returncode, uploads.left(), uploads.run.said.read_text()
            # Before the run takes signals, it has said nothing, and SIGTERM just ends it.
            if status != 0 and (status != -signal.SIGTERM or said):
                wrong.append(f"status {status}: {said}")
            wrong += [f"{left} is left behind"] if left else []
            wrong += [] if was_asked else ["the run has ended without SIGTERM"]
        elif was_asked:
            wrong.append(f"the run goes on {LIMIT_S} s after SIGTERM: {uploads.run.said.read_text()}")
        elif not whole:
            wrong.append(f"the uploads failed, and the run goes on: {uploads.run.said.read_text()}")
        wrong += uploads.start_again()
        return None if whole and not (has_ended or was_asked or wrong) else wrong


def cut_all(openr, calls, most, refuses):
    """Ends runs at each call of these kinds, or at `most` calls of each kind."""
    with tempfile.TemporaryDirectory(prefix="cut-") as folder:
        whole = Uploads(openr, folder, *upload_paths(folder), refuses=refuses)
        if not whole.upload():
            sys.exit("the uploads fail without an end")
        whole.end()
        counts = {call: whole.count(call) for call in calls}
    where = ", where rename() replaces no file" if refuses else ""
    for call in calls:
        numbers = range(1, counts[call] + 1)
        for number in numbers if not most else numbers[::max(1, len(numbers) // most)][:most]:
            wrong = cut(openr, call, number, refuses)
            verdict(f"killed at {call} {number} of {counts[call]}{where}", wrong == [], text_of(wrong))
            if not refuses:
                wrong = ask_to_end(openr, call, number)
                verdict(f"SIGTERM at {call} {number} of {counts[call]}", wrong == [], text_of(wrong))


def text_of(wrong):
    """Returns what cut() or ask_to_end() has found wrong, as a text."""
    return "the run makes fewer calls" if wrong is None else "\n".join(wrong)


def answers(lines, command):
    """Returns the numbers of the lines of a trace after which the robot has answered `command`."""
    streams, found = collections.defaultdict(bytes), []
    for i, line in enumerate(lines):
        sent = re.search(r'sendto\((\d+)<[^>]*>, "((?:[^"\\]|\\.)*)"', line)
        if not sent:
            continue
        stream = streams[sent[1]] + ast.literal_eval(f'b"{sent[2]}"')
        while len(stream) >= rc.ANSWER.size and stream.startswith(b"RC"):
            _, size, _, answered, *_ = rc.ANSWER.unpack_from(stream)
            if len(stream) < size:
                break
            if answered == command:
                found.append(i)
            stream = stream[size:]
        streams[sent[1]] = stream
    return found


def wrong_folder(lines, i, what, path):
    """Returns what is wrong if line i + 1 does not write the folder of `path`, which line i has changed."""
    following = "".join(lines[i + 1:i + 2])
    if "fsync(" in following and f"<{os.path.dirname(path)}>" in following:
        return []
    return [f"after {what} {path} its folder is not written through, but: {following}"]


def wrong_order(lines):
    """Returns what is wrong with the order of the calls in a trace of both uploads and a deletion."""
    wrong, renames = [], [i for i, line in enumerate(lines) if "rename(" in line and TEMPORARY.search(line)]
    if len(renames) != 3:
        wrong.append(f"{len(renames)} renames of uploads, not 3")
    folders_written = []  # line numbers of the fsync of the folder after the last rename of each upload
    for i in renames:
        source, target = re.findall(r'"([^"]*)"', lines[i])
        if not any("fsync(" in line and f"<{source}>" in line for line in lines[:i]):
            wrong.append(f"{source} is renamed and was not written through")
        wrong += wrong_folder(lines, i, "the rename to", target)
        if target.endswith((MOTION_NAME, IMAGE_NAME)):
            folders_written.append(i + 1)
    answered = answers(lines, rc.UPLOAD_END)
    if len(answered) != 2:
        wrong.append(f"{len(answered)} answers to UPLOAD_END, not 2")
    for written, answer in zip(folders_written, answered):
        if answer < written:
            wrong.append(f"UPLOAD_END is answered before the folder is written through: {lines[written]}")
    removals = [i for i, line in enumerate(lines) if "unlink(" in line and f'/{MOTION_NAME}"' in line]
    answered = answers(lines, rc.DELETE)
    if len(removals) != 1 or len(answered) != 1:
        return wrong + [f"{len(removals)} removals of the motion and {len(answered)} answers to DELETE, not 1 of each"]
    wrong += wrong_folder(lines, removals[0], "the removal of", re.search(r'"([^"]*)"', lines[removals[0]])[1])
    if answered[0] < removals[0] + 1:
        wrong.append("DELETE is answered before the folder is written through")
    return wrong


def order(openr):
    """Returns what is wrong with the order of the calls of a run that nobody ends."""
    with tempfile.TemporaryDirectory(prefix="cut-") as folder:
        uploads = Uploads(openr, folder, "-s", "100000", "-e", "trace=fsync,rename,unlink,sendto")
        is_good = uploads.upload(deletes=True)
        uploads.end()
        if not is_good:
            return ["the uploads, or the deletion, failed"]
        return wrong_order(uploads.trace.read_text(errors="replace").splitlines())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--most", type=int, default=0, help="ends at calls of one kind; 0: all")
    parser.add_argument("--one", nargs=2, metavar=("CALL", "N"))
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--refuse", action="store_true", help="with --one: rename() replaces no file")
    how.add_argument("--term", action="store_true", help="with --one: SIGTERM")
    flags = parser.parse_args()
    if not shutil.which("strace"):
        sys.exit("strace is not installed (Debian package strace)")
    openr = (flags.build / "bin/openr").resolve()
    if flags.one:
        call, number = flags.one[0], int(flags.one[1])
        wrong = ask_to_end(openr, call, number) if flags.term else cut(openr, call, number, flags.refuse)
        print("nothing is wrong" if wrong == [] else text_of(wrong))
        return 1 if wrong else 0
    cut_all(openr, CALLS, flags.most, refuses=False)
    cut_all(openr, REFUSED_CALLS, flags.most, refuses=True)
    wrong = order(openr)
    verdict("files are written through before a rename, and their folders after it or a removal, before the answer",
            not wrong, "\n".join(wrong))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
