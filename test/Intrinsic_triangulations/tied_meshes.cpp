// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tied_meshes.h"

namespace Test_surfaces {

std::int64_t dot(const Integer_vector& v, const Integer_vector& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

std::array<Integer_vector, 3> integer_axes(const std::array<std::int64_t, 4>& q)
{
  const auto [a, b, c, d] = q;
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
           {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
           {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}};
}

std::array<Integer_vector, 3> random_axes(int size, Portable_random& random)
{
  std::array<std::int64_t, 4> q;
  for(std::int64_t& x : q)
    x = random.get_int(1, size);
  return integer_axes(q);
}

Point at(const std::array<Integer_vector, 3>& axes, const Integer_vector& place)
{
  std::array<double, 3> p;
  for(std::size_t k = 0; k < 3; ++k)
    p[k] =
      static_cast<double>(place[0] * axes[0][k] + place[1] * axes[1][k] + place[2] * axes[2][k]);
  return {p[0], p[1], p[2]};
}

Mesh on_lattice(Mesh mesh, const std::array<Integer_vector, 3>& axes)
{
  const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
  for(Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    mesh.point(v) = at(axes, {whole(p.x()), whole(p.y()), whole(p.z())});
  }
  return mesh;
}

std::vector<Vector> points_on_circle(std::int64_t radius)
{
  std::vector<Vector> quadrant, result;
  for(std::int64_t x = radius; x > 0; --x) {
    const std::int64_t square = radius * radius - x * x;
    const std::int64_t y = std::llround(std::sqrt(static_cast<double>(square)));
    if(y * y == square)
      quadrant.push_back({x, y});
  }
  for(int turns = 0; turns < 4; ++turns)
    for(Vector& v : quadrant) {
      result.push_back(v);
      v = {-v.y, v.x};
    }
  return result;
}

std::vector<Vector> almost_regular_polygon(std::size_t n)
{
  const std::vector<Vector> all = points_on_circle(1105);
  std::vector<Vector> result;
  for(std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * std::acos(-1.) * static_cast<double>(k) / static_cast<double>(n);
    const auto along = [&](const Vector& v) {
      return static_cast<double>(v.x) * std::cos(angle) +
             static_cast<double>(v.y) * std::sin(angle);
    };
    result.push_back(
      *std::max_element(all.begin(), all.end(),
                        [&](const Vector& v, const Vector& w) { return along(v) < along(w); }));
  }
  return result;
}

void add_fan(std::size_t first, std::size_t n, Triangles& triangles)
{
  for(std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({first, first + i, first + i + 1});
}

void append(Triangles& triangles, const Triangles& more)
{
  triangles.insert(triangles.end(), more.begin(), more.end());
}

Tied_mesh tied_grid(std::size_t m, std::size_t n, Portable_random& random)
{
  const Mesh mesh = grid(m, n, [](double x, double y) { return Point(x, y, 0); });
  return {"grid", on_lattice(mesh, random_axes(100, random)), m * n};
}

Tied_mesh exact_rectangle(Portable_random& random)
{
  const auto axes = random_axes(1 << 6, random);
  const std::int64_t p = random.get_int(1 << 12, 1 << 14), q = random.get_int(1 << 12, 1 << 14);
  const Mesh mesh =
    make_mesh({at(axes, {0, 0, 0}), at(axes, {p, 0, 0}), at(axes, {p, q, 0}), at(axes, {0, q, 0})},
              {{0, 1, 2}, {0, 2, 3}});
  return {"rectangle", mesh, 1};
}

Tied_mesh tied_box(const std::array<int, 3>& size, Portable_random& random)
{
  std::map<std::array<int, 3>, std::size_t> numbers;
  std::vector<Point> points;
  Triangles triangles;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto [entry, is_new] = numbers.emplace(p, points.size());
    if(is_new)
      points.emplace_back(p[0], p[1], p[2]);
    return entry->second;
  };
  std::size_t ties = 0;
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const bool is_upper : {false, true}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for(int i = 0; i < size[u]; ++i)
        for(int j = 0; j < size[v]; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> p;
            p[axis] = is_upper ? size[axis] : 0;
            p[u] = i + (is_upper ? di : dj);
            p[v] = j + (is_upper ? dj : di);
            return number(p);
          };
          append(triangles,
                 random_ears({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, random));
          ++ties;
        }
    }
  return {"box", on_lattice(make_mesh(points, triangles), random_axes(100, random)), ties};
}

Tied_mesh tied_fan(std::size_t n, Portable_random& random)
{
  std::vector<Point> points;
  const auto axes = random_axes(30, random);
  for(const Vector& v : almost_regular_polygon(n))
    points.push_back(at(axes, {v.x, v.y, 0}));
  Triangles triangles;
  add_fan(0, n, triangles);
  return {"fan", make_mesh(points, triangles), n - 3};
}

Tied_mesh tied_prism(std::size_t n, std::int64_t height, Portable_random& random)
{
  const auto axes = random_axes(30, random);
  std::vector<Point> points;
  Triangles triangles;
  for(const std::int64_t z : {height, std::int64_t(0)})
    for(const Vector& v : almost_regular_polygon(n))
      points.push_back(at(axes, {v.x, v.y, z}));
  add_fan(0, n, triangles);
  for(const auto& [a, b, c] : random_ears(consecutive(n, n), random))
    triangles.push_back({a, c, b});
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    append(triangles, random_ears({i, n + i, n + next, next}, random));
  }
  return {"prism", make_mesh(points, triangles), 3 * n - 6};
}

Tied_mesh tied_pyramid(std::size_t n, std::int64_t height, Portable_random& random)
{
  const auto axes = random_axes(30, random);
  std::vector<Point> points;
  for(const Vector& v : almost_regular_polygon(n))
    points.push_back(at(axes, {v.x, v.y, 0}));
  points.push_back(at(axes, {0, 0, height}));
  Triangles triangles;
  for(const auto& [a, b, c] : random_ears(consecutive(0, n), random))
    triangles.push_back({a, c, b});
  for(std::size_t i = 0; i < n; ++i)
    triangles.push_back({i, (i + 1) % n, n});
  return {"pyramid", make_mesh(points, triangles), n - 3};
}

Tied_mesh mirrored_strip(std::size_t n, Portable_random& random)
{
  constexpr int unit = 1 << 16;
  std::vector<Point> points;
  Triangles triangles;
  double y = 0, z = 0;
  for(std::size_t i = 0; i <= n; ++i) {
    const double x = random.get_int(8 * unit, 12 * unit);
    for(const int side : {-1, 1})
      points.emplace_back(side * x, y, z);
    y += random.get_int(18 * unit, 22 * unit);
    z += random.get_int(-8 * unit, 8 * unit);
    if(i == n)
      break;
    const std::size_t k = 2 * i;
    append(triangles, random_ears({k, k + 1, k + 3, k + 2}, random));
  }
  for(std::size_t i = 0; i < n; ++i)
    for(const std::size_t side : {0u, 1u}) {
      const std::size_t a = 2 * i + side, b = a + 2;
      const Point middle = CGAL::midpoint(points[a], points[b]);
      const double out = random.get_int(16 * unit, 24 * unit);
      points.emplace_back(middle.x() + (side == 0 ? -out : out), std::floor(middle.y()),
                          std::floor(middle.z()));
      const std::size_t c = points.size() - 1;
      side == 0 ? triangles.push_back({a, b, c}) : triangles.push_back({b, a, c});
    }
  return {"mirrored strip", make_mesh(points, triangles), n};
}

Tied_mesh tied_mesh(std::uint64_t seed)
{
  Portable_random random(seed);
  const auto size = [&](int least, int greatest) { return random_size(least, greatest, random); };
  const auto side = [&] { return random.get_int(1, 7); };
  const std::int64_t height = random.get_int(200, 3000);
  switch(seed % 7) {
    case 0: return tied_grid(size(1, 12), size(1, 12), random);
    case 1: return exact_rectangle(random);
    case 2: return tied_box({side(), side(), side()}, random);
    case 3: return tied_fan(size(5, 24), random);
    case 4: return tied_prism(size(5, 24), height, random);
    case 5: return tied_pyramid(size(5, 24), height, random);
    default: return mirrored_strip(size(1, 30), random);
  }
}

} // namespace Test_surfaces
