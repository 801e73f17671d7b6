// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Curve_strands.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

using Intrinsic_triangulations::first_halfedge;
using Intrinsic_triangulations::opposite;

// Determines the order in which curves cross an edge. Curves that do not cross each other continue
// side by side until they leave a face by different sides or corners. At this face their order is
// known without numbers. Curves that continue side by side for long are compared at each edge that
// they cross. Results are kept at some of their pieces, so that the total time is linear.
class Crossing_order
{
public:
  Crossing_order(const Traced_curves& traced, const Surface_map& map)
    : m_strands(traced.pieces, traced.first_piece, map.coarse().mesh()), m_mesh(map.fine().mesh())
  {}

  // Compares the positions on the first halfedge of an edge where two pieces end. The result is
  // negative if the position of `a` comes first, and zero if the curves never separate.
  int compare(std::size_t a, std::size_t b)
  {
    const Halfedge_index left = first_halfedge(Edge_index(side_of_end({a, true})));
    const int result = compare_on_left(a, b, left);
    return result != 0 ? result : -compare_on_left(a, b, opposite(left));
  }

private:
  // Encodes two strands and a turn as one number.
  typedef std::uint64_t Ways;

  static constexpr std::size_t distance_of_kept = 16; // in pieces

  static Ways ways(const Strand& a, const Strand& b, Turn turn)
  {
    const auto number = [](const Strand& s) { return 2 * Ways(s.piece) + (s.is_forward ? 1 : 0); };
    return (number(a) << 32 | number(b)) << 1 | (turn == Turn::left ? 1 : 0);
  }

  Halfedge_index side_of_end(const Strand& s) const
  {
    return internal::side_of_end(m_strands.piece(s).segment, m_strands.end(s), m_mesh);
  }

  // Returns the strand on the left of `h`, which starts at the edge where a piece ends.
  Strand strand(std::size_t piece, Halfedge_index h) const
  {
    return side_of_end({piece, true}) == h ? Strand{piece, false} : Strand{piece + 1, true};
  }

  // Compares the positions on `h` where two pieces end, by the curves on its left.
  int compare_on_left(std::size_t a, std::size_t b, Halfedge_index h)
  {
    const int result = compare_ahead(strand(a, h), strand(b, h), h, Turn::left);
    return result != 0 ? result : compare_ahead(strand(a, h), strand(b, h), h, Turn::right);
  }

  // Returns the corner or side through which the curve leaves a face that it has entered by side
  // `n`, counterclockwise. It is odd at corners, even at sides, and zero if the curve bends back to
  // side `n`.
  std::size_t exit(const Strand& s, std::size_t n) const
  {
    const Face_point& p = m_strands.end(s);
    return is_on_side(p) ? 2 * ((side_number(p) + 3 - n) % 3)
                         : 2 * ((corner_number(p) + 2 - n) % 3) + 1;
  }

  // Follows the curve from side `n` to its exit from the face, and returns whether it leaves. The
  // curve may have turned at a vertex and return to this side by another curve. Then no curve lies
  // between the two, and the other curve is followed.
  bool leave_face(Strand& s, std::size_t n, Turn turn, std::size_t other) const
  {
    const Strand start = s;
    while(m_strands.leave_face(s, turn)) {
      if(exit(s, n) != 0)
        return true;
      if(s.piece == start.piece || m_strands.is_on_same_way(s, start))
        return false;
      if(s.piece == other)
        return true;
      s.is_forward = !s.is_forward;
    }
    return false;
  }

  // Compares the positions where two curves enter the face of `h` by `h`.
  int compare_ahead(const Strand& a, const Strand& b, Halfedge_index h, Turn turn)
  {
    m_passed.clear();
    const int result = follow(a, b, h, turn);
    for(const Ways passed : m_passed)
      m_known.emplace(passed, result);
    return result;
  }

  // Follows both curves until they separate or return to an earlier state. They continue at
  // vertices inside of faces. If a curve returns along the other one, the other one is on the side
  // of its turn.
  int follow(Strand a, Strand b, Halfedge_index h, Turn turn)
  {
    const Strand start = a;
    Ways before = ways(a, b, turn); // Brent's way to find a circle
    std::size_t steps = 0, next_before = distance_of_kept;
    do {
      if(++steps == next_before) {
        before = ways(a, b, turn);
        next_before *= 2;
      }
      if(steps > distance_of_kept && a.piece % distance_of_kept == 0) {
        m_passed.push_back(ways(a, b, turn));
        if(const auto known = m_known.find(m_passed.back()); known != m_known.end())
          return known->second;
      }
      const std::size_t n = Intrinsic_triangulations::side_number(h, m_mesh);
      const std::size_t from_a = a.piece, from_b = b.piece;
      if(!leave_face(a, n, turn, from_b) || !leave_face(b, n, turn, from_a))
        return 0;
      const std::size_t exit_a = exit(a, n), exit_b = exit(b, n);
      if(exit_a == 0 || exit_b == 0)
        return (turn == Turn::left ? 1 : -1) * (int(exit_a == 0) - int(exit_b == 0));
      if(exit_a == exit_b && (is_at_corner(m_strands.end(a)) || ends(a) || ends(b)))
        return 0;
      if(exit_a != exit_b)
        return exit_a > exit_b ? -1 : 1;
      h = opposite(side_of_end(a));
      m_strands.advance(a, turn);
      m_strands.advance(b, turn);
    } while(a.piece != start.piece && a.piece != b.piece && ways(a, b, turn) != before);
    return 0;
  }

  // Returns whether the curve has reached a vertex on a boundary edge.
  bool ends(const Strand& s) const { return m_strands.is_last(s) && is_on_side(m_strands.end(s)); }

  Curve_strands m_strands;
  const Delta_complex& m_mesh;
  std::unordered_map<Ways, int> m_known;
  std::vector<Ways> m_passed; // by the last comparison
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
