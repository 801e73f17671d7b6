// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Wide_number.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores T_3 with its lengths in the plane, and the crossings of T_1. The boundary of the surface
// is the axis of the flat double, and its edges are straight lines on it.
class Flat_strips
{
  typedef Intrinsic_triangulations::Intrinsic_triangulation<
    Intrinsic_triangulations::Hyperideal_geometry_traits<>>
    Triangulation;

public:
  // `FT` has the range of the lengths. Lengths beyond the range of `double` are stored relative to
  // the longest length.
  template <typename FT>
  Flat_strips(Doubled_problem& problem, const std::vector<FT>& scale)
  {
    const Penner_surface<FT> surface = problem.scaled(scale);
    const FT unit = std::is_same<FT, double>::value ? FT(1) : greatest_length(surface);
    for(Edge_index e : surface.mesh().edges())
      m_length.push_back(static_cast<double>(surface.scaled_length(e) / unit));
    const auto& ab = problem.triangulation();
    m_triangulation = Triangulation(ab.input_mesh(), ab.mesh()); // crossings need no lengths
    for(Halfedge_index h : surface.flips())
      m_triangulation.flip(h);
  }

  // These members are needed by `lay_out_strip()`.
  const Delta_complex& mesh() const { return m_triangulation.mesh(); }
  const std::vector<double>& length_map() const { return m_length; }

  // Returns the length of the edge of `h`, a halfedge of T_1, as a straight line. It is zero if
  // squares of the lengths that it crosses are out of range.
  double length(Halfedge_index h) const
  {
    const auto trace = trace_input_edge(m_triangulation, h);
    if(trace.size() == 2)
      return m_length[Edge_index(trace.front().on_intrinsic.halfedge).idx()];
    std::vector<Halfedge_index> exits;
    for(std::size_t m = 1; m + 1 < trace.size(); ++m) {
      exits.push_back(trace[m].on_intrinsic.halfedge);
      if(m_length[Edge_index(exits.back()).idx()] < 1 / tolerance::greatest_position)
        return 0;
    }
    Intrinsic_triangulations::Euclidean_strip<double> strip;
    Intrinsic_triangulations::internal::lay_out_strip(strip, *this, exits);
    return strip.length();
  }

private:
  template <typename FT>
  static FT greatest_length(const Penner_surface<FT>& surface)
  {
    FT result(0);
    for(Edge_index e : surface.mesh().edges())
      result = (std::max)(result, surface.scaled_length(e));
    return result;
  }

  Triangulation m_triangulation;
  std::vector<double> m_length;
};

// Returns the lengths in the plane of the edges on the boundary of the surface, for these scale
// factors, and zero for other edges.
inline std::vector<double> flat_boundary_lengths(Doubled_problem& problem,
                                                 const Eigen::VectorXd& scale)
{
  const Flat_strips strips =
    scale.maxCoeff() - scale.minCoeff() > tolerance::narrow_log_scales
      ? Flat_strips(problem, std::vector<Wide_number<double>>(scale.begin(), scale.end()))
      : Flat_strips(problem, std::vector<double>(scale.begin(), scale.end()));
  std::vector<double> result(problem.surface().num_edges(), 0);
  for(Edge_index e : problem.surface().edges())
    if(const Halfedge_index h = problem.surface().halfedge(e); problem.surface().is_border(e))
      result[e.idx()] = strips.length(h);
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H
