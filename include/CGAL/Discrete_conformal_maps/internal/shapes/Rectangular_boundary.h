// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_RECTANGULAR_BOUNDARY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_RECTANGULAR_BOUNDARY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/maps/Flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Boundary_image.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Chooses the corners of a rectangle among the vertices of a loop.
class Corner_choice
{
public:
  typedef std::vector<std::size_t> Corners; // places on the loop

  // `angle` holds the exterior angles, `length` the lengths of the edges that start at the vertices
  Corner_choice(std::vector<double> angle, const std::vector<double>& length)
    : m_length(std::accumulate(length.begin(), length.end(), 0.)),
      m_angle(std::move(angle)),
      m_place(length.size()),
      m_order(length.size())
  {
    std::exclusive_scan(length.begin(), length.end(), m_place.begin(), 0.);
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t i, std::size_t j) { return m_angle[i] > m_angle[j]; });
  }

  // Returns four positions in ascending order, as far apart along the loop as possible. The sum of
  // their exterior angles must be at least nine tenths of the sum of the four sharpest.
  Corners corners() const
  {
    Corners result = sharpest_at_distance(0);
    const double least = total_angle(result) - std::abs(total_angle(result)) / 10;
    for(double distance = m_length / 4; distance > 1e-3 * m_length; distance *= 0.9)
      if(Corners c = sharpest_at_distance(distance); c.size() == 4 && total_angle(c) >= least) {
        result = std::move(c);
        break;
      }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  // Returns up to four places, each the sharpest that is so far from those before.
  Corners sharpest_at_distance(double distance) const
  {
    Corners result;
    for(const std::size_t i : m_order) {
      const bool is_far = std::all_of(result.begin(), result.end(), [&](std::size_t j) {
        return this->distance(i, j) >= distance;
      });
      if(is_far && result.size() < 4)
        result.push_back(i);
    }
    return result;
  }

  double distance(std::size_t i, std::size_t j) const
  {
    const double d = std::abs(m_place[i] - m_place[j]);
    return (std::min)(d, m_length - d);
  }

  double total_angle(const Corners& corners) const
  {
    return std::accumulate(corners.begin(), corners.end(), 0.,
                           [&](double sum, std::size_t i) { return sum + m_angle[i]; });
  }

  double m_length;
  std::vector<double> m_angle, m_place;
  std::vector<std::size_t> m_order; // the sharpest first
};

inline std::vector<Boundary_loop> rectangle_boundaries(const Delta_complex& mesh)
{
  return single_boundary_loops(mesh, 4, "the corners of a rectangle");
}

// Boundaries that are rectangles.
class Rectangular_boundary : public Free_shape
{
public:
  // \throws Invalid_input if the boundary of a component has not four vertices for which
  //   `is_corner` is true
  Rectangular_boundary(const Delta_complex& mesh, const std::vector<char>& is_corner)
    : m_mesh(Intrinsic_triangulations::internal::without_maps(mesh))
  {
    for(Boundary_loop& loop : rectangle_boundaries(m_mesh)) {
      const auto at_corner = [&](Halfedge_index h) {
        return is_corner[m_mesh.source(h).idx()] != 0;
      };
      const auto corners = std::count_if(loop.begin(), loop.end(), at_corner);
      if(corners != 4)
        throw Intrinsic_triangulations::Invalid_input(
          "a rectangle has four corners, but a boundary has " + std::to_string(corners));
      std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), at_corner), loop.end());
      m_rectangles.emplace_back();
      for(Halfedge_index h : loop) {
        if(at_corner(h))
          m_rectangles.back().emplace_back();
        m_rectangles.back().back().push_back(h);
      }
    }
  }

  // Makes corners right angles, and the rest straight.
  void prescribe(std::vector<Vertex_condition>& conditions) const
  {
    constexpr double right_angle = boost::math::constants::half_pi<double>();
    for(const Rectangle& sides : m_rectangles)
      for(const Boundary_loop& side : sides)
        for(Halfedge_index h : side)
          conditions[m_mesh.source(h).idx()] =
            Vertex_condition::curvature(h == side.front() ? right_angle : 0);
  }

  std::vector<Map_promise> promises(const Planar_conformal_map& map,
                                    const std::vector<char>& is_whole) const
  {
    const Boundary_image image(map);
    const Intrinsic_triangulations::Mesh_components components(m_mesh);
    double straightness = 0, cosine = 0;
    for(const Rectangle& sides : m_rectangles) {
      if(!is_whole[components[corner(sides[0]).idx()]])
        continue;
      for(std::size_t s = 0; s < 4; ++s) {
        straightness = greater_error(straightness, image.straightness_error(sides[s], m_mesh));
        cosine = greater_error(cosine, image.cosine(corner(sides[s]), corner(sides[(s + 1) % 4]),
                                                    corner(sides[(s + 2) % 4])));
      }
    }
    return {
      {"straight_sides", straightness, tolerance::promised_length, Map_status::not_rectangular},
      {"right_angles", cosine, tolerance::promised_length, Map_status::not_rectangular}};
  }

private:
  typedef std::vector<Boundary_loop> Rectangle; // its sides

  Vertex_index corner(const Boundary_loop& side) const { return m_mesh.source(side.front()); }

  Delta_complex m_mesh;
  std::vector<Rectangle> m_rectangles;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_RECTANGULAR_BOUNDARY_H
