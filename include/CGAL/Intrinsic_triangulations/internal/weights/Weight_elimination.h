// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_ELIMINATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_ELIMINATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Vertex_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Decides exactly whether edges at hidden vertices are weighted Delaunay. The weight of a hidden
// vertex is equal to its bound, which is a linear equation. Gaussian elimination of these weights
// leaves a constant, which has the sign of the edge.
template <typename Development>
class Weight_elimination
{
  typedef typename Development::Complex Number;

public:
  Weight_elimination(const Delta_complex& mesh, const Vertex_weights& weights,
                     const Development& development)
    : m_mesh(mesh), m_weights(weights), m_development(development)
  {}

  // Returns the sign of the dual edge of the edge of `h`. It is not determined if too many weights
  // depend on each other.
  Uncertain<Sign> sign(Halfedge_index h)
  {
    Form form = given_weights_replaced(dual_edge_form(h, m_mesh, m_development));
    while(!form.coefficient.empty()) {
      if(m_equations.size() == most_equations || !add_equation(next_vertex(form, h)))
        return Uncertain<Sign>::indeterminate();
      m_equations.back().eliminate(form);
    }
    return sign_of_real(form.constant);
  }

private:
  // A greater number would take too long.
  static constexpr std::size_t most_equations = 64;

  // Stores a linear function of the weights of hidden vertices. No coefficient is zero.
  struct Form
  {
    Number constant;
    std::map<Vertex_index, Number> coefficient;

    void add(const Number& x, Vertex_index v)
    {
      const auto [place, is_new] = coefficient.try_emplace(v, x);
      if(!is_new)
        place->second = place->second + x;
      if(sign_of_real(place->second) == ZERO)
        coefficient.erase(place);
    }

    void multiply(const Number& factor)
    {
      constant = constant * factor;
      for(auto& [v, x] : coefficient)
        x = x * factor;
    }
  };

  // States that a function of weights is zero, which determines the weight of a vertex. The
  // coefficient of this weight is one, so that the digits of numbers grow slowly.
  struct Equation
  {
    Vertex_index vertex;
    Form form;

    // Replaces the weight of the vertex in a function.
    void eliminate(Form& other) const
    {
      const auto found = other.coefficient.find(vertex);
      if(found == other.coefficient.end())
        return;
      const Number part = found->second;
      other.coefficient.erase(found);
      other.constant = other.constant - form.constant * part;
      for(const auto& [v, coefficient] : form.coefficient)
        if(v != vertex)
          other.add(-(coefficient * part), v);
    }
  };

  Form given_weights_replaced(const Weight_form<Number>& all) const
  {
    Form form{all.constant, {}};
    for(const auto& [v, coefficient] : all.terms)
      if(m_weights.is_hidden(v))
        form.add(coefficient, v);
      else
        form.constant = form.constant + coefficient * m_development.number(m_weights.given(v));
    return form;
  }

  // Adds the equation of the weight of `v`, and returns whether it is usable.
  bool add_equation(Vertex_index v)
  {
    const Weight_bound& bound = m_weights.hidden().at(v).bound;
    Equation equation{v, given_weights_replaced(weight_bound_form(bound, m_mesh, m_development))};
    for(const Equation& earlier : m_equations)
      earlier.eliminate(equation.form);
    const auto pivot = equation.form.coefficient.find(v);
    if(pivot == equation.form.coefficient.end() ||
       !certainly(sign_of_real(pivot->second) == POSITIVE))
      return false;
    equation.form.multiply(inverse(pivot->second));
    m_equations.push_back(std::move(equation));
    return true;
  }

  // Returns the vertex whose weight is to be eliminated next. An equation that concerns only the
  // corners of the diamond of `h` comes first, because it may prove a tie without other equations.
  Vertex_index next_vertex(const Form& form, Halfedge_index h) const
  {
    const std::array<Vertex_index, 4> corners = diamond_corners(h, m_mesh);
    const auto found =
      std::find_if(form.coefficient.begin(), form.coefficient.end(), [&](const auto& term) {
        const Weight_bound& bound = m_weights.hidden().at(term.first).bound;
        return are_among(bound.corners(m_mesh), corners);
      });
    return found == form.coefficient.end() ? form.coefficient.begin()->first : found->first;
  }

  static bool are_among(const std::array<Vertex_index, 4>& some,
                        const std::array<Vertex_index, 4>& all)
  {
    return std::all_of(some.begin(), some.end(), [&](Vertex_index v) {
      return std::find(all.begin(), all.end(), v) != all.end();
    });
  }

  const Delta_complex& m_mesh;
  const Vertex_weights& m_weights;
  const Development& m_development;
  std::vector<Equation> m_equations;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_ELIMINATION_H
