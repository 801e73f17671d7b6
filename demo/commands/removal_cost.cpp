// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/removal_cost.h"

#include "Program_error.h"
#include "reading/Scanner.h"
#include "reading/text_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace {

// Returns the number after the equals sign.
double weight_value(const std::string& text, const std::string& value)
{
  const double result = finite_number(value).value_or(-1);
  if(result < 0)
    throw Program_error("--weight " + text + ": a weight must be a number that is not negative");
  return result;
}

typedef std::vector<std::vector<double>> Components;

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
  throw Program_error(path + ": " + what);
}

// Returns the colors, or no component if a vertex has no color.
Components colors(const Mesh_data& data)
{
  for(const std::array<const char*, 3>& names :
      {std::array{"red", "green", "blue"}, std::array{"r", "g", "b"}}) {
    Components result;
    for(const char* name : names)
      if(const Point_function* component = data.function(name))
        result.push_back(component->values);
    if(result.size() == names.size())
      return result;
  }
  return {};
}

// Returns a property of vertices. Coordinates are functions, too.
std::vector<double> property(const std::string& path, const Input_mesh& input,
                             const std::string& name)
{
  if(extension_of(path) != ".ply")
    fail(path, "vertices have no property '" + name + "' (.ply can have properties)");
  if(const Point_function* function = input.data.function(name))
    return function->values;
  std::vector<double> result;
  std::set<std::string> names;
  for(int k = 0; k < 3; ++k)
    if(const auto axis = names.insert({"xyz"[k]}).first; *axis == name)
      for(const Point& p : input.mesh.points())
        result.push_back(p[k]);
  if(!result.empty())
    return result;
  for(const Point_function& f : input.data.functions)
    names.insert(f.name);
  std::string known;
  for(const std::string& other : names)
    known += (known.empty() ? "" : ", ") + other;
  fail(path, "vertices have no property '" + name + "'; they have " + known);
}

// Returns the components of a function. "color" has three components, a property of .ply has one.
Components vertex_function(const std::string& path, const Input_mesh& input,
                           const std::string& name)
{
  const Components result =
    name == "color" ? colors(input.data) : Components{property(path, input, name)};
  if(result.empty())
    fail(path, "vertices have no colors (.ply, .off and .obj can have them); give each one, or "
               "leave out the weight of color");
  for(const std::vector<double>& component : result)
    for(const double x : component)
      if(!std::isfinite(x))
        fail(path, "a value of '" + name + "' is not finite; correct it in the file");
  return result;
}

} // namespace

Cost_weights::Cost_weights(const std::vector<std::string>& texts)
{
  if(texts.empty())
    m_weights = default_weights();
  for(const std::string& text : texts) {
    const std::size_t length = text.rfind('=');
    if(length == std::string::npos || length == 0)
      throw Program_error("--weight " + text + ": is not NAME=W, as in curvature=1");
    const double weight = weight_value(text, text.substr(length + 1));
    if(!m_weights.emplace(text.substr(0, length), weight).second)
      throw Program_error("--weight: " + text.substr(0, length) + " has two weights; give one");
  }
  for(auto w = m_weights.begin(); w != m_weights.end();)
    w = w->second > 0 ? std::next(w) : m_weights.erase(w);
  if(std::all_of(m_weights.begin(), m_weights.end(),
                 [](const auto& weight) { return is_part_of_change(weight.first); }))
    throw Program_error("--weight: weights that are not given are zero, and changes of area alone "
                        "are not a cost; give another weight that is positive, as curvature=1");
}

void Cost_weights::set_functions(const std::string& path, const Input_mesh& input)
{
  m_functions.clear();
  for(const auto& weight : m_weights)
    if(is_name_of_function(weight.first))
      m_functions[weight.first] = vertex_function(path, input, weight.first);
}

bool Cost_weights::has_functions() const
{
  return std::any_of(m_weights.begin(), m_weights.end(),
                     [](const auto& weight) { return is_name_of_function(weight.first); });
}
