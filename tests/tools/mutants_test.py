#!/usr/bin/env python3
"""tools/mutant_operators.py: which changes it makes of a source, and what it leaves alone; and
tests/mutants/accepted.json, whose survivors must be mutants of the tree.  The last line is
"N passed, N failed"."""
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import mutants as tool  # noqa: E402
from mutant_operators import mutants_of  # noqa: E402
from verdicts import finish, verdict  # noqa: E402


def changes(source, file="runtime/x.cc"):
    """Returns (original, changed) of each mutant of a function body."""
    mutants = mutants_of(file, f"void F() {{\n{source}\n}}\n")
    return [(mutant.original, mutant.changed) for mutant in mutants]


def check(name, source, *expected, **options):
    found = changes(source, **options)
    verdict(name, sorted(found) == sorted(expected), f"{source}\n{found}")


check("comparisons get or lose the equal sign", "while (a < b) c(x);", ("<", "<="),
      ("c(x);", "{}"))
check("conditions of several parts are negated", "if (a && b) c(x);", ("&&", "||"),
      ("a && b", "!(a && b)"), ("c(x);", "{}"))
check("one equality is only swapped", "if (a == b) return;", ("==", "!="))
check("constants grow by one, in their notation", "F(7, 0x0fu, 1.5f);", ("7", "8"),
      ("0x0fu", "0x10u"), ("1.5f", "(1.5f + 1)"), ("F(7, 0x0fu, 1.5f);", "{}"))
check("assignments are removed", "a = b;\nc->d += e;", ("a = b;", "{}"), ("c->d += e;", "{}"),
      ("+=", "-="))
check("a statement of several lines is removed as a whole", "a(b,\n  c);", ("a(b,\n  c);", "{}"))
check("the statement after an if is removed", "if (!a) b();", ("!a", "!(!a)"), ("b();", "{}"))
check("results become the zero of their type", "return Name(a);", ("Name(a)", "{}"))
check("results of objects become 0, because they are C++98", "return name;", ("name", "0"),
      file="objects/x.cc")
check("comparisons as results are negated", "return a < b;", ("<", "<="), ("a < b", "!(a < b)"))
check("declarations stay", "int a = b;\nFoo c(d);\nFoo* const e = f;\nauto& g = *h;")
check("conditions that declare a variable stay", "if (Foo* const a = b) return;")
check("templates, pointers and references stay", "static_cast<Foo*>(a) & *b;\nreturn;", ("&", "|"))
check("assertions and the texts of messages stay", 'ASSERT(a < 1, "");\nb(fmt::format("{}", 1));',
      ('b(fmt::format("{}", 1));', "{}"))
check("comments, texts and directives stay",
      '// a < 1\n/* b + 1 */\nconst char* c = "d < 1 + 2";\nconst char e = \'1\';\n#define A(f) f + 1\n')

SOURCE = "void F() {\n  Foo(1);\n  Bar(2);\n  Foo(1);\n}\n"
PLACES = [(mutant.line, mutant.text, mutant.occurrence) for mutant in mutants_of("a.cc", SOURCE)
          if mutant.original == "1"]
verdict("equal lines are numbered", PLACES == [(2, "Foo(1);", 1), (4, "Foo(1);", 2)], PLACES)

UNKNOWN = tool.unknown_entries(json.loads(tool.TARGETS.read_text()), tool.accepted_keys())
verdict("each entry of accepted.json names a mutant of the tree", not UNKNOWN,
        "\n".join([*map(str, UNKNOWN), "if only the text of a line has changed, change the entry"]))

sys.exit(finish())
