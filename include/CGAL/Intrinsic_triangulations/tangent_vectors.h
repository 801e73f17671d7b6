// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <complex>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the tangent vector at the source of `outgoing` that is `vector` in the frame of this
// halfedge.
template <typename Surface, typename FT>
std::complex<FT> at_vertex(const Surface& surface, Halfedge_index outgoing,
                           const std::complex<FT>& vector)
{
  const FT angle = std::arg(vector), corner = angle_at_source(outgoing, surface);
  const Vertex_angles<FT> angles(outgoing, surface);
  // The middle of the corner decides whether the vector or its opposite is in the corner.
  if(std::cos(angle - corner / 2) >= 0)
    return std::polar(std::abs(vector), angles.normalized(angle));
  return -std::polar(std::abs(vector), angles.normalized(std::arg(-vector)));
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// transforms a tangent vector from the frame of a face to the frame of one of its vertices.
///
/// Its angle from `outgoing` is normalized (Section 2.3.2). A vector that points away from the
/// corner is the opposite of a vector that points into it. So the direction in which a geodesic
/// arrives becomes the direction in which it continues. Complexity: linear in the degree of the
/// vertex.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param outgoing the halfedge of the face whose source is the vertex; it determines the corner if
///        several are at one vertex
/// \param vector the vector in the frame of the face
/// \throws Numerical_error if the angles at the vertex have no positive finite sum
template <typename Surface>
std::complex<Length_of<Surface>>
tangent_vector_at_vertex(const Surface& surface, Halfedge_index outgoing,
                         const std::complex<Length_of<Surface>>& vector)
{
  const Delta_complex& mesh = surface.mesh();
  CGAL_precondition(!mesh.is_border(outgoing));
  const Halfedge_index h = mesh.halfedge(mesh.face(outgoing));
  const Flat_face<Length_of<Surface>> face(outgoing, surface);
  return internal::at_vertex(surface, outgoing,
                             vector * face.direction(side_number(h, outgoing, mesh)));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// returns the tangent vector of a vertex that points into the surface at an angle from an edge.
///
/// The angle runs along all faces of the vertex, whose sum may be less or greater than a full turn.
/// So each direction at a saddle can be chosen, for example as a start of `trace_geodesic()`.
/// Complexity: linear in the degree of the vertex.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param outgoing the halfedge whose source is the vertex. It may be a border halfedge
/// \param angle the angle on the surface, counterclockwise from `outgoing`, in radians. Inside the
///        surface it may be any finite number
/// \param length the length of the vector, not negative
/// \throws Invalid_input if the vertex is on the boundary, and the direction is outside
/// \throws Numerical_error if the angles at the vertex have no positive finite sum
template <typename Surface>
std::complex<Length_of<Surface>>
tangent_vector_at_angle(const Surface& surface, Halfedge_index outgoing,
                        const Length_of<Surface>& angle, const Length_of<Surface>& length)
{
  typedef Length_of<Surface> FT;
  const internal::Vertex_angles<FT> angles(outgoing, surface);
  const FT normalized = angles.normalized(angle), quarter = pi<FT>() / 2;
  if(angles.is_border() && std::abs(normalized - quarter) > quarter * (1 + 4 * rounding_unit<FT>()))
    throw Invalid_input("vertex " + std::to_string(surface.mesh().source(outgoing).idx()) +
                        " is on the boundary, and this direction leads out of the surface");
  return std::polar(length, normalized);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// computes the logarithm of `p` at the source of `outgoing`: the tangent vector that leads
/// straight through the face to `p`. It is the length times \f$e^{\mathbf{i}\varphi}\f$, with the
/// normalized angle \f$\varphi\f$ counterclockwise from `first_outgoing_halfedge()`.
///
/// `trace_geodesic()` of the result ends at `p`. There may be shorter geodesics through other
/// faces: see `logarithmic_map()`. Complexity: linear in the degree of the vertex.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param outgoing a halfedge of the face of `p`; the logarithm is taken at its source
/// \param p a point with barycentric coordinates that are not negative and sum up to one
/// \throws Numerical_error if the angles at the vertex have no positive finite sum
template <typename Surface>
std::complex<Length_of<Surface>> logarithm(const Surface& surface, Halfedge_index outgoing,
                                           const Face_location<Length_of<Surface>>& p)
{
  CGAL_precondition(surface.mesh().face(outgoing) == p.first);
  const Flat_face<Length_of<Surface>> face(outgoing, surface);
  const auto q = coordinates_from(outgoing, p, surface.mesh());
  return internal::at_vertex(surface, outgoing, q[1] * face.side(0) - q[2] * face.side(2));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// computes the logarithm of `q` at `p`, two points of one face: the vector from `p` to `q` in the
/// frame of the face. Complexity: constant.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param p, q points with barycentric coordinates that sum up to one
/// \pre `p` and `q` are in one face
template <typename Surface>
std::complex<Length_of<Surface>> logarithm(const Surface& surface,
                                           const Face_location<Length_of<Surface>>& p,
                                           const Face_location<Length_of<Surface>>& q)
{
  CGAL_precondition(p.first == q.first);
  const Flat_face<Length_of<Surface>> face(surface.mesh().halfedge(p.first), surface);
  return face.between(p.second, q.second);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
