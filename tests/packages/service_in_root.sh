#!/usr/bin/env bash
# Tests openr-host.service as the first lines of that file tell to use it, in a Debian that systemd
# has booted (tools/service.sh).  The last line is "N passed, N failed".
set -uo pipefail

. "$(dirname "$0")/check.sh"

state=/var/lib/openr-host

# until_true SECONDS COMMAND...: repeats the command until it succeeds; fails after the seconds.
until_true() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.5
  done
}

property() { systemctl show --value --property "$1" openr-host; }

installs() {
  cp /usr/share/openr-host/openr-host.service /etc/systemd/system/ && systemctl enable --now openr-host
}

accepts_commands() { openr rc 127.0.0.1:54000 info | tee /dev/stderr | grep accepting-commands; }
stands() { until_true 120 accepts_commands; }

# The sandbox as the kernel sees it: no root, no capabilities, a filter of system calls.
is_confined() {
  local pid
  pid=$(property MainPID)
  cat "/proc/$pid/status"
  [ "$(stat -c %u "/proc/$pid")" -ne 0 ] && grep -qE '^CapEff:\s*0+$' "/proc/$pid/status" &&
    grep -qE '^NoNewPrivs:\s*1$' "/proc/$pid/status" && grep -qE '^Seccomp:\s*2$' "/proc/$pid/status" &&
    nsenter --target "$pid" --mount touch "$state/made-by-the-test" &&
    ! nsenter --target "$pid" --mount touch /usr/made-by-the-test
}

token_is_secret() {
  ls -lL "$state/token"
  [ "$(stat -L -c %a "$state/token")" = 600 ] && [ "$(stat -L -c %a "$state")" = 700 ] &&
    journalctl -u openr-host --no-pager | grep -F "$state/token" &&
    ! journalctl -u openr-host --no-pager | grep -F "$(head -n 1 "$state/token")"
}

# socket_answer TOKEN: the HTTP status with which the panel answers a page that asks for its socket.
socket_answer() {
  curl --silent --output /dev/null --write-out '%{http_code}' --max-time 3 \
    --header 'Connection: Upgrade' --header 'Upgrade: websocket' --header 'Sec-WebSocket-Version: 13' \
    --header 'Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==' --header "Sec-WebSocket-Protocol: openr.$1" \
    http://127.0.0.1:8210/ws
}

page_wants_token() {
  local with without
  with=$(socket_answer "$(head -n 1 "$state/token")")
  without=$(socket_answer 0123456789abcdef0123456789abcdef)
  echo "with the token $with, with another one $without"
  [ "$with" = 101 ] && [ "$without" = 403 ]
}

other_port_wants_token() {
  cp "$state/token" /root/token && chmod 600 /root/token
  openr rc 127.0.0.1:54100 --token-file /root/token info && ! openr rc 127.0.0.1:54100 info
}

comes_back() {
  local before
  before=$(property MainPID)
  kill -KILL "$before"
  until_true 20 is_another "$before" && stands
}
is_another() { [ "$(property MainPID)" != 0 ] && [ "$(property MainPID)" != "$1" ]; }

stops() {
  local invocation
  invocation=$(property InvocationID)
  systemctl stop openr-host
  journalctl "_SYSTEMD_INVOCATION_ID=$invocation" --no-pager | tail -n 20
  [ "$(property Result)" = success ] && [ "$(property ExecMainStatus)" = 0 ] &&
    journalctl "_SYSTEMD_INVOCATION_ID=$invocation" --no-pager | grep 'ended by pause' && ! pgrep -x openr
}

reads_its_settings() {
  printf 'OPENR_FLAGS=--body ideal --monitor --seed 7\n' >/etc/default/openr-host
  systemctl start openr-host && stands && tr '\0' ' ' <"/proc/$(property MainPID)/cmdline" | grep -- '--seed 7'
}

check 'the service is installed and started' installs
check 'the robot stands and takes commands' stands
check 'the run is confined' is_confined
check 'the token is readable by nobody else and not in the journal' token_is_secret
check 'the page wants the token' page_wants_token
check 'the port for other computers wants the token' other_port_wants_token
check 'the run is started again after it was killed' comes_back
check 'the service stops, and says why the run ended' stops
check '/etc/default/openr-host is read' reads_its_settings
check 'it stops again' stops

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
