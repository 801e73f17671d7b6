#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# check_release.sh RELEASE [COMMAND [FILE...]]: runs COMMAND, ./test.sh by default, on what is committed,
# as a user of a bare Debian system of that release would. FILEs are copied beside the sources. Needs root
# and debootstrap. The system is made anew unless build/systems/RELEASE is there.
#
# The packages of `cmake --build build --target package` are tried in a bare system by
#   scripts/check_release.sh bookworm test/packages/install.sh build/packages/*.deb
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
release=${1:?usage: check_release.sh RELEASE [COMMAND [FILE...]]}
command=${2:-./test.sh}
system=$PWD/build/systems/$release

if [[ ! -d $system ]]; then
  mkdir -p "$(dirname "$system")"
  debootstrap --variant=minbase "$release" "$system.unfinished"
  mv "$system.unfinished" "$system"
fi
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
