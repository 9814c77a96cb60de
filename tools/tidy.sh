#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy on the product, one process per unity file of the
# build (a file that includes several sources).  Needs a build of the preset release.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ ! -f build/release/compile_commands.json ]; then
  echo 'tools/tidy.sh: no build/release; run ./dev build release first' >&2
  exit 2
fi
python3 - <<'PYTHON' | xargs -r -P "$(nproc)" -n 1 clang-tidy -p build/release --quiet --extra-arg=-Qunused-arguments 2>/dev/null
import json

product = ("runtime", "virtualrobot", "distribution", "cli", "kit", "openr", "testing")
for entry in json.load(open("build/release/compile_commands.json")):
    below = entry["file"].split("build/release/")[-1].split("/")[0]
    # clang-tidy cannot read a precompiled header of g++, so sources with one are left out.
    if below in product and "/Unity/" in entry["file"] and "cmake_pch" not in entry["command"]:
        print(entry["file"])
PYTHON
