#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# check_clang.sh [DIR [TARGET...]]: what g++ accepts, clang++ compiles too, in the directory
# build/clang by default, with the same warnings as errors. Not optimised, and the unit tests without
# code, since only the diagnostics matter.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
dir=${1:-build/clang}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(intrinsic headers examples unit_tests_syntax)
cmake -S . -B "$dir" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
cmake --build "$dir" --target "${targets[@]}"
