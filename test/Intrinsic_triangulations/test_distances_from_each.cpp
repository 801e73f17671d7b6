// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "known_surfaces.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/distances_from_each.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>

// These tests compute distances from each of many sources, separately and in several threads.
namespace Test_distances_from_each {

using namespace Test_surfaces;

typedef Eigen::MatrixXd Columns;

std::vector<Vertex_index> some_vertices(const Mesh& mesh)
{
  std::vector<Vertex_index> result;
  for(unsigned v = 0; v < mesh.number_of_vertices(); v += 7)
    result.push_back(Vertex_index(v));
  return result;
}

std::vector<Named_mesh> surfaces()
{
  return {{"cube", cube()},
          {"torus", perturbed(embedded_torus(20, 15), 0.5, 1)},
          {"holes", punctured(perturbed(embedded_torus(12, 9), 0.3, 6), {1, 16})}};
}

template <typename Source>
void expect_shortest_paths(const Triangulation& t, const std::vector<Source>& sources)
{
  const Columns result = IT::distances_from_each(t.input(), sources);
  ASSERT_EQ(result.cols(), Eigen::Index(sources.size()));
  for(std::size_t i = 0; i < sources.size(); ++i) {
    IT::Shortest_paths paths(t.input());
    paths.add_source(sources[i]);
    paths.run();
    for(const Vertex_index v : t.input_mesh().vertices())
      EXPECT_EQ(result(v.idx(), Eigen::Index(i)), paths.distance(v));
  }
}

TEST(Distances_from_each, are_the_lengths_of_shortest_paths)
{
  for(const Named_mesh& m : traced(surfaces())) {
    const Triangulation t(m.mesh);
    expect_shortest_paths(t, some_vertices(m.mesh));
    expect_shortest_paths(
      t, std::vector<Location>{{Face_index(2), {0.2, 0.3, 0.5}}, {Face_index(7), {0.5, 0.5, 0}}});
  }
}

TEST(Distances_from_each, of_none)
{
  const Triangulation t(cube());
  EXPECT_EQ(IT::distances_from_each(t.input(), std::vector<Vertex_index>()).size(), 0);
  EXPECT_EQ(IT::Heat_distance<>(t.input()).distances_from_each(std::vector<Vertex_index>()).size(),
            0);
}

// ---- Heat ----

void expect_near(const Eigen::VectorXd& computed, const Eigen::VectorXd& expected)
{
  EXPECT_LE((computed - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.maxCoeff());
}

TEST(Distances_from_each, of_heat_are_the_distances_from_one)
{
  for(const Named_mesh& m : traced(surfaces())) {
    const Triangulation t(m.mesh);
    const IT::Heat_distance<> heat(t.input());
    const auto sources = some_vertices(m.mesh);
    const Columns result = heat.distances_from_each(sources);
    for(std::size_t i = 0; i < sources.size(); ++i)
      expect_near(result.col(Eigen::Index(i)), heat.distances(sources[i]));
  }
}

// Sets with several sources prescribe values.
TEST(Distances_from_each, of_heat_from_sets)
{
  const Mesh mesh = perturbed(embedded_torus(20, 15), 0.5, 1);
  const Triangulation t(mesh);
  const IT::Heat_distance<> heat(t.input());
  const std::vector<std::vector<Vertex_index>> sets{
    {Vertex_index(3)}, {Vertex_index(3), Vertex_index(200)}, {Vertex_index(17)}};
  const Columns result = heat.distances_from_each(sets);
  for(std::size_t i = 0; i < sets.size(); ++i)
    expect_near(result.col(Eigen::Index(i)), heat.distances(sets[i]));
}

// ---- Threads ----

#ifdef CGAL_LINKED_WITH_TBB

struct Counting_visitor
{
  void after_windows(std::size_t number) { windows += number; }
  std::size_t windows = 0;
};

TEST(Distances_from_each, are_the_same_in_several_threads)
{
  const Mesh mesh = perturbed(embedded_torus(20, 15), 0.5, 1);
  const Triangulation t(mesh);
  const auto sources = some_vertices(mesh);
  const IT::Heat_distance<> heat(t.input());
  const auto np = IT::parameters::concurrency_tag(CGAL::Parallel_tag());
  Counting_visitor alone, together;
  EXPECT_EQ(IT::distances_from_each(t.input(), sources, IT::parameters::visitor(std::ref(alone))),
            IT::distances_from_each(t.input(), sources, np.visitor(std::ref(together))));
  EXPECT_GT(alone.windows, 1000u);
  EXPECT_EQ(alone.windows, together.windows);
  EXPECT_EQ(heat.distances_from_each(sources), heat.distances_from_each(sources, np));
}

#endif

struct Stopping_visitor
{
  void after_windows(std::size_t) { throw std::runtime_error("stop"); }
};

TEST(Distances_from_each, are_stopped_by_a_visitor)
{
  const Mesh mesh = perturbed(embedded_torus(20, 15), 0.5, 1);
  const Triangulation t(mesh);
  const auto np =
    IT::parameters::visitor(Stopping_visitor()).concurrency_tag(CGAL::Parallel_if_available_tag());
  EXPECT_THROW(IT::distances_from_each(t.input(), some_vertices(mesh), np), std::runtime_error);
}

} // namespace Test_distances_from_each
