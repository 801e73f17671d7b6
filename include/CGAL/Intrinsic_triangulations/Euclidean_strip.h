// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// lays out a strip of Euclidean triangles in the plane and intersects its inner edges with the
/// straight line between its ends (Algorithm 3).
///
/// The strip leaves the corner \f$a\f$ of a first triangle through the opposite side
/// \f$\overrightarrow{ij}\f$, passes triangle after triangle, and ends at a corner \f$b\f$. It can
/// also start and end at other points of the first and last triangle. Directions of edges are
/// turned by corner angles, not computed from differences of positions. So a short edge in the
/// strip does not spoil later triangles. The position of a corner follows from the edges that lead
/// to it on the shorter way. So a short line between long edges keeps all its digits. An object
/// can be used for many strips; it allocates memory only for the longest ones.
///
/// \cgalModels `GeodesicStrip`
template <typename FT>
class Euclidean_strip
{
  /// \cond SKIP_IN_MANUAL
protected:
  typedef internal::Plane_vector<FT> Vector;

  struct Segment
  {
    Vector source, target;
  };

  struct Corner
  {
    Vector place;
    FT way; // the length of the way along edges on which it was placed
  };
  /// \endcond

public:
  /// a crossing of the line with an inner edge. `along_line` is the barycentric coordinate on the
  /// line from \f$a\f$ to \f$b\f$, and `along_edge` on \f$\overrightarrow{ij}\f$ (Equation 3.6).
  /// Both are in \f$[0,1]\f$.
  struct Crossing
  {
    FT along_line, ///< the position on the line
      along_edge;  ///< the position on the edge
  };

  /// starts a new strip in the triangle \f$aij\f$ that is left through \f$\overrightarrow{ij}\f$.
  void start(const FT& ai, const FT& ij, const FT& ja)
  {
    const Vector j =
      ja > 0 ? ja * Vector{corner_cosine(ij, ai, ja), corner_sine(ij, ai, ja)} : Vector{};
    start({{ai, FT(0)}, ai}, {j, ja}, {-corner_cosine(ja, ai, ij), corner_sine(ja, ai, ij)});
  }

  /// starts with a line from a point of this triangle: at the point with barycentric coordinates
  /// `p`, which belong to \f$a\f$, \f$i\f$, \f$j\f$. The point may be arbitrarily close to
  /// \f$\overrightarrow{ij}\f$.
  void start(const FT& ai, const FT& ij, const FT& ja, const std::array<FT, 3>& p)
  {
    start(ai, ij, ja);
    const Segment from_a = m_edges.back();
    const Vector edge = ij * m_direction;
    start({p[0] * from_a.source - p[2] * edge, p[0] * ai + p[2] * ij},
          {p[0] * from_a.target + p[1] * edge, p[0] * ja + p[1] * ij}, m_direction);
  }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    turn_around_source(apex(ij, jl, li), direction_at_source(ij, jl, li));
  }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    turn_around_target(apex(ij, jl, li), direction_to_target(ij, jl, li));
  }

  /// ends the strip at the corner \f$l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$.
  void finish(const FT& ij, const FT& jl, const FT& li) { set_end(apex(ij, jl, li)); }

  /// ends with a line to a point of this triangle: the point with barycentric coordinates `q`,
  /// which belong to \f$l\f$, \f$j\f$, \f$i\f$.
  void finish(const FT& ij, const FT& jl, const FT& li, const std::array<FT, 3>& q)
  {
    const Segment& edge = m_edges.back();
    set_end(placed(
      q[2] * ij + q[0] * jl, q[1] * ij + q[0] * li,
      [&] {
        return edge.source + q[1] * ij * m_direction + q[0] * li * direction_at_source(ij, jl, li);
      },
      [&] {
        return edge.target - q[2] * ij * m_direction - q[0] * jl * direction_to_target(ij, jl, li);
      }));
  }

  /// returns the number of inner edges.
  std::size_t size() const { return m_edges.size(); }

  /// returns the length of the line. \pre `finish()` has been called
  FT length() const
  {
    using CGAL::sqrt; // or the one of `FT`
    return sqrt(m_squared_length);
  }

  /// returns the angle at the start of the line, counterclockwise from the direction to the first
  /// \f$i\f$ to the line. `FT` is a floating-point type.
  /// \pre `finish()` has been called
  FT angle() const
  {
    const Vector& i = m_edges.front().source;
    return std::atan2(cross(i, m_end), dot(i, m_end));
  }

  /// returns the crossing of the line with inner edge `m`, not before `least` on the line. If the
  /// line runs along the edge, the result is any point that they share.
  /// \pre `finish()` has been called
  Crossing crossing(std::size_t m, const FT& least = FT(0)) const
  {
    const Segment& edge = m_edges[m];
    const FT right = -cross(m_end, edge.source), left = cross(m_end, edge.target);
    const FT t = right > 0 ? (left > 0 ? right / (right + left) : FT(1)) : FT(0);
    const FT s = projected(edge, t), on_line = (std::max)(std::clamp(s, FT(0), FT(1)), least);
    if(m_squared_length > 0 && !(CGAL::abs(on_line - s) > rounding_unit<FT>()))
      return {on_line, t};
    return {on_line, along_edge(m, on_line)};
  }

  /// returns the position on inner edge `m` that is closest to the point at `along_line` on the
  /// line.
  /// \pre `finish()` has been called
  FT along_edge(std::size_t m, const FT& along_line) const
  {
    const Segment& edge = m_edges[m];
    const Vector ij = edge.target - edge.source;
    const FT square = dot(ij, ij);
    return square > 0
             ? std::clamp<FT>(dot(along_line * m_end - edge.source, ij) / square, FT(0), FT(1))
             : FT(0);
  }

  /// returns the position on the line that is closest to the point at `along_edge` on inner edge
  /// `m`.
  /// \pre `finish()` has been called
  FT along_line(std::size_t m, const FT& along_edge) const
  {
    return std::clamp(projected(m_edges[m], along_edge), FT(0), FT(1));
  }

  /// \cond SKIP_IN_MANUAL
protected:
  // Returns whether the line passes between the ends of all inner edges, if no corner is displaced
  // by more than `displacement`.
  bool is_straight(const FT& displacement) const
  {
    const FT margin = 4 * displacement * m_longest_way;
    return std::all_of(m_edges.begin(), m_edges.end(), [&](const Segment& edge) {
      return cross(m_end, edge.target) > margin && cross(m_end, edge.source) < -margin;
    });
  }

  // Starts a strip whose first edge is in this direction.
  void start(const Corner& i, const Corner& j, const Vector& direction)
  {
    m_edges.clear();
    m_edges.push_back({i.place, j.place});
    m_direction = direction;
    m_way_to_source = i.way;
    m_way_to_target = j.way;
    m_longest_way = (std::max)(i.way, j.way);
  }

  // The next functions continue through the triangle jil, and through an edge at `l` in this
  // direction.
  void turn_around_source(const Corner& l, const Vector& direction)
  {
    m_direction = direction;
    m_way_to_target = noted(l.way);
    m_edges.push_back({m_edges.back().source, l.place});
  }
  void turn_around_target(const Corner& l, const Vector& direction)
  {
    m_direction = direction;
    m_way_to_source = noted(l.way);
    m_edges.push_back({l.place, m_edges.back().target});
  }

  void set_end(const Corner& end)
  {
    noted(end.way);
    m_end = end.place;
    m_squared_length = dot(m_end, m_end);
  }

  // Returns a point with these distances from the ends of the last edge. It is placed by the
  // function for the end with the shorter path.
  template <typename From_source, typename From_target>
  Corner placed(const FT& to_target, const FT& to_source, const From_source& from_source,
                const From_target& from_target) const
  {
    const FT by_source = m_way_to_source + to_source, by_target = m_way_to_target + to_target;
    if(!internal::is_rounded<FT>() || by_source <= by_target) // otherwise all ways are the same
      return {from_source(), by_source};
    return {from_target(), by_target};
  }

  const Segment& last_edge() const { return m_edges.back(); }
  const Vector& direction() const { return m_direction; }
  const FT& longest_way() const { return m_longest_way; }
  /// \endcond

private:
  // Returns the direction of i->l in the triangle jil.
  Vector direction_at_source(const FT& ij, const FT& jl, const FT& li) const
  {
    return m_direction * Vector{corner_cosine(jl, li, ij), -corner_sine(jl, li, ij)};
  }

  // Returns the direction of l->j in the triangle jil.
  Vector direction_to_target(const FT& ij, const FT& jl, const FT& li) const
  {
    return m_direction * Vector{corner_cosine(li, ij, jl), corner_sine(li, ij, jl)};
  }

  // Returns the position of l in the triangle jil.
  Corner apex(const FT& ij, const FT& jl, const FT& li) const
  {
    const Segment& edge = m_edges.back();
    return placed(
      jl, li,
      [&] { return li > 0 ? edge.source + li * direction_at_source(ij, jl, li) : edge.source; },
      [&] { return jl > 0 ? edge.target - jl * direction_to_target(ij, jl, li) : edge.target; });
  }

  // Returns the position on the line, or beyond its ends, of the point at `t` on an edge. Returns
  // the start of a line without length.
  FT projected(const Segment& edge, const FT& t) const
  {
    return m_squared_length > 0
             ? FT(dot(m_end, edge.source + t * (edge.target - edge.source)) / m_squared_length)
             : FT(0);
  }

  const FT& noted(const FT& way)
  {
    m_longest_way = (std::max)(m_longest_way, way);
    return way;
  }

  std::vector<Segment> m_edges;
  Vector m_direction{}; // of the last edge
  FT m_way_to_source{}; // from the start along edges
  FT m_way_to_target{};
  FT m_longest_way{};
  Vector m_end{};
  FT m_squared_length{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_STRIP_H
