// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_HIDDEN_WEIGHTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_HIDDEN_WEIGHTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Supporting_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Vertex_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds edges that must be ties if all hidden vertices have their bounds as weights. Let the faces
// of a fan have positive area. Then the difference between a weight and its bound is a positive
// combination of signed lengths of dual edges inside the fan. All these differences are zero, and
// they are linearly independent. If fans that share edges have as many edges in total as there are
// fans, all dual edges are zero.
class Tied_edges
{
public:
  // `has_area(bound)` returns whether all faces of a fan have positive area.
  template <typename Has_area>
  Tied_edges(const Delta_complex& mesh, const std::map<Vertex_index, Hidden_weight>& hidden,
             const Has_area& has_area)
    : m_sets(boost::make_assoc_property_map(m_rank), boost::make_assoc_property_map(m_parent))
  {
    for(const auto& [v, weight] : hidden)
      m_sets.make_set(v);
    for(const auto& [v, weight] : hidden)
      for_each_inner_edge(weight.bound, mesh, [&, v = v](Edge_index e) {
        m_sets.union_set(m_fan.try_emplace(e, v).first->second, v);
      });
    for(const auto& [v, weight] : hidden)
      if(has_area(weight.bound))
        ++m_excess[m_sets.find_set(v)];
    for(const auto& [e, v] : m_fan)
      --m_excess[m_sets.find_set(v)];
  }

  std::set<Edge_index> determined()
  {
    std::set<Edge_index> result;
    for(const auto& [e, v] : m_fan)
      if(m_excess[m_sets.find_set(v)] == 0)
        result.insert(e);
    return result;
  }

private:
  // Calls `use(e)` for the edges that a geodesic may cross, or for all edges of a narrow cone.
  template <typename Use>
  static void for_each_inner_edge(const Weight_bound& bound, const Delta_complex& mesh,
                                  const Use& use)
  {
    const std::vector<Halfedge_index> outgoing = bound.fan(mesh);
    for(std::size_t i = bound.faces > 0 ? 1 : 0; i + 1 < outgoing.size(); ++i)
      use(mesh.edge(outgoing[i]));
  }

  typedef std::map<Vertex_index, std::size_t> Rank;
  typedef std::map<Vertex_index, Vertex_index> Parent;

  Rank m_rank;
  Parent m_parent;
  boost::disjoint_sets<boost::associative_property_map<Rank>,
                       boost::associative_property_map<Parent>>
    m_sets;
  std::map<Edge_index, Vertex_index> m_fan; // of one of the vertices whose fans contain the edge
  std::map<Vertex_index, long> m_excess;    // of fans over edges
};

// Encloses the weights of hidden vertices. Each is the greatest of the lower bounds that geodesics
// through the vertex give. Bounds depend on the weights of other hidden vertices. So the greatest
// bounds are chosen and a linear system is solved alternately (policy iteration).
template <typename Traits>
class Hidden_weights
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Ball<Long_float> Number;
  typedef Rounded_corners<Long_float, typename Input_metric_of<Traits>::Number> Corners;

public:
  Hidden_weights(const Pair& pair, const Edge_courses<Traits>& courses, Vertex_weights& weights)
    : m_pair(pair),
      m_courses(courses),
      m_corners(exact_input(pair)),
      m_find_bounds(pair, courses),
      m_weights(weights),
      m_value(pair.mesh().num_vertices()),
      m_growth(pair.mesh().num_vertices())
  {
    for(Vertex_index v : pair.mesh().vertices())
      m_value[v.idx()] = Long_float(weights.given(v));
  }

  // Encloses the weights of the vertices that are hidden according to `weights`. If this fails,
  // their errors are infinite. Vertices without any bound count as visible, and are returned.
  std::vector<Vertex_index> enclose()
  {
    const std::vector<Vertex_index> visible = add_bounds();
    for(Vertex_index v : visible)
      m_weights.hidden().erase(v);
    set_intervals();
    return visible;
  }

private:
  void set_intervals()
  {
    try {
      if(m_bounds.empty() || !solve())
        return;
      const double error = greatest_residual();
      for(auto& [v, hidden] : m_weights.hidden()) {
        hidden = {chosen(v).bound, m_value[v.idx()],
                  error * static_cast<double>(m_growth[v.idx()])};
        hidden.bound.is_certain = hidden.bound.is_certain || m_find_bounds.is_certain(hidden.bound);
      }
      m_weights.ties() = Tied_edges(m_pair.mesh(), m_weights.hidden(), [this](const auto& bound) {
                           return m_find_bounds.has_area(bound);
                         }).determined();
    } catch(const Numerical_error&) {
      // The errors stay infinite.
    }
  }

  struct Bound
  {
    Weight_bound bound;
    Weight_form<Number> form; // the weight minus the bound, up to a positive factor
  };

  // A greater bound replaces another one only if it is greater by this part of its terms.
  static Long_float resolution() { return ldexp(Long_float(1), -most_digits / 2); }
  static constexpr int most_rounds = 100;

  // Finds the bounds of all hidden weights. Returns the vertices that have none.
  std::vector<Vertex_index> add_bounds()
  {
    std::vector<Vertex_index> result;
    const Development<Traits, Corners> development(m_pair, m_courses, m_corners);
    for(const auto& [v, hidden] : m_weights.hidden()) {
      const std::vector<Weight_bound> bounds = m_find_bounds(v);
      for(const Weight_bound& b : bounds)
        m_bounds[v].push_back({b, weight_bound_form(b, m_pair.mesh(), development)});
      if(bounds.empty())
        result.push_back(v);
    }
    return result;
  }

  const Bound& chosen(Vertex_index v) const { return m_bounds.at(v)[m_choice.at(v)]; }

  // Computes approximate weights, and returns whether the greatest bounds were found.
  bool solve()
  {
    choose_greatest_bounds();
    for(int round = 0; round < most_rounds; ++round)
      if(!set_weights())
        choose_greatest_bounds();
      else if(!replace_bounds())
        return set_growth();
    return false;
  }

  // Sets the weights to their chosen bounds, and returns whether this was possible. It is not if
  // vertices bound each other in a cycle.
  bool set_weights()
  {
    try {
      set_values(m_value,
                 [](const Bound& b) { return Long_float(b.form.constant.x / -factor(b)); });
      return true;
    } catch(const Numerical_error&) {
      return false;
    }
  }

  static Long_float factor(const Bound& b) { return b.form.terms[0].second.x; }

  // Solves the linear system of the chosen bounds with other constants.
  template <typename Constant>
  void set_values(std::vector<Long_float>& values, const Constant& constant) const
  {
    Supporting_triangles<Long_float> triangles;
    for(const auto& [v, bounds] : m_bounds) {
      const Bound& b = chosen(v);
      triangles.set(v, {constant(b), {part(b, 1), part(b, 2), part(b, 3)}});
    }
    triangles.set_weights(values);
  }

  // Returns a corner of a bound and its part of the convex combination.
  static std::pair<Vertex_index, Long_float> part(const Bound& b, std::size_t corner)
  {
    const auto& [v, coefficient] = b.form.terms[corner];
    return {v, (std::max)(Long_float(coefficient.x / -factor(b)), Long_float(0))};
  }

  // Chooses the greatest bounds by the present weights, and raises weights that are less.
  void choose_greatest_bounds()
  {
    for(const auto& [v, bounds] : m_bounds) {
      std::vector<Long_float> excess;
      for(const Bound& b : bounds)
        excess.push_back(Long_float(-value(b, m_value).x / factor(b)));
      const auto greatest = std::max_element(excess.begin(), excess.end());
      m_choice[v] = std::size_t(greatest - excess.begin());
      m_value[v.idx()] += (std::max)(*greatest, Long_float(0));
    }
  }

  // Chooses bounds that are greater than the weights, and returns whether there are any.
  bool replace_bounds()
  {
    bool is_replaced = false;
    for(const auto& [v, bounds] : m_bounds) {
      Long_float greatest(0);
      for(std::size_t i = 0; i < bounds.size(); ++i)
        if(const Long_float excess = this->excess(bounds[i]); excess > greatest) {
          greatest = excess;
          m_choice[v] = i;
          is_replaced = true;
        }
    }
    return is_replaced;
  }

  // Returns by how much a bound exceeds the weight. It is zero if its terms do not determine it.
  Long_float excess(const Bound& b) const
  {
    const Long_float difference = -value(b, m_value).x;
    Long_float size = abs(b.form.constant.x);
    for(const auto& [v, coefficient] : b.form.terms)
      size += abs(Long_float(coefficient.x * m_value[v.idx()]));
    return difference > resolution() * size ? Long_float(difference / factor(b)) : Long_float(0);
  }

  Number value(const Bound& b, const std::vector<Long_float>& values) const
  {
    return b.form.value([&](Vertex_index v) { return Number{values[v.idx()], Long_float(0), 0}; });
  }

  // Finds numbers u such that every u_v exceeds a sum by one. The sum is over the other hidden
  // vertices of the bound of v: their numbers times the absolute values of their coefficients.
  // Then residuals of at most r change solutions by at most r u. Returns whether such numbers were
  // found.
  bool set_growth()
  {
    set_values(m_growth, [](const Bound&) { return Long_float(2); });
    return std::all_of(m_bounds.begin(), m_bounds.end(), [&](const auto& bounds) {
      const auto& terms = chosen(bounds.first).form.terms;
      Long_float sum = (terms[0].second.x - terms[0].second.radius) *
                       (m_growth[bounds.first.idx()] - Long_float(1 + 0x1p-100));
      for(std::size_t i = 1; i < terms.size(); ++i)
        sum -= (abs(terms[i].second.x) + terms[i].second.radius) * m_growth[terms[i].first.idx()];
      return sum > 0;
    });
  }

  // Returns an upper bound of the residuals of all equations, whose own coefficients are divided
  // out.
  double greatest_residual() const
  {
    constexpr double rounding = 1 + 16 * std::numeric_limits<double>::epsilon();
    double greatest = 0;
    for(const auto& [v, bounds] : m_bounds) {
      const Bound& b = chosen(v);
      const Number residual = value(b, m_value), &f = b.form.terms[0].second;
      const double least_factor = static_cast<double>(f.x) - f.radius;
      if(!(least_factor > 0))
        throw Numerical_error("a coefficient is not positive");
      const double upper = std::abs(static_cast<double>(residual.x)) + residual.radius;
      greatest = (std::max)(greatest, rounding * upper / least_factor);
    }
    return greatest;
  }

  const Pair& m_pair;
  const Edge_courses<Traits>& m_courses;
  Corners m_corners;
  Weight_bounds<Traits> m_find_bounds;
  Vertex_weights& m_weights;
  std::vector<Long_float> m_value, m_growth;
  std::map<Vertex_index, std::vector<Bound>> m_bounds;
  std::map<Vertex_index, std::size_t> m_choice;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_HIDDEN_WEIGHTS_H
