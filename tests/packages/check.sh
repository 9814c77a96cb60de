# check(), for scripts that source this file; it counts in $passed and $failed.
passed=0
failed=0

# check NAME COMMAND...: one pass or failure by the exit status; what a failure said is printed.
check() {
  local name=$1 log begin=$SECONDS
  shift
  log=$(mktemp)
  if "$@" >"$log" 2>&1; then
    passed=$((passed + 1))
    echo "ok   $name, $((SECONDS - begin)) s"
  else
    failed=$((failed + 1))
    echo "FAIL $name"
    tail -n 40 "$log"
  fi
  rm -f "$log"
}
