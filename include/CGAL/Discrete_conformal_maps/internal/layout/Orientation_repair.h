// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_ORIENTATION_REPAIR_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_ORIENTATION_REPAIR_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Number_lists.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Polygon_orientations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Moves corners of polygons that are convex up to rounding. After the repair, no three corners of
// a polygon, in their order, turn right. Then no triangle is reversed, whatever triangles a
// polygon is cut into. A triangle without area is not reversed. Points are in the plane, or
// vectors in space as seen from the origin.
//
// Exact predicates decide. Each move reduces the number of triples that turn right, so the search
// ends. The work of the search is bounded, too. No coordinate of a point changes by more than
// `maximum_move` units in the last place of its greatest coordinate. Points stay in their bounding
// box, and points on a side of the box stay on this side.
template <std::size_t dimension>
class Orientation_repair
{
public:
  typedef std::array<double, dimension> Point;

  static constexpr int maximum_move = 32;

  // `polygons` contains the indices of the points that are the corners of each polygon.
  Orientation_repair(std::vector<Point>& points, const Number_lists& polygons)
    : m_points(points),
      m_polygons(polygons),
      m_orientations(points, polygons),
      m_maximum_work((std::min)(std::size_t(30000000), 2000 * polygons.size()))
  {}

  // Returns the polygons that remain reversed. If no polygon was reversed, no point moves.
  std::vector<std::size_t> run()
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < m_polygons.size(); ++i)
      if(m_orientations.is_reversed(i))
        result.push_back(i);
    if(result.empty())
      return result;
    prepare();
    for(std::size_t last = result.size() + 1; !result.empty() && result.size() < last;) {
      last = result.size();
      result = mended(std::move(result));
    }
    return result;
  }

private:
  typedef Polygon_orientations<dimension> Orientations;
  typedef typename Orientations::Defects Defects;
  typedef std::vector<std::pair<std::size_t, Point>> Positions; // some corners with their positions

  struct Move
  {
    std::size_t corner;
    Point to;
    Defects before, after; // the defects around the corner before and after the move

    std::size_t gain() const { return before.reversed - after.reversed; }
    bool is_better_than(const Move& m) const
    {
      return gain() > m.gain() ||
             (gain() == m.gain() && after.flat + m.before.flat < m.after.flat + before.flat);
    }
  };

  Defects defects_around(std::size_t corner) const
  {
    Defects result;
    for(std::size_t k = 0; k < m_around.size(corner); ++k)
      result += m_orientations.defects(m_around(corner, k));
    return result;
  }

  // ---- The search ----

  void prepare()
  {
    m_around = m_polygons.inverse(m_points.size());
    m_start = m_points;
    m_low = m_high = m_points.front();
    for(const Point& p : m_points)
      for(std::size_t c = 0; c < dimension; ++c) {
        m_low[c] = (std::min)(m_low[c], p[c]);
        m_high[c] = (std::max)(m_high[c], p[c]);
      }
    m_is_in_cluster.assign(m_points.size(), 0);
  }

  // Repairs these polygons, and polygons that a move reverses. Returns the polygons that remain
  // reversed.
  std::vector<std::size_t> mended(std::vector<std::size_t> polygons)
  {
    for(std::size_t n = 0; n < polygons.size(); ++n)
      while(m_orientations.is_reversed(polygons[n]) && improve(polygons[n], polygons)) {
      }
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                  [this](std::size_t i) { return !m_orientations.is_reversed(i); }),
                   polygons.end());
    return polygons;
  }

  // Makes a move for polygon `i`, preferably one that flattens no triangle. Appends the polygons
  // around the corner that are reversed to a list. Returns false if no move exists.
  bool improve(std::size_t i, std::vector<std::size_t>& reversed)
  {
    return m_work < m_maximum_work &&
           (move_corner(i, false, reversed) || move_corner(i, true, reversed) ||
            merge_corners(i, reversed) || slide_corners(i, reversed));
  }

  // Moves a corner of polygon `i`. Tries the shortest steps first.
  bool move_corner(std::size_t i, bool may_flatten, std::vector<std::size_t>& reversed)
  {
    for(int exponent = -2; (1 << (exponent + 2)) <= 4 * maximum_move; ++exponent) {
      Move best{0, {}, {}, {}};
      for(std::size_t k = 0; k < m_polygons.size(i); ++k)
        find_move(i, m_polygons(i, k), exponent, may_flatten, best);
      if(best.gain() > 0) {
        m_points[best.corner] = best.to;
        for(std::size_t k = 0; k < m_around.size(best.corner); ++k)
          add_if_reversed(m_around(best.corner, k), reversed);
        return true;
      }
    }
    return false;
  }

  void add_if_reversed(std::size_t i, std::vector<std::size_t>& reversed) const
  {
    if(m_orientations.is_reversed(i))
      reversed.push_back(i);
  }

  // Finds the best move of a corner by 2^exponent units. The move must be better than `best`, and
  // improve polygon `i`.
  void find_move(std::size_t i, std::size_t corner, int exponent, bool may_flatten, Move& best)
  {
    const Point from = m_points[corner];
    const double step = std::ldexp(Orientations::unit(from), exponent);
    const std::size_t reversed = m_orientations.defects(i).reversed;
    Move move{corner, {}, defects_around(corner), {}};
    m_work += m_around.size(corner);
    for_each_direction([&](const Point& direction) {
      move.to = moved(from, step, direction);
      if(move.to == from || m_work >= m_maximum_work || !may_move(corner, move.to))
        return;
      m_points[corner] = move.to;
      m_work += 1;
      if(m_orientations.defects(i).reversed < reversed) {
        move.after = defects_around(corner);
        m_work += m_around.size(corner);
        if(move.after.reversed < move.before.reversed &&
           (may_flatten || move.after.flat <= move.before.flat) && move.is_better_than(best))
          best = move;
      }
      m_points[corner] = from;
    });
  }

  // Calls `f` with vectors of maximum norm one. In the plane their coordinates are multiples of
  // one half, in space integers.
  template <typename Function>
  static void for_each_direction(const Function& f)
  {
    for(int x = -2; x <= 2; ++x)
      for(int y = -2; y <= 2; ++y)
        if constexpr(dimension == 2) {
          if((std::max)(std::abs(x), std::abs(y)) == 2)
            f({x / 2., y / 2.});
        } else if(x % 2 == 0 && y % 2 == 0)
          for(double z : {-1., 0., 1.})
            f({x / 2., y / 2., z});
  }

  static Point moved(Point p, double step, const Point& direction)
  {
    for(std::size_t c = 0; c < dimension; ++c)
      p[c] += step * direction[c];
    return p;
  }

  bool may_move(std::size_t corner, const Point& to) const
  {
    const Point &start = m_start[corner], from = m_points[corner];
    const double bound = maximum_move * Orientations::unit(start);
    for(std::size_t c = 0; c < dimension; ++c)
      if(to[c] != from[c] && !(m_low[c] < from[c] && from[c] < m_high[c] && m_low[c] <= to[c] &&
                               to[c] <= m_high[c] && std::abs(to[c] - start[c]) <= bound))
        return false;
    return true;
  }

  // Merges points close to each other at one corner of polygon `i`, so that their triangles have
  // no area. Merges as few points as possible.
  bool merge_corners(std::size_t i, std::vector<std::size_t>& reversed)
  {
    for(int size = 1; size <= maximum_move; size *= 2)
      for(std::size_t k = 0; k < m_polygons.size(i); ++k)
        if(merge_around(m_polygons(i, k), size, reversed))
          return true;
    return false;
  }

  bool merge_around(std::size_t center, int size, std::vector<std::size_t>& reversed)
  {
    Positions to;
    for(std::size_t c : cluster(center, size))
      to.emplace_back(c, m_points[center]);
    return move_together(std::move(to), reversed);
  }

  // Moves corners to the positions of other points, if this reduces the number of triples that turn
  // right.
  bool move_together(Positions points, std::vector<std::size_t>& reversed)
  {
    std::vector<std::size_t> polygons;
    for(const auto& [c, p] : points)
      for(std::size_t k = 0; k < m_around.size(c); ++k)
        polygons.push_back(m_around(c, k));
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    m_work += 2 * polygons.size();
    const auto number_of_reversed = [&] {
      Defects result;
      for(std::size_t i : polygons)
        result += m_orientations.defects(i);
      return result.reversed;
    };
    const std::size_t before = number_of_reversed();
    const auto exchange = [&] {
      for(auto& [c, p] : points)
        std::swap(m_points[c], p);
    };
    exchange();
    if(number_of_reversed() < before) {
      for(std::size_t i : polygons)
        add_if_reversed(i, reversed);
      return true;
    }
    exchange();
    return false;
  }

  // Returns the corners that polygons connect to `center` within `size` units of it.
  std::vector<std::size_t> cluster(std::size_t center, int size)
  {
    const Point& to = m_points[center];
    const double radius = size * Orientations::unit(to);
    const auto belongs = [&](std::size_t corner) {
      double distance = 0;
      for(std::size_t c = 0; c < dimension; ++c)
        distance = (std::max)(distance, std::abs(m_points[corner][c] - to[c]));
      return distance <= radius && may_move(corner, to);
    };
    std::vector<std::size_t> result{center};
    m_is_in_cluster[center] = 1;
    for(std::size_t n = 0; n < result.size() && m_work < m_maximum_work; ++n)
      for(std::size_t k = 0; k < m_around.size(result[n]); ++k)
        for(std::size_t i = m_around(result[n], k), s = 0; s < m_polygons.size(i); ++s, ++m_work)
          if(const std::size_t c = m_polygons(i, s); !m_is_in_cluster[c] && belongs(c)) {
            m_is_in_cluster[c] = 1;
            result.push_back(c);
          }
    for(std::size_t c : result)
      m_is_in_cluster[c] = 0;
    return result;
  }

  // Moves several corners one after the other, beginning with polygon `i`. Each corner moves to
  // the position at which the polygons around it extend least beyond their sides.
  bool slide_corners(std::size_t i, std::vector<std::size_t>& reversed)
  {
    std::vector<std::size_t> waiting;
    const auto wait = [&](std::size_t polygon) {
      for(std::size_t k = 0; k < m_polygons.size(polygon); ++k)
        waiting.push_back(m_polygons(polygon, k));
    };
    wait(i);
    Positions start, end;
    for(std::size_t n = 0; n < waiting.size() && n < maximum_slides; ++n)
      if(const Point from = m_points[waiting[n]]; slide(waiting[n])) {
        start.emplace_back(waiting[n], from);
        for(std::size_t k = 0; k < m_around.size(waiting[n]); ++k)
          if(const std::size_t j = m_around(waiting[n], k); m_orientations.depth(j) > 0)
            wait(j);
      }
    while(!start.empty()) {
      const auto [c, p] = start.back();
      start.pop_back();
      if(std::none_of(end.begin(), end.end(), [c = c](const auto& x) { return x.first == c; }))
        end.emplace_back(c, m_points[c]);
      m_points[c] = p;
    }
    return move_together(std::move(end), reversed);
  }

  bool slide(std::size_t corner)
  {
    const Point from = m_points[corner];
    Point best = from;
    double least = depth_around(corner) * (1 - 1. / 1024);
    for(int exponent = -2; (1 << (exponent + 2)) <= 4 * maximum_move && least > 0; ++exponent)
      for_each_direction([&](const Point& direction) {
        const Point to = moved(from, std::ldexp(Orientations::unit(from), exponent), direction);
        if(m_work >= m_maximum_work || !may_move(corner, to))
          return;
        m_points[corner] = to;
        m_work += m_around.size(corner);
        if(const double d = depth_around(corner); d < least) {
          least = d;
          best = to;
        }
        m_points[corner] = from;
      });
    m_points[corner] = best;
    return best != from;
  }

  double depth_around(std::size_t corner) const
  {
    double result = 0;
    for(std::size_t k = 0; k < m_around.size(corner); ++k)
      result += m_orientations.depth(m_around(corner, k));
    return result;
  }

  static constexpr std::size_t maximum_slides = 64;

  std::vector<Point>& m_points;
  const Number_lists& m_polygons;
  Orientations m_orientations;
  Number_lists m_around;      // the polygons around each point
  std::vector<Point> m_start; // the given points
  Point m_low, m_high;
  std::vector<char> m_is_in_cluster;
  std::size_t m_maximum_work; // the maximum number of polygons to examine
  std::size_t m_work = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_ORIENTATION_REPAIR_H
