// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// is a convex function of many variables, twice continuously differentiable. It is moved to a
/// point and then queried there, so that it can change a state that belongs to the
/// point (a triangulation, for example), and computes only what is requested.
///
/// It may become linear far away. Along some directions it may be constant: see
/// `CGAL::Discrete_conformal_maps::Minimization_domain`.
///
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Conformal_energy`
class ConvexEnergy
{
public:
  /// the number type: `double`.
  typedef double FT;

  /// returns the number of variables.
  std::size_t size() const;

  /// moves to the point `u`; what is asked for later belongs to this point. `u` can be far from the
  /// minimum. What cannot be computed there is infinite or not a number, to which the minimizer
  /// answers by a shorter step. An exception leaves the minimizer.
  void evaluate(const Eigen::VectorXd& u);

  /// returns the value. It may be costly: only `CGAL::Discrete_conformal_maps::Ceres_minimizer`
  /// asks for it.
  double value() const;

  /// returns the gradient.
  const Eigen::VectorXd& gradient() const;

  /// returns the Hessian: positive semidefinite, both triangles with the same pattern, compressed.
  /// Its pattern may change from point to point; a pattern that stays saves time. If the
  /// off-diagonal entries are not positive and the rows sum to zero or more, as in a Laplacian,
  /// steps are bounded best.
  const Eigen::SparseMatrix<double>& Hessian() const;

  /// returns a bound of the rounding errors of the entries of the gradient (max norm), for given
  /// `u`: the error of `u` itself does not count.
  double gradient_error() const;
};
