// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXTRINSIC_MESH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXTRINSIC_MESH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename Point>
Surface_mesh<Point> mesh_with_connectivity(const Delta_complex& complex)
{
  Surface_mesh<Point> mesh;
  mesh.resize(complex.num_vertices(), complex.num_edges(), complex.num_faces());
  for(Halfedge_index h : complex.halfedges()) {
    mesh.set_next(h, complex.next(h));
    mesh.set_target(h, complex.target(h));
    mesh.set_face(h, complex.face(h));
  }
  for(Vertex_index v : complex.vertices())
    mesh.set_halfedge(v, complex.halfedge(v));
  for(Face_index f : complex.faces())
    mesh.set_halfedge(f, complex.halfedge(f));
  return mesh;
}

inline void check_simplicial(const Delta_complex& mesh)
{
  for(Face_index f : mesh.faces())
    if(!is_simplicial(f, mesh))
      throw Invalid_input("face " + std::to_string(f.idx()) +
                          " is not simplicial: a side of it is a loop or has the ends of another "
                          "edge, or another face has the same corners");
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// returns \f$T_2\f$ as a mesh in space, if it is simplicial. Vertices are at their positions on
/// the surface of \f$T_1\f$, edges are straight, and faces are flat. All elements keep their
/// indices. So the surface differs, but is close to the original if the faces are small. The
/// common subdivision is the surface itself. `refine()` makes a triangulation simplicial on
/// request. Complexity: linear in the sum of the squared degrees.
///
/// \param pair the two triangulations
/// \param positions a readable property map from the vertices of \f$T_1\f$ to points of a kernel
/// \returns a `CGAL::Surface_mesh` with these points
/// \throws Invalid_input if \f$T_2\f$ is not simplicial
/// \pre \f$T_2\f$ has no garbage
template <typename Traits, typename PointMap>
auto extrinsic_mesh(const Triangulation_pair<Traits>& pair, const PointMap& positions)
{
  CGAL_precondition(!pair.mesh().has_garbage());
  internal::check_simplicial(pair.mesh());
  auto mesh =
    internal::mesh_with_connectivity<typename boost::property_traits<PointMap>::value_type>(
      pair.mesh());
  interpolate(pair, positions, mesh.points());
  return mesh;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXTRINSIC_MESH_H
