#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# check_sanitizers.sh [python | CTEST_ARGUMENT...]: builds the program, the unit tests and the package
# for Python with the sanitizers for addresses and undefined behaviour, and runs the tests; arguments are
# passed to ctest (-R Refine). Then the program reads FUZZ_RUNS damaged files, 100,000 if that is not
# set, from number FUZZ_FIRST on; those on which it fails are left in build/sanitizers/fuzz. With
# `python`, only the package for Python is built and tested, also on malformed arrays. Tests of Python
# run without other arguments only; memory that Python never frees does not count. Slow. Dynamic types
# are not checked, since CGAL's arrangements, which tests compare with, cast faces to another class; nor
# are shifts of negative numbers, with which CGAL's MP_Float computes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
targets=(intrinsic_python)
[[ ${1:-} == python ]] || targets+=(intrinsic fuzz_server unit_tests)

test_python()
{
  local libraries
  libraries="$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libubsan.so)"
  LD_PRELOAD=$libraries ASAN_OPTIONS=detect_leaks=0 \
    ctest --test-dir build/sanitizers --output-on-failure -R '^python[.]' "$@"
}

scripts/set_up.sh
cmake -S . -B build/sanitizers -G Ninja -DCMAKE_BUILD_TYPE=Debug \
  -DCGAL_DATA_DIR="$PWD/build/cgal_data" \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -fno-omit-frame-pointer \
-fsanitize=address,undefined -fno-sanitize=vptr,shift-base -fno-sanitize-recover=undefined"
cmake --build build/sanitizers --target "${targets[@]}"
export UBSAN_OPTIONS=print_stacktrace=1
if [[ ${1:-} == python ]]; then
  # The others start the program, or need the memory and the time of a build without sanitizers.
  test_python -E '[.](program|running|docstrings|tutorials)$'
  exit
fi
# The other tests use other programs and packages, build or check text.
ctest --test-dir build/sanitizers --output-on-failure -j2 \
  -E '^((clang|compiled|consumer|doc|example|packages|prose|python|without_GMP)([._].*)?|demo[.]fuzz)$' "$@"
[[ $# -gt 0 ]] || test_python
python3 test/demo/fuzz.py build/sanitizers/demo/fuzz_server build/cgal_data --server \
  --runs "${FUZZ_RUNS:-100000}" --first "${FUZZ_FIRST:-0}" --keep build/sanitizers/fuzz
