// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <cstddef>
#include <string>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// the topology of a connected surface, which determines its possible constant curvature.
enum class Surface_type
{
  sphere,    ///< closed, genus zero
  disk,      ///< genus zero with one boundary
  torus,     ///< closed, genus one
  annulus,   ///< genus zero with two boundaries
  hyperbolic ///< all others
};

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the name of `type`.
inline const char* to_string(Surface_type type)
{
  switch(type) {
    case Surface_type::sphere: return "sphere";
    case Surface_type::disk: return "disk";
    case Surface_type::torus: return "torus";
    case Surface_type::annulus: return "annulus";
    case Surface_type::hyperbolic: return "hyperbolic";
  }
  return "unknown";
}

namespace internal {

// Checks the number of components with faces.
inline void check_connected(std::size_t components)
{
  if(components == 0)
    throw Intrinsic_triangulations::Invalid_input("the surface has no face");
  if(components > 1)
    throw Intrinsic_triangulations::Invalid_input("the surface has " + std::to_string(components) +
                                                  " components; map them one by one");
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the topology of a surface. Isolated vertices are ignored. Complexity: linear.
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not connected or has no faces
template <typename Graph>
Surface_type surface_type(const Graph& g)
{
  const Intrinsic_triangulations::Topological_type type =
    Intrinsic_triangulations::topological_type(g);
  internal::check_connected(type.components);
  if(type.genus == 0 && type.boundary_loops < 3)
    return type.boundary_loops == 0   ? Surface_type::sphere
           : type.boundary_loops == 1 ? Surface_type::disk
                                      : Surface_type::annulus;
  return type.genus == 1 && type.boundary_loops == 0 ? Surface_type::torus
                                                     : Surface_type::hyperbolic;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H
