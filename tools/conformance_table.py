#!/usr/bin/env python3
"""Makes docs/conformance.md of tests/conformance/statements*.tsv.

    tools/conformance_table.py           writes the table
    tools/conformance_table.py --check   prints each fault: an unknown test, a bad line, a table
                                         that is out of date

Every test named has to exist below tests/: Suite.Name of a *_test.cc, or a file.  That holds for
the tests that other documents name in backticks as well, with * for any part of a name.
"""
import fnmatch
import re
import sys
from pathlib import Path

from citations import PLACE, Book

ROOT = Path(__file__).resolve().parent.parent
STATEMENTS = sorted((ROOT / "tests/conformance").glob("statements*.tsv"))
TABLE = ROOT / "docs/conformance.md"
STATUSES = ("ok", "chosen", "open")

HEAD = """# Conformance

What the [reference on OPEN-R](openr/README.md) says, and the test that holds it. Made by `tools/conformance_table.py` of
`tests/conformance/statements*.tsv`; do not edit.

*ok*: the test proves the statement. *chosen*: no source settles it, the test holds our choice. *open*: not done.
"""


def tests_of_tree():
    names = set()
    for source in (ROOT / "tests").rglob("*_test.cc"):
        for suite, name in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", source.read_text(), re.M):
            names.add(f"{suite}.{name}")
    return names


def unknown_tests(known):
    """Returns FILE:LINE and name of each test that a document names and that is not there."""
    problems = []
    for file in sorted((ROOT / "docs").glob("*.md")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            for name in re.findall(r"`(\*?[A-Z]\w*(?:Test|Conformance)\*?\.[\w.*]+)`", line):
                pattern = name[:-3] + "*" if name.endswith("...") else name
                if not fnmatch.filter(known, pattern):
                    problems.append(f"{file.relative_to(ROOT)}:{number}: there is no test '{name}'")
    return problems


def read_statements(problems):
    """Returns the sections in order, each as (title, [(statement, source, tests, status)])."""
    known = tests_of_tree()
    sections = []
    lines = [(f"{file.relative_to(ROOT)}:{number}", line) for file in STATEMENTS
             for number, line in enumerate(file.read_text().splitlines(), 1)]
    for where, line in lines:
        if line.startswith("## "):
            sections.append((line[3:], []))
        elif line and not line.startswith("#"):
            fields = line.split("\t")
            if len(fields) != 4 or fields[3] not in STATUSES or not sections:
                problems.append(f"{where}: not 'statement, source, tests, status' below a section")
                continue
            statement, source, tests, status = fields
            tests = tests.split()
            for test in tests:
                if test not in known and not (ROOT / "tests" / test).is_file():
                    problems.append(f"{where}: there is no test '{test}'")
            if (status == "open") != (not tests):
                problems.append(f"{where}: what is open has no test, anything else has one")
            sections[-1][1].append((statement, source, tests, status))
    return sections


def with_links(source, books):
    """Returns the source of a statement with links to the places in the books."""
    def link(found):
        name, place = found[1], found[2]
        target = books[name].anchor_of(place) if name in books and place else ""
        return f"[{found[0]}](openr/{name}.md{'#' if target else ''}{target})" if name in books else found[0]
    return re.sub(rf"\b([\w-]+)\.md(?: ({PLACE}))?", link, source)


def render(sections):
    books = {file.stem: Book(file.read_text()) for file in (ROOT / "docs/openr").glob("*.md")}
    rows = [row for _, rows in sections for row in rows]
    counts = ", ".join(f"{sum(row[3] == status for row in rows)} {status}" for status in STATUSES)
    text = f"{HEAD}\n{len(rows)} statements: {counts}.\n"
    for title, rows in sections:
        text += f"\n## {title}\n\n| statement | source | test | status |\n|---|---|---|---|\n"
        for statement, source, tests, status in rows:
            text += f"| {statement} | {with_links(source, books)} | {'<br>'.join(tests)} | {status} |\n"
    return text


def main():
    problems = []
    text = render(read_statements(problems))
    if "--check" in sys.argv[1:]:
        if not TABLE.exists() or TABLE.read_text() != text:
            problems.append("docs/conformance.md is out of date: run tools/conformance_table.py")
    elif not problems:
        TABLE.write_text(text)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
