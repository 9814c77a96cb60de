#!/usr/bin/env python3
"""tools/commits.py: which commits it checks, and which of them it refuses.  The last line is "N passed, N failed"."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

# Only what is set here: a hook of git that runs the tests names its repository in the environment.
ENVIRONMENT = {**{name: value for name, value in os.environ.items() if not name.startswith("GIT_")},
               "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1",
               "GIT_AUTHOR_NAME": "A", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "A", "GIT_COMMITTER_EMAIL": "a@b"}
LONG = "Give a subject of fifty-one characters to a commit."[:-1] + "s"
BAD = "Stop here."


def git(folder, *words, text=None):
    subprocess.run(["git", "-C", folder, "-c", "protocol.file.allow=always", *words], env=ENVIRONMENT, input=text,
                   text=True, capture_output=True, check=True)


class Checkout:
    """A repository in a folder that is gone at the end of a `with` block; it has a first commit on `main`."""

    def __enter__(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name, "here")
        self.folder.mkdir()
        git(self.folder, "init", "-q", "-b", "main")
        self.commit("Begin.", {"old": "x\n" * 2000})
        return self

    def __exit__(self, *_):
        self.scratch.cleanup()

    def write(self, files):
        for name, text in files.items():
            file = self.folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def commit(self, message, files=None):
        self.write(files or {})
        git(self.folder, "add", "-A")
        git(self.folder, "commit", "-q", "--allow-empty", "-F", "-", text=message)

    def git(self, *words):
        git(self.folder, *words)

    def clone(self, *words):
        """Returns a clone beside this checkout."""
        other = Checkout()
        other.folder = Path(self.scratch.name, "there")
        git(self.folder, "clone", "-q", *words, f"file://{self.folder}", str(other.folder))
        return other

    def faults(self):
        """Returns the lines that the tool prints, without the ids of the commits."""
        done = subprocess.run([sys.executable, ROOT / "tools/commits.py", self.folder], env=ENVIRONMENT,
                              capture_output=True, text=True, check=False)
        lines = done.stdout.splitlines()
        if done.returncode != bool(lines):
            return [f"status {done.returncode}: {done.stdout}{done.stderr}"]
        return [line.partition(": ")[2] for line in lines]


def check_rule(name, message, files, wanted):
    with Checkout() as here:
        here.git("checkout", "-q", "-b", "work")
        here.commit(message, files)
        said = here.faults()
        verdict(name, [line.split(",")[0].split(":")[0] for line in said] == wanted, str(said))


def check_rules():
    lines = "a line\n" * 1501
    check_rule("50 characters are good", LONG[:50], {"a": lines[7:]}, [])
    check_rule("51 are too many", LONG, {}, ["the subject has 51 characters"])
    check_rule("characters count, not bytes", "ä" * 50, {}, [])
    check_rule("a full stop is refused", BAD, {}, ["the subject ends with a full stop"])
    check_rule("a full stop within is not", "Stop ./dev at x.cc", {}, [])
    check_rule("1,501 lines are too many", "Add", {"a": lines}, ["changes 1501 lines"])
    check_rule("also in two files, with a blank and a tab", "Add", {"a b": lines[7:], "c\td": "x\n"}, ["changes 1501 lines"])
    check_rule("deleted lines count", "Clear", {"old": "", "a": "x\n"}, ["changes 2001 lines"])
    check_rule("a reason allows them", "Add\n\nWhy.\n\nLarge: a table of lines\nOther: x\n", {"a": lines}, [])
    check_rule("a reason must be given", "Add\n\nLarge:\n", {"a": lines}, ["changes 1501 lines"])
    check_rule("lines of generated files do not count", "Add", {"docs/conformance.md": lines, "docs/pictures/a/b.svg": lines}, [])
    check_rule("but those of files beside them do", "Add", {"docs/conformance.md.txt": lines}, ["changes 1501 lines"])
    check_rule("lines of binary files do not count", "Add", {"a": "\0" + lines}, [])
    check_rule("a commit without a change is good", "Note", {}, [])
    with Checkout() as here:
        here.git("checkout", "-q", "-b", "work")
        here.git("mv", "old", "new")
        here.commit("Move")
        verdict("moved lines do not count", here.faults() == [], str(here.faults()))
        here.git("mv", "new", "newer")
        here.commit("Move and add", {"newer": "x\n" * 2000 + "y\n" * 1501})
        verdict("lines that are added on the way do", len(here.faults()) == 1 and "1501 lines" in here.faults()[0],
                str(here.faults()))


def check_choice():
    with Checkout() as here:
        verdict("the first commit is not checked", here.faults() == [])
        for number in range(25):
            here.commit(f"Step {number}.")
        verdict("without a remote, the last 20 of main are checked", len(here.faults()) == 20, str(here.faults()))
        here.git("checkout", "-q", "-b", "work")
        verdict("also on a branch that has nothing more", len(here.faults()) == 20, str(here.faults()))
        here.commit("Work.")
        verdict("on a branch, only what main does not have", here.faults() == ["the subject ends with a full stop: Work."],
                str(here.faults()))
        here.git("checkout", "-q", "-b", "side", "main")
        here.commit("Go on", {"a": "x"})
        here.git("merge", "-q", "--no-ff", "-m", "Merge with a subject that is much longer than fifty characters.", "work")
        verdict("a merge is not checked, and what it brings is",
                here.faults() == ["the subject ends with a full stop: Work."], str(here.faults()))
        there = here.clone()
        verdict("a fresh clone has nothing to check", there.faults() == [], str(there.faults()))
        there.commit(BAD)
        verdict("a commit in a clone is checked", len(there.faults()) == 1, str(there.faults()))
        there.git("checkout", "-q", "main")
        verdict("main of a clone is not", there.faults() == [], str(there.faults()))
        here.git("branch", "-m", "main", "trunk")
        here.git("checkout", "-q", "--detach")
        verdict("without main and remotes nothing is checked", here.faults() == [], str(here.faults()))


def check_clones():
    with Checkout() as here:
        here.commit(BAD, {"a": "x\n" * 1501})
        there = here.clone("--depth", "1")
        verdict("a shallow clone has nothing to check", there.faults() == [], str(there.faults()))
        there.git("remote", "remove", "origin")
        verdict("also without its remote", there.faults() == [], str(there.faults()))
        there.commit(BAD)
        verdict("but what is committed on it", len(there.faults()) == 1, str(there.faults()))
        inner = Checkout()
        inner.folder = here.folder / "archive"
        inner.folder.mkdir()
        verdict("an archive of the sources has nothing to check", inner.faults() == [], str(inner.faults()))
        (inner.folder / ".git").write_text("damaged")
        verdict("nor has a repository that git cannot read", inner.faults() == [], str(inner.faults()))


assert len(LONG) == 51
check_rules()
check_choice()
check_clones()
sys.exit(finish())
