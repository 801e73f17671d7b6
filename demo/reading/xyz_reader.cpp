// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/format_readers.h"

void read_xyz(Scanner& in, Polygon_soup& soup)
{
  for(in.skip_comments('#'); !in.at_end(); in.skip_comments('#')) {
    const double x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
    soup.points.emplace_back(x, y, z);
    in.skip_line(); // normals or colors
  }
}
