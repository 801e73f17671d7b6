// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// is a convex function of many variables, twice continuously differentiable. It is moved to a
/// point and then queried. So it can change a state that belongs to the point, for example a
/// triangulation, and computes only requested values.
///
/// It may become linear far from the minimum. Along some directions it may be constant: see
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

  /// moves to the point `u`; later queries are about this point. `u` can be far from the minimum.
  /// Values that cannot be computed are infinite or NaN; then the minimizer makes a shorter step.
  /// An exception leaves the minimizer.
  void evaluate(const Eigen::VectorXd& u);

  /// returns the value. It may be costly: only `CGAL::Discrete_conformal_maps::Ceres_minimizer`
  /// queries it.
  double value() const;

  /// returns the gradient.
  const Eigen::VectorXd& gradient() const;

  /// returns the Hessian: positive semidefinite, both triangles with the same pattern, compressed.
  /// Its pattern may change from point to point; a fixed pattern saves time. Bounds of steps are
  /// best for matrices such as Laplacians: off-diagonal entries are not positive, and rows sum to
  /// zero or more.
  const Eigen::SparseMatrix<double>& Hessian() const;

  /// returns a bound of the rounding errors of the entries of the gradient (max norm). The error of
  /// `u` itself does not count.
  double gradient_error() const;
};
