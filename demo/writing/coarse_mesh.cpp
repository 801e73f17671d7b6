// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/coarse_mesh.h"

#include <array>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

constexpr std::size_t number_of_colors = 4; // a face has three neighbors at most
constexpr std::array<std::array<std::int64_t, 3>, number_of_colors> palette{
  {{141, 180, 226}, {250, 205, 130}, {160, 215, 150}, {235, 150, 140}}};

// Each face takes the first color that no neighbor has.
std::vector<std::size_t> colors(const IS::Delta_complex& mesh)
{
  std::vector<std::size_t> result(mesh.number_of_faces(), number_of_colors);
  for(const IS::Face_index f : mesh.faces()) {
    std::array<bool, number_of_colors> is_taken{};
    for(const IS::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      const IS::Face_index g = mesh.face(mesh.opposite(h));
      if(g.is_valid() && result[g] < number_of_colors)
        is_taken[result[g]] = true;
    }
    result[f] = 0;
    while(is_taken[result[f]])
      ++result[f];
  }
  return result;
}

// The faces that have an area.
std::vector<Mesh::Face_index> polygons(const Mesh& mesh)
{
  std::vector<Mesh::Face_index> result;
  for(const Mesh::Face_index f : mesh.faces())
    if(mesh.degree(f) > 2)
      result.push_back(f);
  return result;
}

Vertex_kind kind(const Coarse_subdivision& subdivision, std::size_t number_of_input_vertices,
                 IS::Vertex_index v)
{
  if(v.idx() < number_of_input_vertices)
    return Vertex_kind::input;
  if(subdivision.is_vertex(IS::Level::fine, v) || subdivision.is_vertex(IS::Level::coarse, v))
    return Vertex_kind::inserted;
  return subdivision.place(IS::Level::fine, v).along.is_valid() ? Vertex_kind::crossing
                                                                : Vertex_kind::bend;
}

std::vector<Attribute> edge_data(const Coarse_subdivision& subdivision, const Fine_origin& origin)
{
  const Mesh& mesh = subdivision.mesh();
  const auto parent = [&](IS::Level side, Mesh::Edge_index e) {
    return number_of(IS::Edge_index(subdivision.parent_halfedge(side, mesh.halfedge(e))));
  };
  const auto input_edge = [&](Mesh::Edge_index e) {
    const std::int64_t fine = parent(IS::Level::fine, e);
    return fine < 0 ? fine : origin.edges[std::size_t(fine)];
  };
  return {attribute("input_edge", mesh.edges(), input_edge),
          attribute("coarse_edge", mesh.edges(),
                    [&](Mesh::Edge_index e) { return parent(IS::Level::coarse, e); })};
}

std::vector<Attribute> polygon_data(const Coarse_subdivision& subdivision,
                                    const std::vector<Mesh::Face_index>& faces,
                                    const Fine_origin& origin)
{
  const auto input_face = [&](Mesh::Face_index f) {
    return origin.faces[subdivision.parent_face(IS::Level::fine, f)];
  };
  const auto coarse_face = [&](Mesh::Face_index f) {
    return number_of(subdivision.parent_face(IS::Level::coarse, f));
  };
  const std::vector<std::size_t> color = colors(subdivision.level(IS::Level::coarse).mesh());
  const auto channel = [&](std::size_t c) {
    return [&, c](Mesh::Face_index f) {
      return palette[color[subdivision.parent_face(IS::Level::coarse, f)]][c];
    };
  };
  return {attribute("input_face", faces, input_face), attribute("coarse_face", faces, coarse_face),
          attribute("red", faces, channel(0)), attribute("green", faces, channel(1)),
          attribute("blue", faces, channel(2))};
}

void add_coarse_edges(const Coarse_subdivision& subdivision, Output_mesh& result)
{
  const Mesh& mesh = subdivision.mesh();
  const auto edges = subdivision.level(IS::Level::coarse).mesh().edges();
  for(const IS::Edge_index e : edges) {
    const auto parts = subdivision.parts_of_coarse_edge(e);
    result.lines.add_corner(mesh.source(*parts.begin()));
    for(const Mesh::Halfedge_index h : parts)
      result.lines.add_corner(mesh.target(h));
    result.lines.close();
  }
  const auto black = [](IS::Edge_index) { return std::int64_t(0); };
  result.line_data = {
    attribute("coarse_edge", edges, [](IS::Edge_index e) { return number_of(e); }),
    attribute("red", edges, black), attribute("green", edges, black),
    attribute("blue", edges, black)};
}

} // namespace

Output_mesh coarse_mesh(const Coarse_subdivision& subdivision, const Fine_origin& origin)
{
  const Mesh& mesh = subdivision.mesh();
  const std::vector<Mesh::Face_index> faces = polygons(mesh);
  Output_mesh result = output_mesh_with_edges(mesh, faces);
  result.point_data = {attribute("coarse_vertex", mesh.vertices(),
                                 [&](Mesh::Vertex_index v) {
                                   return number_of(
                                     subdivision.parent_vertex(IS::Level::coarse, v));
                                 }),
                       attribute("kind", mesh.vertices(), [&](Mesh::Vertex_index v) {
                         return std::int64_t(kind(subdivision, origin.number_of_vertices, v));
                       })};
  result.edge_data = edge_data(subdivision, origin);
  result.polygon_data = polygon_data(subdivision, faces, origin);
  add_coarse_edges(subdivision, result);
  return result;
}

Mesh_data data_of_coarse_mesh(const Coarse_subdivision& subdivision, const Triangle_data& fine,
                              const Output_mesh& mesh)
{
  const std::vector<Mesh::Face_index> faces = polygons(subdivision.mesh());
  const auto weights = [&](std::size_t i) {
    const auto w =
      subdivision.weights(IS::Level::fine, IS::Vertex_index(static_cast<Mesh::size_type>(i)));
    return Point_weights{w.size, {w.vertex[0], w.vertex[1], w.vertex[2]}, w.weight};
  };
  const auto triangle = [&](std::size_t i, std::size_t) {
    return number_of(subdivision.parent_face(IS::Level::fine, faces[i]));
  };
  return carried(fine, {mesh.points.size(), mesh.polygons, weights, triangle});
}
