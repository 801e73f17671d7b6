// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>

// Maps of surfaces with needles and caps as thin as rounding of positions allows.
namespace Test_needles {

using namespace Test_surfaces;
using DCM::Map_status;

// ---- Surfaces ----

// Splits a face at a point with barycentric coordinates 1 : e : e or 1 : 1 : e, up to rounding, and
// one of the new faces again. Stops where rounding gives a corner.
void add_nested_needles(Mesh& mesh, double e, std::size_t depth, Portable_random& random)
{
  Face_index f(Mesh::size_type(random.get_int(0, int(mesh.number_of_faces()))));
  for(std::size_t i = 0; i < depth; ++i) {
    Halfedge_index h = mesh.halfedge(f);
    for(int turns = random.get_int(0, 3); turns > 0; --turns)
      h = mesh.next(h);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = apex(h, mesh);
    const double second = random.get_int(0, 2) ? 1 : e, sum = 1 + second + e;
    const auto coordinate = [&](int c) { return (p[c] + second * q[c] + e * r[c]) / sum; };
    const Point inside(coordinate(0), coordinate(1), coordinate(2));
    if(!is_free(inside, mesh))
      return;
    const Vertex_index v = mesh.target(CGAL::Euler::add_center_vertex(h, mesh));
    mesh.point(v) = inside;
    f = mesh.face(mesh.halfedge(v));
  }
}

Mesh with_needles(Mesh mesh, double e, std::size_t count, std::uint64_t seed)
{
  Portable_random random(seed);
  for(std::size_t i = 0; i < count; ++i)
    add_nested_needles(mesh, e, 3, random);
  return mesh;
}

const double widths[] = {1e-2, 1e-5, 1e-8, 1e-11, 1e-13, 1e-15};

// The intrinsic Delaunay triangulation is certified.
TEST(Needles, triangulation_is_exact)
{
  for(const double e : widths) {
    SCOPED_TRACE(e);
    const Mesh mesh = with_needles(random_sphere(60, 3), e, 4, 7);
    const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::exact_decisions(true));
    EXPECT_TRUE(IT::certify_Delaunay(map.Delaunay()).is_Delaunay());
  }
}

// Conductances in series: from a fixed end, potentials are sums of resistances.
TEST(Laplacian_elimination, chain_of_any_weights)
{
  const std::vector<double> weight{1, 1e20, 1e-20, 1e15, 3, 1e-3};
  const auto n = Eigen::Index(weight.size());
  std::vector<Eigen::Triplet<double>> entries;
  for(Eigen::Index i = 0; i < n; ++i) {
    const double w = weight[std::size_t(i)];
    entries.insert(entries.end(), {{int(i), int(i), w},
                                   {int(i + 1), int(i + 1), w},
                                   {int(i), int(i + 1), -w},
                                   {int(i + 1), int(i), -w}});
  }
  Eigen::SparseMatrix<double> matrix(n + 1, n + 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const DCM::internal::Laplacian_elimination<double>::Order order{3, 6, 1, 5, 2, 4}; // without 0
  EXPECT_TRUE(DCM::internal::Laplacian_elimination<double>::is_needed(matrix, order));
  DCM::internal::Laplacian_elimination<double> elimination;
  ASSERT_TRUE(elimination.factorize(matrix, Eigen::VectorXd::Zero(n + 1), order));
  Eigen::VectorXd current = Eigen::VectorXd::Zero(n + 1);
  current[n] = 1;
  const std::vector<double> potential = elimination.solve(current);
  double expected = 0;
  for(Eigen::Index i = 0; i < n; ++i) {
    expected += 1 / weight[std::size_t(i)];
    EXPECT_NEAR(potential[std::size_t(i + 1)] / expected, 1, 1e-14);
  }
}

} // namespace Test_needles
