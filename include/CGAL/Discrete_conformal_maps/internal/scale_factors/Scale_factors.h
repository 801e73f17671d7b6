// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Factorization_counts.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Difference_bounded_newton.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Precise_newton_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/reduce_gradient.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_values.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Symmetric_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/falls_without_end.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/shift_to_zero.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/exact_promises.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the scale factors of a doubled problem at the vertices of the surface itself. Faces have
// the geometry of `Triangle`.
template <template <typename> class Triangle>
class Scale_factors : public Scale_values
{
  typedef Doubled_problem::Triangulation Triangulation;
  template <typename FT>
  using Energy = Symmetric_energy<Conformal_energy<FT, Triangle<FT>>>;

public:
  // `start` contains initial scale factors. Its entries for prescribed scale factors are not read.
  Scale_factors(Doubled_problem& problem, const Vector& start) : Scale_values(problem, start) {}

  // Returns whether the scale factors were found with bounded differences of neighbors.
  bool has_bounded_differences() const { return !m_found.empty(); }
  // Returns the scale factors that were found with bounded differences, if any.
  const std::vector<Double_double>& found_with_bounds() const { return m_found; }

  // Begins with another search with bounded differences. It starts from scale factors found before,
  // if any.
  void resume(const std::vector<Double_double>& found) { m_found = m_resumed = found; }

  // Lets all searches do only a part of the work that is left.
  void limit_work() { m_end_of_work = m_problem.work().end_of_part(); }

  // Uses scale factors that need no search.
  void take(const std::vector<Decimal_115>& log_scale)
  {
    note_rounded(log_scale);
    m_precise = log_scale;
    m_result.status = Minimization_status::converged;
    m_status = Map_status::success;
    m_max_curvature_error = 0;
  }

  // Minimizes the energy. If `double` has too few digits for `tolerance`, two stages with more
  // digits follow. If rounding or limits prevent the tolerance of the minimizer, `tolerance`
  // suffices.
  void minimize(const Any_minimizer& minimizer, double tolerance, Any_visitor& visitor)
  {
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.is_fixed()[v])
        m_u[Eigen::Index(v)] = m_problem.scale_factor(v);
    const bool is_resumed = !m_resumed.empty();
    m_start = is_resumed ? std::exchange(m_resumed, {}) : precise_values<Double_double>();
    if(!has_bounded_differences() || !bounds_differences(visitor)) {
      if(is_resumed)
        m_start = precise_values<Double_double>();
      minimize_from_start(minimizer, tolerance, visitor);
    }
    m_start.clear();
    if(m_status == Map_status::not_converged && is_within(tolerance))
      m_status = Map_status::success;
  }

  // Continues, with more digits, to scale factors with which needles on the exact surface have a
  // layout. The triangulation of the problem may have been moved to `triangulation`.
  // \pre They have been found.
  void sharpen(const Triangulation& triangulation, Any_visitor& visitor)
  {
    if(!m_problem.has_needles())
      return;
    if(!has_115_digits())
      sharpen_in<Double_double>(triangulation, visitor);
    if(!can_be_laid_out(triangulation))
      sharpen_in<Decimal_115>(triangulation, visitor);
  }

  // Returns the errors of the scale factors, with more digits and with the lengths that the problem
  // has now.
  Scale_errors errors()
  {
    return m_is_wide ? errors_in<Wide_number<Double_double>>() : errors_in<Double_double>();
  }

  // Returns the scale factors as precisely as the rounding of `FT` allows. From now on, their
  // rounded values are used. The triangulation of the problem may have been moved to
  // `triangulation`.
  template <typename FT>
  std::vector<FT> refine(const Triangulation& triangulation, Any_visitor& visitor)
  {
    auto energy = energy_at_start<FT>(triangulation);
    const double left =
      reduce_gradient(energy, Free_variables(domain(), m_problem.size()), m_problem.is_fixed(),
                      m_problem.order(), tolerance::rounding_of_gradient<FT>(), visitor);
    approach(energy, left, visitor);
    note_values(energy);
    return energy.scale_factors();
  }

protected:
  Minimization_domain domain() const
  {
    return m_problem.domain(Triangle<double>::has_similar_ones);
  }

private:
  // Stores a search for scale factors, and whether it is needed after the searches before it.
  struct Search
  {
    bool (Scale_factors::*is_needed)(double tolerance) const;
    void (Scale_factors::*run)(const Any_minimizer&, double tolerance, Any_visitor&);
    bool starts_beyond_range = false, bends_boundaries = false;
  };

  void minimize_from_start(const Any_minimizer& minimizer, double& tolerance, Any_visitor& visitor)
  {
    // The searches are tried in this order.
    static constexpr Search searches[] = {
      {&Scale_factors::is_open, &Scale_factors::minimize_rounded},
      {&Scale_factors::needs_digits, &Scale_factors::minimize_in<Double_double>},
      {&Scale_factors::needs_most_digits, &Scale_factors::minimize_in<Decimal_115>},
      {&Scale_factors::may_be_bent, &Scale_factors::minimize_in<Double_double>, false, true},
      {&Scale_factors::needs_range, &Scale_factors::minimize_beyond_range, true},
      {&Scale_factors::may_be_bent, &Scale_factors::minimize_beyond_range, true, true}};
    m_is_wide = false;
    if(m_problem.bend() > 0)
      tolerance = tolerance::promised_angle;
    m_max_curvature_error = std::numeric_limits<double>::infinity();
    const bool is_in_range =
      !Triangle<double>::has_similar_ones || m_problem.has_precise_lengths() || !is_beyond_range();
    for(const Search& search : searches) {
      if((is_in_range || search.starts_beyond_range) && (this->*search.is_needed)(tolerance)) {
        if(search.bends_boundaries) {
          m_problem.bend_straight_boundaries();
          tolerance = tolerance::promised_angle;
        }
        (this->*search.run)(minimizer, tolerance, visitor);
      }
      if(is_within(tolerance) || (is_far_off(tolerance) && bounds_differences(visitor)))
        return;
    }
    if(is_lost(tolerance))
      bounds_differences(visitor);
  }

  // Minimizes in `double`, if it resolves the minimum. The result is measured with all digits.
  void minimize_rounded(const Any_minimizer& minimizer, double tolerance, Any_visitor& visitor)
  {
    auto energy = energy_at_start<double>(m_problem.triangulation());
    if(is_unknown(energy, tolerance))
      return;
    run(energy, minimizer, visitor);
    m_precise = std::vector<double>();
    if(!m_problem.has_precise_lengths())
      return;
    const auto precise = energy_at_start<Double_double>(m_problem.triangulation());
    note_values(precise);
    m_result.gradient_error = (std::max)(m_max_curvature_error, precise.gradient_error());
    store(precise.scale_factors());
  }

  // Returns whether rounding of long edges hides the angles of needles, at the start or during the
  // minimization. If so, the error of the gradient becomes infinite.
  template <typename FT>
  bool is_unknown(const Energy<FT>& energy, double tolerance)
  {
    if(!can_descend() || (std::max)(rounding_at_short_edges<FT>(m_problem.triangulation()),
                                    energy.gradient_error()) <= tolerance)
      return false;
    m_result.gradient_error = std::numeric_limits<double>::infinity();
    return true;
  }

  bool is_open(double) const { return true; }
  bool needs_range(double) const { return Triangle<double>::has_similar_ones && is_beyond_range(); }

  // Returns whether sides of straight boundaries may be too small for straight angles in extended
  // precision.
  bool may_be_bent(double) const
  {
    return Triangle<double>::has_similar_ones && std::isfinite(m_max_curvature_error) &&
           m_problem.flipping() == Flipping::to_Delaunay && m_problem.bend() == 0 &&
           !m_problem.has_precise_lengths() && m_status == Map_status::not_converged &&
           m_result.status != Minimization_status::unbounded &&
           m_result.status != Minimization_status::iteration_limit;
  }

  // Searches from the start, on the exact surface, with bounded differences of neighbors. Each
  // minimization makes at most one such search. Returns whether scale factors are found. If so, the
  // next minimization begins with this search. Otherwise only the numbers of steps have changed.
  bool bounds_differences(Any_visitor& visitor)
  {
    m_found.clear();
    if constexpr(Triangle<double>::has_similar_ones)
      if(!m_start.empty() && m_problem.work().left(m_end_of_work) > 0) {
        Doubled_problem problem = m_problem;
        const Scale_state before = state();
        const bool is_found = is_found_with_bounds(visitor);
        m_start.clear();
        if(is_found)
          m_found = precise_values<Double_double>();
        else {
          m_problem = std::move(problem);
          const Minimization_result last = m_result;
          state() = before;
          m_result.iterations = last.iterations;
          m_result.evaluations = last.evaluations;
          static_cast<Factorization_counts&>(m_result) = last;
        }
      }
    return has_bounded_differences();
  }
  bool is_found_with_bounds(Any_visitor& visitor)
  {
    typedef Wide_number<Double_double> FT;
    m_problem.straighten_boundaries();
    m_problem.make_precise();
    m_problem.complete();
    auto energy = symmetric_energy<FT, Triangle<FT>>(m_problem, m_problem.triangulation());
    energy.set_origin({m_start.begin(), m_start.end()});
    if(!reaches_minimum(energy, visitor))
      return false;
    store(energy.scale_factors());
    note_rounded(shift_to_zero(m_problem, std::get<std::vector<Double_double>>(m_precise)));
    return m_is_wide = true;
  }

  // Returns whether the minimum is reached, and false if an evaluation needs endless flips. If the
  // search ends shortly before, errors decide.
  template <typename FT>
  bool reaches_minimum(Energy<FT>& energy, Any_visitor& visitor)
  {
    try {
      energy.evaluate(Vector::Zero(m_u.size()));
      energy.limit_work(end_of_part());
      note_last(energy,
                Difference_bounded_newton<Energy<FT>>(energy, domain())
                  .run(tolerance::gradient, tolerance::steps_with_bounded_differences, visitor));
      if(m_status != Map_status::success && m_max_curvature_error <= tolerance::lost_curvature)
        descend(energy, tolerance::gradient, m_end_of_work, visitor);
    } catch(const Intrinsic_triangulations::Error&) {
      return false;
    }
    return m_status == Map_status::success ? m_max_curvature_error <= tolerance::promised_angle
                                           : is_within(tolerance::curvature);
  }

  template <typename FT>
  Scale_errors errors_in()
  {
    return scale_errors<Triangle<FT>::has_similar_ones>(
      energy_at_start<FT>(m_problem.triangulation()), domain());
  }

  // Continues from a gradient of this norm until only the rounding error of `FT` remains.
  template <typename FT>
  void approach(Energy<FT>& energy, double norm, Any_visitor& visitor) const
  {
    for(double before = 1; norm > tolerance::rounding_of_gradient<FT>() && norm < before / 10;) {
      energy.move_origin();
      Vector x = Vector::Zero(m_u.size());
      before = norm;
      // The minimization has used up the digits of x at this point.
      Energy_reference<Energy<FT>> any_energy(energy);
      const Any_minimizer minimizer = Newton_minimizer(tolerance::reduction * norm);
      norm = minimizer(any_energy, x, domain(), visitor).gradient_norm;
    }
  }

  template <typename FT>
  Energy<FT> energy_at_start(const Triangulation& triangulation) const
  {
    Energy<FT> result = symmetric_energy<FT, Triangle<FT>>(m_problem, triangulation);
    if constexpr(!std::is_same_v<FT, double>)
      if(m_problem.has_precise_lengths() && is_extended()) {
        result.set_origin(precise_values<FT>());
        result.evaluate(Vector::Zero(m_u.size()));
        return result;
      }
    result.evaluate(m_u);
    return result;
  }

  // Nothing changes unless errors become smaller. Lengths may be beyond the range of `FT`.
  template <typename FT>
  void sharpen_in(const Triangulation& triangulation, Any_visitor& visitor)
  {
    const Scale_state before = state();
    auto energy = energy_at_start<FT>(triangulation);
    note_values(energy);
    const double error = m_max_curvature_error;
    if(can_descend())
      descend(energy, tolerance::rounding_of_gradient<FT>(), end_of_part(), visitor);
    else
      approach(energy, error, visitor);
    note_values(energy);
    if(m_max_curvature_error <= error) {
      m_status = before.m_status; // the curvatures have been good enough before
      store(energy.scale_factors());
    } else
      state() = before;
  }

  // The minimizer moves by numbers in double, which lose fewer digits the closer the origin is.
  template <typename FT>
  void minimize_in(const Any_minimizer& minimizer, double tolerance, Any_visitor& visitor)
  {
    auto energy = energy_at_start<FT>(m_problem.triangulation());
    if(is_unknown(energy, tolerance))
      return;
    if(can_descend())
      return descend_from_start(energy, tolerance, visitor);
    double before = 0;
    do {
      before = (std::max)(m_max_curvature_error, m_result.gradient_error);
      run(energy, minimizer, visitor);
    } while(!is_within(tolerance) && !has_no_solution() &&
            (std::max)(m_max_curvature_error, m_result.gradient_error) < before / 2);
    store(energy.scale_factors());
  }

  void minimize_beyond_range(const Any_minimizer& minimizer, double tolerance, Any_visitor& visitor)
  {
    if constexpr(Triangle<double>::has_similar_ones) {
      m_is_wide = true;
      auto energy = energy_at_start<Wide_number<double>>(m_problem.triangulation());
      run(energy, minimizer, visitor);
      minimize_in<Wide_number<Double_double>>(minimizer, tolerance, visitor);
      if(const auto u =
           std::get_if<std::vector<Double_double>>(&m_precise)) // null if needles failed
        note_rounded(shift_to_zero(m_problem, *u));
    }
  }

  // If numbers have too few digits, intermediate flips reverse needles. Then the next search does
  // not start from the end of this search.
  template <typename FT>
  void descend_from_start(Energy<FT>& energy, double tolerance, Any_visitor& visitor)
  {
    const Vector start = m_u;
    descend(energy, tolerance::gradient, m_end_of_work, visitor);
    if(is_within(tolerance))
      store(energy.scale_factors());
    else if(!std::is_same_v<FT, Decimal_115>)
      m_u = start;
    m_result.gradient_error = (std::max)(m_max_curvature_error, m_result.gradient_error);
  }

  // Returns whether the exact surface has needles, and steps may have more digits than `double`.
  bool can_descend() const
  {
    return m_problem.has_needles() && m_problem.flipping() == Flipping::to_Delaunay &&
           (Triangle<double>::has_similar_ones || !m_problem.has_radii());
  }

  template <typename FT>
  void descend(Energy<FT>& energy, double gradient_tolerance, double end_of_work,
               Any_visitor& visitor)
  {
    energy.limit_work(end_of_work);
    Precise_newton_iteration<Energy<FT>> newton(energy, domain());
    note_last(energy, newton.run(gradient_tolerance, tolerance::steps_with_more_digits, visitor));
  }

  // Returns the end of the next of several searches.
  double end_of_part() const { return m_problem.work().end_of_part(m_end_of_work); }

  template <typename FT>
  void note_last(const Energy<FT>& energy, const Minimization_result& last)
  {
    m_result = last.after(m_result);
    m_has_layout = true;
    m_status = last.status == Minimization_status::converged ? Map_status::success
                                                             : Map_status::not_converged;
    note_values(energy);
  }

  template <typename FT>
  void run(Energy<FT>& energy, const Any_minimizer& minimizer, Any_visitor& visitor)
  {
    energy.limit_work(m_end_of_work);
    energy.move_origin();
    Vector x = Vector::Zero(m_u.size());
    Energy_reference<Energy<FT>> any_energy(energy);
    const Minimization_result last = minimizer(any_energy, x, domain(), visitor);
    m_result = last.after(m_result);
    m_has_layout =
      m_problem.flipping() == Flipping::to_Delaunay || energy.energy().number_of_flat_faces() == 0;
    m_status = status_after(x);
    note_values(energy);
  }

  // Returns the status after a minimization in this direction.
  Map_status status_after(const Vector& direction) const
  {
    if(m_problem.flipping() == Flipping::none && falls_without_end(m_problem, direction))
      return Map_status::no_minimum;
    if(!m_has_layout)
      return Map_status::triangle_inequality;
    return m_result.status == Minimization_status::converged ? Map_status::success
                                                             : Map_status::not_converged;
  }

  double m_end_of_work = tolerance::work_for_map;
  std::vector<Double_double> m_start;   // empty if a search with bounded differences has used it
  std::vector<Double_double> m_found;   // with bounded differences
  std::vector<Double_double> m_resumed; // scale factors of a problem before, until they are used
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_FACTORS_H
