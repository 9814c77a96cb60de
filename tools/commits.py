#!/usr/bin/env python3
"""Checks the commits that can still be changed: length of the subject, number of changed lines.

    tools/commits.py [FOLDER]     prints each commit with its fault

FOLDER is a checkout; without FOLDER, this checkout is read.  The rules:

    - a subject has at most 50 characters and no full stop at its end;
    - a commit changes at most 1,500 lines, inserted and deleted ones together.  Files that a program
      makes (GENERATED), binary files and lines that only move with their file do not count.  A commit
      that has to be larger says why in its message, in a line such as "Large: renames a folder".

A commit that others have cannot be changed any more.  A rule that fails for it would fail for ever, so
only these commits are checked:

    - those that no remote-tracking branch has.  So a fresh clone, as CI makes it, checks none: its
      commits all come from the remote.  They were checked where they were made;
    - without remote-tracking branches, those that `main` does not have;
    - the last 20 if `main` has all of them, because without a remote nothing is published;
    - none if there is no `main` either, as in a checkout of a bare commit id, or no repository, as in an
      archive of the sources: nothing tells which commits are new.

Merges are not checked, because git writes their subject and their lines belong to other commits, and
neither are commits without a parent: the first one of a project, and the oldest one of a shallow clone,
whose lines would be those of the whole tree.
"""
import re
import subprocess
import sys
from pathlib import Path

SUBJECT_MAX = 50
LINES_MAX = 1500
LAST = 20  # commits of `main` that are checked where there is no remote
# Files made by programs: documents, tables, pictures and recorded results.
GENERATED = re.compile(r"docs/conformance\.md|docs/pictures/.*|tools/surface/sdk_surface\.tsv|"
                       r"python/openr_host/_commands\.py|panel/package-lock\.json|bench/instructions\.json|"
                       r"tests/examples/hashes\.txt|tests/determinism/golden\.txt")
LARGE = re.compile(r"^Large: *\S", re.MULTILINE)


class Repository:
    def __init__(self, folder):
        self.folder = folder

    def git(self, *words):
        done = subprocess.run(["git", "-C", self.folder, *words], stdout=subprocess.PIPE, check=True)
        return done.stdout.decode(errors="replace")

    def has(self, branch):
        command = ["git", "-C", self.folder, "rev-parse", "--verify", "--quiet", f"refs/heads/{branch}"]
        return subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode == 0

    def commits(self):
        """Returns the ids of the commits that can still be changed, the newest first."""
        listing = ["rev-list", "--no-merges", "--min-parents=1"]
        if self.git("for-each-ref", "--count=1", "refs/remotes"):
            return self.git(*listing, "HEAD", "--not", "--remotes").split()
        if not self.has("main"):
            return []
        if self.git("rev-list", "--count", "refs/heads/main..HEAD").strip() == "0":
            return self.git(*listing, f"--max-count={LAST}", "HEAD").split()
        return self.git(*listing, "refs/heads/main..HEAD").split()

    def message(self, commit):
        """Returns the subject and the whole message."""
        subject, _, message = self.git("show", "--no-patch", "--format=%s%n%B", commit).partition("\n")
        return subject, message

    def changed_lines(self, commit):
        """Returns how many lines the commit inserts and deletes, without those of GENERATED."""
        # -l0: finds renames among any number of files; -z: names are as they are, without quotes.
        fields = self.git("diff-tree", "-r", "-M", "-l0", "--numstat", "-z", "--no-commit-id",
                          commit).split("\0")
        lines, at = 0, 0
        while at < len(fields) - 1:
            inserted, deleted, name = fields[at].split("\t", 2)
            at += 1
            if not name:  # a renamed file: the old and the new name follow
                name = fields[at + 1]
                at += 2
            if inserted != "-" and not GENERATED.fullmatch(name):  # "-": a binary file
                lines += int(inserted) + int(deleted)
        return lines


def faults(repository, commit):
    """Yields what is wrong with a commit."""
    subject, message = repository.message(commit)
    if len(subject) > SUBJECT_MAX:
        yield f"the subject has {len(subject)} characters, above {SUBJECT_MAX}: {subject}"
    if subject.endswith("."):
        yield f"the subject ends with a full stop: {subject}"
    lines = repository.changed_lines(commit)
    if lines > LINES_MAX and not LARGE.search(message):
        yield (f"changes {lines} lines, above {LINES_MAX}; split it, or say why in its message in a line "
               f"'Large: REASON': {subject}")


def main():
    folder = Path(sys.argv[1]).resolve() if sys.argv[1:] else Path(__file__).resolve().parent.parent
    repository = Repository(folder)
    try:
        if not (folder / ".git").exists():  # an archive, maybe within a checkout of something else
            return 0
        commits = repository.commits()
    except (OSError, subprocess.CalledProcessError):
        print("commits.py: git cannot read the history, so no commit is checked", file=sys.stderr)
        return 0
    found = [f"{commit[:12]}: {fault}" for commit in commits for fault in faults(repository, commit)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
