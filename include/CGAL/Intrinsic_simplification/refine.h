// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/operations/Refinement_follower.h>
#include <CGAL/Intrinsic_simplification/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Returns an intrinsic triangulation that is a level of a surface, with its constraints.
// \throws Numerical_error if a triangle inequality fails: lengths of levels are rounded
inline Evolving_surface::Triangulation constrained_triangulation(const Surface_level& level,
                                                                 const Intrinsic_surface& surface)
{
  std::vector<char> is_constrained;
  for(Edge_index e : surface.mesh().edges())
    is_constrained.push_back(surface.is_constrained(e) ? 1 : 0);
  const auto map = boost::make_function_property_map<Edge_index>(
    [&](Edge_index e) { return is_constrained[e] != 0; });
  try {
    return Evolving_surface::Triangulation(
      level.mesh(), Intrinsic_triangulations::parameters::edge_length_map(level.length_map())
                      .edge_is_constrained_map(map));
  } catch(const Intrinsic_triangulations::Invalid_input& e) {
    throw Intrinsic_triangulations::Numerical_error(e.what());
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// inserts vertices into a surface and flips it to Delaunay until every face satisfies the bounds
/// or is excused, as `Intrinsic_triangulations::refine()` does. The geometry of the surface does
/// not change. Operations are recorded like removals: maps, subdivisions and prolongations lead
/// through both.
///
/// \tparam NamedParameters a sequence of named parameters
/// \param surface the surface
/// \param np the parameters of `Intrinsic_triangulations::refine()`. The predicate and the visitor
///   get elements of an intrinsic triangulation of the surface, with indices without gaps.
///
/// Complexity: see `Intrinsic_triangulations::refine()`, plus linear in the elements.
/// \returns the numbers of operations, the status, and the faces of the surface that violate the
///   bounds, with the reason
/// \throws the exceptions of `Intrinsic_triangulations::refine()`; afterwards the surface is valid
/// \throws Intrinsic_triangulations::Numerical_error if the lengths of a face of the surface
///   violate the triangle inequality by rounding
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
Intrinsic_triangulations::Refinement_result
refine(Evolving_surface& surface, const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace IT = Intrinsic_triangulations;
  IT::Default_refinement_visitor silent;
  auto&& visitor = IT::internal::visitor_of(np, silent);
  typedef std::remove_reference_t<decltype(visitor)> Visitor;
  Evolving_surface::Triangulation tri =
    internal::constrained_triangulation(Surface_level(surface), surface.surface());
  internal::Refinement_follower<Visitor> follower(tri, surface, visitor);
  IT::Refinement_result result = IT::refine(tri, np.visitor(std::ref(follower)));
  follower.take_lengths();
  for(IT::Remaining_face& f : result.remaining) {
    f.face = follower.image(f.face);
    if(f.vertex.is_valid())
      f.vertex = follower.image(f.vertex);
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H
