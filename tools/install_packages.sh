#!/usr/bin/env bash
# Installs the Debian packages that are named in lists, such as cmake/debian-packages.txt, and
# missing here.  What apt-get prints goes to standard error.
#
#     tools/install_packages.sh LIST...
#
# Another user than root becomes root by sudo, which asks for a password only on a terminal,
# because .ci/nightly runs without a person.
set -euo pipefail

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
    echo "these packages are missing; as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
  if [ ! -t 0 ]; then as_root=(sudo -n); fi
fi
echo "installing ${missing[*]}" >&2
# A new container has no lists of packages, so they are fetched first.
if ! { "${as_root[@]}" apt-get update -q &&
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}"; } >&2; then
  echo "${missing[*]} cannot be installed; apt-get says above why" >&2
  exit 1
fi
