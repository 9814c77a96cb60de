#!/usr/bin/env python3
"""tools/citations.py: which wrong citations it finds, and that it is silent about right ones.  The
last line is "N passed, N failed"."""
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
TOOL = ROOT / "tools/citations.py"
BOOK = "core" + ".md"

TREE = {
    "docs/openr/core.md": """# Core

## 1. Life

### 1.1 Facts

1. One (BOARD 5, 7-9; Guide 2.1.3 and 2.4; Guide 3; Guide-7 1.2).
2. Two.

### Of queues

3. Three.

```text
4. No item.
## 9. No section
```

## 11. Questions

| # | Question |
|---|---|
| 5 | what |

## 12. Notes

4. Four.
""",
    "docs/openr/sources.md": "# Sources\n\n## Marks of sources\n\n| Mark | Source |\n|---|---|\n"
                             "| Guide n | a |\n| BOARD n | b |\n\n### Marks of models\n\n| Mark | Source |\n"
                             "|---|---|\n| Seed n | c |\n| TK, TK:x | d |\n\n## Words\n\n| Word | d |\n|---|---|\n"
                             "| ANT | e |\n",
    "docs/openr/README.md": "# Contents\n\n- [1](core.md#1-life)\n- [11](core.md#11-questions)\n"
                            "- [12](core.md#12-notes) [a](sources.md#marks-of-sources) [b](sources.md#words)\n",
    "docs/report.md": "# Report\n\n## Chapter 3: Simulation\n\n### 3.1.2 Primitives\n\n| Part | Here |\n|---|---|\n"
                      "| Table 3.1, blocks | a |\n| Figure 3.3, Figure 3.4 | b |\n\n## Appendix A: format\n",
    "docs/body.md": "# Body\n\n## What it is, and `why`\n",
}

RIGHT = [
    "Book", "Book 1", "Book 1.1", "Book, 1.1", "Book, section 1.1", "Book sections 1 and 11", "Book 1.1 2",
    "Book 1.1 3", "Book 11 5", "Book 11.5", "Book 12.4", "Book 1.1 1, 11 5", "Book 1.1, step 2",
    "Book 1.1 1 to 1.1 3", "Book 1.1), so 13 things", "Book 1.1; another 99", "Book 1.1, \"Of queues\"",
    "DOCS:openr/Book 1.1", "DOCS:body.md", "Hohl 2004", "Hohl 2004, section 3.1.2", "Hohl 2004, 3.1.2",
    "Hohl 2004, chapter 3", "Hohl 2004, table 3.1 and figure 3.4", "Hohl 2004, appendix A",
    "Hohl 2004 (18 servos)", "BOARD 5, 8", "BOARD 7", "on the BOARD",
    "Guide 2.1.3", "Guide 2.4", "Guide 3", "Guide 2, 2.1", "Guide-7 1.2", "the Guide", "L" "2 cache",
    "TK 2.5", "SD" "K 1.1.5", "ERS-210 1.2", "x-ray A1-X 2.5", "LED3",
]

WRONG = [
    ("Book 2", f"{BOOK} has no 2"),
    ("Book 1.1 4", f"{BOOK} has no 1.1 4"),
    ("Book 1.2", f"{BOOK} has no 1.2"),
    ("Book 9", f"{BOOK} has no 9"),
    ("Book 1.1, 1.9", f"{BOOK} has no 1.9"),
    ("Book, sections 1 and 99", f"{BOOK} has no 99"),
    ("Book 11 6", f"{BOOK} has no 11 6"),
    ("Book 1.1, step 7", f"{BOOK} 1.1 has no step 7"),
    ("Book 1.1,\n// 77", f"{BOOK} has no 77"),
    ("Book\n// 77", f"{BOOK} has no 77"),
    ("Book:14", f"{BOOK} by line"),
    ("Book, lines 3 to 4", f"{BOOK} by line"),
    ("Book, \"Of stacks\"", f'{BOOK} does not say "Of stacks"'),
    ("DOCS:openr/Book 2", f"{BOOK} has no 2"),
    ("DOCS:bodies.md", "there is no DOCS:bodies.md"),
    ("Hohl " "2004, section 3.1.9", "docs/report.md has no section 3.1.9"),
    ("Hohl " "2004, 3.1.2 and 3.7", "docs/report.md has no section 3.7"),
    ("(Hohl\n// " "2004, table 3.9)", "docs/report.md has no table 3.9"),
    ("Hohl " "2004, figure 3.1", "docs/report.md has no figure 3.1"),
    ("BOARD 6", "no book has BOARD 6"),
    ("BOARD 5, 10", "no book has BOARD 10"),
    ("Guide 2.2", "no book has Guide 2.2"),
    ("Guide 2.1.3.1", "no book has Guide 2.1.3.1"),
    ("Guide 1.2", "no book has Guide 1.2"),
    ("Guide-7 2.4", "no book has Guide-7 2.4"),
    ("Guide 2.4, 2.1.4", "no book has Guide 2.1.4"),
    ("P" "G A", "no book has P" "G A"),
    ("a\n// OLDER" " 3.7", "docs/openr/sources.md does not explain OLDER"),
    ("AN" "T 3.7", "docs/openr/sources.md does not explain AN" "T"),
]

# Lines of the file of a model, and the complaint; "" if it is right.
MODELS = [
    ("a.json", '"sources": {"Guide": "a", "Seed": "b"}, "source": "Guide 2.1, Seed 3.1"', ""),
    ("a.json", '"sources": {"Guide": "a",\n "NEW": "b"}', "a.json:2: docs/openr/sources.md does not explain NEW"),
    ("a.json", '"source": "NE' 'W 3.1"', "does not explain NEW"),
    ("a.json", '"source": "Guide 1.2"', "no book has Guide 1.2"),
    ("ers7.json", '"source": "Guide 1.2"', ""),
    ("ers7.json", '"source": "Guide 2.4"', "no book has Guide-7 2.4"),
    ("a.json", '"source": "Seed 3.1, Seed 3.1.2"', ""),
    ("a.json", '"source": "Seed 3.9"', "docs/report.md has no table or section 3.9"),
]

MARKDOWN = [
    ("[a](body.md) [b](body.md#what-it-is-and-why) [c](http://x.y/z.md) [d](#here)\n\n# Here\n", ""),
    ("[a](bodies.md)", "there is no bodies.md"),
    ("[a](body.md#where)", "body.md has no #where"),
    ("[a](#there)", "has no #there"),
]

def whole(text):
    """The text with the names that this file must not have, because the tool reads it, too."""
    for name, mark in {"Book": BOOK, "BOARD": "BBS", "Guide": "MI", "Seed": "SE" "ED", "DOCS:": "docs/"}.items():
        text = text.replace(name, mark)
    return text


def say(more, below=""):
    """Status of the tool, and what it prints, for the tree and some more files.

    `below` is the name of a folder around the tree.
    """
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / below
        for name, text in {**TREE, **more}.items():
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(whole(text))
        done = subprocess.run([sys.executable, str(TOOL), folder], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def comment(citation):
    return "int a;\n// As " + citation + "\nint b;\n"


def main():
    status, said = say({})
    verdict("nothing is cited", (status, said) == (0, ""), said)
    for citation in RIGHT:
        status, said = say({"runtime/a.cc": comment(citation)})
        verdict(citation, (status, said) == (0, ""), said)
    for citation, words in WRONG:
        status, said = say({"tests/a.h": comment(citation)})
        good = status == 1 and said.startswith("tests/a.h:") and whole(words) in said
        verdict(citation, good, said)
    for name, text, words in MODELS:
        status, said = say({f"virtualrobot/model/{name}": text + "\n"})
        verdict(f"{name}: {text}", status == (1 if words else 0) and whole(words) in said, said)
    for name in ("cli/a.h", "kit/a.h", "python/a.h", "panel/src/a.ts", "panel/test/a.mjs", ".ci/run", "dev"):
        status, said = say({name: comment("Book 9")})
        verdict(f"{name} is read", status == 1 and f"{name}:" in said, said)
    status, said = say({"runtime/a": comment("Book 9")})
    verdict("other files without a suffix are not", (status, said) == (0, ""), said)
    status, said = say({"panel/" "node_modules/" "a.md": "[a](missing.md)\n"})
    verdict("packages of npm are not read", (status, said) == (0, ""), said)
    status, said = say({"cli/a.h": comment("Book 9")}, below="node_modules")
    verdict("a checkout below a folder of that name is read", status == 1 and "cli/a.h:" in said, said)
    status, said = say({"tools/a.py": "# one\n\n# " + BOOK + " 1.1 and\n# 99\n"})
    verdict("the line is that of the number", said == f"tools/a.py:4: {BOOK} has no 99\n", said)
    for text, words in MARKDOWN:
        status, said = say({"docs/" "a.md": text})
        verdict(text, status == (1 if words else 0) and words in said, said)
    status, said = say({"docs/openr/README.md": "# Contents\n"})
    verdict("the contents are complete", "README.md: no link to core.md, '11. Questions'" in said, said)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
