// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_REMOVAL_COST_H
#define INTRINSIC_REMOVAL_COST_H

#include "commands/weighted_cost.h"
#include "reading/Input_mesh.h"

#include <string>
#include <vector>

// Stores the weights of curvature, of area and its changes, and of functions on the vertices in the
// cost of a removal, by their names.
class Cost_weights
{
public:
  // Reads texts "name=value". Names that are missing have no weight. Without any text, the weights
  // are the weights of `default_cost()`.
  // Throws Program_error if a text is not of this form, a value is negative, or only weights of
  // changes are positive.
  explicit Cost_weights(const std::vector<std::string>& texts);

  // Returns the positive weights, by their names.
  const Named_weights& values() const { return m_weights; }

  // Reads the functions that have weights from the mesh, whose file is `path`.
  // Throws Program_error if it has no such function, or a value is not finite.
  void set_functions(const std::string& path, const Input_mesh& input);

  // Returns whether such functions exist.
  bool has_functions() const;

  // Calls `visit(values)` with each component of each function, which it may change.
  template <class Visit>
  void for_each_function(const Visit& visit)
  {
    for(auto& [name, components] : m_functions)
      for(std::vector<double>& values : components)
        visit(values);
  }

  // Returns the cost of removals from the surface.
  // Precondition: the functions have been set, and have values at all vertices.
  CGAL::Intrinsic_simplification::Transport_cost
  cost(const CGAL::Intrinsic_simplification::Evolving_surface& surface) const
  {
    return weighted_cost(surface, m_weights, m_functions);
  }

private:
  Named_weights m_weights;
  Named_functions m_functions;
};

#endif // INTRINSIC_REMOVAL_COST_H
