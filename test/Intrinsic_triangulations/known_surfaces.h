// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_KNOWN_SURFACES_H
#define INTRINSIC_TRIANGULATIONS_TEST_KNOWN_SURFACES_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

// This file generates surfaces whose geodesics have formulas.
namespace Test_surfaces {

using Complex = std::complex<double>;

Complex random_vector(double length, CGAL::Random& random);

// ---- The plane, or the plane modulo a lattice ----

class Flat_places
{
public:
  Flat_places(Side side, const Flat_triangulation& flat)
    : m_side(side), m_flat(flat), m_faces(side, *flat)
  {}

  const Flat_faces& faces() const { return m_faces; }

  Complex vector(Halfedge_index h) const
  {
    return complex(m_side == Side::input ? m_flat.input_vector(h) : m_flat.vector(h));
  }

  Complex place(const Location& p) const
  {
    const auto h = m_faces.sides(p.first);
    return complex(m_flat.surface().point[m_faces.mesh().source(h[0])]) +
           p.second[1] * vector(h[0]) - p.second[2] * vector(h[2]);
  }

  // Returns the rotation of vectors from the frame of a face to the plane.
  Complex frame(Face_index f) const
  {
    const Complex axis = vector(m_faces.sides(f)[0]);
    return axis / std::abs(axis);
  }

  double distance(const Complex& p, const Complex& q) const
  {
    const auto det = [](const Complex& v, const Complex& w) { return (std::conj(v) * w).imag(); };
    const Complex d = p - q, a = complex(m_flat.surface().a), b = complex(m_flat.surface().b);
    return std::abs(d - std::round(det(d, b) / det(a, b)) * a -
                    std::round(det(a, d) / det(a, b)) * b);
  }

private:
  Side m_side;
  const Flat_triangulation& m_flat;
  Flat_faces m_faces;
};

// ---- A cone ----

// Represents n triangles around an apex, which is vertex 0, with these angles and long legs.
struct Cone
{
  explicit Cone(const std::vector<double>& angles)
  {
    const int n = static_cast<int>(angles.size());
    Sides sides;
    std::vector<double> lengths(angles.size(), leg);
    for(int i = 0; i < n; ++i) {
      sides.push_back({i + 1, n + i + 1, -((i + 1) % n + 1)});
      lengths.push_back(2 * leg * std::sin(angles[static_cast<std::size_t>(i)] / 2));
    }
    for(double a : angles)
      total += a;
    mesh = triangulation(glue(sides), lengths);
    apex = mesh.input_mesh().source(halfedge_of(1));
  }

  Halfedge_index outgoing(Face_index f) const
  {
    for(Halfedge_index h : Flat_faces(Side::input, mesh).sides(f))
      if(mesh.input_mesh().source(h) == apex)
        return h;
    return {};
  }

  // Returns the distance and the angle (on the surface) from the apex.
  Complex polar(const Location& p) const
  {
    const Complex v = IT::logarithm(mesh.input(), outgoing(p.first), p);
    return {std::abs(v), std::arg(v) / (2 * pi) * total};
  }

  // Returns the unit vector away from the apex, in the frame of the face.
  Complex outwards(const Location& p) const
  {
    const Location tip = Flat_faces(Side::input, mesh).on(outgoing(p.first), 0);
    const Complex v = IT::logarithm(mesh.input(), tip, p);
    return v / std::abs(v);
  }

  static constexpr double leg = 10;
  Triangulation mesh;
  Vertex_index apex;
  double total = 0;
};

std::vector<Cone> cones();

// ---- Points of surfaces in space ----

std::array<Point, 3> corners(Face_index f, const Mesh& mesh);

// Returns the location of a point in the first face that contains it.
Location locate(const Point& p, const Mesh& mesh);

// ---- All triangulations ----

void check_all(void (&check)(Side, const Triangulation&));

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_KNOWN_SURFACES_H
