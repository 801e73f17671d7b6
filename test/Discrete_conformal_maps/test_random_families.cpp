// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "planar_cells.h"
#include "reference_surface.h"

#include "../Intrinsic_triangulations/near_degenerate_meshes.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>

// These are small surfaces of the families of benchmark/workflow/hard_surfaces.py. Every success
// satisfies its promises in a hundred digits.
namespace Test_random_families {

using namespace Test_surfaces;

double power_of_ten(double low, double high, CGAL::Random& random)
{
  return std::pow(10, random.get_double(low, high));
}

Mesh strip(CGAL::Random& random)
{
  const double tooth = power_of_ten(-2, 0, random);
  return grid(std::size_t(random.get_int(2, 40)), 1,
              [&](double x, double y) { return Point(x, y * (0.5 + tooth * std::fmod(x, 2)), 0); });
}

Mesh comb(CGAL::Random& random)
{
  std::set<Cell> cells;
  const int teeth = random.get_int(1, 5), length = random.get_int(1, 6);
  for(int i = 0; i < 2 * teeth - 1; ++i)
    for(int j = 0; j < (i % 2 == 0 ? length : 1); ++j)
      cells.emplace(i, j);
  return Planar_cells(cells, 1, random_seed(random)).mesh;
}

Mesh open_tube(CGAL::Random& random)
{
  const std::size_t rings = std::size_t(random.get_int(2, 15)),
                    n = std::size_t(random.get_int(3, 7));
  const double step = power_of_ten(-1, 1, random);
  std::vector<Point> points;
  for(std::size_t i = 0; i <= rings; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const Complex z = std::polar(1., 2 * pi * double(j) / double(n));
      points.emplace_back(z.real(), z.imag(), step * double(i));
    }
  return make_mesh(points, lattice(rings, n, false, true));
}

// Adds a vertex with the weights 1 : e : e or 1 : 1 : e in a face.
void add_needle_or_cap(Mesh& mesh, Mesh::Face_index f, double e, bool is_needle)
{
  const auto h = mesh.halfedge(f);
  const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
              r = mesh.point(mesh.target(mesh.next(h)));
  const Point place = CGAL::barycenter(p, 1., q, is_needle ? e : 1., r, e);
  mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = place;
}

Mesh needles_and_caps_in(Mesh mesh, double least, CGAL::Random& random)
{
  for(int i = 0; i < 6; ++i) {
    const int f = random.get_int(0, int(mesh.number_of_faces()));
    add_needle_or_cap(mesh, Mesh::Face_index(unsigned(f)), power_of_ten(least, -2, random),
                      random.get_bool());
  }
  return mesh;
}

Mesh with_moderate_needles(CGAL::Random& random)
{
  return needles_and_caps_in(random_sphere(40, random_seed(random)), -6, random);
}

Mesh with_needles(CGAL::Random& random)
{
  return needles_and_caps_in(embedded_torus(7, 5), -13, random);
}

// Returns a mesh with a second vertex at the distance of 1e-28 and more from the origin, which is a
// vertex.
Mesh coincident(CGAL::Random& random)
{
  Mesh mesh = grid(4, 4, [&](double x, double y) {
    return Point(x - 2, y - 2, x == 2 && y == 2 ? 0 : random.get_double(0, 0.3));
  });
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    if(mesh.point(mesh.source(h)) != Point(0, 0, 0))
      continue;
    add_needle_or_cap(mesh, f, power_of_ten(-28, -10, random), true);
    break;
  }
  return mesh;
}

Mesh stretched(CGAL::Random& random)
{
  return stretched_along_x(random_sphere(50, random_seed(random)), power_of_ten(0, 5, random));
}

Mesh with_holes(CGAL::Random& random)
{
  return punctured(random_sphere(60, random_seed(random)), {0, 20, 40});
}

Mesh with_handles(CGAL::Random& random)
{
  return perturbed(frame(std::size_t(random.get_int(1, 4)), 1), 0.1, random_seed(random));
}

// Returns a prism over a face of an octahedron.
Mesh with_limb(CGAL::Random& random)
{
  Mesh mesh = octahedron();
  const double step = power_of_ten(-0.5, 0.5, random);
  Mesh::Face_index end(0);
  for(int i = random.get_int(2, 12); i > 0; --i) {
    const auto h = mesh.halfedge(end);
    const std::array<Vertex_index, 3> old{mesh.source(h), mesh.target(h),
                                          mesh.target(mesh.next(h))};
    CGAL::Euler::remove_face(h, mesh);
    std::array<Vertex_index, 3> ring;
    for(std::size_t s = 0; s < 3; ++s)
      ring[s] = mesh.add_vertex(mesh.point(old[s]) + Kernel::Vector_3(step, step, step));
    for(std::size_t s = 0; s < 3; ++s) {
      const std::size_t t = (s + 1) % 3;
      mesh.add_face(old[s], old[t], ring[t]);
      mesh.add_face(old[s], ring[t], ring[s]);
    }
    end = mesh.add_face(ring[0], ring[1], ring[2]);
  }
  mesh.collect_garbage();
  return mesh;
}

Mesh spiral(CGAL::Random& random)
{
  const double width = random.get_double(0.2, 0.9), turn = random.get_double(0.1, 0.5);
  return grid(std::size_t(random.get_int(5, 50)), 1, [&](double x, double y) {
    const Complex z = std::polar(1 + turn * x / (2 * pi) + width * y, -turn * x);
    return Point(z.real(), z.imag(), 0);
  });
}

Mesh polygon(CGAL::Random& random)
{
  const std::size_t n = std::size_t(random.get_int(4, 40));
  return planar_mesh(random_points(n, 1000, random_seed(random)));
}

struct Family
{
  std::string name;
  Mesh (*make)(CGAL::Random&);
  // States whether rounding of distances changes angles. Curvatures then belong to the rounded
  // lengths.
  bool is_at_rounding = false;
};

std::vector<Family> families()
{
  return {{"strip", strip},
          {"comb", comb},
          {"tube", open_tube},
          {"moderate needles", with_moderate_needles},
          {"needles", with_needles, true},
          {"coincident", coincident, true},
          {"stretched", stretched, true},
          {"holes", with_holes},
          {"handles", with_handles},
          {"limb", with_limb},
          {"spiral", spiral},
          {"polygon", polygon}};
}

template <typename Any_mesh>
int Euler_characteristic(const Any_mesh& mesh)
{
  return int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
}

// Flips change no numbers of elements.
void expect_Euler_characteristic(const Planar_conformal_map& map)
{
  const int expected = Euler_characteristic(mesh_A(map));
  EXPECT_EQ(Euler_characteristic(mesh_C(map)), expected);
  EXPECT_EQ(Euler_characteristic(map.subdivision().mesh()), expected);
}

// Returns the greatest error of a length cross ratio, of the positions compared with the ideal
// polyhedron.
double error_of_cross_ratios(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  long double result = 0;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    if(!map.is_laid_out(mesh.face(h)) || !map.is_laid_out(mesh.face(o)))
      continue;
    const auto error = [&](Halfedge_index x) { // of a side in the plane, against its length
      const Complex z = map.position(mesh.next(x)) - map.position(x);
      return std::hypot((long double)z.real(), (long double)z.imag()) /
             (long double)map.ideal().length(mesh.edge(x));
    };
    const long double ratio =
      error(mesh.next(h)) * error(mesh.next(o)) / (error(mesh.prev(h)) * error(mesh.prev(o)));
    result = (std::max)(result, std::abs(ratio - 1));
  }
  return double(result);
}

// Checks the sum of curvatures in a hundred digits, and that prescribed curvatures are zero.
void expect_flat(const Planar_conformal_map& map, const Mesh& mesh)
{
  std::vector<double> u;
  for(Vertex_index v : mesh.vertices())
    u.push_back(map.log_scale(v));
  Reference_surface surface(mesh);
  surface.scale(u);
  const std::vector<Long_real> curvature = surface.curvatures();
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v) && std::count(map.cones().begin(), map.cones().end(), v) == 0) {
      EXPECT_LT(abs(curvature[v.idx()]), 1e-9) << v;
    }
}

TEST(Random_families, successes_have_what_is_promised)
{
  std::map<std::string, int> found;
  for(const auto& [family, seed] : traced(families(), 4)) {
    CGAL::Random random(seed + 1);
    const Mesh mesh = family.make(random);
    ASSERT_TRUE(CGAL::is_triangle_mesh(mesh) && mesh.is_valid(false));
    const Planar_conformal_map map = DCM::flatten(mesh);
    expect_Euler_characteristic(map);
    if(map.status() != DCM::Map_status::success)
      continue;
    ++found[family.name];
    // Positions in `double` do not represent the shapes of crowded faces.
    EXPECT_LT(map.crowded_faces().empty() ? error_of_cross_ratios(map)
                                          : DCM::max_cross_ratio_error(map),
              1e-8);
    if(!family.is_at_rounding)
      expect_flat(map, mesh);
  }
  for(const Family& family : traced(families())) {
    if(!family.is_at_rounding) {
      EXPECT_EQ(found[family.name], 4);
    }
  }
}

} // namespace Test_random_families
