// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_SPECTRAL_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_SPECTRAL_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Unfolded_faces.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the spectral conformal layout of a chart (Mullen, Tong, Alliez, Desbrun 2008). It is
// the eigenvector of L z = lambda B z with the least eigenvalue besides the constant vectors. Here
// z^* L z is the conformal energy, which is the Dirichlet energy minus the area. The term z^* B z
// is the mean square on the boundary.
//
// L is a sum over faces of |r|^2 / (8 area) with r = side_0 (z_2 - z_1) - side_1 (z_1 - z_0). The
// residual r vanishes if the image is similar to the face. Sizes of faces may differ by a factor
// of 1e20, and the eigenvector as a whole has no digits for small faces. So the inverse iteration
// z <- L^-1 (lambda B z) with the Rayleigh quotient lambda is computed as z - L^-1 (L z - lambda B
// z). The solution of the linear system is a correction of the layout, and r is computed from
// differences. On a flat chart, the kernel of L also contains the layout, whose scale is left
// unchanged.
template <typename FT>
class Spectral_chart
{
public:
  typedef Plane_vector<FT> Vector;
  typedef std::array<std::size_t, 3> Points;
  typedef std::array<Vector, 3> Sides;

  // Side `s` leads from point `s` to the next point.
  void add_face(const Points& point, const Sides& side)
  {
    std::size_t first = 0; // the shortest side: differences to it lose no digits on needles
    for(std::size_t s : {1u, 2u})
      if(norm(side[s]) < norm(side[first]))
        first = s;
    const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
    m_faces.push_back({{point[first], point[second], point[third]},
                       {side[first], side[second], side[third]},
                       FT(1) / (2 * quadrupled_area(side))});
  }

  void add_boundary_edge(std::size_t i, std::size_t j, double length)
  {
    m_boundary.push_back({i, j, length});
  }

  // Improves a layout of the chart while corrections get smaller and the energy does not rise by
  // more than rounding. The area of the result is the area of the faces. If a face has no area,
  // the chart does not change. `order` is the elimination order of the points.
  // \throws Numerical_error if L has no factorization
  void improve(std::vector<Vector>& z, const Shared_order& order = {}) const
  {
    Energy energy = evaluate(z);
    if(!std::isfinite(energy.value))
      return;
    std::vector<std::size_t> point(2 * z.size()); // the point of each coordinate
    for(std::size_t k = 0; k < point.size(); ++k)
      point[k] = k / 2;
    Dirichlet_solver solver(matrix(z.size()), held_points(z), order.refined(point, 2));
    for(double last = std::numeric_limits<double>::infinity();;) {
      const Eigen::VectorXd step = solver.solve(residual(energy, z));
      std::vector<Vector> better = corrected(z, step);
      Energy least = evaluate(better);
      if(!(step.norm() < last / 2) || !(least.value <= (1 + tolerance::growth) * energy.value))
        break;
      last = step.norm();
      z = std::move(better);
      energy = std::move(least);
    }
    rescale(z);
  }

private:
  struct Face
  {
    Points point;
    Sides side;
    FT weight; // 1 / (8 area)

    // Returns the factor of point `s` in r.
    const Vector& opposite(std::size_t s) const { return side[(s + 1) % 3]; }
  };

  struct Boundary_edge
  {
    std::size_t i, j;
    double length;
  };

  struct Energy
  {
    double value;             // z^* L z
    Eigen::VectorXd gradient; // L z, with real and imaginary parts alternating
  };

  static FT quadrupled_area(const Sides& side)
  {
    using std::sqrt;
    return sqrt(Intrinsic_triangulations::squared_quadrupled_area(
      FT(sqrt(norm(side[0]))), FT(sqrt(norm(side[1]))), FT(sqrt(norm(side[2])))));
  }

  static Vector image(const Face& f, std::size_t s, const std::vector<Vector>& z)
  {
    return z[f.point[(s + 1) % 3]] - z[f.point[s]];
  }

  static void add(Eigen::VectorXd& vector, std::size_t i, double x, double y)
  {
    vector[static_cast<Eigen::Index>(2 * i)] += x;
    vector[static_cast<Eigen::Index>(2 * i + 1)] += y;
  }

  Energy evaluate(const std::vector<Vector>& z) const
  {
    Energy result{0, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * z.size()))};
    for(const Face& f : m_faces) {
      const Vector r = f.side[0] * image(f, 1, z) - f.side[1] * image(f, 0, z);
      const Vector scaled = f.weight * r;
      result.value += static_cast<double>(r.x * scaled.x + r.y * scaled.y);
      for(std::size_t s = 0; s < 3; ++s) {
        const std::complex<double> part = to_complex(conj(f.opposite(s)) * scaled);
        add(result.gradient, f.point[s], part.real(), part.imag());
      }
    }
    return result;
  }

  // Returns B z with lumped B, for a translate of `z` whose mean on the boundary is zero.
  Eigen::VectorXd boundary_moment(const std::vector<Vector>& z) const
  {
    std::complex<double> mean(0);
    double sum = 0;
    for(const Boundary_edge& e : m_boundary) {
      mean += e.length / 2 * (to_complex(z[e.i]) + to_complex(z[e.j]));
      sum += e.length;
    }
    mean /= sum;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * z.size()));
    for(const Boundary_edge& e : m_boundary)
      for(const std::size_t i : {e.i, e.j}) {
        const std::complex<double> moment = e.length / 2 * (to_complex(z[i]) - mean);
        add(result, i, moment.real(), moment.imag());
      }
    return result;
  }

  // Returns L z - lambda B z.
  Eigen::VectorXd residual(const Energy& energy, const std::vector<Vector>& z) const
  {
    const Eigen::VectorXd moment = boundary_moment(z);
    double square = 0; // z^* B z
    for(std::size_t i = 0; i < z.size(); ++i) {
      const std::complex<double> p = to_complex(z[i] - z[0]);
      square += moment[static_cast<Eigen::Index>(2 * i)] * p.real() +
                moment[static_cast<Eigen::Index>(2 * i + 1)] * p.imag();
    }
    return energy.gradient - energy.value / square * moment;
  }

  Eigen::SparseMatrix<double> matrix(std::size_t number_of_points) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * m_faces.size());
    for(const Face& f : m_faces)
      for(std::size_t s = 0; s < 3; ++s)
        for(std::size_t t = 0; t < 3; ++t) {
          const std::complex<double> l =
            to_complex(f.weight * (conj(f.opposite(s)) * f.opposite(t)));
          const int row = static_cast<int>(2 * f.point[s]),
                    column = static_cast<int>(2 * f.point[t]);
          entries.emplace_back(row, column, l.real());
          entries.emplace_back(row + 1, column + 1, l.real());
          entries.emplace_back(row, column + 1, -l.imag());
          entries.emplace_back(row + 1, column, l.imag());
        }
    const auto size = static_cast<Eigen::Index>(2 * number_of_points);
    Eigen::SparseMatrix<double> result(size, size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // Returns two points that are fixed because L has a kernel. They are the first point and the
  // point farthest from it.
  static std::vector<char> held_points(const std::vector<Vector>& z)
  {
    std::size_t far = 0;
    for(std::size_t i = 0; i < z.size(); ++i)
      if(norm(z[i] - z[0]) > norm(z[far] - z[0]))
        far = i;
    std::vector<char> result(2 * z.size(), 0);
    for(std::size_t i : {std::size_t(0), far})
      result[2 * i] = result[2 * i + 1] = 1;
    return result;
  }

  static std::vector<Vector> corrected(const std::vector<Vector>& z, const Eigen::VectorXd& step)
  {
    std::vector<Vector> result(z);
    for(std::size_t i = 0; i < z.size(); ++i)
      result[i] = z[i] - Vector{FT(step[static_cast<Eigen::Index>(2 * i)]),
                                FT(step[static_cast<Eigen::Index>(2 * i + 1)])};
    return result;
  }

  void rescale(std::vector<Vector>& z) const
  {
    using std::sqrt;
    FT wanted(0), area(0);
    for(const Face& f : m_faces) {
      wanted += FT(1) / (4 * f.weight);
      area += (conj(image(f, 0, z)) * image(f, 1, z)).y;
    }
    if(!(area > 0)) // the layout has collapsed
      return;
    const FT factor = sqrt(wanted / area);
    for(Vector& p : z)
      p = factor * p;
  }

  std::vector<Face> m_faces;
  std::vector<Boundary_edge> m_boundary;
};

// Moves the points of each chart to its spectral layout.
struct Spectral_layout
{
  template <typename FT>
  void operator()(Unfolded_faces<FT>& faces, const Shared_order& order) const
  {
    std::vector<std::size_t> number(faces.positions.size(), none); // of each point in its chart
    const auto& steps = faces.cut().steps();
    for(auto root = steps.begin(); root != steps.end();) {
      const auto end = std::find_if(
        root + 1, steps.end(), [](const Cut_graph::Step& step) { return !step.entry.is_valid(); });
      improve_chart(root, end, faces, order, number);
      root = end;
    }
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  template <typename Iterator, typename FT>
  static void improve_chart(Iterator begin, Iterator end, Unfolded_faces<FT>& faces,
                            const Shared_order& order, std::vector<std::size_t>& number)
  {
    Spectral_chart<FT> chart;
    std::vector<std::size_t> points;
    const auto number_of = [&](Halfedge_index h) {
      std::size_t& result = number[faces.point(h)];
      if(result == none) {
        result = points.size();
        points.push_back(faces.point(h));
      }
      return result;
    };
    for(Iterator step = begin; step != end; ++step) {
      const auto h = sides(step->face, faces.mesh());
      const std::array<std::size_t, 3> point{number_of(h[0]), number_of(h[1]), number_of(h[2])};
      chart.add_face(point, {faces.side(h[0]), faces.side(h[1]), faces.side(h[2])});
      for(std::size_t s = 0; s < 3; ++s)
        if(faces.cut().is_seam(Edge_index(h[s])))
          chart.add_boundary_edge(point[s], point[(s + 1) % 3],
                                  static_cast<double>(faces.length(h[s])));
    }
    std::vector<Plane_vector<FT>> position;
    std::vector<Vertex_index> vertex;
    for(std::size_t i : points) {
      position.push_back(faces.positions[i]);
      vertex.push_back(faces.vertices[i]);
    }
    chart.improve(position, *order.refined(vertex));
    for(std::size_t k = 0; k < points.size(); ++k)
      faces.positions[points[k]] = position[k];
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_SPECTRAL_LAYOUT_H
