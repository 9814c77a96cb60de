#!/usr/bin/env python3
"""Checks that objects use only headers, functions and names that the robot has.

    tools/sdk_surface.py                    checks objects/ and examples/; prints every offence,
                                            nothing is good
    tools/sdk_surface.py FOLDER...          checks other folders
    tools/sdk_surface.py --list [FOLDER]    lists what is used: name, how often, where it is from
    tools/sdk_surface.py --symbols FILE     checks what compiled objects leave undefined (nm -C -u)
    tools/sdk_surface.py --write            makes tools/surface/sdk_surface.tsv of runtime/include
                                            and the books of docs/openr

The SDK's surface: names that our headers have *and* a book of docs/openr names.  What only our headers
have (the table says "-") would be missing on the robot, so objects must not use it.

Names that the original headers define as macros (tools/surface/macro_names.txt) may not be declared
as something else, in objects/, examples/ and in our own headers: it would not compile there.
"""
import argparse
import collections
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools/surface"))
import original_names  # noqa: E402
from source_names import KEYWORDS, Source  # noqa: E402

HEADERS = ROOT / "runtime/include"
# Books that describe only the robot.  The other books of docs/openr also describe this project.
REFERENCES = [ROOT / "docs/openr" / f"{book}.md"
              for book in ("binary", "core", "field-notes", "measured", "network", "robot")]
TABLE = ROOT / "tools/surface/sdk_surface.tsv"
LIBRARY = ROOT / "tools/surface/robot_c_library.txt"
MACROS = ROOT / "tools/surface/macro_names.txt"
SOURCES = (".cc", ".cpp", ".c", ".h")
# Headers that the stub generator makes of a stub.cfg (core.md 4.2 and 4.3), and tools/genmodel.
GENERATED_HEADERS = {"def.h", "entry.h", "RobotConstants.h"}
GENERATED_NAMES = re.compile(r"^(NUM_)?ROBOTS$|^(sbj|obs|entry)[A-Z]\w*$|^Entry_\w+$|^Extra_Entry$|^numOf(Subject|Observer)$")


def names_of_headers():
    """Returns {name: first header that contains the name}."""
    names = {}
    for header in sorted(HEADERS.rglob("*.h")):
        place = str(header.relative_to(HEADERS))
        source = Source(header.read_text())
        for word in sorted(set(source.defined) | {w for w, _ in source.tokens}):
            if re.match(r"[A-Za-z_]\w*$", word) and word not in KEYWORDS:
                names.setdefault(word, place)
        names[place] = place
    return names


def macro_names():
    return {line for line in MACROS.read_text().split("\n") if line and not line.startswith("#")}


class References:
    """Names that the reference texts contain.

    A text may write names in short: `prefix{A 0, B 1}` stands for prefixA and prefixB.
    """

    def __init__(self):
        self.words = {}
        for text in REFERENCES:
            content = text.read_text()
            for word in re.findall(r"[A-Za-z_]\w*", content):
                self.words.setdefault(word, text.stem)
            for prefix, body in re.findall(r"(\w+)\{([^{}]*)\}", content):
                for word in re.findall(r"[A-Za-z_]\w*", body):
                    self.words.setdefault(prefix + word, text.stem)
            for header in re.findall(r"[\w/]+\.h\b", content):
                self.words.setdefault(header, text.stem)
        self.stems = {}
        for word, source in self.words.items():
            if re.match(r"o[a-z]+[A-Z]\w*_", word):
                self.stems.setdefault(word.rsplit("_", 1)[0], source)
        for row in original_names.rows():
            for word in [row.header, *re.findall(r"[A-Za-z_]\w*", f"{row.name} {row.facts}")]:
                if row.kind != "brings":
                    self.words.setdefault(word, "original_names")
        for word in macro_names():
            self.words.setdefault(word, "macro_names")

    def source_of(self, name):
        if name in self.words:
            return self.words[name]
        if name.endswith(".h"):
            return self.words.get(name.split("/")[-1], "-") if "/formats/" not in name else "-"
        for cut in range(len(name) - 1, 2, -1):  # orsb + PAUSE: a text may name the parts
            left, right = name[:cut].rstrip("_"), name[cut:].lstrip("_")
            source = self.words.get(left) or self.words.get(left + "_") or self.stems.get(left)
            if source and (right in self.words or "_" + right in self.words):
                return source
        return "-"


def write_table():
    references = References()
    lines = ["# Made by tools/sdk_surface.py --write of runtime/include and the references; do not edit.",
             "# name, header of ours, reference that names it (-: none, so the robot may not have it)"]
    for name, header in sorted(names_of_headers().items()):
        lines.append(f"{name}\t{header}\t{references.source_of(name)}")
    TABLE.write_text("\n".join(lines) + "\n")


def read_table():
    table = {}
    for line in TABLE.read_text().splitlines():
        if not line.startswith("#"):
            name, header, reference = line.split("\t")
            table[name] = (header, reference)
    return table


def read_library():
    sections = collections.defaultdict(set)
    title = ""
    for line in LIBRARY.read_text().splitlines():
        line = line.split("#")[0].rstrip()
        if line.endswith(":"):
            title = line[:-1]
        else:
            sections[title].update(line.split())
    return sections


class Surface:
    def __init__(self):
        self.table = read_table()
        self.library = read_library()
        self.macros = macro_names()
        self.used = collections.Counter()  # keys: (name, where the name comes from)

    def of_sdk(self, name):
        return self.table.get(name, ("", "-"))[1] != "-"

    def judge_include(self, what, own_files):
        """Returns a text if objects may not include the header, or None."""
        name = what[1:-1]
        if what[0] == '"' and (Path(name).name in own_files or name in GENERATED_HEADERS):
            return None
        if name.startswith("device/") and Path(name).name in own_files:
            return None
        if name in self.library["c headers"] or name in self.library["c++ headers"]:
            self.used[f"<{name}>", "C and C++ library"] += 1
            return None
        if self.of_sdk(name):
            self.used[f"<{name}>", "SDK"] += 1
            return None
        if name in self.table:
            return f"{what}: a header of this project that the SDK does not have"
        return f"{what}: neither the SDK nor the robot's C library has this header"

    def judge_name(self, name, qualifier, is_call, own):
        if qualifier == "std":
            self.used[f"std::{name}", "C++ library"] += 1
            known = self.library["std"] | self.library["functions"]
            return None if name in known else f"std::{name}: not in the robot's C++ library of 1998"
        plain = qualifier in ("", "::")
        if is_call and plain and name in self.library["does not work"]:
            return f"{name}(): not there, or without effect, on the robot (core reference 8.1)"
        if name in own or GENERATED_NAMES.match(name) or name == "std":
            return None
        if self.of_sdk(name):
            self.used[name, "SDK"] += 1
            return None
        sections = ["functions", "names"] if plain else ["members", "functions", "names"]
        if any(name in self.library[section] for section in sections):
            self.used[name, "C and C++ library"] += plain
            return None
        if name in self.table:
            return f"{name}: only our {self.table[name][0]} has it, no reference names it"
        return f"{name}: not declared here, and not of the SDK or the robot's C library"

    def macro_offences(self, file, source, is_macro_allowed=lambda name: False):
        """Yields an offence for each declared name that the original headers define as a macro."""
        for name, line in sorted(source.declarations().items(), key=lambda item: item[1]):
            if name in self.macros and not is_macro_allowed(name):
                yield f"{file}:{line}: {name}: a macro of the robot's headers; take another name"

    def check_headers(self, folder):
        """Yields the offences of macro_offences() for our own headers.

        A header may define such a macro, or declare the name if a reference declares it, too.
        """
        for header in sorted(Path(folder).rglob("*.h")):
            source = Source(header.read_text())
            yield from self.macro_offences(
                header, source, lambda name: name in source.defined or self.is_documented(name))

    def is_documented(self, name):
        """Returns whether a reference other than the list of macros has the name."""
        is_word = name.islower()  # such as max: a word that every text contains
        return not is_word and self.table.get(name, ("", "-"))[1] not in ("-", "macro_names")

    def check_program(self, files, own_files, shared_names):
        """Yields the offences of the sources of a program; a name of one source is known in all."""
        sources = {file: Source(file.read_text(errors="replace")) for file in files}
        own = set(shared_names)
        for source in sources.values():
            own |= source.declared()
        for file, source in sources.items():
            yield from self.macro_offences(file, source)
            for line, what in source.includes:
                offence = self.judge_include(what, own_files)
                if offence:
                    yield f"{file}:{line}: {offence}"
            said = set()
            for name, line, qualifier, is_call in source.uses():
                offence = self.judge_name(name, qualifier, is_call, own)
                if offence and offence not in said:
                    said.add(offence)
                    yield f"{file}:{line}: {offence}"


def sources_below(folder):
    return sorted(f for f in folder.rglob("*") if f.suffix in SOURCES and f.is_file())


def programs(folder):
    """Yields the folders of programs: objects/ is one program, each example is another."""
    if folder.name == "examples":
        for child in sorted(folder.iterdir()):
            if child.name == "controllers" and child.is_dir():
                yield from sorted(f for f in child.iterdir() if f.is_dir())
            elif child.is_dir():
                yield child
    else:
        yield folder


def check(folders, surface):
    """Yields the offences of all programs in the folders."""
    devices = sources_below(ROOT / "objects/Controller/include")
    interface = set()
    for header in devices:
        interface |= Source(header.read_text()).declared()
    for folder in folders:
        for program in programs(folder):
            files = sources_below(program)
            own_files = {f.name for f in files} | {f.name for f in devices}
            yield from surface.check_program(files, own_files, interface)


# Functions that templates of the C++ library of 1998 call, and functions of the compiler.
LIBRARY_SYMBOLS = re.compile(r"std::(_Rb_tree_|__throw_|ios_base::Init::|allocator<|(__cxx11::)?basic_string<"
                             r"|(__detail::)?_List_node_base)"
                             r"|operator (new|delete)|__|_Unwind_|_gp_disp$|_GLOBAL_OFFSET_TABLE_$")


def judge_symbol(symbol, surface):
    """Returns a text if the robot does not have the symbol, or None.

    `symbol`: as nm -C prints it, such as OPENR::OpenPrimitive(char const*, ...).
    """
    name = re.sub(r"^(vtable|typeinfo|typeinfo name|VTT) for ", "", re.sub(r"\(.*", "", symbol))
    if LIBRARY_SYMBOLS.match(name):
        return None
    parts = [part.strip() for part in re.split(r"::", name) if part.strip()]
    plain = [part.split()[0].lstrip("~") for part in parts]  # "operator new" becomes "operator"
    if len(plain) == 1 and (plain[0] in surface.library["functions"] or surface.of_sdk(plain[0])):
        return None
    if len(plain) > 1 and all(part == "operator" or surface.of_sdk(part) for part in plain):
        return None
    return f"{symbol}: called, and neither of the SDK nor of the robot's C library"


def symbol_offences(file, surface):
    for line in Path(file).read_text().splitlines():
        if line.strip():
            offence = judge_symbol(line.strip(), surface)
            if offence:
                yield offence


def stale_table():
    """Yields a text for each name whose line in the table is out of date.

    The name has appeared or disappeared, in our headers or in the references.
    """
    now, then = names_of_headers(), read_table()
    references = References()
    for name in sorted(set(now) & set(then)):
        if references.source_of(name) != then[name][1]:
            yield (f"{TABLE.name}: {name} is said to be of '{then[name][1]}', the references say "
                   f"'{references.source_of(name)}'; make it again with --write")
    for name in sorted(set(now) ^ set(then)):
        which = "is not in" if name in now else "is still in"
        yield f"{now.get(name, then.get(name, ('?',))[0])}: {name} {which} {TABLE.name}; make it again with --write"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--symbols", metavar="FILE")
    parser.add_argument("folders", nargs="*", type=Path)
    arguments = parser.parse_args()
    if arguments.write:
        write_table()
        return 0
    surface = Surface()
    if arguments.symbols:
        offences = list(symbol_offences(arguments.symbols, surface))
        print("\n".join(offences), end="\n" if offences else "")
        return 1 if offences else 0
    offences = list(check(arguments.folders or [ROOT / "objects", ROOT / "examples"], surface))
    if not arguments.folders:
        offences += list(surface.check_headers(HEADERS)) + list(stale_table())
    if arguments.list:
        for (name, origin), count in sorted(surface.used.items(), key=lambda item: (item[0][1], item[0][0])):
            print(f"{name}\t{count}\t{origin}")
        return 0
    for offence in offences:
        print(offence.replace(str(ROOT) + "/", ""))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
