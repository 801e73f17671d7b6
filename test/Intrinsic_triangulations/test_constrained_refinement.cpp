// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "hard_meshes.h"
#include "refinement_checks.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_constrained_refinement {

using namespace Test_surfaces;

// Checks the pieces of constrained edges. Each lies along its edge of T1, which they cover end to
// end, and the vertices between them lie on it.
void check_pieces(const Triangulation& t, const std::set<std::size_t>& fixed)
{
  check_chains(t, fixed);
  std::vector<std::size_t> pieces(t.input_mesh().num_edges()), vertices(pieces);
  for(Edge_index e : t.mesh().edges())
    if(t.is_constrained(e) || t.mesh().is_border(e))
      ++pieces[t.input_mesh().edge(t.input_halfedge(t.mesh().halfedge(e)))];
  for(const auto& m : t.inserted_vertices())
    if(const auto* p = IT::on_edge(m)) {
      ++vertices[Edge_index(p->halfedge)];
      const auto& b = p->weight;
      EXPECT_EQ(std::count(b.begin(), b.end(), 0.), 0);
    }
  for(std::size_t e : fixed)
    EXPECT_EQ(pieces[e], vertices[e] + 1) << e;
}

// Refines with these edges marked. Checks that every face that violates the bound has an allowed
// excuse, and all decisions are certified.
void expect_refined(const Mesh& mesh, const std::set<std::size_t>& marked, bool is_exact,
                    double degrees = 25)
{
  const auto is_constrained = boost::make_function_property_map<Mesh::Edge_index>(
    [&](Mesh::Edge_index e) { return marked.count(e.idx()) > 0; });
  Triangulation t(mesh, CGAL::parameters::edge_is_constrained_map(is_constrained));
  const IT::Refinement_result result =
    IT::refine(t, IT::parameters::minimum_angle(degrees).exact_decisions(is_exact));
  EXPECT_TRUE(result.status == IT::Refinement_status::bounds_met ||
              result.status == IT::Refinement_status::bounds_met_but_excused)
    << to_string(result.status);
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  check_angles(t, degrees, result, 1e-6);
  std::set<std::size_t> fixed = marked;
  for(Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e))
      fixed.insert(e.idx());
  check_pieces(t, fixed);
}

std::set<std::size_t> random_edges(const Mesh& mesh, std::size_t n, Portable_random& random)
{
  std::set<std::size_t> result;
  while(result.size() < n)
    result.insert(std::size_t(random.get_int(0, static_cast<int>(mesh.number_of_edges()))));
  return result;
}

// Returns the edges at which faces meet at more than 40 degrees.
std::set<std::size_t> feature_edges(const Mesh& mesh)
{
  const auto normal = [&](Mesh::Halfedge_index h) {
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
    return CGAL::cross_product(q - p, r - p);
  };
  std::set<std::size_t> result;
  for(Mesh::Edge_index e : mesh.edges())
    if(!mesh.is_border(e)) {
      const auto m = normal(mesh.halfedge(e)), n = normal(mesh.opposite(mesh.halfedge(e)));
      if(m * n <
         std::cos(40 * std::acos(-1.) / 180) * std::sqrt(m.squared_length() * n.squared_length()))
        result.insert(e.idx());
    }
  return result;
}

TEST(Constrained_refinement, random_edges_inside)
{
  Portable_random random(7);
  for(unsigned int seed : seeds(8))
    for(bool is_exact : {false, true}) {
      const Mesh mesh = random_sphere(419, seed);
      expect_refined(mesh, random_edges(mesh, 41, random), is_exact);
    }
}

TEST(Constrained_refinement, random_edges_on_other_surfaces)
{
  Portable_random random(8);
  for(int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Mesh mesh = hard_base(random);
    expect_refined(mesh, random_edges(mesh, 1 + mesh.number_of_edges() / 20, random), i % 2 == 0);
  }
}

TEST(Constrained_refinement, feature_edges_of_data_meshes)
{
  std::size_t count = 0;
  for_each_data_mesh(400000, [&](const Mesh& mesh) {
    const std::set<std::size_t> marked = feature_edges(mesh);
    if(marked.size() < 10 || mesh.number_of_faces() > 4000)
      return;
    expect_refined(mesh, marked, false);
    ++count;
  });
  EXPECT_GE(count, 10u);
}

// If the faces at a marked edge are needles thinner than rounding errors, exact decisions are
// needed.
TEST(Constrained_refinement, random_edges_of_hard_meshes)
{
  Portable_random random(9);
  for(std::uint64_t seed : traced({3u, 9u, 10u, 13u, 25u, 27u})) {
    const Mesh mesh = hard_mesh(seed).mesh;
    const auto marked = random_edges(mesh, 5, random);
    const auto is_constrained = boost::make_function_property_map<Mesh::Edge_index>(
      [&](Mesh::Edge_index e) { return marked.count(e.idx()) > 0; });
    Triangulation t(mesh, CGAL::parameters::edge_is_constrained_map(is_constrained));
    const IT::Refinement_result result =
      IT::refine(t, IT::parameters::maximum_number_of_insertions(std::size_t(100000)));
    EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
    EXPECT_NE(result.status, IT::Refinement_status::insertion_limit);
    for(const IT::Remaining_face& f : result.remaining)
      EXPECT_NE(f.reason, IT::Remaining_reason::no_room);
  }
}

} // namespace Test_constrained_refinement
