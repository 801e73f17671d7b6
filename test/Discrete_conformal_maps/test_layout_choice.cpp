// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Spectral_layout.h>
#include <Eigen/Dense>

namespace Test_layout_choice {

using namespace Test_surfaces;
using DCM::Layout;

constexpr Layout layouts[] = {Layout::least_squares, Layout::spectral, Layout::incremental};

// ---- Maps ----

struct Problem
{
  std::string name;
  Delta_complex mesh;
  std::vector<double> length;
  Conditions condition;
  double bound; // of scale factors

  Problem(const std::string& name_, const Triangulation& t, const Conditions& condition_,
          double bound_ = std::numeric_limits<double>::infinity())
    : name(name_), mesh(t.mesh()), length(lengths_of(t)), condition(condition_), bound(bound_)
  {}

  Planar_conformal_map map(Layout layout) const
  {
    return DCM::flatten(mesh, length_parameter(length)
                                .vertex_condition_map(as_map(condition))
                                .maximum_log_scale(bound)
                                .layout(layout));
  }
};

Problem with_greedy_cones(const std::string& name, const Mesh& mesh)
{
  const Triangulation t(mesh);
  return {name, t, default_conditions(t.mesh()), 2};
}

// Returns a tube, `rings` times as long as its sides, closed at both ends. The four corners of one
// end have all curvature.
Problem tube(int rings)
{
  std::vector<Point> points;
  Triangles triangles;
  const auto number = [](int ring, int k) { return std::size_t(4 * ring + k % 4); };
  for(int ring = 0; ring <= rings; ++ring)
    for(int k = 0; k < 4; ++k)
      points.emplace_back(k == 0 || k == 3 ? 0 : 1, k < 2 ? 0 : 1, ring);
  for(int ring = 0; ring < rings; ++ring)
    for(int k = 0; k < 4; ++k) {
      triangles.push_back({number(ring, k), number(ring, k + 1), number(ring + 1, k + 1)});
      triangles.push_back({number(ring, k), number(ring + 1, k + 1), number(ring + 1, k)});
    }
  triangles.push_back({0, 3, 2});
  triangles.push_back({0, 2, 1});
  const std::size_t end = number(rings, 0);
  triangles.push_back({end, end + 1, end + 2});
  triangles.push_back({end, end + 2, end + 3});
  Conditions condition(points.size());
  for(std::size_t v = 0; v < 4; ++v)
    condition[v] = Vertex_condition::curvature(pi);
  return {"tube of " + std::to_string(rings), Triangulation(make_mesh(points, triangles)),
          condition};
}

std::vector<Problem> problems_without_cones()
{
  std::vector<Problem> result;
  for(const Flat_surface& surface :
      {flat_torus(4, 3, 1), flat_grid(6, 5, 2), flat_polygon(random_points(200, 10000, 6)),
       flat_cylinder(3, 2)}) {
    const Flat_triangulation flat(surface);
    result.push_back({"flat surface", *flat, default_conditions((*flat).mesh())});
  }
  return result;
}

std::vector<Problem> problems_with_cones()
{
  std::vector<Problem> result{with_greedy_cones("sphere", random_sphere(400, 9)),
                              with_greedy_cones("five components", five_components())};
  for(int genus : {0, 1, 2, 3})
    result.push_back(with_greedy_cones("genus " + std::to_string(genus), plate_with_holes(genus)));
  Conditions condition(200);
  for(std::size_t i = 0; i < 10; ++i)
    condition[17 * i] = Vertex_condition::curvature(4 * pi / 10);
  result.push_back({"ten cones", Triangulation(random_sphere(200, 2)), condition});
  return result;
}

// ---- Comparison ----

// Returns the charts. Seams and faces that join vertices distinguish components.
std::vector<std::vector<Halfedge_index>> charts(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  std::vector<std::vector<Halfedge_index>> result;
  std::vector<char> is_found(mesh.number_of_faces(), 0);
  for(Face_index root : mesh.faces()) {
    if(is_found[root] || !map.is_laid_out(root))
      continue;
    result.emplace_back();
    std::vector<Face_index> front{root};
    is_found[root] = 1;
    while(!front.empty()) {
      const Face_index f = front.back();
      front.pop_back();
      for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        result.back().push_back(h);
        const Face_index g = mesh.face(mesh.opposite(h));
        if(!map.is_seam(mesh.edge(h)) && !is_found[g]) {
          is_found[g] = 1;
          front.push_back(g);
        }
      }
    }
  }
  return result;
}

// Returns the error of the best similarity from one to the other, relative to the size.
double difference(const std::vector<Complex>& p, const std::vector<Complex>& q)
{
  Complex center_p(0), center_q(0), product(0);
  double square = 0, size = 0, result = 0;
  for(std::size_t i = 0; i < p.size(); ++i) {
    center_p += p[i] / double(p.size());
    center_q += q[i] / double(q.size());
  }
  for(std::size_t i = 0; i < p.size(); ++i) {
    product += std::conj(p[i] - center_p) * (q[i] - center_q);
    square += std::norm(p[i] - center_p);
    size = (std::max)(size, std::abs(q[i] - center_q));
  }
  for(std::size_t i = 0; i < p.size(); ++i)
    result =
      (std::max)(result, std::abs(product / square * (p[i] - center_p) - (q[i] - center_q)) / size);
  return result;
}

std::vector<Complex> positions(const Planar_conformal_map& map,
                               const std::vector<Halfedge_index>& chart)
{
  std::vector<Complex> result;
  for(Halfedge_index h : chart)
    result.push_back(map.position(h));
  return result;
}

// Checks that seams have the same length, and the same turn as with the other layout.
void check_seams(const Planar_conformal_map& one, const Planar_conformal_map& two, double tolerance)
{
  const Delta_complex& mesh = mesh_C(one);
  const auto turn = [&](const Planar_conformal_map& map, Edge_index e) {
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    return (map.position(mesh.next(h)) - map.position(h)) /
           (map.position(o) - map.position(mesh.next(o)));
  };
  for(Edge_index e : mesh.edges()) {
    ASSERT_EQ(one.is_seam(e), two.is_seam(e));
    const Halfedge_index h = mesh.halfedge(e);
    if(!one.is_seam(e) || !one.is_laid_out(mesh.face(h)) ||
       !one.is_laid_out(mesh.face(mesh.opposite(h))))
      continue;
    EXPECT_NEAR(std::abs(turn(two, e)), 1, tolerance) << e;
    EXPECT_LT(std::abs(turn(one, e) - turn(two, e)), tolerance) << e;
  }
}

void check_layouts_agree(const Problem& problem)
{
  const Planar_conformal_map reference = problem.map(Layout::least_squares);
  ASSERT_EQ(reference.status(), DCM::Map_status::success);
  for(const Layout layout : layouts) {
    SCOPED_TRACE(problem.name + ", layout " + std::to_string(int(layout)));
    const Planar_conformal_map map = problem.map(layout);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    check_layout(map);
    check_seams(reference, map, 1e-9);
    for(const auto& chart : charts(map))
      EXPECT_LT(difference(positions(reference, chart), positions(map, chart)), 1e-9);
  }
}

// ---- A chart that is not flat ----

// Represents a grid with its distances on a dome, as faces of a chart, which do not fit together in
// the plane.
struct Dome
{
  static constexpr std::size_t side = 6, size = side * side;

  static Point place(std::size_t i)
  {
    const double x = double(i % side) / side, y = double(i / side) / side;
    return Point(x, y, 0.2 * std::cos(x + 2 * y) + 0.1 * x * x);
  }

  Dome()
  {
    for(std::size_t y = 0; y + 1 < side; ++y)
      for(std::size_t x = 0; x + 1 < side; ++x) {
        const std::size_t i = y * side + x;
        faces.push_back({i, i + 1, i + side + 1});
        faces.push_back({i, i + side + 1, i + side});
      }
    for(std::size_t k = 0; k + 1 < side; ++k)
      for(const auto& [i, j] : {std::pair(k, k + 1),
                                {size - side + k, size - side + k + 1},
                                {k * side, (k + 1) * side},
                                {(k + 1) * side - 1, (k + 2) * side - 1}})
        boundary.push_back({i, j});
  }

  // Returns the corners of a face, laid out in a separate plane.
  static std::array<Complex, 3> flat(const std::array<std::size_t, 3>& f)
  {
    const auto u = place(f[1]) - place(f[0]), v = place(f[2]) - place(f[0]);
    const double a = std::sqrt(u * u);
    return {0, a, Complex(u * v / a, std::sqrt(CGAL::cross_product(u, v).squared_length()) / a)};
  }

  static double distance(std::size_t i, std::size_t j)
  {
    return std::sqrt(CGAL::squared_distance(place(i), place(j)));
  }

  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::array<std::size_t, 2>> boundary;
};

// Returns twice the Dirichlet energy by cotangents, minus twice the area by the boundary, and B,
// all as z^* M z.
Eigen::MatrixXcd conformal_energy(const Dome& dome)
{
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(Dome::size, Dome::size);
  for(const auto& f : dome.faces) {
    const std::array<Complex, 3> z = Dome::flat(f);
    for(std::size_t s = 0; s < 3; ++s) {
      const auto i = Eigen::Index(f[(s + 1) % 3]), j = Eigen::Index(f[(s + 2) % 3]);
      const Complex corner = std::conj(z[(s + 1) % 3] - z[s]) * (z[(s + 2) % 3] - z[s]);
      const double weight = corner.real() / corner.imag() / 4;
      result(i, i) += weight;
      result(j, j) += weight;
      result(i, j) -= weight;
      result(j, i) -= weight;
      // Twice the area is the sum of Im(conj(z_i) z_j) over sides.
      result(i, j) += Complex(0, 0.25);
      result(j, i) -= Complex(0, 0.25);
    }
  }
  return result;
}

Eigen::MatrixXcd boundary_mass(const Dome& dome)
{
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(Dome::size, Dome::size);
  for(const auto& [i, j] : dome.boundary)
    for(const std::size_t k : {i, j})
      result(Eigen::Index(k), Eigen::Index(k)) += Dome::distance(i, j) / 2;
  return result;
}

// Returns the eigenvector of L z = lambda B z with the least lambda > 0, by B z = mu (L + B) z.
std::vector<Complex> dense_eigenvector(const Dome& dome)
{
  const Eigen::MatrixXcd l = conformal_energy(dome), b = boundary_mass(dome);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(b, l + b);
  const auto z = solver.eigenvectors().col(Eigen::Index(Dome::size) - 2); // mu = 1: constants
  return {z.data(), z.data() + Dome::size};
}

TEST(Layout_choice, all_agree_on_flat_surfaces)
{
  for(const Problem& problem : problems_without_cones())
    check_layouts_agree(problem);
}

TEST(Layout_choice, all_agree_on_surfaces_with_cones)
{
  for(const Problem& problem : problems_with_cones())
    check_layouts_agree(problem);
}

// Positions are as accurate as rounding of the whole surface allows for the smallest faces.
TEST(Layout_choice, large_ranges_of_scale)
{
  for(const int rings : {5, 10, 20}) {
    const Problem problem = tube(rings);
    for(const Layout layout : layouts) {
      SCOPED_TRACE(problem.name + ", layout " + std::to_string(int(layout)));
      const Planar_conformal_map map = problem.map(layout);
      const double range = log_scale(map, 0) - log_scale(map, std::size_t(4 * rings));
      EXPECT_GT(range, rings);
      // A dozen rounding errors occur on each of the paths through 4 faces per ring.
      const double error = DCM::max_cross_ratio_error(map);
      EXPECT_LT(error, 48 * rings * std::exp(range) * std::numeric_limits<double>::epsilon());
      EXPECT_EQ(map.status(),
                error <= 1e-8 ? DCM::Map_status::success : DCM::Map_status::not_conformal);
      EXPECT_TRUE(rings == 20 || error <= 1e-8) << error;
    }
  }
}

TEST(Layout_choice, faces_smaller_than_rounding_are_reported)
{
  for(const Layout layout : layouts) {
    const Planar_conformal_map map = tube(60).map(layout);
    EXPECT_GT(log_scale(map, 0) - log_scale(map, 240), std::log(1e20));
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    EXPECT_FALSE(map.crowded_faces().empty());
  }
}

TEST(Layout_choice, spectral_layout_is_an_eigenvector)
{
  const Dome dome;
  DCM::internal::Spectral_chart<double> layout;
  for(const auto& f : dome.faces) {
    const std::array<Complex, 3> z = Dome::flat(f);
    std::array<DCM::internal::Plane_vector<double>, 3> sides;
    for(std::size_t s = 0; s < 3; ++s) {
      const Complex side = z[(s + 1) % 3] - z[s];
      sides[s] = {side.real(), side.imag()};
    }
    layout.add_face(f, sides);
  }
  for(const auto& [i, j] : dome.boundary)
    layout.add_boundary_edge(i, j, Dome::distance(i, j));
  std::vector<DCM::internal::Plane_vector<double>> z;
  for(std::size_t i = 0; i < Dome::size; ++i)
    z.push_back({Dome::place(i).x(), Dome::place(i).y()});
  layout.improve(z);
  std::vector<Complex> image;
  for(const auto& p : z)
    image.push_back(to_complex(p));
  EXPECT_LT(difference(image, dense_eigenvector(dome)), 1e-9);
}

} // namespace Test_layout_choice
