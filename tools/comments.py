#!/usr/bin/env python3
"""Checks that no comment begins with a word that refers to something only the code names.

    tools/comments.py [FOLDER]     prints FILE:LINE: COMMENT for each one that does

FOLDER is a checkout; without FOLDER, this checkout is read.  The words are those of CONTRIBUTING.md: who,
whose, what, which, that, those, of, one, there, it.  Comments of C, C++ and TypeScript (// and /* */),
Python, shell and CMake (#) are read, also those behind code, and docstrings of Python.  A line that
continues a comment may begin with any word: the comment above it must begin in the same column.
"""
import ast
import io
import os
import re
import sys
import tokenize
from pathlib import Path

FOLDERS = (".ci", "bench", "cli", "cmake", "distribution", "examples", "kit", "objects", "openr", "panel", "python",
           "runtime", "stub.cfg", "testing", "tests", "tools", "virtualrobot")
# Copies of old programs, on which the kit is tested, and a file that a program makes.
LEFT_OUT = ("tests/kit/fixtures/", "python/openr_host/_commands.py")
WORDS = re.compile(r"(who|whose|what|which|that|those|of|one|there|it)(?![\w:])", re.IGNORECASE)

C_PARTS = re.compile(r"""
    (?P<raw>R"(?P<mark>[^\s()\\]{0,16})\((?:.|\n)*?\)(?P=mark)")
  | (?P<text>"(?:\\(?:.|\n)|[^"\\\n])*" | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+' | `(?:\\(?:.|\n)|[^`\\])*`)
  | (?P<comment>//(?:\\\n|[^\n])* | /\*(?:.|\n)*?\*/)
""", re.VERBOSE)
# Where a shell's '#' begins no comment: in quotes, behind a backslash, within a word or ${...}.
SHELL_PARTS = re.compile(r"""
    (?P<here><<-?\s*(?P<quote>['"\\]?)(?P<mark>\w+)(?P=quote)?(?P<rest>[^\n]*)\n(?:.*\n)*?\t*(?P=mark)(?=\n|$))
  | (?P<text>'[^']*' | "(?:\\(?:.|\n)|[^"\\])*" | \\. | \$\{[^}]*\})
  | (?P<comment>(?<![^\s;&|()])\#[^\n]*)
""", re.VERBOSE)
CMAKE_PARTS = re.compile(r"""
    (?P<text>\[(?P<mark>=*)\[(?:.|\n)*?\](?P=mark)\] | "(?:\\(?:.|\n)|[^"\\])*" | \\.)
  | (?P<comment>\#[^\n]*)
""", re.VERBOSE)


def found_by(parts, text):
    """Yields (offset, comment) for each comment; `parts` matches comments, and text that looks like them."""
    for part in parts.finditer(text):
        if part["comment"]:
            yield part.start(), part["comment"]


def found_by_python(text):
    """Yields (offset, text) for each comment and for each docstring, which has no quotes in the text."""
    begins = [0]
    for line in text.splitlines(keepends=True):
        begins.append(begins[-1] + len(line))
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield begins[token.start[0] - 1] + token.start[1], token.string
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node):
            yield begins[node.body[0].lineno - 1] + node.body[0].col_offset, ast.get_docstring(node)


def comments_of(name, text):
    """Returns the comments of a file as (offset, text); none of a file of another language."""
    suffix = Path(name).suffix
    if suffix in (".c", ".cc", ".h", ".idl", ".ts", ".mjs"):
        return list(found_by(C_PARTS, text))
    if suffix == ".py":
        return list(found_by_python(text))
    if suffix == ".cmake" or name.endswith("CMakeLists.txt"):
        return list(found_by(CMAKE_PARTS, text))
    if suffix == ".sh" or text.startswith(("#!/bin/sh", "#!/usr/bin/env bash", "#!/bin/bash")):
        return list(found_by(SHELL_PARTS, text))
    return []


def offences(name, text):
    """Yields a line for each comment of the file that begins with one of WORDS."""
    ends = {}  # the end of a comment -> the column in which it begins
    for offset, comment in comments_of(name, text):
        if comment.startswith("#!"):  # names the program that runs the script
            continue
        begin = text.rfind("\n", 0, offset) + 1
        column = offset - begin
        ends[offset + len(comment)] = column
        is_alone = not text[begin:offset].strip()
        if is_alone and ends.get(begin - 1) == column:
            continue
        words = comment.lstrip("/*#!<").lstrip()
        if WORDS.match(words):
            yield f"{name}:{text.count(chr(10), 0, offset) + 1}: {comment.splitlines()[0]}"


def files(root):
    yield from (path for path in [root / "dev"] if path.is_file())
    for folder in FOLDERS:
        for path, folders, names in os.walk(root / folder):
            folders[:] = sorted(set(folders) - {"node_modules", "__pycache__"})
            yield from (Path(path, name) for name in sorted(names))


def main():
    root = Path(sys.argv[1]).resolve() if sys.argv[1:] else Path(__file__).resolve().parent.parent
    found = []
    for file in files(root):
        name = file.relative_to(root).as_posix()
        if not name.startswith(LEFT_OUT) and not file.is_symlink():
            found += offences(name, file.read_text(errors="replace"))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
