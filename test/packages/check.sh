#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# check.sh BUILD: makes the Debian packages from what BUILD has built, unpacks them into a fresh
# directory, and uses them from there. Exits with 77, which means skipped, if Debian's tools are missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "${1:?usage: check.sh BUILD}" && pwd)
. "$here/use.sh"

for tool in cpack dpkg-deb dpkg-shlibdeps file; do
  command -v $tool >/dev/null || { echo "packages: $tool is missing"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cpack --config "$build/CPackConfig.cmake" -B "$work/packages" >"$work/log" 2>&1 ||
  { cat "$work/log"; fail "cpack has failed"; }
for package in "$work"/packages/*.deb; do
  name=$(dpkg-deb -f "$package" Package)
  dpkg-deb -x "$package" "$work/root"
  [[ $(dpkg-deb -f "$package" Version) == "$(version)"-* ]] || fail "$name has another version"
  [[ -n $(dpkg-deb -f "$package" Depends) ]] || fail "$name depends on nothing"
  for file in copyright changelog.gz changelog.Debian.gz; do
    [[ -s $work/root/usr/share/doc/$name/$file ]] || fail "$name has no $file"
  done
done
# No file belongs to two packages.
for package in "$work"/packages/*.deb; do
  dpkg-deb -c "$package" | awk '$1 !~ /^d/ {print $6}'
done | sort | uniq -d >"$work/shared"
[[ ! -s $work/shared ]] || fail "files of several packages: $(cat "$work/shared")"

use_packages "$work/root/usr" "$work/consumer"
