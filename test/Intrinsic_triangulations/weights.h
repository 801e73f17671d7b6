// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H
#define INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>

#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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

// Computes dual edges in 50 digits. Lengths are computed in strips of T1, and power centers from
// coordinates of the corners in the plane.
class Dual_edges
{
  typedef IT::Decimal_float<50> Number;

public:
  Dual_edges(const Triangulation& t, const std::vector<double>& weights)
    : m_mesh(t.mesh()), m_weights(weights), m_precise(t)
  {}

  // Returns the least length relative to both heights and the edge. A triangulation is weighted
  // Delaunay if it is not negative.
  double least()
  {
    return least([](const Face& a, const Face& b) {
      return Number((a.center + b.center) / (abs(a.center) + abs(b.center) + a.side));
    });
  }

  // Returns the least change of the weight of an apex that moves the dual edge by its length. It is
  // relative to the squared longest side and the weights. It is negative if the edge is not
  // weighted Delaunay.
  double least_change_of_weight()
  {
    return least([](const Face& a, const Face& b) {
      return Number(2 * (a.center + b.center) * (std::min)(a.apex, b.apex) /
                    (std::max)(a.greatest, b.greatest));
    });
  }

private:
  // Represents a face over one of its sides, with the heights of the power center and of the apex.
  struct Face
  {
    Number side, center, apex, greatest; // square of a side or weight
  };

  Face face(Halfedge_index h)
  {
    const auto weight = [&](Halfedge_index g) { return Number(m_weights[m_mesh.source(g).idx()]); };
    const Number l = m_precise(h), b = m_precise(m_mesh.next(h)), a = m_precise(m_mesh.prev(h));
    const Number wi = weight(h), wj = weight(m_mesh.next(h)), wk = weight(m_mesh.prev(h));
    const Number x = (l * l + a * a - b * b) / (2 * l), y = sqrt(Number(a * a - x * x));
    const Number center = (l * l + wi - wj) / (2 * l), longest = (std::max)({l, a, b});
    return {
      l, (a * a + wi - wk - 2 * center * x) / (2 * y), y,
      (std::max)({Number(longest * longest), Number(abs(wi)), Number(abs(wj)), Number(abs(wk))})};
  }

  template <typename Measure>
  double least(const Measure& measure)
  {
    Number result = 1;
    for(Edge_index e : m_mesh.edges())
      if(!m_mesh.is_border(e)) {
        const Halfedge_index h = m_mesh.halfedge(e);
        const Number number = measure(face(h), face(m_mesh.opposite(h)));
        if(!(number >= result)) // NaN is kept
          result = number;
      }
    return static_cast<double>(result);
  }

  const Delta_complex& m_mesh;
  const std::vector<double>& m_weights;
  IT::Precise_lengths<IT::Euclidean_geometry_traits<double>, Number> m_precise;
};

inline double least_dual_edge(const Triangulation& t, const std::vector<double>& weights)
{
  return Dual_edges(t, weights).least();
}

} // namespace Test_weights

#endif // INTRINSIC_TRIANGULATIONS_TEST_WEIGHTS_H
