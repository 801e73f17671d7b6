// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivision_mesh.h"

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

// Adds the edge of `side` inside which each vertex is, -1 for none, and the place of the vertex on
// that edge, between 0 and 1.
void add_places(const Subdivision& subdivision, const std::string& name, IT::Side side,
                std::vector<Attribute>& data)
{
  std::vector<std::int64_t> edges;
  std::vector<double> coordinates;
  edges.reserve(subdivision.mesh().number_of_vertices());
  coordinates.reserve(subdivision.mesh().number_of_vertices());
  for(const IT::Vertex_index v : subdivision.mesh().vertices()) {
    const IT::Edge_point<double> place = place_inside_edge(subdivision, side, v);
    edges.push_back(number_of(IT::Edge_index(place.halfedge)));
    coordinates.push_back(place.t);
  }
  data.push_back({name + "_edge", std::move(edges)});
  data.push_back({name + "_coordinate", std::move(coordinates)});
}

std::vector<Attribute> point_data(const Subdivision& subdivision)
{
  const auto vertices = subdivision.mesh().vertices();
  const auto input_vertex = [&](IT::Vertex_index v) {
    return subdivision.is_vertex(IT::Side::input, v) ? number_of(v) : -1;
  };
  std::vector<Attribute> result = {
    attribute("kind", vertices,
              [&](IT::Vertex_index v) { return std::int64_t(kind(subdivision, v)); }),
    attribute("input_vertex", vertices, input_vertex)};
  add_places(subdivision, "input", IT::Side::input, result);
  add_places(subdivision, "intrinsic", IT::Side::intrinsic, result);
  return result;
}

Attribute parent_edges(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute(name, subdivision.mesh().edges(),
                   [&](IT::Edge_index e) { return number_of(subdivision.parent_edge(side, e)); });
}

Attribute parent_faces(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute(name, subdivision.mesh().faces(),
                   [&](IT::Face_index f) { return number_of(subdivision.parent_face(side, f)); });
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
