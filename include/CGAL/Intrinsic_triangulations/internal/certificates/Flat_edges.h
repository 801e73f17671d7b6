// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLAT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLAT_EDGES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Determines the edges of T1 whose two faces are coplanar and lie side by side.
class Flat_edges
{
public:
  Flat_edges(const std::vector<Position>& points, const Delta_complex& mesh)
    : m_points(points), m_mesh(mesh)
  {}

  // Returns whether the edge of `h`, which is not on the boundary, is flat. Returns false without
  // positions.
  bool operator()(Halfedge_index h)
  {
    return !m_points.empty() && m_is_flat(std::size_t(Edge_index(h).idx()), [&] {
      const auto [i, j, k, l] = corner_positions(h, m_points, m_mesh);
      return is_flat_in_space(i, j, k, l);
    });
  }

private:
  const std::vector<Position>& m_points;
  const Delta_complex& m_mesh;
  Direct_mapped_cache<bool> m_is_flat;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLAT_EDGES_H
