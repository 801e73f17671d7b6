// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RADII_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RADII_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the distances of an apex from the vertices of a surface. Their squares are stored as a
// mean and differences from it. If the apex is far away, distances have no digits for their
// differences.
class Radii
{
public:
  typedef Eigen::VectorXd Vector;

  Radii() = default;
  Radii(std::size_t n, double radius) : m_mean(radius * radius), m_weight(n, 0.) {}
  explicit Radii(const std::vector<Double_double>& squares) : m_weight(squares) { normalize(); }

  // Returns the square of radius `i` minus the mean of all squares.
  const Double_double& weight(std::size_t i) const { return m_weight[i]; }
  Double_double radius(std::size_t i) const { return sqrt(m_mean + m_weight[i]); }

  bool are_positive() const
  {
    for(const Double_double& w : m_weight)
      if(!(m_mean + w > 0) || !std::isfinite(w.high()))
        return false;
    return std::isfinite(m_mean.high());
  }

  // Returns the radii multiplied by exp(x). The factors have relative errors of type `double`, but
  // the products do not.
  Radii scaled(const Vector& x) const
  {
    const double mean = x.mean();
    Radii result;
    result.m_mean = m_mean + m_mean * std::expm1(2 * mean);
    for(std::size_t i = 0; i < m_weight.size(); ++i) {
      const double change = x[static_cast<Eigen::Index>(i)];
      result.m_weight.push_back(result.m_mean * std::expm1(2 * (change - mean)) + m_weight[i] +
                                m_weight[i] * std::expm1(2 * change));
    }
    result.normalize();
    return result;
  }

  // Returns a weighted mean of the squares. If they are large, the logarithms of their means and
  // the differences of radii are averaged.
  static Radii mean_of(const std::vector<const Radii*>& radii, const std::vector<double>& factors,
                       bool are_large)
  {
    Radii result(radii.front()->m_weight.size(), 0);
    double logarithm = 0;
    for(std::size_t k = 0; k < radii.size(); ++k) {
      const double mean = radii[k]->m_mean.high();
      logarithm += factors[k] * std::log(mean);
      result.m_mean += factors[k] * radii[k]->m_mean;
      const double factor = are_large ? factors[k] / std::sqrt(mean) : factors[k];
      for(std::size_t i = 0; i < result.m_weight.size(); ++i)
        result.m_weight[i] += factor * radii[k]->m_weight[i];
    }
    if(are_large) {
      result.m_mean = std::exp(logarithm);
      for(Double_double& w : result.m_weight)
        w *= std::exp(logarithm / 2);
    }
    return result;
  }

private:
  void normalize()
  {
    Double_double sum = 0;
    for(const Double_double& w : m_weight)
      sum += w;
    sum /= static_cast<double>(m_weight.size());
    for(Double_double& w : m_weight)
      w -= sum;
    m_mean += sum;
  }

  Double_double m_mean = 0;
  std::vector<Double_double> m_weight;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RADII_H
