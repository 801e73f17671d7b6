// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_STRAIGHT_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_STRAIGHT_DISTANCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Bounds distances in space from sources, which are lower bounds for paths on the surface. Faces
// need not be flat in space, because only vertices have positions. A segment counts as a ball that
// contains it, around a corner of its face.
template <typename FT>
class Straight_distances
{
public:
  typedef std::array<FT, 3> Position;

  // Uses the positions `positions` of the vertices.
  template <typename Surface>
  Straight_distances(const Surface& surface, const Distance_sources<Surface>& sources,
                     const std::vector<Position>& positions)
  {
    for(const Vertex_index v : Access_to_sources::vertices(sources))
      m_balls.push_back({positions[v.idx()], FT(0)});
    for(const Curve_segment<FT>& segment : Access_to_sources::curve(sources))
      add(segment, surface, positions);
    std::sort(m_balls.begin(), m_balls.end(),
              [](const Ball& a, const Ball& b) { return a.center[0] < b.center[0]; });
    for(const Ball& ball : m_balls)
      m_greatest_radius = (std::max)(m_greatest_radius, ball.radius);
  }

  // Returns a bound for the distance of the nearest source. Complexity: linear in the sources,
  // usually less.
  FT operator()(const Position& p) const
  {
    FT least = std::numeric_limits<FT>::infinity();
    const auto is_far = [&](const Ball& ball) {
      return CGAL::abs(ball.center[0] - p[0]) - m_greatest_radius > least;
    };
    const auto start =
      std::lower_bound(m_balls.begin(), m_balls.end(), p[0],
                       [](const Ball& ball, const FT& x) { return ball.center[0] < x; });
    for(auto right = start; right != m_balls.end() && !is_far(*right); ++right)
      least = (std::min)(least, distance(*right, p));
    for(auto left = start; left != m_balls.begin() && !is_far(*(left - 1)); --left)
      least = (std::min)(least, distance(*(left - 1), p));
    return least;
  }

private:
  struct Ball
  {
    Position center;
    FT radius;
  };

  template <typename Surface>
  void add(const Curve_segment<FT>& segment, const Surface& surface,
           const std::vector<Position>& positions)
  {
    const auto h = sides(segment.face, surface.mesh());
    const Flat_face<FT> face(h[0], surface);
    const auto radius = [&](std::size_t k) {
      return (std::max)(norm_of(face.to_corner(k, segment.source)),
                        norm_of(face.to_corner(k, segment.target)));
    };
    std::size_t nearest = 0;
    for(std::size_t k = 1; k < 3; ++k)
      if(radius(k) < radius(nearest))
        nearest = k;
    m_balls.push_back({positions[surface.mesh().source(h[nearest]).idx()], radius(nearest)});
  }

  static FT distance(const Ball& ball, const Position& p)
  {
    using std::hypot;
    const FT d = hypot(ball.center[0] - p[0], ball.center[1] - p[1], ball.center[2] - p[2]);
    return (std::max)(FT(0), FT(d - ball.radius));
  }

  std::vector<Ball> m_balls; // by their x-coordinates
  FT m_greatest_radius = FT(0);
};

// Returns the position of a point with the coordinates of any kernel.
template <typename FT, typename Point>
std::array<FT, 3> position_of(const Point& p)
{
  return {FT(CGAL::to_double(p.x())), FT(CGAL::to_double(p.y())), FT(CGAL::to_double(p.z()))};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_STRAIGHT_DISTANCES_H
