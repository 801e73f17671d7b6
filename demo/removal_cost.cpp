// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "removal_cost.h"

#include "Program_error.h"
#include "vertex_functions.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

// The number after the equals sign.
double weight_value(const std::string& text, const std::string& value)
{
  char* end = nullptr;
  const double result = std::strtod(value.c_str(), &end);
  if(value.empty() || *end != '\0' || !std::isfinite(result) || result < 0)
    throw Program_error("--weight " + text + ": a weight is a number that is not negative");
  return result;
}

// Whether a weight is that of a function that counts.
bool is_of_function(const std::pair<const std::string, double>& weight)
{
  return weight.second > 0 && weight.first != "curvature" && weight.first != "area" &&
         weight.first != "area_change";
}

} // namespace

Cost_weights::Cost_weights(const std::vector<std::string>& texts)
  : m_weights{{"area", IS::default_area_weight},
              {"area_change", IS::default_area_change_weight},
              {"curvature", 1}}
{
  for(const std::string& text : texts) {
    const std::size_t length = text.rfind('=');
    if(length == std::string::npos || length == 0)
      throw Program_error("--weight " + text + ": is not NAME=W, as in curvature=1");
    m_weights[text.substr(0, length)] = weight_value(text, text.substr(length + 1));
  }
  if(m_weights["curvature"] == 0 && m_weights["area"] == 0 && !has_functions())
    throw Program_error(
      "--weight: area_change alone is not a cost; give another weight that is positive");
}

void Cost_weights::read_functions(const std::string& path)
{
  for(const auto& weight : m_weights)
    if(is_of_function(weight))
      m_functions[weight.first] = read_vertex_function(path, weight.first);
}

bool Cost_weights::has_functions() const
{
  return std::any_of(m_weights.begin(), m_weights.end(), is_of_function);
}

IS::Transport_cost Cost_weights::cost(const IS::Evolving_surface& surface) const
{
  IS::Transport_cost result(surface);
  if(m_weights.at("curvature") > 0)
    result.add_curvature(surface, m_weights.at("curvature"));
  if(m_weights.at("area") > 0)
    result.add_area(surface, m_weights.at("area"));
  result.add_area_change(surface, m_weights.at("area_change"));
  for(const auto& [name, components] : m_functions)
    for(const std::vector<double>& values : components)
      result.add_function(surface, values, m_weights.at(name) / double(components.size()));
  return result;
}
