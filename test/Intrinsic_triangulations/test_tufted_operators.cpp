// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "matrices.h"
#include "soups.h"

#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>
#include <Eigen/Eigenvalues>

namespace Test_tufted_operators {

using namespace Test_surfaces;
using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::VectorXd;
using Triangulation = IT::Intrinsic_triangulation<>;
using Surface = IT::Tufted_surface<>;

struct Tufted
{
  explicit Tufted(const Soup& soup, bool is_flipped = true)
    : cover(IT::tufted_cover(soup.points, soup.triangles)), triangulation(cover.mesh())
  {
    if(is_flipped)
      IT::make_Delaunay(triangulation);
  }

  Surface surface() const { return Surface(cover, triangulation.intrinsic()); }

  IT::Tufted_cover<Point> cover;
  Triangulation triangulation;
};

// Returns the sum of the operators of single triangles, from positions.
Matrix sum_of_laplacians(const Soup& soup)
{
  const auto n = static_cast<Eigen::Index>(soup.points.size());
  std::vector<Eigen::Triplet<double>> entries;
  for(const auto& t : soup.triangles)
    for(std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<int>(t[(i + 1) % 3]), b = static_cast<int>(t[(i + 2) % 3]);
      const auto v = soup.points[t[(i + 1) % 3]] - soup.points[t[i]];
      const auto w = soup.points[t[(i + 2) % 3]] - soup.points[t[i]];
      const double c = v * w / std::sqrt(CGAL::cross_product(v, w).squared_length()) / 2;
      for(const auto& [row, column, value] :
          {std::tuple(a, a, c), std::tuple(b, b, c), std::tuple(a, b, -c), std::tuple(b, a, -c)})
        entries.emplace_back(row, column, value);
    }
  Matrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double area(const Soup& soup)
{
  double result = 0;
  for(const auto& [a, b, c] : soup.triangles)
    result += std::sqrt(CGAL::cross_product(soup.points[b] - soup.points[a],
                                            soup.points[c] - soup.points[a])
                          .squared_length()) /
              2;
  return result;
}

// Returns a grid whose boundary edges are Delaunay in the double.
Mesh sharp_grid(std::size_t n)
{
  Book page({0.5}, n, n);
  return make_mesh(page.soup.points, page.soup.triangles);
}

void expect_equal_operators(const Surface& a,
                            const IT::Surface_view<Triangulation::Edge_length_map>& b)
{
  const double scale = largest(IT::cotan_laplacian(b));
  EXPECT_LT(largest_distance(IT::cotan_laplacian(a), IT::cotan_laplacian(b)), 1e-12 * scale);
  EXPECT_LT(largest_distance(IT::lumped_mass_matrix(a), IT::lumped_mass_matrix(b)),
            1e-13 * largest(IT::lumped_mass_matrix(b)));
  EXPECT_LT(largest_distance(IT::mass_matrix(a), IT::mass_matrix(b)),
            1e-13 * largest(IT::mass_matrix(b)));
}

// ---- Manifold meshes ----

TEST(Tufted_operators, are_the_ordinary_ones_of_closed_meshes)
{
  for(unsigned int seed : seeds(20)) {
    CGAL::Random random(seed);
    const Mesh mesh = random_sphere(5 + 10 * seed, seed);
    Triangulation ordinary(mesh);
    IT::make_Delaunay(ordinary);
    Soup soup = soup_of(mesh);
    flip_orientations(soup, random);
    expect_equal_operators(Tufted(soup).surface(), ordinary.intrinsic());
  }
}

TEST(Tufted_operators, are_the_ordinary_ones_with_boundary)
{
  const Mesh mesh = sharp_grid(6);
  expect_equal_operators(Tufted(soup_of(mesh)).surface(), Triangulation(mesh).intrinsic());
}

TEST(Tufted_operators, have_distances_of_closed_meshes)
{
  const Mesh mesh = random_sphere(60, 7);
  Triangulation ordinary(mesh);
  IT::make_Delaunay(ordinary);
  const Values expected = IT::heat_distance(ordinary.intrinsic(), std::array{Vertex_index(3)});
  const Values found =
    IT::heat_distance(Tufted(soup_of(mesh)).surface(), std::array{Vertex_index(3)});
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-10);
}

// ---- Any soup ----

TEST(Tufted_operators, without_flips_are_sums_over_triangles)
{
  for(unsigned int seed : seeds(30)) {
    const Soup soup = random_soup(seed);
    const Matrix expected = sum_of_laplacians(soup);
    EXPECT_LT(largest_distance(IT::cotan_laplacian(Tufted(soup, false).surface()), expected),
              1e-9 * largest(expected));
  }
}

void expect_good_operators(const Soup& soup, const Tufted& tufted)
{
  const Surface surface = tufted.surface();
  const Matrix laplacian = IT::cotan_laplacian(surface);
  ASSERT_EQ(laplacian.rows(), static_cast<Eigen::Index>(soup.points.size()));
  const double scale = largest(laplacian);
  EXPECT_EQ(largest_distance(laplacian, laplacian.transpose()), 0);
  EXPECT_LT((laplacian * Values::Ones(laplacian.rows())).cwiseAbs().maxCoeff(), 1e-13 * scale);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(laplacian, Eigen::EigenvaluesOnly);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-13 * scale);
  EXPECT_NEAR(IT::mass_matrix(surface).sum() / area(soup), 1, 1e-12);
  const Values mass = IT::lumped_mass_matrix(surface).diagonal();
  for(const auto& triangle : soup.triangles)
    for(std::size_t v : triangle)
      EXPECT_GT(mass[static_cast<Eigen::Index>(v)], 0); // other vertices have no faces
  EXPECT_NEAR(mass.sum() / area(soup), 1, 1e-12);
  EXPECT_LT(
    largest_distance(IT::divergence_matrix(surface) * IT::gradient_matrix(surface), -laplacian),
    1e-10 * scale);
}

// Returns the distances from a vertex.
Values expect_good_results(const Soup& soup)
{
  const Tufted tufted(soup);
  EXPECT_TRUE(IT::is_Delaunay(tufted.triangulation));
  expect_good_operators(soup, tufted);
  const std::size_t source = soup.triangles.front()[0];
  Values distance = IT::heat_distance(
    tufted.surface(), std::array{Vertex_index(static_cast<Mesh::size_type>(source))});
  EXPECT_EQ(distance[static_cast<Eigen::Index>(source)], 0);
  EXPECT_FALSE(distance.hasNaN());
  return distance;
}

TEST(Tufted_operators, of_300_soups)
{
  for(unsigned int seed : seeds(300)) {
    const Values distance = expect_good_results(random_soup(seed));
    EXPECT_TRUE(distance.allFinite());
    EXPECT_GT(distance.maxCoeff(), 0);
  }
}

TEST(Tufted_operators, of_300_spoiled_meshes)
{
  for(unsigned int seed : seeds(300)) {
    const Mesh torus = perturbed(embedded_torus(3 + seed % 7, 3 + seed % 5), 0.1, seed);
    expect_good_results(spoiled(torus, seed));
  }
}

// Without ties, the surface depends on neither orientations nor the order of faces and vertices.
TEST(Tufted_operators, do_not_depend_on_numbers)
{
  for(unsigned int seed : seeds(30)) {
    CGAL::Random random(seed);
    Soup soup = random_part(0, random);
    move_points(soup, 0.02, random);
    std::vector<std::size_t> number(soup.points.size());
    std::iota(number.begin(), number.end(), std::size_t(0));
    CGAL::cpp98::random_shuffle(number.begin(), number.end(), random);
    Soup other = soup;
    for(std::size_t v = 0; v < number.size(); ++v)
      other.points[number[v]] = soup.points[v];
    for(auto& t : other.triangles)
      t = {number[t[1]], number[t[2]], number[t[0]]};
    flip_orientations(other, random);
    CGAL::cpp98::random_shuffle(other.triangles.begin(), other.triangles.end(), random);

    const Matrix a = IT::cotan_laplacian(Tufted(soup).surface());
    const Matrix b = IT::cotan_laplacian(Tufted(other).surface());
    for(Eigen::Index i = 0; i < a.rows(); ++i)
      for(Eigen::Index j = 0; j < a.cols(); ++j)
        EXPECT_NEAR(a.coeff(i, j),
                    b.coeff(static_cast<Eigen::Index>(number[static_cast<std::size_t>(i)]),
                            static_cast<Eigen::Index>(number[static_cast<std::size_t>(j)])),
                    1e-10 * largest(a));
  }
}

TEST(Tufted_operators, leave_isolated_vertices_out)
{
  Soup soup = Book({0, 1, 2}, 2, 2).soup;
  soup.points.insert(soup.points.begin() + 4, Point(7, 7, 7));
  for(auto& t : soup.triangles)
    for(std::size_t& v : t)
      v += v >= 4 ? 1 : 0;
  const Surface surface = Tufted(soup).surface();
  EXPECT_EQ(IT::cotan_laplacian(surface).col(4).nonZeros(), 0);
  const Values distance = IT::heat_distance(surface, std::array{Vertex_index(0)});
  for(Eigen::Index v = 0; v < distance.size(); ++v)
    EXPECT_EQ(std::isfinite(distance[v]), v != 4);
}

// A flat face whose edge can be flipped causes no failure.
TEST(Tufted_operators, cope_with_flat_faces)
{
  const Soup soup{{{0, 0, 0}, {0, 0, 2}, {0, 0, 1}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}}};
  const Tufted tufted(soup);
  const Matrix laplacian = IT::cotan_laplacian(tufted.surface());
  EXPECT_TRUE(Eigen::MatrixXd(laplacian).allFinite());
  EXPECT_GT(laplacian.coeff(2, 2), 0);
}

// ---- Books ----

// Returns the values of a function of the page and the distances from the spine and from the lower
// side.
Values values(const Book& book, std::size_t pages,
              const std::function<double(std::size_t, double, double)>& f)
{
  Values result(static_cast<Eigen::Index>(book.soup.points.size()));
  for(std::size_t page = 0; page < pages; ++page)
    for(std::size_t i = 0; i <= book.m; ++i)
      for(std::size_t j = 0; j <= book.n; ++j)
        result[static_cast<Eigen::Index>(book.vertex(page, i, j))] =
          f(page, static_cast<double>(i) / static_cast<double>(book.m),
            static_cast<double>(j) / static_cast<double>(book.n));
  return result;
}

// Represents a function on three squares glued along a side. Even functions have a cosine across
// the spine. The others have a sine of half-integer frequency, with coefficients on the pages that
// add up to zero.
struct Mode
{
  std::array<double, 3> on_page; // equal, or with sum zero
  double across, along;          // frequencies

  double operator()(std::size_t page, double x, double y) const
  {
    const double wave =
      on_page[0] == on_page[1] ? std::cos(pi * across * x) : std::sin(pi * across * x);
    return on_page[page] * wave * std::cos(pi * along * y);
  }
};

std::vector<Mode> modes(int n)
{
  std::vector<Mode> result;
  for(int a = 0; a < n; ++a)
    for(int b = 0; b < n; ++b) {
      result.push_back({{1, 1, 1}, double(a), double(b)});
      result.push_back({{1, -1, 0}, a + 0.5, double(b)});
      result.push_back({{1, 1.5, -2.5}, a + 0.5, double(b)});
    }
  return result;
}

// On squares the Laplacian is the five-point one, whose eigenfunctions have closed forms, too.
TEST(Tufted_operators, of_a_book_have_the_known_eigenfunctions)
{
  const std::size_t n = 8;
  const Book book({0.3, 2, 4.5}, n, n);
  const Matrix laplacian = IT::cotan_laplacian(Tufted(book.soup).surface());
  // These are the shares of vertices in the squares, over the area of a square.
  const Values share = values(book, 3, [](std::size_t, double x, double y) {
    return (x == 0 ? 1.5 : x == 1 ? 0.5 : 1) * (y == 0 || y == 1 ? 0.5 : 1);
  });
  for(const Mode& mode : modes(static_cast<int>(n))) {
    const Values u = values(book, 3, mode);
    const double h = 1. / static_cast<double>(n);
    const double eigenvalue =
      4 - 2 * std::cos(pi * mode.across * h) - 2 * std::cos(pi * mode.along * h);
    EXPECT_LT((laplacian * u - eigenvalue * share.cwiseProduct(u)).cwiseAbs().maxCoeff(), 1e-13)
      << mode.across << ' ' << mode.along;
  }
}

// The spectrum converges to the spectrum of three glued squares: pi^2 times (k/2)^2 + l^2, twice if
// k is odd.
TEST(Tufted_operators, of_a_book_have_the_known_spectrum)
{
  std::vector<double> exact;
  for(int k = 0; k < 8; ++k)
    for(int l = 0; l < 5; ++l)
      exact.insert(exact.end(), k % 2 == 1 ? 2u : 1u, pi * pi * (k * k / 4. + l * l));
  std::sort(exact.begin(), exact.end());
  std::vector<double> errors;
  for(const std::size_t n : {4u, 8u, 12u}) {
    CGAL::Random random(1);
    Soup soup = Book({0.3, 2, 4.5}, n, n).soup;
    flip_orientations(soup, random);
    const Surface surface = Tufted(soup).surface();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      Eigen::MatrixXd(IT::cotan_laplacian(surface)), Eigen::MatrixXd(IT::mass_matrix(surface)),
      Eigen::EigenvaluesOnly);
    double error = 0;
    for(Eigen::Index i = 0; i < 12; ++i)
      error = (std::max)(error, std::abs(eigen.eigenvalues()[i] - exact[std::size_t(i)]));
    errors.push_back(error / exact[11]);
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
  EXPECT_LT(errors[2], 0.03);
}

// Three cylinders of equilateral triangles glued along circles have no positions in a plane.
TEST(Tufted_operators, of_lengths_alone)
{
  const std::size_t m = 4, n = 6;
  Triangles triangles;
  const auto vertex = [&](std::size_t page, std::size_t i, std::size_t j) {
    return (i == 0 ? 0 : 1 + page * m + i - 1) * n + j % n;
  };
  // The triangulation is sheared three times around, so it is not Delaunay.
  std::vector<std::array<double, 3>> lengths;
  const double across = std::sqrt(0.75), far = std::hypot(across, 2.5),
               near = std::hypot(across, 1.5);
  for(std::size_t page = 0; page < 3; ++page)
    for(std::size_t i = 0; i < m; ++i)
      for(std::size_t j = 0; j < n; ++j) {
        const std::size_t a = vertex(page, i, j), b = vertex(page, i, j + 1);
        const std::size_t c = vertex(page, i + 1, j + 3), d = vertex(page, i + 1, j + 2);
        triangles.push_back({a, b, c});
        lengths.push_back({1, near, far});
        triangles.push_back({a, c, d});
        lengths.push_back({far, 1, near});
      }
  const std::size_t vertices = (1 + 3 * m) * n;
  const auto cover = IT::tufted_cover(vertices, triangles);
  Triangulation t(cover.mesh(), IT::parameters::edge_length_map(cover.edge_length_map(lengths)));
  IT::make_Delaunay(t);
  const Surface surface(cover, t.intrinsic());
  // Each edge inside the lattice has the weight of two angles of sixty degrees.
  const Matrix laplacian = IT::cotan_laplacian(surface);
  const double weight = 1 / std::sqrt(3.);
  const auto at = [&](std::size_t v) { return laplacian.coeff(int(v), int(v)); };
  EXPECT_NEAR(at(vertex(1, 2, 3)), 6 * weight, 1e-12);
  EXPECT_NEAR(at(vertex(1, 0, 3)), (3 * 2 + 3) * weight, 1e-12);
  EXPECT_NEAR(at(vertex(1, m, 3)), 3 * weight, 1e-12);
  EXPECT_NEAR(IT::mass_matrix(surface).sum(), 3. * double(m * n) * across, 1e-12);
}

// Two unfolded pages are a plane.
TEST(Tufted_operators, have_distances_of_unfolded_books)
{
  for(const std::size_t pages : traced({2u, 3u, 4u, 7u})) {
    std::vector<double> angles;
    for(std::size_t i = 0; i < pages; ++i)
      angles.push_back(6 * double(i * i + 1) / double(pages * pages + 1));
    const Book book(angles, 16, 16);
    const double x0 = 0.5, y0 = 0.25;
    const Values exact = values(book, pages, [&](std::size_t page, double x, double y) {
      return std::hypot(page == 0 ? x - x0 : x + x0, y - y0);
    });
    const Values found = IT::heat_distance(
      Tufted(book.soup).surface(), std::array{Vertex_index(unsigned(book.vertex(0, 8, 4)))});
    // This is the error of the method on the plane, which two pages form.
    static double error_of_two = 0;
    const double error = (found - exact).cwiseAbs().sum() / exact.sum();
    if(pages == 2)
      error_of_two = error;
    EXPECT_LT(error, 0.04);
    EXPECT_LT(error, 1.5 * error_of_two);
  }
}

// A function that is linear on each page has the slopes of a harmonic function.
TEST(Tufted_operators, solve_poisson_equations)
{
  const Book book({0, 2, 4}, 5, 4);
  const Values exact = values(
    book, 3, [](std::size_t page, double x, double) { return (page == 2 ? 3. : -1.5) * x + 1; });
  const Surface surface = Tufted(book.soup).surface();
  std::vector<char> is_fixed(book.soup.points.size(), 0);
  for(std::size_t page = 0; page < 3; ++page)
    for(std::size_t j = 0; j <= book.n; ++j)
      is_fixed[book.vertex(page, book.m, j)] = 1;
  const Values zero = Values::Zero(exact.size());
  const Values found = IT::solve_poisson(surface, zero,
                                         boost::make_function_property_map<Vertex_index>(
                                           [&](Vertex_index v) { return is_fixed[v] != 0; }),
                                         exact);
  EXPECT_LT((found - exact).cwiseAbs().maxCoeff(), 1e-12);
}

// Inserted vertices come after the vertices of the soup.
TEST(Tufted_operators, of_a_refined_cover)
{
  CGAL::Random random(5);
  Soup soup = Book({0, 1, 2, 3.5}, 3, 2, 4, 1).soup;
  move_points(soup, 0.1, random);
  Tufted tufted(soup);
  IT::refine(tufted.triangulation, IT::parameters::minimum_angle(25));
  ASSERT_GT(tufted.triangulation.number_of_inserted_vertices(), 0u);
  const Matrix laplacian = IT::cotan_laplacian(tufted.surface());
  EXPECT_EQ(std::size_t(laplacian.rows()),
            soup.points.size() + tufted.triangulation.number_of_inserted_vertices());
  EXPECT_LT((laplacian * Values::Ones(laplacian.rows())).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_NEAR(IT::mass_matrix(tufted.surface()).sum() / area(soup), 1, 1e-12);
}

// Vertices without a vertex fan have no vectors.
static_assert(!std::is_constructible_v<IT::Tangent_frames<double>, const Surface&>);

// Vectors belong to the cover: along a flat book of two pages they stay parallel.
TEST(Tufted_operators, transport_vectors_on_the_cover)
{
  const Book book({0, pi}, 4, 4);
  const Tufted tufted(book.soup);
  const IT::Vector_heat<double> heat(tufted.triangulation.intrinsic());
  const auto field = heat.transport(Vertex_index(12), std::complex<double>(2, 1));
  for(Eigen::Index v = 0; v < field.size(); ++v)
    EXPECT_NEAR(std::abs(field[v]), std::sqrt(5.), 1e-9);
}

} // namespace Test_tufted_operators

#endif // CGAL_EIGEN3_ENABLED
