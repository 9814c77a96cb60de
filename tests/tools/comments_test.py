#!/usr/bin/env python3
"""tools/comments.py: the comments that it refuses, and the text that it does not take for a comment.  The last line
is "N passed, N failed"."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

# Name of the file, its text, and the lines of the comments that are refused.
FILES = [
    ("runtime/a.cc", "// Of the robot.\nint a;\n", [1]),
    ("runtime/a.cc", "int a;  // of the robot\nint b;  // number of legs\n", [1]),
    ("runtime/a.cc", "int a;  // Which is\nint b;  //it, as well\n\nint c;  // one: a name\n", [1, 2]),
    ("runtime/a.cc", "// The legs\n// of the robot, those\n// that move.\nint a;\n", []),
    ("runtime/a.cc", "int a;  // the legs\n        // of the robot\nint b;\n", []),
    ("runtime/a.cc", "int a;  // the legs\n// of the robot\nint b;\n", [2]),
    ("runtime/a.cc", "// The legs\n\n// of the robot\n", [3]),
    ("runtime/a.h", "/* What it is.\n   Of course. */ int a; /** there */\n", [1, 2]),
    ("runtime/a.cc", "// Italy, oneself, thereby, What() and one_leg.\n// Else\nint a;  // Whatever\n", []),
    ("runtime/a.cc", 'const char* a = "// of" "\\"// of";  // text\n', []),
    ("runtime/a.cc", "char a = '\"';  // of a\nint b = 1'000;  // of b\nchar c = '\\'';  // of c\n", [1, 2, 3]),
    ("runtime/a.cc", 'const char* a = R"(\n// of " a\n)";  // of\nR"x(// of )" )x";\n', [3]),
    ("runtime/a.cc", "int a = 4 / 2; /* a */ int b; // what\n", [1]),
    ("objects/a.c", "int a; /* which moves */\n", [1]),
    ("panel/src/a.ts", "const a = `// of ${b}`; // those\nconst c = 'it'; // it's\n", [1, 2]),
    ("tools/a.py", "#!/usr/bin/env python3\n# What it does.\na = 1  # of b\n", [2, 3]),
    ("tools/a.py", '"""One thing."""\ndef a():\n    """Those."""\n    return "# of"\n', [1, 3]),
    ("tools/a.py", 'def a():\n    """Returns\n    of."""\n    return """\n# of\n"""\n', []),
    ("tools/a.sh", "#!/bin/sh\n# Who does it.\n\necho a  # of\necho '# of' \"# of\" a#of \\# of ${#it}\n", [2, 4]),
    ("tools/a.sh", "cat <<'END'\n# of\nEND\ncat <<-END >x\n# of\n\tEND\n# of\n", [7]),
    (".ci/run", "#!/usr/bin/env bash\n# What is run\n", [2]),
    ("dev", "#!/usr/bin/env bash\ncat >&2 <<TEXT\n  # of\nTEXT\na=1  # what\n", [5]),
    ("cmake/a.cmake", "set(a \"# of\")  # of b\nset(c [[\n# of\n]])\n# There\n", [1, 5]),
    ("tests/CMakeLists.txt", "# One program\n", [1]),
    ("tests/kit/fixtures/a/b.cc", "// of old programs\n", []),
    ("panel/node_modules/a/b.ts", "// of others\n", []),
    ("docs/" "a.md", "# Of books\n", []),
]


def lines_of(name, text):
    """Returns the numbers of the lines that the tool names for this file, and all that it prints."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        done = subprocess.run([sys.executable, ROOT / "tools/comments.py", folder], capture_output=True, text=True,
                              check=False)
    said = done.stdout.splitlines()
    if done.stderr or done.returncode != bool(said) or not all(line.startswith(f"{name}:") for line in said):
        return None, done.stdout + done.stderr
    return sorted(int(line.split(":")[1]) for line in said), done.stdout


for name, text, wanted in FILES:
    found, said = lines_of(name, text)
    verdict(f"{name}: {text}", found == wanted, f"{found}, not {wanted}: {said}")
sys.exit(finish())
