#!/usr/bin/env python3
"""tools/cppcheck.sh: faults that are planted here are found, and a finding ends it with a failure.  The last
line is "N passed, N failed", with ", 1 skipped" if cppcheck is not installed."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

MOVED = """#include <string>
#include <utility>
void Take(std::string text);
void TakeTwice(std::string text) {
  Take(std::move(text));
  Take(text);
}
"""
# A name, the text of a source, and the kind of its finding; "": nothing may be found.
SOURCES = [
    ("a text that was moved away is used", MOVED, "accessMoved"),
    ("a null pointer is used before it is checked",
     "int Read(const int* at) {\n  const int value = *at;\n  if (at == nullptr) return 0;\n  return value;\n}\n",
     "nullPointerRedundantCheck"),
    ("an index is beyond the array", "int Beyond() {\n  int numbers[2] = {1, 2};\n  return numbers[2];\n}\n",
     "arrayIndexOutOfBounds"),
    ("a file that cppcheck cannot read is a finding", "int Open( {\n  return 0;\n}\n", "syntaxError"),
    ("a finding that a comment suppresses is none", MOVED.replace("  Take(text)", "  // cppcheck-suppress accessMoved\n  Take(text)"),
     ""),
    ("a kind that is not in the list is none", "struct Number {\n  Number() {}\n  int value;\n};\n", ""),
    ("a good file", "int Good() { return 1; }\n", ""),
]


def main():
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tools").mkdir()
        script = shutil.copy(ROOT / "tools/cppcheck.sh", Path(folder, "tools"))
        if not shutil.which("cppcheck"):
            done = subprocess.run([script], capture_output=True, text=True)
            verdict("without cppcheck the script says which package it needs",
                    done.returncode == 2 and "Debian package cppcheck" in done.stderr, done.stderr)
            return finish(skipped=1)
        for i, (name, text, kind) in enumerate(SOURCES):
            Path(folder, f"source{i}.cc").write_text(text)
            done = subprocess.run([script, f"source{i}.cc"], capture_output=True, text=True)
            lines = done.stdout.splitlines()
            is_right = (done.returncode, len(lines)) == (1, 1) and f": {kind}: " in lines[0] if kind \
                else (done.returncode, lines) == (0, [])
            verdict(name, is_right, f"status {done.returncode}: {done.stdout}{done.stderr}")
        # Without names the script reads the folders of the product, so each of them is made here.
        for name in ("cli", "distribution", "kit", "objects", "openr", "runtime", "testing", "virtualrobot"):
            Path(folder, name).mkdir()
            Path(folder, name, "good.cc").write_text(SOURCES[-1][1])
        verdict("a product without findings is good", subprocess.run([script]).returncode == 0)
        for name in ("cli", "testing"):
            Path(folder, name, "bad.cc").write_text(SOURCES[0][1])
            done = subprocess.run([script], capture_output=True, text=True)
            verdict(f"a finding in {name}/ is one of the product",
                    done.returncode == 1 and f"{name}/bad.cc:6: accessMoved" in done.stdout, done.stdout + done.stderr)
            Path(folder, name, "bad.cc").unlink()
        done = subprocess.run([script, "nowhere.cc"], capture_output=True, text=True)
        verdict("a name that leads nowhere is a failure", done.returncode == 2, done.stdout)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
