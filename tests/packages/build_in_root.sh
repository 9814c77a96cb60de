#!/usr/bin/env bash
# Builds the sources in /sources and makes the packages, in a root of another Debian that has
# nothing else (tools/packages.sh --suite).  Fails if something does not compile or a test fails.
set -euo pipefail
cd /sources

step() { echo "packages: $*, after $SECONDS s" >&2; }

export DEBIAN_FRONTEND=noninteractive
apt-get update -q >/dev/null
apt-get install -y -q --no-install-recommends dpkg-dev file >/dev/null
step "building, and running the quick tests"
./dev test --quick >/tmp/quick.log 2>&1 || {
  tail -n 60 /tmp/quick.log >&2
  exit 1
}
tail -n 1 /tmp/quick.log
cd build/release
step "packing"
cpack --config CPackConfig.cmake >/tmp/cpack.log 2>&1 || {
  tail -n 20 /tmp/cpack.log >&2
  exit 1
}
step "the packages are made"
