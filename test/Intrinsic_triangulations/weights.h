// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H
#define INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>

#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_weights {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_kernel;
typedef Exact_kernel::Point_2 Point_2;
typedef std::set<std::pair<std::size_t, std::size_t>> Edges;

template <typename T>
std::pair<T, T> ordered(T a, T b)
{
  return std::minmax(a, b);
}

inline auto map_of(const std::vector<double>& weights)
{
  return boost::make_function_property_map<Vertex_index>(
    [&weights](Vertex_index v) { return weights[v.idx()]; });
}

inline std::vector<double> random_numbers(std::size_t n, double least, double greatest,
                                          CGAL::Random& random)
{
  std::vector<double> result(n);
  std::generate(result.begin(), result.end(), [&] { return random.get_double(least, greatest); });
  return result;
}

// Returns the edges of CGAL's regular triangulation of points that have been lifted to these
// weights, and the hidden points.
inline std::pair<Edges, std::vector<Vertex_index>>
regular_triangulation(const std::vector<Point_2>& points, const std::vector<double>& weights)
{
  typedef CGAL::Regular_triangulation_vertex_base_2<Exact_kernel> Base;
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact_kernel, Base> Vertex;
  typedef CGAL::Regular_triangulation_face_base_2<Exact_kernel> Face;
  typedef CGAL::Regular_triangulation_2<Exact_kernel,
                                        CGAL::Triangulation_data_structure_2<Vertex, Face>>
    Triangulation_2;
  std::vector<std::pair<Triangulation_2::Weighted_point, std::size_t>> weighted;
  for(std::size_t i = 0; i < points.size(); ++i)
    weighted.emplace_back(Triangulation_2::Weighted_point(points[i], weights[i]), i);
  const Triangulation_2 t(weighted.begin(), weighted.end());
  std::set<std::size_t> visible;
  Edges edges;
  for(auto v : t.finite_vertex_handles())
    visible.insert(v->info());
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    edges.insert(ordered(e->first->vertex(t.cw(e->second))->info(),
                         e->first->vertex(t.ccw(e->second))->info()));
  std::vector<Vertex_index> hidden;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(visible.count(i) == 0)
      hidden.emplace_back(static_cast<Delta_complex::size_type>(i));
  return {edges, hidden};
}

// Returns the least length of a dual edge, relative to both heights and the edge, in 50 digits:
// lengths come from the strips of T1, and power centers from coordinates of the corners in the
// plane. A triangulation is weighted Delaunay if it is not negative.
inline double least_dual_edge(const Triangulation& t, const std::vector<double>& weights)
{
  typedef boost::multiprecision::cpp_bin_float_50 Number;
  const Delta_complex& mesh = t.mesh();
  IT::Precise_lengths<IT::Euclidean_geometry_traits<double>, Number> precise(t);
  const auto height = [&](Halfedge_index h) {
    const Number l = precise(h), b = precise(mesh.next(h)), a = precise(mesh.prev(h));
    const Number wi = weights[mesh.source(h).idx()], wj = weights[mesh.target(h).idx()],
                 wk = weights[mesh.target(mesh.next(h)).idx()];
    const Number x = (l * l + a * a - b * b) / (2 * l), y = sqrt(Number(a * a - x * x));
    const Number center = (l * l + wi - wj) / (2 * l);
    return Number((a * a + wi - wk - 2 * center * x) / (2 * y));
  };
  Number result = 1;
  for(Edge_index e : mesh.edges())
    if(!mesh.is_border(e)) {
      const Number left = height(mesh.halfedge(e)), right = height(mesh.opposite(mesh.halfedge(e)));
      const Number relative = (left + right) / (abs(left) + abs(right) + precise(mesh.halfedge(e)));
      if(!(relative >= result)) // NaN is kept
        result = relative;
    }
  return static_cast<double>(result);
}

} // namespace Test_weights

#endif // INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H
