#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Builds the program and the unit tests with the sanitizers for addresses and undefined behaviour,
# and runs the tests; arguments are passed to ctest (-R Refine). Then the program reads FUZZ_RUNS
# damaged files, 100,000 if that is not set; those on which it fails are left in build/sanitizers/fuzz.
# Slow. Dynamic types are not checked, since CGAL's arrangements, which tests compare with, cast faces
# to another class; nor are shifts of negative numbers, with which CGAL's MP_Float computes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/set_up.sh
cmake -S . -B build/sanitizers -G Ninja -DCMAKE_BUILD_TYPE=Debug \
  -DCGAL_DATA_DIR="$PWD/build/cgal_data" \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -fno-omit-frame-pointer \
-fsanitize=address,undefined -fno-sanitize=vptr,shift-base -fno-sanitize-recover=undefined"
cmake --build build/sanitizers --target intrinsic unit_tests
# The other tests build or check text; those of Python would need the libraries of the sanitizers.
UBSAN_OPTIONS=print_stacktrace=1 ctest --test-dir build/sanitizers --output-on-failure -j2 \
  -E '^(clang.*|consumer[.].*|doc|python[.].*)$' "$@"
python3 test/demo/fuzz.py build/sanitizers/intrinsic build/cgal_data --runs "${FUZZ_RUNS:-100000}" \
  --keep build/sanitizers/fuzz
