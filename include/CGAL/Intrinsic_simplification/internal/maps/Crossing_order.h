// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

// The order in which curves cross an edge. Curves that do not cross each other go on side by side
// until they leave a face by different sides or corners: there they tell their order, without any
// numbers.
class Crossing_order
{
public:
  Crossing_order(const std::vector<Coarse_piece>& pieces, const Delta_complex& mesh)
    : m_pieces(pieces), m_mesh(mesh)
  {}

  // Compares the places on the first halfedge of an edge where two pieces end: negative if that of
  // `a` is before that of `b`, zero if the curves never separate.
  int compare(std::size_t a, std::size_t b) const
  {
    const Halfedge_index left =
      Intrinsic_triangulations::first_halfedge(Edge_index(side_of_end(a)));
    const int result = compare_ahead(strand(a, left), strand(b, left), left);
    const Halfedge_index right = Intrinsic_triangulations::opposite(left);
    return result != 0 ? result : -compare_ahead(strand(a, right), strand(b, right), right);
  }

private:
  // a piece, followed with or against the direction of its edge
  struct Strand
  {
    std::size_t piece;
    bool is_forward;
  };

  Halfedge_index side_of_end(std::size_t piece) const
  {
    const Curve_segment& segment = m_pieces[piece].segment;
    return internal::side_of_end(segment, segment.to, m_mesh);
  }

  // on the left of `h`, away from where a piece comes to its edge
  Strand strand(std::size_t piece, Halfedge_index h) const
  {
    return side_of_end(piece) == h ? Strand{piece, false} : Strand{piece + 1, true};
  }

  const Face_point& end(const Strand& s) const
  {
    const Curve_segment& segment = m_pieces[s.piece].segment;
    return s.is_forward ? segment.to : segment.from;
  }

  static void advance(Strand& s) { s.piece = s.is_forward ? s.piece + 1 : s.piece - 1; }

  // goes on to where a curve leaves the face
  void leave_face(Strand& s) const
  {
    while(is_bend(end(s)))
      advance(s);
  }

  // Where the curve leaves a face that it has entered by side `n`, counterclockwise: odd at
  // corners, even at sides; zero if it bends back to that side.
  std::size_t exit(const Strand& s, std::size_t n) const
  {
    const Face_point& p = end(s);
    return is_on_side(p) ? 2 * ((side_number(p) + 3 - n) % 3)
                         : 2 * ((corner_number(p) + 2 - n) % 3) + 1;
  }

  // Compares the places where two curves enter the face of `h` by `h`.
  int compare_ahead(Strand a, Strand b, Halfedge_index h) const
  {
    for(;;) {
      leave_face(a);
      leave_face(b);
      const std::size_t n = Intrinsic_triangulations::side_number(h, m_mesh);
      const std::size_t exit_a = exit(a, n), exit_b = exit(b, n);
      if(exit_a == 0 || exit_b == 0 || (exit_a == exit_b && is_at_corner(end(a))))
        return 0;
      if(exit_a != exit_b)
        return exit_a > exit_b ? -1 : 1;
      h = Intrinsic_triangulations::opposite(
        internal::side_of_end(m_pieces[a.piece].segment, end(a), m_mesh));
      advance(a);
      advance(b);
    }
  }

  const std::vector<Coarse_piece>& m_pieces;
  const Delta_complex& m_mesh;
};

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
