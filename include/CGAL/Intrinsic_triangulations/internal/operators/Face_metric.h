// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACE_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACE_METRIC_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// A face laid out in its frame: corner 0 at the origin, corner 1 on the x-axis, corner 2 above it.
template <typename FT>
class Face_metric
{
public:
  template <typename Surface>
  Face_metric(Face_index f, const Surface& surface) : m_face(f)
  {
    const auto h = sides(f, surface.mesh());
    for(std::size_t s = 0; s < 3; ++s) {
      m_corner[s] = surface.mesh().source(h[s]);
      m_length[s] = edge_length(h[s], surface);
    }
    m_quadrupled_area = quadrupled_area(m_length[0], m_length[1], m_length[2]);
  }

  Vertex_index corner(std::size_t s) const { return m_corner[s]; }
  const std::array<Vertex_index, 3>& corners() const { return m_corner; }
  // the number of component k of the vector in this face, among those of all faces
  std::size_t component(std::size_t k) const { return 2 * std::size_t(m_face.idx()) + k; }
  FT area() const { return m_quadrupled_area / 4; }
  FT doubled_area() const { return m_quadrupled_area / 2; }

  // the integral of the product of the hat functions of corners a and b
  FT hat_product(std::size_t a, std::size_t b) const { return area() / (a == b ? 6 : 12); }

  // of the corner opposite to side s
  FT cotangent(std::size_t s) const { return corner_product(s) / m_quadrupled_area; }

  // side s turned counterclockwise by a right angle: the gradient of the hat function of the corner
  // opposite to it, times the doubled area
  std::array<FT, 2> turned_side(std::size_t s) const
  {
    const FT width = 2 * m_length[0], height = m_quadrupled_area / width;
    if(s == 0)
      return {FT(0), m_length[0]};
    if(s == 1)
      return {-height, -corner_product(2) / width};
    return {height, -corner_product(1) / width};
  }

  // where the metric has no gradients
  void refuse_if_degenerate() const
  {
    for(std::size_t s = 0; s < 3; ++s)
      if(!(m_quadrupled_area > 0) || !CGAL::is_finite(cotangent(s)))
        throw Numerical_error("the area of face " + std::to_string(m_face.idx()) +
                              " is zero or out of range");
  }

private:
  FT corner_product(std::size_t s) const
  {
    return doubled_corner_product(m_length[s], m_length[(s + 1) % 3], m_length[(s + 2) % 3]);
  }

  Face_index m_face;
  std::array<Vertex_index, 3> m_corner;
  std::array<FT, 3> m_length; // side s leads from corner s to corner s + 1
  FT m_quadrupled_area;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACE_METRIC_H
