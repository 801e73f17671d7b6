// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents the local Delaunay condition (Equation 2.6).
template <typename Traits>
struct Delaunay_condition
{
  // Returns whether the edge of a halfedge is Delaunay for any rounding of lengths.
  static bool is_certain(Halfedge_index, const Diamond<double>& length)
  {
    return Euclidean_geometry_traits<double>::Is_locally_Delaunay{certified_length_error()}
      .is_certain(length);
  }

  static Sign sign(Halfedge_index h, Exact_decisions<Traits>& decisions)
  {
    return decisions.Delaunay_sign(h);
  }
};

// Proves that T2 is a geodesic triangulation and that its edges satisfy a condition, edge by edge.
template <typename Traits, typename Condition = Delaunay_condition<Traits>>
class Certifier
{
  typedef Triangulation_pair<Traits> Pair;

public:
  typedef Exact_decisions<Traits> Decisions;

  Certifier(const Pair& pair, const Edge_courses<Traits>& courses, Concurrency concurrency,
            Condition condition = {})
    : m_pair(pair),
      m_mesh(pair.mesh()),
      m_courses(courses),
      m_concurrency(concurrency),
      m_condition(std::move(condition)),
      m_length(m_mesh.num_edges(), std::numeric_limits<double>::quiet_NaN()),
      m_is_checked(m_mesh.num_vertices(), false)
  {}

  Delaunay_certificate run()
  {
    check_exact_triangles(exact_input(m_pair));
    for_each<Edge_index>(
      [this](auto e, auto& decisions, auto& part) { check_straightness(e, decisions, part); });
    for_each<Edge_index>(
      [this](auto e, auto& decisions, auto& part) { check_condition(e, decisions, part); });
    if(m_pair.number_of_inserted_vertices() > 0)
      for_each<Vertex_index>(
        [this](auto v, auto& decisions, auto& part) { check_inserted(v, decisions, part); });
    return std::move(m_certificate);
  }

  // Returns decisions for several calls of `straight_length()`.
  Decisions decisions() const { return Decisions(m_pair, m_courses); }

  // Returns the length of the edge `e`. Returns zero if the edge cannot be proved straight, or the
  // faces at inserted ends are not proved to turn around once.
  double straight_length(Edge_index e, Decisions& decisions)
  {
    try {
      const Halfedge_index h = m_mesh.halfedge(e);
      check_straightness(e, decisions, m_certificate);
      for(Vertex_index v : {m_mesh.source(h), m_mesh.target(h)})
        if(!std::exchange(m_is_checked[v.idx()], true))
          check_inserted(v, decisions, m_certificate);
      return !m_certificate.is_geodesic() ? 0
             : std::isnan(m_length[e])    ? decisions.length(h)
                                          : m_length[e];
    } catch(const Numerical_error&) {
      return 0;
    }
  }

private:
  // Calls `check(x, decisions, part)` for all elements. Each chunk has its own decisions and
  // certificate.
  template <typename Index, typename Check>
  void for_each(const Check& check)
  {
    const std::size_t n = number_of_indices<Index>(m_mesh);
    const bool has_garbage = m_mesh.has_garbage();
    std::vector<Delaunay_certificate> parts(number_of_chunks(n));
    for_each_chunk(m_concurrency, n, [&](std::size_t begin, std::size_t end) {
      Decisions decisions = this->decisions();
      Delaunay_certificate& part = parts[begin / chunk_size];
      for(std::size_t i = begin; i < end; ++i)
        if(const Index x(static_cast<Delta_complex::size_type>(i));
           !has_garbage || !m_mesh.is_removed(x))
          check(x, decisions, part);
      part.decided_in_floating_point = decisions.count().floating_point;
      part.decided_in_multiprecision = decisions.count().multiprecision;
      part.decided_exactly = decisions.count().exact;
    });
    for(const Delaunay_certificate& part : parts)
      add(part);
  }

  void add(const Delaunay_certificate& part)
  {
    const auto append = [](const auto& from, auto& to) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(part.non_straight_edges, m_certificate.non_straight_edges);
    append(part.non_Delaunay_edges, m_certificate.non_Delaunay_edges);
    append(part.ties, m_certificate.ties);
    append(part.folded_vertices, m_certificate.folded_vertices);
    append(part.possibly_non_Delaunay_edges, m_certificate.possibly_non_Delaunay_edges);
    append(part.possibly_non_straight_edges, m_certificate.possibly_non_straight_edges);
    append(part.possibly_folded_vertices, m_certificate.possibly_folded_vertices);
    m_certificate.decided_by_lengths += part.decided_by_lengths;
    m_certificate.decided_in_floating_point += part.decided_in_floating_point;
    m_certificate.decided_in_multiprecision += part.decided_in_multiprecision;
    m_certificate.decided_exactly += part.decided_exactly;
  }

  // Checks whether the edge `e` is straight, and stores its length.
  void check_straightness(Edge_index e, Decisions& decisions, Delaunay_certificate& part)
  {
    const Straight_edge straight = decisions.straight_edge(m_mesh.halfedge(e));
    m_length[e] = straight.length;
    if(!straight.is_certain)
      add_unless(e, part.non_straight_edges, part.possibly_non_straight_edges,
                 [&] { return decisions.is_straight(m_mesh.halfedge(e)); });
  }

  void check_condition(Edge_index e, Decisions& decisions, Delaunay_certificate& part)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    if(m_mesh.is_border(e) || m_pair.is_constrained(e))
      return;
    const auto length = [this](Halfedge_index x) { return m_length[m_mesh.edge(x)]; };
    if(m_condition.is_certain(h, diamond_of(length, h, m_mesh))) {
      ++part.decided_by_lengths;
      return;
    }
    add_unless(e, part.non_Delaunay_edges, part.possibly_non_Delaunay_edges, [&] {
      const Sign sign = m_condition.sign(h, decisions);
      if(sign == ZERO)
        part.ties.push_back(e);
      return sign != NEGATIVE;
    });
  }

  void check_inserted(Vertex_index v, Decisions& decisions, Delaunay_certificate& part)
  {
    if(m_pair.is_inserted(v))
      add_unless(v, part.folded_vertices, part.possibly_folded_vertices,
                 [&] { return is_turned_around_once(v, decisions); });
  }

  // Adds `x` to `failures` unless `holds()`, or to `undecided` if no decision is affordable.
  template <typename Index, typename Property>
  static void add_unless(Index x, std::vector<Index>& failures, std::vector<Index>& undecided,
                         const Property& holds)
  {
    try {
      if(!holds())
        failures.push_back(x);
    } catch(const Numerical_error&) {
      undecided.push_back(x);
    }
  }

  // Returns whether the faces at an inserted vertex are oriented and turn around it once. The sum
  // of the angles is a multiple of 2 pi (of pi on the boundary), so few digits suffice.
  bool is_turned_around_once(Vertex_index v, Decisions& decisions) const
  {
    double sum = 0;
    bool is_oriented = true;
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.is_border(h))
        return;
      is_oriented = is_oriented && decisions.is_oriented(h);
      sum += decisions.rounded_angle(h, counted_angle_error());
    });
    return is_oriented && std::lround(sum / pi<double>()) == (m_mesh.is_border(v) ? 1 : 2);
  }

  const Pair& m_pair;
  const Delta_complex& m_mesh;
  const Edge_courses<Traits>& m_courses;
  Concurrency m_concurrency;
  Condition m_condition;
  std::vector<double> m_length;   // NaN if it is not known well enough
  std::vector<char> m_is_checked; // vertices, by `straight_length()`
  Delaunay_certificate m_certificate;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H
