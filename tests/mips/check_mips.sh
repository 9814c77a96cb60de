#!/usr/bin/env bash
# The objects on the robot's word size and byte order, as far as that goes without the SDK:
#
#   objects/, examples/ and controllers compile as C++98 for 32-bit little-endian MIPS;
#   the layout of our headers' structs is the robot's;
#   the tests of the objects' logic pass there (under qemu);
#   openr stick robot makes a stick with a stand-in for the SDK;
#   what they call is of the SDK or of the robot's C library;
#   the stacks of the .ocf files suffice;
#   openr emon finds the line of a crash;
#   and one text of many values is the same, byte for byte, as on the host with g++ and clang++.
#
#   check_mips.sh BUILD [WORK]     BUILD: a build of the host; WORK: default BUILD/../mips
#
# The last line is "N passed, M failed".
set -uo pipefail
[ $# -gt 0 ] || { sed -n '2,15s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "$1" && pwd) || exit 2
mkdir -p "${2:-$build/../mips}"
work=$(cd "${2:-$build/../mips}" && pwd)

passed=0
failed=0

# verdict NAME STATUS
verdict() {
  if [ "$2" -eq 0 ]; then
    passed=$((passed + 1))
    echo "good: $1"
  else
    failed=$((failed + 1))
    echo "FAILED: $1"
  fi
}

# total NAME COMMAND...: runs a test program and adds its last line to the sum.
total() {
  local name=$1
  shift
  "$@" >"$work/$name.log" 2>&1
  add_total "$name" $?
}

# add_total NAME STATUS: adds the last line of a test program that has ended to the sum.
add_total() {
  local name=$1 status=$2 last
  last=$(tail -n 1 "$work/$name.log")
  if [[ $last =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed(,\ [0-9]+\ skipped)?$ ]]; then
    echo "$name: $last"
    passed=$((passed + BASH_REMATCH[1]))
    failed=$((failed + BASH_REMATCH[2]))
    if [ "$status" -ne 0 ] && [ "${BASH_REMATCH[2]}" -eq 0 ]; then verdict "$name ends with 0" 1; fi
    [ "${BASH_REMATCH[2]}" -eq 0 ] && return
  else
    verdict "$name runs to its end (status $status)" 1
  fi
  grep -vE '^\[ +(OK|RUN) ' "$work/$name.log" | head -40
}

# make_with NAME TARGET OPTION...: configures and builds tests/mips with a compiler.
make_with() {
  local name=$1 target=$2
  shift 2
  cmake -S "$here" -B "$work/$name" -G Ninja -DOPENR_BUILD="$build" "$@" >"$work/$name.log" 2>&1 &&
    cmake --build "$work/$name" --target "$target" -- -k 0 >>"$work/$name.log" 2>&1
  local status=$?
  [ "$status" -eq 0 ] || grep -E 'error|FAILED|Error|not found' "$work/$name.log" | head -40
  verdict "$target of $name compiles" "$status"
}

# same NAME FILE: FILE is what g++ on the host wrote.
same() {
  if [ ! -s "$work/host.txt" ] || [ ! -s "$2" ]; then
    verdict "the values are there: $1" 1
    return
  fi
  if cmp -s "$work/host.txt" "$2"; then
    verdict "the same $(wc -l <"$2") lines of values: $1" 0
  else
    diff "$work/host.txt" "$2" | head -8 | cut -c 1-160
    verdict "the same values: $1" 1
  fi
}

# Bytes of a stack that the objects' logic does not use: for stub, handler and the SDK's library.
reserve=1024

# stack OBJECT USED: with the reserve, three quarters of the stack of the .ocf file at most.
stack() {
  local ocf size
  ocf=$here/../../objects/$1/$1.ocf
  size=$(sed 's/#.*//' "$ocf" | awk '$1 == "object" { print $3 }')
  echo "stack of $1: $2 bytes used, $size in its .ocf"
  [ $(($2 + reserve)) -le $((size * 3 / 4)) ]
  verdict "the stack of $1 suffices" $?
}

# Compiles one source at a time for a minute, so it runs beside all that follows.
python3 "$here/robot_stick_test.py" --build "$build" >"$work/robot_stick.log" 2>&1 &
robot_stick=$!
trap 'kill "$robot_stick" 2>/dev/null' EXIT

# Compiles all sources of a target at a time, because only the values of these builds are compared.
# The stacks of mipsel must be those of the robot, where each source is compiled alone.
values=(dump -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0)
make_with host "${values[@]}" -DCMAKE_BUILD_TYPE=Release
make_with clang "${values[@]}" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_C_COMPILER=clang
make_with mipsel all -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE="$here/mipsel.cmake"
make_with mipsel-O0 "${values[@]}" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_TOOLCHAIN_FILE="$here/mipsel.cmake"

"$work/host/bin/dump" >"$work/host.txt"
"$work/clang/bin/dump" >"$work/clang.txt"
qemu-mipsel-static "$work/mipsel/bin/dump" >"$work/mipsel.txt"
qemu-mipsel-static "$work/mipsel-O0/bin/dump" >"$work/mipsel-O0.txt"
same 'clang++ on the host' "$work/clang.txt"
same 'MIPS' "$work/mipsel.txt"
same 'MIPS without optimisation' "$work/mipsel-O0.txt"

# Names that the compiled objects leave to the SDK and the C library.
names() { mipsel-linux-gnu-nm -C "$1" "${@:2}" 2>/dev/null | sed -nE 's/^[0-9a-f ]* [TtWwVvBbDdRrUuiG] //p' | sort -u; }
mapfile -t compiled < <(find "$work"/mipsel/CMakeFiles/object_* -name '*.o')
compiled+=("$work/mipsel/libobjects_common.a")
comm -23 <(names -u "${compiled[@]}") <(names --defined-only "${compiled[@]}") |
  grep -v '^CallControllerMain' >"$work/symbols.txt"
count=$(wc -l <"$work/symbols.txt")
[ "$count" -gt 40 ] && python3 "$here/../../tools/sdk_surface.py" --symbols "$work/symbols.txt"
verdict "$count names that the objects leave undefined are the robot's" $?

# The robot's image tool relocates an undefined weak symbol to the load address: it is not null there.
weak=$(mipsel-linux-gnu-nm -A "${compiled[@]}" | grep -E ' [wv] ')
[ "${#compiled[@]}" -gt 10 ] && [ -z "$weak" ]
verdict "no object leaves a weak symbol undefined $weak" $?

mkdir -p "$work/stick"
qemu-mipsel-static "$work/mipsel/bin/stack" "$work/stick" >"$work/stack.txt"
verdict 'four objects tell their stack' "$([ "$(wc -l <"$work/stack.txt")" -eq 4 ]; echo $?)"
while read -r object used; do stack "$object" "$used"; done <"$work/stack.txt"

total abi qemu-mipsel-static "$work/mipsel/bin/abi"
total logic qemu-mipsel-static "$work/mipsel/bin/logic"
wait "$robot_stick"
add_total robot_stick $?
total emon python3 "$here/emon_test.py" --build "$build"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
