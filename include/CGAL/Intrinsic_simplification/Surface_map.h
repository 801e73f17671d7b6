// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/maps/carry_point.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the bijective map between two levels of an evolving surface (Section 5.2.1).
///
/// A point is carried through the operations between the levels that involve the face in which it
/// is, and through no others: they are found by a list for each face. The map is continuous, and
/// projective on pieces. A vertex that both levels have is mapped to itself, exactly, and a point
/// of a boundary to a point of the boundary.
///
/// The object refers to the history and to both levels. Memory: 4 bytes for each face and operation
/// on it.
class Surface_map
{
public:
  /// a face and barycentric coordinates that sum up to one.
  typedef Intrinsic_triangulations::Face_location<double> Location;

  /// prepares the map. Complexity: linear in the faces of the fine level and the operations.
  /// \throws Intrinsic_triangulations::Overflow_error if there are more operations than can be
  ///   numbered
  /// \pre both levels are of the surface with this history, and `coarse` is not earlier than `fine`
  Surface_map(const Surface_history& history, const Surface_level& fine,
              const Surface_level& coarse)
    : m_history(history), m_fine(fine), m_coarse(coarse)
  {
    CGAL_precondition(fine.time() <= coarse.time());
    const auto add_next = [&](Face_index f, Surface_history::Time) { ++m_end[f + 1]; };
    m_end.assign(fine.number_of_surface_faces() + std::size_t(1), 0);
    for_each_event(add_next);
    for(std::size_t f = 1; f < m_end.size(); ++f)
      m_end[f] += m_end[f - 1];
    if(coarse.time() > std::numeric_limits<std::uint32_t>::max())
      throw Intrinsic_triangulations::Overflow_error("too many operations for a map");
    m_times.resize(m_end.back());
    for_each_event([&](Face_index f, Surface_history::Time t) {
      m_times[m_end[f]++] = static_cast<std::uint32_t>(t);
    });
    m_end.pop_back(); // the end of each list is the start of the next now
  }

  /// the same for an evolving surface, of which it refers to the history.
  Surface_map(const Evolving_surface& surface, const Surface_level& fine,
              const Surface_level& coarse)
    : Surface_map(surface.history(), fine, coarse)
  {}

  /// the level on whose surface the map starts.
  const Surface_level& fine() const { return m_fine; }
  /// the level on whose surface the map ends.
  const Surface_level& coarse() const { return m_coarse; }

  /// maps a point of the fine surface to the coarse surface. Complexity: linear in the operations
  /// that move the point, times the logarithm of the number of operations on a face.
  Location to_coarse(Location p) const
  {
    p.first = m_fine.surface_face(p.first);
    auto t = next_operation(p.first, m_fine.time());
    for(; t != m_coarse.time(); t = next_operation(p.first, t + 1))
      internal::carry_forward(m_history, t, p);
    p.first = m_coarse.level_face(p.first);
    internal::normalize(p.second);
    return p;
  }

  /// maps a point of the coarse surface to the fine surface. Complexity: as `to_coarse()`.
  Location to_fine(Location p) const
  {
    p.first = m_coarse.surface_face(p.first);
    auto end = end_of_operation(p.first, m_coarse.time());
    for(; end != m_fine.time(); end = end_of_operation(p.first, end - 1))
      internal::carry_backward(m_history, end - 1, p);
    p.first = m_fine.level_face(p.first);
    internal::normalize(p.second);
    return p;
  }

  /// the operations.
  const Surface_history& history() const { return m_history; }

  /// the first operation between the levels on the face `f` of the evolving surface that is not
  /// before `t`; if there is none, the time of the coarse level. Complexity: logarithmic in the
  /// operations on the face.
  Surface_history::Time next_operation(Face_index f, Surface_history::Time t) const
  {
    const auto* next = first_not_before(f, t);
    return next == end(f) ? m_coarse.time() : *next;
  }

  /// one more than the last operation between the levels on the face `f` of the evolving surface
  /// that is before `t`; if there is none, the time of the fine level. Complexity: as
  /// `next_operation()`.
  Surface_history::Time end_of_operation(Face_index f, Surface_history::Time t) const
  {
    const auto* next = first_not_before(f, t);
    return next == begin(f) ? m_fine.time() : Surface_history::Time(*(next - 1)) + 1;
  }

private:
  // calls `visit(f, t)` for each operation t on a face f
  template <typename Visit>
  void for_each_event(const Visit& visit) const
  {
    for(Surface_history::Time t = m_fine.time(); t < m_coarse.time(); ++t)
      internal::for_each_face(m_history, m_history[t], [&](Face_index f) { visit(f, t); });
  }

  const std::uint32_t* begin(Face_index f) const
  {
    return m_times.data() + (f == Face_index(0) ? 0 : m_end[f - 1]);
  }
  const std::uint32_t* end(Face_index f) const { return m_times.data() + m_end[f]; }

  const std::uint32_t* first_not_before(Face_index f, Surface_history::Time t) const
  {
    return std::lower_bound(begin(f), end(f), t);
  }

  const Surface_history& m_history;
  const Surface_level &m_fine, &m_coarse;
  std::vector<std::uint32_t> m_times; // of the operations on each face, in their order
  std::vector<std::size_t> m_end;     // of the list of each face
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the place of a vertex of the fine level on the coarse surface.
/// \pre `v` is not isolated
inline Surface_map::Location image_of_vertex(Vertex_index v, const Surface_map& map)
{
  namespace IT = Intrinsic_triangulations;
  const Delta_complex& mesh = map.fine().mesh();
  const Halfedge_index h = IT::first_spoke(v, mesh);
  std::array<double, 3> corner{};
  corner[IT::side_number(h, mesh)] = 1;
  return map.to_coarse({mesh.face(h), corner});
}

} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H
