#!/usr/bin/env python3
"""run_docs_test.py --build DIR: which pages run_docs.py refuses, and which it lets pass.

The last line is "N passed, N failed".
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

RUNNER = pathlib.Path(__file__).with_name("run_docs.py")


def fenced(info, *lines):
    return "\n".join([f"```{info}", *lines, "```", "", ""])


GOOD = [
    ("a page without commands", "# Title\n\nText, and `code`.\n"),
    ("a command that ends well", fenced("sh", "true")),
    ("one that prints what the page says", fenced("sh", "seq 5") + fenced("output", "2", "3")),
    ("lines with others between them", fenced("sh", "seq 5") + fenced("output", "1", "...", "5")),
    ("any text within a line", fenced("sh", "echo at t=1.25 s") + fenced("output", "at t=... s")),
    ("standard error", fenced("sh", "echo bad >&2") + fenced("output", "bad")),
    ("blocks share folder and variables",
     fenced("sh", "mkdir a; cd a; x=1") + fenced("sh", '[ $x = 1 ]; [ "${PWD##*/}" = a ]')),
    ("a listing is a file for the commands behind it",
     fenced("cpp file=sub/a.cc", "int a;") + fenced("sh", "cat sub/a.cc") + fenced("output", "int a;")),
    ("a later listing replaces an earlier one",
     fenced("text file=a", "one") + fenced("sh", "cat a") + fenced("output", "one") +
     fenced("text file=a", "two") + fenced("sh", "cat a") + fenced("output", "two")),
    ("a quotation of a file", fenced("text from=tests/docs/page.py", "class Fault(Exception):")),
    ("an expected status", fenced("sh status=3", "(exit 3)") + fenced("sh", "true")),
    ("a slow command is left out", fenced("sh slow", "false") + fenced("output", "never")),
    ("commands for the robot are left out", fenced("sh robot needs the dog", "false")),
    ("a reason not to run", fenced("python not-run an idea only", "boom(")),
    ("openr is in PATH", fenced("sh", "openr version", 'test -d "$OPENR_HOST/docs"')),
    ("a list with lines under its items", "1. one\n\n    more of one\n"),
    ("programs left in the background", fenced("sh", "sleep 1000 &", "echo x") + fenced("output", "x")),
]

# Title, page, and words that the complaint has.
BAD = [
    ("a command that fails", fenced("sh", "true", "echo so far; false", "true"),
     "page.md:1: ended with status 1", "$ echo so far; false", "| so far"),
    ("a later block that fails", "\n\n" + fenced("sh", "true") + fenced("sh", "(exit 7)"),
     "page.md:7: ended with status 7"),
    ("a pipe whose first part fails", fenced("sh", "false | cat"), "ended with status 1"),
    ("an unset variable", fenced("sh", "echo $nothing_here"), "unbound variable"),
    ("a missing line", fenced("sh", "seq 3") + fenced("output", "4"), "page.md:1: line 5 says", "'4'"),
    ("lines in another order", fenced("sh", "seq 3") + fenced("output", "3", "...", "1"), "prints '1'"),
    ("lines that are not neighbours", fenced("sh", "seq 3") + fenced("output", "1", "3"), "prints '3'"),
    ("a part of a line", fenced("sh", "echo abc") + fenced("output", "ab"), "prints 'ab'"),
    ("another status than the expected one", fenced("sh status=2", "true"), "status 0, the page says 2"),
    ("a language without a mark", fenced("cpp", "int a;"), "page.md:1: 'cpp' is none of"),
    ("no word at all", fenced("", "true"), "page.md:1: a fence without a word"),
    ("an unknown mark", fenced("sh often", "true"), "'sh often' is unknown"),
    ("no reason", fenced("sh not-run", "true"), "'not-run' needs a reason"),
    ("no reason for the robot", fenced("sh robot", "true"), "'robot' needs a reason"),
    ("a fence that is never closed", "```sh\ntrue\n", "page.md:1: the fence is never closed"),
    ("output of nothing", fenced("output", "a"), "output without commands"),
    ("output after a listing", fenced("text file=a", "a") + fenced("output", "a"), "output without commands"),
    ("an indented block", "Text\n\n    openr run\n", "page.md:3: an indented block"),
    ("a file outside of the folder", fenced("text file=../a", "a"), "names no file below"),
    ("a quotation of no file", fenced("cpp from=nowhere.cc", "a"), "there is no nowhere.cc"),
    ("a quotation with another line", fenced("cpp from=tests/docs/page.py", "class Faulty:"),
     "page.md:1: tests/docs/page.py has no such line"),
]


def run(build, text, *flags):
    """Returns status and output of the runner for a page of this text."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "page.md").write_text(text)
        done = subprocess.run([sys.executable, str(RUNNER), "--build", str(build), *flags, "page.md"],
                              cwd=folder, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True, type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    for title, text in GOOD:
        status, said = run(build, text)
        verdict(title, status == 0 and said.endswith("1 passed, 0 failed\n"), said)
    for title, text, *words in BAD:
        status, said = run(build, text)
        good = status == 1 and said.endswith("0 passed, 1 failed\n") and all(word in said for word in words)
        verdict(title, good, said)
    status, said = run(build, fenced("sh slow", "false"), "--slow")
    verdict("--slow runs slow blocks", status == 1 and "page.md:1: ended" in said, said)
    status, said = run(build / "nowhere", fenced("sh", "true"))
    verdict("a build folder without openr", status == 1 and "is not built" in said, said)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
