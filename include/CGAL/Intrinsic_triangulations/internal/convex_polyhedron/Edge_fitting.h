// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_EDGE_FITTING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_EDGE_FITTING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Precise_vector.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Moves vertices in space by Newton's method, such that edges get the lengths that they have on a
// surface. A convex polyhedron without flat vertices is infinitesimally rigid, however its faces
// are cut into triangles. So its edges determine all coordinates but six.
class Edge_fitting
{
  typedef Eigen::VectorXd Vector;
  typedef std::vector<Precise_vector> Positions;

public:
  Edge_fitting(const Metric_surface& surface, Positions& positions)
    : m_surface(surface), m_positions(positions)
  {
    number_coordinates();
    for(int step = 0; step < most_steps && improve(); ++step)
      ;
  }

private:
  static constexpr int most_steps = 30, most_halvings = 10;
  static constexpr int fixed = -1; // the index of a coordinate that stays

  // Excludes motions: fixes all coordinates of a vertex, two of another vertex far from it, and one
  // of a third vertex.
  void number_coordinates()
  {
    std::vector<std::array<double, 3>> p;
    for(const Precise_vector& q : m_positions)
      p.push_back({q.x.high(), q.y.high(), q.z.high()});
    const auto [first, last] = std::minmax_element(p.begin(), p.end());
    const std::array<double, 3> a = *first, b = *last;
    const auto distance = [&](const std::array<double, 3>& q) { // from a line
      return std::abs((b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]));
    };
    const auto third = std::max_element(
      p.begin(), p.end(), [&](const auto& q, const auto& r) { return distance(q) < distance(r); });
    m_index.assign(p.size(), {0, 0, 0});
    m_index[static_cast<std::size_t>(first - p.begin())] = {fixed, fixed, fixed};
    m_index[static_cast<std::size_t>(last - p.begin())] = {0, fixed, fixed};
    m_index[static_cast<std::size_t>(third - p.begin())] = {0, 0, fixed};
    int n = 0;
    for(auto& index : m_index)
      for(int& i : index)
        if(i != fixed)
          i = n++;
  }

  Precise_vector along(Edge_index e, const Positions& positions) const
  {
    const Delta_complex& mesh = m_surface.mesh();
    return positions[mesh.vertex(e, 1).idx()] - positions[mesh.vertex(e, 0).idx()];
  }

  // Returns half of the errors of squared lengths, divided by lengths.
  Vector errors(const Positions& positions) const
  {
    Vector result(static_cast<Eigen::Index>(m_surface.mesh().num_edges()));
    for(Edge_index e : m_surface.mesh().edges()) {
      const Precise_vector v = along(e, positions);
      const Double_double length = m_surface.length_map()[e];
      result[static_cast<Eigen::Index>(e.idx())] =
        ((length * length - v * v) / (2 * length)).high();
    }
    return result;
  }

  Eigen::SparseMatrix<double> derivative() const
  {
    const Delta_complex& mesh = m_surface.mesh();
    std::vector<Eigen::Triplet<double>> entries;
    for(Edge_index e : mesh.edges()) {
      const Precise_vector v = along(e, m_positions);
      const double length = m_surface.length_map()[e].high();
      const std::array<double, 3> direction{v.x.high() / length, v.y.high() / length,
                                            v.z.high() / length};
      for(unsigned int end : {0u, 1u})
        for(std::size_t x = 0; x < 3; ++x)
          if(const int i = m_index[mesh.vertex(e, end).idx()][x]; i != fixed)
            entries.emplace_back(static_cast<int>(e.idx()), i,
                                 end == 0 ? -direction[x] : direction[x]);
    }
    const auto n = static_cast<Eigen::Index>(mesh.num_edges());
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Positions moved(const Vector& step, double factor) const
  {
    Positions result = m_positions;
    const auto change = [&](int i) { return i == fixed ? 0. : factor * step[i]; };
    for(std::size_t v = 0; v < result.size(); ++v)
      result[v] = result[v] + Precise_vector{change(m_index[v][0]), change(m_index[v][1]),
                                             change(m_index[v][2])};
    return result;
  }

  // Returns whether a step has made the greatest error smaller.
  bool improve()
  {
    const Vector error = errors(m_positions);
    const double greatest = error.lpNorm<Eigen::Infinity>();
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.compute(derivative());
    if(solver.info() != Eigen::Success)
      return false;
    const Vector step = solver.solve(error);
    double factor = 1;
    for(int halvings = 0; halvings < most_halvings; ++halvings, factor /= 2) {
      Positions positions = moved(step, factor);
      const double now = errors(positions).lpNorm<Eigen::Infinity>();
      if(now < greatest) {
        m_positions = std::move(positions);
        return now < greatest / 2;
      }
    }
    return false;
  }

  const Metric_surface& m_surface;
  Positions& m_positions;
  std::vector<std::array<int, 3>> m_index; // of coordinates
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_EDGE_FITTING_H
