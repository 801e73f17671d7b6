// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_VERTEX_WEIGHTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_VERTEX_WEIGHTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the least weight with which others do not hide a vertex. It is equal to its bound.
struct Hidden_weight
{
  Weight_bound bound;
  Long_float value = 0;
  double error = std::numeric_limits<double>::infinity(); // the greatest error of `value`
};

// Stores the weights of vertices for which a triangulation is to be weighted Delaunay. Weights of
// visible vertices are exact, and intervals contain the weights of hidden vertices.
class Vertex_weights
{
public:
  explicit Vertex_weights(std::vector<double> given) : m_given(std::move(given)) {}

  double given(Vertex_index v) const { return m_given[v.idx()]; }

  std::map<Vertex_index, Hidden_weight>& hidden() { return m_hidden; }
  const std::map<Vertex_index, Hidden_weight>& hidden() const { return m_hidden; }
  bool is_hidden(Vertex_index v) const { return m_hidden.count(v) > 0; }

  // Returns whether the hidden weights have intervals. Either all or none have them.
  bool is_enclosed() const
  {
    return m_hidden.empty() || m_hidden.begin()->second.bound.halfedge.is_valid();
  }

  // Edges that are ties for the weights of hidden vertices.
  std::set<Edge_index>& ties() { return m_ties; }
  const std::set<Edge_index>& ties() const { return m_ties; }

  // Returns a ball that contains the weight of `v`.
  template <typename N>
  Ball<N> ball(Vertex_index v) const
  {
    const auto found = m_hidden.find(v);
    return found == m_hidden.end() ? Ball<N>{N(given(v)), N(0), 0}
                                   : rounded<N>(found->second.value, found->second.error);
  }

private:
  // Returns a number with the digits of `N`, with an error that includes its rounding.
  template <typename N>
  static Ball<N> rounded(const Long_float& value, double error)
  {
    if constexpr(std::is_same_v<N, Long_float>)
      return {value, N(0), error};
    else {
      const double high = static_cast<double>(value),
                   low = static_cast<double>(Long_float(value - Long_float(high)));
      return Ball<N>{N(high) + N(low), N(0), error}.with_error(2);
    }
  }

  std::vector<double> m_given;
  std::map<Vertex_index, Hidden_weight> m_hidden;
  std::set<Edge_index> m_ties;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_VERTEX_WEIGHTS_H
