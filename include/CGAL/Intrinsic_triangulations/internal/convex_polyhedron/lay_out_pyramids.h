// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_LAY_OUT_PYRAMIDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_LAY_OUT_PYRAMIDS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Precise_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Radii.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out faces in space one after the other, breadth first, by the angles between the bases of
// their pyramids.
class Pyramid_layout
{
  typedef Double_double Number;

public:
  Pyramid_layout(const Metric_surface& surface, const Radii& radii)
    : m_surface(surface),
      m_radii(radii),
      m_positions(surface.mesh().num_vertices()),
      m_is_placed(surface.mesh().num_vertices(), false),
      m_is_reached(surface.mesh().num_faces(), false)
  {
    const Delta_complex& mesh = surface.mesh();
    const Halfedge_index first = longest_side_of_largest_face();
    place(mesh.source(first), {});
    place(mesh.target(first), {surface.length(first), 0, 0});
    reach({first, {1, 0, 0}, {0, 1, 0}});
    for(; !m_queue.empty(); m_queue.pop_front())
      cross_sides(m_queue.front());
  }

  const std::vector<Precise_vector>& positions() const { return m_positions; }

private:
  // Stores a face with the directions of its halfedge `h` and of the height over it.
  struct Frame
  {
    Halfedge_index h;
    Precise_vector along, across;
  };

  // The layout starts at this side, so that coordinates across it and over its face are small if
  // the polyhedron is thin.
  Halfedge_index longest_side_of_largest_face() const
  {
    Halfedge_index result;
    double greatest_area = -1;
    for(Face_index f : m_surface.mesh().faces()) {
      const auto side = sides(f, m_surface.mesh());
      const double area = Face_metric<Number>(f, m_surface).quadrupled_area().high();
      if(!(area > greatest_area))
        continue;
      greatest_area = area;
      result = *std::max_element(side.begin(), side.end(), [&](Halfedge_index h, Halfedge_index o) {
        return m_surface.length(h) < m_surface.length(o);
      });
    }
    return result;
  }

  void place(Vertex_index v, const Precise_vector& p)
  {
    if(m_is_placed[v.idx()])
      return;
    m_is_placed[v.idx()] = true;
    m_positions[v.idx()] = p;
  }

  // Places the corner opposite to the halfedge of `frame`.
  void reach(const Frame& frame)
  {
    const Delta_complex& mesh = m_surface.mesh();
    const Halfedge_index h = frame.h;
    m_is_reached[mesh.face(h).idx()] = true;
    const Number a = m_surface.length(h), b = m_surface.length(mesh.next(h)),
                 c = m_surface.length(mesh.prev(h));
    place(mesh.target(mesh.next(h)), m_positions[mesh.source(h).idx()] +
                                       doubled_corner_product(b, a, c) / (2 * a) * frame.along +
                                       quadrupled_area(a, b, c) / (2 * a) * frame.across);
    m_queue.push_back(frame);
  }

  void cross_sides(const Frame& frame)
  {
    const Delta_complex& mesh = m_surface.mesh();
    const std::array<Halfedge_index, 3> side{frame.h, mesh.next(frame.h), mesh.prev(frame.h)};
    for(Halfedge_index h : side)
      if(const Halfedge_index o = opposite(h); !m_is_reached[mesh.face(o).idx()])
        reach(beyond(turned(frame, h)));
  }

  // Returns the frame of the face for its side `h`.
  Frame turned(const Frame& frame, Halfedge_index h) const
  {
    if(h == frame.h)
      return frame;
    const Delta_complex& mesh = m_surface.mesh();
    const bool is_next = h == mesh.next(frame.h);
    const Halfedge_index third = is_next ? mesh.prev(frame.h) : mesh.next(frame.h);
    // The frame turns by the exterior angle between its halfedge and `h`.
    const Number a = m_surface.length(frame.h), b = m_surface.length(h),
                 c = m_surface.length(third), area = quadrupled_area(a, b, c);
    const Number cosine = Number(-1) * doubled_corner_product(c, a, b) / (2 * a * b),
                 sine = (is_next ? Number(1) : Number(-1)) * area / (2 * a * b);
    return {h, cosine * frame.along + sine * frame.across,
            (Number(-1) * sine) * frame.along + cosine * frame.across};
  }

  // Returns the frame of the face beyond the halfedge of `frame`. It is turned by the sum of the
  // angles of both pyramids at the edge, from one base through the inside to the other.
  Frame beyond(const Frame& frame) const
  {
    const Halfedge_index o = opposite(frame.h);
    const auto [height, foot] = over(frame.h);
    const auto [other_height, other_foot] = over(o);
    const Number squares = foot * foot + height * height,
                 cosine = (foot * other_foot - height * other_height) / squares,
                 sine = (height * other_foot + foot * other_height) / squares;
    return {o, Number(-1) * frame.along,
            cosine * frame.across + (Number(-1) * sine) * cross(frame.along, frame.across)};
  }

  // Returns the height of the apex over the face of `h`, and the height of its foot over `h`.
  std::array<Number, 2> over(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_surface.mesh();
    const Face_index f = mesh.face(h);
    const Pyramid p = pyramid(f, m_surface, m_radii);
    const auto side = sides(f, mesh);
    const auto s = static_cast<std::size_t>(std::find(side.begin(), side.end(), h) - side.begin());
    return {p.height(), p.foot_height(s)};
  }

  const Metric_surface& m_surface;
  const Radii& m_radii;
  std::vector<Precise_vector> m_positions;
  std::vector<bool> m_is_placed, m_is_reached;
  std::deque<Frame> m_queue;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_LAY_OUT_PYRAMIDS_H
