// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_SURFACE_CURVES_H
#define INTRINSIC_TRIANGULATIONS_TEST_SURFACE_CURVES_H

#include "measuring.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/Surface_curve.h>

// This file generates surfaces with curves whose distances have formulas.
namespace Test_surfaces {

typedef IT::Surface_curve<double> Curve;

// Returns the zeros of the function that is linear on faces and has these values at vertices, with
// negative values on the left.
inline Curve level_set(const Delta_complex& mesh, const std::vector<double>& value)
{
  Curve result;
  for(Face_index f : mesh.faces()) {
    const auto h = IT::sides(f, mesh);
    const auto at = [&](std::size_t k) { return value[mesh.source(h[k]).idx()]; };
    const auto crossing = [&](std::size_t k) {
      return IT::barycentric_coordinates(k, at(k) / (at(k) - at((k + 1) % 3)));
    };
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      if((at(k) < 0) == (at(a) < 0) || (at(k) < 0) == (at(b) < 0))
        continue;
      const auto p = crossing(k), q = crossing(b);
      result.push_back(at(k) < 0 ? IT::Curve_segment<double>{f, p, q}
                                 : IT::Curve_segment<double>{f, q, p});
    }
  }
  return result;
}

// Stores a Delaunay triangulation, the signed distances of its vertices from a curve, and a length
// as a unit of errors.
struct Known_curve
{
  std::string name;
  Triangulation t;
  std::vector<double> distance;
  double edge;

  Curve curve() const { return level_set(t.mesh(), distance); }
};

inline Known_curve known_curve(const std::string& name, const Mesh& mesh, double edge,
                               const std::function<double(const Point&)>& distance)
{
  Known_curve result{name, Triangulation(mesh), {}, edge};
  IT::make_Delaunay(result.t);
  for(Vertex_index v : mesh.vertices())
    result.distance.push_back(distance(mesh.point(v)));
  return result;
}

inline Known_curve circle_in_square(std::size_t n, CGAL::Random& random)
{
  const double x = random.get_double(0.4, 0.6), y = random.get_double(0.4, 0.6),
               radius = random.get_double(0.15, 0.35);
  return known_curve("circle", unit_square(n, 1), 1. / static_cast<double>(n),
                     [&](const Point& p) { return std::hypot(p.x() - x, p.y() - y) - radius; });
}

// Returns two circles on both sides of the diagonal.
inline Known_curve circles_in_square(std::size_t n, CGAL::Random& random)
{
  const double first = random.get_double(0.1, 0.2), second = random.get_double(0.1, 0.25);
  return known_curve("circles", unit_square(n, 1), 1. / static_cast<double>(n),
                     [&](const Point& p) {
                       return (std::min)(std::hypot(p.x() - 0.25, p.y() - 0.3) - first,
                                         std::hypot(p.x() - 0.7, p.y() - 0.65) - second);
                     });
}

// Returns a curve whose curvature jumps between half circles and line segments.
inline Known_curve stadium_in_square(std::size_t n, CGAL::Random& random)
{
  const double x = random.get_double(0.45, 0.55), y = random.get_double(0.45, 0.55),
               radius = random.get_double(0.1, 0.2);
  return known_curve("stadium", unit_square(n, 1), 1. / static_cast<double>(n),
                     [&](const Point& p) {
                       const double beyond = (std::max)(0., std::abs(p.x() - x) - 0.2);
                       return std::hypot(beyond, p.y() - y) - radius;
                     });
}

// Returns a line from border to border.
inline Known_curve line_in_square(std::size_t n, CGAL::Random& random)
{
  const double angle = random.get_double(0, 6.28), offset = random.get_double(-0.3, 0.3);
  return known_curve("line", unit_square(n, 1), 1. / static_cast<double>(n), [&](const Point& p) {
    return (p.x() - 0.5) * std::cos(angle) + (p.y() - 0.5) * std::sin(angle) - offset;
  });
}

inline Known_curve circle_on_sphere(std::size_t n, CGAL::Random& random)
{
  Kernel::Vector_3 axis(random.get_double(-1, 1), random.get_double(-1, 1),
                        random.get_double(0.1, 1));
  axis = axis / std::sqrt(axis.squared_length());
  const double radius = random.get_double(0.6, 2.2);
  return known_curve("circle on a sphere", unit_sphere(n / 2), 2. / static_cast<double>(n),
                     [&](const Point& p) {
                       const double cosine = (p - CGAL::ORIGIN) * axis;
                       return std::acos((std::max)(-1., (std::min)(1., cosine))) - radius;
                     });
}

// Returns two parallels of a torus of radii 3 and 1, around its outer half.
inline Known_curve parallels_of_torus(std::size_t n, CGAL::Random& random)
{
  const double half = random.get_double(0.4, 2.5);
  return known_curve("parallels of a torus", embedded_torus(2 * n, n),
                     6.28 / static_cast<double>(n), [&](const Point& p) {
                       const double angle = std::atan2(p.z(), std::hypot(p.x(), p.y()) - 3);
                       return std::abs(angle) - half;
                     });
}

// Returns a circle around a vertex of a flat torus, as long as it does not meet itself.
inline Known_curve circle_on_flat_torus(std::size_t n, CGAL::Random& random)
{
  const int cells = static_cast<int>(n);
  const Flat_surface torus = flat_torus(cells, cells, 2);
  Known_curve result{"circle on a flat torus", triangulation(torus), {}, 1000};
  IT::make_Delaunay(result.t);
  const double radius = random.get_double(0.2, 0.35) * 900 * cells;
  const Vector center = torus.point[static_cast<std::size_t>(random.get_int(0, cells * cells))];
  for(const Vector& p : torus.point)
    result.distance.push_back(shortest_lift(p - center, torus) - radius);
  return result;
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_SURFACE_CURVES_H
