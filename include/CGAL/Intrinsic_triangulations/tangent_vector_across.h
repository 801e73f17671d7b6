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
#include <CGAL/Intrinsic_triangulations/internal/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/angle_in_strip.h>

#include <CGAL/assertions.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// The halfedges of T1 through which the halfedge `h` of T2 leaves faces, in order: the curves that
// cross it are followed to their ends, which tell their edges.
template <typename Traits>
std::vector<Halfedge_index> input_exits(Halfedge_index h,
                                        const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::Integer Integer;
  typedef typename Intrinsic_triangulation<Traits>::Coordinates Coordinates;
  const Coordinates& coordinates = tri.coordinates();
  std::vector<Halfedge_index> result;
  for(Integer number(0); number < coordinates.crossings(h); ++number) {
    typename Coordinates::Crossing c{h, number};
    while(coordinates.advance(c, tri.mesh()) != Coordinates::Turn::ends) {
    }
    result.push_back(coordinates.spoke_at_end(c, tri.mesh(), tri.spokes()));
  }
  return result;
}

// takes a vector from the frame of T2 to that of T1, or back; `angle` is that of the first spoke of
// T2 in the frame of T1
template <typename FT>
std::complex<FT> turned_across(Side side, const std::complex<FT>& vector, const FT& angle)
{
  return vector * std::polar(FT(1), side == Side::input ? -angle : angle);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the normalized angle in which the halfedge `h` of \f$T_2\f$ leaves its source, in the frame of
/// \f$T_1\f$ there (see `Tangent_frames`).
///
/// The corner of \f$T_1\f$ follows from the integer coordinates and is exact. The place in the corner
/// comes from the strip of triangles of \f$T_1\f$ that `h` passes, so that the flips that led to
/// \f$T_2\f$ leave no trace in it. A shared edge has the angle of its twin, to the bit.
/// Complexity: that of `trace_intrinsic_edge()`, and linear in the degree of the source in \f$T_1\f$.
/// For many halfedges use `Angular_coordinates`.
/// \throws Numerical_error if the angles at the source have no positive finite sum, or if the layout
///         has no positive finite length
template <typename Traits>
typename Traits::FT angle_on_input(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const internal::Vertex_angles<FT> angles(tri.input_spoke_before(h), tri.input_mesh(),
                                           tri.input_length_map());
  if(tri.coordinates().is_shared(tri.mesh().edge(h)))
    return angles.normalized(FT(0));
  const std::vector<Halfedge_index> exits = internal::input_exits(h, tri);
  Euclidean_strip<FT> strip;
  return angles.normalized(internal::angle_in_strip(
    h, [&](std::size_t m) { return exits[m]; }, exits.size(), tri, strip));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// takes a tangent vector at the vertex `v` from the frame of one triangulation to that of the other
/// (see `Tangent_frames`).
///
/// Both are frames of one tangent space: the vectors differ by a rotation. On the boundary they are
/// equal.
/// \param side the triangulation in whose frame `vector` is
/// \param v a vertex, not isolated
/// \param vector the vector
/// \param tri both triangulations
/// Complexity: that of `angle_on_input()` for one halfedge.
/// \throws Numerical_error as `angle_on_input()`
template <typename Traits>
std::complex<typename Traits::FT>
tangent_vector_across(Side side, Vertex_index v, const std::complex<typename Traits::FT>& vector,
                      const Intrinsic_triangulation<Traits>& tri)
{
  CGAL_precondition(!tri.mesh().is_isolated(v));
  return internal::turned_across(side, vector, angle_on_input(first_spoke(v, tri.mesh()), tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same for many vectors. Complexity: constant.
template <typename Traits>
std::complex<typename Traits::FT>
tangent_vector_across(Side side, Vertex_index v, const std::complex<typename Traits::FT>& vector,
                      const Angular_coordinates<Traits>& angles)
{
  const Delta_complex& mesh = angles.triangulation().mesh();
  CGAL_precondition(!mesh.is_isolated(v));
  return internal::turned_across(side, vector, angles.angle(first_spoke(v, mesh)));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTOR_ACROSS_H
