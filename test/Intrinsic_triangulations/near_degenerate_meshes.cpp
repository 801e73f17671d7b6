// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "near_degenerate_meshes.h"

namespace Test_surfaces {

unsigned int random_seed(CGAL::Random& random)
{
  return static_cast<unsigned int>(random.get_int(0, 1 << 30));
}

Mesh good_mesh(CGAL::Random& random)
{
  const auto in_plane = [](double x, double y) { return Point(x, y, 0); };
  const auto size = [&](int least, int greatest) { return random_size(least, greatest, random); };
  Mesh mesh;
  switch(random.get_int(0, 5)) {
    case 0: mesh = unit_sphere(size(2, 4)); break;
    case 1: mesh = embedded_torus(size(4, 8), size(4, 7)); break;
    case 2: mesh = frame(size(1, 3), 1); break;
    case 3: mesh = grid(size(5, 8), size(4, 7), in_plane); break;
    default: mesh = bipyramid(size(20, 50), random.get_double(0.1, 2)); break;
  }
  if(toss(random))
    mesh = perturbed(mesh, 0.02, random_seed(random));
  if(CGAL::is_closed(mesh) && random.get_int(0, 3) == 0)
    mesh = punctured(mesh, {random_size(0, static_cast<int>(mesh.number_of_faces()) - 1, random)});
  return mesh;
}

void split_edge_at(Halfedge_index h, double t, Mesh& mesh)
{
  const Point p = between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), t);
  mesh.point(mesh.target(IT::split_edge(h, mesh))) = p;
}

void add_needles(Mesh& mesh, double width, double part, CGAL::Random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random))
    split_edge_at(h, log_uniform(width, 1e-1, random), mesh);
}

void add_caps(Mesh& mesh, double height, double part, CGAL::Random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = mesh.halfedge(f);
    const Point on_side =
      between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), random.get_double(0.1, 0.9));
    const Point p =
      between(on_side, mesh.point(mesh.target(mesh.next(h))), log_uniform(height, 1e-1, random));
    mesh.point(mesh.target(IT::split_face(h, mesh))) = p;
  }
}

Mesh stretched_along_x(Mesh mesh, double factor)
{
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return mesh;
}

Mesh tube(std::size_t rings, std::size_t n, double radius, std::size_t twist, Tube_ends ends)
{
  const double turn = 2 * std::acos(-1.), whole = static_cast<double>(rings);
  const bool is_joined = ends == Tube_ends::joined;
  std::vector<Point> points;
  Triangles triangles;
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double s = turn * static_cast<double>(i) / whole;
      const double t = turn * static_cast<double>(j) / static_cast<double>(n);
      const double out = whole / turn + radius * std::cos(t), up = radius * std::sin(t);
      points.push_back(is_joined ? Point(out * std::cos(s), out * std::sin(s), up)
                                 : Point(radius * std::cos(t), -static_cast<double>(i), up));
      const std::size_t next = (i + 1) % rings, j_next = j + twist;
      const std::size_t k = i * n + j, l = next * n + j_next % n;
      const std::size_t k_up = i * n + (j + 1) % n, l_up = next * n + (j_next + 1) % n;
      if(next != 0 || is_joined) {
        triangles.push_back({k, l, l_up});
        triangles.push_back({k, l_up, k_up});
      }
    }
  if(ends == Tube_ends::capped) {
    points.emplace_back(0, radius, 0);
    points.emplace_back(0, 1 - whole - radius, 0);
    for(std::size_t j = 0; j < n; ++j) {
      const std::size_t j_next = (j + 1) % n, last = (rings - 1) * n;
      triangles.push_back({j, j_next, rings * n});
      triangles.push_back({last + j_next, last + j, rings * n + 1});
    }
  }
  return make_mesh(points, triangles);
}

Mesh fan_prism(std::size_t n, double flatness, double height, bool is_open)
{
  std::vector<Point> points;
  for(int level = 0; level < 2; ++level)
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(n);
      points.emplace_back(std::cos(angle), flatness * std::sin(angle), level * height);
    }
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    triangles.push_back({i, next, n + next});
    triangles.push_back({i, n + next, n + i});
    if(i == 0 || next == 0)
      continue;
    triangles.push_back({0, next, i});
    if(!is_open)
      triangles.push_back({n, n + i, n + next});
  }
  return make_mesh(points, triangles);
}

Mesh needles(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_needles(mesh, 1e-9, random.get_double(0.05, 0.3), random);
  return mesh;
}

Mesh caps(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_caps(mesh, 1e-9, random.get_double(0.1, 1), random);
  return mesh;
}

Mesh needles_and_caps(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_needles(mesh, 1e-5, 0.1, random);
  add_caps(mesh, 1e-4, 0.3, random);
  return mesh;
}

Mesh polygon_fans(CGAL::Random& random)
{
  const std::size_t n = random_size(12, 150, random);
  const double flatness = log_uniform(1e-4, 1, random), height = log_uniform(1e-3, 10, random);
  return fan_prism(n, flatness, height, toss(random));
}

Mesh edge_fans(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_fans(mesh, random);
  return mesh;
}

Mesh stretched_meshes(CGAL::Random& random)
{
  return stretched_along_x(turned(good_mesh(random), random), log_uniform(10, 1e5, random));
}

Mesh thin_tubes(CGAL::Random& random)
{
  const std::size_t n = random_size(3, 8, random), twist = random_size(0, 5, random);
  const auto ends = static_cast<Tube_ends>(random.get_int(0, 3));
  return tube(random_size(9, 30, random), n, log_uniform(1e-6, 1e-1, random), twist, ends);
}

Mesh wire_frames(CGAL::Random& random)
{
  return frame(random_size(1, 6, random), log_uniform(1e-6, 1e-1, random));
}

Mesh boolean_slivers(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  for(int i = 0; i < 2; ++i)
    cut_badly(mesh, 1e-9, random);
  return mesh;
}

Mesh near_coincident_vertices(CGAL::Random& random)
{
  return with_near_coincident_vertices(good_mesh(random), log_uniform(1e-9, 1e-2, random),
                                       random_seed(random));
}

Mesh swept_polygons(CGAL::Random& random)
{
  return planar_mesh(random_points(random_size(30, 300, random), 1 << 18, random_seed(random)));
}

Mesh stretched_slivers(CGAL::Random& random)
{
  Mesh mesh = turned(good_mesh(random), random);
  cut_badly(mesh, 1e-6, random);
  return stretched_along_x(mesh, log_uniform(10, 1e4, random));
}

Named_mesh near_degenerate_mesh(unsigned int seed)
{
  CGAL::Random random(seed);
  const Mesh_family& family = near_degenerate_families[seed % near_degenerate_families.size()];
  Mesh mesh = family.make(random);
  return {family.name, toss(random) ? turned(std::move(mesh), random) : std::move(mesh)};
}

} // namespace Test_surfaces
