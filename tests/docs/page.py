"""Reads a page of docs/cookbook or docs/guide into its fenced blocks.

What a block is stands behind its opening fence:

    ```sh                     commands, run by bash in the order of the page
    ```sh slow                the same, run with --slow only
    ```sh status=1            commands, the last of which ends with this status
    ```output                 lines that the commands before it print
    ```cpp file=Foo.cc        a listing, written to that file; any language
    ```cpp from=examples/A.cc a listing that stands in that file of the checkout, word for word
    ```sh robot REASON        for the robot only: not run
    ```cpp not-run REASON     not run

Everything else is a Fault, so nothing on a page is left out of the run unseen.
"""
import dataclasses
import re

FENCE = re.compile(r"^( *)(`{3,}|~{3,})(.*)$")
LIST = re.compile(r"^ *([-*+]|\d+[.)]) ")
KINDS = ("file", "from", "robot", "not-run")
MARK_AT_LEAST = 3  # letters of the reason of a block that is not run


class Fault(Exception):
    """A page that breaks the rules, with its line."""

    def __init__(self, line, text):
        super().__init__(text)
        self.line = line


@dataclasses.dataclass
class Block:
    """A fenced block: `line` is that of its opening fence, from 1."""

    line: int
    kind: str  # sh, output, file, from, left-out
    text: str
    name: str = ""    # file or from: the path
    status: int = 0   # sh: the expected exit status
    slow: bool = False


def described(line, info, text):
    """Returns the Block of an info string, or raises Fault."""
    words = info.split()
    if not words:
        raise Fault(line, "a fence without a word behind it: say sh, output, file=NAME, robot or not-run")
    language, marks = words[0], words[1:]
    if marks and marks[0] in ("robot", "not-run"):
        if len("".join(marks[1:])) < MARK_AT_LEAST:
            raise Fault(line, f"'{marks[0]}' needs a reason behind it")
        return Block(line, "left-out", text)
    if len(marks) == 1 and marks[0].startswith(("file=", "from=")):
        kind, name = marks[0].split("=", 1)
        if not name or name.startswith("/") or ".." in name.split("/"):
            raise Fault(line, f"'{marks[0]}' names no file below the folder of the page")
        return Block(line, kind, text, name=name)
    if language == "output" and not marks:
        return Block(line, "output", text)
    if language == "sh":
        return commands(line, marks, text)
    raise Fault(line, f"'{info.strip()}' is none of: sh, output, file=NAME, from=PATH, robot REASON, "
                "not-run REASON")


def commands(line, marks, text):
    block = Block(line, "sh", text)
    for mark in marks:
        if mark == "slow":
            block.slow = True
        elif re.fullmatch(r"status=\d+", mark):
            block.status = int(mark[len("status="):])
        else:
            raise Fault(line, f"'sh {mark}' is unknown: slow, status=N, robot REASON, not-run REASON")
    return block


def read_blocks(text):
    """Returns the blocks of a page; raises Fault."""
    blocks, opened, body = [], None, []
    in_list, after_blank = False, True
    for number, line in enumerate(text.splitlines(), 1):
        fence = FENCE.match(line)
        if opened:
            begin, indent, mark, info = opened
            if fence and fence[2].startswith(mark) and not fence[3].strip():
                blocks.append(described(begin, info, "".join(body)))
                opened, body = None, []
            else:
                body.append(line[min(indent, len(line) - len(line.lstrip(" "))):] + "\n")
            continue
        if fence:
            opened = number, len(fence[1]), fence[2], fence[3]
        elif LIST.match(line):
            in_list = True
        elif line.strip() and not line.startswith(" "):
            in_list = False
        elif after_blank and re.match(r" {4}|\t", line) and line.strip() and not in_list:
            raise Fault(number, "an indented block is not run: fence it")
        after_blank = not line.strip()
    if opened:
        raise Fault(opened[0], "the fence is never closed")
    for block, next_block in zip([None] + blocks, blocks):
        if next_block.kind == "output" and (block is None or block.kind != "sh"):
            raise Fault(next_block.line, "output without commands before it")
    return blocks


def missing_line(expected, printed):
    """Returns the first line of `expected` that `printed` lacks, or None.

    The lines come in this order, each next to the one before unless a line `...` is between them.
    `...` within a line stands for any text.
    """
    have = [line.rstrip() for line in printed.splitlines()]
    at = 0
    for group in groups(expected):
        patterns = [re.compile(".*".join(map(re.escape, line.split("...")))) for line in group]
        best = 0
        for begin in range(at, len(have)):
            count = 0
            while (count < len(patterns) and begin + count < len(have)
                   and patterns[count].fullmatch(have[begin + count])):
                count += 1
            best = max(best, count)
            if count == len(patterns):
                at = begin + count
                break
        else:
            return group[best]
    return None


def groups(expected):
    """Returns the runs of lines between lines that are `...`."""
    found = [[]]
    for line in expected.splitlines():
        if line.strip() == "...":
            found.append([])
        else:
            found[-1].append(line.rstrip())
    return [group for group in found if group]
