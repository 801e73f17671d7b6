// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_BOUNDARY_LOOP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_BOUNDARY_LOOP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <CGAL/number_type_config.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the border halfedges of a loop, in their order. The surface is on their right.
typedef std::vector<Halfedge_index> Boundary_loop;

// Returns the boundary of each component with faces.
// \throws Invalid_input unless every such component has one loop of at least `least_size` edges
inline std::vector<Boundary_loop> single_boundary_loops(const Delta_complex& mesh,
                                                        std::size_t least_size, const char* shape)
{
  using Intrinsic_triangulations::Invalid_input;
  const Intrinsic_triangulations::Mesh_components components(mesh);
  std::vector<char> has_loop(components.size(), 0);
  std::vector<Boundary_loop> result;
  for(Halfedge_index border : boundary_loops(mesh)) {
    char& is_known = has_loop[components[mesh.source(border).idx()]];
    if(is_known)
      throw Invalid_input(
        "a component has several boundary loops, but this shape needs exactly one");
    is_known = 1;
    const auto loop = CGAL::halfedges_around_face(mesh.next(border), mesh);
    result.emplace_back(loop.begin(), loop.end());
  }
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v) && !has_loop[components[v.idx()]])
      throw Invalid_input(
        "a component has no boundary, but this shape needs exactly one boundary loop");
  for(const Boundary_loop& loop : result)
    if(loop.size() < least_size)
      throw Invalid_input(std::string("a boundary has too few vertices for ") + shape);
  return result;
}

// Returns pi minus the sum of angles of faces at `v`.
template <typename EdgeLengthMap>
double exterior_angle(Vertex_index v, const Delta_complex& mesh, const EdgeLengthMap& length)
{
  const auto length_of = [&](Halfedge_index h) { return get(length, mesh.edge(h)); };
  double result = CGAL_PI;
  for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
    if(!mesh.is_border(h))
      result -= Intrinsic_triangulations::corner_angle(length_of(mesh.next(h)), length_of(h),
                                                       length_of(mesh.prev(h)));
  });
  return result;
}

// Returns the lengths in the plane of the boundary edges of the input, and zero for other edges.
inline std::vector<double> flat_boundary_lengths(const Planar_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto& mesh = subdivision.mesh();
  std::vector<double> result(map.Delaunay().input_mesh().num_edges(), 0);
  for(Halfedge_index h : mesh.halfedges())
    if(map.is_original(h) && !map.is_original(Intrinsic_triangulations::opposite(h)))
      result[subdivision.parent_edge(Layer::A, mesh.edge(h)).idx()] +=
        std::abs(map.image(h) - map.image(mesh.prev(h)));
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_BOUNDARY_LOOP_H
