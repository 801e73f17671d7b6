// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_MESH_H
#define INTRINSIC_OUTPUT_MESH_H

#include "Polygon_soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// One number per vertex, edge, face or line: all of them integers or all of them not.
struct Attribute
{
  typedef std::variant<std::int64_t, double> Value;

  std::string name;
  std::vector<Value> values;

  bool has_integers() const { return values.empty() || values.front().index() == 0; }
};

// One value per element of `range`.
template <class Range, class Value>
Attribute attribute(const char* name, const Range& range, const Value& value)
{
  Attribute result{name, {}};
  for(const auto element : range)
    result.values.push_back(value(element));
  return result;
}

// Of an element of a mesh; -1 for none.
template <class Index>
std::int64_t number_of(Index i)
{
  return i.is_valid() ? static_cast<std::int64_t>(i.idx()) : -1;
}

// Texture coordinates of the corners of polygons.
struct Texture
{
  std::size_t dimension = 0; // zero if there is no texture; 2, the third being 1; 3 if homogeneous
  std::vector<std::array<double, 3>> coordinates;
  std::vector<std::vector<std::size_t>> polygons; // with coordinates in place of points
};

// A mesh with what is known about its elements, ready to be written.
struct Output_mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<std::vector<std::size_t>> lines; // through points, as polygons are but open
  std::vector<Attribute> point_data;
  std::vector<Attribute> edge_data;
  std::vector<Attribute> polygon_data;
  std::vector<Attribute> line_data;
  Texture texture;
};

// What a vertex of a common subdivision is: the property "kind" of files.
enum class Vertex_kind : std::int64_t
{
  input,    // a vertex of the input
  crossing, // of an edge with another
  inserted, // a vertex of another triangulation only
  bend      // of an edge, inside a face
};

// The points and polygons of a mesh.
Output_mesh output_mesh(const Mesh& mesh);

// The points and edges of a mesh, and those of its polygons.
Output_mesh output_mesh_with_edges(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces);

#endif // INTRINSIC_OUTPUT_MESH_H
