// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_SPHERE_POINTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_SPHERE_POINTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the homogeneous coordinates of the image under `map` of each vertex of `part`, in the
/// order of its vertices. Complexity: linear.
inline std::vector<std::array<double, 4>>
homogeneous_coordinates(const Spherical_conformal_map& map, const Input_part& part)
{
  std::vector<std::array<double, 4>> result(part.vertices().size());
  for(Halfedge_index h : part.mesh().halfedges())
    if(part.has(h))
      result[part.number(part.mesh().target(h))] =
        map.homogeneous_coordinates(part.subdivision().location(Layer::C, h));
  return result;
}

namespace internal {

// Returns the images of the vertices of a part. Vertices of the input have their positions.
inline std::vector<std::array<double, 3>>
images_of_vertices(const Spherical_conformal_map& map, const Input_part& part,
                   const std::vector<std::array<double, 4>>& homogeneous)
{
  std::vector<std::array<double, 3>> result;
  result.reserve(part.vertices().size());
  for(Vertex_index v : part.vertices())
    result.push_back(part.is_of_input(v) ? map.position(v)
                                         : map.image(homogeneous[part.number(v)]));
  return result;
}

inline auto number_of_target(const Input_part& part)
{
  return [&part](Halfedge_index h) { return part.number(part.mesh().target(h)); };
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the images on the sphere of the vertices of a part, in their order. They are rounded
/// such that no face is reversed, as seen from the center, if possible. A polygon
/// (`map.is_flat()`) has no orientation from the center, and does not change. Complexity: linear if
/// rounding reverses no face.
/// \param map the map
/// \param part the part of the input, of `map`
/// \param homogeneous the homogeneous coordinates of the vertices
/// \pre `map.is_laid_out()`
inline Rounded_points<std::array<double, 3>>
sphere_points(const Spherical_conformal_map& map, const Input_part& part,
              const std::vector<std::array<double, 4>>& homogeneous)
{
  auto points = internal::images_of_vertices(map, part, homogeneous);
  if(map.is_flat())
    return {std::move(points), {}};
  return internal::without_reversed_faces(std::move(points), part,
                                          internal::number_of_target(part));
}

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the images in the unit disk of the vertices of a part of a disk, from their images on
/// the hemisphere, `points`. They are rounded such that no face is reversed, if possible. Edges are
/// arcs in the disk, and a thin face can be reversed with straight edges. Complexity: linear if
/// rounding reverses no face.
inline Rounded_points<std::array<double, 2>>
disk_points(const Input_part& part, const std::vector<std::array<double, 3>>& points)
{
  std::vector<std::array<double, 2>> in_disk;
  in_disk.reserve(points.size());
  for(const std::array<double, 3>& p : points)
    in_disk.push_back(internal::coordinates(Spherical_conformal_map::to_plane(p)));
  return internal::without_reversed_faces(std::move(in_disk), part,
                                          internal::number_of_target(part));
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_SPHERE_POINTS_H
