// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "matrices.h"
#include "measuring.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

namespace Test_operators {

using namespace Test_surfaces;
using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::VectorXd;
using Field = Eigen::VectorXcd;
using Complex = std::complex<double>;

Values values(const Mesh& mesh, const std::function<double(const Point&)>& f)
{
  Values result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Vertex_index v : mesh.vertices())
    result[v.idx()] = f(mesh.point(v));
  return result;
}

// Returns the triangulation with lengths in another unit.
Triangulation scaled(const Delta_complex& mesh, std::vector<double> lengths, double factor)
{
  for(double& length : lengths)
    length *= factor;
  return triangulation(mesh, lengths);
}

// ---- Corners ----

// Returns half the cotangents from coordinates: dot over cross product, both exact.
Matrix planar_laplacian(const Flat_surface& surface)
{
  const auto n = static_cast<Eigen::Index>(surface.mesh.number_of_vertices());
  Matrix result(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  for(Halfedge_index h : surface.mesh.halfedges()) {
    if(surface.mesh.is_border(h))
      continue;
    const Vector u = surface.vector[surface.mesh.prev(h)];
    const Vector v = -surface.vector[surface.mesh.next(h)];
    const double w = static_cast<double>(dot(u, v)) / static_cast<double>(det(u, v)) / 2;
    const auto i = static_cast<int>(surface.mesh.source(h).idx());
    const auto j = static_cast<int>(surface.mesh.target(h).idx());
    for(const auto& [row, column, value] :
        {std::tuple(i, i, w), std::tuple(j, j, w), std::tuple(i, j, -w), std::tuple(j, i, -w)})
      entries.emplace_back(row, column, value);
  }
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// ---- Planar functions ----

Values planar_values(const Flat_surface& surface, double a, double b)
{
  Values result(static_cast<Eigen::Index>(surface.point.size()));
  for(Vertex_index v : surface.mesh.vertices())
    result[v.idx()] =
      3 + a * static_cast<double>(surface.point[v].x) + b * static_cast<double>(surface.point[v].y);
  return result;
}

std::vector<Flat_surface> planar_surfaces()
{
  return {flat_grid(6, 5, 1), flat_grid(9, 2, 2), flat_polygon(random_points(25, 1000, 5)),
          flat_polygon(random_points(60, 10000, 6))};
}

// ---- Errors ----

// Checks the errors, each on a mesh with edges half as long as before.
void expect_second_order(const std::vector<double>& errors)
{
  for(std::size_t k = 1; k < errors.size(); ++k) {
    EXPECT_GT(errors[k - 1] / errors[k], 3.2) << errors[k - 1] << " " << errors[k];
  }
}

double mean_square(const Values& error, const Matrix& mass)
{
  return std::sqrt(error.dot(mass * error) / mass.sum());
}

// Returns the least eigenvalue of L relative to a mass matrix, by inverse iteration.
template <typename Scalar>
double least_eigenvalue(const Eigen::SparseMatrix<Scalar>& laplacian, const Values& mass)
{
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>> inverse(laplacian);
  Vector x = Vector::Random(mass.size());
  for(int k = 0; k < 60; ++k) {
    x = Vector(inverse.solve(Vector(mass.cwiseProduct(x.real()).template cast<Scalar>() +
                                    Scalar(0, 1) * mass.cwiseProduct(x.imag()))));
    x /= std::sqrt(x.cwiseAbs2().dot(mass));
  }
  return std::real(x.dot(laplacian * x));
}

// ---- Tangent fields ----

// Returns the field of parallel vectors of direction 1 on a flat surface with exact vectors.
Field parallel_field(const Flat_surface& surface, const IT::Tangent_frames<>& frames)
{
  Field result(static_cast<Eigen::Index>(surface.mesh.number_of_vertices()));
  for(Vertex_index v : surface.mesh.vertices()) {
    const Halfedge_index h = IT::first_outgoing_halfedge(v, surface.mesh);
    const Vector d = surface.vector[h];
    result[v.idx()] = std::polar(
      1., frames.angle(h) - std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)));
  }
  return result;
}

TEST(Operators, corners_of_needles_and_caps)
{
  CGAL::Random random(1);
  for(double thin : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12})
    for(int k = 0; k < 200; ++k) {
      const double c = random.get_double(0.5, 2);
      const bool is_cap = k % 2 == 0; // a and b together longer than c by `thin`
      const double a = is_cap ? c * random.get_double(0.1, 0.9) : thin;
      const double b = is_cap ? c - a + thin : c + thin * random.get_double(-0.9, 0.9);
      for(const auto& [x, y, z] :
          {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}, std::array{a, c, b}}) {
        const Real cotangent = IT::corner_cotangent<Real>(x, y, z);
        EXPECT_NEAR(static_cast<double>((IT::corner_cotangent(x, y, z) - cotangent) /
                                        (std::max)(Real(1), std::abs(cotangent))),
                    0, 4e-15);
        const Real angle = IT::corner_angle<Real>(x, y, z);
        EXPECT_NEAR(static_cast<double>(IT::corner_angle(x, y, z) / angle), 1, 4e-15);
      }
    }
}

TEST(Operators, cotangents_are_those_of_coordinates)
{
  for(const Flat_surface& surface : planar_surfaces()) {
    const Matrix expected = planar_laplacian(surface);
    const Matrix l = IT::cotan_laplacian(triangulation(surface).intrinsic());
    EXPECT_LT(largest_distance(l, expected), 1e-9 * largest(expected));
  }
}

TEST(Operators, equilateral_triangle)
{
  const Matrix l = IT::cotan_laplacian(triangulation(glue({{1, 2, 3}}), {2, 2, 2}).input());
  const double w = 1 / std::sqrt(12.);
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      EXPECT_NEAR(l.coeff(i, j), i == j ? 2 * w : -w, 1e-15);
}

TEST(Operators, laplacian_is_semidefinite_with_constants_as_kernel)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Matrix l = IT::cotan_laplacian(t.triangulation.intrinsic());
    const double size = largest(l);
    EXPECT_EQ(largest_distance(l, l.transpose()), 0);
    EXPECT_LE(largest(l * ones(l)), 1e-14 * size);
    if(l.rows() > 60)
      continue;
    const Values spectrum =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(l)).eigenvalues();
    EXPECT_GE(spectrum[0], -1e-13 * size);
    for(Eigen::Index k = 1; k < spectrum.size(); ++k)
      EXPECT_GT(spectrum[k], 1e-10 * size);
  }
}

TEST(Operators, Delaunay_weights_are_not_negative)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    IT::make_Delaunay(t);
    if(!CGAL::is_closed(m.mesh))
      continue; // a border edge has the negative weight of an obtuse angle
    const Matrix l = IT::cotan_laplacian(t.intrinsic());
    for(int k = 0; k < l.outerSize(); ++k)
      for(Matrix::InnerIterator entry(l, k); entry; ++entry)
        EXPECT_TRUE(entry.row() == entry.col() || entry.value() < 1e-12 * largest(l));
  }
}

TEST(Operators, linear_functions_in_the_plane_are_harmonic)
{
  for(const Flat_surface& surface : planar_surfaces()) {
    const Matrix l = IT::cotan_laplacian(triangulation(surface).intrinsic());
    const Values f = planar_values(surface, 1e-3, -2e-3), moments = l * f;
    for(Vertex_index v : surface.mesh.vertices())
      if(!surface.mesh.is_border(v)) {
        EXPECT_NEAR(moments[v.idx()], 0, 1e-12 * largest(l) * largest(f));
      }
  }
}

TEST(Operators, gradient_of_linear_functions)
{
  for(const Flat_surface& surface : planar_surfaces()) {
    const Triangulation t = triangulation(surface);
    const double a = 1e-3, b = -2e-3;
    const Values g = IT::gradient_matrix(t.intrinsic()) * planar_values(surface, a, b);
    for(Face_index f : surface.mesh.faces()) {
      const Eigen::Index row = 2 * Eigen::Index(f.idx());
      const Vector d = surface.vector[surface.mesh.halfedge(f)];
      const double x = static_cast<double>(d.x) / length(d),
                   y = static_cast<double>(d.y) / length(d);
      EXPECT_NEAR(g[row], a * x + b * y, 1e-9);
      EXPECT_NEAR(g[row + 1], b * x - a * y, 1e-9);
    }
  }
}

TEST(Operators, divergence_of_gradient_is_the_laplacian)
{
  for(const Named_triangulation& t : traced(triangulations()))
    for(Side side : both_sides) {
      const Matrix l = IT::cotan_laplacian(t.triangulation.surface(side));
      const Matrix product = IT::divergence_matrix(t.triangulation.surface(side)) *
                             IT::gradient_matrix(t.triangulation.surface(side));
      EXPECT_LE(largest_distance(-product, l), 1e-14 * (1 + largest(l)));
    }
}

TEST(Operators, masses)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Matrix lumped = IT::lumped_mass_matrix(t.triangulation.intrinsic());
    const Matrix mass = IT::mass_matrix(t.triangulation.intrinsic());
    const double area = static_cast<double>(Flat_faces(Side::intrinsic, t.triangulation).area());
    EXPECT_NEAR(lumped.sum() / area, 1, 1e-13);
    EXPECT_LT(largest(mass * ones(mass) - Values(lumped.diagonal())), 1e-14 * area);
  }
}

TEST(Operators, loops)
{
  const Triangulation torus = triangulation(flat_torus(1, 1, 0));
  EXPECT_EQ(largest(Matrix(IT::cotan_laplacian(torus.input()))), 0);
  EXPECT_GT(IT::lumped_mass_matrix(torus.input()).coeff(0, 0), 0);
  // The mesh is a cone: the edge from the tip to the boundary has the angle at its two sides at the
  // boundary.
  const Triangulation t = triangulation(cone(false), {1.5, 2});
  const Matrix l = IT::cotan_laplacian(t.input());
  EXPECT_NEAR(l.coeff(0, 0), 1 / std::tan(std::acos(2 / 3.)), 1e-14);
  EXPECT_NEAR(l.coeff(0, 1), -l.coeff(0, 0), 1e-14);
}

TEST(Operators, isolated_vertices_and_components)
{
  Mesh mesh = embedded_torus(5, 4);
  const Eigen::Index alone = mesh.add_vertex(Point(9, 9, 9)).idx();
  CGAL::copy_face_graph(tetrahedron(), mesh);
  const Triangulation t(mesh);
  const Matrix l = IT::cotan_laplacian(t.input());
  EXPECT_EQ(l.rows(), Eigen::Index(mesh.number_of_vertices()));
  EXPECT_EQ(Matrix(l.col(alone)).nonZeros(), 0);
  const Values f = Values::Random(l.rows());
  const Values u = IT::solve_poisson(t.input(), f);
  EXPECT_EQ(u[alone], 0);
  const Values moments = IT::mass_matrix(t.input()) * f;
  const Values area = IT::lumped_mass_matrix(t.input()).diagonal();
  for(const auto& [first, size] :
      {std::pair(Eigen::Index(0), alone), std::pair(alone + 1, Eigen::Index(4))}) {
    const double mean = moments.segment(first, size).sum() / area.segment(first, size).sum();
    const Values rest = (moments - mean * area - l * u).segment(first, size);
    EXPECT_LT(largest(rest), 1e-12);
    EXPECT_NEAR(area.cwiseProduct(u).segment(first, size).sum(), 0, 1e-12);
  }
}

TEST(Operators, faces_of_zero_area)
{
  const Triangulation t = triangulation(glue({{1, 2, 3}, {-3, 4, 5}}), {1, 1, 2, 2, 2});
  EXPECT_THROW(IT::cotan_laplacian(t.input()), IT::Numerical_error);
  EXPECT_THROW(IT::gradient_matrix(t.input()), IT::Numerical_error);
  EXPECT_THROW(IT::Poisson_solver<>(t.input()), IT::Numerical_error);
  EXPECT_NEAR(IT::mass_matrix(t.input()).sum(), std::sqrt(3.), 1e-15);
  const Matrix divergence = IT::divergence_matrix(t.input());
  EXPECT_TRUE(Eigen::MatrixXd(divergence).allFinite());
  const IT::Tangent_frames<> frames(t.input());
  const Vertex_index flat = t.mesh().target(t.mesh().halfedge(Edge_index(0)));
  EXPECT_DOUBLE_EQ(frames.angle_sum(flat), pi);
}

TEST(Operators, unit_of_length)
{
  for(const Named_complex& complex : traced(complexes())) {
    const auto lengths = random_lengths(complex.mesh, 3);
    const Triangulation t = triangulation(complex.mesh, lengths);
    for(double factor : {1e-30, 1e-3, 1e30}) {
      const Triangulation s = scaled(complex.mesh, lengths, factor);
      const Matrix l = IT::cotan_laplacian(t.input()), ls = IT::cotan_laplacian(s.input());
      EXPECT_LE(largest_distance(l, ls), 1e-13 * largest(l));
      const Matrix m = IT::mass_matrix(t.input()), ms = IT::mass_matrix(s.input());
      EXPECT_LE(largest_distance(m, ms / (factor * factor)), 1e-13 * largest(m));
    }
  }
}

TEST(Operators, long_double)
{
  const auto length = boost::make_function_property_map<Edge_index>(
    [](Edge_index e) { return 1 + static_cast<Real>(e.idx()) / 20; });
  const Delta_complex mesh = spindle();
  const IT::Surface_view surface(mesh, length);
  const Eigen::SparseMatrix<Real> l = IT::cotan_laplacian(surface);
  EXPECT_LT(static_cast<double>((l * Eigen::Matrix<Real, 3, 1>::Ones()).norm()), 1e-18);
  const Eigen::Matrix<Real, Eigen::Dynamic, 1> f = Eigen::Matrix<Real, 3, 1>(1, 2, 3);
  EXPECT_TRUE(IT::solve_poisson(surface, f).allFinite());
}

// ---- Tangent frames ----

TEST(Tangent_frames, Gauss_Bonnet)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Delta_complex& mesh = t.triangulation.mesh();
    const IT::Tangent_frames<> frames(t.triangulation.intrinsic());
    double sum = 0;
    for(Vertex_index v : mesh.vertices())
      sum += frames.angle_defect(v);
    const double euler = static_cast<double>(mesh.number_of_vertices()) -
                         static_cast<double>(mesh.number_of_edges()) +
                         static_cast<double>(mesh.number_of_faces());
    EXPECT_NEAR(sum, 2 * pi * euler, 1e-9);
  }
}

TEST(Tangent_frames, angles)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Delta_complex& mesh = t.triangulation.mesh();
    const Flat_faces faces(Side::intrinsic, t.triangulation);
    const IT::Tangent_frames<> frames(t.triangulation.intrinsic());
    for(Vertex_index v : mesh.vertices())
      EXPECT_EQ(frames.angle(IT::first_outgoing_halfedge(v, mesh)), 0);
    for(Halfedge_index h : mesh.halfedges()) {
      const Vertex_index v = mesh.source(h);
      if(mesh.is_border(h)) {
        EXPECT_EQ(frames.angle(h), std::acos(-1.));
        continue;
      }
      const Halfedge_index next = IT::next_around_source(h, mesh);
      const double whole = mesh.is_border(v) ? pi : 2 * pi;
      const double end = next == IT::first_outgoing_halfedge(v, mesh) ? whole : frames.angle(next);
      EXPECT_NEAR((end - frames.angle(h)) * frames.angle_sum(v) / whole,
                  static_cast<double>(faces.angle(h)), 1e-9);
    }
  }
}

TEST(Tangent_frames, transport_back_is_the_inverse)
{
  for(const Named_complex& complex : complexes()) {
    const Triangulation t = triangulation(complex.mesh, random_lengths(complex.mesh, 4));
    const IT::Tangent_frames<> frames(t.input());
    for(Halfedge_index h : complex.mesh.halfedges()) {
      EXPECT_NEAR(std::abs(frames.transport(h) * frames.transport(complex.mesh.opposite(h)) - 1.),
                  0, 1e-14);
      // The edge itself is transported to the edge.
      EXPECT_NEAR(std::abs(frames.transport(h) * std::polar(1., frames.angle(h)) +
                           std::polar(1., frames.angle(complex.mesh.opposite(h)))),
                  0, 1e-14);
    }
  }
}

// Around a vertex whose neighbors are flat, transport turns by its angle defect.
TEST(Tangent_frames, holonomy_around_a_cone)
{
  const std::size_t rings = 2, n = 9;
  for(double height : {0., 0.5, 2.}) {
    std::vector<Point> points{{0, 0, height}};
    Triangles triangles;
    for(std::size_t r = 1; r <= rings; ++r)
      for(std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = static_cast<double>(r);
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                            height * (1 - radius));
      }
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t a = 1 + i, b = 1 + (i + 1) % n;
      triangles.push_back({0, a, b});
      triangles.push_back({a, a + n, b});
      triangles.push_back({b, a + n, b + n});
    }
    const Mesh mesh = make_mesh(points, triangles);
    const IT::Tangent_frames<> frames(Triangulation(mesh).input());
    Complex turn = 1;
    for(std::size_t i = 0; i < n; ++i)
      turn *= frames.transport(mesh.halfedge(Vertex_index(static_cast<unsigned>(1 + i)),
                                             Vertex_index(static_cast<unsigned>(1 + (i + 1) % n))));
    const double defect = frames.angle_defect(Vertex_index(0));
    EXPECT_NEAR(std::abs(turn - std::polar(1., defect)), 0, 1e-12) << "height " << height;
  }
}

// ---- Connection Laplacian ----

TEST(Connection_laplacian, is_Hermitian_and_semidefinite_if_Delaunay)
{
  for(Named_triangulation& t : triangulations()) {
    SCOPED_TRACE(t.name);
    IT::make_Delaunay(t.triangulation);
    const IT::Tangent_frames<> frames(t.triangulation.intrinsic());
    const Eigen::SparseMatrix<Complex> l =
      IT::connection_laplacian(t.triangulation.intrinsic(), frames);
    const Eigen::MatrixXcd dense(l);
    EXPECT_LE((dense - dense.adjoint()).cwiseAbs().maxCoeff(), 1e-14 * dense.cwiseAbs().maxCoeff());
    if(is_closed(t.triangulation.mesh())) {
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(dense).eigenvalues()[0],
                -1e-9 * dense.cwiseAbs().maxCoeff());
    }
  }
}

TEST(Connection_laplacian, parallel_fields_on_flat_tori_are_its_kernel)
{
  for(const auto& [m, n] : {std::pair(1, 1), std::pair(2, 1), std::pair(3, 4), std::pair(6, 5)}) {
    const Flat_surface surface = flat_torus(m, n, 3);
    const Triangulation t = triangulation(surface);
    const IT::Tangent_frames<> frames(t.input());
    const Eigen::SparseMatrix<Complex> l = IT::connection_laplacian(t.input(), frames);
    EXPECT_LT((l * parallel_field(surface, frames)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// On the unit sphere the least eigenvalue is one.
TEST(Connection_laplacian, spectrum_of_the_sphere)
{
  std::vector<double> errors;
  for(std::size_t n : {4u, 8u, 16u, 32u}) {
    const Triangulation t(unit_sphere(n));
    const IT::Tangent_frames<> frames(t.input());
    const Eigen::SparseMatrix<Complex> l = IT::connection_laplacian(t.input(), frames);
    const Values mass = IT::lumped_mass_matrix(t.input()).diagonal();
    errors.push_back(std::abs(least_eigenvalue(l, mass) - 1));
  }
  EXPECT_LT(errors.back(), 2e-3);
  for(std::size_t k = 1; k < errors.size(); ++k)
    EXPECT_LT(errors[k], errors[k - 1] / 3) << errors[k - 1];
}

// ---- Poisson ----

TEST(Poisson, prescribed_values_on_a_square)
{
  std::vector<double> errors;
  for(std::size_t n : {8u, 16u, 32u, 64u}) {
    const Mesh mesh = unit_square(n, 1);
    Triangulation t(mesh);
    const Values u = values(mesh, [](const Point& p) {
      return std::sin(pi * p.x()) * std::sin(2 * pi * p.y()) + 2 * p.x() - p.y();
    });
    const Values f = values(mesh, [](const Point& p) {
      return 5 * pi * pi * std::sin(pi * p.x()) * std::sin(2 * pi * p.y());
    });
    const auto is_fixed = boost::make_function_property_map<Vertex_index>(
      [&](Vertex_index v) { return mesh.is_border(v); });
    const Values computed = IT::solve_poisson(t.intrinsic(), f, is_fixed, u);
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_border(v)) {
        EXPECT_EQ(computed[v.idx()], u[v.idx()]);
      }
    errors.push_back(mean_square(computed - u, IT::mass_matrix(t.input())));
  }
  expect_second_order(errors);
}

TEST(Poisson, free_boundary_of_a_square)
{
  std::vector<double> errors;
  for(std::size_t n : {8u, 16u, 32u, 64u}) {
    const Mesh mesh = unit_square(n, 2);
    const Triangulation t(mesh);
    const Values u =
      values(mesh, [](const Point& p) { return std::cos(pi * p.x()) * std::cos(2 * pi * p.y()); });
    const Values computed = IT::solve_poisson(t.input(), Values(5 * pi * pi * u));
    errors.push_back(mean_square(computed - u, IT::mass_matrix(t.input())));
  }
  expect_second_order(errors);
}

TEST(Poisson, spherical_harmonics)
{
  std::vector<double> errors;
  for(std::size_t n : {4u, 8u, 16u, 32u}) {
    const Mesh mesh = unit_sphere(n);
    const Triangulation t(mesh);
    const Values u = values(mesh, [](const Point& p) { return p.x() * p.y() + p.y() * p.z(); });
    const Values computed = IT::solve_poisson(t.input(), Values(6 * u));
    errors.push_back(mean_square(computed - u, IT::mass_matrix(t.input())));
  }
  expect_second_order(errors);
}

TEST(Poisson, wave_on_a_flat_torus)
{
  std::vector<double> errors;
  for(int n : {6, 12, 24, 48}) {
    const Flat_surface surface = flat_torus(n, n, 5);
    const Triangulation t = triangulation(surface);
    // The wave is constant along b and has one period along a.
    const double area = static_cast<double>(det(surface.a, surface.b));
    Values u(static_cast<Eigen::Index>(surface.point.size()));
    for(Vertex_index v : surface.mesh.vertices())
      u[v.idx()] = std::sin(2 * pi * static_cast<double>(det(surface.point[v], surface.b)) / area);
    const double wave_number = 2 * pi * length(surface.b) / area;
    const Values computed = IT::solve_poisson(t.input(), Values(wave_number * wave_number * u));
    errors.push_back(mean_square(computed - u, IT::mass_matrix(t.input())));
  }
  expect_second_order(errors);
}

// The solution of the discrete problem depends neither on the component nor on the unit.
TEST(Poisson, on_all_complexes)
{
  for(const Named_complex& complex : traced(complexes())) {
    const auto lengths = random_lengths(complex.mesh, 5);
    const Triangulation t = triangulation(complex.mesh, lengths),
                        s = scaled(complex.mesh, lengths, 1e-20);
    const Values f = Values::Random(static_cast<Eigen::Index>(complex.mesh.number_of_vertices()));
    const Matrix l = IT::cotan_laplacian(t.input());
    const Values u = IT::solve_poisson(t.input(), f);
    const Values area = IT::lumped_mass_matrix(t.input()).diagonal();
    const Values moments = IT::mass_matrix(t.input()) * f;
    EXPECT_LT(largest(l * u - moments + moments.sum() / area.sum() * area), 1e-12);
    EXPECT_NEAR(area.dot(u), 0, 1e-12);
    EXPECT_LT(largest(IT::solve_poisson(s.input(), f) * 1e40 - u), 1e-12 * (largest(u) + 1));
  }
}

} // namespace Test_operators

#endif
