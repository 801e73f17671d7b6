#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails if a source file is not formatted as .clang-format says; says where. Exits with 77, which means
# skipped, with other versions of clang-format than the one below: each breaks some lines elsewhere.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=14
clang-format --version | grep -q "version $version\." || {
  echo "check_style: needs clang-format $version"
  exit 77
}
find include demo test examples benchmark \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror
