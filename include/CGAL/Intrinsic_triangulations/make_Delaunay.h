// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Edge_stack.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// a visitor that does nothing. A class derived from it needs to define only what it wants to see.
///
/// \cgalModels `FlipVisitor`
struct Default_flip_visitor
{
  /// is called after the edge of `h` has been flipped.
  void after_flip(Halfedge_index /* h */) {}
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// returns whether every edge of `tri` that could be flipped is Delaunay (Equation 2.6). With
/// floating point numbers the tolerance is one-sided: `false` is true of the stored lengths, `true`
/// of lengths within `rounding_unit()` of them. Complexity: linear.
template <typename Traits>
bool is_Delaunay(const Intrinsic_triangulation<Traits>& tri)
{
  for(Edge_index e : tri.mesh().edges())
    if(!tri.is_Delaunay(e))
      return false;
  return true;
}

namespace internal {

// Whether the lengths around `e` leave no doubt; those beyond the boundary mean nothing.
template <typename Traits>
bool is_certainly_Delaunay(Edge_index e, const Intrinsic_triangulation<Traits>& tri)
{
  return tri.traits().is_locally_Delaunay_object().is_certain(
    diamond(tri.length_map(), tri.mesh().halfedge(e), tri.mesh()));
}

// What a run of flips has done.
struct Flip_count
{
  std::size_t flips = 0;
  std::size_t failed = 0; // those whose new edge is not Delaunay either, for rounding of lengths
};

template <typename Traits, typename Visitor>
Flip_count flip_to_Delaunay(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                            Visitor& visitor)
{
  const Delta_complex& mesh = tri.mesh();
  Edge_stack stack(mesh.num_edges());
  for(Edge_index e : mesh.edges())
    stack.push_if(!is_certainly_Delaunay(e, tri), e);
  Flip_count count;
  while(!stack.empty()) {
    const Edge_index e = stack.pop();
    if(tri.is_Delaunay(e))
      continue;
    if(count.flips == limit)
      throw Flip_limit_exceeded("not Delaunay after as many flips as are allowed");
    const Halfedge_index h = mesh.halfedge(e);
    tri.flip(h);
    ++count.flips;
    if(is_rounded<typename Traits::FT>() && !tri.is_Delaunay(e))
      ++count.failed;
    for(Edge_index side : edges_around(h, mesh))
      stack.push_if(!is_certainly_Delaunay(side, tri), side);
    visitor.after_flip(h);
  }
  return count;
}

// Where edges have been flipped more than once on average, rounding may have added up; where a flip
// failed, it has. One or two rounds are enough then, but nothing guarantees it.
template <typename Traits, typename Visitor>
std::size_t make_Delaunay(Intrinsic_triangulation<Traits>& tri, std::size_t limit, Visitor& visitor)
{
  std::size_t flips = 0;
  for(int round = 0; round < 100; ++round) {
    const Flip_count last = flip_to_Delaunay(tri, limit - flips, visitor);
    flips += last.flips;
    if(last.flips <= tri.mesh().number_of_edges() && last.failed == 0)
      return flips;
    tri.recompute_lengths();
  }
  throw Numerical_error("rounding of the lengths keeps the triangulation from becoming Delaunay");
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// flips edges of `tri` until it is Delaunay (Section 2.3.3). Boundary and constrained edges stay.
/// If there were more flips than edges, or rounding has left a flipped edge non-Delaunay, lengths
/// are recomputed from \f$T_1\f$ and flipping goes on.
///
/// \tparam Traits a model of `IntrinsicGeometryTraits`
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of flips that are allowed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{a thousand for each edge, and a hundred million}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every flip; an exception that it throws stops the
///                           flipping and leaves `tri` valid}
///     \cgalParamType{a model of `FlipVisitor`; use `std::ref()` to pass an object with a state}
///     \cgalParamDefault{`Default_flip_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the edges and flips. The number of flips has no bound in the number of
/// edges, since a geodesic triangulation can be sheared without end; on real meshes it is about the
/// number of edges. A mark for each edge and a stack of edges are allocated.
/// \returns the number of flips
/// \throws Flip_limit_exceeded if more flips than allowed were needed
/// \throws Numerical_error if a flipped length is not positive and finite, or rounding of the
///         lengths stands against the postcondition
/// \throws Overflow_error if a normal coordinate is out of range
/// After an exception `tri` is a valid triangulation of the same surface.
/// \post `is_Delaunay(tri)`
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t make_Delaunay(Intrinsic_triangulation<Traits>& tri,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  const Delta_complex& mesh = tri.mesh();
  const std::size_t limit =
    choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                     internal::default_flip_limit(mesh.number_of_edges()));
  Default_flip_visitor silent;
  auto&& visitor =
    choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), silent);
  return internal::make_Delaunay(tri, limit, visitor);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H
