#!/usr/bin/env bash
# Installs the Debian package openr-host in a clean Debian, boots that Debian with systemd in a
# container, and tests openr-host.service there.  The last line is "N passed, N failed".
#
#   tools/service.sh [--packages DIR] [--mirror URL] [--keep]
#
#   --packages DIR  the packages (build/release/packages, made by tools/packages.sh --only-make)
#   --mirror URL    where the packages of the clean Debian come from (http://deb.debian.org/debian)
#   --keep          leaves the root there, and says where
#
# Needs debootstrap, systemd-nspawn (package systemd-container) and root.  The container has a
# network of its own, so a run on this computer does not disturb it.
set -euo pipefail
stands=$PWD  # where the person stands, to whom a relative DIR belongs
cd "$(dirname "${BASH_SOURCE[0]}")/.."

. tools/clean_root.sh

packages=$PWD/build/release/packages
read_flags --packages=packages -- "$@"
case $packages in /*) ;; *) packages=$stands/$packages ;; esac

need_root
command -v systemd-nspawn >/dev/null || give_up "systemd-nspawn is missing; apt-get install systemd-container"
package=$(find "$packages" -maxdepth 1 -name 'openr-host_*.deb' 2>/dev/null | head -n 1) || true
[ -n "$package" ] || give_up "$packages has no package openr-host; tools/packages.sh --only-make makes it"

begin_roots
root=$roots/$suite
make_root "$root"
mkdir "$root/packages"
cp "$package" tests/packages/check.sh tests/packages/service_in_root.sh "$root/packages"
cat >"$roots/install.sh" <<'INSTALL'
export DEBIAN_FRONTEND=noninteractive
apt-get update -q && apt-get install -y -q systemd-sysv dbus curl /packages/openr-host_*.deb
INSTALL
cp "$roots/install.sh" "$root/packages"
in_root "$root" /packages/install.sh >"$roots/install.log" 2>&1 || {
  tail -n 20 "$roots/install.log" >&2
  give_up "the packages cannot be installed"
}

container=
end_container() {
  [ -z "$container" ] || kill "$container" 2>/dev/null || true
  wait
  end_roots
}
trap end_container EXIT
systemd-nspawn --boot --directory="$root" --machine="openr-host-$$" --private-network --register=no \
  --keep-unit --console=pipe </dev/null >"$roots/boot.log" 2>&1 &
container=$!

# The first process of the container, in whose namespaces the checks run.
first=
for ((i = 0; i < 100 && ${#first} == 0; i++)); do
  sleep 0.2
  first=$(pgrep --parent "$container" | head -n 1) || true
done
[ -n "$first" ] || { cat "$roots/boot.log" >&2; give_up "the container has not started"; }
in_container() { nsenter --target "$first" --all --root --wd "$@"; }

# systemctl can talk to systemd only some time after the container has started.
state=
for ((i = 0; i < 150; i++)); do
  state=$(in_container systemctl is-system-running 2>/dev/null) || true
  if [ "$state" = running ] || [ "$state" = degraded ]; then break; fi
  sleep 0.2
done
[ "$state" = running ] || [ "$state" = degraded ] || give_up "systemd is not ready after 30 s: $state"
in_container env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 bash /packages/service_in_root.sh
