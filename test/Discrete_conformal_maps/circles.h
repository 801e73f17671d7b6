// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_CIRCLES_H
#define TEST_CIRCLES_H

#include "flat_maps.h"

#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace Test_circles {

using namespace Test_surfaces;
using Radii = std::vector<double>;

inline auto as_radii(const Radii& radii)
{
  return boost::make_function_property_map<Vertex_index>(
    [&radii](Vertex_index v) { return radii[v.idx()]; });
}

// Returns random parts of half the distance to the nearest vertex, so that no two circles meet. A
// third of the vertices have no circle.
inline Radii random_radii(Triangulation t, double part, unsigned int seed)
{
  IT::make_Delaunay(t);
  std::mt19937 random(seed);
  Radii result;
  for(Vertex_index v : t.mesh().vertices()) {
    double least = std::numeric_limits<double>::infinity();
    for_each_outgoing_halfedge(v, t.mesh(), [&](Halfedge_index h) {
      least = (std::min)(least, t.length(t.mesh().edge(h)));
    });
    const double factor = std::uniform_real_distribution<double>(0.2, 1)(random);
    result.push_back(random() % 3 == 0 || t.mesh().is_isolated(v) ? 0 : part * factor * least / 2);
  }
  return result;
}

// Returns the energy of a surface and its circles, all lengths multiplied by `scale`.
template <typename Energy>
Energy energy_of(Triangulation t, const Radii& radii, double scale = 1)
{
  typedef typename Energy::FT FT;
  IT::make_weighted_Delaunay(t, boost::make_function_property_map<Vertex_index>(
                                  [&](Vertex_index v) { return radii[v.idx()] * radii[v.idx()]; }));
  const auto tangent = boost::make_function_property_map<Edge_index>([&](Edge_index e) {
    return FT(FT(scale) * IT::tangent_length(FT(t.length(e)),
                                             FT(radii[t.mesh().vertex(e, 0).idx()]),
                                             FT(radii[t.mesh().vertex(e, 1).idx()])));
  });
  std::vector<FT> scaled;
  for(const double r : radii)
    scaled.push_back(FT(scale) * FT(r));
  const Eigen::VectorXd target = Eigen::VectorXd::Zero(Eigen::Index(radii.size()));
  return {t.mesh(), tangent, target, DCM::Flipping::to_Delaunay, scaled};
}

} // namespace Test_circles

#endif // TEST_CIRCLES_H
