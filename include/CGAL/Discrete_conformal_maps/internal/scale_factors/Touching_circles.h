// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_TOUCHING_CIRCLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_TOUCHING_CIRCLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Finds circles that touch in a way that no map preserves. In the plane and in the hyperbolic
// plane, a disk does not touch itself, and two disks touch at most once. So edges between touching
// circles must not bound a disk without cones. The boundary of such a disk would be a loop, or two
// edges with the same ends.
class Touching_circles
{
public:
  // The whole surface must be copied to find such a part.
  explicit Touching_circles(Doubled_problem& problem) : m_problem(problem)
  {
    if(problem.has_radii() && !curves().empty())
      problem.complete();
  }

  // \throws Invalid_input if a disk without cones is bounded by one or two such edges
  void check() const
  {
    if(!m_problem.has_radii())
      return;
    for(const Curve& curve : curves())
      if(is_disk(mesh().halfedge(curve.first), curve) ||
         is_disk(opposite(mesh().halfedge(curve.first)), curve))
        throw Intrinsic_triangulations::Invalid_input(message(curve));
  }

private:
  typedef std::pair<Edge_index, Edge_index> Curve; // a loop is stored twice
  typedef std::pair<Vertex_index, Vertex_index> Ends;

  const Delta_complex& mesh() const { return m_problem.triangulation().mesh(); }

  Ends ends(Edge_index e) const { return std::minmax(mesh().vertex(e, 0), mesh().vertex(e, 1)); }

  std::vector<Curve> curves() const
  {
    const auto tangent = m_problem.lengths<double>(m_problem.triangulation());
    std::map<Ends, std::vector<Edge_index>> touching;
    for(Edge_index e : mesh().edges())
      if(get(tangent, e) == 0)
        touching[ends(e)].push_back(e);
    std::vector<Curve> result;
    for(const auto& [ends, edges] : touching)
      for(std::size_t i = 0; i < edges.size(); ++i)
        if(ends.first == ends.second)
          result.emplace_back(edges[i], edges[i]);
        else
          for(std::size_t j = 0; j < i; ++j)
            result.emplace_back(edges[i], edges[j]);
    return result;
  }

  // Returns whether the part of the surface to the left of `start` that the curve bounds is a disk
  // without cones. An open disk has the Euler characteristic one.
  bool is_disk(Halfedge_index start, const Curve& curve) const
  {
    const std::vector<char> is_cone = m_problem.cones();
    const Ends corners = ends(curve.first);
    std::set<Face_index> faces{mesh().face(start)};
    std::set<Vertex_index> vertices;
    std::vector<Face_index> open(faces.begin(), faces.end());
    std::size_t sides_inside = 0;
    while(!open.empty()) {
      const Face_index f = open.back();
      open.pop_back();
      for(Halfedge_index h : sides(f, mesh())) {
        if(const Vertex_index v = mesh().source(h); v != corners.first && v != corners.second) {
          if(is_cone[v.idx()])
            return false;
          vertices.insert(v);
        }
        if(Edge_index(h) == curve.first || Edge_index(h) == curve.second)
          continue;
        ++sides_inside;
        if(const Face_index g = mesh().face(opposite(h)); faces.insert(g).second)
          open.push_back(g);
      }
    }
    return faces.count(mesh().face(opposite(start))) == 0 &&
           faces.size() + vertices.size() == sides_inside / 2 + 1;
  }

  std::string message(const Curve& curve) const
  {
    const auto [a, b] = ends(curve.first);
    const std::size_t v = m_problem.original(a).idx(), w = m_problem.original(b).idx();
    const std::string around = " around vertices without cones";
    if(v == w)
      return "the circle at vertex " + std::to_string(v) + " touches itself" + around;
    return "the circles at vertices " + std::to_string(v) + " and " + std::to_string(w) +
           " touch twice" + around;
  }

  Doubled_problem& m_problem;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_TOUCHING_CIRCLES_H
