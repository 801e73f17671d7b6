// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/Doubled_problem.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// takes over where double has too few digits
typedef boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>
  Extended;

// The scale factors of a doubled problem, with faces of the geometry of `Triangle`.
template <template <typename> class Triangle>
class Scale_factors
{
  typedef Eigen::VectorXd Vector;
  typedef Doubled_problem::Triangulation Triangulation;

public:
  // `start` has scale factors to begin with; those that are prescribed do not count
  Scale_factors(const Doubled_problem& problem, const Vector& start)
    : m_problem(problem), m_u(start)
  {}

  // the scale factors: the sum of both, where double has too few digits for them
  const Vector& values() const { return m_u; }
  const std::vector<Extended>& extended_values() const { return m_extended; }
  bool is_extended() const { return !m_extended.empty(); }

  const Minimization_result& result() const { return m_result; }
  // of the vertices where curvatures are prescribed
  double max_curvature_error() const { return m_max_curvature_error; }

  // Minimizes the energy; if double has too few digits for `tolerance`, in extended precision.
  template <typename Minimizer, typename Visitor>
  void minimize(const Minimizer& minimizer, double tolerance, Visitor& visitor)
  {
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.is_fixed()[v])
        m_u[Eigen::Index(v)] = m_problem.scale_factor(v);
    run<double>(m_problem.triangulation(), minimizer, visitor);
    if(m_max_curvature_error > tolerance || m_result.gradient_error > tolerance)
      m_extended = run<Extended>(m_problem.triangulation(), minimizer, visitor);
  }

  // Goes on from the minimum in extended precision, to where its rounding ends. The triangulation of the problem
  // may have been moved to `triangulation`.
  template <typename Visitor>
  void refine(const Triangulation& triangulation, Visitor& visitor)
  {
    m_extended = run<Extended>(triangulation, Newton_minimizer(1e-30), visitor);
  }

private:
  template <typename FT, typename Minimizer, typename Visitor>
  std::vector<FT> run(const Triangulation& triangulation, const Minimizer& minimizer,
                      Visitor& visitor)
  {
    Conformal_energy<FT, Triangle<FT>> energy(triangulation.mesh(), triangulation.length_map(),
                                              m_problem.target_defect());
    energy.evaluate(m_u);
    energy.move_origin();
    Vector x = Vector::Zero(m_u.size());
    const Minimization_result last = minimizer(energy, x, domain(), visitor);
    const std::size_t iterations = m_result.iterations + last.iterations,
                      evaluations = m_result.evaluations + last.evaluations;
    m_result = last;
    m_result.iterations = iterations;
    m_result.evaluations = evaluations;
    m_u += x;
    m_max_curvature_error = 0;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(!m_problem.is_fixed()[v])
        m_max_curvature_error =
          (std::max)(m_max_curvature_error, std::abs(energy.gradient()[Eigen::Index(v)]));
    return energy.scale_factors();
  }

  Minimization_domain domain() const
  {
    Minimization_domain result{m_problem.is_fixed(), {}};
    if(Triangle<double>::has_similar_ones)
      for(std::size_t v = 0; v < m_problem.size(); ++v)
        result.component.push_back(m_problem.components()[v]);
    return result;
  }

  const Doubled_problem& m_problem;
  Vector m_u;
  std::vector<Extended> m_extended;
  Minimization_result m_result;
  double m_max_curvature_error = 0;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H
