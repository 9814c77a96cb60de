#!/usr/bin/env python3
"""tools/tidy.sh: which files of a build it gives to clang-tidy, with which commands, and when it fails.  A script
takes the place of clang-tidy.  The last line is "N passed, N failed"."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

UNITY = "build/release/openr/CMakeFiles/openr_commands.dir/Unity/unity_0_cxx.cxx"
HEADER = "build/release/openr/CMakeFiles/openr_commands.dir/cmake_pch.hxx"
# Finds a fault in each file that contains the word.
CLANG_TIDY = """#!/bin/sh
for file; do :; done
echo "checked $file"
! grep -q FAULT "$file"
"""


class Tree:
    """A tree with tools/tidy.sh, some sources, and the commands of a build of them."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.commands = []
        for name in ("tools", "bin"):
            (self.folder / name).mkdir()
        self.script = shutil.copy(ROOT / "tools/tidy.sh", self.folder / "tools")
        (self.folder / "bin/clang-tidy").write_text(CLANG_TIDY)
        (self.folder / "bin/clang-tidy").chmod(0o755)

    def add(self, name, text="", command="c++ -c x.cc", is_compiled=True):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        if is_compiled:
            self.commands.append({"directory": str(self.folder), "file": str(file), "command": command})

    def run(self):
        """Returns status, checked files, and what the script says."""
        self.add("build/release/compile_commands.json", json.dumps(self.commands), is_compiled=False)
        done = subprocess.run([self.script], capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"})
        checked = sorted(line.removeprefix(f"checked {self.folder}/") for line in done.stdout.splitlines())
        return done.returncode, checked, done.stdout + done.stderr


def check(name, tree, status, checked=None, word=""):
    found, files, said = tree.run()
    verdict(name, found == status and checked in (None, files) and word in said, f"status {found}: {said}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        tree = Tree(folder)
        check("a build without a source of the product is a failure", tree, 1, [])
        tree.add("runtime/hooks/alone.cc")
        tree.add("openr/commands/run.cc", is_compiled=False)
        tree.add(UNITY, f'#include "{tree.folder}/openr/commands/run.cc"\n',
                 f"c++ -Winvalid-pch -include {tree.folder}/{HEADER} -o x.o -c {tree.folder}/{UNITY}")
        tree.add("tests/openr/run_test.cc")
        tree.add("build/release/tests/Unity/unity_0_cxx.cxx", f'#include "{tree.folder}/runtime/hooks/alone.cc"\n')
        tree.add("build/release/generated/generated.cc")
        files = [UNITY, "runtime/hooks/alone.cc"]
        check("sources alone and several at a time are checked, those of tests are not", tree, 0, files)
        commands = {entry["file"]: entry["command"]
                    for entry in json.loads((tree.folder / "build/tidy/compile_commands.json").read_text())}
        wanted = {str(tree.folder / UNITY): f"c++ -Winvalid-pch -o x.o -c {tree.folder}/{UNITY}",
                  str(tree.folder / "runtime/hooks/alone.cc"): "c++ -c x.cc"}
        verdict("the commands have no precompiled header", commands == wanted, commands)
        tree.add("openr/commands/new.cc", is_compiled=False)
        check("a source that is not compiled is a failure", tree, 1, [], "openr/commands/new.cc")
        tree.add("openr/commands/new.cc", "FAULT")
        check("a finding is a failure, and the other files are checked", tree, 123,
              sorted([*files, "openr/commands/new.cc"]))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
