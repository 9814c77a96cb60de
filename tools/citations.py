#!/usr/bin/env python3
"""Checks that each citation of a book of docs/openr or of the report leads to an existing place.

    tools/citations.py [FOLDER]     prints file:line and the fault of each bad citation

FOLDER is the root of a checkout; without FOLDER, this checkout is read.  The script reads code,
tests, docs and tools; a citation may go on in the next line of a comment.  Forms of a citation:

    core.md 2.5         section 2.5, or item 5 of section 2
    core.md 11 5        item 5 of section 11: of a list, or the row of a table with this number
    core.md, 2.8 and 11.17; robot.md 9.3 2, 16 3; measured.md 1.25 to 1.29
    measured.md section 1, "Notify and ready"                      words of the book, such as a heading
    Hohl 2004, section 5.3.7; Hohl 2004, table 3.8; appendix A     a place in docs/report.md
    BBS 1735            a message that some book cites
    MI 2.1; L2 4.2.2    a section of a guide that some book cites, or a section above it (also PG, IG,
                        MI-220, MI-7; in the file of a model, MI is the guide of that model)
    SEED 3.7            in the files of models: a table or section of the report
    docs/body.md        a file; in *.md also links, with their #anchors

A mark of a source in capital letters, before a number with dots or in "sources" of a model's file, has to
be in the tables of docs/openr/sources.md.  docs/openr/README.md has to name every book and every section
of each.
"""
import os
import re
import sys
from pathlib import Path

FOLDERS = (".ci", "bench", "cli", "cmake", "distribution", "docs", "examples", "kit", "objects", "openr",
           "panel", "python", "runtime", "stub.cfg", "testing", "tests", "tools", "virtualrobot")
SUFFIXES = {".c", ".cc", ".cfg", ".cmake", ".cost", ".cpp", ".h", ".idl", ".json", ".md", ".mjs", ".ocf", ".py",
            ".sh", ".ts", ".tsv", ".txt"}
MODELS = "virtualrobot/model"
GUIDE_OF_MODEL = {"ers7.json": "MI-7", "ers220.json": "MI-220"}
# Words in capital letters before a number with dots that is a version.
VERSIONED = {"VERSION", "SDK", "IEEE", "DDS", "CTF", "ODE", "GLSL"}
NUMBER = r"\d+(?:\.\d+)*"
PLACE = rf"{NUMBER}(?: +\d+(?![\w.]))?"
MORE = rf"(?:,|;| +and| +to| +or|-) *(?:section +)?(?={NUMBER}(?!\w))"


def anchor(heading):
    """Returns the anchor (part of a link behind #) that viewers of Markdown make of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def lines_outside_fences(text):
    inside = False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = not inside
        elif not inside:
            yield line


class Book:
    """Sections, numbered items and headings of one Markdown file."""

    def __init__(self, text):
        self.sections = {}  # section number -> {item numbers}
        self.headings = {}  # heading without its number -> anchor
        self.titles = []    # headings of the second level, with their numbers
        self.words = re.sub(r"\s+", " ", text)
        section = None
        for line in lines_outside_fences(text):
            head = re.match(r"(#+) +(.*)", line)
            item = re.match(rf"(?:(\d+)\. |\| ({NUMBER}) \|)", line)
            if head:
                title = head[2].strip()
                if head[1] == "##":
                    self.titles.append(title)
                number = re.match(rf"({NUMBER})\.? +(.*)", title)
                if number:
                    section = number[1]
                    self.sections[section] = set()
                self.headings[number[2] if number else title] = anchor(title)
            elif item and section:
                self.sections[section].add(item[1] or item[2])

    def has(self, place):
        """Returns whether the book has the place, such as '2.5', '11 5' or '9.3 2'."""
        section, _, item = place.partition(" ")
        if item:
            return item in self.sections.get(section, ())
        if section in self.sections:
            return True
        above, _, last = section.rpartition(".")
        items = self.sections.get(above, ())
        return last in items or section in items

    def says(self, words):
        return words in self.words

    def anchor_of(self, place):
        """Returns the anchor of the section that contains the place."""
        section = place.partition(" ")[0]
        while section not in self.sections and "." in section:
            section = section.rpartition(".")[0]
        for title, name in self.headings.items():
            if name == anchor(f"{section} {title}") or name == anchor(f"{section}. {title}"):
                return name
        return ""


class Report(Book):
    """docs/report.md: a book with tables and figures, whose rows begin with "Table" or "Figure"."""

    def __init__(self, text):
        super().__init__(text)
        self.places = {("section", number) for number in self.sections}
        for line in lines_outside_fences(text):
            first = re.match(r"\| (?:Table|Figure) [^|]*|#+ (?:Chapter|Appendix) \S+", line)
            for kind, number in re.findall(rf"(\w+) ({NUMBER}|[A-Z]\b)", first[0] if first else ""):
                self.places.add((kind.lower(), number))


def joined(text):
    """Replaces line ends, and the marks of a comment behind them, by blanks.

    The length stays, so that an offset is good for both texts.
    """
    return re.sub(r"\n[ \t]*(?://+|\*(?!/)|#)?[ \t]*",
                  lambda found: " " * len(found[0]), text)


def marks_of(file):
    """Returns the marks of the tables in the section "Marks of sources", without the numbers behind them."""
    marks, section = set(), ""
    for line in lines_outside_fences(file.read_text() if file.exists() else ""):
        if line.startswith("## "):
            section = line
        row = re.match(r"\| ([^|]+) \|", line)
        for mark in row[1].split(", ") if row and section == "## Marks of sources" else ():
            marks.add(re.sub(r"( [nx]|:x)$", "", mark))
    return marks


class Checker:
    def __init__(self, root):
        self.root = root
        self.problems = []
        folder = root / "docs/openr"
        self.books = {file.stem: Book(file.read_text()) for file in sorted(folder.glob("*.md"))
                      if file.stem != "README"}
        report = root / "docs/report.md"
        self.report = Report(report.read_text()) if report.exists() else Report("")
        self.messages = set()  # numbers of BBS messages that a book cites
        for file in folder.glob("*.md"):
            for number in self.board_numbers(joined(file.read_text())):
                self.messages.add(number[1])
        self.sections = set()  # (guide, section), such as ("MI", "2.1"), that a book cites
        for file in folder.glob("*.md"):
            self.sections |= {found[1:] for found in self.guide_sections(joined(file.read_text()))}
        self.marks = marks_of(folder / "sources.md")
        self.book_names = "|".join(map(re.escape, self.books)) or "(?!)"
        self.pages = {}

    def page(self, file):
        if file not in self.pages:
            self.pages[file] = Book(file.read_text())
        return self.pages[file]

    @staticmethod
    def board_numbers(text):
        """Yields (offset, number) for every BBS message that the text cites, also within ranges."""
        for found in re.finditer(r"\bBBS((?:,|/|-|–| and|\s)+\d+)+", text):
            for part in re.finditer(r"(\d+)(?:-(\d+))?", found[0]):
                first, last = int(part[1]), int(part[2] or part[1])
                for number in range(first, last + 1):
                    yield found.start() + part.start(), number

    @staticmethod
    def guide_sections(text):
        """Yields (offset, guide, section) for every section of a guide that the text cites."""
        for found in re.finditer(rf"\b(PG|L2|IG|MI(?:-220|-7)?) +({NUMBER}|[AB]\b)((?:(?:,| and| to) +\d+\.{NUMBER})*)",
                                 text):
            yield found.start(), found[1], found[2]
            for part in re.finditer(NUMBER, found[3]):
                yield found.start(3) + part.start(), found[1], part[0]

    def say(self, file, text, offset, what):
        line = text.count("\n", 0, offset) + 1
        self.problems.append(f"{file.relative_to(self.root)}:{line}: {what}")

    def check_books(self, file, text, flat):
        start = rf"(?:(?<![\w/.#-])|(?<=openr/))({self.book_names})\.md\b(?!#)"
        for found in re.finditer(start, flat):
            if flat[:found.start()].endswith("](") and flat[found.end():found.end() + 1] == ")":
                continue  # the target of a link; its text is the citation
            name, book, at = found[1], self.books[found[1]], found.end()
            if re.match(r":\d|,? lines? \d", flat[at:]):
                self.say(file, text, at, f"{name}.md by line: cite a section or statement")
            lead = re.match(rf",? +(?:sections? +)?(?={NUMBER}(?!\w))", flat[at:])
            while lead:
                at += lead.end()
                place = re.match(PLACE, flat[at:])[0]
                if not book.has(" ".join(place.split())):
                    self.say(file, text, at, f"{name}.md has no {' '.join(place.split())}")
                at += len(place)
                lead = re.match(MORE, flat[at:])
            step = re.match(r", +(?:step|row|item|question) +(\d+)", flat[at:])
            if step and place and not book.has(f"{place.partition(' ')[0]} {step[1]}"):
                self.say(file, text, at, f"{name}.md {place} has no {step[0][1:].strip()}")
            heading = re.match(r',? +"([^"]+)"', flat[at:])
            while heading:
                words = re.sub(r"\s+", " ", heading[1])
                if flat[found.end():at].strip() or heading[0].startswith(","):
                    if not book.says(words):
                        self.say(file, text, at, f'{name}.md does not say "{words}"')
                at += heading.end()
                heading = re.match(r'(?:,| and) +"([^"]+)"', flat[at:])

    def check_report(self, file, text, flat):
        kinds = "sections?|chapters?|tables?|figures?|appendix"
        for found in re.finditer(r"\bHohl\s+2004", flat):
            at, kind = found.end(), "section"
            while True:
                part = re.match(rf"(?:'s)?(?:,|\s|and\b|to\b)*\s({kinds})?\s*({NUMBER}|A)(?![\w.]*\w)",
                                flat[at:])
                if not part:
                    break
                kind = (part[1] or kind).rstrip("s")
                if (kind, part[2]) not in self.report.places:
                    self.say(file, text, at + part.start(2),
                             f"docs/report.md has no {kind} {part[2]}")
                at += part.end()

    def check_messages(self, file, text, flat):
        for offset, number in self.board_numbers(flat):
            if number not in self.messages:
                self.say(file, text, offset, f"no book has BBS {number}")

    def check_guides(self, file, text, flat):
        for offset, guide, section in self.guide_sections(flat):
            if guide == "MI" and file.parent == self.root / MODELS:
                guide = GUIDE_OF_MODEL.get(file.name, guide)
            if not any(name == guide and (number + ".").startswith(section + ".")
                       for name, number in self.sections):
                self.say(file, text, offset, f"no book has {guide} {section}")

    def check_marks(self, file, text, flat):
        for found in re.finditer(rf"(?<![\w-])([A-Z][A-Z0-9]+) (\d+\.{NUMBER})(?![\w.]*\w)", flat):
            if found[1] not in self.marks | VERSIONED:
                self.say(file, text, found.start(), f"docs/openr/sources.md does not explain {found[1]}")
        if file.parent == self.root / MODELS and file.suffix == ".json":
            for found in re.finditer(rf"\bSEED ({NUMBER})", text):
                if not {("table", found[1]), ("section", found[1])} & self.report.places:
                    self.say(file, text, found.start(), f"docs/report.md has no table or section {found[1]}")
            sources = re.search(r'"sources": \{([^}]*)\}', text)
            for found in re.finditer(r'"([^"]+)":', sources[1] if sources else ""):
                if found[1] not in self.marks:
                    self.say(file, text, sources.start(1) + found.start(),
                             f"docs/openr/sources.md does not explain {found[1]}")

    def check_paths(self, file, text):
        for found in re.finditer(r"(?<![\w/.(-])((?:\.\./)*(?:[\w-]+/)+[\w-]+\.md)\b", text):
            if not (self.root / found[1]).is_file() and not (file.parent / found[1]).is_file():
                self.say(file, text, found.start(), f"there is no {found[1]}")

    def check_links(self, file, text):
        for found in re.finditer(r"\[[^\[\]]+\]\(([^()\s#]*)(#[^()\s]*)?\)", text):
            if re.match(r"\w+:", found[1]):
                continue
            target = (file.parent / found[1]).resolve() if found[1] else file
            if not target.exists():
                self.say(file, text, found.start(), f"there is no {found[1]}")
            elif found[2] and target.suffix == ".md":
                if found[2][1:] not in self.page(target).headings.values():
                    self.say(file, text, found.start(), f"{found[1]} has no {found[2]}")

    def check_contents(self):
        """Checks that docs/openr/README.md names every book and links to every section."""
        file = self.root / "docs/openr/README.md"
        if not file.exists():
            self.problems.append("docs/openr/README.md: missing")
            return
        text = file.read_text()
        for name, book in self.books.items():
            for title in book.titles:
                if f"]({name}.md#{anchor(title)})" not in text:
                    self.problems.append(f"docs/openr/README.md: no link to {name}.md, '{title}'")

    def files(self):
        for folder in FOLDERS:
            for path, folders, names in os.walk(self.root / folder):
                # The packages of npm, which are installed in panel/, are not ours.
                folders[:] = sorted(set(folders) - {"node_modules"})
                for file in (Path(path, name) for name in sorted(names)):
                    is_read = file.suffix in SUFFIXES or folder == ".ci"
                    if is_read and file.is_file() and not file.is_symlink():
                        yield file
        yield from sorted([*self.root.glob("*.md"), *self.root.glob("dev")])

    def run(self):
        for file in self.files():
            text = file.read_text(errors="replace")
            flat = joined(text)
            self.check_books(file, text, flat)
            self.check_report(file, text, flat)
            self.check_messages(file, text, flat)
            self.check_guides(file, text, flat)
            if file.suffix != ".md":
                self.check_marks(file, text, flat)
            self.check_paths(file, text)
            if file.suffix == ".md":
                self.check_links(file, text)
        self.check_contents()
        return self.problems


def main():
    root = Path(sys.argv[1]).resolve() if sys.argv[1:] else Path(__file__).resolve().parent.parent
    problems = Checker(root).run()
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
