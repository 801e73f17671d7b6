// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivision_mesh.h"

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Index>
std::int64_t number_of(Index i)
{
  return i.is_valid() ? static_cast<std::int64_t>(i.idx()) : -1;
}

// One value per element of `range`.
template <class Range, class Value>
Attribute attribute(const char* name, const Range& range, const Value& value)
{
  Attribute result{name, {}};
  for(const auto element : range)
    result.values.push_back(value(element));
  return result;
}

// The edge on which each crossing is; -1 at a vertex.
Attribute crossed_edges(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute(name, subdivision.mesh().vertices(), [&](IT::Vertex_index v) {
    return subdivision.is_input_vertex(v)
             ? -1
             : number_of(IT::Edge_index(subdivision.place(side, v).halfedge));
  });
}

// The place of each crossing on its edge, between 0 and 1; 0 at a vertex.
Attribute coordinates(const Subdivision& subdivision, const char* name, IT::Side side)
{
  return attribute(name, subdivision.mesh().vertices(),
                   [&](IT::Vertex_index v) { return subdivision.place(side, v).t; });
}

std::vector<Attribute> point_data(const Subdivision& subdivision)
{
  const auto vertices = subdivision.mesh().vertices();
  const auto is_crossing = [&](IT::Vertex_index v) {
    return std::int64_t(subdivision.is_input_vertex(v) ? 0 : 1);
  };
  const auto input_vertex = [&](IT::Vertex_index v) {
    return subdivision.is_input_vertex(v) ? number_of(v) : -1;
  };
  return {attribute("kind", vertices, is_crossing),
          attribute("input_vertex", vertices, input_vertex),
          crossed_edges(subdivision, "input_edge", IT::Side::input),
          coordinates(subdivision, "input_coordinate", IT::Side::input),
          crossed_edges(subdivision, "intrinsic_edge", IT::Side::intrinsic),
          coordinates(subdivision, "intrinsic_coordinate", IT::Side::intrinsic)};
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
  Output_mesh result = output_mesh(mesh);
  for(const Mesh::Edge_index e : mesh.edges())
    result.edges.push_back({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  result.point_data = point_data(subdivision);
  result.edge_data = {parent_edges(subdivision, "input_edge", IT::Side::input),
                      parent_edges(subdivision, "intrinsic_edge", IT::Side::intrinsic)};
  result.polygon_data = {parent_faces(subdivision, "input_face", IT::Side::input),
                         parent_faces(subdivision, "intrinsic_face", IT::Side::intrinsic)};
  return result;
}
