// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

[[noreturn]] inline void fail_at_length(Edge_index e, const Delta_complex& mesh)
{
  throw Invalid_input("the length of edge " + std::to_string(e.idx()) + " between vertices " +
                      std::to_string(mesh.vertex(e, 0).idx()) + " and " +
                      std::to_string(mesh.vertex(e, 1).idx()) +
                      " is zero, not finite, or beyond the range of its number type");
}

template <typename Surface, typename Traits>
void check_length(Edge_index e, const Surface& surface, const Traits& traits)
{
  if(!traits.is_length_object()(get(surface.length_map(), e)))
    fail_at_length(e, surface.mesh());
}

template <typename Surface, typename Traits>
void check_triangles(const Surface& surface, const Traits& traits)
{
  const auto is_triangle = traits.is_triangle_object();
  const Delta_complex& mesh = surface.mesh();
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const auto length = [&](Halfedge_index x) -> decltype(auto) {
      return get(surface.length_map(), mesh.edge(x));
    };
    if(!is_triangle(length(h), length(mesh.next(h)), length(mesh.prev(h))))
      throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()));
  }
}

// Copies length(e) of each edge of `g` to that of the edge with its index in `copy`, and checks it.
template <typename Graph, typename Numbering, typename Surface, typename Traits, typename Length>
void set_lengths(const Graph& g, const Numbering& numbering, const Surface& copy,
                 const Traits& traits, const Length& length)
{
  for(auto e : edges(g)) {
    const Edge_index e_copy = copy.mesh().edge(numbering.halfedge_of(halfedge(e, g)));
    put(copy.length_map(), e_copy, length(e));
    check_length(e_copy, copy, traits);
  }
}

// Gives `copy` the lengths of `g`: those of the named parameter, or the distances of its vertices.
template <typename Graph, typename NamedParameters, typename Numbering, typename Surface,
          typename Traits>
void copy_lengths(const Graph& g, const NamedParameters& np, const Numbering& numbering,
                  const Surface& copy, const Traits& traits)
{
  typedef Length_of<Surface> FT;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_length_map_t>::value) {
    const auto length = get_parameter(np, internal_np::edge_length_map);
    set_lengths(g, numbering, copy, traits, [&](auto e) { return FT(get(length, e)); });
    check_triangles(copy, traits);
  } else {
    const auto point = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                        get_const_property_map(CGAL::vertex_point, g));
    set_lengths(g, numbering, copy, traits, [&](auto e) {
      return distance<FT>(get(point, source(e, g)), get(point, target(e, g)));
    });
  }
}

// Calls fix(h) for the first halfedge of each edge that is constrained by the named parameter.
template <typename Graph, typename NamedParameters, typename Numbering, typename Fix>
void copy_constraints([[maybe_unused]] const Graph& g, [[maybe_unused]] const NamedParameters& np,
                      [[maybe_unused]] const Numbering& numbering, [[maybe_unused]] const Fix& fix)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  typedef CGAL::internal_np::edge_is_constrained_t Tag;
  if constexpr(!is_default_parameter<NamedParameters, Tag>::value) {
    const auto is_constrained = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for(auto e : edges(g))
      if(get(is_constrained, e))
        fix(numbering.halfedge_of(halfedge(e, g)));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H
