// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SMALL_ANGLE_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SMALL_ANGLE_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Determines the vertices at which no triangulation can have large angles. Either two boundary or
// constrained edges enclose less than 60 degrees (Section 3.6), or the angle sum is less than
// `least_sum`.
template <typename Traits>
class Small_angle_vertices
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;

public:
  Small_angle_vertices(const Triangulation& tri, const FT& least_sum, bool has_exact_angles)
    : m_tri(tri), m_least_sum(least_sum), m_answer(tri.mesh().num_vertices(), Answer::unknown)
  {
    if constexpr(has_exact_decisions<Traits>())
      if(has_exact_angles)
        set_by_input();
  }

  // Returns why a face that violates the bound on angles is excused, and by which small-angle
  // vertex. Either exactly one of its corners is a small-angle vertex, or it lies in faces of T1 at
  // a small-angle vertex. In the second case all edges that cross it must be edges at this vertex.
  // `courses()` returns the courses of all edges and is called only if they are needed.
  template <typename Courses>
  std::optional<Remaining_face> excuse(Face_index f, const Courses& courses) const
  {
    Vertex_index vertex;
    int count = 0;
    for(Halfedge_index h : sides(f, m_tri.mesh()))
      if(has_small_angle(m_tri.mesh().source(h))) {
        vertex = m_tri.mesh().source(h);
        ++count;
      }
    if(count == 1)
      return Remaining_face{f, Remaining_reason::at_small_angle_vertex, vertex};
    return excuse_by_input_faces(f, courses());
  }

private:
  enum class Answer : char
  {
    unknown,
    yes,
    no
  };

  static Answer answer(bool is_small) { return is_small ? Answer::yes : Answer::no; }

  // Computes angles on demand, because few vertices have thin faces.
  bool has_small_angle(Vertex_index v) const
  {
    if(v.idx() >= m_answer.size())
      return false;
    if(m_answer[v] == Answer::unknown)
      m_answer[v] = answer(has_small_sector(v));
    return m_answer[v] == Answer::yes;
  }

  bool has_small_sector(Vertex_index v) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    const auto is_fixed = [&](Halfedge_index h) {
      return m_tri.is_constrained(mesh.edge(h)) || mesh.is_border(mesh.edge(h));
    };
    return has_small_sector(v, mesh, is_fixed,
                            [&](Halfedge_index h) { return angle_at_source(h, m_tri); });
  }

  // A face that is crossed only by edges at one vertex lies in faces at this vertex. It need not
  // lie in one face only. Otherwise, several faces of T1 that share the wedge at a small-angle
  // vertex would be filled with ever smaller faces.
  std::optional<Remaining_face> excuse_by_input_faces(Face_index f,
                                                      const Edge_courses<Traits>& courses) const
  {
    for(Vertex_index v : first_candidates(f, courses))
      if(has_small_angle(v) && is_crossed_by_edges_at(v, f, courses))
        return Remaining_face{f, Remaining_reason::beside_small_angle_vertex, v};
    return {};
  }

  // Returns the ends of an edge of T1 that crosses `f`. If none crosses it, returns the corners of
  // the face that contains it.
  std::array<Vertex_index, 3> first_candidates(Face_index f,
                                               const Edge_courses<Traits>& courses) const
  {
    const Delta_complex& input = m_tri.input_mesh();
    const auto side = sides(f, m_tri.mesh());
    for(Halfedge_index h : side)
      if(courses.count(h) > 0) {
        const Halfedge_index first = opposite(courses(h)[0]);
        return {input.source(first), input.target(first), input.target(first)};
      }
    const auto corner = sides(m_tri.input_location(side[0]).first, input);
    return {input.source(corner[0]), input.source(corner[1]), input.source(corner[2])};
  }

  bool is_crossed_by_edges_at(Vertex_index v, Face_index f,
                              const Edge_courses<Traits>& courses) const
  {
    for(Halfedge_index h : sides(f, m_tri.mesh())) {
      const Edge_course course = courses(h);
      for(std::size_t m = 0; m < course.size(); ++m)
        if(m_tri.input_mesh().source(course[m]) != v && m_tri.input_mesh().target(course[m]) != v)
          return false;
    }
    return true;
  }

  // Angles around a vertex are angles of T1, whose corners need no strips, however often edges
  // cross. Inserted vertices have no small angle.
  BOOST_NOINLINE void set_by_input()
  {
    const Delta_complex &mesh = m_tri.mesh(), &input = m_tri.input_mesh();
    std::vector<char> is_constrained(input.num_halfedges(), false);
    for(Halfedge_index h : mesh.halfedges())
      if(m_tri.is_constrained(mesh.edge(h)) && !m_tri.is_inserted(mesh.source(h)))
        is_constrained[m_tri.input_outgoing_before(h)] = true;
    const auto is_fixed = [&](Halfedge_index h) {
      return is_constrained[h] || input.is_border(input.edge(h));
    };
    m_answer.assign(m_answer.size(), Answer::no);
    const auto decisions = exact_decisions(m_tri);
    const auto angle = [&](Halfedge_index h) { return decisions.input_angle(h); };
    for(Vertex_index v : input.vertices())
      m_answer[v] = answer(has_small_sector(v, input, is_fixed, angle));
  }

  // Returns whether `v` is a small-angle vertex of T1 or T2.
  template <typename Is_fixed, typename Angle>
  bool has_small_sector(Vertex_index v, const Delta_complex& mesh, const Is_fixed& is_fixed,
                        const Angle& angle) const
  {
    if(mesh.is_isolated(v))
      return false;
    FT least(-1), sector(0), before_first_fixed(0);
    bool has_fixed = false;
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      if(is_fixed(h)) {
        if(has_fixed)
          least = least < 0 ? sector : (std::min)(least, sector);
        else
          before_first_fixed = sector;
        has_fixed = true;
        sector = FT(0);
      }
      if(!mesh.is_border(h))
        sector += angle(h);
    });
    const FT limit = pi<FT>() / 3;
    if(mesh.is_border(v))
      return least < limit;
    const FT closing = sector + before_first_fixed;
    return least < 0 ? closing < m_least_sum : (std::min)(least, closing) < limit;
  }

  const Triangulation& m_tri;
  FT m_least_sum;
  mutable std::vector<Answer> m_answer;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SMALL_ANGLE_VERTICES_H
