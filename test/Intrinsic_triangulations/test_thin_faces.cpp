// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>
#include <CGAL/Intrinsic_triangulations/thin_faces.h>

#include <cmath>
#include <vector>

// These tests compare operators and heat on flat meshes with needles and caps at rounding errors
// with exact numbers.
namespace Test_thin_faces {

using namespace Test_surfaces;
using Number = IT::Exact_field;
using Precise = IT::Precise_surface<>;

// Returns a square grid before further vertices are added.
Mesh square(int n)
{
  Mesh mesh;
  std::vector<Vertex_index> v;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      v.push_back(mesh.add_vertex(Point(double(i) / n - 0.5, double(j) / n - 0.5, 0)));
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const auto at = [&](int x, int y) { return v[std::size_t((j + y) * (n + 1) + i + x)]; };
      mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
      mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
    }
  return mesh;
}

std::array<Number, 2> vector_between(const Point& p, const Point& q)
{
  return {Number(q.x()) - Number(p.x()), Number(q.y()) - Number(p.y())};
}

bool is_clockwise(const Point& p, const Point& q, const Point& r)
{
  const auto u = vector_between(p, q), v = vector_between(p, r);
  return u[0] * v[1] - u[1] * v[0] < 0;
}

// Inserts a vertex into a face, if no other vertex is there, and rounding has not moved it out of
// the face: then the mesh would be folded.
void insert(Mesh& mesh, Face_index f, const std::array<double, 3>& weight)
{
  const Halfedge_index h = mesh.halfedge(f);
  const std::array<Vertex_index, 3> corner{mesh.source(h), mesh.target(h),
                                           mesh.target(mesh.next(h))};
  const double sum = weight[0] + weight[1] + weight[2];
  std::array<double, 2> at{};
  for(std::size_t k = 0; k < 3; ++k)
    for(int c = 0; c < 2; ++c)
      at[std::size_t(c)] += weight[k] / sum * mesh.point(corner[k])[c];
  const Point p(at[0], at[1], 0);
  for(const Vertex_index v : mesh.vertices())
    if(CGAL::squared_distance(mesh.point(v), p) < 1e-70)
      return;
  for(std::size_t k = 0; k < 3; ++k)
    if(is_clockwise(p, mesh.point(corner[k]), mesh.point(corner[(k + 1) % 3])))
      return;
  mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = p;
}

// Returns a grid with vertices close to others and to edges, also on the boundary. Coordinates near
// to zero have all digits.
Mesh spoiled_square(double e, unsigned int seed)
{
  CGAL::Random random(seed);
  Mesh mesh = square(6);
  for(int i = 0; i < 12; ++i) {
    std::array<double, 3> weight{1, e, e};
    if(random.get_int(0, 2) == 0)
      weight[2] = 1;
    std::rotate(weight.begin(), weight.begin() + random.get_int(0, 3), weight.end());
    insert(mesh, Face_index(std::uint32_t(random.get_int(0, int(mesh.number_of_faces())))), weight);
  }
  return mesh;
}

// Returns the cotangent at `p`, from exact positions. It is infinite if the area is zero.
Number cotangent(const Point& p, const Point& q, const Point& r, bool& has_area)
{
  const auto u = vector_between(p, q), v = vector_between(p, r);
  const Number dot = u[0] * v[0] + u[1] * v[1], cross = u[0] * v[1] - u[1] * v[0];
  has_area = cross != 0;
  return has_area ? Number(dot / CGAL::abs(cross)) : Number(0);
}

// Returns the weight of an edge of T2, whose edges are straight lines in the plane.
double weight(Edge_index e, const Triangulation& t, const Mesh& mesh)
{
  const Delta_complex& m = t.mesh();
  Number sum(0);
  for(const Halfedge_index h : {m.halfedge(e), m.opposite(m.halfedge(e))})
    if(bool has_area = false; !m.is_border(h))
      sum += cotangent(mesh.point(m.target(m.next(h))), mesh.point(m.source(h)),
                       mesh.point(m.target(h)), has_area);
  return CGAL::to_double(Number(sum / 2));
}

Eigen::SparseMatrix<double> laplacian(const Triangulation& t)
{
  return IT::with_resolved_areas(
    t, [](const auto& surface) { return IT::rounded_values(IT::cotan_laplacian(surface)); });
}

// Checks that weights of nearly equal size have the same sign, or differ by more than rounding
// errors.
void expect_exact_weights(const Triangulation& t, const Mesh& mesh)
{
  const auto weights = IT::with_resolved_areas(t, [](const auto& surface) {
    std::vector<double> result;
    for(const auto& w : IT::internal::cotan_weights(surface))
      result.push_back(CGAL::to_double(w));
    return result;
  });
  for(const Edge_index e : t.mesh().edges()) {
    const double exact = weight(e, t, mesh);
    EXPECT_NEAR(weights[e.idx()], exact, 1e-7 * (1 + std::abs(exact))) << e;
  }
}

constexpr double smallness[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13, 1e-16, 1e-30, 1e-100, 1e-300};

TEST(Thin_faces, weights_are_those_of_exact_positions)
{
  for(const double e : smallness)
    for(unsigned int seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(testing::Message() << e << ' ' << seed);
      const Mesh mesh = spoiled_square(e, seed);
      Triangulation t(mesh);
      IT::make_Delaunay(t);
      expect_exact_weights(t, mesh);
      EXPECT_TRUE(laplacian(t).coeffs().allFinite());
    }
}

TEST(Thin_faces, areas_are_those_of_exact_positions)
{
  for(const double e : smallness) {
    const Mesh mesh = spoiled_square(e, 5);
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const double area = IT::with_resolved_areas(t, [](const auto& surface) {
      return IT::rounded_values(IT::lumped_mass_matrix(surface)).sum();
    });
    EXPECT_NEAR(area, 1, 1e-10) << e;
  }
}

// Needles do not affect heat: distances are distances on the grid, up to the error of the method.
TEST(Thin_faces, distances_by_heat)
{
  for(const double e : smallness) {
    SCOPED_TRACE(e);
    const Mesh mesh = spoiled_square(e, 3);
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const auto distances = IT::with_resolved_areas(t, [](const auto& surface) {
      return IT::rounded_values(IT::heat_distance(surface, Vertex_index(24)));
    });
    for(const Vertex_index v : t.mesh().vertices()) {
      const double exact = std::sqrt(CGAL::squared_distance(mesh.point(v), Point(0, 0, 0)));
      EXPECT_NEAR(distances[v.idx()], exact, 0.15) << v;
    }
  }
}

template <typename Matrix>
Matrix with_all_digits(const Matrix& matrix)
{
  return matrix.unaryExpr(
    [](const IT::Multiprecision_float& x) { return IT::Multiprecision_float(x.long_value()); });
}

// Rows with large entries are eliminated first, then the others in `double`: the result is the same
// as with all digits.
TEST(Thin_faces, factors_with_many_digits)
{
  typedef IT::Multiprecision_float FT;
  typedef Eigen::SparseMatrix<FT> Matrix;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  for(const double e : {1e-9, 1e-14, 1e-30, 1e-250}) {
    const Mesh mesh = spoiled_square(e, 1);
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const Precise surface(t);
    Matrix matrix = IT::cotan_laplacian(surface);
    for(int i = 0; i < matrix.rows(); ++i)
      matrix.coeffRef(i, i) += FT(1);
    Vector right_side(matrix.rows());
    for(int i = 0; i < matrix.rows(); ++i)
      right_side[i] = FT(1 + i % 7);
    const Vector solution = IT::Factorization<FT>(matrix, "matrix").solve(right_side);
    Eigen::SimplicialLLT<Matrix> all_digits(with_all_digits(matrix));
    const Vector exact = all_digits.solve(right_side);
    for(int i = 0; i < matrix.rows(); ++i)
      EXPECT_LT(CGAL::to_double(FT(abs(solution[i] - exact[i]))), 1e-9) << e << ' ' << i;
  }
}

// The digits of numbers depend on their faces: one needle does not slow down all operators.
TEST(Thin_faces, few_numbers_have_many_digits)
{
  Mesh mesh = square(20);
  insert(mesh, Face_index(350), {1, 1e-14, 1e-14});
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  const Precise surface(t);
  const auto is_long = [](const auto& x) { return x.is_long(); };
  const auto number_in = [&](const auto& numbers) {
    return std::count_if(numbers.begin(), numbers.end(), is_long);
  };
  std::vector<Precise::FT> lengths;
  for(const Edge_index e : t.mesh().edges())
    lengths.push_back(surface.length_map()[e]);
  EXPECT_GE(number_in(lengths), 3);
  EXPECT_LE(number_in(lengths), 10);
  const auto matrix = IT::cotan_laplacian(surface);
  EXPECT_LE(number_in(matrix.coeffs()), 60);
  const auto heat = IT::heat_distance(surface, Vertex_index(0));
  EXPECT_TRUE(IT::rounded_values(heat).allFinite());
  EXPECT_LE(number_in(heat), 10);
}

// A face of zero area at the boundary does not count: the operators are the operators without it.
TEST(Thin_faces, faces_of_no_area_are_left_out)
{
  const Mesh good = square(4);
  Mesh mesh = good;
  const Vertex_index a(0), b(1), c(2);
  ASSERT_NE(mesh.add_face(b, a, c), Mesh::null_face());
  Triangulation t(mesh), without(good);
  IT::make_Delaunay(t);
  IT::make_Delaunay(without);
  EXPECT_TRUE(IT::has_unresolved_areas(t.intrinsic()));
  const Eigen::MatrixXd difference = Eigen::MatrixXd(laplacian(t)) - laplacian(without);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Thin_faces, a_surface_without_area_has_no_operators)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)),
                mesh.add_vertex(Point(2, 0, 0)));
  const Triangulation t(mesh);
  EXPECT_THROW(laplacian(t), IT::Numerical_error);
}

// Two vertices at the midpoint of an edge, one on each side, have the distance zero, so no metric
// exists.
TEST(Thin_faces, vertices_that_coincide)
{
  Mesh mesh = square(2);
  const Edge_index e = *std::find_if(mesh.edges().begin(), mesh.edges().end(),
                                     [&](Edge_index x) { return !mesh.is_border(x); });
  const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
  const Point middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  for(const Halfedge_index x : {h, o})
    mesh.point(mesh.target(CGAL::Euler::add_center_vertex(x, mesh))) = middle;
  Triangulation t(mesh);
  EXPECT_THROW(IT::make_Delaunay(t), IT::Numerical_error);
}

TEST(Thin_faces, connections_and_signed_distances)
{
  const Mesh mesh = spoiled_square(1e-14, 2);
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  IT::with_resolved_areas(t, [&](const auto& surface) {
    typedef IT::Length_of<std::decay_t<decltype(surface)>> FT;
    const IT::Tangent_frames<FT> frames(surface);
    EXPECT_TRUE(IT::rounded_values(IT::connection_laplacian(surface, frames)).coeffs().allFinite());
    const auto curve =
      IT::curve_along_edges(surface, std::vector{t.mesh().halfedge(Edge_index(9))});
    const auto distance = IT::rounded_values(
      IT::signed_heat_distance(surface, curve, IT::parameters::time_step_factor(100)));
    EXPECT_TRUE(distance.allFinite());
  });
}

TEST(Thin_faces, which_lengths_determine_angles_and_areas)
{
  const auto with_height = [](double height) {
    Mesh mesh;
    mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)),
                  mesh.add_vertex(Point(0.5, height, 0)));
    return Triangulation(mesh);
  };
  const auto angles = [&](double h) { return IT::has_unresolved_angles(with_height(h).input()); };
  const auto areas = [&](double h) { return IT::has_unresolved_areas(with_height(h).input()); };
  EXPECT_FALSE(angles(1e-6));
  EXPECT_TRUE(angles(1e-7));
  EXPECT_TRUE(angles(0));
  EXPECT_FALSE(areas(1e-2));
  EXPECT_TRUE(areas(1e-4));
}

} // namespace Test_thin_faces

#endif // CGAL_EIGEN3_ENABLED
