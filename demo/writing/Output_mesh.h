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
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

struct Input_mesh;

// Stores one number per vertex, edge, face or line, or computes it on request. Either all are
// integers, exact up to 2^53, or none is.
class Attribute
{
public:
  std::string name;

  Attribute(std::string name, std::vector<double> values)
    : name(std::move(name)), m_kept(std::move(values))
  {}
  Attribute(std::string name, const std::vector<std::int64_t>& values)
    : name(std::move(name)), m_are_integers(true), m_kept(values.begin(), values.end())
  {}

  // Constructs the attribute with the values `value(i)` for i below `size`.
  template <class Value>
  Attribute(std::string name, std::size_t size, const Value& value)
    : name(std::move(name)),
      m_are_integers(std::is_integral_v<decltype(value(size))>),
      m_size(size),
      m_value([value](std::size_t i) { return static_cast<double>(value(i)); })
  {}

  std::size_t size() const { return m_value ? m_size : m_kept.size(); }
  double operator[](std::size_t i) const { return m_value ? m_value(i) : m_kept[i]; }
  std::int64_t integer(std::size_t i) const { return static_cast<std::int64_t>((*this)[i]); }

  bool are_integers() const { return m_are_integers; }
  bool has_integers() const { return m_are_integers || size() == 0; }

  // Returns the values, which are stored from now on.
  std::vector<double>& kept()
  {
    if(m_value) {
      m_kept.reserve(m_size);
      for(std::size_t i = 0; i < m_size; ++i)
        m_kept.push_back(m_value(i));
      m_value = nullptr;
    }
    return m_kept;
  }
  // Returns the stored values.
  // Precondition: the values are stored already.
  const std::vector<double>& kept() const { return m_kept; }

private:
  bool m_are_integers = false;
  std::vector<double> m_kept;
  std::size_t m_size = 0;
  std::function<double(std::size_t)> m_value; // null if they are kept
};

// Resizes an attribute. New values are zero or NaN.
void resize(Attribute& a, std::size_t n);

// Returns the number of an element of a mesh, or -1 for none.
template <class Index>
std::int64_t number_of(Index i)
{
  return i.is_valid() ? static_cast<std::int64_t>(i.idx()) : -1;
}

// Describes the position of a mesh on the input.
struct Placement
{
  typedef CGAL::Intrinsic_triangulations::Vertex_weights<double> Weights;

  std::size_t number_of_points = 0;            // others may follow
  std::function<Weights(std::size_t)> weights; // of a point, in vertices of the input
  // Returns the face that contains corner k of polygon i, or null if it is in none.
  std::function<Mesh::Face_index(std::size_t i, std::size_t k)> face;
};

// Stores a mesh with all data about its elements, ready to be written.
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

  // Stores all values, so that they no longer refer to other objects.
  void keep()
  {
    for(auto* data : {&point_data, &edge_data, &polygon_data})
      for(Attribute& a : *data)
        a.kept();
  }
};

// Returns the sides of the polygons, each once.
std::vector<std::array<Polygons::Index, 2>> edges_of(const Polygons& polygons);

// Returns the polygons whose attribute `name` is one of `values`.
std::vector<std::int64_t> parts_of(const std::vector<std::int64_t>& values, const std::string& name,
                                   const Output_mesh& mesh);

// Returns the attribute with this name, or null if none exists.
const Attribute* find_attribute(const std::vector<Attribute>& data, const std::string& name);

// Returns the name of a property of a file.
const char* name_of(const Corner_data& data);

// States the kind of a vertex of a common subdivision, which is the property "kind" of files.
enum class Vertex_kind : std::int64_t
{
  input,    // a vertex of the input
  crossing, // of an edge with another
  inserted, // a vertex of another triangulation only
  bend      // of an edge, inside a face
};

// Returns the points and polygons of a mesh.
Output_mesh output_mesh(const Mesh& mesh);
Output_mesh output_mesh(const Polygon_soup& soup);

// Returns the points and edges of a mesh, and its polygons.
Output_mesh output_mesh_with_edges(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces);

// Adds data of its points, corners and polygons. A name that exists already gets the prefix
// "input_".
void add_data(Output_mesh& mesh, Mesh_data data);

// Returns the data of the input at the positions of points and polygons on it.
Mesh_data data_at(const Input_mesh& input, const Polygons& polygons, const Placement& placement);

// Adds the data of the input at the position of the mesh on it.
void add_input_data(const Input_mesh& input, Output_mesh& mesh);

#endif // INTRINSIC_OUTPUT_MESH_H
