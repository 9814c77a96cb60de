#!/usr/bin/env bash
# Takes the first steps of the README in a Debian with nothing in it, as a newcomer does, and prints
# how long each takes.  The last line is "N passed, N failed".
#
#   tools/first_steps.sh [--suite NAME] [--mirror URL] [--keep]
#
#   --suite NAME  the Debian (bookworm)
#   --mirror URL  where its packages come from (http://deb.debian.org/debian)
#   --keep        leaves the root there, and says where
#
# What is cloned is the last commit of this checkout.  Needs debootstrap, and root, because of chroot
# and mount.  The root is made in a new folder in /tmp, or what TMPDIR names, and removed at the end.
# It shares the network of this computer, so TCP port 54000 must be free.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

. tools/clean_root.sh

suite=bookworm
read_flags --suite=suite -- "$@"

need_root
begin_roots
root=$roots/$suite
make_root "$root"
# By way of a bundle, because git does not clone a checkout of another user.
git -c safe.directory="$PWD" bundle create -q "$root/openr-host.bundle" HEAD
cp tests/packages/check.sh tests/packages/readme_in_root.sh "$root"
in_root "$root" /readme_in_root.sh
