// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_PIECES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_PIECES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Segment_search.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_PIECES_H
