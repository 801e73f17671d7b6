// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Segment_search.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Divides a path into straight pieces, each in one face.
template <typename Traits>
class Path_pieces
{
  typedef typename Traits::FT FT;
  typedef Surface_point<FT> Point;
  typedef Curve_segment<FT> Segment;
  typedef boost::container::static_vector<Barycentric_coordinates<FT>, 3> Points;

public:
  Path_pieces(const Correspondence<Traits>& correspondence, Side side, const Surface_path<FT>& path)
    : m_correspondence(correspondence),
      m_side(side),
      m_mesh(correspondence.mesh(side)),
      m_path(path)
  {}

  std::size_t size() const { return m_path.places.empty() ? 0 : m_path.places.size() - 1; }

  // Returns piece `k`, which runs along an edge between two vertices or through a face.
  Segment operator[](std::size_t k) const
  {
    const Point &p = m_path.places[k], &q = m_path.places[k + 1];
    const auto& surface = m_correspondence.triangulation().surface(m_side);
    if(is_at_vertex(p) && is_at_vertex(q))
      return curve_along_edges(surface, std::array<Halfedge_index, 1>{halfedge_of(p)}).front();
    const Face_index f = face(k);
    const Halfedge_index entry = crosses(k) ? m_mesh.opposite(halfedge_of(p)) : Halfedge_index();
    const Points from =
                   is_at_vertex(p) ? Points{face_location(p, m_mesh).second} : points(p, f, entry),
                 to = points(q, f, crosses(k + 1) ? halfedge_of(q) : Halfedge_index());
    if(from.empty() || to.empty())
      throw Invalid_input("two consecutive points of the path share no face");
    return is_at_vertex(q) ? to_vertex(surface, f, from, to, entry)
                           : shortest(surface, f, from, to);
  }

  // Returns whether piece `k` starts between the ends of an edge.
  bool starts_on_edge(std::size_t k) const { return on_edge(m_path.places[k]) != nullptr; }

private:
  // Returns whether the path crosses an edge at place `k`.
  bool crosses(std::size_t k) const
  {
    const auto* p = on_edge(m_path.places[k]);
    return p && k > 0 && k + 1 < m_path.places.size() && !is_inserted(*p);
  }

  bool is_inserted(const Edge_location<FT>& p) const
  {
    const auto [f, b] = face_location(p, m_mesh);
    return segment_end(m_correspondence, m_side, f, b).rank.is_inserted;
  }

  // Returns the face of piece `k`. A path leaves a face through `along`, or through the opposite
  // halfedge if rounding has moved it.
  Face_index face(std::size_t k) const
  {
    const Point &p = m_path.places[k], &q = m_path.places[k + 1];
    const Face_index first = face_location(p, m_mesh).first;
    if(!on_edge(p))
      return first;
    const Halfedge_index h = k > 0 ? m_mesh.opposite(halfedge_of(p)) : halfedge_of(p);
    const Face_index f = k > 0 ? m_mesh.face(h) : first;
    if(f.is_valid() && !points(q, f, Halfedge_index()).empty())
      return f;
    const Face_index beyond = m_mesh.face(m_mesh.opposite(h));
    return beyond.is_valid() && beyond != f ? beyond : m_mesh.face(h);
  }

  // Returns the points of a face that a position of a path denotes. These are several points if the
  // face meets itself at the position. If the path crosses a side of the face, only this side
  // counts.
  Points points(const Point& p, Face_index f, Halfedge_index crossed) const
  {
    if(const auto* inside = std::get_if<Face_location<FT>>(&p))
      return inside->first == f ? Points{inside->second} : Points();
    Points result;
    for(const Halfedge_index h : sides(f, m_mesh))
      if(!on_edge(p)) {
        if(m_mesh.source(h) == m_mesh.source(halfedge_of(p)))
          result.push_back(barycentric_coordinates(side_number(h, m_mesh), FT(0)));
      } else if(Edge_index(h) == Edge_index(halfedge_of(p)) && is_possible(h, crossed))
        result.push_back(
          face_location(h == halfedge_of(p) ? *on_edge(p) : reversed(*on_edge(p)), m_mesh).second);
    return result;
  }

  // Rounding may have moved an edge that a path crosses to the other side of its face.
  bool is_possible(Halfedge_index h, Halfedge_index crossed) const
  {
    return !crossed.is_valid() || h == crossed || m_mesh.face(h) != m_mesh.face(m_mesh.opposite(h));
  }

  // Returns the segment to a vertex. A path that has crossed a side ends at the corner opposite to
  // it if possible.
  template <typename Surface>
  Segment to_vertex(const Surface& surface, Face_index f, const Points& from, const Points& to,
                    Halfedge_index entry) const
  {
    if(entry.is_valid() && m_mesh.face(entry) == f) {
      const auto opposite_corner =
        barycentric_coordinates(side_number(m_mesh.prev(entry), m_mesh), FT(0));
      if(std::find(to.begin(), to.end(), opposite_corner) != to.end())
        return {f, from.front(), opposite_corner};
    }
    return shortest(surface, f, from, to);
  }

  template <typename Surface>
  static Segment shortest(const Surface& surface, Face_index f, const Points& from,
                          const Points& to)
  {
    Segment best{f, from.front(), to.front()};
    if(from.size() * to.size() > 1)
      for(const auto& p : from)
        for(const auto& q : to)
          if(segment_length(surface, Segment{f, p, q}) < segment_length(surface, best))
            best = {f, p, q};
    return best;
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  const Delta_complex& m_mesh;
  const Surface_path<FT>& m_path;
};

// Returns the points of a segment of a face of `side` on the other triangulation. These are its
// start, the points where it leaves faces, and its end. An end on an edge of both triangulations
// has the halfedge with the segment on its left.
template <typename Traits>
std::vector<Surface_point<typename Traits::FT>>
segment_across(const Correspondence<Traits>& correspondence, Side side,
               const Curve_segment<typename Traits::FT>& segment)
{
  const Face_index f = segment.face;
  return Segment_search<Traits>(correspondence, side,
                                f)(segment_end(correspondence, side, f, segment.source),
                                   segment_end(correspondence, side, f, segment.target));
}

// Adds the segments between consecutive positions, except segments as short as rounding errors.
template <typename FT>
void add_segments(const std::vector<Surface_point<FT>>& places, const Delta_complex& mesh,
                  Surface_curve<FT>& curve)
{
  const auto is_short = [](const Curve_segment<FT>& s) {
    for(std::size_t c = 0; c < 3; ++c)
      if(CGAL::abs(s.source[c] - s.target[c]) > rounding_unit<FT>())
        return false;
    return true;
  };
  Face_location<FT> from = face_location(places.front(), mesh);
  for(std::size_t i = 1; i < places.size(); ++i) {
    const Face_location<FT> to = face_location(places[i], mesh);
    CGAL_assertion(from.first == to.first);
    const Curve_segment<FT> segment{to.first, from.second, to.second};
    if(places.size() == 2 || !is_short(segment))
      curve.push_back(segment);
    if(i + 1 < places.size())
      from = face_location(reversed(*on_edge(places[i])), mesh);
  }
}

// Stores the positions of a path whose pieces are added in order. Between a vertex and the next
// position, it crosses no edge at this vertex, with any rounding.
template <typename FT>
class Joined_path
{
  typedef Surface_point<FT> Point;

public:
  explicit Joined_path(const Delta_complex& mesh) : m_mesh(mesh) {}

  bool is_empty() const { return m_places.empty(); }

  // Adds a piece. If the path continues straight from the previous piece and both are in one face,
  // their common end is omitted.
  void add(const std::vector<Point>& piece, bool goes_on_straight)
  {
    const Point& start = piece.front();
    if(is_empty())
      add_place(start);
    else if(!goes_on_straight || is_at_vertex(start))
      add_joint(start);
    else if(on_edge(start))
      add_crossing(reversed(*on_edge(start)));
    for(std::size_t i = 1; i + 1 < piece.size(); ++i)
      add_crossing(piece[i]);
    m_end = piece.back();
  }

  // Adds the end of the last piece, and returns the positions.
  std::vector<Point> finish()
  {
    come_to_end();
    m_places.push_back(m_end);
    return std::move(m_places);
  }

private:
  void add_place(const Point& p)
  {
    m_places.push_back(p);
    m_crossings = 0;
  }

  void add_joint(const Point& start)
  {
    come_to_end();
    const auto* p = on_edge(start);
    const bool is_inside = p && !m_mesh.is_border(m_mesh.opposite(p->halfedge));
    add_place(is_inside ? Point(reversed(*p)) : start);
  }

  void add_crossing(const Point& x)
  {
    const Halfedge_index h = halfedge_of(x), o = m_mesh.opposite(h),
                         from = halfedge_of(m_places.back());
    if(is_at_vertex(m_places.back()) && (from == h || from == m_mesh.next(h)))
      return leave_along(from == h ? m_mesh.next(o) : o);
    m_places.push_back(x);
    ++m_crossings;
  }

  // Ends the path at a vertex, with the path on the left of the halfedge `back`. A path through a
  // face from vertex to vertex follows an edge.
  void come_to_end()
  {
    if(!is_at_vertex(m_end))
      return;
    Halfedge_index back = halfedge_of(m_end);
    for(; m_crossings > 0; --m_crossings) {
      const Halfedge_index h = halfedge_of(m_places.back()), o = m_mesh.opposite(h);
      if(back != o && back != m_mesh.next(o))
        return;
      back = back == o ? m_mesh.next(h) : h;
      m_places.pop_back();
    }
    if(is_at_vertex(m_places.back()) && m_mesh.next(back) == halfedge_of(m_places.back()))
      leave_along(m_mesh.opposite(back));
  }

  // Makes the path leave its last vertex along `h`, or beside it on the left.
  void leave_along(Halfedge_index h) { m_places.back() = Vertex_location{h}; }

  const Delta_complex& m_mesh;
  std::vector<Point> m_places;
  std::size_t m_crossings = 0; // the last places that are crossings
  Point m_end{};               // of the last piece
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// maps a curve to the other triangulation: its segments are cut at the edges of that
/// triangulation.
///
/// The order and the directions of segments do not change. Parts whose length is rounding error are
/// left out. The sequence of faces that a segment passes is connected, however flat they are, also
/// for segments with a common end. Rounding only chooses between curves that are equal up to
/// rounding, such as the sides of an edge along which a curve runs. Apart from that, mapping a
/// curve to the other triangulation and back is the identity.
/// \param correspondence the crossings of both
/// \param side the triangulation whose faces `curve` refers to
/// \param curve segments with barycentric coordinates that are not negative and sum up to one
///
/// Complexity: linear in the edges that a segment meets up to rounding, with a logarithm of their
/// number. An end on an edge takes a logarithm of its crossings. An end inside a face takes a
/// logarithm of the crossings of a face of \f$T_2\f$. In a face of \f$T_1\f$ it is linear in the
/// regions of the subdivision between the end and a corner.
template <typename Traits>
Surface_curve<typename Traits::FT> curve_across(const Correspondence<Traits>& correspondence,
                                                Side side,
                                                const Surface_curve<typename Traits::FT>& curve)
{
  Surface_curve<typename Traits::FT> result;
  for(const auto& segment : curve)
    internal::add_segments(internal::segment_across(correspondence, side, segment),
                           correspondence.mesh(internal::other(side)), result);
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// maps a path over one triangulation to the other.
/// \param correspondence the crossings of both
/// \param side the triangulation that `path` runs over
/// \param path a path with positions as `Shortest_paths::path()` returns them. Between two vertices
///   it follows an edge, and everywhere else a straight line in a face. It may also bend at
///   inserted vertices and inside faces.
/// \returns the path with its unchanged length and its positions on the other triangulation, in
///   the form of `Shortest_paths::path()`. If it passes an inserted vertex of \f$T_2\f$, it has a
///   position in the face or on the edge of \f$T_1\f$ that contains the vertex. If a position on
///   \f$T_1\f$ is the position of an inserted vertex, the path passes this vertex of \f$T_2\f$.
///
/// Connectivity and rounding are described at `curve_across()` for curves. Complexity: the
/// complexity of that function.
/// \throws Invalid_input if two consecutive positions that are not both vertices share no face
template <typename Traits>
Surface_path<typename Traits::FT> curve_across(const Correspondence<Traits>& correspondence,
                                               Side side,
                                               const Surface_path<typename Traits::FT>& path)
{
  typedef typename Traits::FT FT;
  if(path.places.empty())
    return path;
  internal::Joined_path<FT> result(correspondence.mesh(internal::other(side)));
  const internal::Path_pieces<Traits> pieces(correspondence, side, path);
  for(std::size_t k = 0; k < pieces.size(); ++k)
    if(const Curve_segment<FT> s = pieces[k]; s.source != s.target)
      result.add(internal::segment_across(correspondence, side, s), pieces.starts_on_edge(k));
  if(!result.is_empty())
    return {path.length, result.finish()};
  const auto& [f, p] = face_location(path.places.front(), correspondence.mesh(side));
  return {path.length, {internal::segment_across(correspondence, side, {f, p, p}).front()}};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H
