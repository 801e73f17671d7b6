// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename FT>
[[noreturn]] void fail_at_length(Edge_index e, const Delta_complex& mesh,
                                 [[maybe_unused]] const FT& length)
{
  std::ostringstream text;
  text << "the length of edge " << e.idx() << " between vertices " << mesh.vertex(e, 0).idx()
       << " and " << mesh.vertex(e, 1).idx();
  if constexpr(std::is_floating_point_v<FT>)
    text << " is " << length << ", which";
  text << " is zero, not finite, or beyond the range of its number type: from 2^-127 to 2^127 for "
          "double";
  throw Invalid_input(text.str());
}

template <typename Surface, typename Traits>
void check_length(Edge_index e, const Surface& surface, const Traits& traits)
{
  if(!traits.is_length_object()(get(surface.length_map(), e)))
    fail_at_length(e, surface.mesh(), get(surface.length_map(), e));
}

// Returns the length of the edge `e` that the metric determines.
template <typename K, typename Surface>
double rounded_length(Edge_index e, const Input_metric<K>& metric, const Surface& surface)
{
  if(!metric.squared_lengths.empty())
    return root_of<double>(metric.squared_lengths[e.idx()]);
  if(metric.points.empty())
    return get(surface.length_map(), e);
  const auto d = vector_between<double>(metric.points[surface.mesh().vertex(e, 0)],
                                        metric.points[surface.mesh().vertex(e, 1)]);
  return std::sqrt(dot(d, d));
}

// Checks the lengths of a file, which its metric determines.
template <typename Surface, typename Metric, typename Traits>
void check_lengths(const Surface& surface, [[maybe_unused]] const Metric& metric,
                   const Traits& traits)
{
  const Delta_complex& mesh = surface.mesh();
  for(Edge_index e : mesh.edges()) {
    check_length(e, surface, traits);
    if constexpr(!std::is_same_v<Metric, No_metric>) {
      const double length = get(surface.length_map(), e),
                   exact = rounded_length(e, metric, surface);
      if(!(std::abs(length - exact) <= rounding_unit<double>() * length))
        throw Invalid_input("the length of edge " + std::to_string(e.idx()) +
                            " differs from its exact positions or squared length");
    }
  }
}

template <typename Surface, typename Traits>
void check_triangles(const Surface& surface, const Traits& traits)
{
  const auto is_triangle = traits.is_triangle_object();
  for(Face_index f : surface.mesh().faces())
    if(const auto [a, b, c] = side_lengths(surface.mesh().halfedge(f), surface);
       !is_triangle(a, b, c))
      throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()));
}

// Copies length(e) of each edge of `g` to the edge of `copy` with its index.
template <typename Graph, typename Numbering, typename Surface, typename Length>
void set_lengths(const Graph& g, const Numbering& numbering, const Surface& copy,
                 const Length& length)
{
  for(auto e : edges(g))
    put(copy.length_map(), copy.mesh().edge(numbering.halfedge_of(halfedge(e, g))), length(e));
}

// Sets the lengths of `copy`. They are the lengths of the named parameter, the roots of squared
// lengths, or the distances of vertices.
template <typename Graph, typename NamedParameters, typename Numbering, typename Surface>
void copy_lengths(const Graph& g, const NamedParameters& np, const Numbering& numbering,
                  const Surface& copy)
{
  typedef Length_of<Surface> FT;
  using CGAL::parameters::get_parameter;
  if constexpr(has_parameter<NamedParameters, internal_np::edge_length_map_t>()) {
    const auto length = get_parameter(np, internal_np::edge_length_map);
    set_lengths(g, numbering, copy, [&](auto e) { return FT(get(length, e)); });
  } else if constexpr(has_parameter<NamedParameters, internal_np::squared_edge_length_map_t>()) {
    const auto square = get_parameter(np, internal_np::squared_edge_length_map);
    set_lengths(g, numbering, copy, [&](auto e) { return root_of<FT>(get(square, e)); });
  } else {
    const auto point = vertex_points(g, np);
    set_lengths(g, numbering, copy, [&](auto e) {
      return distance<FT>(get(point, source(e, g)), get(point, target(e, g)));
    });
  }
}

// Distances of positions need no check, because they are lengths of triangles.
template <typename NamedParameters, typename Surface, typename Traits>
void check_copied_lengths(const NamedParameters&, const Surface& copy, const Traits& traits)
{
  for(Delta_complex::size_type n = 0; n < copy.mesh().num_edges(); ++n)
    check_length(Edge_index(n), copy, traits);
  if constexpr(has_parameter<NamedParameters, internal_np::edge_length_map_t>() ||
               has_parameter<NamedParameters, internal_np::squared_edge_length_map_t>())
    check_triangles(copy, traits);
}

// Returns the exact value of a number of a kernel.
template <typename K, typename Number>
auto to_exact(const Number& x) -> decltype(K(x.exact()))
{
  return K(x.exact());
}
template <typename K>
K to_exact(const K& x)
{
  return x;
}

// Copies nothing without an exact metric.
template <typename Graph, typename NamedParameters, typename Numbering>
void copy_metric(const Graph&, const NamedParameters&, const Numbering&, const Delta_complex&,
                 No_metric&)
{}

// Copies the data that determine the lengths of `g` exactly: positions in floating point, or
// squared lengths.
template <typename Graph, typename NamedParameters, typename Numbering, typename K>
void copy_metric(const Graph& g, const NamedParameters& np, const Numbering& numbering,
                 const Delta_complex& copy, Input_metric<K>& metric)
{
  const auto set_squared_lengths = [&](const auto& square) {
    metric.squared_lengths.resize(copy.num_edges());
    for(auto e : edges(g))
      metric.squared_lengths[copy.edge(numbering.halfedge_of(halfedge(e, g)))] = square(e);
  };
  if constexpr(has_parameter<NamedParameters, internal_np::squared_edge_length_map_t>()) {
    const auto square = CGAL::parameters::get_parameter(np, internal_np::squared_edge_length_map);
    set_squared_lengths([&](auto e) { return K(get(square, e)); });
  } else if constexpr(!has_parameter<NamedParameters, internal_np::edge_length_map_t>()) {
    const auto point = vertex_points(g, np);
    typedef typename boost::property_traits<decltype(point)>::value_type Point;
    typedef typename Kernel_traits<Point>::Kernel Kernel;
    if constexpr(std::is_floating_point_v<typename Kernel::FT>) {
      metric.points.resize(copy.num_vertices());
      for(auto v : vertices(g)) {
        const auto& p = get(point, v);
        metric.points[numbering.vertex(v)] = {double(p.x()), double(p.y()), double(p.z())};
      }
    } else if constexpr(!std::is_same_v<K, double>)
      set_squared_lengths([&](auto e) {
        return to_exact<K>(typename Kernel::Compute_squared_distance_3()(get(point, source(e, g)),
                                                                         get(point, target(e, g))));
      });
  }
}

inline void forget(No_metric&) {}

template <typename K>
void forget(Input_metric<K>& metric)
{
  metric = {};
}

// Mollifies the lengths as the named parameter requires. If they change, they count as exact.
template <typename NamedParameters, typename Surface, typename Metric>
void mollify_lengths([[maybe_unused]] const NamedParameters& np,
                     [[maybe_unused]] const Surface& copy, [[maybe_unused]] Metric& metric)
{
  if constexpr(has_parameter<NamedParameters, internal_np::mollification_t>()) {
    typedef Length_of<Surface> FT;
    const FT epsilon(CGAL::parameters::get_parameter(np, internal_np::mollification));
    if(!(epsilon >= 0))
      throw Invalid_input("the mollification is negative or NaN");
    if(epsilon > 0 && mollify(copy.mesh(), copy.length_map(), epsilon) > 0)
      forget(metric);
  }
}

// Calls fix(h) for the first halfedge of each edge that is constrained by the named parameter.
template <typename Graph, typename NamedParameters, typename Fix>
void copy_constraints([[maybe_unused]] const Graph& g, [[maybe_unused]] const NamedParameters& np,
                      [[maybe_unused]] const Fix& fix)
{
  typedef CGAL::internal_np::edge_is_constrained_t Tag;
  if constexpr(has_parameter<NamedParameters, Tag>()) {
    const auto is_constrained = CGAL::parameters::get_parameter(np, Tag());
    with_numbering(g, [&](const auto& numbering) {
      for(auto e : edges(g))
        if(get(is_constrained, e))
          fix(numbering.halfedge_of(halfedge(e, g)));
    });
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_COPY_PROPERTIES_H
