// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RESTING_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RESTING_POINTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the apex of a triangle over a side from 0 to `side`, above the x-axis. In a triangle that
// is almost flat, lengths of type `double` determine half of the digits of the height.
inline std::complex<double> apex_over(const Double_double& side, const Double_double& from_source,
                                      const Double_double& from_target)
{
  const Double_double x = (side + scaled_foot(from_target, from_source) / side) / 2,
                      y = quadrupled_area(side, from_source, from_target) / (2 * side);
  return {x.high(), y.high()};
}

// Stores barycentric coordinates of a point, which are best in the triangle with the greatest least
// coordinate.
struct Coordinates_in_triangle
{
  std::array<double, 3> coordinates;
  double least;

  // If the triangle has no area, the point is moved to the longest side.
  Coordinates_in_triangle(const std::complex<double>& p,
                          const std::array<std::complex<double>, 3>& q)
  {
    const double area = cross(q[1] - q[0], q[2] - q[0]),
                 size = norm(q[1] - q[0]) + norm(q[2] - q[0]);
    for(std::size_t c = 0; c < 3; ++c)
      coordinates[c] = cross(q[(c + 1) % 3] - p, q[(c + 2) % 3] - p) / area;
    least = area > least_area * size ? (std::min)({coordinates[0], coordinates[1], coordinates[2]})
                                     : -std::numeric_limits<double>::infinity();
    if(!(area > least_known_area * size))
      coordinates = on_longest_side(p, q);
  }

private:
  // Up to the first number, the least coordinate is not known. Up to the second one, the area is an
  // effect of rounding.
  static constexpr double least_area = 1e-7, least_known_area = 0x1p-48;

  static std::array<double, 3> on_longest_side(const std::complex<double>& p,
                                               const std::array<std::complex<double>, 3>& q)
  {
    std::size_t longest = 0;
    const auto side = [&](std::size_t s) { return q[(s + 1) % 3] - q[s]; };
    for(std::size_t s = 1; s < 3; ++s)
      if(norm(side(s)) > norm(side(longest)))
        longest = s;
    const double t = std::clamp(((p - q[longest]) / side(longest)).real(), 0., 1.);
    std::array<double, 3> result{0, 0, 0};
    result[longest] = 1 - t;
    result[(longest + 1) % 3] = t;
    return result;
  }
};

// Stores points on a surface that keep their positions when its edges are flipped. Coordinates are
// relative to a face, beginning with the source of its halfedge.
class Resting_points
{
public:
  struct Point
  {
    std::size_t number; // given by the owner
    std::array<double, 3> coordinates;
  };

  // Returns the points in the face `f`.
  const std::vector<Point>& in_face(Face_index f) const
  {
    static const std::vector<Point> none;
    return f.idx() < m_points.size() ? m_points[f.idx()] : none;
  }

  void add(Face_index f, const Point& point)
  {
    if(f.idx() >= m_points.size())
      m_points.resize(f.idx() + 1);
    m_points[f.idx()].push_back(point);
  }

  // Moves the points of the two faces at the edge of `h` to the new faces after its flip.
  void before_flip(Halfedge_index h, const Diamond<Double_double>& length,
                   const Delta_complex& mesh)
  {
    const Halfedge_index o = opposite(h);
    const Face_index f = mesh.face(h), g = mesh.face(o);
    if(in_face(f).empty() && in_face(g).empty())
      return;
    const Complex i(0), j(length.ij.high()), k = apex_over(length.ij, length.ki, length.jk),
                                             l = conj(apex_over(length.ij, length.il, length.lj));
    Placed placed;
    take(h, {i, j, k}, mesh, placed);
    take(o, {j, i, l}, mesh, placed);
    for(const auto& [number, p] : placed) {
      const Coordinates_in_triangle left(p, {l, k, i}), right(p, {k, l, j}); // `h` leads to k then
      if(left.least >= right.least)
        add(f, {number, left.coordinates});
      else
        add(g, {number, right.coordinates});
    }
  }

  // Moves the points of the three faces around a vertex to the face that replaces them, and lets
  // the vertex rest in it. `outgoing` are its edges, counterclockwise, with their lengths, and
  // `side` are the lengths of the edges between their ends. Returns the points; the face has the
  // ends as corners in this order.
  std::vector<Point> before_removal(std::size_t number,
                                    const std::array<Halfedge_index, 3>& outgoing,
                                    const std::array<Double_double, 3>& outgoing_length,
                                    const std::array<Double_double, 3>& side,
                                    const Delta_complex& mesh)
  {
    const std::array<Complex, 3> corner{0, side[0].high(), apex_over(side[0], side[2], side[1])};
    const Complex center = apex_over(side[0], outgoing_length[0], outgoing_length[1]);
    Placed placed{{number, center}};
    for(std::size_t s = 0; s < 3; ++s)
      take(outgoing[s], {center, corner[s], corner[(s + 1) % 3]}, mesh, placed);
    std::vector<Point> result;
    for(const auto& [n, p] : placed)
      result.push_back({n, Coordinates_in_triangle(p, corner).coordinates});
    return result;
  }

private:
  typedef std::complex<double> Complex;
  typedef std::vector<std::pair<std::size_t, Complex>> Placed;

  // Removes the points of the face of `h` and adds them to `placed`. The face has these corners,
  // the source of `h` first.
  void take(Halfedge_index h, const std::array<Complex, 3>& corner, const Delta_complex& mesh,
            Placed& placed)
  {
    const Face_index f = mesh.face(h);
    if(in_face(f).empty())
      return;
    const std::size_t shift = mesh.halfedge(f) == h ? 0 : mesh.next(mesh.halfedge(f)) == h ? 1 : 2;
    for(const Point& p : std::exchange(m_points[f.idx()], {})) {
      Complex position(0);
      for(std::size_t c = 0; c < 3; ++c)
        position += p.coordinates[(c + shift) % 3] * corner[c];
      placed.emplace_back(p.number, position);
    }
  }

  std::vector<std::vector<Point>> m_points; // of each face
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_RESTING_POINTS_H
