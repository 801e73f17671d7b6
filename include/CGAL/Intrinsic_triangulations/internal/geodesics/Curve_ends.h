// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_ENDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_ENDS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/angles.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Segment_origin.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the points at which segments of a curve end. Segments that share an end lie side by side
// in this list. A shortest path leaves the end of a segment at no less than a right angle to it. So
// all segments at a point determine the directions in which paths from this point can start.
template <typename Surface>
class Curve_ends
{
public:
  typedef Length_of<Surface> FT;
  typedef std::complex<FT> Vector;
  typedef std::vector<Sector_in_face<FT>> Sectors;

  // Collects and sorts the ends. Complexity: O(n log n).
  Curve_ends(const Surface& surface, const Surface_curve<FT>& curve)
    : m_surface(surface), m_mesh(surface.mesh())
  {
    for(const Curve_segment<FT>& segment : curve) {
      m_ends.push_back(end({segment.face, segment.source}, segment.target));
      m_ends.push_back(end({segment.face, segment.target}, segment.source));
    }
    std::sort(m_ends.begin(), m_ends.end(),
              [](const End& a, const End& b) { return a.key() < b.key(); });
  }

  // Calls `visit(p, sectors)` for each point, a location in one of its faces, with the directions
  // of paths in all of its faces.
  template <typename Visit>
  void for_each_point(const Visit& visit) const
  {
    for(auto first = m_ends.begin(); first != m_ends.end();) {
      const auto last = std::find_if_not(first, m_ends.end(),
                                         [&](const End& e) { return is_same_point(*first, e); });
      visit(first->place, sectors(first, last));
      first = last;
    }
  }

private:
  struct End
  {
    Face_location<FT> place;
    Halfedge_index along; // the edge of the point; null inside a face
    Vector direction;     // of the segment, in the frame of the face
    std::size_t kind, index;
    FT x, y; // its coordinates in the edge or the face

    auto key() const { return std::tie(kind, index, x, y); }
  };

  typedef typename std::vector<End>::const_iterator Iterator;

  Flat_face<FT> flat_face(Face_index f) const { return {m_mesh.halfedge(f), m_surface}; }

  End end(const Face_location<FT>& p, const std::array<FT, 3>& q) const
  {
    const Surface_point<FT> point = surface_point(p, m_mesh);
    const Halfedge_index along = halfedge_of(point);
    const Vector direction = flat_face(p.first).between(p.second, q);
    const std::size_t kind = point.index();
    if(is_at_vertex(point))
      return {p, along, direction, kind, m_mesh.source(along).idx(), FT(0), FT(0)};
    if(const auto* e = on_edge(point))
      return {p,
              along,
              direction,
              kind,
              Edge_index(along).idx(),
              place_on_first_halfedge(edge_point(*e)),
              FT(0)};
    return {p, along, direction, kind, p.first.idx(), p.second[1], p.second[2]};
  }

  // Returns whether two ends are one point. A point on an edge is rounded differently in both faces
  // of the edge.
  static bool is_same_point(const End& a, const End& b)
  {
    const FT tolerance = rounding_unit<FT>();
    return a.kind == b.kind && a.index == b.index && CGAL::abs(a.x - b.x) <= tolerance &&
           CGAL::abs(a.y - b.y) <= tolerance;
  }

  // Stores all directions around a point, and the halfedge along which each sector starts.
  struct Surrounding
  {
    Sectors sectors;
    std::vector<Halfedge_index> along;
    FT sum = FT(0);
    bool is_cyclic = true;

    void add(Halfedge_index h, const Face_location<FT>& at, const Vector& start, const FT& angle)
    {
      along.push_back(h);
      sectors.push_back({at, start, sum, sum, sum + angle});
      sum += angle;
    }

    void exclude(const FT& angle)
    {
      const FT turn = is_cyclic ? sum : FT(0);
      for(const FT& middle : {FT(angle - turn), angle, FT(angle + turn)})
        for(auto& sector : sectors)
          sector.exclude(middle);
    }
  };

  Sectors sectors(Iterator first, Iterator last) const
  {
    Surrounding around = surrounding(*first);
    for(auto e = first; e != last; ++e) {
      const auto found = std::find(around.along.begin(), around.along.end(), e->along);
      const auto& in = around.sectors[static_cast<std::size_t>(found - around.along.begin())];
      const FT angle = std::arg(e->direction * std::conj(in.start));
      around.exclude(in.first + (angle < -pi<FT>() / 2 ? FT(angle + 2 * pi<FT>()) : angle));
    }
    for(auto& sector : around.sectors)
      sector.widen();
    return around.sectors;
  }

  Surrounding surrounding(const End& p) const
  {
    Surrounding result;
    if(p.kind == 2)
      result.add(p.along, p.place, normalized(p.direction), 2 * pi<FT>());
    else if(p.kind == 1)
      add_sides(p, result);
    else
      add_corners(m_mesh.source(p.along), result);
    return result;
  }

  void add_sides(const End& p, Surrounding& around) const
  {
    const Edge_point<FT> on_first{first_halfedge(Edge_index(p.along)), p.x};
    for(const Edge_point<FT>& q : {on_first, reversed(on_first, m_mesh)})
      if(m_mesh.is_border(q.halfedge))
        around.is_cyclic = false;
      else
        around.add(q.halfedge, face_location(q, m_mesh), direction(q.halfedge), pi<FT>());
  }

  void add_corners(Vertex_index v, Surrounding& around) const
  {
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.is_border(h)) {
        around.is_cyclic = false;
        return;
      }
      const Vector next = -direction(m_mesh.prev(h)), start = direction(h);
      around.add(h, face_location(Edge_point<FT>{h, FT(0)}, m_mesh), start,
                 CGAL::abs(std::arg(next * std::conj(start))));
    });
  }

  Vector direction(Halfedge_index h) const
  {
    return flat_face(m_mesh.face(h)).direction(side_number(h, m_mesh));
  }

  const Surface& m_surface;
  const Delta_complex& m_mesh;
  std::vector<End> m_ends;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_ENDS_H
