// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/subdivision_mesh.h"

#include "writing/subdivision_elements.h"

#include <CGAL/Intrinsic_triangulations/interpolation.h>

#include <boost/property_map/property_map.hpp>

#include <utility>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

typedef Whole_subdivision<Subdivision> Part;

Vertex_kind kind(const Subdivision& subdivision, IT::Vertex_index v)
{
  if(subdivision.is_vertex(IT::Side::input, v))
    return Vertex_kind::input;
  return subdivision.is_vertex(IT::Side::intrinsic, v) ? Vertex_kind::inserted
                                                       : Vertex_kind::crossing;
}

// Returns the position on the first halfedge of the edge of `side` that contains `v` inside, or
// null if `v` is not inside an edge.
IT::Edge_point<double> place_inside_edge(const Subdivision& subdivision, IT::Side side,
                                         IT::Vertex_index v)
{
  const IT::Surface_point<double> p = subdivision.place(side, v);
  const auto* on_edge = IT::on_edge(p);
  if(on_edge == nullptr)
    return {IT::Halfedge_index(), 0};
  return {IT::first_halfedge(IT::Edge_index(on_edge->halfedge)),
          IT::place_on_first_halfedge(IT::edge_point(*on_edge))};
}

// Adds to points the edge of `side` that contains them inside, -1 for none, and their positions on
// that edge, between 0 and 1.
void add_places(const Part& part, const std::string& name, IT::Side side, Output_mesh& result)
{
  const auto place = [&subdivision = part.subdivision(), side](IT::Vertex_index v) {
    return place_inside_edge(subdivision, side, v);
  };
  add_attribute(result.point_data, name + "_edge", part, &Part::vertices,
                [=](IT::Vertex_index v) { return number_of(IT::Edge_index(place(v).halfedge)); });
  add_attribute(result.point_data, name + "_coordinate", part, &Part::vertices,
                [=](IT::Vertex_index v) { return place(v).t; });
}

void add_kinds(const Part& part, Output_mesh& result)
{
  const Subdivision& subdivision = part.subdivision();
  add_attribute(result.point_data, "kind", part, &Part::vertices,
                [&subdivision](IT::Vertex_index v) { return std::int64_t(kind(subdivision, v)); });
  add_attribute(result.point_data, "input_vertex", part, &Part::vertices,
                [&subdivision](IT::Vertex_index v) {
                  return subdivision.is_vertex(IT::Side::input, v) ? number_of(v) : -1;
                });
}

} // namespace

Output_mesh subdivision_mesh(const Subdivision& subdivision)
{
  const Part part(subdivision);
  Output_mesh result;
  result.points.assign(part.mesh().points().begin(), part.mesh().points().end());
  add_edges_and_polygons(part, result);
  add_kinds(part, result);
  for(const auto& [side, name] :
      {std::pair(IT::Side::input, "input"), std::pair(IT::Side::intrinsic, "intrinsic")}) {
    add_places(part, name, side, result);
    add_parents(
      part, side, name, [](auto parent) { return number_of(parent); }, result);
  }
  set_placement(
    part, [&](IT::Vertex_index v) { return subdivision.weights(IT::Side::input, v); },
    [&](IT::Face_index f) { return subdivision.parent_face(IT::Side::input, f); }, result);
  return result;
}

std::vector<double> interpolated(IT::Side side, const std::vector<double>& values,
                                 const Subdivision& subdivision)
{
  const auto map = [&](auto first) {
    return boost::make_iterator_property_map(first, get(boost::vertex_index, subdivision.mesh()));
  };
  std::vector<double> result(subdivision.mesh().number_of_vertices());
  IT::interpolate(side, subdivision, map(values.begin()), map(result.begin()));
  return result;
}
