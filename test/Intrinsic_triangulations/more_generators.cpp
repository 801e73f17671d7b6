// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "more_generators.h"

namespace Test_surfaces {

double longest_input_edge(const Triangulation& t)
{
  double result = 0;
  for(Edge_index e : t.input_mesh().edges())
    result = (std::max)(result, t.input_length(e));
  return result;
}

std::vector<double> sorted_lengths(const Triangulation& t)
{
  std::vector<double> result;
  for(Edge_index e : t.mesh().edges())
    result.push_back(t.length(e));
  std::sort(result.begin(), result.end());
  return result;
}

double convexity(const Triangulation& t, Halfedge_index h)
{
  const Delta_complex& mesh = t.mesh();
  const auto angle = [&](Halfedge_index x) { return angle_at(x, mesh, t.length_map()); };
  const Halfedge_index o = mesh.opposite(h);
  return pi - (std::max)(angle(h) + angle(mesh.next(o)), angle(o) + angle(mesh.next(h)));
}

void flip_at_random(Triangulation& t, std::size_t attempts, unsigned int seed,
                    const std::function<void(Halfedge_index)>& after_flip)
{
  CGAL::Random random(seed);
  const double limit = 6 * longest_input_edge(t);
  const auto flipped_length = t.traits().compute_flipped_length_object();
  for(std::size_t i = 0; i < attempts; ++i) {
    const Halfedge_index h = random_halfedge(t.mesh(), random);
    if(!t.is_flippable(h) || convexity(t, h) < 0.01 ||
       flipped_length(IT::diamond(t.length_map(), h, t.mesh())) > limit)
      continue;
    t.flip(h);
    if(after_flip)
      after_flip(h);
  }
}

Triangulation with_random_flips(const Mesh& mesh, CGAL::Random& random)
{
  Triangulation t(mesh);
  for(std::size_t i = 0; i < 3 * mesh.number_of_edges(); ++i)
    if(const Halfedge_index h = random_index<Halfedge_index>(t.mesh().num_halfedges(), random);
       t.is_flippable(h) && t.coordinates().crossings(h) < 50)
      t.flip(h);
  t.recompute_lengths();
  return t;
}

Mesh with_near_coincident_vertices(Mesh mesh, double distance, unsigned int seed)
{
  CGAL::Random random(seed);
  for(Vertex_index v : mesh.vertices())
    if(v.idx() % 3 == 0) {
      const Point p = mesh.point(mesh.source(mesh.halfedge(v)));
      mesh.point(v) =
        p + distance * Kernel::Vector_3(random.get_double(0.1, 1), random.get_double(0.1, 1),
                                        random.get_double(0.1, 1));
    }
  return mesh;
}

Flat_surface flat_grid(std::size_t m, std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Vector> points;
  for(std::size_t i = 0; i <= m; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      points.push_back({static_cast<std::int64_t>(1000 * i) + random.get_int(-140, 141),
                        static_cast<std::int64_t>(1000 * j) + random.get_int(-140, 141)});
  return flat_surface(points, lattice(m, n));
}

std::vector<Named_surface> flat_surfaces()
{
  return {{"small grid", flat_grid(2, 2, 1)},
          {"grid", flat_grid(6, 5, 2)},
          {"torus with one vertex", flat_torus(1, 1, 0)},
          {"torus with two vertices", flat_torus(2, 1, 3)},
          {"torus", flat_torus(3, 4, 4)},
          {"annulus with two vertices", flat_cylinder(1, 0)},
          {"sheared annulus with two vertices", flat_cylinder(1, 3)},
          {"annulus", flat_cylinder(4, 0)},
          {"sheared annulus", flat_cylinder(3, 1)}};
}

void add_flipped(const std::string& name, const Triangulation& t,
                 std::vector<Named_triangulation>& result)
{
  result.push_back({name, t});
  result.push_back({name + ", Delaunay", t});
  IT::make_Delaunay(result.back().triangulation);
  for(unsigned int seed : {1u, 2u, 3u, 4u, 5u}) {
    result.push_back({name + ", flipped with seed " + std::to_string(seed), t});
    flip_at_random(result.back().triangulation, 20 * t.mesh().number_of_edges(), seed);
  }
}

std::vector<Named_triangulation> closed_surfaces()
{
  std::vector<Named_triangulation> result;
  for(const Named_complex& c : complexes())
    if(!has_border(c.mesh))
      result.push_back({c.name, triangulation(c.mesh, random_lengths(c.mesh, 11))});
  for(const Named_mesh& m : meshes())
    if(CGAL::is_closed(m.mesh))
      result.push_back({m.name + " in space", Triangulation(m.mesh)});
  return result;
}

std::vector<Named_triangulation> triangulations()
{
  std::vector<Named_triangulation> result;
  for(const Named_mesh& m : meshes())
    add_flipped(m.name, Triangulation(m.mesh), result);
  for(const Named_complex& c : complexes())
    add_flipped(c.name + " with random lengths", triangulation(c.mesh, random_lengths(c.mesh, 7)),
                result);
  for(const Named_surface& s : flat_surfaces())
    add_flipped("flat " + s.name, triangulation(s.surface), result);
  return result;
}

} // namespace Test_surfaces
