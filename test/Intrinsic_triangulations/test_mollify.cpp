// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "near_degenerate_meshes.h"

#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

namespace Test_mollify {

using namespace Test_surfaces;

// Returns the least slack of a triangle inequality in any face.
double least_slack(const Delta_complex& mesh, const std::vector<double>& lengths)
{
  double result = std::numeric_limits<double>::infinity();
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const double a = lengths[mesh.edge(h)], b = lengths[mesh.edge(mesh.next(h))],
                 c = lengths[mesh.edge(mesh.next(mesh.next(h)))];
    result = (std::min)(result, a + b + c - 2 * (std::max)({a, b, c}));
  }
  return result;
}

double mean(const std::vector<double>& lengths)
{
  return std::accumulate(lengths.begin(), lengths.end(), 0.) / static_cast<double>(lengths.size());
}

// Returns lengths from zero to one, which violate many inequalities.
std::vector<double> wild_lengths(const Delta_complex& mesh, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> result(mesh.number_of_edges());
  for(double& length : result)
    length = random.get_int(0, 4) == 0 ? 0 : random.get_double();
  return result;
}

struct Length_map
{
  typedef Edge_index key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::read_write_property_map_tag category;

  std::vector<double>* lengths;

  friend double get(const Length_map& map, Edge_index e) { return (*map.lengths)[e.idx()]; }
  friend void put(const Length_map& map, Edge_index e, double x) { (*map.lengths)[e.idx()] = x; }
};

double mollified(const Delta_complex& mesh, std::vector<double>& lengths, double epsilon)
{
  return IT::mollify(mesh, Length_map{&lengths}, epsilon);
}

TEST(Mollify, adds_the_missing_slack_and_no_more)
{
  for(const auto& [c, seed] : traced(complexes(), 20)) {
    std::vector<double> lengths = wild_lengths(c.mesh, seed);
    const std::vector<double> before = lengths;
    const double wanted = 1e-3 * mean(before), slack = least_slack(c.mesh, before);
    const double added = mollified(c.mesh, lengths, 1e-3);
    EXPECT_NEAR(added, (std::max)(0., wanted - slack), 1e-15);
    EXPECT_GE(least_slack(c.mesh, lengths), wanted - 1e-15);
    for(std::size_t e = 0; e < lengths.size(); ++e)
      EXPECT_EQ(lengths[e], before[e] + added);
  }
}

TEST(Mollify, changes_nothing_where_nothing_is_missing)
{
  for(const Named_complex& c : traced(complexes())) {
    std::vector<double> lengths = random_lengths(c.mesh, 3); // slack at least 0.1
    const std::vector<double> before = lengths;
    EXPECT_EQ(mollified(c.mesh, lengths, 0.05), 0);
    EXPECT_EQ(lengths, before);
  }
}

TEST(Mollify, twice_is_once)
{
  const Delta_complex mesh = double_torus();
  std::vector<double> lengths = wild_lengths(mesh, 5);
  EXPECT_GT(mollified(mesh, lengths, 0), 0);
  EXPECT_LT(mollified(mesh, lengths, 0), 1e-15);
}

TEST(Mollify, scales_with_the_lengths)
{
  const Delta_complex mesh = Triangulation(embedded_torus(5, 4)).mesh();
  for(double scale : traced({1e-100, 1e-8, 1e8, 1e100})) {
    std::vector<double> lengths = wild_lengths(mesh, 6), scaled = lengths;
    for(double& x : scaled)
      x *= scale;
    const double added = mollified(mesh, lengths, 1e-4);
    EXPECT_NEAR(mollified(mesh, scaled, 1e-4) / scale / added, 1, 1e-12);
  }
}

TEST(Mollify, coincident_vertices_become_apart)
{
  Mesh mesh = embedded_torus(5, 4);
  mesh.point(mesh.target(Halfedge_index(0))) = mesh.point(mesh.source(Halfedge_index(0)));
  EXPECT_THROW(Triangulation{mesh}, IT::Invalid_input);
  auto length = mesh.add_property_map<Edge_index, double>("e:length", 0).first;
  IT::compute_edge_lengths(mesh, length);
  EXPECT_EQ(length[Edge_index(0)], 0);
  const double added = IT::mollify(mesh, length, 1e-5);
  EXPECT_GT(added, 0);
  EXPECT_EQ(length[Edge_index(0)], added);
  Triangulation t(mesh, IT::parameters::edge_length_map(length));
  IT::make_Delaunay(t);
  EXPECT_TRUE(IT::is_Delaunay(t));
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Mollify, edge_lengths_are_distances)
{
  for(const Named_mesh& m : traced(meshes())) {
    Mesh mesh = m.mesh;
    auto length = mesh.add_property_map<Edge_index, double>("e:length", 0).first;
    IT::compute_edge_lengths(mesh, length);
    for(Edge_index e : mesh.edges())
      EXPECT_DOUBLE_EQ(length[e], std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                                   mesh.point(mesh.vertex(e, 1)))));
  }
}

TEST(Mollify, the_empty_mesh)
{
  const Delta_complex mesh;
  std::vector<double> lengths;
  EXPECT_EQ(mollified(mesh, lengths, 1e-5), 0);
}

// The parameter has the effect of the function. Positions no longer count if lengths change.
TEST(Mollify, by_a_named_parameter)
{
  const Mesh good = unit_sphere(2);
  const Mesh bad = near_degenerate_mesh(1).mesh;
  for(const Mesh* mesh : {&good, &bad}) {
    const double epsilon = 1e-4;
    std::vector<double> length(mesh->number_of_edges());
    const auto map =
      boost::make_iterator_property_map(length.begin(), get(boost::edge_index, *mesh));
    IT::compute_edge_lengths(*mesh, map);
    const bool has_changed = IT::mollify(*mesh, map, epsilon) > 0;
    EXPECT_EQ(has_changed, mesh == &bad);
    const Triangulation t(*mesh, IT::parameters::mollification(epsilon));
    EXPECT_EQ(t.input_metric().points.empty(), has_changed);
    for(Edge_index e : mesh->edges())
      EXPECT_EQ(t.length(e), length[e.idx()]);
  }
}

TEST(Mollify, edges_of_zero_length)
{
  Mesh mesh = unit_sphere(1);
  const Halfedge_index h = *mesh.halfedges().begin();
  mesh.point(mesh.source(h)) = mesh.point(mesh.target(h));
  EXPECT_THROW(Triangulation{mesh}, IT::Invalid_input);
  EXPECT_THROW(Triangulation(mesh, IT::parameters::mollification(0)), IT::Invalid_input);
  EXPECT_THROW(Triangulation(mesh, IT::parameters::mollification(-1.)), IT::Invalid_input);
  EXPECT_THROW(Triangulation(mesh, IT::parameters::mollification(std::nan(""))), IT::Invalid_input);
  EXPECT_GT(Triangulation(mesh, IT::parameters::mollification(1e-6)).length(mesh.edge(h)), 0);
}

} // namespace Test_mollify
