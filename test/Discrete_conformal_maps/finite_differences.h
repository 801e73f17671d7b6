// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_FINITE_DIFFERENCES_H
#define TEST_FINITE_DIFFERENCES_H

#include "../Intrinsic_triangulations/matrices.h"

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>

#include <Eigen/Core>

// Returns the ideal polyhedron of a triangulation after many flips.
template <typename FT, typename Triangulation>
CGAL::Discrete_conformal_maps::internal::Ptolemy_surface<FT>
flipped_at_random(const Triangulation& t)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  CGAL::Discrete_conformal_maps::internal::Ptolemy_surface<FT> result(t.mesh(), t.length_map());
  CGAL::Random random(31);
  for(std::size_t i = 0; i < 3 * result.mesh().number_of_edges(); ++i) {
    const IT::Halfedge_index h(static_cast<IT::Delta_complex::size_type>(
      random.get_int(0, int(result.mesh().number_of_halfedges()))));
    if(IT::flip_status(h, result.mesh()) == IT::Operation_status::possible)
      result.flip(h);
  }
  return result;
}

// Returns the derivatives of `function()`, a range of precise numbers, by central differences from
// the origin of an energy. Each direction, a column, has a column.
template <typename Energy, typename Function>
Eigen::MatrixXd central_differences(Energy& energy, double step, const Eigen::MatrixXd& directions,
                                    const Function& function)
{
  Eigen::MatrixXd result;
  for(Eigen::Index i = 0; i < directions.cols(); ++i) {
    const Eigen::VectorXd x = step * directions.col(i);
    energy.evaluate(x);
    const auto after = function();
    energy.evaluate(-x);
    const auto before = function();
    result.conservativeResize(static_cast<Eigen::Index>(after.size()), directions.cols());
    for(std::size_t k = 0; k < after.size(); ++k)
      result(static_cast<Eigen::Index>(k), i) =
        static_cast<double>((after[k] - before[k]) / (2 * step));
  }
  return result;
}

// Returns the derivatives of `function()` with respect to each variable.
template <typename Energy, typename Function>
Eigen::MatrixXd central_differences(Energy& energy, double step, const Function& function)
{
  const auto n = static_cast<Eigen::Index>(energy.size());
  return central_differences(energy, step, Eigen::MatrixXd::Identity(n, n), function);
}

// Returns eight directions. An error of a gradient is seen in almost all directions.
inline Eigen::MatrixXd random_directions(Eigen::Index dimension)
{
  constexpr Eigen::Index number_of_directions = 8;
  const auto size = static_cast<std::size_t>(dimension * number_of_directions);
  return Test_surfaces::random_numbers(size, 1, 23).reshaped(dimension, number_of_directions);
}

#endif // TEST_FINITE_DIFFERENCES_H
