// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Lobachevsky_function.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/assemble_columns.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Angle_difference.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Sparse>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsEnergy
/// the convex energy whose minimum are the scale factors that give a surface prescribed angle
/// defects (Section 4.3.2).
///
/// Faces are Euclidean triangles with the scaled lengths, or hyperbolic triangles with sides
/// \f$x\f$ for scaled lengths \f$\sinh(x/2)\f$. Both have the same ideal Delaunay triangulation.
/// See `Hyperbolic_conformal_energy` for the latter: it is strictly convex, also along constants.
///
/// It is twice continuously differentiable on the whole space: whoever minimizes it sees nothing of
/// the flips behind it. In a fixed triangulation, with Euclidean faces, it is the energy of
/// Springborn, Schr&ouml;der and Pinkall (2008): where the scaled lengths of a face violate the
/// triangle inequality, its part of the energy is linear, as if its angles were 0, 0 and \f$\pi\f$.
/// This is convex, but has no second derivatives where faces become flat; a minimum with such faces
/// gives no metric, and there may be no minimum at all.
///
/// Scale factors are \f$u = u^0 + x\f$, with an origin \f$u^0\f$ in the precision of `FT` and
/// a variable \f$x\f$ in that of `double`. So a minimum can be approached to any precision by a
/// minimizer that knows only `double`, which moves the origin from time to time.
///
/// \tparam FT_ the floating point type in which gradients are computed
/// \tparam Triangle the geometry of faces
/// \cgalModels `ConvexEnergy`
template <typename FT_ = double, typename Triangle = internal::Flat_triangle<FT_>>
class Conformal_energy
{
public:
  /// the number type of lengths, angles and scale factors.
  typedef FT_ FT;
  /// a number for each vertex.
  typedef Eigen::VectorXd Vector;
  /// a symmetric matrix.
  typedef Eigen::SparseMatrix<double> Matrix;

  /// the energy of a surface.
  /// \param mesh the connectivity, without boundary; intrinsic Delaunay, unless it is fixed
  /// \param length a readable property map from the edges to positive lengths
  /// \param target_defect the angle defects \f$\Omega^*\f$ of the minimum, in radians, by the
  ///        numbers of vertices
  /// \param flipping whether the triangulation follows the scale factors
  template <typename EdgeLengthMap>
  Conformal_energy(const Delta_complex& mesh, const EdgeLengthMap& length,
                   const Vector& target_defect, Flipping flipping = Flipping::to_Delaunay)
    : m_surface(mesh, length, flipping),
      m_target_defect(target_defect),
      m_scale_factor(mesh.num_vertices(), FT(0)),
      m_origin(mesh.num_vertices(), FT(0)),
      m_corner(mesh.num_halfedges()),
      m_cotangent(mesh.num_halfedges())
  {
    evaluate(Vector::Zero(target_defect.size()));
  }

  /// the number of variables, one for each vertex.
  std::size_t size() const { return m_origin.size(); }

  /// moves to the point `x`; where a scaled length is too great or small for a number, the gradient
  /// is not a number. Complexity: linear in the vertices, edges and flips.
  void evaluate(const Vector& x)
  {
    for(std::size_t i = 0; i < m_origin.size(); ++i)
      m_scale_factor[i] = m_origin[i] + FT(x[static_cast<Eigen::Index>(i)]);
    m_has_Hessian = false;
    try {
      m_surface.scale(m_scale_factor);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      m_gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    measure_faces();
    sum_angles();
  }

  /// makes the present point the origin: the variable there is zero.
  void move_origin() { m_origin = m_scale_factor; }

  /// the scale factors, by the numbers of vertices.
  const std::vector<FT>& scale_factors() const { return m_scale_factor; }

  /// the surface in its ideal Delaunay triangulation, or its fixed one.
  const Penner_surface<FT>& surface() const { return m_surface; }

  /// the angle at the source of `h` in its face, in the scaled metric.
  FT angle(Halfedge_index h) const { return m_corner[h.idx()].angle(); }

  /// the number of faces whose scaled lengths do not obey the triangle inequality strictly. In a
  /// triangulation that is Delaunay only rounding makes them.
  std::size_t number_of_flat_faces() const { return m_flat_faces; }

  /// the energy: Equation 4.12, with the volume of Leibon (2002) for hyperbolic faces. Complexity:
  /// linear.
  FT value() const;

  /// the derivatives of the energy: the angle defects minus their targets (Equation 4.13).
  const Vector& gradient() const { return m_gradient; }

  /// a bound for the rounding errors in the gradient.
  double gradient_error() const { return m_gradient_error; }

  /// the second derivatives: the cotan Laplacian (Section 4.3.2), and for hyperbolic faces what
  /// Bobenko, Pinkall and Springborn (2015) have in Section 6. Complexity: linear at the first call
  /// after `evaluate()`.
  const Matrix& Hessian() const
  {
    if(!m_has_Hessian)
      internal::assemble_columns(
        mesh(), [this](Vertex_index v, auto& entries) { collect_column(v, entries); }, m_Hessian);
    m_has_Hessian = true;
    return m_Hessian;
  }

private:
  const Delta_complex& mesh() const { return m_surface.mesh(); }

  std::array<FT, 3> side_lengths(const std::array<Halfedge_index, 3>& side) const
  {
    return {m_surface.scaled_length(mesh().edge(side[0])),
            m_surface.scaled_length(mesh().edge(side[1])),
            m_surface.scaled_length(mesh().edge(side[2]))};
  }

  Triangle triangle(const std::array<Halfedge_index, 3>& side) const
  {
    return Triangle(side_lengths(side));
  }

  void measure_faces()
  {
    m_error.assign(m_origin.size(), 0.);
    m_flat_faces = 0;
    for(Face_index f : mesh().faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh());
      const Triangle face = triangle(side);
      m_flat_faces += face.is_flat();
      const bool is_linear = m_surface.flipping() == Flipping::none && face.is_flat();
      for(std::size_t s = 0; s < 3; ++s) {
        m_corner[side[s].idx()] = face.corner(s);
        m_cotangent[side[s].idx()] =
          is_linear ? 0 : static_cast<double>(face.cotangent((s + 2) % 3));
        m_error[mesh().source(side[s]).idx()] +=
          is_linear ? 0 : static_cast<double>(face.angle_error());
      }
    }
  }

  void sum_angles()
  {
    m_gradient.resize(m_target_defect.size());
    m_gradient_error = 0;
    std::vector<internal::Angle_difference<FT>> defect(
      m_target_defect.data(), m_target_defect.data() + m_target_defect.size());
    for(Halfedge_index h : mesh().halfedges())
      defect[mesh().source(h).idx()].subtract(m_corner[h.idx()]);
    for(Vertex_index v : mesh().vertices()) {
      m_gradient[static_cast<Eigen::Index>(v.idx())] =
        mesh().is_isolated(v) ? 0 : defect[v.idx()].value();
      m_gradient_error = (std::max)(m_gradient_error, m_error[v.idx()]);
    }
  }

  // half the sum of the cotangents opposite to the edge
  double weight(Halfedge_index h) const
  {
    return (m_cotangent[h.idx()] + m_cotangent[mesh().opposite(h).idx()]) / 2;
  }

  // The second derivative along x is the sum over all edges of
  //   weight ((x_i - x_j)^2 + tanh^2 (x_i + x_j)^2).
  void collect_column(Vertex_index v, internal::Column_entries& entries) const
  {
    if(mesh().is_isolated(v))
      return;
    double diagonal = 0;
    Intrinsic_triangulations::for_each_spoke(v, mesh(), [&](Halfedge_index h) {
      const Vertex_index w = mesh().target(h);
      const auto tanh2 =
        static_cast<double>(Triangle::squared_tanh(m_surface.scaled_length(mesh().edge(h))));
      if(w != v)
        entries.emplace_back(static_cast<int>(w.idx()), (tanh2 - 1) * weight(h));
      diagonal += (w == v ? 2 * tanh2 : 1 + tanh2) * weight(h);
    });
    entries.emplace_back(static_cast<int>(v.idx()), diagonal);
  }

  Penner_surface<FT> m_surface;
  Vector m_target_defect;
  std::vector<FT> m_scale_factor, m_origin;
  std::vector<internal::Corner<FT>> m_corner; // at the source of each halfedge
  std::vector<double> m_cotangent;            // of the angle opposite to each halfedge
  std::vector<double> m_error;                // of the sum of angles, for each vertex
  Vector m_gradient;
  double m_gradient_error = 0;
  std::size_t m_flat_faces = 0;
  mutable Matrix m_Hessian;
  mutable bool m_has_Hessian = false;
};

/// \ingroup PkgDiscreteConformalMapsEnergy
/// the energy for hyperbolic faces.
template <typename FT = double>
using Hyperbolic_conformal_energy = Conformal_energy<FT, internal::Hyperbolic_triangle<FT>>;

template <typename FT, typename Triangle>
FT Conformal_energy<FT, Triangle>::value() const
{
  using std::log;
  const FT pi = boost::math::constants::pi<FT>();
  FT sum(0);
  for(Vertex_index v : mesh().vertices())
    if(!mesh().is_isolated(v))
      sum += (2 * pi - FT(m_target_defect[static_cast<Eigen::Index>(v.idx())])) *
             m_scale_factor[v.idx()];
  for(Face_index f : mesh().faces()) {
    const auto side = Intrinsic_triangulations::sides(f, mesh());
    const Triangle face = triangle(side);
    for(std::size_t s = 0; s < 3; ++s) {
      const FT lambda = 2 * log(m_surface.scaled_length(mesh().edge(side[(s + 1) % 3])));
      sum += (face.circle_angle(s) - pi / 2) * lambda + Lobachevsky_function(face.angle(s)) +
             Lobachevsky_function(face.circle_angle(s));
    }
    sum += Lobachevsky_function(face.half_defect());
  }
  return sum;
}

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H
