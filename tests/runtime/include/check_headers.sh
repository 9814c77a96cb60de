#!/bin/sh
# Checks that every SDK header compiles alone, twice in a row and without a warning, in the
# languages and compilers that robot sources are built with; that all headers together can
# be part of several sources of one program; that sources in the old manner compile; and the
# layouts on a 32-bit MIPS.
#
#   check_headers.sh INCLUDE_DIR SCRATCH_DIR [quick|full]
#
# quick (the default): each header alone in gnu++98 with g++, and all of them together in every
# other combination.  full: each alone everywhere.
# Compilers that are not installed are named and skipped; g++ has to be there.
# Ends with 1 after listing what failed.
set -u

if [ $# -lt 2 ] || [ ! -f "$1/Types.h" ]; then
  echo "usage: check_headers.sh INCLUDE_DIR SCRATCH_DIR [quick|full]" >&2
  echo "       INCLUDE_DIR is the folder with Types.h (runtime/include)" >&2
  exit 2
fi
include=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/../../.." && pwd)
mkdir -p "$2" && scratch=$(cd "$2" && pwd) || exit 2
mode=${3:-quick}
warnings="-Wall -Wextra -Wpedantic -Wno-long-long -Werror"
# ObserverInfo.h has to warn: it is an old name.
warnings_old="-Wall -Wextra"

# The def.h that the stub generator writes for an object with one subject and one observer.
cat > "$scratch/def.h" <<'END'
#ifndef _def_h_DEFINED
#define _def_h_DEFINED
const char* const objectName = "Sample";
const int numOfSubject = 1;
const int numOfObserver = 1;
const char* const subjectService[numOfSubject] = {"Sample.Out.char.S"};
const char* const observerService[numOfObserver] = {"Sample.In.char.O"};
#endif
END
cat > "$scratch/entry.h" <<'END'
#ifndef _entry_h_DEFINED
#define _entry_h_DEFINED
#include <Types.h>
#include "def.h"
const Selector Entry_Control[numOfSubject] = {4};
const Selector Entry_Ready[numOfSubject] = {5};
const Selector Entry_Connect[numOfObserver] = {6};
const Selector Entry_Notify[numOfObserver] = {7};
#endif
END

headers=$(cd "$include" && find . -name '*.h' | sed 's,^\./,,' | LC_ALL=C sort)

# Sources: one per header, and one with all headers, forwards and backwards.
mkdir -p "$scratch/one"
rm -f "$scratch"/one/*.cc
: > "$scratch/all.cc"
: > "$scratch/all_reversed.cc"
for header in $headers; do
  printf '#include <%s>\n#include <%s>\n' "$header" "$header" \
    > "$scratch/one/$(echo "$header" | tr / _).cc"
  case $header in
    OPENR/ObserverInfo.h) ;;
    *) echo "#include <$header>" >> "$scratch/all.cc" ;;
  esac
done
sed '1!G;h;$!d' "$scratch/all.cc" > "$scratch/all_reversed.cc"
echo '#include "tests/runtime/include/message_layout_checks.h"' > "$scratch/layout.cc"

# Every constant of the interface has the value it has on the robot.
{
  cat "$scratch/all.cc"
  awk -F '\t' '/^[^#]/ { printf "typedef char is_%s[static_cast<unsigned>(%s) == static_cast<unsigned>(%s) ? 1 : -1];\n", $1, $1, $2 }' \
    "$root/tests/conformance/constants.tsv"
} > "$scratch/constants.cc"

: > "$scratch/failures"
# compile FLAGS SOURCE COMPILER...
compile() {
  flags=$1
  source=$2
  shift 2
  if ! "$@" $flags -I"$scratch" -I"$include" -I"$root" "$source" > "$scratch/output" 2>&1; then
    { echo "$* $(basename "$source" .cc):"; sed 's/^/    /;12q' "$scratch/output"; } \
      >> "$scratch/failures"
  fi
}

# each_alone COMPILER...
each_alone() {
  for source in "$scratch"/one/*.cc; do
    case $source in
      *OPENR_ObserverInfo.h.cc) compile "-fsyntax-only $warnings_old" "$source" "$@" ;;
      *) compile "-fsyntax-only $warnings" "$source" "$@" ;;
    esac
  done
  echo "each header alone: $*"
}

# all_together COMPILER...
all_together() {
  for source in "$scratch/all.cc" "$scratch/all_reversed.cc"; do
    compile "-fsyntax-only $warnings" "$source" "$@"
  done
  echo "all headers together: $*"
}

# old_sources COMPILER...  No -Wpedantic and no -Werror: gets() warns by itself.
old_sources() {
  for source in old_source.cc old_network_source.cc old_macros.cc every_signature.cc; do
    compile "-fsyntax-only" "$root/tests/runtime/include/$source" "$@"
  done
  echo "sources in the old manner: $*"
}

have() {
  command -v "$1" > /dev/null && return 0
  echo "skipped: $1 is not installed"
  return 1
}

for compiler in g++ clang++; do
  have $compiler || continue
  for level in 98 11 14 20; do
    case $mode-$compiler-$level in
      full-* | quick-g++-98) each_alone $compiler -std=gnu++$level ;;
    esac
    all_together $compiler -std=gnu++$level
    case $level in
      20) ;;  # std::byte; robot sources are never built above gnu++14
      *) old_sources $compiler -std=gnu++$level ;;
    esac
  done
done
if have mipsel-linux-gnu-g++; then
  [ "$mode" = full ] && each_alone mipsel-linux-gnu-g++ -std=gnu++98
  all_together mipsel-linux-gnu-g++ -std=gnu++98
  old_sources mipsel-linux-gnu-g++ -std=gnu++98
  compile "-fsyntax-only $warnings" "$scratch/layout.cc" mipsel-linux-gnu-g++ -std=gnu++11
  echo "layouts: mipsel-linux-gnu-g++"
fi
compile "-fsyntax-only $warnings" "$scratch/layout.cc" g++ -std=gnu++11
echo "layouts: g++"
compile "-fsyntax-only" "$scratch/constants.cc" g++ -std=gnu++98
echo "constants: g++"

# Nothing may be defined twice when two sources of an object include the same headers.
compile "-c -o $scratch/all.o" "$scratch/all.cc" g++ -std=gnu++98
compile "-c -o $scratch/all_reversed.o" "$scratch/all_reversed.cc" g++ -std=gnu++98
compile "-r -nostdlib -o $scratch/both.o $scratch/all.o" "$scratch/all_reversed.o" g++
echo "two sources in one program: g++"

count=$(echo "$headers" | wc -l)
if [ -s "$scratch/failures" ]; then
  cat "$scratch/failures" >&2
  exit 1
fi
echo "$count headers, no failure"
