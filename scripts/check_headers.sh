#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Compiles every header that users include on its own. Slow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/set_up.sh
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
cmake --build build --target headers
