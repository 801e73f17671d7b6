#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails if a source file is not formatted as .clang-format says; says where.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
find include demo test examples benchmark \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror
