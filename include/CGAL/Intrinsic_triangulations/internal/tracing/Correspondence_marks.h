// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDENCE_MARKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDENCE_MARKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Describes the sides of a face to `Face_map`, read from a correspondence.
template <typename Traits>
class Correspondence_marks
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;

public:
  Correspondence_marks(Side side, Face_index f, const Correspondence<Traits>& correspondence)
    : m_side(side),
      m_halfedge(sides(f, correspondence.mesh(side))),
      m_correspondence(correspondence)
  {}

  std::size_t crossings(std::size_t s) const
  {
    return m_correspondence.number_of_crossings(m_side, Edge_index(m_halfedge[s]));
  }
  FT here(std::size_t s, std::size_t p) const { return crossing(s, p).here.t; }
  Edge_point<FT> across(std::size_t s, std::size_t p) const { return crossing(s, p).across; }
  FT scale(std::size_t s, std::size_t p) const
  {
    const FT on_input = m_correspondence.scale(crossing(s, p).id);
    return m_side == Side::input ? on_input : FT(1 / on_input);
  }
  Halfedge_index outgoing_before(std::size_t s) const
  {
    return m_correspondence.outgoing_before(m_side, m_halfedge[s]);
  }
  Face_location<FT> vertex_across(std::size_t s, const Edge_point<FT>& at) const
  {
    const auto& tri = m_correspondence.triangulation();
    return m_side == Side::input ? face_location(at, tri.mesh())
                                 : tri.input_location(tri.mesh().source(m_halfedge[s]), at);
  }

private:
  auto crossing(std::size_t s, std::size_t p) const
  {
    return m_correspondence.crossing(m_side, m_halfedge[s], static_cast<size_type>(p));
  }

  Side m_side;
  std::array<Halfedge_index, 3> m_halfedge;
  const Correspondence<Traits>& m_correspondence;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDENCE_MARKS_H
