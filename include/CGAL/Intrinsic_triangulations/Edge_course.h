// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_COURSE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_COURSE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// the halfedges of \f$T_1\f$ through which a halfedge of \f$T_2\f$ leaves faces, in order. They
/// are stored elsewhere or belong to this object; both cases have the same interface.
///
/// A course is valid until the triangulation changes. It cannot be copied, since it may refer to
/// itself; functions return it by value.
class Edge_course
{
public:
  /// the type of the halfedges if they belong to the course.
  typedef boost::container::small_vector<Halfedge_index, 8> Exits;

  /// refers to the `n` exits from `first` on, which are stored for the first halfedge of an edge.
  /// The course belongs to this halfedge, or to the opposite one if `is_reversed`.
  Edge_course(const Halfedge_index* first, std::size_t n, bool is_reversed)
    : m_first(is_reversed ? first + n - 1 : first), m_step(is_reversed ? -1 : 1), m_size(n)
  {}

  /// holds the `n` exits of a halfedge that `compute(exits)` sets.
  template <typename Compute>
  Edge_course(std::size_t n, const Compute& compute)
    : m_exits(n), m_first(m_exits.data()), m_step(1), m_size(n)
  {
    compute(m_exits);
  }

  Edge_course(const Edge_course&) = delete;
  Edge_course& operator=(const Edge_course&) = delete;

  /// returns the number of crossings.
  std::size_t size() const { return m_size; }

  /// returns whether there are no crossings.
  bool empty() const { return m_size == 0; }

  /// returns the halfedge of \f$T_1\f$ through which the halfedge leaves a face as crossing `m`,
  /// counted from its source.
  Halfedge_index operator[](std::size_t m) const
  {
    const Halfedge_index exit = m_first[m_step * static_cast<std::ptrdiff_t>(m)];
    return m_step > 0 ? exit : opposite(exit);
  }

private:
  Exits m_exits;
  const Halfedge_index* m_first; // the first exit in the direction of the course
  std::ptrdiff_t m_step;
  std::size_t m_size;
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a part of an edge of \f$T_1\f$: vertices that have been inserted on it lie between its parts.
struct Edge_part
{
  Delta_complex::size_type first; ///< the number of crossings on all parts before it
  Delta_complex::size_type count; ///< the number of its crossings
  /// the number of pieces into which crossings cut all parts before it; a shared part counts none
  Delta_complex::size_type first_piece;
  bool is_shared;   ///< whether it is an edge of \f$T_2\f$
  Vertex_index end; ///< the vertex of \f$T_2\f$ at its end
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_COURSE_H
