// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/side_access.h>

#include <CGAL/assertions.h>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// the tangent vector at the source of `spoke` that is `vector` in the frame of this halfedge
template <typename EdgeLengthMap, typename FT>
std::complex<FT> at_vertex(Halfedge_index spoke, const std::complex<FT>& vector,
                           const Delta_complex& mesh, const EdgeLengthMap& length)
{
  const FT angle = std::arg(vector), corner = angle_at_source(spoke, mesh, length);
  const Vertex_angles<FT> angles(spoke, mesh, length);
  // the middle of the corner decides whether the vector or its opposite is in the corner
  if(std::cos(angle - corner / 2) >= 0)
    return std::polar(std::abs(vector), angles.normalized(angle));
  return -std::polar(std::abs(vector), angles.normalized(std::arg(-vector)));
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// takes a tangent vector from the frame of a face to that of one of its vertices.
///
/// Its angle from `spoke` is normalized (Section 2.3.2). A vector that points away from the corner
/// is the opposite of one that points into it, so that the direction in which a geodesic arrives
/// becomes the one in which it goes on.
/// \param spoke the halfedge of the face whose source is the vertex; it tells one corner from
///        another if they are at the same vertex
/// \param vector the vector in the frame of the face
/// \param mesh a triangulated surface
/// \param length a readable property map from its edges to their lengths, floating point numbers
/// Complexity: linear in the degree of the vertex.
/// \throws Numerical_error if the angles at the vertex have no positive finite sum
template <typename EdgeLengthMap, typename FT>
std::complex<FT> tangent_vector_at_vertex(Halfedge_index spoke, const std::complex<FT>& vector,
                                          const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(!mesh.is_border(spoke));
  const Halfedge_index h = mesh.halfedge(mesh.face(spoke));
  const internal::Flat_face<FT> face(spoke, mesh, length);
  const std::size_t s = h == spoke ? 0 : h == mesh.next(spoke) ? 1 : 2;
  return internal::at_vertex(spoke, vector * face.direction(s), mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same for one of the two triangulations of `tri`.
template <typename Traits>
std::complex<typename Traits::FT>
tangent_vector_at_vertex(Side side, Halfedge_index spoke,
                         const std::complex<typename Traits::FT>& vector,
                         const Intrinsic_triangulation<Traits>& tri)
{
  return tangent_vector_at_vertex(spoke, vector, internal::mesh_of(side, tri),
                                  internal::lengths_of(side, tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the logarithm of `p` at the source of `spoke`: the tangent vector there that leads straight
/// through the face to `p`, its length times \f$e^{\mathbf{i}\varphi}\f$ with the normalized angle
/// \f$\varphi\f$ counterclockwise from `first_spoke()`.
///
/// `trace_geodesic()` of the result ends at `p`. There may be shorter geodesics through other
/// faces: see `logarithmic_map()`.
/// \param spoke a halfedge of the face of `p`
/// \param p a point with barycentric coordinates that are not negative and sum up to one
/// \param mesh a triangulated surface
/// \param length a readable property map from its edges to their lengths, floating point numbers
/// Complexity: linear in the degree of the vertex.
/// \throws Numerical_error if the angles at the vertex have no positive finite sum
template <typename EdgeLengthMap, typename FT>
std::complex<FT> logarithm(Halfedge_index spoke, const Face_location<FT>& p,
                           const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(mesh.face(spoke) == p.first);
  const internal::Flat_face<FT> face(spoke, mesh, length);
  const std::array<FT, 3> q = coordinates_from(spoke, p, mesh);
  return internal::at_vertex(spoke, q[1] * face.side(0) - q[2] * face.side(2), mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same for one of the two triangulations of `tri`.
template <typename Traits>
std::complex<typename Traits::FT> logarithm(Side side, Halfedge_index spoke,
                                            const Face_location<typename Traits::FT>& p,
                                            const Intrinsic_triangulation<Traits>& tri)
{
  return logarithm(spoke, p, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the logarithm of `q` at `p`, a point of the same face: the vector from `p` to `q` in the frame
/// of the face. Complexity: constant.
/// \param p, q points with barycentric coordinates that sum up to one
/// \param mesh a triangulated surface
/// \param length a readable property map from its edges to their lengths, floating point numbers
/// \pre `p` and `q` are in one face
template <typename EdgeLengthMap, typename FT>
std::complex<FT> logarithm(const Face_location<FT>& p, const Face_location<FT>& q,
                           const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(p.first == q.first);
  return internal::Flat_face<FT>(mesh.halfedge(p.first), mesh, length).between(p.second, q.second);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same for one of the two triangulations of `tri`.
template <typename Traits>
std::complex<typename Traits::FT> logarithm(Side side, const Face_location<typename Traits::FT>& p,
                                            const Face_location<typename Traits::FT>& q,
                                            const Intrinsic_triangulation<Traits>& tri)
{
  return logarithm(p, q, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
