// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_REFINEMENT_QUEUE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_REFINEMENT_QUEUE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores bad faces in the order of their refinement. Faces of bad shape come first, because the
// midpoint of an edge is not near to a vertex at large angles. They are ordered by decreasing
// circumradius, in classes of 10 %, newest first. So consecutive insertions are near each other in
// memory. Wider classes would be faster, but insert more vertices. Sides are split in the order of
// arrival, so that no side waits forever.
class Refinement_queue
{
public:
  // Stores a bad face with its version when it was found.
  struct Candidate
  {
    Face_index face;
    std::size_t version;
    bool has_bad_shape;
  };

  bool empty() const { return m_bad_shapes.empty() && m_others.empty(); }

  template <typename FT>
  void push_bad_shape(Face_index f, std::size_t version, const FT& circumradius)
  {
    const double size = std::floor(8 * std::log2(CGAL::to_double(circumradius)));
    m_bad_shapes[std::isnan(size) ? infinity : size].push_back({f, version, true});
  }

  void push_other(Face_index f, std::size_t version) { m_others.push({f, version, false}); }

  // Removes and returns the first candidate.
  // \pre !empty()
  Candidate pop()
  {
    if(m_bad_shapes.empty()) {
      const Candidate result = m_others.front();
      m_others.pop();
      return result;
    }
    const auto greatest = m_bad_shapes.begin();
    const Candidate result = greatest->second.back();
    greatest->second.pop_back();
    if(greatest->second.empty())
      m_bad_shapes.erase(greatest);
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::map<double, std::vector<Candidate>, std::greater<double>> m_bad_shapes; // by sizes
  std::queue<Candidate> m_others;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_REFINEMENT_QUEUE_H
