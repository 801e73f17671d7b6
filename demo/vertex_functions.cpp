// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vertex_functions.h"

#include "Mesh_reader.h"
#include "Program_error.h"
#include "file_extension.h"

#include <array>
#include <cmath>
#include <utility>

namespace {

typedef std::vector<double> Values;

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
  throw Program_error(path + ": " + what);
}

// No component if a vertex has no color.
std::vector<Values> colors(const Vertex_functions& functions)
{
  for(const std::array<const char*, 3>& names :
      {std::array{"red", "green", "blue"}, std::array{"r", "g", "b"}}) {
    std::vector<Values> result;
    for(const char* name : names)
      if(const auto component = functions.find(name); component != functions.end())
        result.push_back(component->second);
    if(result.size() == names.size())
      return result;
  }
  return {};
}

Values property(const std::string& path, const Vertex_functions& functions, const std::string& name)
{
  if(extension_of(path) != ".ply")
    fail(path, "vertices have no property '" + name + "' (.ply can have properties)");
  if(const auto function = functions.find(name); function != functions.end())
    return function->second;
  std::string known;
  for(const auto& [other, values] : functions)
    known += (known.empty() ? "" : ", ") + other;
  fail(path, "vertices have no property '" + name + "'; they have " + known);
}

} // namespace

std::vector<std::vector<double>> read_vertex_function(const std::string& path,
                                                      const std::string& name)
{
  Vertex_functions functions;
  const std::size_t vertices = read_mesh(path, &functions).points.size();
  std::vector<Values> result =
    name == "color" ? colors(functions) : std::vector<Values>{property(path, functions, name)};
  if(result.empty())
    fail(path,
         "vertices have no colors (.ply and .off can have them); give each one, or leave out the "
         "weight of color");
  for(const Values& component : result) {
    if(component.size() != vertices)
      fail(path, "not all vertices have one value of '" + name + "'");
    for(const double x : component)
      if(!std::isfinite(x))
        fail(path, "a value of '" + name + "' is not finite; correct it in the file");
  }
  return result;
}
