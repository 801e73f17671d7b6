// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_DEFECT_ERRORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_DEFECT_ERRORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the greatest differences between actual and prescribed curvatures and exterior angles, in
// radians.
struct Defect_errors
{
  double curvature = 0, exterior_angle = 0;

  double greatest() const { return greater_error(curvature, exterior_angle); }

  // Returns the first promises about any map. Without a layout, lengths can be too small to be
  // measured.
  std::vector<Map_promise> promises(bool is_laid_out,
                                    double bound = tolerance::promised_angle) const
  {
    return {{"layout", is_laid_out ? 0. : 1., 0, Map_status::not_laid_out},
            {"curvature", curvature, bound, Map_status::wrong_curvature},
            {"exterior_angle", exterior_angle, bound, Map_status::wrong_curvature}};
  }
};

// Measures the angles of `mesh`, which is T_3, with these lengths of edges. Compares their sums at
// the vertices of the surface with the conditions of the problem. Precondition: the problem still
// stores its surface.
template <typename Triangle, typename FT>
Defect_errors defect_errors(const Doubled_problem& problem, const Delta_complex& mesh,
                            const std::vector<FT>& length)
{
  const Eigen::VectorXd target = problem.target_defect();
  std::vector<Angle_difference<FT>> defect(target.data(), target.data() + target.size());
  for(Face_index f : mesh.faces()) {
    const auto side = sides(f, mesh);
    const auto of = [&](std::size_t s) { return length[Edge_index(side[s]).idx()]; };
    const Triangle face({of(0), of(1), of(2)});
    for(std::size_t s = 0; s < 3; ++s)
      if(const std::size_t v = mesh.source(side[s]).idx(); v < defect.size())
        defect[v].subtract(face.corner(s), Angle_difference<FT>::rounded_angle(face.corner(s)));
  }
  Defect_errors result;
  for(Vertex_index v : problem.surface().vertices()) {
    if(problem.is_fixed()[v.idx()])
      continue;
    // The double has twice the exterior angle.
    const bool is_outside = problem.is_on_boundary(v);
    double& error = is_outside ? result.exterior_angle : result.curvature;
    error = greater_error(error, problem.part(v.idx()) * std::abs(defect[v.idx()].value()));
  }
  return result;
}

// Returns the errors of a surface that has not been measured, because lengths are out of range.
inline Defect_errors unknown_defect_errors()
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {unknown, unknown};
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_DEFECT_ERRORS_H
