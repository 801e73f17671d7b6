// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_HOMOLOGY_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_HOMOLOGY_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Loop_signatures.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the homology class of a closed curve over the integers. It counts how often the curve
// crosses the curve of each generator, from one side to the other.
class Homology_coordinates
{
public:
  typedef std::vector<std::int64_t> Vector;

  explicit Homology_coordinates(const Loop_signatures& signatures)
    : m_dimension(signatures.generators().size())
  {
    for(std::size_t i = 0; i < m_dimension; ++i)
      signatures.for_each_on_curve(signatures.generators()[i], [&](Halfedge_index h) {
        m_entries.push_back({Edge_index(h), i, is_first_halfedge(h) ? 1 : -1});
      });
    std::stable_sort(m_entries.begin(), m_entries.end(),
                     [](const Entry& a, const Entry& b) { return a.edge < b.edge; });
  }

  std::size_t dimension() const { return m_dimension; }

  Vector operator()(const std::vector<Halfedge_index>& curve) const
  {
    Vector result(m_dimension, 0);
    for(Halfedge_index h : curve) {
      const Edge_index e(h);
      auto x = std::lower_bound(m_entries.begin(), m_entries.end(), e,
                                [](const Entry& a, Edge_index b) { return a.edge < b; });
      for(; x != m_entries.end() && x->edge == e; ++x)
        result[x->generator] += is_first_halfedge(h) ? x->sign : -x->sign;
    }
    return result;
  }

private:
  struct Entry
  {
    Edge_index edge;
    std::size_t generator;
    int sign;
  };

  std::size_t m_dimension;
  std::vector<Entry> m_entries;
};

// Stores integer vectors that are part of a basis of all integer vectors. Linear functions that
// vanish on all of them complete them. Each new vector is reduced by the algorithm of Euclid until
// all functions but one vanish on it, too.
class Partial_basis
{
  typedef Homology_coordinates::Vector Vector;

public:
  explicit Partial_basis(std::size_t dimension) : m_functions(dimension)
  {
    for(std::size_t i = 0; i < dimension; ++i)
      m_functions[i] = {{i, 1}};
  }

  bool is_complete() const { return m_functions.empty(); }

  // Adds a vector if the vectors remain part of a basis, and numbers remain small. Returns whether
  // it was added.
  bool add(const Vector& v)
  {
    std::vector<Function> functions = m_functions;
    Vector values;
    for(const Function& f : functions)
      values.push_back(value(f, v));
    for(;;) {
      const std::size_t pivot = least(values);
      if(pivot == values.size())
        return false;
      bool is_reduced = true;
      for(std::size_t j = 0; j < values.size(); ++j)
        if(const std::int64_t factor = values[j] / values[pivot]; j != pivot && factor != 0) {
          if(!subtract(functions[j], factor, functions[pivot]))
            return false;
          values[j] -= factor * values[pivot];
          is_reduced = is_reduced && values[j] == 0;
        }
      if(!is_reduced)
        continue;
      if(values[pivot] != 1 && values[pivot] != -1)
        return false;
      functions.erase(functions.begin() + static_cast<std::ptrdiff_t>(pivot));
      m_functions = std::move(functions);
      return true;
    }
  }

private:
  typedef std::vector<std::pair<std::size_t, std::int64_t>> Function; // coefficients, by index

  static constexpr std::int64_t greatest = std::int64_t(1) << 30;

  static std::int64_t value(const Function& f, const Vector& v)
  {
    std::int64_t sum = 0;
    for(const auto& [i, factor] : f)
      sum += factor * v[i];
    return sum;
  }

  // Returns the index of the least absolute value that is not zero, or the number of values if all
  // are zero.
  static std::size_t least(const Vector& values)
  {
    std::size_t result = values.size();
    for(std::size_t i = 0; i < values.size(); ++i)
      if(values[i] != 0 &&
         (result == values.size() || std::abs(values[i]) < std::abs(values[result])))
        result = i;
    return result;
  }

  // Returns false if a coefficient gets too large.
  static bool subtract(Function& f, std::int64_t factor, const Function& g)
  {
    Function result;
    auto x = f.begin();
    auto y = g.begin();
    while(x != f.end() || y != g.end()) {
      const bool takes_x = y == g.end() || (x != f.end() && x->first <= y->first),
                 takes_y = x == f.end() || (y != g.end() && y->first <= x->first);
      const std::size_t i = takes_x ? x->first : y->first;
      const std::int64_t c = (takes_x ? (x++)->second : 0) - (takes_y ? factor * (y++)->second : 0);
      if(std::abs(c) > greatest)
        return false;
      if(c != 0)
        result.push_back({i, c});
    }
    f = std::move(result);
    return true;
  }

  std::vector<Function> m_functions;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_HOMOLOGY_COORDINATES_H
