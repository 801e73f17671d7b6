// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/angle_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/Input_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/angle_in_strip.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the directions of all halfedges of \f$T_2\f$ in frames that do not change when edges are flipped:
/// those of \f$T_1\f$.
///
/// The angular coordinate of a halfedge is its normalized angle at its source (Section 2.3.2), as
/// `angle_on_input()` gives it, also where vertices have been inserted. The object is a visitor that keeps
/// the angles up to date:
/// \code
/// Angular_coordinates<> angles(tri);
/// make_Delaunay(tri, CGAL::parameters::visitor(std::ref(angles)));
/// \endcode
/// A new halfedge goes between its two neighbors in the proportion of the two corners, so that the
/// errors of angles do not grow with the number of flips, but for the rounding of each.
///
/// The object refers to the triangulation. Memory: two numbers for each halfedge and one for each vertex.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits` with a floating point type `FT`
/// \cgalModels `FlipVisitor`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Angular_coordinates
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the type of angles.
  typedef typename Traits::FT FT;
  static_assert(std::is_floating_point<FT>::value, "directions are angles");

  /// computes the angles from the integer coordinates and the lengths of \f$T_1\f$.
  /// Complexity: linear in the vertices, edges and crossings.
  /// \throws Numerical_error if the angles at a vertex have no positive finite sum, or if the layout of
  ///         an edge has no positive finite length
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  explicit Angular_coordinates(const Triangulation& tri)
    : m_tri(tri), m_frames(Side::input, tri), m_angle(tri.mesh().num_halfedges())
  {
    const internal::Input_crossings crossings(tri.coordinates(), tri.mesh(), tri.spokes());
    Euclidean_strip<FT> strip;
    for(Halfedge_index h : tri.mesh().halfedges())
      m_angle[h.idx()] =
        angle_of_spoke_before(h) + scale_at(h) * angle_in_corner(h, crossings, strip);
  }

  Angular_coordinates(Triangulation&&) = delete; // it would refer to what is gone

  /// the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// the normalized angle \f$\varphi\f$ of the direction in which the halfedge `h` of \f$T_2\f$ leaves
  /// its source, in the frame of \f$T_1\f$: between 0 and \f$2\pi\f$, but for rounding.
  const FT& angle(Halfedge_index h) const { return m_angle[h.idx()]; }

  /// the parallel transport \f$R_{ij}\f$ along the halfedge `h` of \f$T_2\f$ between the frames of
  /// \f$T_1\f$ (see `Tangent_frames::transport()`).
  std::complex<FT> transport(Halfedge_index h) const
  {
    return -std::polar(FT(1), angle(m_tri.mesh().opposite(h)) - angle(h));
  }

  /// the frames of \f$T_1\f$.
  const Tangent_frames<FT>& frames() const { return m_frames; }

  /// computes the angles of the edge of `h`, which has just been flipped, from its two faces; those of
  /// \f$T_1\f$ if it is shared. Complexity: constant.
  void after_flip(Halfedge_index h)
  {
    const bool is_shared = m_tri.coordinates().is_shared(m_tri.mesh().edge(h));
    for(Halfedge_index x : {h, m_tri.mesh().opposite(h)})
      m_angle[x.idx()] = is_shared ? angle_of_spoke_before(x) : angle_between_neighbors(x);
  }

  /// computes the angles of the edges at the vertex `v`, which has just been inserted. When elements are
  /// renumbered (see `Intrinsic_triangulation::collect_garbage()`), the object must be made afresh.
  /// Complexity: that of `angle_on_input()`, and linear in the degree of `v`.
  void after_insertion(Vertex_index v)
  {
    m_angle.resize(m_tri.mesh().num_halfedges());
    const Halfedge_index first = first_spoke(v, m_tri.mesh());
    FT angle_at_v = angle_on_input(first, m_tri);
    internal::for_each_spoke(v, m_tri.mesh(), [&](Halfedge_index h) {
      const Halfedge_index back = m_tri.mesh().opposite(h);
      const bool is_shared = m_tri.coordinates().is_shared(m_tri.mesh().edge(h));
      m_angle[h.idx()] = is_shared ? angle_of_spoke_before(h) : angle_at_v;
      m_angle[back.idx()] = is_shared ? angle_of_spoke_before(back) : angle_between_neighbors(back);
      if(!m_tri.mesh().is_border(h))
        angle_at_v = std::fmod(m_angle[h.idx()] + corner(h), 2 * internal::pi<FT>());
    });
  }

private:
  // an inserted vertex is flat
  FT scale_at(Halfedge_index h) const
  {
    const Vertex_index v = m_tri.mesh().source(h);
    return m_tri.is_inserted(v) ? FT(1) : m_frames.scale(v);
  }

  FT angle_of_spoke_before(Halfedge_index h) const
  {
    return m_tri.is_inserted(m_tri.mesh().source(h)) ? internal::angle_of_inserted_spoke(h, m_tri)
                                                     : m_frames.angle(m_tri.input_spoke_before(h));
  }

  FT angle_in_corner(Halfedge_index h, const internal::Input_crossings& crossings,
                     Euclidean_strip<FT>& strip) const
  {
    const Edge_index e = m_tri.mesh().edge(h);
    const std::size_t n = crossings.count(e);
    if(m_tri.coordinates().is_shared(e))
      return FT(0);
    const bool is_first = h.idx() % 2 == 0;
    const auto exit = [&](std::size_t m) {
      return is_first ? m_tri.input_mesh().opposite(crossings(e, m)) : crossings(e, n - 1 - m);
    };
    return internal::angle_in_strip(h, exit, n, m_tri, strip);
  }

  FT corner(Halfedge_index h) const
  {
    return internal::angle_at_source(h, m_tri.mesh(), m_tri.length_map());
  }

  // What the corners on either side of `h` lack of the angle between its neighbors is shared out.
  FT angle_between_neighbors(Halfedge_index h) const
  {
    const Halfedge_index before = previous_spoke(h, m_tri.mesh());
    const FT scale = scale_at(h), turn = 2 * internal::pi<FT>();
    const FT right = scale * corner(before), both = right + scale * corner(h);
    const FT gap = angle(next_spoke(h, m_tri.mesh())) - angle(before);
    const FT lack = std::remainder(gap - both, turn);
    const FT result = angle(before) + right + (both > 0 ? lack * (right / both) : FT(0));
    return result < turn ? result : result - turn;
  }

  const Triangulation& m_tri;
  Tangent_frames<FT> m_frames;
  std::vector<FT> m_angle; // of each halfedge of T2, at its source
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H
