// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_RECTANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_RECTANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Corner_choice.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns four vertices on the boundary of each component that suit the corners of a rectangle.
/// They are as far apart along the boundary as possible, under one condition. The sum of their
/// exterior angles is at least nine tenths of the sum at the four sharpest vertices.
///
/// The corners of one component follow each other, counterclockwise along its boundary.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh whose components have one boundary loop each, of four vertices
///   or more; isolated vertices are allowed
/// \param np the parameters of `Intrinsic_triangulations::Intrinsic_triangulation`
///
/// Complexity: \f$O(n \log n)\f$.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>
rectangle_corners(const Graph& g, const NamedParameters& np = CGAL::parameters::default_values())
{
  const Intrinsic_triangulations::Intrinsic_triangulation<> surface(g, np);
  const Delta_complex& mesh = surface.mesh();
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertex, result;
  for(auto v : vertices(g))
    vertex.push_back(v);
  for(const internal::Boundary_loop& loop : internal::rectangle_boundaries(mesh)) {
    std::vector<double> angle, length;
    for(Halfedge_index h : loop) {
      angle.push_back(internal::exterior_angle(mesh.source(h), mesh, surface.length_map()));
      length.push_back(surface.length(mesh.edge(h)));
    }
    const auto corners = internal::Corner_choice(std::move(angle), length).corners();
    for(auto i = corners.rbegin(); i != corners.rend(); ++i) // loops run clockwise
      result.push_back(vertex[mesh.source(loop[*i]).idx()]);
  }
  return result;
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// maps every component of a surface to a rectangle, discretely conformally: the exterior angles on
/// its boundary are \f$\pi/2\f$ at four corners and zero elsewhere.
///
/// The ratio of the sides is the conformal modulus of the surface for these corners.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam VertexRange a range of vertices of `Graph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh whose components have one boundary loop each; isolated
///   vertices are allowed
/// \param corners four vertices on the boundary of each component, in any order, such as the result
///   of `rectangle_corners()`
/// \param np the parameters of `flatten()`; a `vertex_condition_map` applies to inner vertices, and
///   no boundary vertex becomes a cone. `Cones::automatic` places cones if there is a
///   `maximum_log_scale` or `maximum_area_distortion`
///
/// Complexity: the complexity of `flatten()`, which also describes the status.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh, if `corners` are not
///   four vertices on each boundary, or as `flatten()` does. A component with handles has no
///   rectangle without cones inside
/// \throws Intrinsic_triangulations::Numerical_error, Intrinsic_triangulations::Overflow_error,
///   Intrinsic_triangulations::Flip_limit_exceeded as `flatten()` does
template <typename Graph, typename VertexRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map
flatten_to_rectangle(const Graph& g, const VertexRange& corners,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  const std::unordered_set<typename boost::graph_traits<Graph>::vertex_descriptor> given(
    std::begin(corners), std::end(corners));
  internal::Map_parameters parameters =
    internal::map_parameters(g, input.mesh(), np, Vertex_condition());
  for(auto v : vertices(g))
    parameters.is_corner.push_back(given.count(v) != 0);
  return internal::flattened_to<internal::Rectangular_boundary>(std::move(input),
                                                                std::move(parameters), np);
}

} // namespace CGAL::Discrete_conformal_maps

// The compiled library contains the definitions of these headers.
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/internal/maps/Repeated_flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Rectangular_boundary.h>
#endif

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_RECTANGLE_H
