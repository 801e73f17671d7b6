// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_FRAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_FRAMES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>

#include <CGAL/number_utils.h>

#include <complex>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template <typename FT>
class Tufted_surface;

/// \ingroup PkgIntrinsicTriangulationsOperators
/// a frame of the tangent space at every vertex of a triangulated surface (Section 2.3.2).
///
/// A tangent vector at a vertex is a complex number. Its argument is a normalized angle: the angle
/// on the surface, counterclockwise from `first_outgoing_halfedge()`, times a scale. A full turn
/// is \f$2\pi\f$; the angle from one border edge to the other is \f$\pi\f$. At a vertex with
/// another angle sum, the real and imaginary part are no coordinates in an orthonormal frame of the
/// tangent plane (\ref it_tangent). Corners of a flat square are such vertices.
///
/// The object does not refer to the mesh, and is valid as long as connectivity and lengths do not
/// change. Memory: a number for each vertex and halfedge.
///
/// \tparam FT_ a floating point type
template <typename FT_ = double>
class Tangent_frames
{
public:
  /// the type of angles.
  typedef FT_ FT;

  /// computes the frames of a surface. Complexity: linear.
  /// \param surface a model of `IntrinsicSurface`; isolated vertices have a frame without edges
  /// \throws Numerical_error if the angles at a vertex are all zero or one of them is not finite
  template <typename Surface>
  explicit Tangent_frames(const Surface& surface)
    : m_angle_sum(surface.mesh().num_vertices(), FT(0)),
      m_is_border(surface.mesh().num_vertices(), 0),
      m_angle(surface.mesh().num_halfedges(), FT(0))
  {
    for(Vertex_index v : surface.mesh().vertices())
      if(!surface.mesh().is_isolated(v))
        set_frame(v, surface);
  }

  /// is deleted: a vertex of a soup has no tangent space; vertices of its tufted cover have one.
  template <typename F>
  explicit Tangent_frames(const Tufted_surface<F>& surface) = delete;

  /// returns the normalized angle \f$\varphi\f$ of the direction in which `h` leaves its source:
  /// between 0 and \f$2\pi\f$, and exactly \f$\pi\f$ for a border halfedge.
  const FT& angle(Halfedge_index h) const { return m_angle[h.idx()]; }

  /// returns the sum \f$\Theta\f$ of the angles of the surface at `v`; zero if `v` is isolated.
  const FT& angle_sum(Vertex_index v) const { return m_angle_sum[v.idx()]; }

  /// returns \f$2\pi\f$ minus the angle sum, or \f$\pi\f$ minus the angle sum on the boundary. This
  /// is the Gaussian curvature of `v`, or the geodesic curvature of the boundary at `v`. The sum
  /// over a surface without isolated vertices is \f$2\pi\f$ times its Euler characteristic.
  FT angle_defect(Vertex_index v) const { return normalized_sum(v) - angle_sum(v); }

  /// returns the factor that makes angles of the surface at `v` normalized angles:
  /// \f$2\pi/\Theta\f$, or \f$\pi/\Theta\f$ on the boundary. \pre `v` is not isolated
  FT scale(Vertex_index v) const { return normalized_sum(v) / angle_sum(v); }

  /// returns the parallel transport
  /// \f$R_{ij} = e^{\mathbf{i}((\varphi_{ji} + \pi) - \varphi_{ij})}\f$ from the source of `h` to
  /// its target: a tangent vector is multiplied with it.
  std::complex<FT> transport(Halfedge_index h) const
  {
    const Halfedge_index o = opposite(h);
    return -std::polar(FT(1), angle(o) - angle(h));
  }

private:
  FT normalized_sum(Vertex_index v) const { return m_is_border[v.idx()] ? pi<FT>() : 2 * pi<FT>(); }

  // Computes the angles on the surface first, then normalizes them.
  template <typename Surface>
  void set_frame(Vertex_index v, const Surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    m_is_border[v.idx()] = mesh.is_border(mesh.halfedge(v)) ? 1 : 0;
    FT sum(0);
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      m_angle[h.idx()] = sum;
      if(!mesh.is_border(h))
        sum += internal::angle_at_source(h, surface);
    });
    m_angle_sum[v.idx()] = sum;
    normalize(v, mesh);
  }

  void normalize(Vertex_index v, const Delta_complex& mesh)
  {
    const FT& sum = angle_sum(v);
    if(!(sum > 0) || !CGAL::is_finite(sum))
      throw Numerical_error("the angles at vertex " + std::to_string(v.idx()) +
                            " have no positive finite sum");
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      FT& angle = m_angle[h.idx()];
      angle = normalized_sum(v) * (angle / sum);
    });
  }

  std::vector<FT> m_angle_sum;
  std::vector<char> m_is_border;
  std::vector<FT> m_angle; // of each halfedge, at its source
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_FRAMES_H
