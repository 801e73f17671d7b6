#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails if a source file is not formatted as .clang-format says, or has a line of more than 100
# columns, which it leaves in comments; says where. Exits with 77, which means skipped, with other
# versions of clang-format than the one below: each breaks some lines elsewhere.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=14
clang-format --version | grep -q "version $version\." || {
  echo "check_style: needs clang-format $version"
  exit 77
}
sources=(include src demo python test examples benchmark)
find "${sources[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror
if LC_ALL=C.UTF-8 grep -rnE --include='*.h' --include='*.cpp' '^.{101}' "${sources[@]}"; then
  echo "check_style: lines of more than 100 columns"
  exit 1
fi
