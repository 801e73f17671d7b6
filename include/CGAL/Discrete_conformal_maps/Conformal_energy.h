// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Lobachevsky_function.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Angle_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsEnergy
/// a convex energy. Its minimum is at the scale factors with the prescribed angle defects (Section
/// 4.3.2).
///
/// Faces are Euclidean triangles with the scaled lengths, or hyperbolic triangles with sides
/// \f$x\f$ for scaled lengths \f$\sinh(x/2)\f$. Both have the same ideal Delaunay triangulation.
/// `Hyperbolic_conformal_energy` has hyperbolic faces. It is strictly convex in all directions,
/// also if one number is added to all variables.
///
/// It is twice continuously differentiable on the whole space, so minimizers need not know the
/// flips. In a fixed triangulation, with Euclidean faces, it is the energy of \cgalCite{SSP08}. If
/// the scaled lengths of a face violate the triangle inequality, its part of the energy is linear.
/// A minimum with such faces defines no metric. A minimum need not exist.
///
/// With circles at the vertices, radii are multiplied by \f$e^u\f$, and the energy is the one of
/// \cgalCite{BL23}. Lengths are distances of centers. With Euclidean faces, the second derivatives
/// are the `Intrinsic_triangulations::weighted_laplacian()`. With hyperbolic faces, a circle with
/// the hyperbolic radius \f$R\f$ has \f$2 r e^u = \tanh R\f$. Its variable is not \f$u\f$, but
/// \f$w\f$ with \f$r e^w = \tanh(R/2)\f$, in which the energy is convex.
///
/// Scale factors are \f$u = u^0 + x\f$, with an origin \f$u^0\f$ in the precision of `FT` and a
/// variable \f$x\f$ in `double`. A minimizer in `double` that moves the origin can approach a
/// minimum to any precision.
///
/// \tparam FT_ the floating point type in which gradients are computed
/// \tparam Triangle the geometry of faces
/// \cgalModels `ConvexEnergy`
template <typename FT_ = double, typename Triangle = internal::Flat_triangle<FT_>>
class Conformal_energy
#ifndef DOXYGEN_RUNNING
  : public internal::Angle_energy<Conformal_energy<FT_, Triangle>, Penner_surface<FT_>, Triangle>
#endif
{
  typedef internal::Angle_energy<Conformal_energy, Penner_surface<FT_>, Triangle> Base;
  friend Base;

public:
  /// the floating point type of lengths, angles and scale factors.
  typedef FT_ FT;
  /// a number for each vertex.
  typedef Eigen::VectorXd Vector;

  /// returns the energy of a surface.
  /// \param complex the connectivity, without boundary; intrinsic Delaunay, unless it is fixed
  /// \param length a readable property map from the edges to positive lengths
  /// \param target_defect the angle defects \f$\Omega^*\f$ of the minimum, in radians, by the
  ///        indices of vertices: an `Eigen::VectorXd` or a vector of numbers
  /// \param flipping whether the triangulation follows the scale factors
  /// \param radii the radii of circles, if there are circles, see `Penner_surface`
  template <typename EdgeLengthMap, typename Angle_defects>
  Conformal_energy(const Delta_complex& complex, const EdgeLengthMap& length,
                   const Angle_defects& target_defect, Flipping flipping = Flipping::to_Delaunay,
                   std::vector<FT> radii = {})
    : Base(Penner_surface<FT>(complex, length, flipping, std::move(radii)),
           flipping == Flipping::none)
  {
    for(auto v = 0 * target_defect.size(); v < target_defect.size(); ++v) {
      m_target_defect.push_back(FT(target_defect[v]));
      m_without_faces.emplace_back(m_target_defect.back());
    }
    this->evaluate(Vector::Zero(Eigen::Index(m_target_defect.size())));
  }

#ifdef DOXYGEN_RUNNING
  /// returns the number of variables, one for each vertex.
  std::size_t size() const;

  /// sets whether several threads are used: `CGAL::Sequential_tag`, the default,
  /// `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`. Values do not depend on it,
  /// bitwise.
  template <typename ConcurrencyTag>
  void set_concurrency(const ConcurrencyTag& tag);

  /// moves to the point `x`. If a scaled length exceeds the range of its number type, the gradient
  /// is NaN. Complexity: linear in the vertices, edges and flips.
  void evaluate(const Vector& x);

  /// makes the current point the origin: its variable is zero.
  void move_origin();

  /// returns the scale factors, by the indices of vertices; for hyperbolic circles the variables.
  const std::vector<FT>& scale_factors() const;

  /// returns the surface in its ideal Delaunay triangulation, or in its fixed triangulation.
  const Penner_surface<FT>& surface() const;

  /// returns the angle at the source of `h` in its face, in the scaled metric.
  FT angle(Halfedge_index h) const;

  /// returns the derivatives of the energy: the angle defects minus their targets (Equation 4.13).
  const Vector& gradient() const;

  /// returns a bound for the rounding errors in the gradient.
  double gradient_error() const;

  /// returns the second derivatives: the cotan Laplacian (Section 4.3.2), and for hyperbolic faces
  /// the matrix of \cgalCite{BPS15}, Section 6. Complexity: linear at the first call after
  /// `evaluate()`.
  const Eigen::SparseMatrix<double>& Hessian() const;
#endif

  /// returns the number of faces whose scaled lengths do not satisfy the strict triangle
  /// inequality. In a Delaunay triangulation, only rounding causes such faces.
  std::size_t number_of_flat_faces() const { return Base::flat_faces(); }

  /// returns the energy: Equation 4.12, with the volume of Leibon (2002) for hyperbolic faces.
  /// Complexity: linear. \pre there are no circles: with circles, only the derivatives are known
  FT value() const;

#ifndef DOXYGEN_RUNNING
  // Returns the derivative by one variable, after some have been moved.
  double derivative(Vertex_index v) const
  {
    internal::Angle_difference<FT> defect = m_without_faces[v.idx()];
    for_each_outgoing_halfedge(v, mesh(), [&](Halfedge_index h) {
      const auto corner = Base::triangle({h, mesh().next(h), mesh().prev(h)}).corner(0);
      defect.subtract(corner, internal::Angle_difference<FT>::rounded_angle(corner));
    });
    return defect.value();
  }

  // Returns the value with weights of the terms of vertices and faces.
  template <typename Vertex_weight, typename Face_weight>
  FT weighted_value(const Vertex_weight& vertex_weight, const Face_weight& face_weight) const;
#endif

private:
  using Base::mesh;

  template <typename Index>
  static bool is_remaining(Index)
  {
    return true;
  }

  void sum_angles()
  {
    std::vector<internal::Angle_difference<FT>> defect = m_without_faces;
    for(Halfedge_index h : mesh().halfedges())
      defect[mesh().source(h).idx()].subtract(Base::corner(h), Base::rounded_angle(h));
    for(Vertex_index v : mesh().vertices())
      Base::set_gradient(v, defect[v.idx()].value());
  }

  std::vector<FT> m_target_defect;
  std::vector<internal::Angle_difference<FT>> m_without_faces; // defects minus their targets
};

/// \ingroup PkgDiscreteConformalMapsEnergy
/// the energy for hyperbolic faces.
template <typename FT = double>
using Hyperbolic_conformal_energy = Conformal_energy<FT, internal::Hyperbolic_triangle<FT>>;

template <typename FT, typename Triangle>
FT Conformal_energy<FT, Triangle>::value() const
{
  return weighted_value([](Vertex_index) { return 1.; }, [](Face_index) { return 1.; });
}

#ifndef DOXYGEN_RUNNING
template <typename FT, typename Triangle>
template <typename Vertex_weight, typename Face_weight>
FT Conformal_energy<FT, Triangle>::weighted_value(const Vertex_weight& vertex_weight,
                                                  const Face_weight& face_weight) const
{
  using std::log;
  CGAL_precondition(!this->surface().has_radii());
  const FT pi = Intrinsic_triangulations::pi<FT>();
  FT sum(0);
  for(Vertex_index v : mesh().vertices())
    if(!mesh().is_isolated(v))
      sum +=
        FT(vertex_weight(v)) * (2 * pi - m_target_defect[v.idx()]) * this->scale_factors()[v.idx()];
  for(Face_index f : mesh().faces()) {
    const auto side = sides(f, mesh());
    const Triangle face = Base::triangle(side);
    FT part = Lobachevsky_function(face.half_defect());
    for(std::size_t s = 0; s < 3; ++s) {
      const FT lambda = 2 * log(this->surface().scaled_length(mesh().edge(side[(s + 1) % 3])));
      part += (face.circle_angle(s) - pi / 2) * lambda + Lobachevsky_function(face.angle(s)) +
              Lobachevsky_function(face.circle_angle(s));
    }
    sum += FT(face_weight(f)) * part;
  }
  return sum;
}
#endif

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CONFORMAL_ENERGY_H
