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
#include <CGAL/Intrinsic_triangulations/internal/tracing/Path_pieces.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Segment_search.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

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
/// Connectivity, rounding and complexity are as in `curve_across()` for curves.
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
