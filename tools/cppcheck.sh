#!/usr/bin/env bash
# Runs cppcheck on the product.  Prints each finding of the kinds below, each of which is an error;
# cppcheck also knows kinds that are mostly wrong about this code, which are left out.  A kind comes
# in when its findings are mended, not before.  Exit status 0: there is no finding.
#
#     tools/cppcheck.sh [FOLDER|FILE...]     without names: the whole product
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

kinds=(cppcheckError internalAstError preprocessorErrorDirective syntaxError unknownMacro accessMoved arrayIndexOutOfBounds bufferAccessOutOfBounds deallocuse
  doubleFree eraseDereference invalidIterator1 leakNoVarFunctionCall memleak memleakOnRealloc
  memsetClass mismatchAllocDealloc mismatchingContainers negativeIndex nullPointer
  nullPointerRedundantCheck resourceLeak returnReference selfAssignment sizeofwithsilentarraypointer
  uninitdata uninitvar useClosedFile va_end_missing wrongPrintfScanfArgNum zerodiv)

if ! command -v cppcheck >/dev/null; then
  echo 'tools/cppcheck.sh: cppcheck is not installed (Debian package cppcheck)' >&2
  exit 2
fi
if [ $# -eq 0 ]; then
  set -- cli distribution kit objects openr runtime testing virtualrobot
fi
findings=$(cppcheck -q -j "$(nproc)" --std=c++20 --language=c++ --enable=warning -I. \
  --suppress=missingInclude --inline-suppr --template='{file}:{line}: {id}: {message}' "$@" 2>&1) || {
  echo "$findings"
  exit 2
}
grep -E "^[^ ]+: ($(IFS='|'; echo "${kinds[*]}")): " <<<"$findings" && exit 1
exit 0
