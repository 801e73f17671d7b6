// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "equality.h"
#include "hard_meshes.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_exact_refinement {

using namespace Test_surfaces;
using Exact_triangulation = IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>;
using IT::Refinement_result;
using IT::Remaining_reason;

constexpr std::size_t insertion_limit = 60000;

template <typename Any_triangulation>
Refinement_result refined(Any_triangulation& tri)
{
  return IT::refine(tri, IT::parameters::maximum_number_of_insertions(insertion_limit));
}

// Returns the least angle of a face from its sides in extended precision. The sides are certified
// up to 2^-40, and faces that satisfy the bound are not thin.
template <typename Any_triangulation>
double least_angle(const Any_triangulation& tri, Face_index f)
{
  std::array<long double, 3> side;
  for(std::size_t s = 0; s < 3; ++s)
    side[s] = tri.length(tri.mesh().edge(IT::sides(f, tri.mesh())[s]));
  std::sort(side.begin(), side.end());
  const auto [a, b, c] = side;
  return double(std::acos((b * b + c * c - a * a) / (2 * b * c)) * 180 / std::acos(-1.L));
}

template <typename Any_triangulation>
void expect_bound(const Any_triangulation& tri, const Refinement_result& result)
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

template <typename Any_triangulation>
void expect_places(const Any_triangulation& tri)
{
  for(const auto& m : tri.inserted_vertices()) {
    EXPECT_TRUE(IT::internal::can_be_inserted(m, tri.input_mesh()));
    const auto b = IT::face_location(m, tri.input_mesh()).second;
    EXPECT_EQ(std::count(b.begin(), b.end(), 0.), IT::on_edge(m) ? 1 : 0);
  }
}

// Checks that each stored length is the length on the exact surface.
void expect_lengths(const Exact_triangulation& tri)
{
  Exact_triangulation fresh = tri;
  fresh.recompute_lengths();
  for(Edge_index e : tri.mesh().edges())
    EXPECT_NEAR(tri.length(e) / fresh.length(e), 1, 0x1p-39) << e;
}

template <typename Any_triangulation>
void expect_certified(const Any_triangulation& tri, const Refinement_result& result)
{
  EXPECT_NE(result.status, IT::Refinement_status::insertion_limit);
  EXPECT_TRUE(tri.is_valid(true));
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(tri);
  EXPECT_TRUE(certificate.non_straight_edges.empty());
  EXPECT_TRUE(certificate.non_Delaunay_edges.empty());
  EXPECT_TRUE(certificate.folded_vertices.empty());
  expect_bound(tri, result);
  expect_places(tri);
}

void expect_refined(const std::string& name, const Mesh& mesh)
{
  SCOPED_TRACE(name);
  Exact_triangulation tri(mesh);
  const Refinement_result result = refined(tri);
  EXPECT_TRUE(result.is_exact);
  expect_certified(tri, result);
  expect_lengths(tri);
}

// The meshes are a sample of small ones, or the first n if EXACT_REFINEMENT_SEEDS is n.
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

// Counts the inserted vertices, and notices their removal.
struct Insertion_counter : IT::Default_refinement_visitor
{
  template <typename Traits>
  void after_insertion(Vertex_index, const IT::Vertex_inserter<Traits>&)
  {
    ++vertices;
  }
  void after_removal(Vertex_index, Face_index) { --vertices; }
  void before_exact_flips() { has_exact_flips = true; }
  void before_exact_refinement()
  {
    EXPECT_EQ(triangulation->number_of_inserted_vertices(), 0u);
    ++restarts;
    vertices = 0;
  }

  explicit Insertion_counter(const Triangulation& tri) : triangulation(&tri) {}

  const Triangulation* triangulation;
  std::size_t vertices = 0;
  int restarts = 0;
  bool has_exact_flips = false;
};

// Checks refinement in `double`. If it restarts because a filter failed, it equals refinement with
// exact traits. Otherwise it needs at most about as many vertices. The result is always certified.
void expect_refined_in_double(const std::string& name, const Mesh& mesh)
{
  SCOPED_TRACE(name);
  Triangulation tri(mesh);
  Insertion_counter counter(tri);
  const Refinement_result result = IT::refine(
    tri, IT::parameters::maximum_number_of_insertions(insertion_limit).visitor(std::ref(counter)));
  EXPECT_EQ(counter.vertices, tri.number_of_inserted_vertices());
  EXPECT_EQ(counter.vertices, result.insertions - result.removals);
  const bool is_restarted = counter.restarts == 1 || counter.has_exact_flips;
  EXPECT_TRUE(result.is_exact || !is_restarted);
  expect_certified(tri, result);
  Exact_triangulation exact(mesh);
  const std::size_t expected = refined(exact).insertions;
  if(!is_restarted) {
    EXPECT_LE(double(result.insertions), 10 + 1.2 * double(expected));
    return;
  }
  EXPECT_EQ(result.insertions, expected);
  for(Edge_index e : tri.mesh().edges())
    EXPECT_NEAR(tri.length(e) / exact.length(e), 1, 0x1p-39) << e;
}

TEST(Exact_refinement, in_double_goes_on_where_rounding_leaves_doubts)
{
  const char* all = std::getenv("EXACT_REFINEMENT_SEEDS");
  if(all == nullptr)
    for(std::uint64_t seed : {1u, 4u, 5u, 9u, 10u, 13u, 16u, 21u, 27u, 46u, 48u, 58u, 61u, 73u, 85u,
                              97u, 930033u, 950722u})
      expect_refined_in_double(std::to_string(seed), hard_mesh(seed).mesh);
  else
    for(std::uint64_t seed = 0; seed < std::strtoull(all, nullptr, 10); ++seed)
      expect_refined_in_double(std::to_string(seed), hard_mesh(seed).mesh);
}

// Squares on a turned grid are ties that rounding breaks. Refinement in `double` continues, and the
// visitor is not notified of a restart.
TEST(Exact_refinement, in_double_is_certified_on_ordinary_meshes)
{
  Portable_random random(6);
  for(int i = 0; i < 30; ++i) {
    const Mesh mesh =
      i % 3 == 0
        ? turned_apart(grid(5, 4, [](double x, double y) { return Point(x, y, 0); }), random)
        : hard_base(random);
    Triangulation tri(mesh);
    Insertion_counter counter(tri);
    const Refinement_result result =
      IT::refine(tri, IT::parameters::minimum_angle(i % 2 == 0 ? 25. : 20.)
                        .maximum_circumradius(i % 3 == 0 ? 0.3 : 1e100)
                        .visitor(std::ref(counter)));
    EXPECT_EQ(counter.restarts, 0);
    EXPECT_EQ(counter.vertices, tri.number_of_inserted_vertices());
    EXPECT_EQ(counter.vertices, result.insertions - result.removals);
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay()) << i;
  }
}

// This holds even if it needs more vertices than exact decisions from the beginning.
TEST(Exact_refinement, in_double_is_certified_on_hard_meshes)
{
  for(std::uint64_t seed : seeds(30, 62)) {
    const Mesh mesh = hard_mesh(seed).mesh;
    if(mesh.number_of_faces() > 600)
      continue;
    Triangulation tri(mesh);
    const Refinement_result result = refined(tri);
    expect_certified(tri, result);
  }
}

// Certain decisions in floating point are correct: exact arithmetic agrees that these edges are
// straight, and numbers with more digits agree on their lengths.
TEST(Exact_refinement, edges_without_doubt_are_straight)
{
  std::size_t certain = 0;
  for(std::uint64_t seed = 0; seed < 60; ++seed) {
    const Mesh mesh = hard_mesh(seed).mesh;
    if(mesh.number_of_faces() > 300)
      continue;
    Triangulation tri(mesh);
    IT::refine(tri, IT::parameters::maximum_number_of_insertions(std::size_t(300)));
    const auto decisions = IT::internal::exact_decisions(tri);
    auto exact = IT::internal::exact_decisions(tri);
    IT::Precise_lengths<Triangulation::Traits> precise(tri);
    for(Edge_index e : tri.mesh().edges()) {
      const Halfedge_index h = tri.mesh().halfedge(e);
      const auto straight = decisions.straight_edge(h);
      if(!straight.is_certain)
        continue;
      ++certain;
      EXPECT_TRUE(exact.is_input_edge(h) || exact.is_straight(h)) << seed << ' ' << e;
      if(!std::isnan(straight.length)) {
        EXPECT_NEAR(straight.length / to_double(precise(h)), 1, straight.error) << seed << ' ' << e;
      }
    }
  }
  EXPECT_GT(certain, 1000u);
}

// Refinement is exact on request, too, and can continue a refinement with exact decisions.
TEST(Exact_refinement, in_double_on_request)
{
  Portable_random random(2);
  for(int i = 0; i < 5; ++i) {
    const Mesh mesh = hard_base(random);
    Triangulation tri(mesh);
    Exact_triangulation exact(mesh);
    EXPECT_EQ(IT::refine(tri, IT::parameters::exact_decisions(true)).insertions,
              refined(exact).insertions);
    const Refinement_result result =
      IT::refine(tri, IT::parameters::exact_decisions(true).minimum_angle(28));
    EXPECT_TRUE(result.is_exact);
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay()) << i;
    for(Face_index f : tri.mesh().faces())
      EXPECT_GE(least_angle(tri, f), result.remaining.empty() ? 28 - 1e-6 : 0);
  }
}

// An exception of the visitor at the restart leaves the input.
TEST(Exact_refinement, can_be_stopped_before_exact_decisions)
{
  struct Stopped
  {};
  struct Visitor : IT::Default_refinement_visitor
  {
    void before_exact_refinement() { throw Stopped(); }
  };
  const Triangulation given(hard_mesh(5).mesh);
  Triangulation tri = given;
  Visitor visitor;
  EXPECT_THROW(IT::refine(tri, IT::parameters::visitor(std::ref(visitor))), Stopped);
  EXPECT_EQ(text_of(tri), text_of(given));
}

// Flips at random, some of which make edges that are not straight.
void bend(Triangulation& tri, Portable_random& random)
{
  const int edges = static_cast<int>(tri.mesh().number_of_edges());
  for(int flip = 0; flip < edges / 4; ++flip) {
    const Halfedge_index h =
      tri.mesh().halfedge(Edge_index(static_cast<unsigned>(random.get_int(0, edges))));
    if(IT::flip_status(h, tri.mesh()) == IT::Operation_status::possible &&
       !tri.is_constrained(tri.mesh().edge(h)))
      try {
        tri.flip(h);
      } catch(const IT::Numerical_error&) {
      }
  }
}

// Inserted vertices keep their positions if T2 is rebuilt from T1, and refinement continues.
TEST(Exact_refinement, bent_edges_between_inserted_vertices_are_repaired)
{
  Portable_random random(9);
  std::size_t bent = 0;
  for(std::uint64_t seed : seeds(24)) {
    Mesh mesh = seed % 2 == 0 ? hard_base(random) : hard_mesh(seed).mesh;
    auto is_constrained = mesh.add_property_map<Edge_index, bool>("e:constrained", false).first;
    for(Edge_index e : mesh.edges())
      is_constrained[e] = seed % 3 == 0 && random.get_int(0, 5) == 0;
    Triangulation tri(mesh, IT::parameters::edge_is_constrained_map(is_constrained));
    IT::refine(tri, IT::parameters::face_predicate([](Face_index) {
                      return true;
                    }).maximum_number_of_insertions(std::size_t(60)));
    bend(tri, random);
    bent += !IT::certify_Delaunay(tri).is_geodesic();
    const auto places = tri.inserted_vertices();
    IT::make_Delaunay(tri, IT::parameters::exact_decisions(true));
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay());
    EXPECT_TRUE(tri.is_valid(true));
    ASSERT_EQ(tri.number_of_inserted_vertices(), places.size());
    for(std::size_t i = 0; i < places.size(); ++i)
      EXPECT_EQ(IT::face_location(tri.inserted_vertices()[i], tri.input_mesh()),
                IT::face_location(places[i], tri.input_mesh()));
    bend(tri, random);
    const Refinement_result result = refined(tri);
    EXPECT_GE(tri.number_of_inserted_vertices(), places.size());
    expect_certified(tri, result);
  }
  EXPECT_GT(bent, 20u);
}

// Flips and inserted vertices are gone; constraints stay, also those of edges that were split.
TEST(Exact_refinement, reset_gives_the_input)
{
  Portable_random random(4);
  for(int i = 0; i < 5; ++i) {
    Mesh mesh = hard_base(random);
    auto is_constrained = mesh.add_property_map<Edge_index, bool>("e:constrained", false).first;
    for(Edge_index e : mesh.edges())
      is_constrained[e] = random.get_int(0, 5) == 0;
    const Triangulation given(mesh, IT::parameters::edge_is_constrained_map(is_constrained));
    Triangulation tri = given;
    IT::refine(tri, IT::parameters::face_predicate([](Face_index) {
                      return true;
                    }).maximum_number_of_insertions(std::size_t(200)));
    EXPECT_GT(tri.number_of_inserted_vertices(), 0u);
    tri.reset_to_input();
    EXPECT_EQ(text_of(tri), text_of(given));
    EXPECT_TRUE(tri.is_valid(true));
  }
}

TEST(Exact_refinement, faces_excused_are_those_at_small_angle_vertices)
{
  for(Remaining_reason reason :
      {Remaining_reason::at_small_angle_vertex, Remaining_reason::beside_small_angle_vertex,
       Remaining_reason::insertion_limit, Remaining_reason::no_room, Remaining_reason::at_rounding,
       Remaining_reason::no_area})
    EXPECT_EQ(IT::is_excused({Face_index(0), reason, Vertex_index(0)}),
              reason == Remaining_reason::at_small_angle_vertex ||
                reason == Remaining_reason::beside_small_angle_vertex);
}

// Geometry determines the number of vertices: it equals the number in `double` if no decision is
// undecided.
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

// Returns the crossed edges that can be split.
template <typename Inserter>
std::vector<Halfedge_index> crossed_edges(const Inserter& inserter)
{
  const Delta_complex& mesh = inserter.triangulation().mesh();
  std::vector<Halfedge_index> result;
  for(Halfedge_index h : mesh.halfedges())
    if(inserter.courses().count(h) > 0 && inserter.can_be_split(h))
      result.push_back(h);
  return result;
}

template <typename Mesh_type>
std::multiset<Vertex_index> neighbors(Vertex_index v, const Mesh_type& mesh)
{
  std::multiset<Vertex_index> result;
  IT::for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) { result.insert(mesh.target(h)); });
  return result;
}

// Splits crossed edges anywhere; nothing changes where that is not possible. Returns the number of
// vertices.
template <typename Any_triangulation>
std::size_t expect_split_exactly(Any_triangulation tri, Portable_random& random, bool is_hard)
{
  IT::make_Delaunay(tri, IT::parameters::exact_decisions(true));
  const bool is_geodesic = IT::certify_Delaunay(tri).is_geodesic();
  std::size_t count = 0;
  IT::Vertex_inserter<typename Any_triangulation::Traits> inserter(tri, true);
  for(int i = 0; i < 20; ++i) {
    const std::vector<Halfedge_index> crossed = crossed_edges(inserter);
    if(crossed.empty())
      break;
    const Halfedge_index h = crossed[std::size_t(random.get_int(0, int(crossed.size())))];
    const double t = std::ldexp(random.get_double(0.1, 1), i % 3 == 0 ? -i : 0);
    const double length = tri.length(tri.mesh().edge(h));
    const Vertex_index source = tri.mesh().source(h), target = tri.mesh().target(h);
    const auto before = tri.mesh().number_of_edges();
    try {
      const Vertex_index m = inserter.split_edge(h, t, i % 2 == 0 ? 0 : 1e-3 * length);
      EXPECT_EQ(tri.mesh().number_of_edges(), before + 3);
      const auto around = neighbors(m, tri.mesh());
      EXPECT_TRUE(around.count(source) > 0 && around.count(target) > 0);
      EXPECT_TRUE(is_hard || around.size() == 4);
      ++count;
    } catch(const IT::Numerical_error&) {
      EXPECT_EQ(tri.mesh().number_of_edges(), before);
      EXPECT_EQ(tri.mesh().source(h), source);
    }
  }
  tri.collect_garbage();
  EXPECT_TRUE(tri.is_valid(true));
  EXPECT_EQ(IT::certify_Delaunay(tri).is_geodesic(), is_geodesic);
  return count;
}

TEST(Exact_refinement, crossed_edges_are_split)
{
  Portable_random random(5);
  std::size_t count = 0;
  for(std::uint64_t seed = 0; seed < 60; ++seed) {
    const Mesh mesh = hard_mesh(seed).mesh;
    if(mesh.number_of_faces() > 300)
      continue;
    SCOPED_TRACE(seed);
    count += expect_split_exactly(Exact_triangulation(mesh), random, true);
    count += expect_split_exactly(Triangulation(mesh), random, true);
  }
  EXPECT_GT(count, 1000u);
  for(int i = 0; i < 10; ++i)
    expect_split_exactly(Exact_triangulation(hard_base(random)), random, false);
}

// A vertex that is moved onto an edge of T1 near its target keeps its distance from the target.
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

// The only vertex to refine lies exactly on a boundary edge, and cannot be flipped away.
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

// The least length of an edge is 2^-127. Insertions that would make shorter edges fail, and must
// change nothing.
TEST(Exact_refinement, failed_insertions_change_nothing)
{
  const double s = std::ldexp(1.5, -127);
  const Mesh mesh = make_mesh({Point(0, 0, 0), Point(s, 0, 0), Point(s, s, 0), Point(0, s, 0)},
                              {{0, 1, 2}, {0, 2, 3}});
  for(const bool is_exact : {false, true}) {
    Triangulation tri(mesh);
    Insertion_counter counter(tri);
    const Refinement_result result =
      IT::refine(tri, IT::parameters::maximum_circumradius(s / 2).exact_decisions(is_exact).visitor(
                        std::ref(counter)));
    EXPECT_EQ(result.status, IT::Refinement_status::no_room);
    EXPECT_EQ(counter.vertices, tri.number_of_inserted_vertices());
    EXPECT_EQ(counter.vertices, result.insertions - result.removals);
    EXPECT_TRUE(tri.is_valid(true));
    for(IT::Edge_index e : tri.mesh().edges())
      EXPECT_GE(tri.length(e), std::ldexp(1., -127));
  }
}

} // namespace Test_exact_refinement
