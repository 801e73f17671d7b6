// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "more_generators.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <atomic>

#include "results.h" // after Eigen

namespace Test_parallel {

using namespace Test_surfaces;
using IT::Side;

constexpr IT::Side sides[] = {Side::input, Side::intrinsic};

// ---- Loops ----

// Every index is visited once, and the results do not depend on the number of threads.
TEST(Parallel, loops)
{
  for(std::size_t n : {0u, 1u, 1023u, 1024u, 1025u, 100000u})
    for(std::size_t threads : {1u, 2u, 3u, 7u}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      std::vector<int> visits(n, 0);
      IT::for_each_chunk(IT::Concurrency(CGAL::Parallel_tag()), n,
                         [&](std::size_t begin, std::size_t end) {
                           EXPECT_EQ(begin % IT::chunk_size, 0u);
                           for(std::size_t i = begin; i < end; ++i)
                             ++visits[i];
                         });
      EXPECT_EQ(visits, std::vector<int>(n, 1));
    }
}

TEST(Parallel, the_first_exception_comes_out)
{
  const std::size_t n = 300 * IT::chunk_size;
  for(std::size_t threads : {1u, 2u, 3u, 7u})
    for(unsigned int seed = 0; seed < 20; ++seed) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      CGAL::Random random(seed);
      std::vector<char> fails(300, 0);
      for(int k = 0; k < 20; ++k)
        fails[static_cast<std::size_t>(random.get_int(0, 300))] = 1;
      const auto first =
        static_cast<std::size_t>(std::find(fails.begin(), fails.end(), 1) - fails.begin());
      std::atomic<std::size_t> before(0);
      const auto f = [&](std::size_t begin, std::size_t) {
        const std::size_t chunk = begin / IT::chunk_size;
        if(fails[chunk])
          throw std::runtime_error(std::to_string(chunk));
        before += chunk < first;
      };
      try {
        IT::for_each_chunk(IT::Concurrency(CGAL::Parallel_tag()), n, f);
        ADD_FAILURE() << "no exception";
      } catch(const std::runtime_error& e) {
        EXPECT_EQ(e.what(), std::to_string(first));
      }
      EXPECT_EQ(before, first); // all chunks before it have been run
    }
}

// ---- Triangulations ----

Triangulation Delaunay(const Mesh& mesh)
{
  Triangulation tri(mesh);
  IT::make_Delaunay(tri);
  return tri;
}

Triangulation refined(const Mesh& mesh)
{
  Triangulation tri(mesh);
  IT::refine(tri,
             IT::parameters::minimum_angle(30).maximum_circumradius(0.9 * longest_input_edge(tri)));
  EXPECT_GT(tri.number_of_inserted_vertices(), 100u);
  return tri;
}

Triangulation flipped(const Mesh& mesh)
{
  Triangulation tri(mesh);
  flip_at_random(tri, 4 * mesh.number_of_edges(), 5);
  return tri;
}

std::vector<Named_triangulation> large_triangulations()
{
  std::vector<Named_triangulation> result;
  for(const auto& [name, mesh] :
      {std::pair<std::string, Mesh>{"torus", large_torus()}, {"square", large_square()}}) {
    result.push_back({name + ", Delaunay", Delaunay(mesh)});
    result.push_back({name + ", refined", refined(mesh)});
    result.push_back({name + ", flipped at random", flipped(mesh)});
  }
  return result;
}

template <typename Traits>
Results results(const IT::Correspondence<Traits>& c)
{
  Results results;
  results.add(c.number_of_input_pieces());
  for(typename IT::Correspondence<Traits>::size_type id = 0; id < c.number_of_crossings(); ++id) {
    const auto p = c.crossing(id);
    results.add(p.on_input.halfedge.idx());
    results.add(p.on_input.t);
    results.add(p.on_intrinsic.halfedge.idx());
    results.add(p.on_intrinsic.t);
    results.add(c.scale(id));
  }
  for(Side side : sides)
    for(IT::Halfedge_index h : c.mesh(side).halfedges()) {
      results.add(c.outgoing_before(side, h).idx());
      for(unsigned int p = 0; p < c.number_of_crossings(side, Edge_index(h)); ++p)
        results.add(c.crossing(side, h, p).id);
    }
  for(Edge_index e : c.mesh(Side::input).edges())
    for(unsigned int i = 0; i < c.number_of_parts(e); ++i) {
      const auto& part = c.part(e, i);
      for(auto x : {part.first, part.count, part.first_piece, part.end.idx()})
        results.add(x);
    }
  return results;
}

TEST(Parallel, correspondence)
{
  for(const Named_triangulation& t : traced(large_triangulations()))
    expect_same_results([&](auto tag) {
      return results(IT::Correspondence<>(t.triangulation, IT::parameters::concurrency_tag(tag)));
    });
}

// Crossings have scales in this geometry.
TEST(Parallel, ideal_correspondence)
{
  IT::Intrinsic_triangulation<IT::Ideal_geometry_traits<>> tri(large_torus());
  IT::make_Delaunay(tri);
  expect_same_results([&](auto tag) {
    return results(
      IT::Correspondence<IT::Ideal_geometry_traits<>>(tri, IT::parameters::concurrency_tag(tag)));
  });
}

TEST(Parallel, common_subdivision)
{
  for(const Named_triangulation& t : traced(large_triangulations())) {
    const IT::Correspondence<> correspondence(t.triangulation);
    expect_same_results([&](auto tag) {
      Results results;
      results.add_subdivision(
        IT::Common_subdivision<>(correspondence, IT::parameters::concurrency_tag(tag)), sides);
      return results;
    });
  }
}

TEST(Parallel, matrices)
{
  for(const Named_triangulation& t : traced(large_triangulations())) {
    const IT::Correspondence<> correspondence(t.triangulation);
    const IT::Common_subdivision<> subdivision(correspondence);
    expect_same_results([&](auto tag) {
      Results results;
      const auto np = IT::parameters::concurrency_tag(tag);
      for(Side side : sides)
        results.add_matrix(IT::interpolation_matrix(side, subdivision, np));
      results.add_matrix(IT::mixed_mass_matrix(correspondence, np));
      return results;
    });
  }
}

// ---- Flips and certificates ----

template <typename Tag>
Results Delaunay_results(const Triangulation& start, bool is_exact, Tag tag)
{
  Triangulation tri = start;
  Results results;
  results.add(
    IT::make_Delaunay(tri, IT::parameters::exact_decisions(is_exact).concurrency_tag(tag)));
  results.add_mesh(tri.mesh());
  for(Edge_index e : tri.mesh().edges())
    results.add(tri.length(e));
  return results;
}

TEST(Parallel, flipping)
{
  for(const Mesh& mesh : {large_torus(), large_square()})
    for(bool is_exact : {false, true})
      expect_same_results(
        [&](auto tag) { return Delaunay_results(Triangulation(mesh), is_exact, tag); });
}

template <typename Tag>
Results certificate_results(const Triangulation& tri, Tag tag)
{
  const IT::Delaunay_certificate c =
    IT::certify_Delaunay(tri, IT::parameters::concurrency_tag(tag));
  Results results;
  for(const auto* edges : {&c.non_straight_edges, &c.non_Delaunay_edges, &c.ties}) {
    results.add(edges->size());
    for(Edge_index e : *edges)
      results.add(e.idx());
  }
  for(auto v : c.folded_vertices)
    results.add(v.idx());
  for(std::size_t x : {c.decided_by_lengths, c.decided_in_floating_point,
                       c.decided_in_multiprecision, c.decided_exactly})
    results.add(x);
  return results;
}

TEST(Parallel, certificates)
{
  std::vector<Named_triangulation> all = large_triangulations();
  all.push_back({"ties", Triangulation(grid(60, 60, [](double x, double y) {
                   return Point(3 * x - 4 * y, 4 * x + 3 * y, 0);
                 }))});
  for(const Named_triangulation& t : traced(all))
    expect_same_results([&](auto tag) { return certificate_results(t.triangulation, tag); });
}

} // namespace Test_parallel
