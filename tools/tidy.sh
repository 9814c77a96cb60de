#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy on the product, one process per compiled file of the
# build: a source, or a unity file that includes several sources.  Needs a build of the preset
# release.  Fails as well if the build does not compile a source of the product, because clang-tidy
# does not see it then.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ ! -f build/release/compile_commands.json ]; then
  echo 'tools/tidy.sh: no build/release; run ./dev build release first' >&2
  exit 2
fi
# clang-tidy gets commands without precompiled headers, because clang cannot read those of g++.
mkdir -p build/tidy
files=$(python3 - <<'PYTHON'
import json
import pathlib
import re
import sys

product = ("runtime", "virtualrobot", "distribution", "cli", "kit", "openr", "testing")
root = pathlib.Path.cwd()
sources = {file for name in product for file in root.glob(f"{name}/**/*.cc")}
compiled, commands = set(), {}
for entry in json.load(open("build/release/compile_commands.json")):
    file = pathlib.Path(entry["file"])
    is_unity = "/Unity/" in entry["file"]
    included = {pathlib.Path(name) for name in re.findall('#include "(.+)"', file.read_text())} if is_unity else {file}
    if included & sources and file not in commands and not file.is_relative_to(root / "build/release/tests"):
        compiled |= included
        entry["command"] = re.sub(r" -include \S+/cmake_pch\.hxx(?= )", "", entry["command"])
        commands[file] = entry
json.dump(list(commands.values()), open("build/tidy/compile_commands.json", "w"))
print(*commands, sep="\n")
missing = sorted(sources - compiled)
if missing or not sources:
    print("tools/tidy.sh: not compiled in build/release:", *missing, sep="\n  ", file=sys.stderr)
    sys.exit(1)
PYTHON
) || exit 1
xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet --extra-arg=-Qunused-arguments <<<"$files" 2>/dev/null
