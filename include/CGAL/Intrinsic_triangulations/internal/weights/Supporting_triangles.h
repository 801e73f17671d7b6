// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_SUPPORTING_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_SUPPORTING_TRIANGLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a triangle of three lifted points, which hides a vertex. If the lifted point of this
// vertex lies in it, its weight is a constant plus a convex combination of the three weights.
template <typename FT>
struct Supporting_triangle
{
  FT constant;
  std::array<std::pair<Vertex_index, FT>, 3> part; // nonnegative, with sum 1
};

// Stores the triangles that hide vertices, at most one for each vertex. They depend on each other,
// so their weights solve a linear system. Elimination needs no subtraction of coefficients
// (Grassmann, Taksar and Heyman), so that vertices close to each other lose no digits.
template <typename FT>
class Supporting_triangles
{
public:
  void set(Vertex_index hidden, const Supporting_triangle<FT>& triangle)
  {
    m_triangle[hidden] = triangle;
  }

  // Sets the weights of all hidden vertices. Complexity: almost linear, because hidden vertices
  // form only small cycles.
  // \throws Numerical_error if vertices hide each other in a cycle
  void set_weights(std::vector<FT>& weights) const
  {
    Elimination elimination(m_triangle, weights);
    elimination.solve(weights);
  }

  // Checks that a relative error `u` of weights moves no hidden vertex by more than the heights of
  // lifted points, which are squares of lengths.
  // \throws Numerical_error if a hidden vertex moves farther
  void check_digits(const std::vector<FT>& weights, const FT& u) const
  {
    const auto size = [](const FT& x) { return x > 0 ? x : FT(-x); };
    for(const auto& [v, triangle] : m_triangle)
      if(size(triangle.constant) < u * size(weights[v.idx()]))
        throw Numerical_error("the weights that hide vertex " + std::to_string(v.idx()) +
                              " are so great that rounding exceeds the squares of lengths");
  }

private:
  typedef std::map<Vertex_index, Supporting_triangle<FT>> Triangles;

  // Stores the equation of a weight. Weights of visible vertices are part of the constant.
  struct Equation
  {
    FT constant = FT(0), visible_part = FT(0);
    std::map<Vertex_index, FT> part;  // of other hidden vertices
    std::set<Vertex_index> dependent; // vertices whose equations have this weight
  };

  class Elimination
  {
  public:
    Elimination(const Triangles& triangles, const std::vector<FT>& weights)
    {
      for(const auto& [v, triangle] : triangles)
        m_equation[v].constant = triangle.constant;
      for(const auto& [v, triangle] : triangles)
        for(const auto& [w, part] : triangle.part)
          add(part, w, v, weights[w.idx()]);
      for(const auto& [v, equation] : m_equation)
        m_open.insert({cost(v), v});
    }

    void solve(std::vector<FT>& weights)
    {
      std::vector<Vertex_index> order;
      while(!m_open.empty()) {
        order.push_back(m_open.begin()->second);
        m_open.erase(m_open.begin());
        eliminate(order.back());
      }
      for(; !order.empty(); order.pop_back()) {
        const Equation& equation = m_equation[order.back()];
        FT weight = equation.constant;
        for(const auto& [w, part] : equation.part)
          weight += part * weights[w.idx()];
        weights[order.back().idx()] = weight;
      }
    }

  private:
    // Adds `part` times the weight of `w` to the equation of `v`. The weight of `v` itself is
    // dropped, because `normalize()` compensates it.
    void add(const FT& part, Vertex_index w, Vertex_index v, const FT& weight)
    {
      const auto of_w = m_equation.find(w);
      if(w == v || part == 0)
        return;
      Equation& equation = m_equation[v];
      if(of_w == m_equation.end()) {
        equation.constant += part * weight;
        equation.visible_part += part;
      } else {
        equation.part[w] += part;
        of_w->second.dependent.insert(v);
      }
    }

    std::size_t cost(Vertex_index v) const
    {
      const Equation& equation = m_equation.at(v);
      return equation.part.size() * equation.dependent.size();
    }

    // Divides an equation by the sum of its coefficients.
    void normalize(Vertex_index v)
    {
      Equation& equation = m_equation[v];
      FT sum = equation.visible_part;
      for(const auto& [w, part] : equation.part)
        sum += part;
      if(!(sum > 0))
        throw Numerical_error("vertices hide each other around vertex " + std::to_string(v.idx()));
      equation.constant /= sum;
      equation.visible_part /= sum;
      for(auto& [w, part] : equation.part)
        part /= sum;
    }

    // Replaces the weight of `v` in all open equations.
    void eliminate(Vertex_index v)
    {
      normalize(v);
      const Equation& equation = m_equation[v];
      for(const auto& [w, part] : equation.part)
        change(w, [&](Equation& of_w) { of_w.dependent.erase(v); });
      for(const Vertex_index u : equation.dependent)
        change(u, [&](Equation& of_u) {
          const FT factor = of_u.part.at(v);
          of_u.part.erase(v);
          of_u.constant += factor * equation.constant;
          of_u.visible_part += factor * equation.visible_part;
          for(const auto& [w, part] : equation.part)
            if(w != u) {
              of_u.part[w] += factor * part;
              change(w, [&, u = u](Equation& of_w) { of_w.dependent.insert(u); });
            }
        });
    }

    template <typename Function>
    void change(Vertex_index v, const Function& function)
    {
      m_open.erase({cost(v), v});
      function(m_equation[v]);
      m_open.insert({cost(v), v});
    }

    std::map<Vertex_index, Equation> m_equation;
    std::set<std::pair<std::size_t, Vertex_index>> m_open;
  };

  Triangles m_triangle;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_SUPPORTING_TRIANGLES_H
