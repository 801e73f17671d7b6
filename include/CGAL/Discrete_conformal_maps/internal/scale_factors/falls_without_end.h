// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FALLS_WITHOUT_END_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FALLS_WITHOUT_END_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/number_type_config.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns whether the energy of a fixed triangulation falls along a direction without limit. Far
// along it, every face has the angle pi at its least entry. A convex energy that falls even there
// has no minimum.
inline bool falls_without_end(const Doubled_problem& problem, const Eigen::VectorXd& direction)
{
  const Delta_complex& mesh = problem.triangulation().mesh();
  const Eigen::VectorXd target = problem.target_defect();
  const double pi = CGAL_PI;
  double slope = 0, size = 0;
  const auto add = [&](double x) {
    slope += x;
    size += std::abs(x);
  };
  for(std::size_t v = 0; v < problem.size(); ++v)
    if(const auto i = Eigen::Index(v); !problem.is_fixed()[v])
      add(problem.part(v) * (2 * pi - target[i]) * direction[i]);
  for(Face_index f : mesh.faces()) {
    double least = std::numeric_limits<double>::infinity();
    for(Halfedge_index h : sides(f, mesh))
      least = (std::min)(least, direction[Eigen::Index(problem.original(mesh.source(h)).idx())]);
    add(-problem.part(f) * pi * least);
  }
  return slope < -tolerance::cancellation * size;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FALLS_WITHOUT_END_H
