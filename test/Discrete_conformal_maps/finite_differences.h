// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_FINITE_DIFFERENCES_H
#define TEST_FINITE_DIFFERENCES_H

#include <Eigen/Core>

#include <cstddef>

// The derivatives of `function()`, a range of precise numbers, by central differences from the
// origin of an energy: a column for each of its variables.
template <typename Energy, typename Function>
Eigen::MatrixXd central_differences(Energy& energy, double step, const Function& function)
{
  const auto n = static_cast<Eigen::Index>(energy.size());
  Eigen::MatrixXd result;
  for(Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd x = step * Eigen::VectorXd::Unit(n, i);
    energy.evaluate(x);
    const auto after = function();
    energy.evaluate(-x);
    const auto before = function();
    result.conservativeResize(static_cast<Eigen::Index>(after.size()), n);
    for(std::size_t k = 0; k < after.size(); ++k)
      result(static_cast<Eigen::Index>(k), i) =
        static_cast<double>((after[k] - before[k]) / (2 * step));
  }
  return result;
}

#endif // TEST_FINITE_DIFFERENCES_H
