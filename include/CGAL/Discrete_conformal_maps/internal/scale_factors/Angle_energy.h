// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_ANGLE_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_ANGLE_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Implements the common part of the energies of scale factors, whose derivatives are angle defects.
// It stores a surface that is scaled, the angles of its faces, and the Hessian, a cotan Laplacian.
// `Derived` has the gradient, as `sum_angles()`. Its `is_remaining()` determines which edges and
// faces belong to the energy.
template <typename Derived, typename Surface, typename Triangle>
class Angle_energy
{
public:
  typedef typename Surface::FT FT;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  std::size_t size() const { return m_origin.size(); }

  template <typename ConcurrencyTag>
  void set_concurrency(const ConcurrencyTag& tag)
  {
    m_concurrency = Intrinsic_triangulations::Concurrency(tag);
  }

  // Evaluates the energy. If a scaled length is not a length, or if rounding prevents flips from
  // ending, the gradient is NaN.
  void evaluate(const Vector& x)
  {
    for(std::size_t i = 0; i < m_origin.size(); ++i)
      m_scale_factor[i] = m_origin[i] + FT(x[Eigen::Index(i)]);
    m_has_Hessian = false;
    try {
      scale();
    } catch(const Intrinsic_triangulations::Error&) {
      m_gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    measure_faces();
    add_errors();
    derived().sum_angles();
  }

  // Sets the point at which the variable is zero, by default the present point.
  void set_origin(const std::vector<FT>& origin) { m_origin = origin; }
  void move_origin() { m_origin = m_scale_factor; }

  const std::vector<FT>& scale_factors() const { return m_scale_factor; }
  const Surface& surface() const { return m_surface; }

  // Returns the scaled length of the edge of `h`, or with circles, the distance between their
  // centers.
  FT length(Halfedge_index h) const
  {
    if constexpr(has_circles)
      if(m_surface.has_radii())
        return Triangle::length(m_surface.scaled_decorated_length(h));
    return m_surface.scaled_length(Edge_index(h));
  }

  // Returns the angle at the source of `h`, in the scaled metric.
  // \pre the face of `h` remains
  FT angle(Halfedge_index h) const { return m_corner[h.idx()].angle(); }

  const Vector& gradient() const { return m_gradient; }
  double gradient_error() const { return m_gradient_error; }

  const Matrix& Hessian() const
  {
    if(!m_has_Hessian)
      Intrinsic_triangulations::assemble(
        m_concurrency, size(), size(),
        [this](std::size_t v, auto& entries) {
          this->collect_column(Vertex_index(static_cast<Delta_complex::size_type>(v)), entries);
        },
        m_Hessian);
    m_has_Hessian = true;
    return m_Hessian;
  }

  // Adds the coefficients of the second derivative in the column of `v` to a list; several can have
  // the same row. The second derivative along x is the sum over all remaining edges of
  // weight ((x_i - x_j)^2 + tanh^2 (x_i + x_j)^2).
  template <typename Entries>
  void collect_column(Vertex_index v, Entries& entries) const
  {
    collect_column(
      v, [v](Vertex_index w) { return w == v; }, entries);
  }

  // Adds the coefficients if all vertices for which `is_same()` holds share the variable of `v`.
  // Weights between these vertices do not count, however great they are.
  template <typename Is_same, typename Entries>
  void collect_column(Vertex_index v, const Is_same& is_same, Entries& entries) const
  {
    if(mesh().is_isolated(v))
      return;
    double diagonal = 0;
    for_each_outgoing_halfedge(v, mesh(), [&](Halfedge_index h) {
      if(!derived().is_remaining(Edge_index(h)))
        return;
      const Vertex_index w = mesh().target(h);
      const auto tanh2 = static_cast<double>(Triangle::squared_tanh(length(h)));
      if(!is_same(w))
        entries.emplace_back(static_cast<int>(w.idx()), (tanh2 - 1) * weight(h));
      diagonal += (is_same(w) ? 2 * tanh2 : 1 + tanh2) * weight(h);
    });
    entries.emplace_back(static_cast<int>(v.idx()), diagonal);
  }

  // Moves some variables, but only for `derivative()`. All other values are unchanged until
  // `evaluate()`.
  void move_some(const std::vector<Vertex_index>& vertices, const std::vector<FT>& u)
  {
    m_surface.scale_at(vertices, u);
  }

protected:
  // `is_fixed` must be true if faces may violate the triangle inequality.
  Angle_energy(Surface surface, bool is_fixed)
    : m_is_fixed(is_fixed),
      m_surface(std::move(surface)),
      m_scale_factor(mesh().num_vertices(), FT(0)),
      m_origin(mesh().num_vertices(), FT(0)),
      m_corner(mesh().num_halfedges(), Corner<FT>{FT(1), FT(0)}), // no angle beyond a border
      m_rounded_angle(mesh().num_halfedges()),
      m_cotangent(mesh().num_halfedges()),
      m_error(mesh().num_faces()),
      m_is_flat(mesh().num_faces()),
      m_gradient(Vector::Zero(Eigen::Index(mesh().num_vertices())))
  {}

  const Delta_complex& mesh() const { return m_surface.mesh(); }
  const Corner<FT>& corner(Halfedge_index h) const { return m_corner[h.idx()]; }
  double rounded_angle(Halfedge_index h) const { return m_rounded_angle[h.idx()]; }
  std::size_t flat_faces() const { return m_flat_faces; }

  void set_gradient(Vertex_index v, double defect)
  {
    m_gradient[Eigen::Index(v.idx())] = mesh().is_isolated(v) ? 0 : defect;
  }

  Triangle triangle(const std::array<Halfedge_index, 3>& side) const
  {
    if constexpr(has_circles)
      if(m_surface.has_radii()) {
        const auto edge = [&](std::size_t s) { return m_surface.scaled_decorated_length(side[s]); };
        return Triangle(edge(0), edge(1), edge(2));
      }
    const auto length = [&](std::size_t s) { return m_surface.scaled_length(Edge_index(side[s])); };
    return Triangle({length(0), length(1), length(2)});
  }

private:
  static constexpr bool has_circles = Intrinsic_triangulations::internal::Has_radii<Surface>::value;

  // Scales the surface. The variables of hyperbolic circles are not scale factors.
  void scale()
  {
    if constexpr(has_circles && !Triangle::has_similar_ones)
      if(m_surface.has_radii()) {
        std::vector<FT> u;
        for(Vertex_index v : mesh().vertices())
          u.push_back(Triangle::log_scale(m_scale_factor[v.idx()], m_surface.radius(v)));
        return m_surface.scale(u);
      }
    m_surface.scale(m_scale_factor);
  }

  Derived& derived() { return static_cast<Derived&>(*this); }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  void measure_faces()
  {
    Intrinsic_triangulations::for_each_in_chunks<Face_index>(m_concurrency, mesh(),
                                                             [this](Face_index f) {
                                                               const auto side = sides(f, mesh());
                                                               m_error[f.idx()] = 0;
                                                               m_is_flat[f.idx()] = 0;
                                                               if(derived().is_remaining(f))
                                                                 measure(f, side);
                                                               else
                                                                 for(Halfedge_index h : side)
                                                                   m_cotangent[h.idx()] = FT(0);
                                                             });
  }

  void measure(Face_index f, const std::array<Halfedge_index, 3>& side)
  {
    const Triangle face = triangle(side);
    m_is_flat[f.idx()] = face.is_flat();
    const bool is_linear = m_is_fixed && face.is_flat();
    m_error[f.idx()] = is_linear ? 0 : static_cast<double>(face.angle_error());
    for(std::size_t s = 0; s < 3; ++s) {
      m_corner[side[s].idx()] = face.corner(s);
      m_rounded_angle[side[s].idx()] = Angle_difference<FT>::rounded_angle(face.corner(s));
      m_cotangent[side[s].idx()] = is_linear ? FT(0) : face.cotangent((s + 2) % 3);
    }
  }

  // Adds the errors in the order of faces.
  void add_errors()
  {
    std::vector<double> error(size(), 0.);
    m_gradient_error = 0;
    m_flat_faces = 0;
    for(Face_index f : mesh().faces()) {
      m_flat_faces += m_is_flat[f.idx()] ? 1u : 0u;
      for(Halfedge_index h : sides(f, mesh()))
        error[mesh().source(h).idx()] += m_error[f.idx()];
    }
    for(Vertex_index v : mesh().vertices())
      m_gradient_error = (std::max)(m_gradient_error, error[v.idx()]);
  }

  // Returns half the sum of the cotangents opposite to the edge, which may cancel.
  double weight(Halfedge_index h) const
  {
    return static_cast<double>(FT((m_cotangent[h.idx()] + m_cotangent[opposite(h).idx()]) / 2));
  }

  bool m_is_fixed;
  Intrinsic_triangulations::Concurrency m_concurrency;
  Surface m_surface;
  std::vector<FT> m_scale_factor, m_origin;
  std::vector<Corner<FT>> m_corner; // at the source of each halfedge
  std::vector<double> m_rounded_angle;
  std::vector<FT> m_cotangent; // of the angle opposite to each halfedge
  std::vector<double> m_error; // of an angle of each face
  std::vector<char> m_is_flat;
  Vector m_gradient;
  double m_gradient_error = 0;
  std::size_t m_flat_faces = 0;
  mutable Matrix m_Hessian;
  mutable bool m_has_Hessian = false;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_ANGLE_ENERGY_H
