#!/usr/bin/env python3
"""Runs openr with sticks, and other disks, that are full or read-only.

    bad_sticks.py --build build/release [--short] [--only WORD]

The disks are small file systems in memory, in a mount namespace of this script, which needs root or
user namespaces; without them all is skipped, with the reason.  On a full disk, a file takes all room
that is left.  These must hold:

- a run from such a stick comes to the hashes that it has on a good stick;
- what cannot be written is refused with a reason: uploads, files of objects, the record of a crash,
  the files of a run, temporary files; nothing crashes;
- no file is there in part, and no file that was whole before is another;
- when there is room again, the same run takes an upload, and the next start works.

--short leaves out the cases that only try other amounts of room, and those that need strace or much
time.  The last line is "N passed, N failed", or "0 passed, 0 failed, 1 skipped".
"""
import argparse
import contextlib
import errno
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import remote_run as rc  # noqa: E402: the folders are put into the path first
from verdicts import finish, verdict  # noqa: E402

INSIDE = "OPENR_BAD_STICKS_INSIDE"  # set in the process that has a mount namespace of its own
PAGE = 4096  # a file system in memory gives room in pages
NO_ROOM, READ_ONLY = "No space left on device", "Read-only file system"
NOT_WRITTEN = 11  # status of an answer of the remote control
MOTION, IMAGE = "DISK.MTN", "CONTROLL.BIN"
QUICK = ("--body", "ideal", "--rate", "max", "--rc-port", "0", "--no-panel")
RATE = "20"  # virtual seconds per second, of runs with clients
LIMIT_S = 300  # for one command; ends a check only


def enter_namespace():
    """Starts this script again in a mount namespace of its own; returns a reason if that fails."""
    reason = "unshare is not installed (Debian package util-linux)"
    for words in (["unshare", "--mount"], ["unshare", "--map-root-user", "--mount"]):
        if not shutil.which("unshare"):
            break
        with tempfile.TemporaryDirectory() as folder:
            tried = subprocess.run([*words, "mount", "-t", "tmpfs", "none", folder], capture_output=True,
                                   text=True, check=False)
        if tried.returncode == 0:
            os.execvpe(words[0], [*words, sys.executable, *sys.argv], {**os.environ, INSIDE: "1"})
        reason = tried.stderr.strip()
    return f"mounting is not permitted here: {reason}"


class Disk:
    """A file system of its own in memory, mounted at `path`."""

    def __init__(self, path, size=64 << 20):
        self.path = pathlib.Path(path)
        self.path.mkdir(parents=True)
        self.filler = self.path / "filler"
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size},mode=755", "none", str(self.path)], check=True)

    def fill(self, pages=0):
        """Leaves room for so many pages."""
        self.make_room()
        disk = os.statvfs(self.path)
        with self.filler.open("wb") as file:
            os.posix_fallocate(file.fileno(), 0, (disk.f_bavail - pages) * disk.f_frsize)

    def make_room(self):
        self.filler.unlink(missing_ok=True)

    def set_read_only(self, is_read_only=True):
        options = "remount,bind,ro" if is_read_only else "remount,bind,rw"
        subprocess.run(["mount", "-o", options, str(self.path)], check=True)

    def close(self):
        subprocess.run(["umount", "--lazy", str(self.path)], check=True)


class Bad:
    """A disk that is bad in one way: "full" or "read-only"."""

    def __init__(self, disk, kind):
        self.disk, self.kind = disk, kind
        self.reason = NO_ROOM if kind == "full" else READ_ONLY
        self.errno = errno.ENOSPC if kind == "full" else errno.EROFS
        self.path = disk.path

    def spoil(self):
        if self.kind == "full":
            self.disk.fill()
        else:
            self.disk.set_read_only()

    def mend(self):
        if self.kind == "full":
            self.disk.make_room()
        else:
            self.disk.set_read_only(False)


def files_of(folder):
    """Returns the content of each file below the folder."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file()}


def findings_of(report):
    return [f"{finding['severity']}: {finding['text']}" for finding in report.get("findings", [])]


class Cases:
    def __init__(self, build, folder, is_short):
        self.build, self.folder, self.is_short = build, folder, is_short
        self.openr = str(build / "bin/openr")
        self.env = {**os.environ, "NO_COLOR": "1", "XDG_RUNTIME_DIR": str(self.make("live")),
                    "XDG_CACHE_HOME": str(self.make("cache")), "TMPDIR": str(self.make("temp"))}
        self.out = self.make("out")
        self.good_stick = self.folder / "good"
        self.check_output("stick", "host", "-o", str(self.good_stick))
        self.good = self.run(self.good_stick)[2]
        self.count = 0

    def make(self, name):
        (self.folder / name).mkdir()
        return self.folder / name

    def command(self, *words, **env):
        """Runs openr; returns the status and all that it printed."""
        done = subprocess.run([self.openr, *map(str, words)], env={**self.env, **env}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=LIMIT_S, check=False)
        return done.returncode, done.stdout

    def check_output(self, *words):
        status, said = self.command(*words)
        if status != 0:
            sys.exit(f"openr {' '.join(words)}: status {status}\n{said}")

    def run(self, stick, *flags, seconds=1):
        """Runs the stick; returns status, what was printed, and the report."""
        report = self.out / "report.json"
        report.unlink(missing_ok=True)
        status, said = self.command("run", *QUICK, "--for", f"{seconds}s", "--stick", stick, "--report", report,
                                    *flags)
        return status, said, json.loads(report.read_text()) if report.exists() else {}

    @contextlib.contextmanager
    def disk(self, kind):
        """Makes a good disk that can become bad in the way `kind`."""
        self.count += 1
        disk = Disk(self.folder / f"disk{self.count}")
        try:
            yield Bad(disk, kind)
        finally:
            disk.close()

    @contextlib.contextmanager
    def stick(self, kind, trouble=""):
        """Makes a disk with a stick: the default one, or one of an object that is told to do `trouble`."""
        with self.disk(kind) as bad:
            stick = bad.path / "stick"
            if trouble:
                self.make_trouble(stick, trouble)
            else:
                shutil.copytree(self.good_stick, stick)
            yield bad, stick

    def make_trouble(self, stick, word):
        for name in ("CONF", "OBJS", "DATA/P"):
            (stick / "OPEN-R/MW" / name).mkdir(parents=True)
        (stick / "OPEN-R/MW/CONF/OBJECT.CFG").write_text("/MS/OPEN-R/MW/OBJS/TROUBLE.BIN\n")
        (stick / "OPEN-R/MW/CONF/CONNECT.CFG").write_text("")
        (stick / "OPEN-R/MW/DATA/P/TROUBLE.TXT").write_text(word)
        (stick / "OPEN-R/MW/DATA/P/STAY.TXT").write_text("stay")
        shutil.copy(self.build / "images/TROUBLE.BIN", stick / "OPEN-R/MW/OBJS")

    def check_next_start(self, name, stick):
        """Checks that the stick of the default objects works again."""
        status, said, report = self.run(stick)
        left = [str(path) for path in stick.rglob("UPLOAD*")]
        verdict(f"{name}: the next start", status == 0 and not left and not report["findings"],
                f"status {status}, left {left}\n{said}")

    # ---- The cases

    def runs(self, kind):
        """A run of the default objects."""
        with self.stick(kind) as (bad, stick):
            before = files_of(stick)
            bad.spoil()
            status, said, report = self.run(stick)
            # The messages of the boot say whether the stick is write-protected.
            keys = ("trace_hash", "state_hash") if kind == "full" else ("state_hash",)
            same = all(report.get(key) == self.good[key] for key in keys)
            verdict(f"{kind}: a run is the same as ever", status == 0 and same, said)
            noted = [text for text in findings_of(report) if text.startswith(f"note: {stick}: the disk is mounted "
                                                                             "read-only")]
            expected = 1 if kind == "read-only" else 0
            verdict(f"{kind}: a note says that the stick is write-protected",
                    len(noted) == len(report.get("findings", [])) == expected, said)
            verdict(f"{kind}: a run changes nothing", files_of(stick) == before)
            bad.mend()
            self.check_next_start(kind, stick)

    def recorded(self, kind):
        """A recording is replayed when the disk is good again."""
        with self.stick(kind, "writes") as (bad, stick):
            bad.spoil()
            record = self.out / "run.rec"
            status, said, _ = self.run(stick, "--record", record)
            bad.mend()
            replayed, answer = self.command("replay", record)
            # A recording does not have the errors of the disk, so in the replay all bytes find room.
            good = replayed == 0 if kind == "read-only" else replayed == 1 and "difference: " in answer
            verdict(f"{kind}: the recording replays, or the replay names a difference", status == 0 and good,
                    said + answer)

    def objects(self, kind, *flags):
        """Checks which errors an object gets, and what the run says about the object's files."""
        name = " ".join([kind, *flags])
        with self.stick(kind, "writes") as (bad, stick):
            folder = stick / "OPEN-R/MW/DATA/P"
            before = files_of(stick)
            bad.spoil()
            status, said, report = self.run(stick, *flags)
            number = bad.errno
            if kind == "full":
                # A new file or folder needs no room in memory.
                expected = ["W stick 2", f"W stdio fopen 1 fwrite -1/{number} fflush 0 fclose 0",
                            f"W close fputs 1 fclose -1/{number}", f"W descriptor open 1 write -1/{number} close 0",
                            "W ofstream open 1 good 0", "W folders mkdir 0 remove 0 rename 0"]
                named = {f"warning: /MS/OPEN-R/MW/DATA/P/{file}.TXT: not all bytes that were written are in the "
                         f"file: {NO_ROOM}; make room on the disk that holds {folder}/{file}.TXT"
                         for file in ("STDIO", "CLOSE", "OPEN", "STREAM", "REWIND", "REOPEN", "CLEAR", "LEFT")
                         if file != "LEFT" or not flags}  # a process of its own has ended by then
            else:
                expected = ["W stick 1", f"W stdio fopen 0/{number}", f"W descriptor open 0/{number}",
                            "W ofstream open 0 good 0",
                            f"W folders mkdir -1/{number} remove -1/{errno.ENOENT} rename -1/{number}"]
                named = {f"note: /MS/OPEN-R/MW/DATA/P/{file} cannot be written: the stick is write-protected"
                         for file in ("STDIO.TXT", "CLOSE.TXT", "LEFT.TXT", "STREAM.TXT", "MADE", "STAY.TXT")}
            missing = [line for line in expected if line not in said]
            verdict(f"{name}: the object sees the errors of the robot", status == 0 and not missing, f"{missing}\n{said}")
            missing = named - set(findings_of(report))
            verdict(f"{name}: a finding for each file", not missing, f"missing {sorted(missing)}\n{said}")
            if kind == "read-only":
                verdict(f"{name}: nothing has changed", files_of(stick) == before)
            bad.mend()
            if not (folder / "STAY.TXT").exists():
                (folder / "MOVED.TXT").rename(folder / "STAY.TXT")
            status, said, report = self.run(stick, *flags)
            sizes = {path.name: path.stat().st_size for path in folder.iterdir()}
            whole = all(sizes.get(f"{file}.TXT") == 6000 for file in ("STDIO", "OPEN", "STREAM"))
            verdict(f"{name}: with room all is written", status == 0 and whole and not report["findings"],
                    f"{sizes}\n{said}")

    def crashes(self, kind, pages=0):
        """The record of a crash."""
        with self.stick(kind, "crash") as (bad, stick):
            log = stick / "OPEN-R/EMON.LOG"
            bad.spoil()
            if pages:
                bad.disk.fill(pages)
            status, said, _ = self.run(stick)
            told = f"{log}: the record of the crash cannot be written: {bad.reason}" in said
            name = f"{kind}, room {pages}"
            verdict(f"{name}: a crash is told, and why there is no EMON.LOG",
                    status == 1 and "EXCEPTION SIGSEGV" in said and (told or pages > 0 and log.exists()), said)
            verdict(f"{name}: no part of a record", log.exists() != told, said)
            bad.mend()
            status, said, _ = self.run(stick)
            read, answer = self.command("emon", log)
            verdict(f"{name}: with room there is a record", status == 1 and read == 0, said + answer)

    def uploads(self, kind):
        """Uploads to a run; on a full disk with all amounts of room."""
        with self.stick(kind) as (bad, stick):
            folder = self.make(f"uploads-{kind}")
            if kind == "read-only":
                bad.spoil()
            run = rc.Run(self.openr, folder, "--rate", RATE, stick=stick)
            try:
                self.upload_all(run, bad)
                why = run.end()
                verdict(f"{kind}: the run ends as the pause button asks", not why, why)
            finally:
                run.kill()
            bad.mend()
            self.check_next_start(kind, stick)

    def upload_all(self, run, bad):
        client = rc.Client(run.port)
        run.wait_until_standing(client)
        stand = (self.good_stick / rc.FOLDERS[rc.MOTION] / "STAND.MTN").read_bytes()
        image = (self.good_stick / rc.FOLDERS[rc.IMAGE] / IMAGE).read_bytes()
        whole = {rc.MOTION: stand + bytes(3 * PAGE), rc.IMAGE: image + bytes(PAGE)}
        name = {rc.MOTION: MOTION, rc.IMAGE: IMAGE}
        for kind, data in whole.items():
            # A new motion needs its own size; an image also that of the one which is kept.
            most = 2 * (len(data) // PAGE) + 3 if bad.kind == "full" else 0
            rooms = range(most + 1)
            if self.is_short:
                rooms = sorted({0, most // 3, most * 2 // 3})
            for pages in rooms:
                if bad.kind == "full":
                    bad.disk.fill(pages)
                self.upload(run, client, bad, kind, name[kind], data + bytes([pages % 256]), pages)
        bad.mend()
        for kind, data in whole.items():
            if bad.kind == "read-only":
                break  # the run has seen at its start that the stick is write-protected
            wrong = self.try_upload(client, kind, name[kind], data)
            there = (run.stick / rc.FOLDERS[kind] / name[kind]).read_bytes()
            verdict(f"{bad.kind}: with room {name[kind]} is uploaded", not wrong and there == data, wrong)

    @staticmethod
    def try_upload(client, kind, name, data):
        """Uploads a file; returns "" or the refusal."""
        packets = rc.upload_packets(kind, name, data)
        try:
            for at in range(0, len(packets), 30):
                client.ask_all(packets[at:at + 30])
        except rc.Refused as refused:
            return str(refused)
        return ""

    def upload(self, run, client, bad, kind, name, data, pages):
        """Uploads a file once, and looks at the stick."""
        before = files_of(run.stick)
        refused = self.try_upload(client, kind, name, data)
        after = files_of(run.stick)
        path = f"{rc.FOLDERS[kind]}/{name}"
        expected = dict(before)
        if not refused:
            expected[path] = data
            if kind == rc.IMAGE:
                expected[f"{rc.FOLDERS[kind]}/CONTROLL.OLD"] = before[path]
        else:
            # The old image may be kept already when the new one finds no room.
            old = f"{rc.FOLDERS[rc.IMAGE]}/CONTROLL.OLD"
            if kind == rc.IMAGE and after.get(old) == before[path]:
                expected[old] = after[old]
        changed = [name for name in after.keys() | expected.keys() if after.get(name) != expected.get(name)]
        case = f"{bad.kind}, room for {pages} pages: {name}"
        verdict(f"{case} is there whole, or as before", not changed, f"changed {changed}; {refused}")
        reason = "the stick is full; delete files from it" if bad.kind == "full" else "the stick is write-protected"
        good = not refused or f"status {NOT_WRITTEN}, " in refused and reason in refused
        verdict(f"{case} is refused with the reason", good and (refused or pages > 0), refused)
        answers = client.ask_all([(rc.GET, b"\x01"), (rc.POWER, b"")])
        verdict(f"{case}: the run goes on", len(answers) == 2)

    def outputs(self, kind):
        """The files of a run on such a disk."""
        with self.disk(kind) as bad:
            bad.spoil()
            flags = {"--record": "run.rec", "--log-data": "run.csv", "--timeline": "run.json",
                     "--console": "console.txt", "--speaker": "run.wav", "--report": "report.json"}
            for flag, file in flags.items():
                if self.is_short and flag not in ("--record", "--report"):
                    continue
                path = bad.path / file
                status, said = self.command("run", *QUICK, "--for", "1s", "--stick", self.good_stick, flag, path)
                verdict(f"{kind}: {flag} is refused with the reason",
                        status in (1, 2) and f"{path}: " in said and bad.reason in said, f"status {status}\n{said}")
                self.check_rest(f"{kind}: {flag}", path)

    def check_rest(self, name, path):
        """Checks that what is left of a file can be read, or is refused with a reason."""
        if not path.exists():
            return
        if path.suffix == ".rec":
            status, said = self.command("trace", path)
            verdict(f"{name}: a recording in part is read or refused", status in (0, 1) and said, said)
        else:
            verdict(f"{name}: nothing is left but an empty file or a log", path.stat().st_size == 0
                    or path.suffix in (".csv", ".txt"), f"{path.stat().st_size} bytes of {path}")

    def temporary(self, kind):
        """Temporary files, the cache and the socket of a run on such a disk."""
        with self.disk(kind) as bad:
            bad.spoil()
            rooms = (0,) if self.is_short or kind == "read-only" else (0, 50, 150, 200, 250, 300)
            for pages in rooms:
                if pages:
                    bad.disk.fill(pages)
                status, said = self.command("run", *QUICK, "--for", "1s", TMPDIR=str(bad.path))
                # 200 pages are enough for the copy of the stick, but not for those of the images.
                good = status == 1 and str(bad.path) in said and "TMPDIR" in said and (
                    bad.reason in said or "no room is left on the disk" in said)
                case = f"{kind}, room for {pages} pages: TMPDIR"
                # The images may be smaller than those that the rooms are made for.
                verdict(f"{case} is refused with the reason", good or (pages > 200 and status == 0),
                        f"status {status}\n{said}")
                left = [str(path) for path in bad.path.iterdir() if path != bad.disk.filler]
                verdict(f"{case}: nothing is left", not left, str(left))
            status, said = self.command("run", *QUICK, "--for", "1s", "--stick", self.good_stick,
                                        XDG_RUNTIME_DIR=str(bad.path))
            verdict(f"{kind}: XDG_RUNTIME_DIR: the run goes to its end, or is refused with the reason",
                    status == 0 or bad.reason in said, f"status {status}\n{said}")
            status, said = self.command("run", *QUICK, "--for", "1s", XDG_CACHE_HOME=str(bad.path / "cache"))
            verdict(f"{kind}: XDG_CACHE_HOME is not needed", status == 0, f"status {status}\n{said}")

    def new_folders(self, kind):
        """Commands that make a stick or an object on such a disk."""
        for name, command, rooms in (("stick", ["stick", "host", "-o", "new"], (0, 100)),
                                     ("new", ["new", "Dog"], (0, 3))):
            for pages in rooms[:1 if kind == "read-only" else None]:
                with self.disk(kind) as bad:
                    bad.spoil()
                    if pages:
                        bad.disk.fill(pages)
                    status, said = self.command_in(bad.path, command)
                    case = f"{kind}, room for {pages} pages: openr {name}"
                    reasons = (bad.reason, "no room is left on the disk", "this disk is read-only",
                               "is mounted read-only")
                    verdict(f"{case} is refused with the reason",
                            status in (1, 2) and any(reason in said for reason in reasons), f"status {status}\n{said}")
                    left = [str(path) for path in bad.path.rglob("*") if path != bad.disk.filler and path.is_file()]
                    verdict(f"{case} leaves nothing", not left, str(left))
                    bad.mend()
                    status, said = self.command_in(bad.path, command)
                    verdict(f"{case} works with room", status == 0, f"status {status}\n{said}")

    def command_in(self, folder, words):
        done = subprocess.run([self.openr, *map(str, words)], env=self.env, cwd=folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=LIMIT_S, check=False)
        return done.returncode, done.stdout

    def damaged(self, call, error, when="1+"):
        """Uploads to a stick whose disk refuses one kind of calls, the first one or all: the
        acknowledged motion stays."""
        folder = self.make(f"damaged-{call}-{error}-{when}")
        shutil.copytree(self.good_stick, folder / "stick")
        path = folder / "stick" / rc.FOLDERS[rc.MOTION] / MOTION
        data = (path.parent / "STAND.MTN").read_bytes()
        path.write_bytes(data)
        run = rc.Run(self.openr, folder, "--rate", RATE, stick=folder / "stick",
                     prefix=["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={call}",
                             "-e", f"inject={call}:error={error}:when={when}"])
        try:
            client = rc.Client(run.port)
            run.wait_until_standing(client)
            refused = self.try_upload(client, rc.MOTION, MOTION, data + bytes(100))
            names = sorted(file.name for file in path.parent.iterdir())
            whole = path.exists() and path.read_bytes() == data
            verdict(f"{call} {when} fails, {error}: an upload is refused, and the old motion stays",
                    f"status {NOT_WRITTEN}, " in refused and whole and "UPLOAD0.TMP" not in names,
                    f"{refused}; {names}")
        finally:
            subprocess.run(["pkill", "-KILL", "-P", str(run.process.pid)], check=False)
            run.kill()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--only", default="", help="cases whose name contains this word")
    flags = parser.parse_args()
    if INSIDE not in os.environ:
        print(enter_namespace())
        print("0 passed, 0 failed, 1 skipped")
        return 0
    with tempfile.TemporaryDirectory(prefix="bad-sticks-") as folder:
        cases = Cases(flags.build.resolve(), pathlib.Path(folder), flags.short)
        for kind in ("full", "read-only"):
            calls = [("runs", cases.runs), ("objects", cases.objects), ("crashes", cases.crashes),
                     ("uploads", cases.uploads), ("outputs", cases.outputs), ("temporary", cases.temporary),
                     ("recorded", cases.recorded)]
            if not flags.short:
                calls += [("new_folders", cases.new_folders),
                          ("apart", lambda kind: cases.objects(kind, "--place", "Trouble=away"))]
            if not flags.short and kind == "full":
                calls += [("crashes", lambda kind: cases.crashes(kind, 1)), ("damaged", lambda _: damage(cases))]
            for name, call in calls:
                if flags.only in name:
                    call(kind)
    return finish()


def damage(cases):
    if not shutil.which("strace"):
        sys.exit("strace is not installed (Debian package strace)")
    for call, error in (("rename", "ENOSPC"), ("rename", "EACCES"), ("fsync", "EIO"), ("fsync", "ENOSPC")):
        cases.damaged(call, error)
    # Linux reports once that the bytes of a file are lost.
    cases.damaged("fsync", "EIO", "1")


if __name__ == "__main__":
    sys.exit(main())
