#!/usr/bin/env python3
"""Writes what is made of the description of the commands of openr serve (openr/serve/command_table.cc).

    tools/python_commands.py --program build/release/bin/openr [--check]

It writes python/openr_host/_commands.py, which has a typed method for each command, and the table
in docs/python.md.  With --check it writes nothing and fails if one of them is out of date.
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODULE = ROOT / "python/openr_host/_commands.py"
PAGE = ROOT / "docs/python.md"
BEGIN, END = "<!-- commands: made by tools/python_commands.py -->", "<!-- end of commands -->"
TYPES = {"text": "str", "number": "float", "integer": "int", "flag": "bool", "texts": "Sequence[str]"}

HEAD = '''"""The commands of openr serve, a method for each.

Made by tools/python_commands.py of openr/serve/command_table.cc.  Do not change it by hand.
"""
from __future__ import annotations

import json
from typing import Any, Sequence

from ._channel import Channel

Answer = tuple[dict[str, Any], bytes]


class Commands:
    """Asks the process of a run.  Each method returns the members of the answer and its further bytes."""

    def __init__(self, channel: Channel) -> None:
        self.channel = channel

    def ask(self, name: str, parameters: dict[str, Any], data: bytes = b"") -> Answer:
        return self.channel.ask(json.dumps({"do": name, **parameters}).encode(), data)
'''


def literal(value):
    return repr(tuple(value)) if isinstance(value, list) else repr(value)


def wrapped(text, indent, width=100):
    """Returns `text` in lines that begin with `indent`."""
    lines, line = [], indent
    for word in text.split():
        if len(line) + len(word) + 1 > width and line.strip():
            lines.append(line)
            line = indent
        line += ("" if line == indent else " ") + word
    return "\n".join(lines + [line])


def method(command):
    """Returns the text of the Python method for a command."""
    parameters = []
    for each in command["parameters"]:
        otherwise = f" = {literal(each['otherwise'])}" if "otherwise" in each else ""
        parameters.append(f"{each['name']}: {TYPES[each['type']]}{otherwise}")
    if command["takes"]:
        parameters.append("data: bytes = b\"\"")
    head = f"    def {command['name']}(self"
    head += (", *, " + ", ".join(parameters) if parameters else "") + ") -> Answer:"
    if len(head) > 100:
        head = f"    def {command['name']}(\n            self, *,\n"
        head += "".join(f"            {each},\n" for each in parameters)
        head += "    ) -> Answer:"
    doc = [wrapped(command["help"], "        ")]
    doc[0] = '        """' + doc[0].lstrip()
    if command["takes"]:
        doc.append(wrapped(f"data: {command['takes']}", "        "))
    for each in command["parameters"]:
        doc.append(wrapped(f"{each['name']}: {each['help']}.", "        "))
    doc.append(wrapped(f"Answers {command['answer']}.", "        "))
    if len(doc) > 1:
        doc.insert(1, "")
    doc.append('        """')
    values = ", ".join(
        f'"{each["name"]}": ' + (f"list({each['name']})" if each["type"] == "texts" else each["name"])
        for each in command["parameters"])
    data = ", data" if command["takes"] else ""
    call = f'        return self.ask("{command["name"]}", {{{values}}}{data})'
    if len(call) > 100:
        call = f'        return self.ask("{command["name"]}", {{\n'
        for each in command["parameters"]:
            value = f"list({each['name']})" if each["type"] == "texts" else each["name"]
            call += f'            "{each["name"]}": {value},\n'
        call += f"        }}{data})"
    return "\n".join(["", head, *doc, call, ""])


def module(commands):
    return HEAD + "".join(method(each) for each in commands if each["name"] != "fork")


def table(commands):
    """Returns the lines of the table of docs/python.md."""
    lines = ["| command | does | parameters (with the value when left out) | answers |", "|---|---|---|---|"]
    for each in commands:
        parameters = []
        for one in each["parameters"]:
            otherwise = f" = `{json.dumps(one['otherwise'])}`" if "otherwise" in one else ""
            parameters.append(f"`{one['name']}`{otherwise}: {one['help']}")
        if each["takes"]:
            parameters.append(f"bytes: {each['takes']}")
        cells = [f"`{each['name']}`", each["help"], "<br>".join(parameters), each["answer"]]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def page(commands, old):
    """Returns docs/python.md with the present table."""
    before, rest = old.split(BEGIN)
    return before + BEGIN + "\n" + table(commands) + "\n" + END + rest.split(END)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    described = subprocess.run([arguments.program, "serve", "--describe"], check=True,
                               stdout=subprocess.PIPE).stdout
    commands = json.loads(described)["commands"]
    wanted = {MODULE: module(commands)}
    if PAGE.exists():
        wanted[PAGE] = page(commands, PAGE.read_text())
    stale = [path for path, text in wanted.items() if not path.exists() or path.read_text() != text]
    if arguments.check:
        for path in stale:
            print(f"{path.relative_to(ROOT)} is out of date: tools/python_commands.py --program "
                  f"{arguments.program}")
        return 1 if stale else 0
    for path in stale:
        path.write_text(wanted[path])
    return 0


if __name__ == "__main__":
    sys.exit(main())
