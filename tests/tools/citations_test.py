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

1. One (BOARD 5, 7-9).
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
    "docs/openr/README.md": "# Contents\n\n- [1](core.md#1-life)\n- [11](core.md#11-questions)\n"
                            "- [12](core.md#12-notes)\n",
    "docs/report.md": "# Report\n\n## Chapter 3: Simulation\n\n### 3.1.2 Primitives\n\n| Part | Here |\n|---|---|\n"
                      "| Table 3.1, blocks | a |\n| Figure 3.3, Figure 3.4 | b |\n\n## Appendix A: format\n",
    "docs/body.md": "# Body\n\n## What it is, and `why`\n",
}

RIGHT = [
    "BOOK", "BOOK 1", "BOOK 1.1", "BOOK, 1.1", "BOOK, section 1.1", "BOOK sections 1 and 11", "BOOK 1.1 2",
    "BOOK 1.1 3", "BOOK 11 5", "BOOK 11.5", "BOOK 12.4", "BOOK 1.1 1, 11 5", "BOOK 1.1, step 2",
    "BOOK 1.1 1 to 1.1 3", "BOOK 1.1), so 13 things", "BOOK 1.1; another 99", "BOOK 1.1, \"Of queues\"",
    "DOCS:openr/BOOK 1.1", "DOCS:body.md", "Hohl 2004", "Hohl 2004, section 3.1.2", "Hohl 2004, 3.1.2",
    "Hohl 2004, chapter 3", "Hohl 2004, table 3.1 and figure 3.4", "Hohl 2004, appendix A",
    "Hohl 2004 (18 servos)", "BOARD 5, 8", "BOARD 7", "on the BOARD",
]

WRONG = [
    ("BOOK 2", f"{BOOK} has no 2"),
    ("BOOK 1.1 4", f"{BOOK} has no 1.1 4"),
    ("BOOK 1.2", f"{BOOK} has no 1.2"),
    ("BOOK 9", f"{BOOK} has no 9"),
    ("BOOK 1.1, 1.9", f"{BOOK} has no 1.9"),
    ("BOOK, sections 1 and 99", f"{BOOK} has no 99"),
    ("BOOK 11 6", f"{BOOK} has no 11 6"),
    ("BOOK 1.1, step 7", f"{BOOK} 1.1 has no step 7"),
    ("BOOK 1.1,\n// 77", f"{BOOK} has no 77"),
    ("BOOK\n// 77", f"{BOOK} has no 77"),
    ("BOOK:14", f"{BOOK} by line"),
    ("BOOK, lines 3 to 4", f"{BOOK} by line"),
    ("BOOK, \"Of stacks\"", f'{BOOK} does not say "Of stacks"'),
    ("DOCS:openr/BOOK 2", f"{BOOK} has no 2"),
    ("DOCS:bodies.md", "there is no DOCS:bodies.md"),
    ("Hohl " "2004, section 3.1.9", "docs/report.md has no section 3.1.9"),
    ("Hohl " "2004, 3.1.2 and 3.7", "docs/report.md has no section 3.7"),
    ("(Hohl\n// " "2004, table 3.9)", "docs/report.md has no table 3.9"),
    ("Hohl " "2004, figure 3.1", "docs/report.md has no figure 3.1"),
    ("BOARD 6", "no book has BOARD 6"),
    ("BOARD 5, 10", "no book has BOARD 10"),
]

MARKDOWN = [
    ("[a](body.md) [b](body.md#what-it-is-and-why) [c](http://x.y/z.md) [d](#here)\n\n# Here\n", ""),
    ("[a](bodies.md)", "there is no bodies.md"),
    ("[a](body.md#where)", "body.md has no #where"),
    ("[a](#there)", "has no #there"),
]

def whole(text):
    """The text with the names that this file must not have, because the tool reads it, too."""
    return text.replace("BOOK", BOOK).replace("BOARD", "BBS").replace("DOCS:", "docs/")


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
    for folder in ("cli", "kit", "panel", "python"):
        status, said = say({f"{folder}/a.h": comment("BOOK 9")})
        verdict(f"{folder} is read", status == 1 and f"{folder}/a.h:" in said, said)
    status, said = say({"panel/" "node_modules/" "a.md": "[a](missing.md)\n"})
    verdict("packages of npm are not read", (status, said) == (0, ""), said)
    status, said = say({"cli/a.h": comment("BOOK 9")}, below="node_modules")
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
