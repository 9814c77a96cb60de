#!/usr/bin/env bash
# Installs the Debian packages that are named in lists, such as cmake/debian-packages.txt, and
# missing here.  What apt-get prints goes to standard error.
#
#     tools/install_packages.sh [--no-questions] LIST...
#
# Another user than root becomes root by sudo, which may ask for a password.  With --no-questions
# sudo fails instead, because .ci/nightly runs without a person.
set -euo pipefail

say() { echo "install_packages: $*" >&2; }

sudo=(sudo)
if [ "${1:-}" = --no-questions ]; then
  sudo=(sudo -n)
  shift
fi
if [ $# -eq 0 ]; then
  say "usage: tools/install_packages.sh [--no-questions] LIST..."
  exit 2
fi
names=$(sed 's/#.*//' "$@")
missing=()
for package in $names; do
  dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
    missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    say "these packages are missing; as root: apt-get install ${missing[*]}"
    exit 1
  fi
  as_root=("${sudo[@]}")
fi
say "installing ${missing[*]}"
# A new container has no lists of packages, so they are fetched first.
if ! { "${as_root[@]}" apt-get update -q &&
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}"; } >&2; then
  say "${missing[*]} cannot be installed; the reason stands above"
  exit 1
fi
