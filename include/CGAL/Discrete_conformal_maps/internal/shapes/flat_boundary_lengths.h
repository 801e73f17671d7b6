// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_values.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Wide_number.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores T_3 with its lengths in the plane, and the crossings of T_1. The boundary of the surface
// is the axis of the flat double, and its edges are straight lines on it. `FT` has the digits of
// lengths, and not necessarily their range.
template <typename FT>
class Flat_strips
{
  typedef Intrinsic_triangulations::Intrinsic_triangulation<
    Intrinsic_triangulations::Hyperideal_geometry_traits<>>
    Triangulation;

public:
  // `Wide` has the range of the lengths. Lengths beyond the range of `FT` are stored relative to
  // the longest length.
  template <typename Wide>
  Flat_strips(Doubled_problem& problem, const std::vector<Wide>& scale)
  {
    const Penner_surface<Wide> surface = problem.scaled(scale);
    const Wide unit = std::is_same<FT, Wide>::value ? Wide(1) : greatest_length(surface);
    for(Edge_index e : surface.mesh().edges())
      m_length.push_back(converted<FT>(Wide(surface.scaled_length(e) / unit)));
    const auto& ab = problem.triangulation();
    m_triangulation = Triangulation(ab.input_mesh(), ab.mesh()); // crossings need no lengths
    for(Halfedge_index h : surface.flips())
      m_triangulation.flip(h);
  }

  // These members are needed by `lay_out_strip()`.
  const Delta_complex& mesh() const { return m_triangulation.mesh(); }
  const std::vector<FT>& length_map() const { return m_length; }

  // Returns the length of the edge of `h`, a halfedge of T_1, as a straight line. It is zero if
  // squares of the lengths that it crosses are out of range.
  double length(Halfedge_index h) const
  {
    const auto trace = trace_input_edge(m_triangulation, h);
    if(trace.size() == 2)
      return static_cast<double>(m_length[Edge_index(trace.front().on_intrinsic.halfedge).idx()]);
    std::vector<Halfedge_index> exits;
    for(std::size_t m = 1; m + 1 < trace.size(); ++m) {
      exits.push_back(trace[m].on_intrinsic.halfedge);
      if(m_length[Edge_index(exits.back()).idx()] < 1 / tolerance::greatest_position)
        return 0;
    }
    Intrinsic_triangulations::Euclidean_strip<FT> strip;
    Intrinsic_triangulations::internal::lay_out_strip(strip, *this, exits);
    return static_cast<double>(strip.length());
  }

private:
  template <typename Wide>
  static Wide greatest_length(const Penner_surface<Wide>& surface)
  {
    Wide result(0);
    for(Edge_index e : surface.mesh().edges())
      result = (std::max)(result, surface.scaled_length(e));
    return result;
  }

  Triangulation m_triangulation;
  std::vector<FT> m_length;
};

// Returns the lengths in the plane of the edges on the boundary of the surface, for these scale
// factors, and zero for other edges.
template <typename FT>
std::vector<double> flat_boundary_lengths(Doubled_problem& problem, const std::vector<FT>& scale)
{
  const Flat_strips<FT> strips =
    are_far_apart(scale)
      ? Flat_strips<FT>(problem, std::vector<Wide_number<FT>>(scale.begin(), scale.end()))
      : Flat_strips<FT>(problem, scale);
  std::vector<double> result(problem.surface().num_edges(), 0);
  for(Edge_index e : problem.surface().edges())
    if(const Halfedge_index h = problem.surface().halfedge(e); problem.surface().is_border(e))
      result[e.idx()] = strips.length(h);
  return result;
}

// Computes lengths with the digits of the scale factors. Rounded lengths of needles would differ
// from the lengths for which angles have been measured.
inline std::vector<double> flat_boundary_lengths(Doubled_problem& problem,
                                                 const Scale_values& scale)
{
  return scale.is_extended() ? flat_boundary_lengths(problem, scale.precise_values<Double_double>())
                             : flat_boundary_lengths(problem, scale.precise_values<double>());
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FLAT_BOUNDARY_LENGTHS_H
