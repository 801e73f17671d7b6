// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_VERTEX_VECTOR_HEAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_VERTEX_VECTOR_HEAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_flow.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes frames at the vertices like `Tangent_frames`, but angles on the boundary are angles of
// the surface. So no curvature is spread around a boundary vertex. A field that is parallel inside
// is parallel along the boundary.
template <typename Surface>
class Vertex_frames
{
public:
  typedef Length_of<Surface> FT;
  typedef std::complex<FT> Complex;

  explicit Vertex_frames(const Surface& surface)
    : m_surface(surface), m_angle(surface.mesh().num_halfedges()), m_scale(m_angle.size())
  {
    const Tangent_frames<FT> frames(surface);
    const Delta_complex& mesh = surface.mesh();
    for(Halfedge_index h : mesh.halfedges()) {
      const Vertex_index v = mesh.source(h);
      const bool is_boundary = mesh.is_border(mesh.halfedge(v));
      m_scale[h.idx()] = is_boundary ? FT(1) : frames.scale(v);
      m_angle[h.idx()] = is_boundary ? FT(frames.angle(h) / frames.scale(v)) : frames.angle(h);
    }
  }

  // Returns the parallel transport from the source of `h` to its target.
  Complex transport(Halfedge_index h) const
  {
    return -std::polar(FT(1), m_angle[opposite(h).idx()] - m_angle[h.idx()]);
  }

  // Returns the rotations that map vectors from the corners of a face to its frame, and keep the
  // directions of bisectors.
  std::array<Complex, 3> to_face(Face_index f) const
  {
    const auto h = sides(f, m_surface.mesh());
    const Flat_face<FT> face(h[0], m_surface);
    std::array<Complex, 3> result;
    for(std::size_t k = 0; k < 3; ++k) {
      const FT half = angle_at_source(h[k], m_surface) / 2;
      const FT bisector = m_angle[h[k].idx()] + m_scale[h[k].idx()] * half;
      result[k] = face.direction(k) * std::polar(FT(1), half - bisector);
    }
    return result;
  }

private:
  Surface m_surface;                // a view
  std::vector<FT> m_angle, m_scale; // of each halfedge, at its source
};

// Computes the heat flow of tangent vectors at vertices, from and to faces, for a time and for four
// times this time.
template <typename Surface>
class Vertex_vector_heat
{
public:
  typedef Length_of<Surface> FT;
  typedef std::complex<FT> Complex;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  // `factor` is the shorter time in squared mean edge lengths.
  Vertex_vector_heat(const Surface& surface, const Mesh_components& components, const FT& factor)
    : m_surface(surface),
      m_frames(surface),
      m_short(matrix(components, factor), "heat flow of vectors"),
      m_long(matrix(components, FT(4) * factor), m_short.order(), "heat flow of vectors")
  {}

  // Returns the elimination order of the vertices, which other matrices of the surface can use,
  // too.
  const Elimination_order& order() const { return m_short.order(); }

  // Returns the heat from the unit normals on the right of the segments of a curve, after the
  // shorter time and after the longer one. It is the mean on each face, with components as in
  // gradient_matrix(), times a common factor.
  std::array<Vector, 2> spread(const Surface_curve<FT>& curve) const
  {
    const Field sources = normalized(moments(curve));
    return {means_on_faces(m_short.solve(sources)), means_on_faces(m_long.solve(sources))};
  }

private:
  typedef Eigen::Matrix<Complex, Eigen::Dynamic, 1> Field;

  const Delta_complex& mesh() const { return m_surface.mesh(); }

  Eigen::SparseMatrix<Complex> matrix(const Mesh_components& components, const FT& factor) const
  {
    return plus_diagonal(connection_laplacian(mesh(), weights(components, factor), m_frames),
                         decay_rates(m_surface, factor, components));
  }

  // Returns cotan weights minus the entries of the mass matrix divided by the time. The mass matrix
  // is the mean of the consistent and the lumped one. On uniform meshes, its errors are then of
  // fourth order instead of second order. A face of area A adds A / 24 to off-diagonal entries. So
  // the flow depends less on the directions and sizes of edges. Negative weights are dropped.
  std::vector<FT> weights(const Mesh_components& components, const FT& factor) const
  {
    const std::vector<FT> time = time_steps(m_surface, factor, components);
    std::vector<FT> result = cotan_weights(m_surface);
    for(Face_index f : mesh().faces()) {
      const std::size_t component = components[mesh().source(mesh().halfedge(f)).idx()];
      const FT entry = Face_metric<FT>(f, m_surface).area() / (FT(24) * time[component]);
      for(Halfedge_index h : sides(f, mesh()))
        result[mesh().edge(h).idx()] -= entry;
    }
    for(FT& w : result)
      w = (std::max)(w, FT(0));
    return result;
  }

  Vector means_on_faces(const Field& heat) const
  {
    Vector result = Vector::Zero(2 * Eigen::Index(mesh().num_faces()));
    for(Face_index f : mesh().faces()) {
      const auto h = sides(f, mesh());
      const auto to_face = m_frames.to_face(f);
      Complex mean(0);
      for(std::size_t k = 0; k < 3; ++k)
        mean += heat[mesh().source(h[k]).idx()] / FT(3) * to_face[k];
      result[2 * Eigen::Index(f.idx())] = mean.real();
      result[2 * Eigen::Index(f.idx()) + 1] = mean.imag();
    }
    return result;
  }

  // Returns the integrals of the normals of a curve against hat functions. They are zero if they
  // cancel up to rounding.
  Field moments(const Surface_curve<FT>& curve) const
  {
    Field result = Field::Zero(Eigen::Index(mesh().num_vertices()));
    Vector total = Vector::Zero(result.size());
    for(const Curve_segment<FT>& segment : curve) {
      const auto h = sides(segment.face, mesh());
      const auto to_face = m_frames.to_face(segment.face);
      const Complex along = Flat_face<FT>(h[0], m_surface).between(segment.source, segment.target);
      for(std::size_t k = 0; k < 3; ++k) {
        const FT weight = (segment.source[k] + segment.target[k]) / 2;
        result[mesh().source(h[k]).idx()] +=
          weight * along * Complex(0, -1) * std::conj(to_face[k]);
        total[mesh().source(h[k]).idx()] += weight * norm_of(along);
      }
    }
    for(Eigen::Index v = 0; v < result.size(); ++v)
      if(std::abs(result[v]) <= rounding_unit<FT>() * total[v])
        result[v] = FT(0);
    return result;
  }

  static Field normalized(const Field& moments)
  {
    const FT greatest =
      moments.size() == 0 ? FT(0) : Digits<FT>::few(moments.cwiseAbs().maxCoeff());
    return greatest > 0 ? Field(moments / greatest * Heat_flow<FT>::unit()) : moments;
  }

  Surface m_surface; // a view
  Vertex_frames<Surface> m_frames;
  Factorization<Complex> m_short, m_long;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_VERTEX_VECTOR_HEAT_H
