// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_ROUTE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_ROUTE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Stores the operations between two times, in a list for each face that they change.
class Operations_by_face
{
public:
  typedef Surface_history::Time Time;

  Operations_by_face(const Surface_history& history, Time first, Time last, std::size_t faces)
    : m_end((std::max)(faces, history.end_of_inserted_faces()) + 1, 0)
  {
    if(last > std::numeric_limits<std::uint32_t>::max())
      throw Intrinsic_triangulations::Overflow_error("too many operations for a map");
    const auto for_each_event = [&](const auto& visit) {
      for(Time t = first; t < last; ++t)
        history[t].visit([&](const auto& operation) {
          for(const Face_corner& c : history.corners(operation))
            visit(c.face(), t);
        });
    };
    for_each_event([&](Face_index f, Time) { ++m_end[f + 1]; });
    for(std::size_t f = 1; f < m_end.size(); ++f)
      m_end[f] += m_end[f - 1];
    m_times.resize(m_end.back());
    for_each_event(
      [&](Face_index f, Time t) { m_times[m_end[f]++] = static_cast<std::uint32_t>(t); });
    m_end.pop_back(); // the end of each list is the start of the next now
  }

  // Returns the first operation on `f` that is not before `t`, or `none`.
  Time next(Face_index f, Time t, Time none) const
  {
    const auto* next = first_not_before(f, t);
    return next == m_times.data() + m_end[f] ? none : *next;
  }

  // Returns the time after the last operation on `f` before `t`, or `none`.
  Time previous(Face_index f, Time t, Time none) const
  {
    const auto* next = first_not_before(f, t);
    return next == begin(f) ? none : Time(*(next - 1)) + 1;
  }

private:
  const std::uint32_t* begin(Face_index f) const
  {
    return m_times.data() + (f == Face_index(0) ? 0 : m_end[f - 1]);
  }

  const std::uint32_t* first_not_before(Face_index f, Time t) const
  {
    return std::lower_bound(begin(f), m_times.data() + m_end[f], t);
  }

  std::vector<std::size_t> m_end;     // of the list of each face
  std::vector<std::uint32_t> m_times; // of the operations on each face, in their order
};

// Leads through the operations between two levels, forward or backward.
class Route
{
public:
  typedef Surface_history::Time Time;

  Route(const Surface_history& history, const Operations_by_face& operations,
        const Surface_level& start, const Surface_level& end)
    : m_history(history),
      m_operations(operations),
      m_start(start),
      m_end(end),
      m_is_forward(start.time() <= end.time())
  {}

  const Surface_level& start() const { return m_start; }
  const Surface_level& end() const { return m_end; }
  bool is_forward() const { return m_is_forward; }

  // Returns the time of the next operation on `f`, or the time of the end if no operation follows.
  Time next(Face_index f, Time now) const
  {
    return m_is_forward ? m_operations.next(f, now, m_end.time())
                        : m_operations.previous(f, now, m_end.time());
  }

  Time length() const
  {
    return m_is_forward ? m_end.time() - m_start.time() : m_start.time() - m_end.time();
  }

  // Returns the time after the next `n` operations, at most the time of the end.
  Time after(Time t, Time n) const
  {
    return m_is_forward ? t + (std::min)(n, m_end.time() - t) : t - (std::min)(n, t - m_end.time());
  }

  // Returns whether no operation lies between the time `t` and `end`.
  bool is_at(Time t, Time end) const { return m_is_forward ? t >= end : t <= end; }

  // Calls `visit` with the operation at time `t`, and returns the time after it.
  template <typename Visit>
  Time pass(Time t, const Visit& visit) const
  {
    m_history[m_is_forward ? t : t - 1].visit(visit);
    return m_is_forward ? t + 1 : t - 1;
  }

  // Returns the factors by which a scaling multiplies the coordinates in the face `f` (Equation
  // 5.1).
  Coordinates factors(const Scaling& scaling, Face_index f) const
  {
    const double factor = m_is_forward ? scaling.factor : 1 / scaling.factor;
    Coordinates result{1, 1, 1};
    for(const Face_corner& c : m_history.corners(scaling))
      if(c.face() == f)
        result[c.index()] = factor;
    return result;
  }

private:
  const Surface_history& m_history;
  const Operations_by_face& m_operations;
  const Surface_level &m_start, &m_end;
  bool m_is_forward;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_ROUTE_H
