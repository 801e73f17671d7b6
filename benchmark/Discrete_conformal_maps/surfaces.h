// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_BENCHMARK_SURFACES_H
#define DISCRETE_CONFORMAL_MAPS_BENCHMARK_SURFACES_H

// This file generates surfaces of any size.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Returns an m times n grid over the torus; `place` maps the angles to points.
template <typename Place>
Mesh torus(unsigned m, unsigned n, const Place& place)
{
  Mesh mesh;
  mesh.reserve(m * n, 3 * m * n, 2 * m * n);
  for(unsigned i = 0; i < m; ++i)
    for(unsigned j = 0; j < n; ++j)
      mesh.add_vertex(place(2 * CGAL_PI * i / m, 2 * CGAL_PI * j / n));
  const auto vertex = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(i % m * n + j % n); };
  for(unsigned i = 0; i < m; ++i)
    for(unsigned j = 0; j < n; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

// Returns a torus with about so many vertices, with bumps.
inline Mesh torus(unsigned vertices)
{
  const auto n = static_cast<unsigned>(std::sqrt(vertices / 3.));
  return torus(3 * n, n, [](double s, double t) {
    const double r = 1 + 0.2 * std::sin(5 * s) * std::cos(3 * t);
    return Point((3 + r * std::cos(t)) * std::cos(s), (3 + r * std::cos(t)) * std::sin(s),
                 r * std::sin(t));
  });
}

// Generates the sides of a cube, n times n squares each, projected to a sphere with bumps.
class Sphere
{
public:
  explicit Sphere(unsigned vertices) : m_size(static_cast<unsigned>(std::sqrt(vertices / 6.)))
  {
    m_number.assign((m_size + 1) * (m_size + 1) * 6, Mesh::null_vertex());
    for(unsigned side = 0; side < 6; ++side)
      for(unsigned i = 0; i < m_size; ++i)
        for(unsigned j = 0; j < m_size; ++j)
          add_square(side, i, j);
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  typedef std::array<unsigned, 3> Place; // on the surface of a cube of `m_size` steps

  Place place(unsigned side, unsigned i, unsigned j) const
  {
    const unsigned axis = side / 2;
    Place p{};
    p[axis] = side % 2 == 0 ? 0 : m_size;
    p[(axis + 1) % 3] = side % 2 == 0 ? j : i;
    p[(axis + 2) % 3] = side % 2 == 0 ? i : j;
    return p;
  }

  Mesh::Vertex_index vertex(unsigned side, unsigned i, unsigned j)
  {
    const Place p = place(side, i, j);
    // The loop finds the first side that contains the position.
    unsigned first = 0;
    while(p[first / 2] != (first % 2 == 0 ? 0 : m_size))
      ++first;
    Mesh::Vertex_index& v =
      m_number[(first * (m_size + 1) + p[(first / 2 + 1) % 3]) * (m_size + 1) +
               p[(first / 2 + 2) % 3]];
    if(v == Mesh::null_vertex())
      v = m_mesh.add_vertex(blown_up(p));
    return v;
  }

  Point blown_up(const Place& p) const
  {
    std::array<double, 3> x;
    for(unsigned k = 0; k < 3; ++k)
      x[k] = std::tan(CGAL_PI / 4 * (2. * p[k] / m_size - 1));
    const double norm = std::hypot(x[0], x[1], x[2]);
    const double r = (1 + 0.1 * std::sin(9 * x[0] / norm) * std::sin(8 * x[1] / norm)) / norm;
    return Point(r * x[0], r * x[1], r * x[2]);
  }

  void add_square(unsigned side, unsigned i, unsigned j)
  {
    const auto a = vertex(side, i, j), b = vertex(side, i + 1, j), c = vertex(side, i + 1, j + 1),
               d = vertex(side, i, j + 1);
    m_mesh.add_face(a, b, c);
    m_mesh.add_face(a, c, d);
  }

  unsigned m_size;
  std::vector<Mesh::Vertex_index> m_number;
  Mesh m_mesh;
};

// Generates a surface of genus two: a distorted plate with two square holes, made of small cubes.
class Plate
{
public:
  // The plate has 50 n^2 squares for sides of n cubes.
  explicit Plate(unsigned vertices) : m_size(static_cast<int>(std::sqrt(vertices / 50.)))
  {
    const int n = m_size;
    for(int x = 0; x < 5 * n; ++x)
      for(int y = 0; y < 3 * n; ++y)
        for(int z = 0; z < n; ++z)
          if(is_full({x, y, z}))
            for(unsigned axis = 0; axis < 3; ++axis)
              for(int side : {0, 1})
                add_side({x, y, z}, axis, side);
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  typedef std::array<int, 3> Place;

  bool is_full(const Place& p) const
  {
    const int x = p[0], y = p[1], z = p[2], n = m_size;
    return x >= 0 && x < 5 * n && y >= 0 && y < 3 * n && z >= 0 && z < n &&
           !(x / n % 2 == 1 && y / n == 1);
  }

  Mesh::Vertex_index vertex(const Place& p)
  {
    const auto [entry, is_new] = m_vertex.emplace(p, Mesh::null_vertex());
    if(is_new) {
      const double x = double(p[0]) / m_size, y = double(p[1]) / m_size, z = double(p[2]) / m_size;
      entry->second = m_mesh.add_vertex(Point(x + 0.1 * std::sin(3 * y), y + 0.1 * std::sin(4 * x),
                                              z + 0.1 * std::sin(5 * x) * std::cos(4 * y)));
    }
    return entry->second;
  }

  void add_side(const Place& cube, unsigned axis, int side)
  {
    Place beyond = cube, a = cube;
    beyond[axis] += 2 * side - 1;
    if(is_full(beyond))
      return;
    a[axis] += side;
    Place b = a, c = a, d = a;
    const unsigned s = (axis + 2 - unsigned(side)) % 3, t = (axis + 1 + unsigned(side)) % 3;
    ++b[s], ++c[s], ++c[t], ++d[t];
    m_mesh.add_face(vertex(a), vertex(b), vertex(c));
    m_mesh.add_face(vertex(a), vertex(c), vertex(d));
  }

  int m_size;
  std::map<Place, Mesh::Vertex_index> m_vertex;
  Mesh m_mesh;
};

#endif // DISCRETE_CONFORMAL_MAPS_BENCHMARK_SURFACES_H
