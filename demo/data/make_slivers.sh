#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes slivers.off beside itself: a torus with three lobes, whose grid of long, unevenly spaced
# triangles is wound around the tube.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

awk -v m=60 -v n=22 -v turns=9 '
  BEGIN {
    pi = atan2(0, -1)
    print "OFF"
    print m * n, 2 * m * n, 0
    for (i = 0; i < m; ++i)
      for (j = 0; j < n; ++j) {
        u = 2 * pi * i / m
        v = 2 * pi * (j / n + turns * i / m)
        v += 0.8 * sin(v)
        r = 1 + 0.25 * cos(3 * u)
        printf "%.6f %.6f %.6f\n", (3 + r * cos(v)) * cos(u), (3 + r * cos(v)) * sin(u), r * sin(v)
      }
    for (i = 0; i < m; ++i)
      for (j = 0; j < n; ++j) {
        a = i * n + j
        b = i * n + (j + 1) % n
        c = (i + 1) % m * n + j
        d = (i + 1) % m * n + (j + 1) % n
        print 3, a, c, d
        print 3, a, d, b
      }
  }' >slivers.off
