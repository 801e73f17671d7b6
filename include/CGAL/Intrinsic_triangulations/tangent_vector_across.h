// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTOR_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTOR_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Angular_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/angle_on_input.h>

#include <CGAL/assertions.h>

#include <complex>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Transforms a vector from the frame of T2 to the frame of T1, or back. `angle` is the angle of
// the first outgoing halfedge of T2 in the frame of T1.
template <typename FT>
std::complex<FT> turned_across(Side side, const std::complex<FT>& vector, const FT& angle)
{
  return vector * std::polar(FT(1), side == Side::input ? -angle : angle);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// transforms a tangent vector at the vertex `v` of \f$T_2\f$ from the frame of one triangulation
/// to the frame of the other. The frame of \f$T_2\f$ is the frame of `Tangent_frames`. For the
/// frame of \f$T_1\f$ see `angle_on_input()`.
///
/// Both are frames of one tangent space: the vectors differ by a rotation. On the boundary they are
/// equal.
/// \param tri both triangulations
/// \param side the triangulation in whose frame `vector` is
/// \param v a vertex, not isolated
/// \param vector the vector
///
/// Complexity: the complexity of `angle_on_input()` for one halfedge.
/// \throws Numerical_error as `angle_on_input()`
template <typename Traits>
std::complex<typename Traits::FT>
tangent_vector_across(const Intrinsic_triangulation<Traits>& tri, Side side, Vertex_index v,
                      const std::complex<typename Traits::FT>& vector)
{
  CGAL_precondition(!tri.mesh().is_isolated(v));
  return internal::turned_across(side, vector,
                                 angle_on_input(tri, first_outgoing_halfedge(v, tri.mesh())));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// transforms one of many tangent vectors from the frame of one triangulation to the frame of the
/// other. Complexity: constant.
/// \param angles the angles on both triangulations
/// \param side the triangulation in whose frame `vector` is
/// \param v a vertex, not isolated
/// \param vector the vector
template <typename Traits>
std::complex<typename Traits::FT>
tangent_vector_across(const Angular_coordinates<Traits>& angles, Side side, Vertex_index v,
                      const std::complex<typename Traits::FT>& vector)
{
  const Delta_complex& mesh = angles.triangulation().mesh();
  CGAL_precondition(!mesh.is_isolated(v));
  return internal::turned_across(side, vector, angles.angle(first_outgoing_halfedge(v, mesh)));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTOR_ACROSS_H
