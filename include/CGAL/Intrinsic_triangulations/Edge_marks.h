// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_MARKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_MARKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the index of a mark on the first halfedge of the edge of `h`, if it is mark `p` of `n`
/// on `h`. Marks are counted from the source. This is its own inverse.
inline Delta_complex::size_type along_first_halfedge(Halfedge_index h, Delta_complex::size_type p,
                                                     Delta_complex::size_type n)
{
  return is_first_halfedge(h) ? p : n - 1 - p;
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// the indices of marks on the edges of a Delta-complex.
///
/// A mark is a point inside an edge. The marks of an edge have consecutive indices, in the
/// direction of its first halfedge, and edge follows edge. On a halfedge they are counted from its
/// source.
///
/// An edge with \f$n\f$ marks consists of \f$n+1\f$ pieces. The marks on these edges are indexed in
/// the same way. The edges come first in their mesh.
class Edge_marks
{
public:
  /// the type of indices.
  typedef Delta_complex::size_type size_type;

  /// creates the indices for an empty complex.
  Edge_marks() : m_first(1, 0) {}

  /// creates the indices for `count[e]` marks on each edge `e`. Complexity: linear in the edges.
  /// \throws Overflow_error if there are more marks than a `Surface_mesh` can index
  explicit Edge_marks(std::vector<size_type> count) : m_first(std::move(count))
  {
    const std::uint64_t limit = (std::numeric_limits<size_type>::max)() / 8;
    std::uint64_t total = 0;
    m_first.reserve(m_first.size() + 1); // push_back() alone would double the memory
    m_first.push_back(0);
    for(size_type& n : m_first) {
      const size_type first = static_cast<size_type>(total);
      total += n;
      if(total > limit)
        throw Overflow_error("more crossings than a mesh can index");
      n = first;
    }
  }

  /// returns the number of all marks.
  size_type size() const { return m_first.back(); }
  /// returns the number of marks on the edge `e`.
  size_type size(Edge_index e) const { return m_first[e.idx() + 1] - m_first[e.idx()]; }
  /// returns the number of marks on all edges before `e`.
  size_type before(Edge_index e) const { return m_first[e.idx()]; }

  /// returns the index of mark `p` on the halfedge `h`.
  size_type operator()(Halfedge_index h, size_type p) const
  {
    const Edge_index e(h);
    return is_first_halfedge(h) ? m_first[e.idx()] + p : m_first[e.idx() + 1] - 1 - p;
  }

  /// returns which mark on the halfedge `h` has the index `mark`.
  size_type position(Halfedge_index h, size_type mark) const
  {
    const Edge_index e(h);
    return is_first_halfedge(h) ? mark - m_first[e.idx()] : m_first[e.idx() + 1] - 1 - mark;
  }

  /// returns the number of pieces of all edges.
  size_type number_of_pieces() const
  {
    return m_first.back() + static_cast<size_type>(m_first.size()) - 1;
  }
  /// returns the number of pieces of the edge `e`.
  size_type number_of_pieces(Edge_index e) const { return size(e) + 1; }

  /// returns the halfedge of piece `p` of the halfedge `h`, in the direction of `h`. It begins at
  /// mark `p - 1` and ends at mark `p`.
  Halfedge_index piece(Halfedge_index h, size_type p) const
  {
    const size_type e = Edge_index(h).idx();
    const size_type marks = is_first_halfedge(h) ? m_first[e] + p : m_first[e + 1] - p;
    return oriented_like(h, first_halfedge(Edge_index(e + marks)));
  }
  /// returns the last piece of the halfedge `h`, which ends where `h` ends.
  Halfedge_index last_piece(Halfedge_index h) const { return piece(h, size(Edge_index(h))); }

private:
  std::vector<size_type> m_first; // of each edge, and the number of all
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_MARKS_H
