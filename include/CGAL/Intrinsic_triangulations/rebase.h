// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REBASE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REBASE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Delaunay_matching.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/coordinates_over.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns T3 over T2, where both have the vertices of T1.
template <typename Traits>
Intrinsic_triangulation<Traits> flipped_over(const Intrinsic_triangulation<Traits>& base,
                                             const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  Delta_complex input = without_maps(base.mesh());
  auto input_length = stored_length_map<FT>(input);
  for(Edge_index e : input.edges())
    input_length[e] = base.length(e);

  Delta_complex mesh = coordinates_over<Traits>(base, tri);
  auto length = stored_length_map<FT>(mesh);
  const Integer_coordinates<typename Traits::Integer> coordinates(mesh);
  const Outgoing_halfedges outgoing_halfedges(input, boost::dummy_property_map());
  for(Edge_index e : mesh.edges())
    length[e] = coordinates.is_shared(e) ? base.length(Edge_index(coordinates.shared_halfedge(
                                             mesh.halfedge(e), mesh, outgoing_halfedges)))
                                         : tri.length(e);
  Intrinsic_triangulation<Traits> result(std::move(input), std::move(mesh), {}, base.traits());
  for(Edge_index e : result.mesh().edges())
    result.set_constrained(e, tri.is_constrained(e) && result.coordinates().is_shared(e));
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// returns \f$T_3\f$, the second triangulation of `tri`, as an intrinsic triangulation whose input
/// is \f$T_2\f$, the second triangulation of `base`. Both have the same input \f$T_1\f$. So
/// tracing, the common subdivision and all other functions work between \f$T_2\f$ and \f$T_3\f$.
///
/// The integer coordinates of \f$T_2\f$ over \f$T_3\f$ follow from the coordinates of \f$T_1\f$
/// over both, by flips (Section 3.4), without a length. The elements have the indices that they
/// have in `base` and `tri`. Lengths are copied; an edge of both has its length in `base`.
/// Constraints are copied for edges of both. With exact traits the stored lengths of \f$T_2\f$ are
/// the exact metric of the result. Complexity: linear in the flips from \f$T_2\f$ and from
/// \f$T_3\f$ to \f$T_1\f$, see `flip_to_input()`.
///
/// Inserted vertices at equal positions on \f$T_1\f$ are the same vertices. Vertices that only
/// \f$T_2\f$ has are inserted into \f$T_3\f$. Vertices that only \f$T_3\f$ has are inserted
/// vertices of the result, with positions on \f$T_2\f$. Vertices have the indices that they have
/// in `base`, and other elements have new indices.
///
/// Within a face of \f$T_1\f$ integer coordinates do not determine how curves wind around inserted
/// vertices. Therefore the flips lead over the Delaunay triangulation of all these vertices; ties
/// are allowed. Straight edges identify it, by their ends and the edges of \f$T_1\f$ that they
/// cross. Lengths are recomputed on \f$T_2\f$.
///
/// Complexity with inserted vertices: a product, plus \f$O(n \log n)\f$ in the edges. The first
/// factor is the complexity of `make_Delaunay()` for both and of `Correspondence`. The second
/// factor is the greatest number of times that a face is split.
/// \throws Invalid_input if the two do not have the same input, or their lengths differ by more
///   than rounding
/// \throws Numerical_error if rounding moves a vertex of one triangulation to another element of
///   \f$T_1\f$ in the other one. Another reason is that both Delaunay triangulations differ by more
///   than ties
/// \throws Overflow_error if an intermediate normal coordinate is out of range
/// \pre the two have no garbage, see `Intrinsic_triangulation::collect_garbage()`
template <typename Traits>
Intrinsic_triangulation<Traits> rebase(const Intrinsic_triangulation<Traits>& base,
                                       const Intrinsic_triangulation<Traits>& tri)
{
  internal::check_common_input(base, tri);
  if constexpr(internal::can_have_inserted_vertices<Traits>())
    if(internal::have_inserted_vertices(base, tri))
      return internal::inserted_over(base, tri);
  return internal::flipped_over(base, tri);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REBASE_H
