// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_RECTANGULAR_BOUNDARY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_RECTANGULAR_BOUNDARY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/maps/Flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Corner_choice.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Boundary_image.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Prescribes boundaries that are rectangles.
class Rectangular_boundary : public Free_shape
{
public:
  // \throws Invalid_input unless the boundary of each component has four vertices for which
  // `is_corner` is true
  Rectangular_boundary(const Intrinsic_triangulations::Intrinsic_triangulation<>& surface,
                       const Map_parameters& parameters)
    : m_mesh(Intrinsic_triangulations::internal::without_maps(surface.mesh()))
  {
    for(Boundary_loop& loop : rectangle_boundaries(m_mesh)) {
      const auto at_corner = [&](Halfedge_index h) {
        return parameters.is_corner[m_mesh.source(h).idx()] != 0;
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

  // Prescribes right angles at corners, and a straight boundary at other vertices.
  void prescribe(std::vector<Vertex_condition>& conditions) const
  {
    constexpr double right_angle = CGAL_PI / 2;
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
