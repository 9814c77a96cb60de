#!/usr/bin/env python3
"""Writes the files that a page shows as fenced blocks whose first line is ```LANGUAGE NAME.

usage: extract_files.py PAGE FOLDER

Files that would not change are left alone, so that nothing is built again.
"""
import pathlib
import re
import sys

BLOCK = re.compile(r"^```\w+ (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in BLOCK.findall(page.read_text()):
        file = folder / name
        if not file.exists() or file.read_text() != text:
            file.write_text(text)


if __name__ == "__main__":
    main()
