// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_DATA_H
#define INTRINSIC_MESH_DATA_H

#include "reading/Polygons.h"

#include <boost/container_hash/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

// Stores a number at each point.
struct Point_function
{
  std::string name;
  std::vector<double> values;
  bool has_fractions = false; // its numbers are of a type with fractions
  bool is_color = false;      // an integer up to 255, and interpolated as one
};

// Stores coordinates at the corners of polygons, which may differ at one point: a texture, or
// normals.
struct Corner_data
{
  std::string name;
  std::size_t dimension = 0; // zero if there is nothing; 2, the third being 1, or 3
  std::vector<std::array<double, 3>> coordinates;
  Polygons polygons; // with coordinates in place of points; none where there are no coordinates
};

// Returns whether the data are not a list of normals.
bool is_texture(const Corner_data& data);

// Stores groups of polygons, as .obj has them: objects, groups and materials.
struct Polygon_groups
{
  std::vector<std::string> libraries;      // lines that name files with materials
  std::vector<std::string> lines;          // those that begin each group
  std::vector<Polygons::Index> of_polygon; // none before the first; empty if there are no groups

  Polygons::Index operator[](std::int64_t polygon) const
  {
    const auto i = static_cast<std::size_t>(polygon);
    return i < of_polygon.size() ? of_polygon[i] : Polygons::none;
  }

  // Maps the groups to other polygons. Number i is a part of polygon `parent(i)`, or of none for
  // -1.
  template <class Parent>
  void carry(std::size_t size, const Parent& parent)
  {
    std::vector<Polygons::Index> result(of_polygon.empty() ? 0 : size);
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = (*this)[parent(i)];
    of_polygon = std::move(result);
  }
};

// Stores the data of a mesh beside positions.
struct Mesh_data
{
  std::vector<Point_function> functions;
  std::vector<Corner_data> corners;
  Polygon_groups groups;

  bool empty() const { return functions.empty() && corners.empty() && groups.of_polygon.empty(); }

  // Returns the function with this name, or null if none exists.
  const Point_function* function(const std::string& name) const;
};

// Returns the dimension of corner coordinates in a list of this name. Returns zero if it is not a
// name of corner data, with or without the prefix "input_".
std::size_t corner_dimension(std::string_view name);

// Numbers coordinates corner by corner. Equal coordinates at one point get one number, so that only
// seams have several.
class Corner_data_builder
{
public:
  typedef std::array<double, 3> Coordinates;

  // This value stands for missing coordinates.
  static constexpr Coordinates missing{std::numeric_limits<double>::quiet_NaN(), 0, 0};

  Corner_data_builder(std::string name, std::size_t dimension);

  // Adds the next corner of a polygon. If a coordinate is not finite, the corner has none.
  void add_corner(Polygons::Index point, const Coordinates& coordinates);
  void close() { m_result.polygons.close(); }

  // Adds the data, unless no corner has any.
  void finish(Mesh_data& data);

private:
  typedef std::pair<Polygons::Index, Coordinates> Key;

  Polygons::Index number(Polygons::Index point, const Coordinates& coordinates);

  Corner_data m_result;
  std::vector<Polygons::Index> m_first; // of each point
  std::unordered_map<Key, Polygons::Index, boost::hash<Key>> m_others;
};

// Adds coordinates at the corners of polygons, some of which may name nonexistent points.
// `coordinates` returns the coordinates of a corner, counted over all polygons. Normals become
// functions nx, ny and nz if each point has one.
void add_corner_data(
  const std::string& name, std::size_t dimension, const Polygons& polygons, std::size_t points,
  const std::function<Corner_data_builder::Coordinates(std::size_t)>& coordinates, Mesh_data& data);

// Converts colors to integers up to 255. `colors` has all values of each component, also of alpha.
// A color is in fractions if it has others than integers, and all are below 2. It is in integers up
// to 255 if one is greater than 1. If neither holds, it is like the other colors. Halves are
// rounded down, as CGAL does.
void make_bytes(std::vector<std::vector<double>>& colors);

// Removes functions without a value at each of `points` points, and finds the colors. Red, green
// and blue are colors only together: if one of them has fractions, or is out of range, none is.
void clean(Mesh_data& data, std::size_t points);

// Stores data of triangles, which are the triangles of the input or parts of them.
struct Triangle_data : Mesh_data
{
  Polygons triangles;
};

// Represents a point as a convex combination of points of one triangle.
struct Point_weights
{
  std::size_t size = 0;
  std::array<std::size_t, 3> point{};
  std::array<double, 3> weight{};
};

// Returns the first texture, for these polygons. Corners without coordinates at one point share a
// coordinate that is NaN. Without a texture, the dimension is zero.
Corner_data texture_on(const Polygons& polygons, const std::vector<Corner_data>& all);

// Describes the position of a mesh on triangles.
struct Placed_mesh
{
  std::size_t number_of_points;
  const Polygons& polygons;
  std::function<Point_weights(std::size_t)> weights; // of a point
  // Returns the triangle that contains corner k of polygon i, or -1 if it is none.
  std::function<std::int64_t(std::size_t i, std::size_t k)> triangle;
};

// Returns the data at the points and corners of the mesh, linear in each triangle.
Mesh_data carried(const Triangle_data& data, const Placed_mesh& mesh);

#endif // INTRINSIC_MESH_DATA_H
