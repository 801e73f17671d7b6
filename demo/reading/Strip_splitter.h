// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STRIP_SPLITTER_H
#define INTRINSIC_STRIP_SPLITTER_H

#include "reading/Polygons.h"

#include <array>
#include <cstddef>

// Splits strips, which are sequences of corners. Each corner after the second makes a triangle with
// the two previous ones. The orientation alternates, and a negative index ends a strip.
class Strip_splitter
{
public:
  explicit Strip_splitter(Polygons& polygons) : m_polygons(polygons) {}

  void add_corner(std::size_t index)
  {
    if(index == Polygons::none) {
      m_corners = 0;
      return;
    }
    if(m_corners >= 2)
      add_triangle(index, m_corners % 2 == 1);
    m_last = {m_last[1], index};
    ++m_corners;
  }

private:
  // Adds a triangle. A triangle without area connects parts of a strip.
  void add_triangle(std::size_t index, bool is_reversed)
  {
    if(m_last[0] != m_last[1] && m_last[0] != index && m_last[1] != index)
      m_polygons.push_back(
        std::array{m_last[is_reversed ? 1 : 0], m_last[is_reversed ? 0 : 1], index});
  }

  Polygons& m_polygons;
  std::size_t m_corners = 0;
  std::array<std::size_t, 2> m_last{};
};

#endif // INTRINSIC_STRIP_SPLITTER_H
