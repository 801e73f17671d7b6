// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_BRUTE_FORCE_H
#define INTRINSIC_TRIANGULATIONS_TEST_BRUTE_FORCE_H

#include "generators.h"

// This file counts on flat surfaces, in integers.
namespace Test_surfaces {

struct Segment
{
  Vector source, vector;
};

inline int sign(std::int64_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

// Whether the open segments have one point in common.
inline bool cross(const Segment& s, const Segment& t)
{
  const Vector d = t.source - s.source;
  return sign(det(s.vector, d)) * sign(det(s.vector, d + t.vector)) < 0 &&
         sign(det(t.vector, -d)) * sign(det(t.vector, s.vector - d)) < 0;
}

inline std::int64_t floor_of_ratio(std::int64_t p, std::int64_t q)
{
  return p / q - (p % q != 0 && (p < 0) != (q < 0));
}

// Stores the ranges of i and j for which the translate t + i a + j b can meet s.
struct Lattice_range
{
  std::int64_t first, last;

  // Constructs the range over the corners p, p + v, p - w, p + v - w of all differences of points
  // of s and t.
  Lattice_range(const std::array<std::int64_t, 3>& p_v_w, std::int64_t determinant)
  {
    const auto [p, v, w] = p_v_w;
    const std::array<std::int64_t, 4> corners{p, p + v, p - w, p + v - w};
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    first = floor_of_ratio(*low, determinant);
    last = floor_of_ratio(*high, determinant) + 1;
  }
};

// Returns how often s crosses all translates of t.
inline std::int64_t count_crossings(const Segment& s, const Segment& t, const Flat_surface& surface)
{
  const Vector a = surface.a, b = surface.b, d = s.source - t.source;
  const Lattice_range along_a({det(d, b), det(s.vector, b), det(t.vector, b)}, det(a, b));
  const Lattice_range along_b({det(a, d), det(a, s.vector), det(a, t.vector)}, det(a, b));
  std::int64_t count = 0;
  for(std::int64_t i = along_a.first; i <= along_a.last; ++i)
    for(std::int64_t j = along_b.first; j <= along_b.last; ++j)
      count += cross(s, {t.source + i * a + j * b, t.vector});
  return count;
}

// Whether u comes before v, counterclockwise from the direction d.
inline bool is_before(const Vector& d, const Vector& u, const Vector& v)
{
  const auto in_second_half = [&](const Vector& w) {
    return det(d, w) < 0 || (det(d, w) == 0 && dot(d, w) < 0);
  };
  return in_second_half(u) != in_second_half(v) ? in_second_half(v) : det(u, v) > 0;
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_BRUTE_FORCE_H
