#!/usr/bin/env python3
"""Builds the site of the documents with MkDocs: build.py [-o FOLDER]; `./dev docs` calls it.

Nothing is fetched from the network, neither while it is built nor by the pages.  A broken link or
anchor, and a page that would fetch something from elsewhere, are errors: exit status 1.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import links
from stage import Stage

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
# Sections of the site and their pages, below docs/ and without .md; those that do not exist are left out, and
# documents that no section names are in the reference.
SECTIONS = [
    ("First ten minutes", ["guide/first-ten-minutes", "installing"]),
    ("How OPEN-R works", ["guide/how-openr-works", "architecture", "panel"]),
    ("Cookbook", ["cookbook/README", "cookbook/[0-9]*"]),
    ("Porting", ["guide/porting", "host-kit", "robot-build", "limits", "endings", "conformance"]),
    ("Teachers", ["guide/teachers", "testing", "controllers", "python", "worlds"]),
]


def label(page):
    """Returns the entry of a page: short for the cookbook, else MkDocs takes the title of the page."""
    found = re.fullmatch(r"docs/cookbook/0*(\d+)-(.+)\.md", str(page))
    if found:
        return {f"{found[1]} {found[2].replace('-', ' ').capitalize()}": str(page)}
    return str(page)


def navigation(pages):
    """Returns the tree of the navigation; each page is in it once."""
    left = sorted(pages)
    tree = []

    def take(pattern):
        hits = [page for page in left if page.match(pattern) and len(page.parts) == len(pathlib.Path(pattern).parts)]
        for page in hits:
            left.remove(page)
        return [label(page) for page in hits]

    tree.append({"Home": take("README.md")[0]})
    for title, patterns in SECTIONS:
        entries = [entry for pattern in patterns for entry in take(f"docs/{pattern}.md")]
        if entries:
            tree.append({title: entries})
    examples = take("examples/README.md") + take("examples/*/README.md") + take("examples/*/*/README.md")
    rest = take("docs/guide/*.md") + take("docs/*.md")
    reference = [{"OPEN-R": take("docs/openr/README.md") + take("docs/openr/*.md")}, {"openr-host": rest},
                 {"Examples": examples}, {"Decisions": take("docs/decisions/*.md")},
                 {"Project": [label(page) for page in left]}]
    tree.append({"Reference": [group for group in reference if all(group.values())]})
    return tree


def configured(pages, site, stage):
    """Returns the text of mkdocs.yml: JSON is YAML."""
    text = (HERE / "mkdocs.yml").read_text()
    return text + "".join(f"{key}: {json.dumps(value)}\n" for key, value in
                          (("docs_dir", str(pages)), ("site_dir", str(site)), ("nav", navigation(stage.pages))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", default=ROOT / "build/site", type=pathlib.Path)
    parser.add_argument("--root", default=ROOT, type=pathlib.Path, help="of the checkout whose documents these are")
    arguments = parser.parse_args()
    site = arguments.o.resolve()
    if not shutil.which("mkdocs"):
        sys.exit("docs: mkdocs is missing; its packages are in cmake/debian-packages-docs.txt")
    work = site.with_name(site.name + ".pages")
    pages = work / "pages"
    config = work / "mkdocs.yml"
    if not config.exists() and site.is_dir() and any(site.iterdir()):  # MkDocs would remove what is in it
        sys.exit(f"docs: {site} has files that are not of a site of this program; name a folder that is empty or new")
    stage = Stage(arguments.root.resolve(), pages)
    stage.fill()
    config.write_text(configured(pages, site, stage))
    done = subprocess.run(["mkdocs", "build", "--strict", "--clean", "-f", str(config)], check=False,
                          env={**os.environ, "PYTHONPATH": str(HERE), "PYTHONDONTWRITEBYTECODE": "1"},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        complaints = [line for line in done.stdout.splitlines() if re.search("WARNING|ERROR|Error", line)]
        print("\n".join(complaints or [done.stdout]))
        return 1
    (site / "404.html").unlink(missing_ok=True)  # for servers of a whole host, whose root this site is not
    faults = links.faults(site)
    print("\n".join(faults) if faults else f"{site / 'index.html'}: {len(stage.pages)} pages, "
          f"{len(stage.sources)} files of the checkout that they name")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
