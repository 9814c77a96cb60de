#!/usr/bin/env bash
# Installs the Debian packages that are named in a list and missing here, such as
# cmake/debian-packages-nightly.txt.  Becomes root by sudo, which must not ask for a password, because
# .ci/nightly runs without a person.
#
#     tools/install_list.sh LIST LOG     the file LOG gets what apt-get prints
set -uo pipefail

names=$(sed 's/#.*//' "$1") || exit 1
missing=()
for package in $names; do
  dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
    missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(sudo -n); fi
# A new container has no lists of packages, so they are fetched first.
if ! { "${as_root[@]}" apt-get update -q &&
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}"; } >"$2" 2>&1; then
  tail -n 5 "$2" >&2
  echo "tools/install_list.sh: ${missing[*]} cannot be installed; all that was said is in $2" >&2
  exit 1
fi
