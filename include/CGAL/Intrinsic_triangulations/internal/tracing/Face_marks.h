// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MARKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MARKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_tracer.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes the crossings on the sides of a face one by one, as `Face_map` needs them. An object can
// be used for many faces.
template <typename Traits>
class Face_marks
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;

  struct Mark
  {
    FT here;
    Edge_point<FT> across;
    FT scale;
  };

public:
  explicit Face_marks(const Triangulation& tri) : m_tri(tri) {}

  // Lays out each side of a face of T2 on the triangles of T1 that it passes.
  void set_face(Face_index f, const Edge_courses<Traits>& courses)
  {
    start(Side::intrinsic, f);
    for(std::size_t s = 0; s < 3; ++s)
      set_side(s, courses(m_side[s]));
  }

  // Starts a face whose marks are added one after the other along each side.
  void start(Side side, Face_index f)
  {
    m_on = side;
    m_side = sides(f, m_tri.surface(side).mesh());
    for(std::size_t s = 0; s < 3; ++s) {
      m_mark[s].clear();
      m_outgoing[s] = side == Side::intrinsic ? m_tri.input_outgoing_before(m_side[s])
                                              : Delta_complex::null_halfedge();
    }
  }

  void set_outgoing_before(std::size_t s, Halfedge_index h) { m_outgoing[s] = h; }

  void add(std::size_t s, const FT& here, const Edge_point<FT>& across, const FT& scale)
  {
    m_mark[s].push_back({here, across, scale});
  }

  Halfedge_index side(std::size_t s) const { return m_side[s]; }

  std::size_t crossings(std::size_t s) const { return m_mark[s].size(); }
  const FT& here(std::size_t s, std::size_t p) const { return m_mark[s][p].here; }
  const Edge_point<FT>& across(std::size_t s, std::size_t p) const { return m_mark[s][p].across; }
  const FT& scale(std::size_t s, std::size_t p) const { return m_mark[s][p].scale; }
  Halfedge_index outgoing_before(std::size_t s) const { return m_outgoing[s]; }
  Face_location<FT> vertex_across(std::size_t s, const Edge_point<FT>& at) const
  {
    return m_on == Side::input ? face_location(at, m_tri.mesh())
                               : m_tri.input_location(m_tri.mesh().source(m_side[s]), at);
  }

private:
  void set_side(std::size_t s, const Edge_course& course)
  {
    const Halfedge_index h = m_side[s];
    if(course.empty())
      return;
    if(!m_tri.traits().is_length_object()(m_tri.lay_out(m_strip, h, course)))
      throw Numerical_error("the strip of edge " + std::to_string(h.idx() / 2) +
                            " has no positive finite length");
    FT here(0); // rounding may move a crossing, but never past another
    for(std::size_t m = 0; m < course.size(); ++m) {
      const auto position = crossing_not_before<Traits>(here, m, m_strip);
      here = (std::max)(here, position.along_line);
      add(s, here, {opposite(course[m]), 1 - position.along_edge}, scale_of<Traits>(position));
    }
  }

  const Triangulation& m_tri;
  Side m_on = Side::intrinsic;
  std::array<Halfedge_index, 3> m_side, m_outgoing;
  std::array<std::vector<Mark>, 3> m_mark;
  typename Traits::Geodesic_strip m_strip;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MARKS_H
