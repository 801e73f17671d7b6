// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_MESH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_MESH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_part.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// adds the common subdivision of both triangulations of a correspondence to a mesh of any type.
/// Its vertices are the vertices of \f$T_2\f$, in their order, and then the crossings. Complexity:
/// linear.
///
/// \tparam Graph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param correspondence the crossings
/// \param out the mesh; elements that it has are kept
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{input_point_map}
///     \cgalParamDescription{the positions of the vertices of \f$T_1\f$}
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
///     \cgalParamDescription{gets the vertex of \f$T_1\f$ for each vertex of `out`; null if it is
///       no such vertex}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key and `Vertex_index` as
///                    value, or `std::array<Vertex_index, 2>` for both triangulations}
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
template <typename Traits, typename Graph,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void common_subdivision(const Correspondence<Traits>& correspondence, Graph& out,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef Common_subdivision<Traits> Subdivision;
  const Subdivision subdivision(correspondence);
  const Subdivision_part<Subdivision> part(subdivision);
  const Copied_part copy(part, out);
  write_input_points(
    part, copy, out, [&](Vertex_index v) { return subdivision.weights(Side::input, v); }, np);
  write_parents(part, copy, out, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_MESH_H
