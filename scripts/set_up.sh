#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# set_up.sh [program|tests]: installs the Debian packages that are missing and unpacks CGAL's data files
# into build/cgal_data. For `program`, only what building and using the program `intrinsic` takes; for
# `tests`, the default, what all tests take. Does nothing, quickly, when all is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# ca-certificates is for fetching three.js.
packages=(
  g++ cmake ninja-build python3 ca-certificates
  libcgal-dev libcgal-demo libeigen3-dev libgmp-dev libmpfr-dev
  libsuitesparse-dev libopenblas0-serial libtbb-dev libcli11-dev nlohmann-json3-dev libcairo2-dev)
# Chromium is for the tests of pages.
test_packages=(
  clang clang-format ccache dpkg-dev file doxygen libjs-mathjax libceres-dev libgtest-dev libopenmesh-dev
  pybind11-dev python3-dev python3-meshio python3-scipy mypy chromium fonts-dejavu-core)
data_archive=/usr/share/doc/libcgal-dev/data.tar.gz
data_dir=build/cgal_data
log=$PWD/build/set_up.log

case ${1:-tests} in
  program) ;;
  tests) packages+=("${test_packages[@]}") ;;
  *) echo "usage: set_up.sh [program|tests]" >&2; exit 2 ;;
esac

fail()
{
  echo "set_up: $*" >&2
  exit 1
}

is_installed()
{
  [[ "$(dpkg-query -W -f '${Status}' "$1" 2>/dev/null)" == *" installed" ]]
}

# Runs a command quietly; its output is shown only if it fails.
quietly()
{
  "$@" >"$log" 2>&1 || { tail -n 20 "$log" >&2; fail "failed: $* (output in $log)"; }
}

as_root()
{
  if [[ $EUID -eq 0 ]]; then "$@"; else sudo "$@"; fi
}

install_packages()
{
  [[ $EUID -eq 0 ]] || command -v sudo >/dev/null ||
    fail "neither root nor sudo; please install: $*"
  echo "set_up: installing $# packages: $*"
  quietly as_root apt-get update
  quietly as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends "$@"
}

# Slim images do not keep /usr/share/doc: then the archive comes from the package itself.
print_data_archive()
{
  if [[ -f $data_archive ]]; then
    cat "$data_archive"
  else
    (cd build && quietly apt-get download libcgal-demo)
    dpkg-deb --fsys-tarfile build/libcgal-demo_*.deb | tar -xO ".$data_archive"
  fi
}

unpack_data()
{
  local unfinished=$data_dir.unfinished
  rm -rf "$unfinished"
  mkdir -p "$unfinished"
  print_data_archive | tar -xz -C "$unfinished" --strip-components=1 data/meshes ||
    fail "cannot unpack CGAL's data files"
  mv "$unfinished" "$data_dir"
}

mkdir -p build

if command -v dpkg-query >/dev/null; then
  missing=()
  for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] || install_packages "${missing[@]}"
  [[ -d $data_dir ]] || unpack_data
else
  echo "set_up: not a Debian system; these packages must be there: ${packages[*]}" >&2
fi
