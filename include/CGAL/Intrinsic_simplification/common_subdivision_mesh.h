// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_COMMON_SUBDIVISION_MESH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_COMMON_SUBDIVISION_MESH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_part.h>

#include <CGAL/boost/graph/Euler_operations.h>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// adds the common subdivision of both levels of a map to a mesh of any type. Vertices of the fine
/// level come first, in their order, then others (see `Surface_subdivision`).
///
/// Faces with two sides, which have no area, are joined with a neighbor; then `out` can have
/// garbage. Polygons need not be convex. Complexity: see `Surface_subdivision`.
///
/// \tparam Graph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param map the map
/// \param out the mesh; elements that it has are kept
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{input_point_map}
///     \cgalParamDescription{the positions of the vertices of the fine level}
///     \cgalParamType{a readable property map with `Vertex_index` as key and a point of a kernel as
///                    value, such as `mesh.points()` of a `Surface_mesh` without garbage; for other
///                    graphs, vertices are numbered in the order of `vertices(g)`}
///     \cgalParamDefault{none: `out` gets no positions}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the map that gets the positions of the vertices of `out`}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, out)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_vertex_map}
///     \cgalParamDescription{gets the vertex of the fine level for each vertex of `out`; null if it
///       is no such vertex}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key and `Vertex_index` as
///                    value, or `std::array<Vertex_index, 2>` for both levels}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_edge_map}
///     \cgalParamDescription{gets the edge that contains each edge of `out`; null if no edge
///       contains it}
///     \cgalParamType{as before, with edges and `Edge_index`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_face_map}
///     \cgalParamDescription{gets for each face of `out` the face that contains it}
///     \cgalParamType{as before, with faces and `Face_index`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Intrinsic_triangulations::Numerical_error as `Surface_subdivision`; then `out` is not
///   changed
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
void common_subdivision(const Surface_map& map, Graph& out,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace IT = Intrinsic_triangulations;
  typedef Surface_subdivision<> Subdivision;
  const Subdivision subdivision(map);
  const IT::Subdivision_part<Subdivision> part(subdivision);
  const IT::Copied_part copy(part, out);
  IT::write_input_points(
    part, copy, out, [&](Vertex_index v) { return subdivision.weights(Level::fine, v); }, np);
  IT::write_parents(part, copy, out, np);
  for(Face_index f : part.faces())
    if(const auto h = copy.halfedge_of(part.mesh().halfedge(f)); next(next(h, out), out) == h)
      Euler::join_face(is_border(opposite(h, out), out) ? next(h, out) : h, out);
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_COMMON_SUBDIVISION_MESH_H
