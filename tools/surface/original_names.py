#!/usr/bin/env python3
"""The names of the robot's headers in original_names.tsv, as C++ that only compiles when they are there.

    original_names.py --sources FOLDER   writes one source per header: it includes that header and
                                         nothing else, and uses every name that has to come with it
    original_names.py --layouts FILE     writes the sizes and offsets as checks for tests/mips/abi
"""
import argparse
import collections
import re
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
Row = collections.namedtuple("Row", "kind name header facts where")

PREAMBLE = """
template <class Left, class Right> struct SameType;
template <class Type> struct SameType<Type, Type> { typedef Type Is; };
#define CHECK_JOIN(a, b) a##b
#define CHECK_NAME(line) CHECK_JOIN(Check, line)
#define CHECK(condition) \\
  typedef char CHECK_NAME(__LINE__)[(condition) ? 1 : -1] __attribute__((unused))
#define CHECK_TYPE(expression, type) \\
  typedef SameType<__typeof__(expression), type>::Is CHECK_NAME(__LINE__) __attribute__((unused))
"""


def table(name):
    for line in (FOLDER / name).read_text().splitlines():
        if line and not line.startswith("#"):
            yield line.split("\t")


def left_out():
    """Returns {name that our headers need not have: reason}."""
    return {name: reason for name, reason in table("left_out.tsv")}


def rows():
    """Yields the rows of the table whose names our headers must have, in order."""
    absent = left_out()
    for fields in table("original_names.tsv"):
        row = Row(*(fields + [""] * 5)[:5])
        if row.name not in absent:
            yield row


def members(row):
    """Returns the size of a type, and [(member, offset, type, is_array)] without base classes."""
    size, *fields = [field.strip() for field in row.facts.split(";")]
    found = []
    for field in fields:
        match = re.match(r"(\w+) @(\d+) (.*?)(\[\])?$", field)
        if match:
            found.append((match[1], int(match[2]), match[3].replace("enum ", "").strip(), bool(match[4])))
    return int(size.split()[0]), found


def base_of(row):
    match = re.search(r"base:(\w+) @0", row.facts)
    return match[1] if match else None


def type_checks(row):
    size, found = members(row)
    yield f"CHECK(sizeof({row.name}) == {size});"
    for member, offset, kind, is_array in found:
        yield f"CHECK(__builtin_offsetof({row.name}, {member}) == {offset});"
        if kind:
            element = f"(({row.name}*)0)->{member}" + ("[0]" if is_array else "")
            yield f"CHECK_TYPE({element}, {kind});"
    if base_of(row):
        yield f"{base_of(row)}* to_base({row.name}* derived) {{ return derived; }}"


def typedef_checks(row):
    kind, size = row.facts.rsplit(", ", 1)
    yield f"CHECK(sizeof({row.name}) == {int(size.split()[0])});"
    if kind.strip() != "enum" and not row.where:
        yield f"typedef SameType<{row.name}, {kind}>::Is CHECK_NAME(__LINE__) __attribute__((unused));"


def method_checks(row):
    """Yields a function for each overload, which calls the method with the robot's parameters."""
    owner, method = row.name.rsplit("::", 1)
    for form in row.facts.split(" | "):
        parameters, result = re.match(r"\((.*)\) -> (.*)$", form).groups()
        kinds = [kind.replace("enum ", "") for kind in parameters.split(", ") if kind]
        declared = [f"{kind} a{i}" for i, kind in enumerate(kinds)]
        values = ", ".join(f"a{i}" for i in range(len(kinds)))
        result = result.replace("enum ", "")
        if method == owner:
            body = f"{owner} made{'(' + values + ')' if kinds else ''}; (void)made;"
        else:
            declared.insert(0, f"{owner}& object")
            operator = re.match(r"operator(\W+)$", method)
            call = f"(object {operator[1]} a0)" if operator else f"object.{method}({values})"
            body = f"{call};" if result == "void" else f"{result} result = {call}; (void)result;"
        yield f"void form({', '.join(declared)}) {{ {body} }}"


def checks(row):
    if row.kind == "type":
        yield from type_checks(row)
    elif row.kind == "typedef":
        yield from typedef_checks(row)
    elif row.kind == "method":
        yield from method_checks(row)
    elif row.kind == "brings":
        yield f"void use() {{ {row.facts} }}"
    else:
        yield f"CHECK(static_cast<unsigned>({row.name}) == static_cast<unsigned>({row.facts}));"


def source_of(header, some_rows):
    """Returns a source that includes `header` and checks the rows."""
    lines = [f"#include <{header}>", PREAMBLE]
    for number, row in enumerate(some_rows):
        lines += [f"// {row.kind} {row.name}", f"namespace row{number} {{"]
        if row.where == "32":
            lines += ["#if __SIZEOF_POINTER__ == 4", *checks(row), "#else"]
            lines += [f"typedef {row.name} There;"] if row.kind in ("type", "typedef") else []
            lines += ["#endif"]
        else:
            lines += checks(row)
        lines.append("}")
    return "\n".join(lines) + "\n"


def sources(some_rows):
    """Returns {header: source that checks the names of the header}."""
    by_header = collections.defaultdict(list)
    for row in some_rows:
        by_header[row.header].append(row)
    return {header: source_of(header, found) for header, found in sorted(by_header.items())}


def layouts(some_rows):
    """Returns the text of a C++ function for tests/mips/abi that checks all sizes and offsets."""
    found = [row for row in some_rows if row.kind == "type"]
    lines = [f"#include <{header}>" for header in sorted({row.header for row in found})]
    lines += ["", '#include "abi.h"', "", "void CheckOriginalNames() {"]
    for row in found:
        size, fields = members(row)
        lines.append(f"  SIZE({row.name}, {size});")
        lines += [f"  AT({row.name}, {member}, {offset});" for member, offset, _, _ in fields]
    return "\n".join(lines + ["}"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, metavar="FOLDER")
    parser.add_argument("--layouts", type=Path, metavar="FILE")
    arguments = parser.parse_args()
    if arguments.sources:
        arguments.sources.mkdir(parents=True, exist_ok=True)
        for header, text in sources(list(rows())).items():
            (arguments.sources / (re.sub(r"\W", "_", header) + ".cc")).write_text(text)
    if arguments.layouts:
        arguments.layouts.parent.mkdir(parents=True, exist_ok=True)
        arguments.layouts.write_text(layouts(list(rows())))
    return 0


if __name__ == "__main__":
    sys.exit(main())
