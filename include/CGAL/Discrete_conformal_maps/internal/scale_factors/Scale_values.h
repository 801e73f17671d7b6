// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Scale factors at the vertices of the surface of a doubled problem, with the digits that they
// have.
class Scale_values
{
public:
  typedef Eigen::VectorXd Vector;

  // the scale factors, rounded to `double`
  const Vector& values() const { return m_u; }
  // whether scale factors have more digits, because `double` has too few
  bool is_extended() const { return m_precise.index() > 0; }
  // whether `Extended` has too few digits
  bool is_more_extended() const { return m_precise.index() > 1; }
  // whether lengths with these scale factors may be beyond the range of `double`
  bool is_wide() const { return m_is_wide; }
  // Returns the scale factors as `Extended` or `More_extended`, with the digits that there are.
  template <typename FT>
  std::vector<FT> precise_values() const
  {
    std::vector<FT> result(m_u.begin(), m_u.end());
    std::visit(
      [&](const auto& u) {
        for(std::size_t v = 0; v < u.size(); ++v)
          if(!m_problem.is_fixed()[v])
            result[v] = converted<FT>(u[v]);
      },
      m_precise);
    return result;
  }

  void start_from(const std::vector<double>& log_scale)
  {
    m_u = Eigen::Map<const Vector>(log_scale.data(), m_u.size());
    m_precise = std::vector<double>();
  }

protected:
  Scale_values(Doubled_problem& problem, const Vector& start) : m_problem(problem), m_u(start) {}

  // If scale factors differ so much, intermediate lengths may be beyond the range of `double`.
  bool is_beyond_range() const
  {
    return m_problem.flipping() == Flipping::to_Delaunay && !is_more_extended() && m_u.size() > 0 &&
           m_u.maxCoeff() - m_u.minCoeff() > tolerance::narrow_log_scales;
  }

  template <typename FT>
  void note_rounded(const std::vector<FT>& u)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      m_u[Eigen::Index(v)] = static_cast<double>(u[v]);
  }

  // Keeps scale factors with the digits that they have.
  template <typename FT>
  void store(const std::vector<FT>& u)
  {
    typedef std::conditional_t<std::is_same_v<FT, More_extended>, FT, Extended> Precise;
    std::vector<Precise> result;
    for(const FT& x : u)
      result.push_back(converted<Precise>(x));
    m_precise = std::move(result);
  }

  Doubled_problem& m_problem;
  Vector m_u;
  std::variant<std::vector<double>, std::vector<Extended>, std::vector<More_extended>> m_precise;
  bool m_is_wide = false;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H
