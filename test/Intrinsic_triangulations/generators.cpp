// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/convex_hull_3.h>

namespace Test_surfaces {

Mesh make_mesh(const std::vector<Point>& points, const Triangles& triangles)
{
  Mesh mesh;
  for(const Point& p : points)
    mesh.add_vertex(p);
  for(const auto& [a, b, c] : triangles)
    mesh.add_face(Vertex_index(static_cast<Mesh::size_type>(a)),
                  Vertex_index(static_cast<Mesh::size_type>(b)),
                  Vertex_index(static_cast<Mesh::size_type>(c)));
  return mesh;
}

Mesh tetrahedron()
{
  return make_mesh({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

Mesh octahedron()
{
  return make_mesh(
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

Mesh square()
{
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

Mesh cube()
{
  std::vector<Point> points;
  for(int i = 0; i < 8; ++i)
    points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  return make_mesh(points, {{0, 2, 1},
                            {1, 2, 3},
                            {4, 5, 6},
                            {5, 7, 6},
                            {0, 1, 4},
                            {1, 5, 4},
                            {2, 6, 3},
                            {3, 6, 7},
                            {0, 4, 2},
                            {2, 4, 6},
                            {1, 3, 5},
                            {3, 7, 5}});
}

Mesh convex_hull(const std::vector<Point>& points)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Hull_point;
  std::vector<Hull_point> hull_points;
  for(const Point& p : points)
    hull_points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Hull_point> hull;
  CGAL::convex_hull_3(hull_points.begin(), hull_points.end(), hull);
  return make_mesh(points, sorted_triangles(hull, hull_points));
}

Mesh random_sphere(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  while(points.size() < n) {
    const Kernel::Vector_3 v(random.get_double(-1, 1), random.get_double(-1, 1),
                             random.get_double(-1, 1));
    if(const double length = std::sqrt(v.squared_length()); length > 0.1)
      points.push_back(CGAL::ORIGIN + v / length);
  }
  return convex_hull(points);
}

Mesh bipyramid(std::size_t n, double height)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(n);
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  points.emplace_back(0, 0, height);
  points.emplace_back(0, 0, -height);
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    triangles.push_back({i, (i + 1) % n, n});
    triangles.push_back({(i + 1) % n, i, n + 1});
  }
  return make_mesh(points, triangles);
}

Triangles lattice(std::size_t m, std::size_t n, bool has_closed_columns, bool has_closed_rows)
{
  const std::size_t rows = has_closed_columns ? m : m + 1, columns = has_closed_rows ? n : n + 1;
  const auto at = [&](std::size_t i, std::size_t j) { return i % rows * columns + j % columns; };
  Triangles triangles;
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return triangles;
}

Mesh grid(std::size_t m, std::size_t n, const std::function<Point(double, double)>& place)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i <= m; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      points.push_back(place(static_cast<double>(i), static_cast<double>(j)));
  return make_mesh(points, lattice(m, n));
}

Mesh embedded_torus(std::size_t m, std::size_t n)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double s = 2 * pi * static_cast<double>(i) / static_cast<double>(m);
      const double t = 2 * pi * static_cast<double>(j) / static_cast<double>(n);
      const double radius = 3 + std::cos(t);
      points.emplace_back(radius * std::cos(s), radius * std::sin(s), std::sin(t));
    }
  return make_mesh(points, lattice(m, n, true, true));
}

Mesh perturbed(Mesh mesh, double amount, unsigned int seed)
{
  CGAL::Random random(seed);
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(random.get_double(-amount, amount),
                                                     random.get_double(-amount, amount),
                                                     random.get_double(-amount, amount));
  return mesh;
}

Mesh frame(std::size_t holes, double strut)
{
  const std::size_t columns = 2 * holes + 1;
  const auto is_solid = [&](std::size_t i, std::size_t j) { // from 1
    return i > 0 && i <= columns && j > 0 && j <= 3 && !(i % 2 == 0 && j == 2);
  };
  const auto index = [](std::size_t i, std::size_t j, std::size_t k) { return 8 * i + 2 * j + k; };
  const auto place = [&](std::size_t i) {
    return static_cast<double>(i / 2) + strut * static_cast<double>((i + 1) / 2);
  };
  std::vector<Point> points;
  for(std::size_t i = 0; i <= columns; ++i)
    for(std::size_t j = 0; j <= 3; ++j)
      for(std::size_t k = 0; k <= 1; ++k)
        points.emplace_back(place(i), place(j), strut * static_cast<double>(k));
  Triangles triangles;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  for(std::size_t i = 0; i < columns; ++i)
    for(std::size_t j = 0; j < 3; ++j) {
      if(!is_solid(i + 1, j + 1))
        continue;
      add(index(i, j, 1), index(i + 1, j, 1), index(i + 1, j + 1, 1), index(i, j + 1, 1));
      add(index(i, j, 0), index(i, j + 1, 0), index(i + 1, j + 1, 0), index(i + 1, j, 0));
      const auto add_side = [&](std::size_t i0, std::size_t j0, std::size_t i1, std::size_t j1) {
        add(index(i0, j0, 0), index(i1, j1, 0), index(i1, j1, 1), index(i0, j0, 1));
      };
      if(!is_solid(i + 1, j))
        add_side(i, j, i + 1, j);
      if(!is_solid(i + 2, j + 1))
        add_side(i + 1, j, i + 1, j + 1);
      if(!is_solid(i + 1, j + 2))
        add_side(i + 1, j + 1, i, j + 1);
      if(!is_solid(i, j + 1))
        add_side(i, j + 1, i, j);
    }
  return make_mesh(points, triangles);
}

Mesh straight_plate_with_holes(int genus) { return frame(static_cast<std::size_t>(genus), 1); }

Mesh plate_with_holes(int genus) { return perturbed(straight_plate_with_holes(genus), 0.1, 12); }

Mesh four_components()
{
  Mesh result = random_sphere(20, 8);
  result += tetrahedron();
  result.add_vertex(Point(9, 9, 9));
  result += perturbed(embedded_torus(5, 4), 0.3, 9);
  return result;
}

Mesh five_components()
{
  Mesh result = four_components();
  result += perturbed(grid(3, 3, [](double x, double y) { return Point(x, y, 0); }), 0.3, 4);
  return result;
}

Mesh punctured(Mesh mesh, const std::vector<std::size_t>& faces)
{
  Triangles rest;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    if(std::find(faces.begin(), faces.end(), f.idx()) == faces.end())
      rest.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return make_mesh({mesh.points().begin(), mesh.points().end()}, rest);
}

Halfedge_index halfedge_of(int side)
{
  return Halfedge_index(
    static_cast<Delta_complex::size_type>(side > 0 ? 2 * side - 2 : -2 * side - 1));
}

void close_border(Delta_complex& mesh)
{
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h)) {
      Halfedge_index x = mesh.opposite(h);
      while(!mesh.is_border(x))
        x = mesh.opposite(mesh.prev(x));
      mesh.set_next(h, x);
    }
}

void add_vertices(Delta_complex& mesh)
{
  for(Halfedge_index h : mesh.halfedges()) {
    if(mesh.target(h) != Delta_complex::null_vertex())
      continue;
    const Vertex_index v = mesh.add_vertex();
    mesh.set_halfedge(v, h);
    Halfedge_index x = h;
    do {
      mesh.set_target(x, v);
      if(mesh.is_border(x))
        mesh.set_halfedge(v, x);
      x = mesh.opposite(mesh.next(x));
    } while(x != h);
  }
}

Delta_complex glue(const Sides& faces)
{
  int edges = 0;
  for(const auto& face : faces)
    for(int side : face)
      edges = (std::max)(edges, std::abs(side));
  Delta_complex mesh;
  mesh.resize(0, static_cast<Delta_complex::size_type>(edges),
              static_cast<Delta_complex::size_type>(faces.size()));
  for(Face_index f : mesh.faces())
    for(std::size_t s = 0; s < 3; ++s) {
      const Halfedge_index h = halfedge_of(faces[f][s]);
      mesh.set_next(h, halfedge_of(faces[f][(s + 1) % 3]));
      mesh.set_face(h, f);
      mesh.set_halfedge(f, h);
    }
  close_border(mesh);
  add_vertices(mesh);
  return mesh;
}

Delta_complex cone(bool mirrored)
{
  return glue({mirrored ? std::array{-1, 1, 2} : std::array{1, -1, 2}});
}

Delta_complex double_torus()
{
  return glue({{1, 2, 5}, {-5, -1, 6}, {-6, -2, 7}, {-7, 3, 8}, {-8, 4, 9}, {-9, -3, -4}});
}

std::array<double, 3> random_coordinates(CGAL::Random& random)
{
  const double u = random.get_double(), v = random.get_double();
  return u + v > 1 ? std::array{u + v - 1, 1 - u, 1 - v} : std::array{1 - u - v, u, v};
}

Location random_location(const Delta_complex& mesh, CGAL::Random& random)
{
  const auto f = random_index<Face_index>(mesh.number_of_faces(), random);
  return {f, random_coordinates(random)};
}

Point place_in_space(const Location& p, const Delta_complex& mesh, const Mesh& positions)
{
  return place_in_space(p, mesh, [&](Vertex_index v) { return positions.point(v); });
}

Point place_in_space(const Location& p, const Mesh& mesh)
{
  return place_in_space(p, mesh, [&](Vertex_index v) { return mesh.point(v); });
}

std::vector<double> random_values(std::size_t n, double bound, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> result(n);
  for(double& x : result)
    x = random.get_double(-bound, bound);
  return result;
}

std::vector<double> random_lengths(const Delta_complex& mesh, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> result(mesh.number_of_edges());
  for(double& length : result)
    length = random.get_double(1, 1.9);
  return result;
}

std::complex<double> complex(const Vector& v)
{
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

Flat_surface flat_torus(int m, int n, unsigned int seed, const Vector& right, const Vector& up)
{
  CGAL::Random random(seed);
  std::vector<Vector> shift;
  for(int i = 0; i < m * n; ++i)
    shift.push_back({random.get_int(-140, 141), random.get_int(-140, 141)});
  const auto cell = [&](int i, int j) { return i % m * n + j % n; };
  const auto label = [&](int i, int j, int kind) { return 3 * cell(i, j) + kind; };
  const auto corner = [&](int i, int j) {
    return i * right + j * up + shift[static_cast<std::size_t>(cell(i, j))];
  };
  Sides sides;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      sides.push_back({label(i, j, 1), label(i + 1, j, 2), -label(i, j, 3)});
      sides.push_back({label(i, j, 3), -label(i, j + 1, 1), -label(i, j, 2)});
    }
  const auto place = [&](int edge) {
    const int i = (edge - 1) / 3 / n, j = (edge - 1) / 3 % n, kind = (edge - 1) % 3 + 1;
    return std::make_pair(corner(i, j), corner(i + (kind != 2), j + (kind != 1)));
  };
  return flat_surface(sides, place, m * right, n * up);
}

Flat_surface flat_cylinder(int n, int twists, int height)
{
  const std::int64_t width = 1000, shift = 300;
  const auto bottom = [&](int i) { return i % n * 4 + 1; };
  const auto top = [&](int i) { return i % n * 4 + 2; };
  const auto across = [&](int i) { return i % n * 4 + 3; };
  const auto diagonal = [&](int i) { return i % n * 4 + 4; };
  Sides sides;
  for(int i = 0; i < n; ++i) {
    sides.push_back({bottom(i), across(i + 1), -diagonal(i)});
    sides.push_back({diagonal(i), -top(i), -across(i)});
  }
  const auto place = [&](int edge) {
    const int i = (edge - 1) / 4, kind = (edge - 1) % 4 + 1;
    const Vector low{width * i, 0}, high{width * (i + n * twists) + shift, height}, step{width, 0};
    return kind == 1   ? std::make_pair(low, low + step)
           : kind == 2 ? std::make_pair(high, high + step)
           : kind == 3 ? std::make_pair(low, high)
                       : std::make_pair(low, high + step);
  };
  return flat_surface(sides, place, {width * n, 0}, {0, beyond});
}

double shortest_lift(const Vector& v, const Flat_surface& s)
{
  double result = std::numeric_limits<double>::infinity();
  for(int i = -2; i <= 2; ++i)
    for(int j = -2; j <= 2; ++j)
      result = (std::min)(result, length(v + i * s.a + j * s.b));
  return result;
}

Triangles swept_triangles(const std::vector<Vector>& points)
{
  const auto sees = [&](std::size_t p, std::size_t u, std::size_t v) {
    return det(points[v] - points[u], points[p] - points[u]) < 0;
  };
  std::vector<std::size_t> hull{0, 1, 2};
  if(sees(2, 0, 1))
    std::swap(hull[0], hull[1]);
  Triangles triangles{{hull[0], hull[1], hull[2]}};
  for(std::size_t p = 3; p < points.size(); ++p) {
    std::vector<std::size_t> wider;
    for(std::size_t i = 0; i < hull.size(); ++i) {
      const std::size_t before = hull[(i + hull.size() - 1) % hull.size()];
      const std::size_t u = hull[i], v = hull[(i + 1) % hull.size()];
      const bool sees_before = sees(p, before, u), sees_after = sees(p, u, v);
      if(!sees_before || !sees_after)
        wider.push_back(u);
      if(sees_after) {
        triangles.push_back({u, p, v});
        if(!sees_before)
          wider.push_back(p);
      }
    }
    hull = wider;
  }
  return triangles;
}

std::vector<Vector> random_points(std::size_t n, int size, unsigned int seed)
{
  CGAL::Random random(seed);
  std::map<int, int> y_of_x;
  while(y_of_x.size() < n)
    y_of_x.emplace(random.get_int(0, size), random.get_int(0, size));
  std::vector<Vector> points;
  for(const auto& [x, y] : y_of_x)
    points.push_back({x, y});
  return points;
}

Flat_surface flat_surface(const std::vector<Vector>& points, const Triangles& triangles)
{
  std::map<std::pair<std::size_t, std::size_t>, int> labels;
  std::vector<std::pair<Vector, Vector>> ends;
  const auto label = [&](std::size_t u, std::size_t v) {
    const auto [entry, is_new] =
      labels.emplace(std::minmax(u, v), static_cast<int>(labels.size()) + 1);
    if(is_new)
      ends.emplace_back(points[(std::min)(u, v)], points[(std::max)(u, v)]);
    return u < v ? entry->second : -entry->second;
  };
  Sides sides;
  for(const auto& [u, v, w] : triangles)
    sides.push_back({label(u, v), label(v, w), label(w, u)});
  return flat_surface(sides, [&](int edge) { return ends[static_cast<std::size_t>(edge - 1)]; },
                      {beyond, 0}, {0, beyond});
}

Flat_surface flat_polygon(const std::vector<Vector>& points)
{
  return flat_surface(points, swept_triangles(points));
}

Mesh planar_mesh(const std::vector<Vector>& points)
{
  std::vector<Point> placed;
  for(const Vector& p : points)
    placed.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y), 0);
  return make_mesh(placed, swept_triangles(points));
}

long double area_of_triangle(std::array<long double, 3> l)
{
  std::sort(l.begin(), l.end());
  const auto [c, b, a] = l;
  const long double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return std::sqrt((std::max)(0.L, product)) / 4;
}

double polygon_area(Face_index f, const Mesh& mesh)
{
  const Halfedge_index first = mesh.halfedge(f);
  const Point p = mesh.point(mesh.source(first));
  Kernel::Vector_3 sum(0, 0, 0);
  for(Halfedge_index h : CGAL::halfedges_around_face(first, mesh))
    sum = sum + CGAL::cross_product(mesh.point(mesh.source(h)) - p, mesh.point(mesh.target(h)) - p);
  return std::sqrt(sum.squared_length()) / 2;
}

bool has_border(const Delta_complex& mesh)
{
  const auto h = mesh.halfedges();
  return std::any_of(h.begin(), h.end(), [&](Halfedge_index x) { return mesh.is_border(x); });
}

std::size_t border_loops(const Delta_complex& mesh)
{
  std::set<Halfedge_index> seen;
  std::size_t loops = 0;
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) && seen.count(h) == 0) {
      ++loops;
      for(Halfedge_index x = h; seen.insert(x).second;)
        x = mesh.next(x);
    }
  return loops;
}

std::vector<Named_mesh> meshes()
{
  const auto in_plane = [](double x, double y) { return Point(x, y, 0); };
  return {{"tetrahedron", tetrahedron()},
          {"octahedron", octahedron()},
          {"cube", cube()},
          {"random sphere", random_sphere(40, 1)},
          {"bipyramid", bipyramid(30, 0.5)},
          {"double disk", perturbed(bipyramid(7, 0), 0.2, 2)},
          {"torus", embedded_torus(5, 4)},
          {"rough torus", perturbed(embedded_torus(6, 5), 0.4, 3)},
          {"grid", perturbed(grid(4, 3, in_plane), 0.3, 4)},
          {"polygon", planar_mesh(random_points(25, 1000, 5))},
          {"sphere with three holes", punctured(random_sphere(40, 6), {0, 20, 50})},
          {"torus with a hole", punctured(embedded_torus(5, 4), {7})}};
}

std::vector<Named_complex> glued_complexes()
{
  return {{"triangle", glue({{1, 2, 3}})}, {"pillow", glue({{1, 2, 3}, {-3, -2, -1}})},
          {"cone", cone(false)},           {"mirrored cone", cone(true)},
          {"spindle", spindle()},          {"bigon", bigon()},
          {"double torus", double_torus()}};
}

std::vector<Named_complex> complexes()
{
  std::vector<Named_complex> result;
  for(const Named_mesh& m : meshes())
    result.push_back({m.name, IT::Intrinsic_triangulation<>(m.mesh).mesh()});
  for(const Named_complex& c : glued_complexes())
    result.push_back(c);
  result.push_back({"torus with one vertex", flat_torus(1, 1, 0).mesh});
  result.push_back({"torus with two vertices", flat_torus(2, 1, 0).mesh});
  result.push_back({"annulus with two vertices", flat_cylinder(1, 0).mesh});
  result.push_back({"annulus", flat_cylinder(4, 0).mesh});
  return result;
}

std::vector<std::string> data_meshes(std::uintmax_t largest_file)
{
  std::vector<std::string> result;
  std::error_code none_there;
  for(const auto& file :
      std::filesystem::directory_iterator(CGAL::data_file_path("meshes"), none_there))
    if(file.path().extension() == ".off" && file.file_size() <= largest_file)
      result.push_back(file.path().string());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace Test_surfaces
