#!/usr/bin/env bash
# Runs of the whole graph on several builds, and on a CPU without FMA and AVX2: their hashes are
# those of golden.txt.
#
#   check_hashes.sh BUILD...      folders with bin/hash_probe and stick/, as CMake makes them
#
# Prints a line per run; the last line is "N passed, N failed".
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }

golden=$(dirname "$0")/golden.txt
# Names before and after glibc 2.33; unknown ones are ignored.
plain_cpu=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4,-AVX512F

passed=0
failed=0

# hashes BUILD SCENARIO: state and trace hash of a run; nothing when it fails.
hashes() {
  # shellcheck disable=SC2086
  "$1/bin/hash_probe" $2 "$1/stick"
}

# compare NAME HASHES: counts and prints.
compare() {
  if [ "$2" = "$wanted" ]; then
    passed=$((passed + 1))
    echo "$2  $1"
  else
    failed=$((failed + 1))
    echo "${2:-no hashes}  $1  DIFFERS from $wanted"
  fi
}

while read -r body seconds seed wanted; do
  scenario="$body $seconds $seed"
  echo "hash_probe $scenario"
  for build in "$@"; do
    compare "$build" "$(hashes "$build" "$scenario" || true)"
  done
  compare "$1 without FMA and AVX2" \
    "$(export GLIBC_TUNABLES=$plain_cpu; hashes "$1" "$scenario" || true)"
done < <(grep -v '^#' "$golden")
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
