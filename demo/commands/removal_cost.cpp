// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/removal_cost.h"

#include "Program_error.h"
#include "reading/Scanner.h"
#include "reading/vertex_functions.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

#include <algorithm>
#include <iterator>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

// The number after the equals sign.
double weight_value(const std::string& text, const std::string& value)
{
  const double result = finite_number(value).value_or(-1);
  if(result < 0)
    throw Program_error("--weight " + text + ": a weight is a number that is not negative");
  return result;
}

bool is_of_change(const std::string& name)
{
  return name == "area_change" || name == "boundary_change";
}

bool is_of_function(const std::string& name)
{
  return name != "curvature" && name != "area" && !is_of_change(name);
}

} // namespace

Cost_weights::Cost_weights(const std::vector<std::string>& texts)
{
  if(texts.empty())
    m_weights = {{"area", IS::default_area_weight},
                 {"area_change", IS::default_area_change_weight},
                 {"boundary_change", IS::default_boundary_change_weight},
                 {"curvature", 1}};
  for(const std::string& text : texts) {
    const std::size_t length = text.rfind('=');
    if(length == std::string::npos || length == 0)
      throw Program_error("--weight " + text + ": is not NAME=W, as in curvature=1");
    m_weights[text.substr(0, length)] = weight_value(text, text.substr(length + 1));
  }
  for(auto w = m_weights.begin(); w != m_weights.end();)
    w = w->second > 0 ? std::next(w) : m_weights.erase(w);
  if(std::all_of(m_weights.begin(), m_weights.end(),
                 [](const auto& weight) { return is_of_change(weight.first); }))
    throw Program_error("--weight: weights that are not given are zero, and changes of area alone "
                        "are not a cost; give another weight that is positive, as curvature=1");
}

void Cost_weights::read_functions(const std::string& path)
{
  for(const auto& weight : m_weights)
    if(is_of_function(weight.first))
      m_functions[weight.first] = read_vertex_function(path, weight.first);
}

bool Cost_weights::has_functions() const
{
  return std::any_of(m_weights.begin(), m_weights.end(),
                     [](const auto& weight) { return is_of_function(weight.first); });
}

IS::Transport_cost Cost_weights::cost(const IS::Evolving_surface& surface) const
{
  IS::Transport_cost result(surface);
  const auto add = [&](const char* name, const auto& member) {
    if(const auto weight = m_weights.find(name); weight != m_weights.end())
      (result.*member)(surface, weight->second);
  };
  add("curvature", &IS::Transport_cost::add_curvature);
  add("area", &IS::Transport_cost::add_area);
  add("area_change", &IS::Transport_cost::add_area_change);
  add("boundary_change", &IS::Transport_cost::add_boundary_change);
  for(const auto& [name, components] : m_functions)
    for(const std::vector<double>& values : components)
      result.add_function(surface, values, m_weights.at(name) / double(components.size()));
  return result;
}
