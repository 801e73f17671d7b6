// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hard_meshes.h"

namespace Test_surfaces {

bool is_free(const Point& p, const Mesh& mesh)
{
  return std::none_of(mesh.points().begin(), mesh.points().end(),
                      [&](const Point& q) { return CGAL::squared_distance(p, q) <= 1e-34; });
}

bool all_are_apart(const Mesh& mesh)
{
  return std::set<Point>(mesh.points().begin(), mesh.points().end()).size() ==
         mesh.number_of_vertices();
}

Halfedge_index split_edge_apart(Halfedge_index h, double t, Mesh& mesh)
{
  const Point p = between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), t);
  if(!is_free(p, mesh))
    return Mesh::null_halfedge();
  const Halfedge_index result = IT::split_edge(h, mesh);
  mesh.point(mesh.target(result)) = p;
  return result;
}

void split_face_apart(Halfedge_index h, const Point& p, Mesh& mesh)
{
  if(is_free(p, mesh))
    mesh.point(mesh.target(IT::split_face(h, mesh))) = p;
}

const Point& apex(Halfedge_index h, const Mesh& mesh)
{
  return mesh.point(mesh.target(mesh.next(h)));
}

Mesh turned_apart(const Mesh& mesh, Portable_random& random)
{
  const Mesh result = turned(mesh, random);
  return all_are_apart(result) ? result : mesh;
}

Mesh stretched_apart(const Mesh& mesh, double factor)
{
  const Mesh result = stretched_along_x(mesh, factor);
  return all_are_apart(result) ? result : mesh;
}

Mesh hard_base(Portable_random& random)
{
  const auto size = [&](double least, double greatest) {
    return static_cast<std::size_t>(log_uniform(least, greatest, random));
  };
  const auto in_plane = [](double x, double y) { return Point(x, y, 0); };
  const double height = random.get_double(0.1, 2), radius = random.get_double(0.3, 3);
  Mesh mesh;
  switch(random.get_int(0, 6)) {
    case 0: mesh = unit_sphere(size(2, 12)); break;
    case 1: mesh = embedded_torus(size(4, 30), size(4, 16)); break;
    case 2: mesh = frame(2, 1); break;
    case 3: mesh = grid(size(4, 24), size(4, 20), in_plane); break;
    case 4: mesh = tube(size(4, 20), size(3, 12), radius, 0, Tube_ends::open); break;
    default: mesh = bipyramid(size(16, 100), height); break;
  }
  if(toss(random))
    mesh = turned_apart(mesh, random);
  const auto last = static_cast<int>(mesh.number_of_faces()) - 1;
  if(CGAL::is_closed(mesh) && random.get_int(0, 3) == 0)
    mesh = punctured(mesh, {random_size(0, last, random)});
  return mesh;
}

std::vector<std::size_t> consecutive(std::size_t first, std::size_t n)
{
  std::vector<std::size_t> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = first + i;
  return result;
}

Mesh sliced_polygon(std::size_t sides, std::size_t n, double height, Portable_random& random)
{
  const double turn = 2 * std::acos(-1.) / static_cast<double>(sides);
  const auto corner = [&](std::size_t k) {
    const double angle = turn * static_cast<double>(k);
    return Point(std::cos(angle), std::sin(angle), 0);
  };
  std::vector<Point> points;
  for(std::size_t k = 0; k < sides; ++k) {
    points.push_back(corner(k));
    double t = 0;
    for(std::size_t i = 1; i < n; ++i)
      points.push_back(
        between(corner(k), corner(k + 1), t += log_uniform(1e-15, 0.9, random) * (1 - t)));
  }
  points.erase(std::unique(points.begin(), points.end(),
                           [](const Point& p, const Point& q) { return p == q; }),
               points.end());
  const std::size_t ring = points.size();
  Triangles triangles = random_ears(consecutive(0, ring), random);
  if(height > 0) {
    for(std::size_t i = 0, flat = triangles.size(); i < flat; ++i)
      triangles.push_back({ring + triangles[i][0], ring + triangles[i][2], ring + triangles[i][1]});
    for(std::size_t i = 0; i < ring; ++i) {
      const std::size_t next = (i + 1) % ring;
      points.push_back(points[i] - Kernel::Vector_3(0, 0, height));
      triangles.push_back({i, ring + i, ring + next});
      triangles.push_back({i, ring + next, next});
    }
  }
  return make_mesh(points, triangles);
}

Mesh saw_teeth(std::size_t columns, std::size_t rows, double tooth, bool is_closed,
               Portable_random& random)
{
  std::vector<Point> points;
  double x = 0;
  for(std::size_t i = 0; i < columns; ++i) {
    for(std::size_t j = 0; j <= rows; ++j)
      points.emplace_back(x, static_cast<double>(j) + (i % 2 == 1 ? tooth : 0), 0);
    x += log_uniform(1e-14, 1, random);
  }
  return make_mesh(points, lattice(is_closed ? columns : columns - 1, rows, is_closed));
}

void add_extreme_needles(Mesh& mesh, double part, Portable_random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random))
    split_edge_apart(h, log_uniform(1e-16, 1e-1, random), mesh);
}

Halfedge_index inner_side(Face_index f, const Mesh& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return !mesh.is_border(mesh.edge(h))              ? h
         : !mesh.is_border(mesh.edge(mesh.next(h))) ? mesh.next(h)
                                                    : mesh.prev(h);
}

void add_extreme_caps(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = inner_side(f, mesh);
    const Point on_side =
      between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), random.get_double(0.1, 0.9));
    split_face_apart(h, between(on_side, apex(h, mesh), log_uniform(1e-16, 1e-1, random)), mesh);
  }
}

void add_near_vertices(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = mesh.halfedge(f);
    const Point opposite =
      between(mesh.point(mesh.target(h)), apex(h, mesh), random.get_double(0.1, 0.9));
    split_face_apart(
      h, between(mesh.point(mesh.source(h)), opposite, log_uniform(1e-16, 1e-11, random)), mesh);
  }
}

void collapse_almost(Mesh& mesh, double part, Portable_random& random)
{
  for(Vertex_index v : random_part(mesh.vertices(), part, random)) {
    const Point& neighbor = mesh.point(mesh.source(mesh.halfedge(v)));
    const Point p = neighbor + log_uniform(1e-16, 1e-11, random) * random_direction(random);
    if(is_free(p, mesh))
      mesh.point(v) = p;
  }
}

void add_flat_faces(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = inner_side(f, mesh);
    split_face_apart(h, between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), 0.5), mesh);
  }
}

void add_cascades(Mesh& mesh, double part, Portable_random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random)) {
    const double ratio = log_uniform(1e-5, 0.5, random);
    Halfedge_index first = h;
    for(int i = 0; i < 12 && first.is_valid(); ++i)
      first = split_edge_apart(first, ratio, mesh);
  }
}

Mesh spoilt(void (*spoil)(Mesh&, double, Portable_random&), double least_part, double greatest_part,
            Portable_random& random)
{
  Mesh mesh = hard_base(random);
  spoil(mesh, random.get_double(least_part, greatest_part), random);
  return mesh;
}

Mesh extreme_needles(Portable_random& random)
{
  return spoilt(add_extreme_needles, 0.02, 0.2, random);
}

Mesh extreme_caps(Portable_random& random) { return spoilt(add_extreme_caps, 0.05, 0.8, random); }

Mesh near_vertices(Portable_random& random) { return spoilt(add_near_vertices, 0.05, 0.5, random); }

Mesh almost_collapsed(Portable_random& random)
{
  return spoilt(collapse_almost, 0.05, 0.4, random);
}

Mesh flat_faces(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  for(int i = 0; i < 3; ++i)
    add_flat_faces(mesh, 0.2, random);
  return mesh;
}

Mesh spoilt_twice(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  for(int i = 0; i < 2; ++i) {
    add_extreme_needles(mesh, 0.04, random);
    add_extreme_caps(mesh, 0.1, random);
    add_near_vertices(mesh, 0.05, random);
  }
  return mesh;
}

Mesh sliced_polygons(Portable_random& random)
{
  const std::size_t sides = random_size(3, 9, random), n = random_size(8, 40, random);
  const Mesh mesh =
    sliced_polygon(sides, n, toss(random) ? log_uniform(1e-3, 10, random) : 0, random);
  return stretched_apart(mesh, log_uniform(1, 1e2, random));
}

Mesh saw_tooth_strips(Portable_random& random)
{
  const std::size_t columns = random_size(6, 60, random), rows = random_size(2, 10, random);
  return saw_teeth(columns, rows, log_uniform(1e-3, 0.9, random), toss(random), random);
}

Mesh stretched_and_spoilt(Portable_random& random)
{
  Mesh mesh =
    stretched_apart(turned_apart(hard_base(random), random), log_uniform(1e-5, 1e2, random));
  add_extreme_needles(mesh, 0.04, random);
  add_extreme_caps(mesh, 0.1, random);
  return mesh;
}

Mesh close_cuts(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  cut_badly(mesh, 1e-15, random);
  return mesh;
}

Mesh spoilt_frames(Portable_random& random)
{
  Mesh mesh = frame(random_size(2, 4, random), log_uniform(1e-2, 1, random));
  add_extreme_needles(mesh, 0.1, random);
  add_near_vertices(mesh, 0.2, random);
  return mesh;
}

Named_mesh hard_mesh(std::uint64_t seed)
{
  Portable_random random(seed);
  const Hard_family& family = hard_families[seed % hard_families.size()];
  const Mesh mesh = family.make(random);
  return {family.name, toss(random) ? turned_apart(mesh, random) : mesh};
}

} // namespace Test_surfaces
