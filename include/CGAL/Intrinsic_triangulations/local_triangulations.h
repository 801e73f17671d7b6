// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOCAL_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOCAL_TRIANGULATIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Default_diagonalize_traits.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Triangulates the neighborhoods of points in their tangent planes.
class Local_triangulator
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point;
  typedef Kernel::Vector_3 Vector;
  typedef typename Pointer_property_map<Point>::const_type Point_map;
  typedef Search_traits_3<Kernel> Base_traits;
  typedef Search_traits_adapter<std::size_t, Point_map, Base_traits> Search_traits;
  typedef Orthogonal_k_neighbor_search<Search_traits> Search;
  typedef Delaunay_triangulation_2<
    Kernel,
    Triangulation_data_structure_2<Triangulation_vertex_base_with_info_2<std::size_t, Kernel>>>
    Delaunay;
  typedef std::vector<std::array<std::size_t, 3>> Triangles;

public:
  explicit Local_triangulator(std::vector<Point> points)
    : m_points(std::move(points)),
      m_tree(boost::counting_iterator<std::size_t>(0),
             boost::counting_iterator<std::size_t>(m_points.size()), typename Search::Splitter(),
             Search_traits(point_map()))
  {}

  // Adds the triangles around point `center`.
  void add_star(std::size_t center, std::size_t neighbors, Triangles& triangles) const
  {
    const auto near = nearest(center, neighbors);
    const std::array<Vector, 2> axes = tangent_axes(near);
    const auto flat = [&](std::size_t i) {
      const Vector v = m_points[i] - m_points[center];
      const double x = v * axes[0], y = v * axes[1];
      if(!CGAL::is_finite(x) || !CGAL::is_finite(y))
        throw Invalid_input("the neighbors of point " + std::to_string(center) +
                            " are out of range");
      return Kernel::Point_2(x, y);
    };
    Delaunay delaunay;
    const auto middle = delaunay.insert(flat(center));
    middle->info() = center;
    for(const std::size_t i : near) {
      const std::size_t before = delaunay.number_of_vertices();
      const auto v = delaunay.insert(flat(i));
      if(delaunay.number_of_vertices() > before)
        v->info() = i;
    }
    if(delaunay.dimension() < 2)
      return;
    auto f = delaunay.incident_faces(middle);
    const auto first = f;
    do {
      const int c = f->index(middle);
      if(!delaunay.is_infinite(f))
        triangles.push_back({center, f->vertex(f->ccw(c))->info(), f->vertex(f->cw(c))->info()});
    } while(++f != first);
  }

private:
  Point_map point_map() const { return Point_map(m_points.data()); }

  // Returns the nearest points in ascending distance, including the center and equal points.
  std::vector<std::size_t> nearest(std::size_t center, std::size_t neighbors) const
  {
    const Distance_adapter<std::size_t, Point_map, Euclidean_distance<Base_traits>> distance(
      point_map());
    const Search search(m_tree, m_points[center], static_cast<unsigned int>(neighbors + 1), 0, true,
                        distance);
    std::vector<std::size_t> result;
    for(const auto& found : search)
      result.push_back(found.first);
    return result;
  }

  // Returns two unit vectors orthogonal to the direction in which the points vary least.
  std::array<Vector, 2> tangent_axes(const std::vector<std::size_t>& near) const
  {
    double scale = (std::numeric_limits<double>::min)();
    for(const std::size_t i : near)
      for(int x = 0; x < 3; ++x)
        scale = (std::max)(scale, std::abs(m_points[i][x] - m_points[near[0]][x]));
    const auto scaled = [&](std::size_t i) { return (m_points[i] - m_points[near[0]]) / scale; };
    Vector mean = NULL_VECTOR;
    for(const std::size_t i : near)
      mean = mean + scaled(i) / double(near.size());
    std::array<double, 6> covariance{};
    for(const std::size_t i : near) {
      const Vector v = scaled(i) - mean;
      std::size_t entry = 0;
      for(int x = 0; x < 3; ++x)
        for(int y = x; y < 3; ++y)
          covariance[entry++] += v[x] * v[y];
    }
    std::array<double, 3> variances{};
    std::array<double, 9> axes{};
    Default_diagonalize_traits<double, 3>::diagonalize_selfadjoint_covariance_matrix(
      covariance, variances, axes);
    return {Vector(axes[3], axes[4], axes[5]), Vector(axes[6], axes[7], axes[8])};
  }

  std::vector<Point> m_points;
  typename Search::Tree m_tree;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCovers
/// triangulates the neighborhood of each point of a cloud. The nearest points are projected to the
/// plane in which they vary most, and triangulated in this plane (Delaunay). The triangles around
/// the point itself are kept. If neighborhoods agree, each triangle occurs three times, once for
/// each of its corners. So the share of a `Tufted_surface` of all of them is one sixth
/// \cgalCite{SC20}.
///
/// Complexity: \f$O(n k \log k)\f$ for \f$n\f$ points, plus the search for neighbors.
/// \param points a random access range of points with coordinates of type `double`; each of several
///   equal points is triangulated without the others
/// \param number_of_neighbors how many nearest points are considered; 30 is usual
/// \returns the triangles, as indices of points; a point whose neighbors are collinear gets none
/// \throws Invalid_input if a coordinate, or a distance to a neighbor, is not finite
template <typename PointRange>
std::vector<std::array<std::size_t, 3>> local_triangulations(const PointRange& points,
                                                             std::size_t number_of_neighbors)
{
  std::vector<Exact_predicates_inexact_constructions_kernel::Point_3> own;
  for(const auto& p : points)
    own.emplace_back(double(p.x()), double(p.y()), double(p.z()));
  internal::check_finite(own);
  std::vector<std::array<std::size_t, 3>> result;
  result.reserve(6 * own.size());
  const std::size_t size = own.size();
  const internal::Local_triangulator triangulator(std::move(own));
  for(std::size_t i = 0; i < size; ++i)
    triangulator.add_star(i, number_of_neighbors, result);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOCAL_TRIANGULATIONS_H
