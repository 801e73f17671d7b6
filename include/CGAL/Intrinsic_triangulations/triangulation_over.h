// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/coordinates_over.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// drops the input \f$T_1\f$ that two triangulations have in common: returns \f$T_3\f$, the second
/// triangulation of `tri`, over \f$T_2\f$, the second one of `base`, as its input. So tracing, the
/// common subdivision and everything else work between these two.
///
/// The integer coordinates of \f$T_2\f$ over \f$T_3\f$ follow from those of \f$T_1\f$ over both,
/// by flips (Section 3.4), without a length. The elements have the numbers that they have in `base`
/// and `tri`. Lengths and constraints are taken over; an edge of both has its length in `base`. With
/// exact traits the lengths of \f$T_2\f$, as they are stored, are the exact metric of the result.
/// Complexity: linear in the flips from \f$T_2\f$ and from \f$T_3\f$ to \f$T_1\f$, see
/// `flip_to_input()`.
/// \throws Invalid_input if the two have not the same input, or vertices have been inserted, or the
///   lengths of the two are too different to be rounded ones of one surface
/// \throws Overflow_error if a normal coordinate on the way is out of range
template <typename Traits>
Intrinsic_triangulation<Traits> triangulation_over(const Intrinsic_triangulation<Traits>& base,
                                                   const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  internal::check_common_input(base, tri);
  Delta_complex input = internal::without_maps(base.mesh());
  auto input_length = input.add_property_map<Edge_index, FT>("e:length", FT(0)).first;
  for(Edge_index e : input.edges())
    input_length[e] = base.length(e);

  Delta_complex mesh = internal::coordinates_over<Traits>(base, tri);
  auto length = mesh.add_property_map<Edge_index, FT>("e:length", FT(0)).first;
  auto is_constrained = mesh.add_property_map<Edge_index, bool>("e:is_constrained", false).first;
  const Integer_coordinates<typename Traits::Integer> coordinates(mesh);
  const Vertex_spokes spokes(input, boost::dummy_property_map());
  for(Edge_index e : mesh.edges()) {
    length[e] =
      coordinates.is_shared(e)
        ? base.length(Edge_index(coordinates.shared_halfedge(mesh.halfedge(e), mesh, spokes)))
        : tri.length(e);
    is_constrained[e] = tri.is_constrained(e) && coordinates.is_shared(e);
  }
  return {std::move(input), std::move(mesh), {}, base.traits()};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H
