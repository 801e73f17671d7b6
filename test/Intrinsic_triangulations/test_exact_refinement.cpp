// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "hard_meshes.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>

namespace {

using namespace Test_surfaces;
using Exact_triangulation = IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>;
using IT::Refinement_result;
using IT::Remaining_reason;

constexpr std::size_t insertion_limit = 60000;

Refinement_result refined(Exact_triangulation& tri)
{
  return IT::refine(tri, IT::parameters::maximum_number_of_insertions(insertion_limit));
}

// The least angle of a face from its sides in extended precision: they are certified up to 2^-40,
// and faces that meet the bound are not thin.
double least_angle(const Exact_triangulation& tri, Face_index f)
{
  std::array<long double, 3> side;
  for(std::size_t s = 0; s < 3; ++s)
    side[s] = tri.length(tri.mesh().edge(IT::sides(f, tri.mesh())[s]));
  std::sort(side.begin(), side.end());
  const auto [a, b, c] = side;
  return double(std::acos((b * b + c * c - a * a) / (2 * b * c)) * 180 / std::acos(-1.L));
}

void expect_bound(const Exact_triangulation& tri, const Refinement_result& result)
{
  std::set<Face_index> left;
  for(const IT::Remaining_face& f : result.remaining)
    left.insert(f.face);
  for(Face_index f : tri.mesh().faces())
    if(left.count(f) == 0)
      EXPECT_GE(least_angle(tri, f), 25 - 1e-6) << f;
    else
      EXPECT_FALSE(least_angle(tri, f) >= 25 + 1e-6) << f; // or NaN, in a face next to nothing
}

void expect_places(const Exact_triangulation& tri)
{
  for(const auto& m : tri.inserted_vertices()) {
    EXPECT_TRUE(IT::internal::is_valid_place(m, tri.input_mesh()));
    const auto& b = m.location.second;
    EXPECT_EQ(std::count(b.begin(), b.end(), 0.), m.along.is_valid() ? 1 : 0);
  }
}

// a stored length is that of the exact surface
void expect_lengths(const Exact_triangulation& tri)
{
  Exact_triangulation fresh = tri;
  fresh.recompute_lengths();
  for(Edge_index e : tri.mesh().edges())
    EXPECT_NEAR(tri.length(e) / fresh.length(e), 1, 0x1p-39) << e;
}

void expect_refined(const std::string& name, const Mesh& mesh)
{
  SCOPED_TRACE(name);
  Exact_triangulation tri(mesh);
  const Refinement_result result = refined(tri);
  EXPECT_NE(result.status, IT::Refinement_status::insertion_limit);
  EXPECT_TRUE(tri.is_valid(true));
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(tri);
  EXPECT_TRUE(certificate.bent_edges.empty());
  EXPECT_TRUE(certificate.non_Delaunay_edges.empty());
  const bool has_flat_faces =
    std::any_of(result.remaining.begin(), result.remaining.end(),
                [](const auto& f) { return f.reason == Remaining_reason::no_area; });
  EXPECT_TRUE(certificate.is_Delaunay() || has_flat_faces);
  expect_bound(tri, result);
  expect_places(tri);
  expect_lengths(tri);
}

// A sample of small ones; the first n if EXACT_REFINEMENT_SEEDS is n.
TEST(Exact_refinement, ends_on_hard_meshes_with_a_certificate)
{
  const char* all = std::getenv("EXACT_REFINEMENT_SEEDS");
  if(all == nullptr)
    for(unsigned seed :
        {1u, 3u, 4u, 5u, 9u, 10u, 12u, 13u, 14u, 15u, 16u, 17u, 21u, 25u, 26u, 27u, 28u})
      expect_refined(std::to_string(seed), hard_mesh(seed).mesh);
  else
    for(std::uint64_t seed = 0; seed < std::strtoull(all, nullptr, 10); ++seed)
      expect_refined(std::to_string(seed), hard_mesh(seed).mesh);
}

// The number of vertices is that which geometry needs: as in `double` where that has no doubt.
TEST(Exact_refinement, inserts_about_as_many_vertices_as_double_on_ordinary_meshes)
{
  Portable_random random(1);
  for(int i = 0; i < 10; ++i) {
    const Mesh mesh = hard_base(random);
    Triangulation rounded(mesh);
    Exact_triangulation tri(mesh);
    const auto expected = double(IT::refine(rounded).insertions);
    EXPECT_NEAR(double(refined(tri).insertions), expected, 10 + 0.2 * expected) << i;
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay()) << i;
  }
}

// A vertex that is pushed onto an edge of T1 near its target keeps its distance from there.
TEST(Exact_refinement, parts_of_edges_near_a_target_lose_no_digits)
{
  const double tiny = 0x1p-70;
  const std::array<double, 2> start{1, 1}, near_target{tiny, 1}, nearer{tiny / 4, 1};
  const Mesh mesh = make_mesh({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}});
  const Exact_triangulation tri(mesh);
  const auto length = [&](const auto& a, const auto& b) {
    const Halfedge_index h = tri.input_mesh().halfedge(Face_index(0));
    const double forward = IT::internal::Part_of_input_edge{h, a, b}.length(tri.input_length_map());
    const double back =
      IT::internal::Part_of_input_edge{IT::opposite(h), {b[1], b[0]}, {a[1], a[0]}}.length(
        tri.input_length_map());
    EXPECT_EQ(forward, back);
    return forward / tri.input_length(tri.input_mesh().edge(h));
  };
  EXPECT_DOUBLE_EQ(length(near_target, nearer), tiny * 3 / 4);
  EXPECT_DOUBLE_EQ(length(start, near_target), 0.5);
  EXPECT_LT(length(nearer, near_target), 0);
}

// A boundary edge of a prism-free strip whose only vertex lies on it exactly cannot be flipped away.
TEST(Exact_refinement, faces_without_area_are_named)
{
  const Mesh mesh = make_mesh({Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0), Point(1, 2, 0)},
                              {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}});
  Exact_triangulation tri(mesh);
  const Refinement_result result = refined(tri);
  ASSERT_EQ(result.status, IT::Refinement_status::no_room);
  EXPECT_FALSE(result.remaining.empty());
  for(const IT::Remaining_face& f : result.remaining)
    EXPECT_EQ(f.reason, Remaining_reason::no_area);
}

} // namespace
