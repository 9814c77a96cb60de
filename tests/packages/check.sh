# check() and result(), for scripts that source this file; both count in $passed and $failed.
passed=0
failed=0

# result STATUS NAME BEGIN LOG: one pass or failure of a step that began at second BEGIN.  Prints the
# end of the file LOG if the step has failed.
result() {
  if [ "$1" -eq 0 ]; then
    passed=$((passed + 1))
    echo "ok   $2, $((SECONDS - $3)) s"
  else
    failed=$((failed + 1))
    echo "FAIL $2, $((SECONDS - $3)) s"
    tail -n 40 "$4"
  fi
}

# check NAME COMMAND...: one pass or failure by the exit status of the command.
check() {
  local name=$1 log begin=$SECONDS status=0
  shift
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  result "$status" "$name" "$begin" "$log"
  rm -f "$log"
}
