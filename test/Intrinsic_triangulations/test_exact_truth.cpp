// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_flips.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#ifdef CGAL_USE_GMP
#ifndef CGAL_USE_CORE
#define CGAL_USE_CORE 1
#endif
#include <CGAL/CORE_Expr.h>
#endif

namespace Test_exact_truth {

using namespace Test_surfaces;

// ---- CGAL's Delaunay triangulation of the flat torus ----

// Stores an edge from a vertex to another one along a vector, in one of the two directions.
using Torus_edge = std::tuple<unsigned int, unsigned int, std::int64_t, std::int64_t>;

Torus_edge torus_edge(unsigned int p, unsigned int q, const Vector& v)
{
  return (std::min)(Torus_edge(p, q, v.x, v.y), Torus_edge(q, p, -v.x, -v.y));
}

std::int64_t modulo(std::int64_t x, std::int64_t n) { return (x % n + n) % n; }

std::set<Torus_edge> periodic_edges(const std::vector<Vector>& points, std::int64_t period)
{
  using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<
    CGAL::Exact_predicates_inexact_constructions_kernel>;
  using Periodic = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
  Periodic periodic(Periodic::Iso_rectangle(0, 0, double(period), double(period)));
  std::map<std::pair<double, double>, unsigned int> number;
  for(const Vector& p : points) {
    const Periodic::Point q(double(modulo(p.x, period)), double(modulo(p.y, period)));
    number[{q.x(), q.y()}] = static_cast<unsigned int>(number.size());
    periodic.insert(q);
  }
  std::set<Torus_edge> result;
  for(auto e = periodic.edges_begin(); e != periodic.edges_end(); ++e) {
    const auto segment = periodic.periodic_segment(*e);
    const auto &p = segment[0].first, &q = segment[1].first;
    const auto &i = segment[0].second, &j = segment[1].second;
    const Vector v{std::int64_t(q.x() - p.x()) + (j.x() - i.x()) * period,
                   std::int64_t(q.y() - p.y()) + (j.y() - i.y()) * period};
    result.insert(torus_edge(number.at({p.x(), p.y()}), number.at({q.x(), q.y()}), v));
  }
  return result;
}

// Checks the torus of a square lattice, in any basis. Edges that are ties may differ.
void check_square_torus(int n, int shear, unsigned int seed)
{
  const std::int64_t period = 1000 * n;
  const Flat_surface surface = flat_torus(n, n, seed, {1000, 0}, {1000 * shear, 1000});
  Exact_triangulation t = with_squared_lengths(surface, 7);
  Vector_keeper vectors(t.mesh(), surface.vector);
  Portable_random random(seed);
  shuffle(t, 4 * t.mesh().number_of_edges(), random,
          [&](Halfedge_index h) { vectors.after_flip(h); });
  IT::make_Delaunay(t, IT::parameters::visitor(std::ref(vectors)));
  const std::set<Torus_edge> expected = periodic_edges(surface.point, period);
  EXPECT_EQ(expected.size(), t.mesh().number_of_edges());
  std::size_t ties = 0, found = 0;
  for(Edge_index e : t.mesh().edges()) {
    const Halfedge_index h = t.mesh().halfedge(e);
    if(vectors.side_of_circle(h) == 0)
      ++ties;
    else
      found +=
        expected.count(torus_edge(t.mesh().source(h), t.mesh().target(h), vectors.vector[h]));
  }
  EXPECT_EQ(found + ties, t.mesh().number_of_edges());
  EXPECT_EQ(IT::certify_Delaunay(t).ties.size(), ties);
}

TEST(Exact_truth, Delaunay_triangulations_of_flat_tori)
{
  for(unsigned int seed : seeds(24))
    check_square_torus(1 + static_cast<int>(seed) % 5, static_cast<int>(seed) % 3 - 1, seed);
}

// ---- Numbers with roots ----

#ifdef CGAL_USE_GMP

using Expression = CORE::Expr;

// Keeps the squared lengths of edges, as expressions with roots, while they are flipped.
struct Square_keeper : IT::Default_flip_visitor
{
  const Delta_complex& mesh;
  std::vector<Expression> square;

  explicit Square_keeper(const Delta_complex& mesh, const Mesh& surface)
    : mesh(mesh), square(mesh.number_of_edges())
  {
    for(Edge_index e : mesh.edges()) {
      const Point &p = surface.point(mesh.source(mesh.halfedge(e))),
                  &q = surface.point(mesh.target(mesh.halfedge(e)));
      for(int k = 0; k < 3; ++k) {
        const Expression d = Expression(q[k]) - Expression(p[k]);
        square[e] += d * d;
      }
    }
  }

  const Expression& operator()(Halfedge_index h) const { return square[mesh.edge(h)]; }

  // Returns twice the scalar product of the sides at the source of `h`, in its face.
  Expression at_source(Halfedge_index h) const
  {
    return (*this)(h) + (*this)(mesh.prev(h)) - (*this)(mesh.next(h));
  }

  // Returns four times the area of the face of `h`.
  Expression area(Halfedge_index h) const
  {
    const Expression product = at_source(h);
    return sqrt(4 * (*this)(h) * (*this)(mesh.prev(h)) - product * product);
  }

  // The law of cosines holds at i, where the angles of both faces at ij add up.
  void after_flip(Halfedge_index h)
  {
    const Halfedge_index o = mesh.opposite(h);
    const Expression ij = (*this)(h), &ki = (*this)(mesh.next(h)), &il = (*this)(mesh.prev(h));
    const Expression &lj = (*this)(mesh.next(o)), &jk = (*this)(mesh.prev(o));
    const Expression p = ij + ki - jk, q = ij + il - lj; // twice the scalar products with ij
    const Expression areas = sqrt((4 * ij * ki - p * p) * (4 * ij * il - q * q));
    square[mesh.edge(h)] = ki + il - (p * q - areas) / (2 * ij);
  }

  CGAL::Sign Delaunay_sign(Halfedge_index h) const
  {
    const Halfedge_index o = mesh.opposite(h);
    const auto opposite_corner = [&](Halfedge_index x) { return at_source(mesh.prev(x)); };
    return CGAL::sign(Expression(opposite_corner(h) * area(o) + opposite_corner(o) * area(h)));
  }
};

void check_every_edge(const Mesh& mesh, std::size_t shuffled)
{
  Exact_triangulation t(mesh);
  Square_keeper squares(t.mesh(), mesh);
  Portable_random random(mesh.number_of_vertices());
  shuffle(t, shuffled, random, [&](Halfedge_index h) { squares.after_flip(h); });
  const std::size_t flips = IT::make_Delaunay(t, IT::parameters::visitor(std::ref(squares)));
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(t);
  EXPECT_TRUE(certificate.is_Delaunay());
  std::size_t ties = 0;
  for(Edge_index e : t.mesh().edges()) {
    const Halfedge_index h = t.mesh().halfedge(e);
    EXPECT_NEAR(CGAL::to_double(squares(h)) / (t.length(e) * t.length(e)), 1, 0x1p-38);
    if(t.mesh().is_border(e))
      continue;
    const CGAL::Sign sign = squares.Delaunay_sign(h);
    EXPECT_NE(sign, CGAL::NEGATIVE) << e;
    ties += sign == CGAL::ZERO;
  }
  EXPECT_EQ(certificate.ties.size(), ties);
  std::cout << mesh.number_of_vertices() << " vertices, " << flips << " flips, " << ties
            << " ties\n";
}

// The surfaces have all sizes up to EXACT_TRUTH_VERTICES, if it is set.
TEST(Exact_truth, every_edge_with_roots)
{
  const char* greatest = std::getenv("EXACT_TRUTH_VERTICES");
  const std::size_t limit = greatest == nullptr ? 60 : std::strtoull(greatest, nullptr, 10);
  for(std::size_t n = 15; n <= limit; n *= 2) {
    SCOPED_TRACE(n);
    const auto seed = static_cast<unsigned int>(n);
    check_every_edge(random_sphere(n, seed), n);
    check_every_edge(perturbed(embedded_torus(n / 5, 5), 0.1, seed), n);
    check_every_edge(perturbed(bipyramid(n, 0.3), 0.02, seed), n / 2);
  }
}

// If flipped edges are ties, expressions must be proved to be zero.
TEST(Exact_truth, ties_with_roots)
{
  for(const Mesh& mesh : {cube(), octahedron(), bipyramid(6, 1), punctured(cube(), {0}),
                          stretched_along_x(cube(), 0.25)})
    check_every_edge(mesh, 8);
}

#endif // CGAL_USE_GMP

} // namespace Test_exact_truth
