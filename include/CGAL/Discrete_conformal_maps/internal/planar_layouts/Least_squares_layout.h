// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_LEAST_SQUARES_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_LEAST_SQUARES_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Unfolded_faces.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the required change of a side of a face along one axis: `x[to] - sign * x[from]` should
// change by `change`. If the sign is -1, one end is the mirror image of a point.
struct Side_change
{
  int from, to, sign;
  double weight, change;
};

// Shifts points on a line such that sides of faces change by given amounts. Solves for the shifts
// by weighted least squares.
class Least_squares_shift
{
public:
  typedef Eigen::VectorXd Vector;

  // `for_each_side(visit)` visits all sides, whose number is known.
  template <typename For_each_side>
  Least_squares_shift(std::size_t number_of_points, std::size_t number_of_sides,
                      const For_each_side& for_each_side)
    : m_diagonal(Vector::Zero(static_cast<Eigen::Index>(number_of_points))),
      m_is_held(number_of_points, 1)
  {
    m_entries.reserve(2 * number_of_sides + number_of_points);
    for_each_side([this](const Side_change& s) {
      for(const auto& [i, j] : {std::pair(s.from, s.to), std::pair(s.to, s.from)}) {
        m_entries.emplace_back(i, j, -s.sign * s.weight);
        m_diagonal[i] += s.weight;
        m_is_held[static_cast<std::size_t>(i)] = 0;
      }
    });
  }

  // Fixes point `i`. Points without sides are fixed automatically. In each set of points that
  // sides connect, the caller fixes one point, unless one of the signs is -1.
  void fix(int i) { m_is_held[static_cast<std::size_t>(i)] = 1; }

  // `order` is the elimination order of the points.
  void factorize(const std::shared_ptr<Shared_order>& order)
  {
    for(Eigen::Index i = 0; i < m_diagonal.size(); ++i)
      m_entries.emplace_back(static_cast<int>(i), static_cast<int>(i), m_diagonal[i]);
    Eigen::SparseMatrix<double> matrix(m_diagonal.size(), m_diagonal.size());
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    std::vector<Eigen::Triplet<double>>().swap(m_entries); // the factor replaces them
    m_solver.emplace(matrix, m_is_held, order);
  }

  // Returns the right-hand side for these changes.
  template <typename For_each_side>
  Vector right_side(const For_each_side& for_each_side) const
  {
    Vector result = Vector::Zero(m_diagonal.size());
    for_each_side([&result](const Side_change& s) {
      result[s.to] += s.weight * s.change;
      result[s.from] -= s.sign * s.weight * s.change;
    });
    return result;
  }

  // Shifts the coordinates of points.
  // \pre `factorize()` has been called
  template <typename Point, typename FT>
  void shift(const Vector& right_side, std::vector<Point>& points, FT Point::*coordinate)
  {
    const Vector by = m_solver->solve(right_side);
    for(std::size_t i = 0; i < points.size(); ++i)
      points[i].*coordinate += FT(by[Eigen::Index(i)]);
  }

private:
  std::vector<Eigen::Triplet<double>> m_entries; // entries outside the diagonal
  Vector m_diagonal;
  std::vector<char> m_is_held;
  std::optional<Dirichlet_solver> m_solver;
};

// Returns the weight of a side. It makes changes relative to the length of the side.
template <typename FT>
double side_weight(const FT& length)
{
  return static_cast<double>(1 / (length * length));
}

// Shifts the points such that the sum of the squared relative changes of all sides of faces is
// minimal.
struct Least_squares_layout
{
  template <typename FT>
  void operator()(Unfolded_faces<FT>& faces, const Shared_order& order) const
  {
    typedef Plane_vector<FT> Vector;
    const auto sides_along = [&faces](FT Vector::*coordinate) {
      return [&faces, coordinate](const auto& visit) {
        faces.for_each_side([&](Halfedge_index h) {
          const Halfedge_index n = faces.mesh().next(h);
          const FT present = faces.position(n).*coordinate - faces.position(h).*coordinate;
          visit(Side_change{int(faces.point(h)), int(faces.point(n)), 1,
                            side_weight(faces.length(h)),
                            static_cast<double>(faces.side(h).*coordinate - present)});
        });
      };
    };
    const auto along_x = sides_along(&Vector::x), along_y = sides_along(&Vector::y);
    Least_squares_shift shift(faces.positions.size(), 3 * faces.cut().steps().size(), along_x);
    for(const Cut_graph::Step& step : faces.cut().steps())
      if(!step.entry.is_valid())
        shift.fix(int(faces.point(faces.mesh().halfedge(step.face))));
    const Eigen::VectorXd x = shift.right_side(along_x), y = shift.right_side(along_y);
    if(std::is_same<FT, double>::value)
      faces.drop_sides(); // the factor replaces them
    shift.factorize(order.refined(faces.vertices));
    shift.shift(x, faces.positions, &Vector::x);
    shift.shift(y, faces.positions, &Vector::y);
    // If numbers have more digits than shifts, a second shift removes the remaining errors.
    if(!std::is_same<FT, double>::value) {
      shift.shift(shift.right_side(along_x), faces.positions, &Vector::x);
      shift.shift(shift.right_side(along_y), faces.positions, &Vector::y);
    }
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_LEAST_SQUARES_LAYOUT_H
