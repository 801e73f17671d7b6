// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_LAPLACIAN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsWeights
/// computes the Laplacian of a triangulation with weighted vertices \cgalCite{Gli05}. The weight
/// of an edge is the length of its dual edge, see `dual_edge_length()`, divided by its own length.
/// With equal weights this is `cotan_laplacian()`. If the triangulation is weighted Delaunay, the
/// weights of edges with two faces are not negative. Then the matrix is positive semidefinite on a
/// surface without boundary. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
/// \param weight a readable property map from vertices to the number type of lengths
/// \throws Invalid_input if a weight is infinite or NaN
/// \throws Numerical_error if the area of a face is zero or out of range
template <typename Surface, typename WeightMap>
auto weighted_laplacian(const Surface& surface, const WeightMap& weight)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  for(Vertex_index v : mesh.vertices())
    internal::check_finite(FT(get(weight, v)), v.idx(), "the weight");
  for(Face_index f : mesh.faces())
    if(!internal::has_gradients(Face_metric<FT>(f, surface), f))
      throw Numerical_error("the area of face " + std::to_string(f.idx()) + " is zero");
  std::vector<FT> on_edge(mesh.num_edges(), FT(0));
  for(Edge_index e : mesh.edges())
    on_edge[e.idx()] = dual_edge_length(e, surface, weight) / get(surface.length_map(), e);
  return internal::laplacian_of(mesh, std::move(on_edge));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_LAPLACIAN_H
