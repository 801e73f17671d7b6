// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CIRCLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CIRCLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Exact_weighted_flipping.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the circles at the vertices of a surface, if it has any, for its double. `original` maps
// vertices of the double to vertices of the surface.
class Vertex_circles
{
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Triangulation;
  typedef std::vector<Vertex_index> Originals;

public:
  // Stores a radius for each vertex of the surface, or no circles if all are zero.
  // \throws Invalid_input if one is negative, infinite or NaN
  explicit Vertex_circles(std::vector<double> radii = {}) : m_radii(std::move(radii))
  {
    for(std::size_t v = 0; v < m_radii.size(); ++v)
      if(!(m_radii[v] >= 0 && std::isfinite(m_radii[v])))
        throw Intrinsic_triangulations::Invalid_input("the radius at vertex " + std::to_string(v) +
                                                      " is negative or not a finite number");
    if(std::all_of(m_radii.begin(), m_radii.end(), [](double r) { return r == 0; }))
      m_radii.clear();
  }

  bool exist() const { return !m_radii.empty(); }

  // Returns the radii at the vertices of the double, if they have circles.
  template <typename FT>
  std::vector<FT> radii(const Originals& original) const
  {
    std::vector<FT> result;
    if(exist())
      for(Vertex_index v : original)
        result.push_back(FT(m_radii[v.idx()]));
    return result;
  }

  // Returns the length of the tangent between the circles at the ends of `e`, from its length. It
  // is zero if they touch or overlap.
  template <typename FT>
  FT tangent_length(const FT& length, Edge_index e, const Triangulation& t,
                    const Originals& original) const
  {
    const auto [r, s] = radii_at(e, t, original);
    return Intrinsic_triangulations::tangent_length(length, FT(r), FT(s));
  }

  // Flips to the weighted Delaunay triangulation, with squared radii as weights, by exact
  // decisions if `is_exact`. Returns the number of flips.
  // \throws Invalid_input if circles at the ends of an edge meet, or hide a circle
  template <typename Visitor>
  std::size_t flip(Triangulation& t, const Originals& original, bool is_exact,
                   Visitor& visitor) const
  {
    check(t, original, [&t](Edge_index e) { return t.length(e); });
    const auto radius = boost::make_function_property_map<Vertex_index>(
      [&](Vertex_index v) { return m_radii[original[v.idx()].idx()]; });
    const auto result =
      is_exact ? Intrinsic_triangulations::internal::flip_exactly_with_circles(t, radius, visitor)
               : Intrinsic_triangulations::make_weighted_Delaunay(
                   t, Intrinsic_triangulations::internal::squared_radius_map(radius),
                   CGAL::parameters::visitor(std::ref(visitor)));
    if(!result.hidden_vertices.empty())
      throw Intrinsic_triangulations::Invalid_input(
        "the circle at vertex " +
        std::to_string(original[result.hidden_vertices.front().idx()].idx()) +
        " is hidden by circles that it meets");
    return result.flips;
  }

  // Checks that circles at the ends of each edge do not meet. Two circles of positive radius may
  // touch, up to `tolerance::overlap_of_circles`. Flips round lengths, which are `length(e)`,
  // several times, so a length for which they meet is computed again on the exact surface.
  // \throws Invalid_input if they do
  template <typename Length>
  void check(const Triangulation& t, const Originals& original, const Length& length) const
  {
    std::optional<Intrinsic_triangulations::Precise_lengths<Triangulation::Traits>> precise;
    for(Edge_index e : t.mesh().edges()) {
      const auto [r, s] = radii_at(e, t, original);
      if(!do_meet(r, s, length(e)))
        continue;
      if(!precise)
        precise.emplace(t);
      if(do_meet(r, s, (*precise)(t.mesh().halfedge(e)).high()))
        throw Intrinsic_triangulations::Invalid_input(meeting(e, t, original));
    }
  }

private:
  // Returns whether circles meet whose centers have the distance `length`, by more than an overlap
  // that counts as touching.
  static bool do_meet(double r, double s, double length)
  {
    const double rest = length - (r + s);
    return r > 0 && s > 0 ? rest < -tolerance::overlap_of_circles * length : !(rest > 0);
  }

  std::pair<double, double> radii_at(Edge_index e, const Triangulation& t,
                                     const Originals& original) const
  {
    return {m_radii[original[t.mesh().vertex(e, 0).idx()].idx()],
            m_radii[original[t.mesh().vertex(e, 1).idx()].idx()]};
  }

  static std::string meeting(Edge_index e, const Triangulation& t, const Originals& original)
  {
    const Vertex_index a = t.mesh().vertex(e, 0), b = t.mesh().vertex(e, 1), v = original[a.idx()],
                       w = original[b.idx()];
    if(v != w)
      return "the circles at vertices " + std::to_string(v.idx()) + " and " +
             std::to_string(w.idx()) + " meet";
    return "the circle at vertex " + std::to_string(v.idx()) +
           (a == b ? " meets itself" : " crosses the boundary");
  }

  std::vector<double> m_radii;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CIRCLES_H
