// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>

#include <Eigen/Core>

#include <functional>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a model of `ConvexMinimizer` whose type is known only at run time.
typedef std::function<Minimization_result(Abstract_energy&, Eigen::VectorXd&,
                                          const Minimization_domain&, Any_visitor&)>
  Any_minimizer;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_MINIMIZER_H
