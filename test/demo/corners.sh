#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Barycentric coordinates belong to the corners of a face in the order of the file.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"
python3 "$tests/corners.py" "$program" || fail 'coordinates belong to other corners'
