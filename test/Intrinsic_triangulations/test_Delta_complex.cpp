// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace Test_Delta_complex {

using namespace Test_surfaces;
using IT::Operation_status;

struct Counts
{
  long vertices, edges, faces;

  friend bool operator==(const Counts& a, const Counts& b)
  {
    return a.vertices == b.vertices && a.edges == b.edges && a.faces == b.faces;
  }
};

Counts counts(const Delta_complex& mesh)
{
  return {mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces()};
}

void expect_valid(const Delta_complex& mesh, const Counts& expected)
{
  EXPECT_TRUE(IT::is_valid_Delta_complex(mesh, true));
  EXPECT_TRUE(mesh.is_valid(true));
  EXPECT_TRUE(counts(mesh) == expected);
}

// Returns whether halfedges are equal, with equal ends and neighbors.
bool same_links(const Delta_complex& a, const Delta_complex& b)
{
  for(Halfedge_index h : a.halfedges())
    if(b.is_removed(h) || a.next(h) != b.next(h) || a.prev(h) != b.prev(h) ||
       a.target(h) != b.target(h) || a.is_border(h) != b.is_border(h))
      return false;
  return counts(a) == counts(b);
}

bool same_faces(const Delta_complex& a, const Delta_complex& b)
{
  for(Halfedge_index h : a.halfedges())
    if(a.face(h) != b.face(h))
      return false;
  return same_links(a, b);
}

// Whether walking both complexes from these halfedges on meets no difference.
bool match(const Delta_complex& a, const Delta_complex& b, Halfedge_index in_a, Halfedge_index in_b)
{
  std::map<Halfedge_index, Halfedge_index> image;
  std::map<Vertex_index, Vertex_index> image_of_target;
  std::vector<std::pair<Halfedge_index, Halfedge_index>> open{{in_a, in_b}};
  while(!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    const auto [entry, is_new] = image.emplace(x, y);
    if(entry->second != y || a.is_border(x) != b.is_border(y) ||
       image_of_target.emplace(a.target(x), b.target(y)).first->second != b.target(y))
      return false;
    if(is_new) {
      open.emplace_back(a.next(x), b.next(y));
      open.emplace_back(a.opposite(x), b.opposite(y));
    }
  }
  return image.size() == a.number_of_halfedges();
}

// Returns whether two connected complexes are isomorphic.
bool isomorphic(const Delta_complex& a, const Delta_complex& b)
{
  const auto halfedges = b.halfedges();
  return counts(a) == counts(b) &&
         std::any_of(halfedges.begin(), halfedges.end(),
                     [&](Halfedge_index h) { return match(a, b, *a.halfedges().begin(), h); });
}

void for_each_complex(const std::function<void(const Delta_complex&)>& check)
{
  for(const Named_complex& c : traced(complexes()))
    check(c.mesh);
}

bool in_one_face(Halfedge_index h, const Delta_complex& mesh)
{
  return mesh.face(h) == mesh.face(mesh.opposite(h));
}

void check_flip(Halfedge_index h, const Delta_complex& before)
{
  Delta_complex mesh = before;
  const Halfedge_index o = mesh.opposite(h);
  const Halfedge_index jk = mesh.next(h), ki = mesh.prev(h), il = mesh.next(o), lj = mesh.prev(o);
  IT::flip_edge(h, mesh);
  expect_valid(mesh, counts(before));
  EXPECT_EQ(mesh.target(h), before.target(jk));
  EXPECT_EQ(mesh.source(h), before.target(il));
  EXPECT_TRUE(mesh.next(h) == ki && mesh.next(ki) == il && mesh.next(il) == h);
  EXPECT_TRUE(mesh.next(o) == lj && mesh.next(lj) == jk && mesh.next(jk) == o);
  IT::flip_edge(h, mesh); // the edge is back, but backwards
  EXPECT_TRUE(mesh.next(h) == il && mesh.next(il) == lj && mesh.next(lj) == h);
  EXPECT_TRUE(match(before, mesh, h, o));
  IT::flip_edge(h, mesh);
  IT::flip_edge(h, mesh);
  EXPECT_TRUE(same_faces(before, mesh));
  expect_valid(mesh, counts(before));
}

void check_split_face(Halfedge_index h, const Delta_complex& before)
{
  Delta_complex mesh = before;
  const Halfedge_index inward = IT::split_face(h, mesh);
  const Counts c = counts(before);
  expect_valid(mesh, {c.vertices + 1, c.edges + 3, c.faces + 2});
  EXPECT_EQ(mesh.source(inward), before.target(h));
  EXPECT_EQ(mesh.next(h), inward);
  EXPECT_EQ(IT::removal_status(mesh.target(inward), mesh), Operation_status::possible);
  const Face_index f = IT::remove_degree_3_vertex(mesh.target(inward), mesh);
  EXPECT_EQ(mesh.face(h), f);
  expect_valid(mesh, c);
  EXPECT_TRUE(same_links(before, mesh));
}

// Splits the edge of h, checks the result and returns the halfedge to the new vertex.
Halfedge_index split(Halfedge_index h, Delta_complex& mesh)
{
  const Counts c = counts(mesh);
  const Vertex_index i = mesh.source(h), j = mesh.target(h);
  const int sides = !mesh.is_border(h) + !mesh.is_border(mesh.opposite(h));
  const Halfedge_index first = IT::split_edge(h, mesh);
  expect_valid(mesh, {c.vertices + 1, c.edges + 1 + sides, c.faces + sides});
  EXPECT_TRUE(mesh.source(first) == i && mesh.target(h) == j);
  EXPECT_EQ(mesh.target(first), mesh.source(h));
  return first;
}

void check_split_border_edge(Halfedge_index h, const Delta_complex& before)
{
  Delta_complex mesh = before;
  const Vertex_index m = mesh.target(split(h, mesh));
  EXPECT_EQ(IT::removal_status(m, mesh), Operation_status::possible);
  IT::remove_degree_3_vertex(m, mesh);
  expect_valid(mesh, counts(before));
  EXPECT_TRUE(isomorphic(before, mesh));
}

// Checks that a flip removes one of four edges from the new vertex.
void check_split_inner_edge(Halfedge_index h, const Delta_complex& before)
{
  for(Delta_complex::size_type cut = 0; cut < 2; ++cut) {
    Delta_complex mesh = before;
    const Vertex_index m = mesh.target(split(h, mesh));
    EXPECT_EQ(IT::removal_status(m, mesh), Operation_status::wrong_degree);
    const Halfedge_index outgoing(mesh.number_of_halfedges() - 2 - 2 * cut);
    EXPECT_TRUE(mesh.source(outgoing) == m || mesh.target(outgoing) == m);
    IT::flip_edge(outgoing, mesh);
    EXPECT_EQ(IT::removal_status(m, mesh), Operation_status::possible);
    IT::remove_degree_3_vertex(m, mesh);
    expect_valid(mesh, counts(before));
    EXPECT_TRUE(isomorphic(before, mesh));
  }
}

struct Outgoing_halfedges_found
{
  std::size_t degree = 0, loops = 0;
};

Outgoing_halfedges_found count_outgoing_halfedges(Vertex_index v, const Delta_complex& mesh)
{
  Outgoing_halfedges_found result;
  for(Halfedge_index h : mesh.halfedges()) {
    result.degree += mesh.target(h) == v;
    result.loops += mesh.target(h) == v && mesh.source(h) == v; // twice for each
  }
  return result;
}

void check_join(Halfedge_index h, const Delta_complex& before)
{
  Delta_complex mesh = before;
  split(h, mesh);
  IT::join_edge(h, mesh);
  expect_valid(mesh, counts(before));
  EXPECT_TRUE(same_faces(before, mesh));
}

// Checks that the edge of a degree-1 vertex j becomes two, with a loop around j and a diagonal.
void check_split_inside_face(Halfedge_index h, const Delta_complex& before)
{
  Delta_complex mesh = before;
  const bool winds_around_target = mesh.next(h) == mesh.opposite(h);
  const Halfedge_index first = split(h, mesh);
  EXPECT_NE(IT::removal_status(mesh.target(first), mesh), Operation_status::possible);
  const Halfedge_index to_tip = winds_around_target ? h : mesh.opposite(first);
  EXPECT_EQ(mesh.next(to_tip), mesh.opposite(to_tip));
  EXPECT_EQ(count_outgoing_halfedges(mesh.target(to_tip), mesh).degree, 1u);
  EXPECT_EQ(count_outgoing_halfedges(mesh.source(to_tip), mesh).degree, 5u);
  EXPECT_EQ(count_outgoing_halfedges(mesh.source(to_tip), mesh).loops, 2u);
}

void check_removal(Vertex_index v, const Delta_complex& before)
{
  const Outgoing_halfedges_found found = count_outgoing_halfedges(v, before);
  const Operation_status status = IT::removal_status(v, before);
  EXPECT_EQ(status == Operation_status::possible, found.degree == 3 && found.loops == 0);
  EXPECT_TRUE(status != Operation_status::self_edge || found.loops > 0);
  if(status != Operation_status::possible)
    return;
  Delta_complex mesh = before;
  const bool on_border = mesh.is_border(v);
  const Face_index f = IT::remove_degree_3_vertex(v, mesh);
  const Counts c = counts(before);
  EXPECT_FALSE(mesh.is_removed(f));
  expect_valid(mesh,
               {c.vertices - 1, c.edges - (on_border ? 2 : 3), c.faces - (on_border ? 1 : 2)});
}

// Applies one operation at a random halfedge, if it is possible.
void random_operation(Delta_complex& mesh, CGAL::Random& random)
{
  const int size = static_cast<int>(mesh.num_halfedges());
  const Halfedge_index h(static_cast<Delta_complex::size_type>(random.get_int(0, size)));
  if(mesh.is_removed(h))
    return;
  const int kind = random.get_int(0, 6);
  if(kind == 0 && !mesh.is_border(h))
    IT::split_face(h, mesh);
  else if(kind == 1)
    IT::split_edge(h, mesh);
  else if(kind == 2 && IT::removal_status(mesh.target(h), mesh) == Operation_status::possible)
    IT::remove_degree_3_vertex(mesh.target(h), mesh);
  else if(kind > 2 && IT::flip_status(h, mesh) == Operation_status::possible)
    IT::flip_edge(h, mesh);
}

void expect_defect(const Delta_complex& mesh, const std::string& message)
{
  EXPECT_FALSE(IT::is_valid_Delta_complex(mesh));
  const std::string found = IT::internal::Delta_complex_defect(mesh);
  EXPECT_NE(found.find(message), std::string::npos) << found << " is not " << message;
}

void expect_defect_after(const Delta_complex& good, const std::string& message,
                         const std::function<void(Delta_complex&)>& damage)
{
  Delta_complex mesh = good;
  damage(mesh);
  expect_defect(mesh, message);
}

TEST(Delta_complex, generators_are_what_they_say)
{
  std::map<std::string, std::pair<int, std::size_t>> euler_and_loops;
  for(const Named_complex& c : complexes()) {
    EXPECT_TRUE(IT::is_valid_Delta_complex(c.mesh, true)) << c.name;
    euler_and_loops[c.name] = {Euler_characteristic(c.mesh), border_loops(c.mesh)};
  }
  using Expected = std::pair<int, std::size_t>;
  for(const char* sphere :
      {"tetrahedron", "cube", "random sphere", "double disk", "spindle", "pillow"})
    EXPECT_EQ(euler_and_loops[sphere], Expected(2, 0)) << sphere;
  for(const char* disk : {"triangle", "cone", "mirrored cone", "bigon", "polygon", "grid"})
    EXPECT_EQ(euler_and_loops[disk], Expected(1, 1)) << disk;
  for(const char* torus : {"torus", "torus with one vertex", "torus with two vertices"})
    EXPECT_EQ(euler_and_loops[torus], Expected(0, 0)) << torus;
  EXPECT_EQ(euler_and_loops["annulus"], Expected(0, 2));
  EXPECT_EQ(euler_and_loops["double torus"], Expected(-2, 0));
  EXPECT_EQ(euler_and_loops["torus with a hole"], Expected(-1, 1));
  EXPECT_EQ(euler_and_loops["sphere with three holes"], Expected(-1, 3));
}

TEST(Delta_complex, flip_status_and_four_flips)
{
  for_each_complex([](const Delta_complex& mesh) {
    for(Halfedge_index h : mesh.halfedges()) {
      SCOPED_TRACE(h.idx());
      const bool on_border = mesh.is_border(h) || mesh.is_border(mesh.opposite(h));
      const Operation_status expected = on_border              ? Operation_status::border_edge
                                        : in_one_face(h, mesh) ? Operation_status::same_face
                                                               : Operation_status::possible;
      EXPECT_EQ(IT::flip_status(h, mesh), expected);
      if(expected == Operation_status::possible)
        check_flip(h, mesh);
    }
  });
}

TEST(Delta_complex, split_face_and_back)
{
  for_each_complex([](const Delta_complex& mesh) {
    for(Halfedge_index h : mesh.halfedges())
      if(!mesh.is_border(h))
        check_split_face(h, mesh);
  });
}

TEST(Delta_complex, split_edge_and_back)
{
  for_each_complex([](const Delta_complex& mesh) {
    for(Halfedge_index h : mesh.halfedges()) {
      SCOPED_TRACE(h.idx());
      if(!in_one_face(h, mesh))
        check_join(h, mesh);
      if(mesh.is_border(h) || mesh.is_border(mesh.opposite(h)))
        check_split_border_edge(h, mesh);
      else if(in_one_face(h, mesh))
        check_split_inside_face(h, mesh);
      else
        check_split_inner_edge(h, mesh);
    }
  });
}

TEST(Delta_complex, removal)
{
  for_each_complex([](const Delta_complex& mesh) {
    for(Vertex_index v : mesh.vertices()) {
      SCOPED_TRACE(v.idx());
      check_removal(v, mesh);
    }
  });
}

TEST(Delta_complex, removal_at_a_boundary_loop_of_two_edges)
{
  Delta_complex mesh = bigon();
  IT::remove_degree_3_vertex(mesh.target(halfedge_of(3)), mesh);
  expect_valid(mesh, {2, 2, 1});
  EXPECT_TRUE(isomorphic(mesh, cone(false)));
}

TEST(Delta_complex, every_refusal_is_reached_and_has_words_of_its_own)
{
  std::set<Operation_status> seen;
  std::set<std::string> words;
  const auto see = [&](Operation_status status) {
    seen.insert(status);
    words.insert(IT::to_string(status));
  };
  for_each_complex([&](const Delta_complex& mesh) {
    for(Halfedge_index h : mesh.halfedges())
      see(IT::flip_status(h, mesh));
    for(Vertex_index v : mesh.vertices())
      see(IT::removal_status(v, mesh));
  });
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(words.size(), 5u);
  Delta_complex isolated;
  EXPECT_EQ(IT::removal_status(isolated.add_vertex(), isolated), Operation_status::wrong_degree);
}

TEST(Delta_complex, random_operations)
{
  for(unsigned int seed = 0; seed < 5; ++seed)
    for_each_complex([seed](const Delta_complex& before) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Delta_complex mesh = before;
      CGAL::Random random(seed);
      for(int i = 0; i < 150; ++i) {
        random_operation(mesh, random);
        ASSERT_TRUE(IT::is_valid_Delta_complex(mesh, true));
      }
      EXPECT_TRUE(mesh.is_valid(true));
      EXPECT_EQ(Euler_characteristic(mesh), Euler_characteristic(before));
      EXPECT_EQ(border_loops(mesh), border_loops(before));
    });
}

TEST(Delta_complex, outgoing_halfedges_are_in_order)
{
  for_each_complex([](const Delta_complex& mesh) {
    for(Halfedge_index h : mesh.halfedges()) {
      if(mesh.is_border(h))
        continue;
      EXPECT_EQ(mesh.source(IT::next_around_source(h, mesh)), mesh.source(h));
      EXPECT_EQ(IT::previous_around_source(IT::next_around_source(h, mesh), mesh), h);
    }
    for(Vertex_index v : mesh.vertices()) {
      const Halfedge_index first = IT::first_outgoing_halfedge(v, mesh);
      EXPECT_EQ(mesh.source(first), v);
      EXPECT_EQ(mesh.is_border(mesh.opposite(first)), mesh.is_border(v));
    }
  });
}

TEST(Delta_complex, broken_links_are_found)
{
  const Delta_complex good = glue({{1, 2, 3}, {-3, 4, 5}});
  const Halfedge_index h = halfedge_of(1), inner = halfedge_of(3);
  expect_defect_after(good, "next and prev disagree",
                      [&](Delta_complex& m) { m.set_next(m.prev(h), m.next(h)); });
  expect_defect_after(good, "next and prev disagree",
                      [&](Delta_complex& m) { m.set_next(h, Delta_complex::null_halfedge()); });
  expect_defect_after(good, "the next halfedge starts elsewhere",
                      [&](Delta_complex& m) { m.set_target(h, m.source(h)); });
  expect_defect_after(good, "the next halfedge is in another face",
                      [&](Delta_complex& m) { m.set_face(h, m.face(m.opposite(inner))); });
  expect_defect_after(good, "its face is removed",
                      [&](Delta_complex& m) { m.remove_face(m.face(h)); });
  expect_defect_after(good, "no face on either side", [&](Delta_complex& m) {
    const Vertex_index v = m.add_vertex();
    const Halfedge_index x = IT::internal::add_directed_edge(v, v, m);
    m.set_next(x, m.opposite(x));
    m.set_next(m.opposite(x), x);
  });
}

TEST(Delta_complex, quadrangles_are_found)
{
  Delta_complex mesh = glue({{1, 2, 3}, {-3, 4, 5}});
  const Halfedge_index h = halfedge_of(3), o = mesh.opposite(h);
  const Face_index f = mesh.face(h);
  mesh.set_next(mesh.prev(h), mesh.next(o));
  mesh.set_next(mesh.prev(o), mesh.next(h));
  for(int side : {1, 2, 4, 5})
    mesh.set_face(halfedge_of(side), f);
  mesh.set_halfedge(f, halfedge_of(1));
  mesh.remove_edge(mesh.edge(h));
  expect_defect(mesh, "its face is not a triangle");
}

TEST(Delta_complex, broken_vertices_and_faces_are_found)
{
  const Delta_complex good = glue({{1, 2, 3}, {-3, 4, 5}});
  const Halfedge_index h = halfedge_of(1), inner = halfedge_of(3);
  expect_defect_after(good, "its halfedge is in another face",
                      [&](Delta_complex& m) { m.set_halfedge(m.face(inner), m.opposite(inner)); });
  expect_defect_after(good, "it has edges but no halfedge", [&](Delta_complex& m) {
    m.set_halfedge(m.target(h), Delta_complex::null_halfedge());
  });
  expect_defect_after(good, "its halfedge does not lead to it",
                      [&](Delta_complex& m) { m.set_halfedge(m.target(h), m.opposite(h)); });
  expect_defect_after(good, "its halfedge does not lead to it",
                      [&](Delta_complex& m) { m.set_halfedge(m.add_vertex(), h); });
  expect_defect_after(good, "it is on the boundary but its halfedge is not",
                      [&](Delta_complex& m) { m.set_halfedge(m.target(h), h); });
}

TEST(Delta_complex, pinched_vertices_are_found)
{
  Delta_complex mesh = glue({{1, 2, 3}, {4, 5, 6}});
  const Vertex_index v = mesh.target(halfedge_of(1)), w = mesh.target(halfedge_of(4));
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.target(h) == w)
      mesh.set_target(h, v);
  mesh.remove_vertex(w);
  expect_defect(mesh, "it has more than one vertex fan");
}

// Checks the type while handles and loops are glued in and cut out one by one.
template <typename Graph>
void expect_topological_type(const Graph& g, std::size_t components, std::size_t loops,
                             std::size_t genus)
{
  const IT::Topological_type type = IT::topological_type(g);
  EXPECT_EQ(type.components, components);
  EXPECT_EQ(type.boundary_loops, loops);
  EXPECT_EQ(type.genus, genus);
}

TEST(Topological_type, is_that_of_known_surfaces)
{
  expect_topological_type(Delta_complex(), 0, 0, 0);
  expect_topological_type(cone(false), 1, 1, 0);
  expect_topological_type(double_torus(), 1, 0, 2);
  Mesh all = punctured(random_sphere(40, 1), {0, 30});
  expect_topological_type(all, 1, 2, 0);
  all += embedded_torus(5, 4);
  all.add_vertex(Point(0, 0, 0));
  expect_topological_type(all, 2, 2, 1);
  all += punctured(embedded_torus(5, 4), {3});
  expect_topological_type(all, 3, 3, 2);
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  CGAL::copy_face_graph(punctured(embedded_torus(5, 4), {0, 20}), polyhedron);
  expect_topological_type(polyhedron, 1, 2, 1);
}

TEST(Delta_complex, refusals_are_preconditions)
{
  Delta_complex mesh = cone(false);
  const CGAL::Failure_behaviour behaviour = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const CGAL::Failure_function silent = [](const char*, const char*, const char*, int,
                                           const char*) {};
  const CGAL::Failure_function handler = CGAL::set_error_handler(silent);
  EXPECT_THROW(IT::flip_edge(halfedge_of(1), mesh), CGAL::Precondition_exception);
  EXPECT_THROW(IT::flip_edge(halfedge_of(2), mesh), CGAL::Precondition_exception);
  EXPECT_THROW(IT::split_face(mesh.opposite(halfedge_of(2)), mesh), CGAL::Precondition_exception);
  for(Vertex_index v : mesh.vertices())
    EXPECT_THROW(IT::remove_degree_3_vertex(v, mesh), CGAL::Precondition_exception);
  CGAL::set_error_handler(handler);
  CGAL::set_error_behaviour(behaviour);
  EXPECT_TRUE(same_faces(mesh, cone(false)));
}

} // namespace Test_Delta_complex
