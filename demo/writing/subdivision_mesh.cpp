// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/subdivision_mesh.h"

#include <utility>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

Vertex_kind kind(const Subdivision& subdivision, IT::Vertex_index v)
{
  if(subdivision.is_vertex(IT::Side::input, v))
    return Vertex_kind::input;
  return subdivision.is_vertex(IT::Side::intrinsic, v) ? Vertex_kind::inserted
                                                       : Vertex_kind::crossing;
}

// The place on the first halfedge of the edge of `side` inside which `v` lies; null if there is
// none.
IT::Edge_point<double> place_inside_edge(const Subdivision& subdivision, IT::Side side,
                                         IT::Vertex_index v)
{
  if(subdivision.is_vertex(side, v))
    return {IT::Halfedge_index(), 0};
  const IT::Surface_place<double> p = subdivision.place(side, v);
  if(!p.along.is_valid())
    return {IT::Halfedge_index(), 0};
  return {IT::first_halfedge(IT::Edge_index(p.along)),
          IT::place_on_first_halfedge(IT::edge_point(p.along, p.location, subdivision.mesh(side)))};
}

template <class Value>
Attribute at_vertices(const std::string& name, const Subdivision& subdivision, const Value& value)
{
  return attribute_on_demand<IT::Vertex_index>(name, subdivision.mesh().number_of_vertices(),
                                               value);
}

// Adds the edge of `side` inside which each vertex is, -1 for none, and the place of the vertex on
// that edge, between 0 and 1.
void add_places(const Subdivision& subdivision, const std::string& name, IT::Side side,
                std::vector<Attribute>& data)
{
  data.push_back(at_vertices(name + "_edge", subdivision, [&subdivision, side](IT::Vertex_index v) {
    return number_of(IT::Edge_index(place_inside_edge(subdivision, side, v).halfedge));
  }));
  data.push_back(
    at_vertices(name + "_coordinate", subdivision, [&subdivision, side](IT::Vertex_index v) {
      return place_inside_edge(subdivision, side, v).t;
    }));
}

std::vector<Attribute> point_data(const Subdivision& subdivision)
{
  const auto input_vertex = [&subdivision](IT::Vertex_index v) {
    return subdivision.is_vertex(IT::Side::input, v) ? number_of(v) : -1;
  };
  std::vector<Attribute> result = {
    at_vertices("kind", subdivision,
                [&subdivision](IT::Vertex_index v) { return std::int64_t(kind(subdivision, v)); }),
    at_vertices("input_vertex", subdivision, input_vertex)};
  add_places(subdivision, "input", IT::Side::input, result);
  add_places(subdivision, "intrinsic", IT::Side::intrinsic, result);
  return result;
}

Attribute parent_edges(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute_on_demand<IT::Edge_index>(
    name, subdivision.mesh().number_of_edges(),
    [&subdivision, side](IT::Edge_index e) { return number_of(subdivision.parent_edge(side, e)); });
}

Attribute parent_faces(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute_on_demand<IT::Face_index>(
    name, subdivision.mesh().number_of_faces(),
    [&subdivision, side](IT::Face_index f) { return number_of(subdivision.parent_face(side, f)); });
}

} // namespace

Output_mesh subdivision_mesh(const Subdivision& subdivision)
{
  const Mesh& mesh = subdivision.mesh();
  Output_mesh result = output_mesh_with_edges(mesh, {mesh.faces().begin(), mesh.faces().end()});
  result.point_data = point_data(subdivision);
  result.edge_data = {parent_edges(subdivision, "input_edge", IT::Side::input),
                      parent_edges(subdivision, "intrinsic_edge", IT::Side::intrinsic)};
  result.polygon_data = {parent_faces(subdivision, "input_face", IT::Side::input),
                         parent_faces(subdivision, "intrinsic_face", IT::Side::intrinsic)};
  return result;
}

void add_input_data(const Input_mesh& input, const Subdivision& subdivision, Output_mesh& mesh)
{
  if(input.data.empty())
    return;
  typedef Mesh::size_type Size;
  const auto weights = [&](std::size_t i) {
    return input.weights(
      subdivision.weights(IT::Side::input, IT::Vertex_index(static_cast<Size>(i))));
  };
  const auto triangle = [&](std::size_t i, std::size_t) {
    return input.triangle(
      subdivision.parent_face(IT::Side::input, IT::Face_index(static_cast<Size>(i))));
  };
  add_data(mesh, carried(input.data, {subdivision.mesh().number_of_vertices(), mesh.polygons,
                                      weights, triangle}));
}
