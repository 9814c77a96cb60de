#!/usr/bin/env bash
# Types the commands of the README, from its begin to its first section, in a root that has nothing
# else (tools/first_steps.sh); with --list, prints those of ./README.md.  While the command ./dev run
# of the first block runs, the commands of the second block are typed as in a second terminal; then
# Ctrl-C ends the run.  The last line is "N passed, N failed".
set -uo pipefail
set -m  # each command in the background has a process group, as in a terminal, so Ctrl-C reaches it

. "$(dirname "$0")/check.sh"
log=$(mktemp)
run_log=$(mktemp)
trap 'rm -f "$log" "$run_log"' EXIT

# commands BLOCK: those of the first indented block of the README, or of the second one.
commands() {
  awk -v wanted="$1" '
    /^## / { exit }
    /^    [^ ]/ { if (!inside) block++; inside = 1; if (block == wanted) print substr($0, 5); next }
    { inside = 0 }' README.md | sed 's/ *#.*//'
}

# step COMMAND: one pass or failure by its exit status.
step() {
  local begin=$SECONDS status=0
  bash -c "$1" >"$log" 2>&1 </dev/null || status=$?
  result "$status" "$1" "$begin" "$log"
}

# step_beside COMMAND: the same beside the run.  The dog refuses to move until it stands, so a
# command is typed again for a minute.  One that watches shows the joint neck_pan until Ctrl-C, after 5 s.
step_beside() {
  local begin=$SECONDS status limit=60
  case $1 in *--watch*) limit=5 ;; esac
  while true; do
    status=0
    timeout --foreground --signal=INT "$limit" bash -c "exec $1" >"$log" 2>&1 </dev/null || status=$?
    if [ "$limit" -eq 5 ] && [ "$status" -eq 124 ] && grep -q neck_pan "$log"; then status=0; fi
    if [ "$status" -eq 0 ] || [ $((SECONDS - begin)) -ge 60 ]; then break; fi
    kill -0 "$run" 2>/dev/null || break
    sleep 1
  done
  result "$status" "$1" "$begin" "$log"
}

# begin_run COMMAND: types it in the first terminal, and waits until the remote control is there.
begin_run() {
  local begin=$SECONDS status=0
  bash -c "exec $1" >"$run_log" 2>&1 </dev/null &
  run=$!
  until grep -q 'remote control: .*:54000' "$run_log"; do
    if ! kill -0 "$run" 2>/dev/null; then status=1; break; fi
    sleep 1
  done
  result "$status" "$1: from nothing to a run" "$begin" "$run_log"
}

end_run() {
  local begin=$SECONDS status=0
  kill -INT -- "-$run" 2>/dev/null
  wait "$run" || status=$?
  result "$status" "Ctrl-C ends the run" "$begin" "$run_log"
}

if [ "${1:-}" = --list ]; then
  commands 1
  echo
  commands 2
  exit
fi

export HOME=/root DEBIAN_FRONTEND=noninteractive
cd /
step 'apt-get update -q && apt-get install -y -q git'
step 'git clone -q /openr-host.bundle /openr-host'
cd /openr-host || exit 1
mapfile -t first < <(commands 1)
mapfile -t second < <(commands 2)
if [ ${#first[@]} -eq 0 ] || [ ${#second[@]} -eq 0 ]; then
  echo "README.md has no two blocks of commands before its first section"
  failed=$((failed + 1))
fi
for command in "${first[@]}"; do
  if [ "$command" != './dev run' ]; then step "$command"; continue; fi
  begin_run "$command"
  for beside in "${second[@]}"; do step_beside "$beside"; done
  end_run
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
