// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_MESH_H
#define INTRINSIC_OUTPUT_MESH_H

#include "reading/Mesh_data.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

struct Input_mesh;

// Numbers that are kept, or computed each time one of them is asked for.
template <class Number>
class Values
{
public:
  Values(std::vector<Number> kept) : m_kept(std::move(kept)) {}
  Values(std::size_t size, std::function<Number(std::size_t)> number)
    : m_size(size), m_number(std::move(number))
  {}

  std::size_t size() const { return m_number ? m_size : m_kept.size(); }
  Number operator[](std::size_t i) const { return m_number ? m_number(i) : m_kept[i]; }

  // The numbers, which are kept from now on.
  std::vector<Number>& kept()
  {
    if(m_number) {
      m_kept.reserve(m_size);
      for(std::size_t i = 0; i < m_size; ++i)
        m_kept.push_back(m_number(i));
      m_number = nullptr;
    }
    return m_kept;
  }
  // Precondition: they are kept already.
  const std::vector<Number>& kept() const { return m_kept; }

private:
  std::vector<Number> m_kept;
  std::size_t m_size = 0;
  std::function<Number(std::size_t)> m_number; // null if they are kept
};

// One number per vertex, edge, face or line: all of them integers or all of them not.
struct Attribute
{
  std::string name;
  std::variant<Values<std::int64_t>, Values<double>> values;

  std::size_t size() const
  {
    return std::visit([](const auto& v) { return v.size(); }, values);
  }

  void keep()
  {
    std::visit([](auto& v) { v.kept(); }, values);
  }

  // New values are zero or NaN. Precondition: the values are kept.
  void resize(std::size_t n)
  {
    const auto resize = [n](auto& numbers) {
      typedef typename std::decay_t<decltype(numbers)>::value_type Number;
      numbers.resize(n, std::numeric_limits<Number>::quiet_NaN());
    };
    std::visit([&](auto& v) { resize(v.kept()); }, values);
  }

  bool has_integers() const { return values.index() == 0 || size() == 0; }
};

// One value per element of `range`.
template <class Range, class Value>
Attribute attribute(const char* name, const Range& range, const Value& value)
{
  typedef std::is_floating_point<decltype(value(*range.begin()))> Is_real;
  std::vector<std::conditional_t<Is_real::value, double, std::int64_t>> values;
  values.reserve(range.size());
  for(const auto element : range)
    values.push_back(value(element));
  return {name, std::move(values)};
}

// One value per index below `n`, computed when it is asked for.
template <class Value>
Attribute attribute_on_demand(const std::string& name, std::size_t n, const Value& value)
{
  return {name, Values<decltype(value(n))>(n, value)};
}

// Of an element of a mesh; -1 for none.
template <class Index>
std::int64_t number_of(Index i)
{
  return i.is_valid() ? static_cast<std::int64_t>(i.idx()) : -1;
}

// Where a mesh lies on the input.
struct Placement
{
  typedef CGAL::Intrinsic_triangulations::Vertex_weights<double> Weights;

  std::size_t number_of_points = 0;            // others may follow
  std::function<Weights(std::size_t)> weights; // of a point, in vertices of the input
  // The face in which corner k of polygon i lies; null if it is in none.
  std::function<Mesh::Face_index(std::size_t i, std::size_t k)> face;
};

// A mesh with what is known about its elements, ready to be written.
struct Output_mesh
{
  std::vector<Point> points;
  std::vector<std::array<Polygons::Index, 2>> edges;
  Polygons polygons;
  Polygons lines; // through points, as polygons are but open
  std::vector<Attribute> point_data;
  std::vector<Attribute> edge_data;
  std::vector<Attribute> polygon_data;
  std::vector<Attribute> line_data;
  Corner_data texture;                  // an image of the mesh; its name follows from its dimension
  std::vector<Corner_data> corner_data; // beside that
  Polygon_groups groups;
  Placement placement; // of all but lines, if it is known

  // Keeps all values, which then do not refer to what they are computed from.
  void keep()
  {
    for(auto* data : {&point_data, &edge_data, &polygon_data})
      for(Attribute& a : *data)
        a.keep();
  }
};

// That of a property of a file.
const char* name_of(const Corner_data& data);

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
Output_mesh output_mesh(const Polygon_soup& soup);

// The points and edges of a mesh, and those of its polygons.
Output_mesh output_mesh_with_edges(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces);

// Adds data of its points, corners and polygons. A name that is taken already gets "input_" in
// front.
void add_data(Output_mesh& mesh, Mesh_data data);

// The data of the input where points and polygons lie on it.
Mesh_data data_at(const Input_mesh& input, const Polygons& polygons, const Placement& placement);

// Adds the data of the input where the mesh lies on it.
void add_input_data(const Input_mesh& input, Output_mesh& mesh);

#endif // INTRINSIC_OUTPUT_MESH_H
