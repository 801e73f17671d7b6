# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Functions that use installed packages, for the other scripts of this directory.

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

fail()
{
  echo "packages: $*" >&2
  exit 1
}

version()
{
  sed -n 's/^project(.* VERSION \([0-9.]*\) .*/\1/p' "$source_dir/CMakeLists.txt"
}

# An application finds the packages below PREFIX, is compiled, and runs.
use_headers()
{
  local prefix=$1 build=$2 target=consumer_of_compiled
  [[ -f $prefix/lib/libCGAL_intrinsic_triangulations.a ]] || target=consumer
  ! command -v ninja >/dev/null || export CMAKE_GENERATOR=Ninja
  mkdir -p "$build"
  { cmake -S "$source_dir/test/consumer" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" &&
    cmake --build "$build" --target $target; } >"$build/log" 2>&1 ||
    { cat "$build/log"; fail "the application has not been compiled"; }
  grep -q "^CGAL_intrinsic_triangulations_DIR:PATH=$prefix/" "$build/CMakeCache.txt" ||
    fail "CMake has found another installation"
  "$build/$target" | grep -qx "1 flip" || fail "the application does not flip an edge"
}

# The program knows its version, and flips the long diagonal of a quadrilateral.
use_program()
{
  local prefix=$1 work=$2
  printf '%s\n' OFF '4 2 0' '-2 0 0' '0 -1 0' '2 0 0' '0 1 0' '3 0 1 2' '3 0 2 3' >"$work/thin.off"
  "$prefix/bin/intrinsic" --version | grep -qF "$(version)" || fail "the program has another version"
  "$prefix/bin/intrinsic" info "$work/thin.off" >/dev/null || fail "info has failed"
  "$prefix/bin/intrinsic" delaunay "$work/thin.off" -o "$work/flipped.off" --stats "$work/stats.json" >/dev/null ||
    fail "delaunay has failed"
  grep -qE '"flips": *1\b' "$work/stats.json" || fail "the program does not flip an edge"
}

# Debian's interpreter imports the package from PREFIX, and flips the same diagonal.
use_python()
{
  local prefix=$1
  (cd / && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$prefix/lib/python3/dist-packages \
    /usr/bin/python3 - "$prefix" <<'PYTHON') || fail "Python does not use its package"
import sys
import intrinsic

assert intrinsic.__file__.startswith(sys.argv[1]), intrinsic.__file__
T = intrinsic.Triangulation([[-2, 0, 0], [0, -1, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
assert T.delaunay() == 1
PYTHON
}

# use_packages PREFIX WORK: uses what has been installed below PREFIX; WORK is for temporary files.
use_packages()
{
  use_headers "$1" "$2"
  if [[ -e $1/bin/intrinsic ]]; then use_program "$1" "$2"; else echo "packages: no program"; fi
  if [[ -d $1/lib/python3/dist-packages/intrinsic ]]; then
    use_python "$1"
  else
    echo "packages: no package for Python"
  fi
}
