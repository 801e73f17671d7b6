// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_POINTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_POINTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Input_part.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Number_lists.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Orientation_repair.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the images of the corners or vertices of an input part, rounded to `double`, with the reversed
/// faces (\ref dcm_reversed).
///
/// \tparam Point the type of points
template <typename Point>
struct Rounded_points
{
  std::vector<Point> points; ///< the points
  /// the faces of the subdivision with three corners that turn right in the order of the boundary
  std::vector<Face_index> reversed_faces;
};

namespace internal {

// Moves points until no face of a part is reversed, if this is possible. `index(h)` is the index of
// the point at the target of `h`.
template <std::size_t dimension, typename Index>
Rounded_points<std::array<double, dimension>>
without_reversed_faces(std::vector<std::array<double, dimension>> points, const Input_part& part,
                       const Index& index)
{
  Number_lists corners;
  for(Face_index f : part.faces()) {
    for(Halfedge_index h : CGAL::halfedges_around_face(part.mesh().halfedge(f), part.mesh()))
      corners.add(index(h));
    corners.close();
  }
  Rounded_points<std::array<double, dimension>> result{std::move(points), {}};
  for(std::size_t n : Orientation_repair<dimension>(result.points, corners).run())
    result.reversed_faces.push_back(part.faces()[n]);
  return result;
}

// Returns the images of the corners of a part, `image(z)` for homogeneous coordinates `z`.
template <typename Map, typename Image>
auto rounded_corners(const Map& map, const Input_part& part, const Texture_corners& corners,
                     const Image& image)
{
  std::vector<decltype(image(map.homogeneous_coordinates({})))> points;
  points.reserve(corners.size());
  for(std::size_t n = 0; n < corners.size(); ++n)
    points.push_back(image(
      map.homogeneous_coordinates(part.subdivision().location(Layer::C, corners.halfedge(n)))));
  return without_reversed_faces(std::move(points), part,
                                [&](Halfedge_index h) { return corners.index(h); });
}

inline std::array<double, 2> coordinates(const std::complex<double>& z)
{
  return {z.real(), z.imag()};
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the images \f$(x, y)\f$ in the plane of the corners of a part, in their order. They are
/// rounded such that no face is reversed, if that is possible (\ref dcm_reversed). Complexity:
/// linear if rounding reverses no face.
/// \pre `map.is_laid_out()`
inline Rounded_points<std::array<double, 2>> texture_points(const Planar_conformal_map& map,
                                                            const Input_part& part,
                                                            const Texture_corners& corners)
{
  return internal::rounded_corners(map, part, corners, [](const std::array<double, 3>& z) {
    return internal::coordinates(Planar_conformal_map::to_plane(z));
  });
}

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the homogeneous coordinates of the images of the corners of a part, in their order. They
/// are rounded such that no face is reversed for the exact quotients of these numbers, not for
/// quotients in `double`. Complexity: linear if rounding reverses no face.
/// \tparam Map `Planar_conformal_map` or `Hyperbolic_conformal_map`
/// \pre the map is laid out
template <typename Map>
Rounded_points<std::array<double, 3>>
homogeneous_texture_points(const Map& map, const Input_part& part, const Texture_corners& corners)
{
  return internal::rounded_corners(map, part, corners,
                                   [](const std::array<double, 3>& z) { return z; });
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_POINTS_H
