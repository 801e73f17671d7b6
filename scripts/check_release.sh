#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# check_release.sh RELEASE [COMMAND [FILE...]]: runs COMMAND, ./test.sh by default, on what is committed,
# as a user of a bare Debian system of that release would. FILEs are copied beside the sources. Needs root
# and debootstrap. The bare system is kept in build/systems/RELEASE; COMMAND runs in a copy of it,
# build/systems/RELEASE.used, which is left there.
#
# The packages of `cmake --build build --target package`, the installation by pip and the demonstration
# are tried by
#   scripts/check_release.sh bookworm test/packages/install.sh build/packages/*.deb
#   scripts/check_release.sh bookworm test/packages/pip.sh
#   scripts/check_release.sh bookworm ./demo.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
release=${1:?usage: check_release.sh RELEASE [COMMAND [FILE...]]}
command=${2:-./test.sh}
bare=$PWD/build/systems/$release
system=$bare.used

if [[ ! -d $bare ]]; then
  mkdir -p "$(dirname "$bare")"
  rm -rf "$bare.unfinished"
  debootstrap --variant=minbase "$release" "$bare.unfinished"
  mv "$bare.unfinished" "$bare"
fi
rm -rf --one-file-system "$system" # not beyond what an interrupted run has left mounted
cp -a "$bare" "$system"
cp /etc/resolv.conf "$system/etc"
mkdir -p "$system/root/source"
git archive HEAD | tar -x -C "$system/root/source"
[[ $# -le 2 ]] || cp "${@:3}" "$system/root/source"

trap 'umount -R "$system/dev" "$system/sys" "$system/proc"' EXIT
mount -t proc proc "$system/proc"
mount -t sysfs sys "$system/sys"
mount --rbind /dev "$system/dev"
mount --make-rslave "$system/dev"
time env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
  chroot "$system" bash -c "cd /root/source && $command"
