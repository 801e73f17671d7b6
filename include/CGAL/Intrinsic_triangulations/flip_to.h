// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_shared.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Delaunay_matching.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/coordinates_over.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Flips T2 by integer coordinates alone. Lengths are set at the end, because intermediate edges
// need not be straight.
template <typename Traits>
class Coordinate_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  explicit Coordinate_flipping(Triangulation& tri) : m_tri(tri), m_result(tri) {}

  std::size_t flip_to_input()
  {
    for(Edge_index e : m_result.mesh().edges())
      if(!m_result.coordinates().is_shared(e))
        m_result.set_constrained(e, false);
    const auto flips =
      flip_to_shared(m_result.m_coordinates, m_result.m_mesh, m_result.m_outgoing_halfedges).size();
    for(Edge_index e : m_result.mesh().edges())
      m_result.m_length[e] = m_result.shared_length(m_result.mesh().halfedge(e));
    m_tri = std::move(m_result);
    return flips;
  }

  std::size_t flip_to(const Triangulation& target)
  {
    Delta_complex over = coordinates_over<Traits>(target, m_tri);
    typename Triangulation::Coordinates coordinates(over);
    const Outgoing_halfedges outgoing_halfedges(target.mesh(), boost::dummy_property_map());
    const std::vector<Halfedge_index> flips = flip_to_shared(coordinates, over, outgoing_halfedges);
    for(Halfedge_index h : flips)
      m_result.m_coordinates.flip(h, m_result.m_mesh, m_result.m_outgoing_halfedges);
    for(Edge_index e : m_result.mesh().edges()) {
      const Edge_index there(
        coordinates.shared_halfedge(over.halfedge(e), over, outgoing_halfedges));
      m_result.set_edge(m_result.mesh().halfedge(e), target.length(there),
                        target.is_constrained(there));
    }
    m_tri = std::move(m_result);
    return flips.size();
  }

private:
  Triangulation& m_tri;
  Triangulation m_result;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// turns \f$T_2\f$ of `tri` back into \f$T_1\f$ by flips that follow the integer coordinates alone
/// (Mosher's algorithm, Algorithm 4). Edges of \f$T_1\f$ stay constrained; other constraints are
/// dropped. Complexity: finite; in practice below the number of crossings.
/// \returns the number of flips
/// \throws Overflow_error if an intermediate normal coordinate is out of range; nothing has
///   changed then.
/// \pre no vertex has been inserted
template <typename Traits>
std::size_t flip_to_input(Intrinsic_triangulation<Traits>& tri)
{
  CGAL_precondition(tri.number_of_inserted_vertices() == 0);
  return internal::Coordinate_flipping<Traits>(tri).flip_to_input();
}

namespace internal {

// Counts the flips until all edges of T3 exist. Remaining vertices of T2 lie in faces of T3.
template <typename Traits>
std::size_t flip_to_inserted(Intrinsic_triangulation<Traits>& tri,
                             const Intrinsic_triangulation<Traits>& target)
{
  const Intrinsic_triangulation<Traits> over = inserted_over(target, tri);
  Delta_complex mesh = over.mesh();
  typename Intrinsic_triangulation<Traits>::Coordinates coordinates(mesh);
  const std::size_t flips = flip_to_shared(coordinates, mesh, over.outgoing_halfedges()).size();
  tri = target;
  return flips;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// turns \f$T_2\f$ into \f$T_3\f$, the second triangulation of `target`, by flips that follow
/// integer coordinates alone (Section 3.4). These are the coordinates of \f$T_3\f$ over \f$T_2\f$,
/// see `rebase()`. Lengths and constraints become lengths and constraints of \f$T_3\f$. Indices of
/// edges and faces may differ. Complexity: finite; in practice below the numbers of crossings of
/// the three triangulations with each other.
///
/// If vertices have been inserted, `tri` becomes a copy of `target`, see `rebase()`. Vertices of
/// `target` are inserted, edges are flipped, and vertices that are not in `target` are removed.
/// \returns the number of flips until all edges of \f$T_3\f$ exist
/// \throws Invalid_input if the two do not have the same input
/// \throws Numerical_error as `rebase()` if vertices have been inserted
/// \throws Overflow_error if an intermediate normal coordinate is out of range
///
/// After an exception nothing has changed.
template <typename Traits>
std::size_t flip_to(Intrinsic_triangulation<Traits>& tri,
                    const Intrinsic_triangulation<Traits>& target)
{
  internal::check_common_input(tri, target);
  if constexpr(internal::can_have_inserted_vertices<Traits>())
    if(internal::have_inserted_vertices(tri, target))
      return internal::flip_to_inserted(tri, target);
  return internal::Coordinate_flipping<Traits>(tri).flip_to(target);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_H
