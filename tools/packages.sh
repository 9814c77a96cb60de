#!/usr/bin/env bash
# Makes the Debian packages and tests them in a clean Debian.  The last line is "N passed, N failed".
#
#   tools/packages.sh [--build DIR] [--only-make] [--suite NAME] [--mirror URL] [--fresh] [--keep]
#
#   --build DIR   the build folder whose files are packed (build/release); what is missing is built
#   --only-make   makes the packages, in DIR/packages, and does not test them
#   --suite NAME  Debian of the clean root; default: that of this machine, since the packages need
#                 the libraries they were built with
#   --mirror URL  where its packages come from (http://deb.debian.org/debian)
#   --fresh       makes the root anew; without it the one of the last time is unpacked again
#   --keep        leaves the root there, and says where
#
# To make them needs dpkg-dev.  To test them needs debootstrap, and root, because of chroot and
# mount; nothing outside of DIR is changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/release
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")
mirror=http://deb.debian.org/debian
only_make=false
fresh=false
keep=false
while [ $# -gt 0 ]; do
  case $1 in
    --build) build=$2; shift ;;
    --suite) suite=$2; shift ;;
    --mirror) mirror=$2; shift ;;
    --only-make) only_make=true ;;
    --fresh) fresh=true ;;
    --keep) keep=true ;;
    *) sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
  shift
done

say() { echo "packages: $*" >&2; }
give_up() { say "$*"; exit 1; }

command -v dpkg-shlibdeps >/dev/null || give_up "dpkg-shlibdeps is missing; install dpkg-dev"
[ -f "$build/CPackConfig.cmake" ] || give_up "$build is no build folder; ./dev build makes one"
build=$(cd "$build" && pwd)
packages=$build/packages
rm -rf "$packages"
(cd "$build" && cpack --config CPackConfig.cmake >"$build/cpack.log" 2>&1) || {
  tail -n 20 "$build/cpack.log" >&2
  give_up "cpack failed; all it said is in $build/cpack.log"
}
rm -rf "$packages/_CPack_Packages"
ls -sh "$packages" >&2
if $only_make; then exit; fi

[ "$(id -u)" -eq 0 ] || give_up "a clean root needs chroot and mount: call this as root (sudo)"
command -v debootstrap >/dev/null || give_up "debootstrap is missing; apt-get install debootstrap"

base=$build/roots/$suite.tar
mkdir -p "$build/roots"
if $fresh; then rm -f "$base"; fi
root=$(mktemp -d "$build/roots/$suite.XXXXXX")
chmod 755 "$root"
clean_up() {
  if $keep; then say "the root is $root"; else rm -rf "$root"; fi
}
trap clean_up EXIT
if [ ! -f "$base" ]; then
  say "making a root of Debian $suite"
  debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$build/debootstrap.log" 2>&1 ||
    give_up "debootstrap failed; all it said is in $build/debootstrap.log"
  tar -C "$root" -cf "$base.new" . && mv "$base.new" "$base"
else
  tar -C "$root" -xf "$base"
fi

mkdir "$root/packages"
cp "$packages"/*.deb tests/packages/*.sh "$root/packages"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
# Mounts and processes of the root end with it.
unshare --mount --pid --fork bash -c '
  mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && mount -t tmpfs tmpfs "$1/run" &&
    exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb chroot "$1" bash /packages/in_clean_root.sh
' bash "$root"
