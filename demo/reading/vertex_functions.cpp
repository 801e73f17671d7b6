// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/vertex_functions.h"

#include "Program_error.h"
#include "reading/Mesh_reader.h"
#include "reading/file_extension.h"

#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
  throw Program_error(path + ": " + what);
}

// No component if a vertex has no color.
std::vector<std::vector<double>> colors(const Mesh_data& data)
{
  for(const std::array<const char*, 3>& names :
      {std::array{"red", "green", "blue"}, std::array{"r", "g", "b"}}) {
    std::vector<std::vector<double>> result;
    for(const char* name : names)
      if(const Point_function* component = data.function(name))
        result.push_back(component->values);
    if(result.size() == names.size())
      return result;
  }
  return {};
}

std::vector<double> property(const std::string& path, const Mesh_data& data,
                             const std::string& name)
{
  if(extension_of(path) != ".ply")
    fail(path, "vertices have no property '" + name + "' (.ply can have properties)");
  if(const Point_function* function = data.function(name))
    return function->values;
  std::set<std::string> names;
  for(const Point_function& f : data.functions)
    names.insert(f.name);
  std::string known;
  for(const std::string& other : names)
    known += (known.empty() ? "" : ", ") + other;
  fail(path, "vertices have no property '" + name + "'; they have " + known);
}

// The coordinates are functions, too.
Mesh_data data_with_positions(const std::string& path)
{
  Polygon_soup soup = read_mesh(path);
  for(int k = 0; k < 3; ++k) {
    Point_function f{std::string(1, "xyz"[k]), {}};
    for(const Point& p : soup.points)
      f.values.push_back(p[k]);
    soup.data.functions.push_back(std::move(f));
  }
  return std::move(soup.data);
}

} // namespace

std::vector<std::vector<double>> read_vertex_function(const std::string& path,
                                                      const std::string& name)
{
  const Mesh_data data = data_with_positions(path);
  std::vector<std::vector<double>> result =
    name == "color" ? colors(data) : std::vector<std::vector<double>>{property(path, data, name)};
  if(result.empty())
    fail(path, "vertices have no colors (.ply, .off and .obj can have them); give each one, or "
               "leave out the "
               "weight of color");
  for(const std::vector<double>& component : result)
    for(const double x : component)
      if(!std::isfinite(x))
        fail(path, "a value of '" + name + "' is not finite; correct it in the file");
  return result;
}
