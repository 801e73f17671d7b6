// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/coarse_mesh.h"

#include "writing/subdivision_elements.h"

#include <array>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

typedef Whole_subdivision<Coarse_subdivision> Coarse_part;

constexpr std::size_t number_of_colors = 4; // a face has three neighbors at most
constexpr std::array<std::array<std::int64_t, 3>, number_of_colors> palette{
  {{141, 180, 226}, {250, 205, 130}, {160, 215, 150}, {235, 150, 140}}};

// Returns colors. Each face gets the first color that no neighbor has.
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

Vertex_kind kind(const Coarse_subdivision& subdivision, std::size_t number_of_input_vertices,
                 IS::Vertex_index v)
{
  if(v.idx() < number_of_input_vertices)
    return Vertex_kind::input;
  if(subdivision.is_vertex(IS::Level::fine, v) || subdivision.is_vertex(IS::Level::coarse, v))
    return Vertex_kind::inserted;
  return IT::on_edge(subdivision.place(IS::Level::fine, v)) ? Vertex_kind::crossing
                                                            : Vertex_kind::bend;
}

void add_colors(const Coarse_part& part, Output_mesh& result)
{
  const Coarse_subdivision& subdivision = part.subdivision();
  const std::vector<std::size_t> color = colors(subdivision.mesh(IS::Level::coarse));
  const char* const channels[] = {"red", "green", "blue"};
  for(std::size_t c = 0; c < 3; ++c)
    add_attribute(result.polygon_data, channels[c], part, &Coarse_part::faces,
                  [=, &subdivision](auto f) {
                    return palette[color[subdivision.parent_face(IS::Level::coarse, f)]][c];
                  });
}

// Returns the element of the input. Elements of the fine level that are not parts of the input have
// none.
Mesh::Edge_index input_element(Mesh::Edge_index e, const Fine_level& fine)
{
  return e.is_valid() ? fine.input_edge(e) : e;
}
Mesh::Face_index input_element(Mesh::Face_index f, const Fine_level& fine)
{
  return fine.input_face(f);
}

void add_coarse_edges(const Coarse_subdivision& subdivision, Output_mesh& result)
{
  const Mesh& mesh = subdivision.mesh();
  std::vector<std::int64_t> numbers;
  for(const IS::Edge_index e : subdivision.level(IS::Level::coarse).mesh().edges()) {
    const auto parts = subdivision.parts_of_coarse_edge(e);
    result.lines.add_corner(mesh.source(*parts.begin()));
    for(const Mesh::Halfedge_index h : parts)
      result.lines.add_corner(mesh.target(h));
    result.lines.close();
    numbers.push_back(number_of(e));
  }
  result.line_data.emplace_back("coarse_edge", numbers);
  for(const char* channel : {"red", "green", "blue"}) // black
    result.line_data.emplace_back(channel, std::vector<std::int64_t>(numbers.size(), 0));
}

} // namespace

Output_mesh coarse_mesh(const Coarse_subdivision& subdivision, const Fine_level& fine)
{
  const Coarse_part part(subdivision);
  Output_mesh result;
  result.points.assign(part.mesh().points().begin(), part.mesh().points().end());
  add_edges_and_polygons(part, result);
  add_attribute(result.point_data, "coarse_vertex", part, &Coarse_part::vertices,
                [&](auto v) { return number_of(subdivision.parent_vertex(IS::Level::coarse, v)); });
  add_attribute(result.point_data, "kind", part, &Coarse_part::vertices, [&](auto v) {
    return std::int64_t(kind(subdivision, fine.number_of_input_vertices(), v));
  });
  add_parents(
    part, IS::Level::fine, "input", [&](auto f) { return number_of(input_element(f, fine)); },
    result);
  add_parents(
    part, IS::Level::coarse, "coarse", [](auto f) { return number_of(f); }, result);
  add_colors(part, result);
  add_coarse_edges(subdivision, result);
  set_placement(
    part, [&](auto v) { return subdivision.weights(IS::Level::fine, v); },
    [&](auto f) { return subdivision.parent_face(IS::Level::fine, f); }, result);
  result.keep();
  return result;
}

Mesh_data data_of_coarse_mesh(const Triangle_data& fine, const Output_mesh& mesh)
{
  const auto weights = [&](std::size_t i) {
    const Placement::Weights w = mesh.placement.weights(i);
    return Point_weights{w.size, {w.vertex[0], w.vertex[1], w.vertex[2]}, w.weight};
  };
  const auto triangle = [&](std::size_t i, std::size_t k) {
    return number_of(mesh.placement.face(i, k));
  };
  return carried(fine, {mesh.points.size(), mesh.polygons, weights, triangle});
}
