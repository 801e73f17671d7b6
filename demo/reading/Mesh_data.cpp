// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Mesh_data.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace {

typedef Polygons::Index Index;
typedef Corner_data_builder::Coordinates Coordinates;

bool is_byte(double x) { return x >= 0 && x <= 255 && x == std::floor(x); }

bool is_color_name(const std::string& name)
{
  return name == "red" || name == "green" || name == "blue";
}

// Returns the value of a linear function. Constants are reproduced exactly for all weights.
template <class Value>
double linear_value(const Point_weights& w, const Value& value)
{
  std::size_t first = 0;
  while(first + 1 < w.size && w.weight[first] == 0)
    ++first;
  const double origin = value(first);
  double result = origin;
  for(std::size_t c = first + 1; c < w.size; ++c)
    if(w.weight[c] != 0)
      result += w.weight[c] * (value(c) - origin);
  return result;
}

Point_function carried(const Point_function& from, const Placed_mesh& mesh)
{
  Point_function result{from.name, {}, from.has_fractions, from.is_color};
  result.values.reserve(mesh.number_of_points);
  for(std::size_t i = 0; i < mesh.number_of_points; ++i) {
    const Point_weights w = mesh.weights(i);
    const double x = linear_value(w, [&](std::size_t c) { return from.values[w.point[c]]; });
    result.values.push_back(from.is_color ? std::round(x) : x);
  }
  return result;
}

// Returns the coordinates of a point of a triangle.
Coordinates coordinates(const Corner_data& data, const Polygons& triangles, std::size_t triangle,
                        const Point_weights& w)
{
  const Polygons::Polygon corners = triangles[triangle];
  std::array<Index, 3> number{};
  for(std::size_t c = 0; c < w.size; ++c) {
    const auto corner = std::find(corners.begin(), corners.end(), w.point[c]);
    number[c] = corner == corners.end()
                  ? Polygons::none
                  : data.polygons[triangle][static_cast<std::size_t>(corner - corners.begin())];
    if(number[c] == Polygons::none)
      return Corner_data_builder::missing;
  }
  Coordinates result{0, 0, 1};
  for(std::size_t k = 0; k < data.dimension; ++k)
    result[k] = linear_value(w, [&](std::size_t c) { return data.coordinates[number[c]][k]; });
  return result;
}

void carry(const Corner_data& from, const Polygons& triangles, const Placed_mesh& mesh,
           Mesh_data& result)
{
  Corner_data_builder builder(from.name, from.dimension);
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    for(std::size_t k = 0; k < mesh.polygons[i].size(); ++k) {
      const Index point = mesh.polygons[i][k];
      const std::int64_t triangle = mesh.triangle(i, k);
      builder.add_corner(point, triangle < 0
                                  ? Corner_data_builder::missing
                                  : coordinates(from, triangles, static_cast<std::size_t>(triangle),
                                                mesh.weights(point)));
    }
    builder.close();
  }
  builder.finish(result);
}

// Returns whether every point has exactly one coordinate.
bool is_of_points(const Corner_data& data, std::size_t points)
{
  return data.coordinates.size() == points &&
         std::none_of(data.polygons.corners().begin(), data.polygons.corners().end(),
                      [](Index c) { return c == Polygons::none; });
}

void add_functions(const Corner_data& normals, const Polygons& polygons, Mesh_data& data)
{
  const std::vector<Index>&points = polygons.corners(), &numbers = normals.polygons.corners();
  for(std::size_t k = 0; k < 3; ++k) {
    Point_function f{{'n', "xyz"[k]}, std::vector<double>(normals.coordinates.size())};
    for(std::size_t c = 0; c < points.size(); ++c)
      f.values[points[c]] = normals.coordinates[numbers[c]][k];
    data.functions.push_back(std::move(f));
  }
}

} // namespace

const Point_function* Mesh_data::function(const std::string& name) const
{
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const Point_function& f) { return f.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

bool is_texture(const Corner_data& data) { return data.name.find("texcoord") != std::string::npos; }

std::size_t corner_dimension(std::string_view name)
{
  while(name.substr(0, 6) == "input_")
    name.remove_prefix(6);
  if(name == "texcoord")
    return 2;
  return name == "homogeneous_texcoord" || name == "normal" ? 3 : 0;
}

Corner_data_builder::Corner_data_builder(std::string name, std::size_t dimension)
{
  m_result.name = std::move(name);
  m_result.dimension = dimension;
}

void Corner_data_builder::add_corner(Index point, const Coordinates& coordinates)
{
  const bool is_finite =
    std::all_of(coordinates.begin(), coordinates.end(), [](double x) { return std::isfinite(x); });
  m_result.polygons.add_corner(is_finite ? number(point, coordinates) : Polygons::none);
}

Index Corner_data_builder::number(Index point, const Coordinates& coordinates)
{
  const auto add = [&] {
    m_result.coordinates.push_back(coordinates);
    return static_cast<Index>(m_result.coordinates.size() - 1);
  };
  if(point >= m_first.size())
    m_first.resize(std::size_t(point) + 1, Polygons::none);
  if(m_first[point] == Polygons::none)
    m_first[point] = add();
  if(m_result.coordinates[m_first[point]] == coordinates)
    return m_first[point];
  // Adding zero unites both signs of zero.
  const Coordinates key{coordinates[0] + 0., coordinates[1] + 0., coordinates[2] + 0.};
  const auto [other, is_new] = m_others.try_emplace(Key(point, key), Polygons::none);
  if(is_new)
    other->second = add();
  return other->second;
}

void Corner_data_builder::finish(Mesh_data& data)
{
  if(!m_result.coordinates.empty())
    data.corners.push_back(std::move(m_result));
}

void add_corner_data(const std::string& name, std::size_t dimension, const Polygons& polygons,
                     std::size_t points, const std::function<Coordinates(std::size_t)>& coordinates,
                     Mesh_data& data)
{
  Corner_data_builder builder(name, dimension);
  std::size_t corner = 0;
  for(const Polygons::Polygon& polygon : polygons) {
    for(const Index v : polygon) {
      const bool is_point = v < points;
      builder.add_corner(is_point ? v : 0,
                         is_point ? coordinates(corner) : Corner_data_builder::missing);
      ++corner;
    }
    builder.close();
  }
  builder.finish(data);
  if(name != "normal" || data.corners.empty() || !is_of_points(data.corners.back(), points))
    return;
  const Corner_data normals = std::move(data.corners.back());
  data.corners.pop_back();
  add_functions(normals, polygons, data);
}

void make_bytes(std::vector<std::vector<double>>& colors)
{
  enum Kind
  {
    fractions,
    bytes,
    both
  };
  const auto kind_of = [&](std::size_t i) {
    double greatest = 0;
    bool are_integers = true;
    for(std::size_t k = 0; k < 3; ++k) {
      greatest = (std::max)(greatest, colors[k][i]);
      are_integers = are_integers && colors[k][i] == std::floor(colors[k][i]);
    }
    return are_integers ? (greatest > 1 ? bytes : both) : (greatest < 2 ? fractions : bytes);
  };
  std::vector<Kind> kinds;
  for(std::size_t i = 0; i < colors[0].size(); ++i)
    kinds.push_back(kind_of(i));
  const auto have = [&](Kind k) { return std::count(kinds.begin(), kinds.end(), k) > 0; };
  const Kind doubtful = have(bytes) && !have(fractions) ? bytes : fractions;
  for(std::vector<double>& component : colors)
    for(std::size_t i = 0; i < component.size() && i < kinds.size(); ++i) {
      const bool is_byte = (kinds[i] == both ? doubtful : kinds[i]) == bytes;
      component[i] = std::ceil(std::clamp((is_byte ? 1 : 255) * component[i], 0., 255.) - 0.5);
    }
}

void clean(Mesh_data& data, std::size_t points)
{
  auto& all = data.functions;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const Point_function& f) { return f.values.size() != points; }),
            all.end());
  const auto has_bytes = [](const Point_function& f) {
    return !f.has_fractions && std::all_of(f.values.begin(), f.values.end(), is_byte);
  };
  const bool are_colors = std::all_of(all.begin(), all.end(), [&](const Point_function& f) {
    return !is_color_name(f.name) || has_bytes(f);
  });
  for(Point_function& f : all)
    f.is_color = are_colors && (is_color_name(f.name) || (f.name == "alpha" && has_bytes(f)));
}

Corner_data texture_on(const Polygons& polygons, const std::vector<Corner_data>& all)
{
  const auto found = std::find_if(all.begin(), all.end(), is_texture);
  if(found == all.end())
    return {};
  Corner_data result{found->name, found->dimension, found->coordinates, {}};
  std::map<Index, Index> missing;
  for(std::size_t i = 0; i < polygons.size(); ++i) {
    for(std::size_t k = 0; k < polygons[i].size(); ++k) {
      Index number = found->polygons[i][k];
      if(number == Polygons::none) {
        const auto size = static_cast<Index>(result.coordinates.size());
        const auto [place, is_new] = missing.emplace(polygons[i][k], size);
        if(is_new)
          result.coordinates.push_back(Corner_data_builder::missing);
        number = place->second;
      }
      result.polygons.add_corner(number);
    }
    result.polygons.close();
  }
  return result;
}

Mesh_data carried(const Triangle_data& data, const Placed_mesh& mesh)
{
  Mesh_data result;
  for(const Point_function& f : data.functions)
    result.functions.push_back(carried(f, mesh));
  for(const Corner_data& c : data.corners)
    carry(c, data.triangles, mesh, result);
  result.groups = data.groups;
  result.groups.carry(mesh.polygons.size(), [&](std::size_t i) { return mesh.triangle(i, 0); });
  return result;
}
