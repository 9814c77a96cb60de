#!/usr/bin/env bash
# Makes the Debian packages and tests them in a clean Debian.  The last line is "N passed, N failed".
#
#   tools/packages.sh [--build DIR] [--only-make] [--suite NAME] [--mirror URL] [--keep]
#
#   --build DIR   the build folder whose files are packed (build/release); what is missing is built
#   --only-make   makes the packages, in DIR/packages, and does not test them
#   --suite NAME  another Debian than that of this machine, such as trixie: everything is built from
#                 the sources there, with its compiler and libraries, and the quick tests are run,
#                 because packages need the libraries they were built with; the packages are then in
#                 DIR/packages-NAME
#   --mirror URL  where the packages of the clean Debian come from (http://deb.debian.org/debian)
#   --keep        leaves the roots there, and says where
#
# To make them for this machine needs dpkg-dev and file.  All else needs debootstrap, and root, because of
# chroot and mount.  Files in DIR belong to the owner of DIR.  The roots are made in a new folder
# in /tmp, or what TMPDIR names, and removed at the end.
set -euo pipefail
stands=$PWD  # where the person stands, to whom a relative DIR belongs
cd "$(dirname "${BASH_SOURCE[0]}")/.."

. tools/clean_root.sh

this_suite=$suite
build=$PWD/build/release
only_make=false
read_flags --build=build --only-make=only_make --suite=suite -- "$@"

# as_owner COMMAND...: as the owner of the build folder, who could not remove files of root.
as_owner() {
  local owner group
  owner=$(stat -c %u "$build") group=$(stat -c %g "$build")
  if [ "$(id -u)" -eq 0 ] && [ "$owner" -ne 0 ]; then
    setpriv --reuid="$owner" --regid="$group" --clear-groups env HOME="$(getent passwd "$owner" | cut -d: -f6)" "$@"
  else
    "$@"
  fi
}

# make_here: the packages of this machine's Debian.
make_here() {
  command -v dpkg-shlibdeps >/dev/null || give_up "dpkg-shlibdeps is missing; install dpkg-dev"
  command -v file >/dev/null || give_up "file is missing, which CPack needs; install file"
  [ -f "$build/CPackConfig.cmake" ] || give_up "$build is no build folder; ./dev build makes one"
  as_owner bash -c 'rm -rf "$1/packages" && cd "$1" && cpack --config CPackConfig.cmake >cpack.log 2>&1' \
    bash "$build" || {
    tail -n 20 "$build/cpack.log" >&2
    give_up "cpack failed; all it said is in $build/cpack.log"
  }
  as_owner rm -rf "$packages/_CPack_Packages"
}

# make_there: the packages of another Debian, from the sources of this checkout.
make_there() {
  make_root "$roots/maker"
  mkdir "$roots/maker/sources"
  # The files of the checkout as they are now, without what was built.
  git -c safe.directory="$PWD" ls-files -z --cached --others --exclude-standard --deduplicate |
    { while IFS= read -r -d '' file; do [ -e "$file" ] && printf '%s\0' "$file"; done || true; } |
    tar --null --files-from=- -cf - | tar --no-same-owner -C "$roots/maker/sources" -xf -
  in_root "$roots/maker" /sources/tests/packages/build_in_root.sh || give_up "the build in Debian $suite failed"
  as_owner rm -rf "$packages"
  as_owner mkdir -p "$packages"
  for file in "$roots"/maker/sources/build/release/packages/*.deb; do
    as_owner tee "$packages/$(basename "$file")" <"$file" >/dev/null
  done
}

case $build in /*) ;; *) build=$stands/$build ;; esac
mkdir -p "$build"
build=$(cd "$build" && pwd)
if [ "$suite" = "$this_suite" ]; then packages=$build/packages; else packages=$build/packages-$suite; fi
if ! $only_make || [ "$suite" != "$this_suite" ]; then
  need_root
fi
begin_roots
if [ "$suite" = "$this_suite" ]; then make_here; else make_there; fi
ls -sh "$packages" >&2
if $only_make; then exit; fi

root=$roots/$suite
make_root "$root"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r tests/packages/. "$root/packages"
in_root "$root" /packages/in_clean_root.sh
