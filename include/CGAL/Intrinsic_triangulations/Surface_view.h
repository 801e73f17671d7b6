// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_VIEW_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSurfaces
/// the type of the map of edge lengths of a model of `IntrinsicSurface`.
template <typename Surface>
using Length_map_of = std::decay_t<decltype(std::declval<const Surface&>().length_map())>;

/// \ingroup PkgIntrinsicTriangulationsSurfaces
/// the number type of the edge lengths of a model of `IntrinsicSurface`.
template <typename Surface>
using Length_of = typename boost::property_traits<Length_map_of<Surface>>::value_type;

/// \ingroup PkgIntrinsicTriangulationsSurfaces
/// a connectivity and edge lengths that are stored elsewhere, as one surface. Copying takes
/// constant time and copies the property map, not the lengths.
///
/// The template argument is deduced: `Surface_view(mesh, length)` is a surface.
///
/// \tparam EdgeLengthMap a model of `ReadablePropertyMap` from `Edge_index` to a number type
/// \cgalModels `IntrinsicSurface`
template <typename EdgeLengthMap>
class Surface_view
{
public:
  /// makes a surface of a connectivity, which is referred to, and a map of its edge lengths.
  Surface_view(const Delta_complex& mesh, const EdgeLengthMap& length)
    : m_mesh(&mesh), m_length_map(length)
  {}

  /// returns the connectivity.
  const Delta_complex& mesh() const { return *m_mesh; }
  /// returns the map of edge lengths.
  const EdgeLengthMap& length_map() const { return m_length_map; }

private:
  const Delta_complex* m_mesh;
  EdgeLengthMap m_length_map;
};

/// \ingroup PkgIntrinsicTriangulationsSurfaces
/// returns the map of the edge lengths that are stored with `mesh`. Adds it, with zeros, if it does
/// not exist. Complexity: constant, or linear if it adds the map.
template <typename FT>
Delta_complex::Property_map<Edge_index, FT> stored_length_map(Delta_complex& mesh)
{
  return mesh.add_property_map<Edge_index, FT>("e:length", FT(0)).first;
}

/// \ingroup PkgIntrinsicTriangulationsSurfaces
/// returns the map that states for each edge of `mesh` whether it must not be flipped. Adds it if
/// it does not exist. Complexity: constant, or linear if it adds the map.
inline Delta_complex::Property_map<Edge_index, bool> stored_constraint_map(Delta_complex& mesh)
{
  return mesh.add_property_map<Edge_index, bool>("e:is_constrained", false).first;
}

namespace internal {

template <typename Surface>
Surface_view<Length_map_of<Surface>> view_of(const Surface& surface)
{
  return {surface.mesh(), surface.length_map()};
}

template <typename Surface>
Length_of<Surface> edge_length(Halfedge_index h, const Surface& surface)
{
  return get(surface.length_map(), surface.mesh().edge(h));
}

// Returns the lengths of the sides of the face of `h`, beginning with `h`.
template <typename Surface>
std::array<Length_of<Surface>, 3> side_lengths(Halfedge_index h, const Surface& surface)
{
  const Delta_complex& mesh = surface.mesh();
  return {edge_length(h, surface), edge_length(mesh.next(h), surface),
          edge_length(mesh.prev(h), surface)};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_VIEW_H
