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
#include <limits>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// takes over where double has too few digits
typedef boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>
  Extended;

// takes over from that where lengths are added up to very long ways
typedef boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<384, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>
  More_extended;

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

  // The scale factors as precisely as the rounding of `FT` allows; their rounded values are the values from now
  // on. The triangulation of the problem may have been moved to `triangulation`.
  template <typename FT, typename Visitor>
  std::vector<FT> refine(const Triangulation& triangulation, Visitor& visitor)
  {
    const double limit = 1e4 * static_cast<double>(std::numeric_limits<FT>::epsilon());
    auto energy = energy_at_values<FT>(triangulation);
    for(double before = 1, norm = max_norm(energy.gradient());
        norm > limit && norm < before / 10;) {
      energy.move_origin();
      Vector x = Vector::Zero(m_u.size());
      before = norm;
      // the digits of x end there
      norm = Newton_minimizer(1e-12 * norm)(energy, x, domain(), visitor).gradient_norm;
    }
    note_error(energy);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      m_u[Eigen::Index(v)] = static_cast<double>(energy.scale_factors()[v]);
    return energy.scale_factors();
  }

private:
  template <typename FT>
  Conformal_energy<FT, Triangle<FT>> energy_at_values(const Triangulation& triangulation) const
  {
    Conformal_energy<FT, Triangle<FT>> energy(triangulation.mesh(), triangulation.length_map(),
                                              m_problem.target_defect());
    energy.evaluate(m_u);
    return energy;
  }

  template <typename Energy>
  void note_error(const Energy& energy)
  {
    m_max_curvature_error = 0;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(!m_problem.is_fixed()[v])
        m_max_curvature_error =
          (std::max)(m_max_curvature_error, std::abs(energy.gradient()[Eigen::Index(v)]));
  }

  template <typename FT, typename Minimizer, typename Visitor>
  std::vector<FT> run(const Triangulation& triangulation, const Minimizer& minimizer,
                      Visitor& visitor)
  {
    auto energy = energy_at_values<FT>(triangulation);
    energy.move_origin();
    Vector x = Vector::Zero(m_u.size());
    const Minimization_result last = minimizer(energy, x, domain(), visitor);
    const std::size_t iterations = m_result.iterations + last.iterations,
                      evaluations = m_result.evaluations + last.evaluations;
    m_result = last;
    m_result.iterations = iterations;
    m_result.evaluations = evaluations;
    m_u += x;
    note_error(energy);
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
