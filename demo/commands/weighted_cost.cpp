// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/weighted_cost.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

namespace IS = CGAL::Intrinsic_simplification;

Named_weights default_weights()
{
  return {{"area", IS::default_area_weight},
          {"area_change", IS::default_area_change_weight},
          {"boundary_change", IS::default_boundary_change_weight},
          {"curvature", 1}};
}

bool is_part_of_change(const std::string& name)
{
  return name == "area_change" || name == "boundary_change";
}

bool is_name_of_function(const std::string& name)
{
  return name != "curvature" && name != "area" && !is_part_of_change(name);
}

IS::Transport_cost weighted_cost(const IS::Evolving_surface& surface, const Named_weights& weights,
                                 const Named_functions& functions)
{
  IS::Transport_cost result(surface);
  const auto add = [&](const char* name, const auto& member) {
    if(const auto weight = weights.find(name); weight != weights.end())
      (result.*member)(surface, weight->second);
  };
  add("curvature", &IS::Transport_cost::add_curvature);
  add("area", &IS::Transport_cost::add_area);
  add("area_change", &IS::Transport_cost::add_area_change);
  add("boundary_change", &IS::Transport_cost::add_boundary_change);
  for(const auto& [name, components] : functions)
    for(const std::vector<double>& values : components)
      result.add_function(surface, values, weights.at(name) / double(components.size()));
  return result;
}
