// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONJUGATE_GRADIENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the outcome of an iteration.
enum class Iteration_status
{
  converged,       ///< the error is below the tolerance
  iteration_limit, ///< the limit of iterations was reached
  no_progress      ///< the error does not decrease, by rounding or as a number is not finite
};

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns a short sentence for `status`.
inline const char* to_string(Iteration_status status)
{
  switch(status) {
    case Iteration_status::converged: return "converged";
    case Iteration_status::iteration_limit:
      return "not converged after as many iterations as are allowed";
    case Iteration_status::no_progress: return "the error no longer decreases";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// a solution of linear equations with its estimated error.
template <typename FT>
struct Iterative_solution
{
  Eigen::Matrix<FT, Eigen::Dynamic, 1> solution; ///< the last iterate
  std::size_t iterations = 0;                    ///< the number of iterations
  /// the square root of the product of the residual and the preconditioned residual, relative to
  /// the right-hand side
  FT error = FT(0);
  Iteration_status status = Iteration_status::no_progress; ///< the outcome of the iteration
};

namespace internal {

// Iterates by conjugate gradients, and measures errors.
template <typename Equations, typename FT>
class Conjugate_gradients
{
public:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  Conjugate_gradients(const Equations& equations, const Vector& b, std::size_t limit)
    : m_equations(equations), m_right_side(b), m_limit(limit)
  {
    m_result.solution = Vector::Zero(b.size());
    m_scale = size(b, m_equations.preconditioned(b));
  }

  // Restarts with the true residual if this is larger than the updated residual.
  Iterative_solution<FT> run(const FT& tolerance)
  {
    FT last = (std::numeric_limits<FT>::max)();
    for(;;) {
      Vector r = m_right_side - m_equations.product(m_result.solution);
      Vector z = m_equations.preconditioned(r);
      m_result.error = m_scale == 0 ? FT(0) : FT(size(r, z) / m_scale);
      if(m_result.error <= tolerance)
        return with_status(Iteration_status::converged);
      if(m_result.iterations >= m_limit)
        return with_status(Iteration_status::iteration_limit);
      if(!(m_result.error < last / 2))
        return with_status(Iteration_status::no_progress);
      last = m_result.error;
      descend(r, z, m_scale * (std::max)(tolerance, FT(residual_rounding<FT>() * last)));
    }
  }

private:
  static FT size(const Vector& r, const Vector& z)
  {
    using std::sqrt;
    return sqrt(Digits<FT>::few((std::max)(FT(r.dot(z)), FT(0))));
  }

  const Iterative_solution<FT>& with_status(Iteration_status status)
  {
    m_result.status = status;
    return m_result;
  }

  // Iterates from a solution with the residual `r` and the preconditioned residual `z`.
  void descend(Vector& r, Vector& z, const FT& tolerance)
  {
    Vector p = z;
    for(FT rz = r.dot(z); rz > tolerance * tolerance && m_result.iterations < m_limit;) {
      const Vector ap = m_equations.product(p);
      const FT step = Digits<FT>::few(rz / p.dot(ap));
      m_result.solution += step * p;
      r -= step * ap;
      z = m_equations.preconditioned(r);
      const FT next = r.dot(z);
      p = z + Digits<FT>::few(next / rz) * p;
      rz = next;
      ++m_result.iterations;
    }
  }

  const Equations& m_equations;
  const Vector& m_right_side;
  std::size_t m_limit;
  FT m_scale;
  Iterative_solution<FT> m_result;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// solves linear equations \f$A x = b\f$ by the conjugate gradient method. The error of the result
/// is measured with the true residual. Complexity: a product and a preconditioning for each
/// iteration.
/// \param equations an object with a member function `product(x)`, which returns \f$A x\f$ for a
///   symmetric positive semidefinite matrix, and `preconditioned(r)` for a symmetric preconditioner
/// \param b the right-hand side, in the range of the matrix
/// \param tolerance the relative error at which to stop
/// \param maximum_number_of_iterations the greatest number of iterations
template <typename Equations, typename FT>
Iterative_solution<FT> solve_by_conjugate_gradients(const Equations& equations,
                                                    const Eigen::Matrix<FT, Eigen::Dynamic, 1>& b,
                                                    const FT& tolerance,
                                                    std::size_t maximum_number_of_iterations)
{
  return internal::Conjugate_gradients(equations, b, maximum_number_of_iterations).run(tolerance);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONJUGATE_GRADIENTS_H
