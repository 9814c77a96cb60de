#!/usr/bin/env bash
# The same run on several builds, and on a CPU without FMA and AVX2: equal hashes.
#
#   check_hashes.sh BUILD...      folders with bin/openr and stick/, as CMake makes them
#
# Prints a line per run; the last line is "N passed, N failed".
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }

scenarios=("--for 20s --body ode" "--for 20s --body ideal --seed 5")
# Names before and after glibc 2.33; unknown ones are ignored.
plain_cpu=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4,-AVX512F

passed=0
failed=0

# hashes BUILD SCENARIO: state and trace hash of a run; nothing when it fails.
hashes() {
  local build=$1
  shift
  # shellcheck disable=SC2086
  "$build/bin/openr" run --rate max --no-panel --rc-port 0 --json $* 2>/dev/null |
    python3 -c 'import json, sys; r = json.load(sys.stdin); print(r["state_hash"], r["trace_hash"])'
}

# compare NAME HASHES: counts and prints.
compare() {
  if [ -n "$2" ] && [ "$2" = "$wanted" ]; then
    passed=$((passed + 1))
    echo "$2  $1"
  else
    failed=$((failed + 1))
    echo "${2:-no report}  $1  DIFFERS from $wanted"
  fi
}

for scenario in "${scenarios[@]}"; do
  echo "openr run $scenario"
  wanted=$(hashes "$1" "$scenario") || wanted=
  for build in "$@"; do
    compare "$build" "$(hashes "$build" "$scenario" || true)"
  done
  compare "$1 without FMA and AVX2" \
    "$(export GLIBC_TUNABLES=$plain_cpu; hashes "$1" "$scenario" || true)"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
