// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the map between levels, and its matrices.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/prolongation.h>

namespace Test_surface_map {

using namespace Test_surfaces;

void expect_near(const Location& p, const Location& q, double tolerance)
{
  ASSERT_EQ(p.first, q.first);
  for(std::size_t s = 0; s < 3; ++s)
    EXPECT_NEAR(p.second[s], q.second[s], tolerance);
}

void expect_inside(const Location& p)
{
  ASSERT_TRUE(p.first.is_valid());
  for(double x : p.second)
    EXPECT_GE(x, 0);
  EXPECT_NEAR(p.second[0] + p.second[1] + p.second[2], 1, 1e-15);
}

TEST(Surface_map, there_and_back)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    CGAL::Random random(1);
    for(int n = 0; n < 100; ++n) {
      const Location p = random_location(s.fine.mesh(), random);
      expect_inside(map.to_coarse(p));
      expect_near(map.to_fine(map.to_coarse(p)), p, 1e-9);
      const Location q = random_location(s.coarse.mesh(), random);
      expect_inside(map.to_fine(q));
      expect_near(map.to_coarse(map.to_fine(q)), q, 1e-9);
    }
  });
}

// Remaining vertices keep their positions, and a coordinate of zero stays exactly zero.
TEST(Surface_map, of_vertices)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    for(Halfedge_index h : s.fine.mesh().halfedges()) {
      const Vertex_index v = s.coarse.level_vertex(s.fine.surface_vertex(s.fine.mesh().source(h)));
      if(s.fine.mesh().is_border(h) || !v.is_valid())
        continue;
      Coordinates corner{};
      corner[IT::side_number(h, s.fine.mesh())] = 1;
      const auto [f, b] = map.to_coarse({s.fine.mesh().face(h), corner});
      const auto sides = IT::sides(f, s.coarse.mesh());
      for(std::size_t t = 0; t < 3; ++t)
        EXPECT_TRUE(b[t] == 0 || (b[t] == 1 && s.coarse.mesh().source(sides[t]) == v));
    }
  });
}

// A point of an edge may be given as such.
TEST(Surface_map, of_points_of_edges)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    const auto middle = [](const Delta_complex& mesh) {
      return IT::Surface_point<double>(
        IT::Edge_location<double>{mesh.halfedge(*mesh.edges().begin()), {0.5, 0.5}});
    };
    const auto fine = middle(s.fine.mesh()), coarse = middle(s.coarse.mesh());
    EXPECT_EQ(map.to_coarse(fine), map.to_coarse(IT::face_location(fine, s.fine.mesh())));
    EXPECT_EQ(map.to_fine(coarse), map.to_fine(IT::face_location(coarse, s.coarse.mesh())));
  });
}

TEST(Surface_map, is_continuous_across_edges)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    for(Edge_index e : s.fine.mesh().edges()) {
      const Halfedge_index h = s.fine.mesh().halfedge(e), o = s.fine.mesh().opposite(h);
      if(s.fine.mesh().is_border(h) || s.fine.mesh().is_border(o))
        continue;
      for(const double t : {0.1, 0.4, 0.75})
        expect_same_place(map.to_coarse(location(h, t, s.fine.mesh())),
                          map.to_coarse(location(o, 1 - t, s.fine.mesh())), s.coarse.mesh());
    }
  });
}

TEST(Surface_map, keeps_the_boundary)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    for(Halfedge_index h : s.fine.mesh().halfedges())
      if(s.fine.mesh().is_border(s.fine.mesh().opposite(h))) {
        const Location p = map.to_coarse(location(h, 0.3, s.fine.mesh()));
        bool is_on_border = false;
        for(Halfedge_index side : IT::sides(p.first, s.coarse.mesh()))
          is_on_border =
            is_on_border || (s.coarse.mesh().is_border(s.coarse.mesh().opposite(side)) &&
                             IT::coordinates_from(side, p, s.coarse.mesh())[2] == 0);
        EXPECT_TRUE(is_on_border) << "halfedge " << h;
      }
  });
}

// Returns twice the area of a triangle, relative to the face. Differences are computed first,
// because it may be tiny.
double signed_area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The images of small triangles are small triangles of the same orientation.
TEST(Surface_map, keeps_the_orientation)
{
  int checked = 0;
  for_each_surface([&](const Simplified& s, const Surface_map& map) {
    CGAL::Random random(2);
    for(int n = 0; n < 100; ++n) {
      const Location p = random_location(s.coarse.mesh(), random);
      const double step = 1e-6 * *std::min_element(p.second.begin(), p.second.end());
      const auto image = [&](double x, double y) {
        return map.to_fine({p.first, {p.second[0] - x - y, p.second[1] + x, p.second[2] + y}});
      };
      const Location a = image(0, 0), b = image(step, 0), c = image(0, step);
      if(a.first != b.first || a.first != c.first)
        continue;
      EXPECT_GT(signed_area(a.second, b.second, c.second), 0);
      ++checked;
    }
  });
  EXPECT_GT(checked, 5000);
}

TEST(Surface_map, of_a_flat_polygon_is_the_identity)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map& map) {
    CGAL::Random random(3);
    for(int n = 0; n < 300; ++n) {
      const Location p = random_location(s.fine.mesh(), random);
      const Point before = place(p, s.fine, mesh), after = place(map.to_coarse(p), s.coarse, mesh);
      EXPECT_LT(std::sqrt(CGAL::squared_distance(before, after)), 1e-8);
    }
  });
}

// Four points on a line: the crossing of both diagonals has one position on the line, which depends
// on lengths only.
TEST(Flip_geometry, of_points_on_a_line)
{
  CGAL::Random random(5);
  for(int n = 0; n < 1000; ++n) {
    std::array<double, 4> x; // of i, j, k and l
    for(double& position : x)
      position = n % 2 ? random.get_int(0, 64) : random.get_double(0, 64);
    const auto [low, high] = std::minmax({x[2], x[3]});
    if(x[0] == x[1] || low > (std::max)(x[0], x[1]) || high < (std::min)(x[0], x[1]))
      continue; // the diagonals do not meet
    const auto d = [&](int a, int b) { return std::abs(x[std::size_t(a)] - x[std::size_t(b)]); };
    const auto [length, s, t] =
      IS::internal::flip_geometry({d(0, 1), d(1, 2), d(2, 0), d(0, 3), d(3, 1)});
    EXPECT_NEAR(x[0] + s * (x[1] - x[0]), x[3] + t * (x[2] - x[3]), 1e-6) << n;
  }
}

// A point on the line of three corners has weights that keep its position.
TEST(Weights_from_lengths, of_points_on_a_line)
{
  CGAL::Random random(6);
  for(int n = 0; n < 1000; ++n) {
    std::array<double, 3> x, outgoing, side;
    for(double& position : x)
      position = n % 2 ? random.get_int(0, 64) : random.get_double(0, 64);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    if(*low == *high)
      continue;
    const double p = *low + random.get_double(0, 1) * (*high - *low);
    for(std::size_t c = 0; c < 3; ++c) {
      outgoing[c] = std::abs(p - x[c]);
      side[c] = std::abs(x[(c + 1) % 3] - x[c]);
    }
    const auto weight = IS::internal::weights_from_lengths(outgoing, side);
    EXPECT_NEAR(weight[0] * x[0] + weight[1] * x[1] + weight[2] * x[2], p, 1e-9);
    EXPECT_GE(*std::min_element(weight.begin(), weight.end()), 0);
    EXPECT_NEAR(weight[0] + weight[1] + weight[2], 1, 1e-12);
  }
}

// A map over two levels is the composition of the two maps.
TEST(Surface_map, levels_of_a_hierarchy)
{
  Evolving_surface surface(random_sphere(300, 7));
  const Surface_level fine(surface);
  simplify(surface, number_of_vertices(std::size_t(100)));
  const Surface_level middle(surface);
  simplify(surface, number_of_vertices(std::size_t(20)));
  const Surface_level coarse(surface);
  const Surface_map first(surface, fine, middle), second(surface, middle, coarse);
  const Surface_map both(surface, fine, coarse);
  CGAL::Random random(4);
  for(int n = 0; n < 1000; ++n) {
    const Location p = random_location(fine.mesh(), random);
    expect_near(both.to_coarse(p), second.to_coarse(first.to_coarse(p)), 1e-12);
    const Location q = random_location(coarse.mesh(), random);
    expect_near(both.to_fine(q), first.to_fine(second.to_fine(q)), 1e-12);
  }
  const Eigen::SparseMatrix<double> product =
    IS::prolongation_matrix(first) * IS::prolongation_matrix(second);
  EXPECT_EQ(product.rows(), 300);
  EXPECT_EQ(product.cols(), 20);
  EXPECT_EQ(middle.triangulation().mesh().number_of_vertices(), 100u);
  EXPECT_TRUE(IT::is_Delaunay(middle.triangulation()));
}

// The squared lengths at the tip become a third, so its coordinate is multiplied by three:
// circumcircles, where the sum of l_ij^2 b_i b_j is zero, become circumcircles.
TEST(Surface_map, changes_of_scale_keep_circumcircles)
{
  const Simplified s = without_tip();
  const Surface_map map(s.surface, s.fine, s.coarse);
  for(Halfedge_index h : s.fine.mesh().halfedges()) {
    if(s.fine.mesh().source(h) != Vertex_index(0))
      continue;
    const Location q = map.to_coarse({s.fine.mesh().face(h), {1 / 3., 1 / 3., 1 / 3.}});
    // The tip, in the middle of the new face, has three fifths, and two corners have one fifth
    // each.
    const Coordinates expected{1 / 5., 2 / 5., 2 / 5.};
    Coordinates sorted = q.second;
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(sorted[c], expected[c], 1e-14);
  }
}

// ---- Matrices ----

TEST(Prolongation, rows_are_barycentric_coordinates)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    const Eigen::SparseMatrix<double, Eigen::RowMajor> p = IS::prolongation_matrix(map);
    for(Vertex_index v : s.fine.mesh().vertices()) {
      double sum = 0;
      for(decltype(p)::InnerIterator entry(p, static_cast<int>(v)); entry; ++entry) {
        EXPECT_GT(entry.value(), 0);
        sum += entry.value();
      }
      EXPECT_NEAR(sum, 1, 1e-15);
      const Vertex_index coarse = s.coarse.level_vertex(s.fine.surface_vertex(v));
      EXPECT_TRUE(!coarse.is_valid() ||
                  p.coeff(static_cast<int>(v), static_cast<int>(coarse)) == 1);
    }
  });
}

TEST(Prolongation, of_linear_functions_on_a_flat_polygon_is_exact)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map& map) {
    Eigen::VectorXd fine(mesh.number_of_vertices()), coarse(s.coarse.mesh().number_of_vertices());
    const auto value = [&](Vertex_index v) {
      return mesh.point(v).x() - 2 * mesh.point(v).y() + 3;
    };
    for(Vertex_index v : mesh.vertices())
      fine[v.idx()] = value(v);
    for(Vertex_index v : s.coarse.mesh().vertices())
      coarse[v.idx()] = value(s.coarse.surface_vertex(v));
    EXPECT_LT((IS::prolongation_matrix(map) * coarse - fine).cwiseAbs().maxCoeff(), 1e-7);
  });
}

TEST(Prolongation, restriction_is_a_mean_that_keeps_integrals)
{
  const Simplified s(Evolving_surface(random_sphere(200, 3)), 20);
  const Surface_map map(s.surface, s.fine, s.coarse);
  const Eigen::SparseMatrix<double> p = IS::prolongation_matrix(map);
  const Eigen::SparseMatrix<double> r = IS::restriction_matrix(p, map);
  EXPECT_LT((r * Eigen::VectorXd::Ones(200) - Eigen::VectorXd::Ones(20)).cwiseAbs().maxCoeff(),
            1e-14);
  const Eigen::SparseMatrix<double> mass = IT::lumped_mass_matrix(s.fine);
  const Eigen::VectorXd fine_mass = mass.diagonal(), coarse_mass = p.transpose() * fine_mass;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(200, -1, 3);
  EXPECT_NEAR(coarse_mass.dot(r * x), fine_mass.dot(x), 1e-12);
}

TEST(Prolongation, isolated_vertices_keep_their_values)
{
  Mesh mesh = random_sphere(50, 8);
  const Vertex_index alone = mesh.add_vertex({3, 3, 3});
  const Simplified s(Evolving_surface(mesh), 10);
  const Surface_map map(s.surface, s.fine, s.coarse);
  const Eigen::SparseMatrix<double> p = IS::prolongation_matrix(map);
  const Eigen::SparseMatrix<double> r = IS::restriction_matrix(p, map);
  const Vertex_index coarse = s.coarse.level_vertex(alone);
  ASSERT_TRUE(coarse.is_valid());
  EXPECT_EQ(p.coeff(static_cast<int>(alone), static_cast<int>(coarse)), 1);
  EXPECT_EQ(r.coeff(static_cast<int>(coarse), static_cast<int>(alone)), 1);
}

} // namespace Test_surface_map
