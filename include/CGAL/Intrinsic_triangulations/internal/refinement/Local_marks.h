// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_LOCAL_MARKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_LOCAL_MARKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sides of a face of T2, each laid out on the triangles of T1 that it passes (see `Face_map`).
// An object can be used for many faces.
template <typename Traits>
class Local_marks
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;

  struct Mark
  {
    FT here;
    Edge_point<FT> across;
  };

public:
  explicit Local_marks(const Triangulation& tri) : m_tri(tri) {}

  void set_face(Face_index f, const Edge_courses<Traits>& courses)
  {
    m_side = sides(f, m_tri.mesh());
    for(std::size_t s = 0; s < 3; ++s)
      set_side(s, courses(m_side[s]));
  }

  Halfedge_index side(std::size_t s) const { return m_side[s]; }

  std::size_t crossings(std::size_t s) const { return m_mark[s].size(); }
  const FT& here(std::size_t s, std::size_t p) const { return m_mark[s][p].here; }
  const Edge_point<FT>& across(std::size_t s, std::size_t p) const { return m_mark[s][p].across; }
  // there are distances in this geometry, hence no scales
  FT scale(std::size_t, std::size_t) const { return FT(1); }
  Halfedge_index outgoing_before(std::size_t s) const
  {
    return m_tri.input_outgoing_before(m_side[s]);
  }
  Face_location<FT> vertex_across(std::size_t s, const Edge_point<FT>& at) const
  {
    return m_tri.input_location(m_tri.mesh().source(m_side[s]), at);
  }

private:
  void set_side(std::size_t s, const Edge_course& course)
  {
    const Halfedge_index h = m_side[s];
    m_mark[s].resize(course.size());
    if(course.empty())
      return;
    if(!m_tri.traits().is_length_object()(m_tri.lay_out(m_strip, h, course)))
      throw Numerical_error("the strip of edge " + std::to_string(h.idx() / 2) +
                            " has no positive finite length");
    FT here(0); // rounding may move a crossing, but never past another
    for(std::size_t m = 0; m < course.size(); ++m) {
      const auto position = m_strip.crossing(m, here);
      here = (std::max)(here, position.along_line);
      m_mark[s][m] = {here, {opposite(course[m]), 1 - position.along_edge}};
    }
  }

  const Triangulation& m_tri;
  std::array<Halfedge_index, 3> m_side;
  std::array<std::vector<Mark>, 3> m_mark;
  typename Traits::Geodesic_strip m_strip;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_LOCAL_MARKS_H
