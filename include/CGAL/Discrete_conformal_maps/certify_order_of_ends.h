// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_ORDER_OF_ENDS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_ORDER_OF_ENDS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// two neighboring crossings on an edge of \f$T_2\f$: one with an edge of \f$T_1\f$, the other with
/// an edge of \f$T_3\f$.
struct Pair_of_ends
{
  Halfedge_index along; ///< the first halfedge of the edge of \f$T_2\f$
  Vertex_index first,   ///< the vertex of the subdivision that comes first along it
    second;             ///< the vertex that follows
};

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the results of exact decisions about the order in which edges of \f$T_1\f$ and \f$T_3\f$ cross
/// edges of \f$T_2\f$. This order determines the connectivity of a `Triple_subdivision`.
struct Order_certificate
{
  /// the number of pairs decided in floating point, with error bounds.
  std::size_t decided_in_floating_point = 0;
  /// the number of pairs decided with more digits.
  std::size_t decided_in_multiprecision = 0;
  /// the number of pairs decided in exact arithmetic.
  std::size_t decided_exactly = 0;
  std::vector<Pair_of_ends> ties;      ///< the pairs at one position, for which any order is right
  std::vector<Pair_of_ends> exchanged; ///< the pairs in wrong order
  std::vector<Pair_of_ends> undecided; ///< the pairs without a decision

  /// returns whether the order is right on all edges.
  bool is_exact() const { return exchanged.empty() && undecided.empty(); }
};

namespace internal {

template <typename Subdivision, typename Ideal_traits>
class Order_certifier
{
  typedef Delta_complex::size_type size_type;
  typedef Correspondence<Ideal_traits> Ideal_correspondence;

public:
  Order_certifier(const Subdivision& subdivision, const Correspondence<>& ab,
                  const Ideal_correspondence& bc)
    : m_subdivision(subdivision), m_ab(ab), m_bc(bc), m_decisions(ab.triangulation(), ab.courses())
  {}

  Order_certificate operator()()
  {
    find_pairs();
    for(const Neighbors& pair : m_pairs)
      decide(pair);
    m_result.decided_in_floating_point = m_decisions.count().floating_point;
    m_result.decided_in_multiprecision = m_decisions.count().multiprecision;
    m_result.decided_exactly = m_decisions.count().exact;
    return std::move(m_result);
  }

private:
  struct Neighbors
  {
    Pair_of_ends ends;
    size_type p, q;  // the indices of the crossings with A and with C along the edge
    bool A_is_first; // in the subdivision
  };

  size_type count_of_A(Edge_index e) const { return m_ab.number_of_crossings(Side::intrinsic, e); }

  void find_pairs()
  {
    const Delta_complex& mesh = m_ab.mesh(Side::intrinsic);
    std::vector<size_type> count;
    for(Edge_index e : mesh.edges())
      count.push_back(count_of_A(e) + m_bc.number_of_crossings(Side::input, e));
    const Intrinsic_triangulations::Edge_marks marks(std::move(count));
    for(Edge_index e : mesh.edges())
      if(count_of_A(e) > 0 && count_of_A(e) < marks.size(e))
        find_pairs(e, marks);
  }

  // Finds pairs of ends from two families. Edges of one family do not cross, so the order of their
  // own ends follows from integers.
  void find_pairs(Edge_index e, const Intrinsic_triangulations::Edge_marks& marks)
  {
    const Halfedge_index h = Intrinsic_triangulations::first_halfedge(e);
    const auto vertex = [&](size_type i) { return m_subdivision.mesh().target(marks.piece(h, i)); };
    const auto is_of_A = [&](size_type i) {
      return vertex(i).idx() < m_ab.mesh(Side::input).num_vertices() + m_ab.number_of_crossings();
    };
    size_type p = 0, q = 0; // crossings with A and C before mark i
    for(size_type i = 0; i < marks.size(e); ++i) {
      const bool is_A = is_of_A(i);
      if(i > 0 && is_A != is_of_A(i - 1))
        m_pairs.push_back(
          {{h, vertex(i - 1), vertex(i)}, is_A ? p : p - 1, is_A ? q - 1 : q, !is_A});
      ++(is_A ? p : q);
    }
  }

  // Returns the position of crossing `m` on the first halfedge of the edge `e` of C.
  auto place_of_C(Edge_index e, size_type m)
  {
    const Halfedge_index h = Intrinsic_triangulations::first_halfedge(e);
    const auto course = m_bc.courses()(h);
    m_bc.triangulation().lay_out(m_strip, h, course);
    return Intrinsic_triangulations::edge_point(course[m], m_strip.crossing(m).along_edge).t;
  }

  void decide(const Neighbors& pair)
  {
    const auto c = m_bc.crossing(Side::input, pair.ends.along, pair.q);
    const Edge_index e(c.across.halfedge);
    const size_type m = c.id - m_bc.crossings_on_intrinsic().before(e);
    try {
      const Sign order = m_decisions.compare_place(pair.ends.along, pair.p, place_of_C(e, m));
      if(order == ZERO)
        m_result.ties.push_back(pair.ends);
      else if((order == NEGATIVE) != pair.A_is_first)
        m_result.exchanged.push_back(pair.ends);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      m_result.undecided.push_back(pair.ends);
    }
  }

  const Subdivision& m_subdivision;
  const Correspondence<>& m_ab;
  const Ideal_correspondence& m_bc;
  Intrinsic_triangulations::Ideal_strip<Lazy_exact_nt<Intrinsic_triangulations::Exact_field>>
    m_strip;
  Intrinsic_triangulations::internal::Exact_decisions<typename Correspondence<>::Traits>
    m_decisions;
  std::vector<Neighbors> m_pairs;
  Order_certificate m_result;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// decides exactly, without a tolerance, whether a subdivision has its crossings in the right
/// order. These are crossings of edges of \f$T_2\f$ with edges of \f$T_1\f$ and of \f$T_3\f$. If
/// so, its connectivity is exact.
///
/// The metric of \f$T_1\f$ is exact, as in `Intrinsic_triangulations::certify_Delaunay()`, which
/// certifies that the edges of \f$T_2\f$ are straight. It determines the crossings of edges of
/// \f$T_2\f$ and \f$T_1\f$. The Penner lengths of \f$T_2\f$, as exact numbers, determine the
/// crossings of edges of \f$T_2\f$ and \f$T_3\f$, for any scale factors. The integer coordinates
/// determine exactly which triangles an edge passes. The order of neighboring crossings determines
/// the order of all crossings on an edge.
///
/// A pair remains undecided if 1024 bits do not decide it and more than twelve independent square
/// roots are involved. These are square roots of areas of faces of \f$T_1\f$ that the edge passes.
/// Edges of \f$T_1\f$ and \f$T_2\f$ that run along each other, in faces without area, count as
/// ties.
///
/// \param subdivision the subdivision
/// \param ab the correspondence of \f$T_1\f$ and \f$T_2\f$
/// \param bc the correspondence of \f$T_2\f$ and \f$T_3\f$
///
/// Complexity: linear in the edges and crossings, and for each pair in the faces that its edges of
/// \f$T_2\f$ and \f$T_3\f$ pass.
/// \tparam Ideal_traits `Intrinsic_triangulations::Ideal_geometry_traits`, or
///   `Intrinsic_triangulations::Hyperideal_geometry_traits` without radii
/// \pre The edges of \f$T_2\f$ are straight; `subdivision` belongs to these three triangulations
template <typename FT, typename Point, typename Ideal_traits>
Order_certificate certify_order_of_ends(const Triple_subdivision<FT, Point>& subdivision,
                                        const Correspondence<>& ab,
                                        const Correspondence<Ideal_traits>& bc)
{
  return internal::Order_certifier<Triple_subdivision<FT, Point>, Ideal_traits>(subdivision, ab,
                                                                                bc)();
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_ORDER_OF_ENDS_H
