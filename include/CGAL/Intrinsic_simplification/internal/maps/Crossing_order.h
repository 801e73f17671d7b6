// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Represents a piece of an edge of the coarse level, and the direction in which it is followed.
struct Strand
{
  std::size_t piece;
  bool is_forward;
};

// States how a curve continues at a vertex of the coarse level inside a fine face. It follows the
// next edge on one side, so that it does not cross any edge.
enum class Turn
{
  left,
  right
};

// Follows edges of the coarse level over the faces of the fine level.
class Curve_strands
{
public:
  Curve_strands(const std::vector<Coarse_piece>& pieces,
                const std::vector<Curve_index>& first_piece, const Delta_complex& coarse)
    : m_pieces(pieces), m_first_piece(first_piece), m_coarse(coarse)
  {}

  const Coarse_piece& piece(const Strand& s) const { return m_pieces[s.piece]; }
  Edge_index edge(const Strand& s) const { return piece(s).edge; }

  const Face_point& end(const Strand& s) const
  {
    return s.is_forward ? piece(s).segment.to : piece(s).segment.from;
  }
  Curve_index end_mark(const Strand& s) const { return piece(s).marks[s.is_forward ? 1 : 0]; }

  bool is_last(const Strand& s) const
  {
    const Edge_index e = edge(s);
    return s.is_forward ? s.piece + 1 == m_first_piece[e.idx() + 1]
                        : s.piece == m_first_piece[e.idx()];
  }

  // Returns whether both curves follow the same edge in the same direction.
  bool is_on_same_way(const Strand& s, const Strand& other) const
  {
    return halfedge(s) == halfedge(other);
  }

  // Returns the first piece of the halfedge `h` of the coarse level.
  Strand first(Halfedge_index h) const
  {
    const Edge_index e(h);
    return Intrinsic_triangulations::is_first_halfedge(h)
             ? Strand{m_first_piece[e.idx()], true}
             : Strand{m_first_piece[e.idx() + 1] - std::size_t(1), false};
  }

  // Returns the vertex of the coarse level at the end of the edge.
  Vertex_index target(const Strand& s) const { return m_coarse.target(halfedge(s)); }

  void advance(Strand& s, Turn turn) const
  {
    if(is_last(s))
      s = first(next(halfedge(s), turn));
    else
      s.piece = s.is_forward ? s.piece + 1 : s.piece - 1;
  }

  // Follows the curve to its exit from the face, and returns whether it leaves. At most two edges
  // of its face precede an edge that comes from outside.
  bool leave_face(Strand& s, Turn turn) const
  {
    for(int edges = 0; is_bend(end(s)); advance(s, turn))
      if(is_last(s) && ++edges > 2)
        return false;
    return true;
  }

private:
  Halfedge_index halfedge(const Strand& s) const
  {
    const Halfedge_index h = Intrinsic_triangulations::first_halfedge(edge(s));
    return s.is_forward ? h : Intrinsic_triangulations::opposite(h);
  }

  // Vertices inside faces are not on the boundary.
  Halfedge_index next(Halfedge_index h, Turn turn) const
  {
    return turn == Turn::left ? m_coarse.next(h)
                              : m_coarse.opposite(m_coarse.prev(m_coarse.opposite(h)));
  }

  const std::vector<Coarse_piece>& m_pieces;
  const std::vector<Curve_index>& m_first_piece; // of each edge of the coarse level, and the end
  const Delta_complex& m_coarse;
};

using Intrinsic_triangulations::first_halfedge;
using Intrinsic_triangulations::opposite;

// Determines the order in which curves cross an edge. Curves that do not cross each other continue
// side by side until they leave a face by different sides or corners. At this face their order is
// known without numbers. Curves that continue side by side over many faces would be compared at
// each edge that they cross. Results are stored at some of their pieces, so that the total time is
// linear.
class Crossing_order
{
public:
  Crossing_order(const Traced_curves& traced, const Surface_map& map)
    : m_strands(traced.pieces, traced.first_piece, map.coarse().mesh()),
      m_marks(traced.marks),
      m_mesh(map.fine().mesh())
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
  // curve may bend back to this side. It may also have turned at a vertex and return to this side
  // by another curve. Then no curve lies between the two, and the other curve is followed.
  bool leave_face(Strand& s, std::size_t n, Turn turn, std::size_t other) const
  {
    const Strand start = s;
    while(m_strands.leave_face(s, turn)) {
      if(exit(s, n) != 0)
        return true;
      if(s.piece == start.piece)
        return false;
      if(s.piece == other || m_strands.is_on_same_way(s, start))
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
    Ways before = ways(a, b, turn); // Brent's algorithm detects a cycle
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
      if(const std::optional<int> order = order_in_face(a, b, h, turn))
        return *order;
      h = opposite(side_of_end(a));
      m_strands.advance(a, turn);
      m_strands.advance(b, turn);
    } while(a.piece != start.piece && a.piece != b.piece && ways(a, b, turn) != before);
    return 0;
  }

  // Moves both curves from `h` to the sides through which they leave its face. Returns their order,
  // or 0, unless they leave through the same side.
  std::optional<int> order_in_face(Strand& a, Strand& b, Halfedge_index h, Turn turn)
  {
    const std::size_t n = Intrinsic_triangulations::side_number(h, m_mesh);
    const Strand from_a = a, from_b = b;
    if(!leave_face(a, n, turn, from_b.piece) || !leave_face(b, n, turn, from_a.piece))
      return 0;
    const std::size_t exit_a = exit(a, n), exit_b = exit(b, n);
    const bool bends_a = exit_a == 0 && m_strands.is_on_same_way(a, from_a),
               bends_b = exit_b == 0 && m_strands.is_on_same_way(b, from_b);
    if((bends_a || bends_b) && !(bends_a && bends_b && are_nested(from_a, a, from_b, b)))
      return compare_starts(from_a, from_b, h);
    if(!bends_a && (exit_a == 0 || exit_b == 0))
      return (turn == Turn::left ? 1 : -1) * (int(exit_a == 0) - int(exit_b == 0));
    if(exit_a != exit_b)
      return exit_a > exit_b ? -1 : 1;
    return is_at_corner(m_strands.end(a)) || ends(a) || ends(b) ? std::optional(0) : std::nullopt;
  }

  double start_ratio(const Strand& s) const
  {
    return m_marks[m_strands.end_mark({s.piece, !s.is_forward})].ratio;
  }
  double end_ratio(const Strand& s) const { return m_marks[m_strands.end_mark(s)].ratio; }

  // Compares the positions on `h` where two pieces start.
  int compare_starts(const Strand& a, const Strand& b, Halfedge_index h) const
  {
    const double x = start_ratio(a), y = start_ratio(b);
    return (int(x > y) - int(x < y)) * (Intrinsic_triangulations::is_first_halfedge(h) ? 1 : -1);
  }

  // Returns whether one of two curves that bend back to a side encloses the other one.
  bool are_nested(const Strand& from_a, const Strand& to_a, const Strand& from_b,
                  const Strand& to_b) const
  {
    const auto [first_a, last_a] = std::minmax({start_ratio(from_a), end_ratio(to_a)});
    const auto [first_b, last_b] = std::minmax({start_ratio(from_b), end_ratio(to_b)});
    return first_a < last_b && first_b < last_a;
  }

  // Returns whether the curve has reached a vertex on a boundary edge.
  bool ends(const Strand& s) const { return m_strands.is_last(s) && is_on_side(m_strands.end(s)); }

  Curve_strands m_strands;
  const std::vector<Curve_mark>& m_marks;
  const Delta_complex& m_mesh;
  std::unordered_map<Ways, int> m_known;
  std::vector<Ways> m_passed; // the states of the last comparison
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CROSSING_ORDER_H
