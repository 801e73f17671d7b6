// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "planar_cells.h"
#include "reference_surface.h"

#include "../Intrinsic_triangulations/near_degenerate_meshes.h"

#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

// Maps in double precision against those in a hundred digits, from the positions on.
namespace Test_hundred_digits {

using namespace Test_surfaces;

struct Problem
{
  std::string name;
  Mesh mesh;
  Conditions condition;
};

// Returns a problem with the given curvatures, and zero elsewhere.
Problem with_curvatures(const std::string& name, const Mesh& mesh,
                        const std::map<unsigned int, double>& given)
{
  Conditions condition(mesh.number_of_vertices(), Vertex_condition::curvature(0));
  for(const auto& [v, value] : given)
    condition[v] = Vertex_condition::curvature(value);
  return {name, mesh, condition};
}

Problem without_boundary_scale(const std::string& name, const Mesh& mesh)
{
  Conditions condition(mesh.number_of_vertices());
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      condition[v] = Vertex_condition::log_scale(0);
  return {name, mesh, condition};
}

Problem as_rectangle(const std::string& name, const Mesh& mesh)
{
  std::map<unsigned int, double> given;
  for(Vertex_index v : DCM::rectangle_corners(mesh))
    given[v.idx()] = pi / 2;
  return with_curvatures(name, mesh, given);
}

Mesh bent_grid(std::size_t m, std::size_t n, double noise)
{
  return perturbed(grid(m, n, [](double x, double y) { return Point(x, y, 0.02 * x * x); }), noise,
                   4);
}

// Inserts a vertex with the weights 1 : e : e or 1 : 1 : e into every tenth face.
Mesh with_needles_and_caps(Mesh mesh, double e)
{
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(std::size_t i = 0; i < faces.size(); i += 10) {
    const auto h = mesh.halfedge(faces[i]);
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
                r = mesh.point(mesh.target(mesh.next(h)));
    const Point place =
      i % 20 == 0 ? CGAL::barycenter(p, 1., q, e, r, e) : CGAL::barycenter(p, 1., q, 1., r, e);
    mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = place;
  }
  return mesh;
}

std::vector<Problem> problems()
{
  const Mesh torus = perturbed(embedded_torus(12, 8), 0.05, 1), ball = random_sphere(100, 2);
  return {
    with_curvatures("torus", torus, {}),
    with_curvatures("torus with cones", torus, {{3, 5}, {50, -9}, {71, 4}}),
    with_curvatures("sphere with cones", ball,
                    {{0, 1.5 * pi}, {30, 1.9 * pi}, {60, -pi}, {90, 1.6 * pi - 1e-3}, {91, 1e-3}}),
    with_curvatures("frame", perturbed(frame(2, 1), 0.05, 3), {{0, -3 * pi}, {7, -pi}}),
    with_curvatures("torus with needles", with_needles_and_caps(torus, 1e-4), {}),
    with_curvatures("stretched torus", stretched_along_x(torus, 10), {}),
    without_boundary_scale("plate", bent_grid(9, 9, 0.2)),
    without_boundary_scale("plate with needles", with_needles_and_caps(bent_grid(9, 9, 0.1), 1e-4)),
    as_rectangle("rectangle", bent_grid(9, 9, 0.2)),
    as_rectangle("strip", bent_grid(48, 1, 0.2)),
    as_rectangle("rectangle with needles", with_needles_and_caps(bent_grid(9, 9, 0.1), 1e-4)),
  };
}

// Returns the prescribed values on the double. Prescribed scale factors are zero.
std::vector<double> target(const Problem& p)
{
  std::vector<double> result;
  for(Vertex_index v : p.mesh.vertices())
    result.push_back((p.mesh.is_border(v) ? 2 : 1) * p.condition[v.idx()].value);
  return result;
}

std::vector<bool> fixed(const Problem& p)
{
  std::vector<bool> result;
  for(const Vertex_condition& c : p.condition)
    result.push_back(c.quantity == Vertex_condition::Quantity::log_scale);
  return result;
}

std::vector<double> scale_factors(const DCM::Discrete_conformal_map& map, const Mesh& mesh)
{
  std::vector<double> result;
  for(Vertex_index v : mesh.vertices())
    result.push_back(map.log_scale(v));
  return result;
}

Planar_conformal_map flat_map(const Problem& p)
{
  return DCM::flatten(p.mesh, DCM::parameters::vertex_condition_map(as_map(p.condition)));
}

// The surface of the positions, scaled by the map, has the prescribed curvatures.
TEST(Hundred_digits, scale_factors_have_the_curvatures_that_are_promised)
{
  for(const Problem& p : traced(problems())) {
    const Planar_conformal_map map = flat_map(p);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    Reference_surface surface(p.mesh);
    surface.scale(scale_factors(map, p.mesh));
    const std::vector<Long_real> curvature = surface.curvatures();
    const std::vector<double> expected = target(p);
    const std::vector<bool> is_fixed = fixed(p);
    for(std::size_t v = 0; v < expected.size(); ++v) {
      if(is_fixed[v])
        continue;
      EXPECT_LT(abs(curvature[v] - Long_real(expected[v])), 1e-10) << v;
    }
  }
}

// Scale factors are unique, up to a constant if none is prescribed.
TEST(Hundred_digits, scale_factors_are_those_of_the_minimum)
{
  for(const Problem& p : traced(problems())) {
    const std::vector<double> u = scale_factors(flat_map(p), p.mesh);
    Reference_surface surface(p.mesh);
    const std::vector<bool> is_fixed = fixed(p);
    const std::vector<Long_real> expected = surface.find_scale_factors(target(p), is_fixed);
    const bool is_any_fixed = std::count(is_fixed.begin(), is_fixed.end(), true) != 0;
    const Long_real shift = is_any_fixed ? Long_real(0) : Long_real(u[0] - expected[0]);
    for(std::size_t v = 0; v < u.size(); ++v)
      EXPECT_LT(abs(u[v] - expected[v] - shift), 1e-9) << v;
  }
}

// Returns the greatest relative error of a distance, up to a common factor, of the images of the
// ends of edges. `is_good(h)` selects the halfedges that are compared.
template <typename Distance, typename Is_good>
double error_of_distances(const Reference_surface& surface, const Distance& distance,
                          const Is_good& is_good)
{
  std::vector<double> quotients;
  for(std::size_t h = 0; h < surface.number_of_halfedges(); h += 2)
    if(is_good(h) && is_good(h ^ 1))
      quotients.push_back(
        double(Long_real(distance(surface.source(h), surface.target(h))) / surface.length(h)));
  EXPECT_GE(quotients.size(), surface.number_of_input_vertices());
  const auto [least, greatest] = std::minmax_element(quotients.begin(), quotients.end());
  return *greatest / *least - 1;
}

// Edges between faces of the first copy are straight in the rectangle.
TEST(Hundred_digits, rectangles_have_the_distances_of_the_minimum)
{
  for(const Problem& p : traced(problems())) {
    if(p.name.find("rectangle") == std::string::npos && p.name != "strip")
      continue;
    const Planar_conformal_map map = flat_map(p);
    std::vector<Complex> z;
    for(Vertex_index v : p.mesh.vertices())
      z.push_back(image(map, v));
    Reference_surface surface(p.mesh);
    surface.scale(scale_factors(map, p.mesh)); // those of the minimum, see above
    const auto is_of_input = [&](std::size_t h) {
      for(const std::size_t x : {h, surface.next(h), surface.next(surface.next(h))})
        if(surface.source(x) >= surface.number_of_input_vertices())
          return false;
      return true;
    };
    EXPECT_LT(
      error_of_distances(
        surface, [&](std::size_t v, std::size_t w) { return std::abs(z[v] - z[w]); }, is_of_input),
      1e-8);
  }
}

// Chords of the sphere are scaled lengths of one ideal polyhedron.
TEST(Hundred_digits, spheres_have_the_distances_of_a_convex_polyhedron)
{
  const Mesh ball = random_sphere(100, 5);
  for(const auto& [name, mesh] :
      traced(std::vector<Named_mesh>{{"ball", ball},
                                     {"stretched", stretched_along_x(ball, 30)},
                                     {"with needles", with_needles_and_caps(ball, 1e-4)},
                                     {"bipyramid", bipyramid(40, 3)}})) {
    const DCM::Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    Reference_surface surface(mesh);
    surface.scale(scale_factors(map, mesh));
    // Positions in double precision do not resolve the ends of a long surface.
    const auto chord = [&](std::size_t v, std::size_t w) {
      const auto p = map.position_in<Long_real>(Vertex_index(Mesh::size_type(v))),
                 q = map.position_in<Long_real>(Vertex_index(Mesh::size_type(w)));
      return Long_real(sqrt(pow(p[0] - q[0], 2) + pow(p[1] - q[1], 2) + pow(p[2] - q[2], 2)));
    };
    EXPECT_LT(error_of_distances(surface, chord, [](std::size_t) { return true; }), 1e-8);
  }
}

TEST(Hundred_digits, hyperbolic_surfaces_have_no_curvature_at_vertices)
{
  for(const std::size_t holes : traced({2u, 3u})) {
    const Mesh mesh = perturbed(frame(holes, 1), 0.05, 6);
    const auto map = DCM::uniformize_hyperbolic(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    Reference_surface surface(mesh);
    surface.scale(scale_factors(map, mesh));
    for(const Long_real& curvature : surface.curvatures(Reference_faces::hyperbolic))
      EXPECT_LT(abs(curvature), 1e-10);
  }
}

} // namespace Test_hundred_digits
