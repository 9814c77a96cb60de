#!/usr/bin/env python3
"""tools/docs_site: the pages it makes of documents, and the faults it finds.  Last line: "N passed, N failed".

A small site is built where MkDocs is installed; `.ci/nightly` builds the whole one.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools/docs_site")]
import links  # noqa: E402
from build import navigation  # noqa: E402
from slug import slug  # noqa: E402
from stage import Stage, lines_for_mkdocs  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

PAGES = [
    ("good links", {"a.html": '<a href="b.html#x">b</a>', "b.html": '<p id="x">'}, ""),
    ("no page", {"a.html": '<a href="b.html">b</a>'}, "a.html: there is no b.html"),
    ("no anchor", {"a.html": '<a href="b.html#y">b</a>', "b.html": '<p id="x">'}, "a.html: b.html has no #y"),
    ("no anchor here", {"a.html": '<a href="#y">b</a>'}, "a.html: a.html has no #y"),
    ("a link elsewhere is no request", {"a.html": '<a href="https://example.org/">b</a>'}, ""),
    ("a script from elsewhere", {"a.html": '<script src="https://example.org/a.js"></script>'}, "fetches https"),
    ("a font from elsewhere", {"a.html": '<link rel="stylesheet" href="//example.org/a.css">'}, "fetches //"),
    ("a picture from elsewhere", {"a.html": '<img src="http://example.org/a.png">'}, "fetches http"),
    ("a picture within the page", {"a.html": '<img src="data:image/png;base64,AA">'}, ""),
]

FENCES = [
    ("```cpp file=A.cc", '```cpp title="A.cc"'),
    ("```cpp from=a/A.cc", '```cpp title="a/A.cc"'),
    ("```sh status=1", "```sh"),
    ("```sh robot needs the dog", "```sh"),
    ("```output", "```{ .text .prints }"),
    ("```python", "```python"),
]

TREE = {
    "README.md": "# Home\n\n[a](docs/" "a.md) [source](src/x.cc) [folder](src) [lost](src/y.cc)\n",
    "docs/" "a.md": "# A\n\n[up](../README.md) [hidden](../.ci/run) [out](http://x.y/)\n\n```text\n[no](../src/x.cc)\n```\n",
    "docs/openr/README.md": "# Books\n", "docs/cookbook/README.md": "# Cookbook\n",
    "docs/cookbook/" "09-first-joint.md": "# Why?\n", "examples/README.md": "# Examples\n",
    "src/x.cc": "int x;\n", ".ci/run": "true\n", "tools/docs_site/site.css": "",
}


def write(folder, files):
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def check_stage(folder):
    write(folder / "tree", TREE)
    stage = Stage(folder / "tree", folder / "pages")
    stage.fill()
    home, page = ((folder / "pages" / name).read_text() for name in ("README.md", "docs/" "a.md"))
    verdict("links to sources lead to pages", "(src/x.cc.md)" in home and "(src/files.md)" in home, home)
    verdict("a lost link stays, for MkDocs to refuse", "(src/y.cc)" in home, home)
    verdict("hidden files are shown", "(../ci/run.md)" in page and (folder / "pages/ci" / "run.md").exists(), page)
    verdict("code is left alone", "[no](../src/x.cc)" in page, page)
    verdict("a source is a page", "int x;" in (folder / "pages/src/x.cc.md").read_text())
    tree = navigation(stage.pages)
    named = str(tree)
    verdict("every page is in the navigation once",
            all(named.count(f"'{page}'") == 1 for page in stage.pages), named)
    verdict("pages of the cookbook have short names", "{'9 First joint': 'docs/cookbook/09-" in named,
            named)


def check_folder(folder):
    """MkDocs would remove the files of the folder for the site; here a program that only says so is in its place."""
    (folder / "bin").mkdir()
    (folder / "bin/mkdocs").write_text("#!/bin/sh\necho ERROR removed\nexit 1\n")
    (folder / "bin/mkdocs").chmod(0o755)
    path = f"{folder}/bin:{os.environ['PATH']}"
    write(folder / "mine", {"letter.txt": "Dear"})
    status, said = built(folder, "mine", path)
    verdict("a folder with files of a person is refused", status == 1 and "mine has files" in said, said)
    (folder / "empty").mkdir()
    for time in ("first", "second"):
        status, said = built(folder, "empty", path)
        verdict(f"an empty folder, and one that was begun before, is taken: {time}", "removed" in said, said)
        write(folder / "empty", {"index.html": ""})


def built(folder, site, path=os.environ["PATH"]):
    done = subprocess.run([sys.executable, str(ROOT / "tools/docs_site/build.py"), "-o", str(folder / site),
                           "--root", str(folder / "tree")], capture_output=True, text=True,
                          env={**os.environ, "PATH": path})
    return done.returncode, done.stdout + done.stderr


def check_site(folder):
    if not shutil.which("mkdocs"):
        print("mkdocs is not installed: no site is built")
        return
    status, said = built(folder, "bad")
    verdict("a lost link fails the build", status == 1 and "src/y.cc" in said, said)
    home = folder / "tree" / "README.md"
    home.write_text(home.read_text().replace("src/y.cc", "docs/" "a.md#b"))
    status, said = built(folder, "bad")
    verdict("a lost anchor fails the build", status == 1 and "docs/a.html has no #b" in said, said)
    home.write_text(home.read_text().replace("#b", "#a"))
    status, said = built(folder, "site")
    verdict("a site without faults", status == 0 and (folder / "site/docs/a.html").exists(), said)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number, (title, files, words) in enumerate(PAGES):
            write(folder / str(number), files)
            said = "\n".join(links.faults(folder / str(number)))
            verdict(title, words in said and bool(words) == bool(said), said)
        for line, expected in FENCES:
            verdict(line, lines_for_mkdocs(line + "\n```")[0] == expected, lines_for_mkdocs(line + "\n```")[0])
        verdict("a list after a line", lines_for_mkdocs("text\n- a\n- b") == ["text", "", "- a", "- b"])
        verdict("a table after a line", lines_for_mkdocs("text\n| a |") == ["text", "", "| a |"])
        verdict("anchors", slug("1.2 Class `OObject` <OPENR/OObject.h>", "-") == "12-class-oobject-openroobjecth")
        check_stage(folder)
        check_folder(folder)
        check_site(folder)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
