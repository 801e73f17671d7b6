// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_FLAT_INSERTION_H
#define INTRINSIC_TRIANGULATIONS_TEST_FLAT_INSERTION_H

#include "brute_force.h"
#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>

// This file tests T2 with more vertices over a flat T1, with the exact positions of all vertices.
namespace Test_surfaces {

using Inserter = IT::Vertex_inserter<>;

constexpr std::int64_t refinement = 1 << 12; // so that places between vertices are integers

inline Flat_surface refined(Flat_surface s)
{
  for(Vector& v : s.vector)
    v = refinement * v;
  for(Vector& p : s.point)
    p = refinement * p;
  const bool is_planar = s.a == Vector{beyond, 0};
  s.a = (is_planar ? 1024 : refinement) * s.a; // squares fit into 64 bits
  s.b = (is_planar ? 1024 : refinement) * s.b;
  return s;
}

// Returns all numbers of T2 without removed elements.
inline std::vector<double> state(const Triangulation& t)
{
  const Delta_complex& mesh = t.mesh();
  std::vector<double> result;
  const auto note = [&](auto number) { result.push_back(static_cast<double>(number)); };
  for(Halfedge_index h : mesh.halfedges()) {
    for(auto index : {h.idx(), mesh.next(h).idx(), mesh.face(h).idx(), mesh.target(h).idx()})
      note(index);
    note(t.coordinates().roundabout(h));
  }
  for(Edge_index e : mesh.edges()) {
    note(t.length(e));
    note(t.coordinates().normal_coordinate(e));
    note(t.is_constrained(e));
  }
  for(Vertex_index v : mesh.vertices()) {
    note(v.idx());
    note(t.outgoing_halfedges().degree(v));
    if(!t.is_inserted(v))
      continue;
    note(IT::halfedge_of(t.inserted_vertex(v)).idx());
    const auto [f, b] = IT::face_location(t.inserted_vertex(v), t.input_mesh());
    note(f.idx());
    for(double x : b)
      note(x);
  }
  return result;
}

// Whether two sides of a triangle, one after the other, are those of one that double can work with.
inline bool is_fat(const Vector& u, const Vector& v)
{
  const double longest = (std::max)({length(u), length(v), length(u + v)});
  return static_cast<double>(det(u, v)) > 0.01 * longest * longest;
}

// Returns the relative error of distances on a surface whose edge lengths have been rounded, to
// first order. A relative error e of the sides a, b, c of a triangle changes squares of distances
// in it by a relative error of at most e a b c (a + b + c) / (2 area^2).
inline double rounding_of_distances(const Flat_surface& s)
{
  double worst = 0;
  for(Face_index f : s.mesh.faces()) {
    const auto h = IT::sides(f, s.mesh);
    const double a = length(s.vector[h[0]]), b = length(s.vector[h[1]]), c = length(s.vector[h[2]]);
    const double doubled_area = static_cast<double>(det(s.vector[h[0]], s.vector[h[1]]));
    worst = (std::max)(worst, a * b * c * (a + b + c) / (doubled_area * doubled_area));
  }
  return worst * std::numeric_limits<double>::epsilon();
}

inline double longest(const Flat_surface& s)
{
  double result = 0;
  for(const Vector& v : s.vector)
    result = (std::max)(result, length(v));
  return result;
}

class Flat_insertion
{
public:
  // Every edge of T1 whose index is a multiple of `constrained` is constrained, or none if it is 0.
  Flat_insertion(const Flat_surface& surface, unsigned int constrained)
    : m_surface(refined(surface)),
      m_tri(with_constraints(m_surface, constrained)),
      m_inserter(m_tri),
      m_vector(m_surface.vector),
      m_point(m_surface.point),
      m_on(m_point.size()),
      m_rounding(4 * rounding_of_distances(m_surface)), // there are a few roundings
      m_longest(longest(m_surface))
  {}
  Flat_insertion(const Flat_insertion&) = delete;
  Flat_insertion& operator=(const Flat_insertion&) = delete;

  const Triangulation& triangulation() const { return m_tri; }
  const Flat_surface& surface() const { return m_surface; }

  // ---- Operations; they say whether they were possible ----

  bool flip(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index o = mesh.opposite(h);
    if(IT::flip_status(h, mesh) != IT::Operation_status::possible ||
       m_tri.is_constrained(mesh.edge(h)))
      return false;
    const Vector jk = m_vector[mesh.next(h)], ki = m_vector[mesh.prev(h)];
    const Vector il = m_vector[mesh.next(o)], lj = m_vector[mesh.prev(o)];
    if(!is_fat(ki, il) || !is_fat(lj, jk) || length(ki + il) > 15000. * refinement)
      return false;
    EXPECT_TRUE(m_tri.is_flippable(h));
    m_inserter.flip(h);
    after_flip(h);
    check(mesh.edge(h));
    return true;
  }

  // Inserts at a position away from all edges of T1.
  bool insert_into_face(Face_index f, CGAL::Random& random)
  {
    const auto side = IT::sides(f, m_tri.mesh());
    const int b1 = random.get_int(1, 15), b2 = random.get_int(1, 17 - b1);
    const Vector p =
      b1 * m_vector[side[0]] - b2 * m_vector[side[2]]; // 16 times the outgoing halfedge
    const Vector from_corner{p.x / 128 * 8, p.y / 128 * 8};
    return is_clear(m_point[m_tri.mesh().source(side[0])] + from_corner) &&
           insert(f, from_corner, {}, 0);
  }

  // Inserts at a position on an edge of T1 that crosses the face.
  bool insert_on_input(Face_index f, CGAL::Random& random)
  {
    const auto side = IT::sides(f, m_tri.mesh());
    const Halfedge_index x = random_halfedge(m_surface.mesh, random);
    const Vector v = m_surface.vector[x];
    const std::int64_t eighths = random.get_int(1, 8);
    const Vector offset{v.x / 8 * eighths, v.y / 8 * eighths};
    const Vector start =
      m_surface.point[m_surface.mesh.source(x)] + offset - m_point[m_tri.mesh().source(side[0])];
    const Vector middle = m_vector[side[0]] - m_vector[side[2]]; // three times that
    const auto near = [&](std::int64_t numerator) {
      return static_cast<std::int64_t>(std::round(
        static_cast<double>(numerator) / static_cast<double>(det(m_surface.a, m_surface.b))));
    };
    const Vector gap{middle.x / 3 - start.x, middle.y / 3 - start.y};
    const std::int64_t i = near(det(gap, m_surface.b)), j = near(det(m_surface.a, gap));
    return insert(f, start + i * m_surface.a + j * m_surface.b, {x, offset}, 1);
  }

  // Splits at a quarter, a half, or three quarters, by the edge, or by a point of a face.
  bool split(Halfedge_index h, CGAL::Random& random)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const std::int64_t quarters = random.get_int(1, 4);
    const Vector v = m_vector[h], p{v.x / 4 * quarters, v.y / 4 * quarters};
    const Halfedge_index o = mesh.opposite(h);
    const Vector place = m_point[mesh.source(h)] + p;
    if(!m_inserter.can_be_split(h) || v.x % 4 != 0 || v.y % 4 != 0 || !is_fat_split(h, p) ||
       !is_fat_split(o, p - v))
      return false;
    const std::optional<On_input> along = on_input(h);
    if(!along && !is_clear(place))
      return false;
    const double t = static_cast<double>(quarters) / 4;
    const Vertex_index m = random.get_bool() && !mesh.is_border(h)
                             ? m_inserter.insert(IT::face_location(Edge_place{h, t}, mesh))
                             : m_inserter.split_edge(h, t);
    add_vertex(m, place, along ? On_input{along->halfedge, along->offset + p} : On_input());
    set_parts(h, p, v - p);
    check_around(m);
    return true;
  }

  bool remove(Vertex_index v)
  {
    if(!m_tri.is_inserted(v) || m_tri.mesh().is_removed(v))
      return false;
    std::set<Edge_index> outgoing_halfedges = edges_at(v);
    const Face_index f = m_inserter.remove(v, [&](Halfedge_index h) {
      after_flip(h);
      outgoing_halfedges = edges_at(v);
    });
    if(!f.is_valid())
      return false;
    const auto side = IT::sides(f, m_tri.mesh());
    for(std::size_t s = 0; s < 3; ++s)
      if(outgoing_halfedges.count(m_tri.mesh().edge(side[s])) > 0)
        set_vector(side[s], -(m_vector[side[(s + 1) % 3]] + m_vector[side[(s + 2) % 3]]));
    for(Halfedge_index h : side)
      check(m_tri.mesh().edge(h));
    check_orientation();
    return true;
  }

  // Removes the errors of lengths that flips have added. Positions on T1 are rounded, too, so that
  // a short edge has a larger relative error.
  void recompute_lengths()
  {
    m_tri.recompute_lengths();
    for(Edge_index e : m_tri.mesh().edges()) {
      const double exact = length(m_vector[m_tri.mesh().halfedge(e)]);
      EXPECT_NEAR(m_tri.length(e) / exact, 1, m_rounding * (std::max)(1., m_longest / exact)) << e;
    }
  }

  // ---- Checks ----

  void check_all() const
  {
    EXPECT_TRUE(m_tri.is_valid(true));
    check_orientation();
    for(Edge_index e : m_tri.mesh().edges())
      check(e);
    for(Vertex_index v : m_tri.mesh().vertices())
      check_place(v);
  }

  // Checks that every face has positive area, exactly.
  void check_orientation() const
  {
    for(Face_index f : m_tri.mesh().faces()) {
      const Halfedge_index h = m_tri.mesh().halfedge(f);
      ASSERT_GT(det(m_vector[h], m_vector[m_tri.mesh().next(h)]), 0) << f;
    }
  }

  // Checks that the courses of edges equal newly stored courses.
  void check_courses() const
  {
    const IT::internal::Edge_courses fresh(m_tri, IT::Concurrency());
    for(Halfedge_index h : m_tri.mesh().halfedges()) {
      const IT::Edge_course course = m_inserter.course(h), expected = fresh(h);
      ASSERT_EQ(course.size(), expected.size()) << h;
      for(std::size_t m = 0; m < course.size(); ++m)
        ASSERT_EQ(course[m], expected[m]) << h << ' ' << m;
    }
  }

  // Stores T2 without garbage, and the positions of its elements.
  struct Result
  {
    Triangulation triangulation;
    std::vector<Vector> point;  // of each vertex
    std::vector<Vector> vector; // of each halfedge
  };

  Result result() const
  {
    Result r{m_tri, {}, {}};
    r.triangulation.collect_garbage();
    Delta_complex mesh(m_tri.mesh()); // collects its garbage in the same way
    auto point = mesh.add_property_map<Vertex_index, Vector>("v:place", Vector{0, 0}).first;
    auto vector = mesh.add_property_map<Halfedge_index, Vector>("h:vector", Vector{0, 0}).first;
    for(Vertex_index v : mesh.vertices())
      point[v] = m_point[v];
    for(Halfedge_index h : mesh.halfedges())
      vector[h] = m_vector[h];
    mesh.collect_garbage();
    for(Vertex_index v : mesh.vertices())
      r.point.push_back(point[v]);
    for(Halfedge_index h : mesh.halfedges())
      r.vector.push_back(vector[h]);
    return r;
  }

private:
  // Stores a position on an edge of T1: a vector from the source of the halfedge, which is null for
  // no edge.
  struct On_input
  {
    Halfedge_index halfedge;
    Vector offset{0, 0};
  };

  static Triangulation with_constraints(const Flat_surface& surface, unsigned int constrained)
  {
    const auto lengths = surface.lengths();
    const auto length =
      boost::make_function_property_map<Edge_index>([&](Edge_index e) { return lengths[e.idx()]; });
    const auto is_constrained = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return constrained > 0 && e.idx() % constrained == 0; });
    return Triangulation(
      surface.mesh,
      IT::parameters::edge_length_map(length).edge_is_constrained_map(is_constrained));
  }

  // Inserts at `p`, a vector from the first corner of the face.
  bool insert(Face_index f, const Vector& p, const On_input& on, double closeness)
  {
    const auto side = IT::sides(f, m_tri.mesh());
    const Vector u = m_vector[side[0]], w = -m_vector[side[2]];
    const std::array<Vector, 3> outgoing{-p, u - p, w - p};
    for(std::size_t s = 0; s < 3; ++s)
      if(!is_fat(outgoing[s], outgoing[(s + 1) % 3] - outgoing[s]))
        return false;
    const Vector place = m_point[m_tri.mesh().source(side[0])] + p;
    const double area = static_cast<double>(det(u, w));
    const double b1 = static_cast<double>(det(p, w)) / area,
                 b2 = static_cast<double>(det(u, p)) / area;
    const Vertex_index m = m_inserter.insert({f, {1 - b1 - b2, b1, b2}}, closeness);
    add_vertex(m, place, on);
    for(std::size_t s = 0; s < 3; ++s)
      set_vector(m_tri.mesh().prev(side[s]), outgoing[s]);
    check_around(m);
    return true;
  }

  void add_vertex(Vertex_index m, const Vector& place, const On_input& on)
  {
    m_point.resize(m_tri.mesh().num_vertices(), Vector{0, 0}); // removed ones come again
    m_on.resize(m_point.size());
    m_point[m] = place;
    m_on[m] = on;
    m_vector.resize(m_tri.mesh().num_halfedges(), Vector{0, 0});
  }

  void set_vector(Halfedge_index h, const Vector& v)
  {
    m_vector[h] = v;
    m_vector[m_tri.mesh().opposite(h)] = -v;
  }

  void after_flip(Halfedge_index h)
  {
    set_vector(h, -(m_vector[m_tri.mesh().next(h)] + m_vector[m_tri.mesh().prev(h)]));
  }

  // Sets both parts of an edge, where `h` continues from the vertex that has split it.
  void set_parts(Halfedge_index h, const Vector& im, const Vector& mj)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index o = mesh.opposite(h);
    const Halfedge_index first = mesh.prev(mesh.is_border(h) ? h : mesh.opposite(mesh.prev(h)));
    set_vector(h, mj);
    set_vector(first, im);
    if(!mesh.is_border(h))
      set_vector(mesh.prev(h), -(mj + m_vector[mesh.next(h)]));
    if(!mesh.is_border(o))
      set_vector(mesh.next(o), -(m_vector[o] + m_vector[mesh.prev(o)]));
  }

  bool is_fat_split(Halfedge_index h, const Vector& p) const
  {
    if(m_tri.mesh().is_border(h))
      return true;
    const Vector apex = -m_vector[m_tri.mesh().prev(h)];
    return is_fat(p, apex - p) && is_fat(m_vector[h] - p, apex - m_vector[h]);
  }

  std::set<Edge_index> edges_at(Vertex_index v) const
  {
    std::set<Edge_index> result;
    for(Halfedge_index h : m_tri.mesh().halfedges())
      if(m_tri.mesh().target(h) == v)
        result.insert(m_tri.mesh().edge(h));
    return result;
  }

  std::int64_t crossings_with_input(const Segment& s) const
  {
    std::int64_t count = 0;
    for(Edge_index e : m_surface.mesh.edges()) {
      const Halfedge_index x = m_surface.mesh.halfedge(e);
      count += count_crossings(s, {m_surface.point[m_surface.mesh.source(x)], m_surface.vector[x]},
                               m_surface);
    }
    return count;
  }

  // Whether a place is so far from all edges of T1 that rounding cannot move it across.
  bool is_clear(const Vector& p) const
  {
    const std::int64_t d = refinement / 2;
    return crossings_with_input({p - Vector{d, 1}, {2 * d, 2}}) == 0 &&
           crossings_with_input({p - Vector{1, -d}, {2, -2 * d}}) == 0;
  }

  // Returns the halfedges of T1 that start at a vertex, or contain it, with its position.
  std::vector<On_input> outgoing_halfedges_at(Vertex_index v) const
  {
    std::vector<On_input> result;
    if(m_tri.is_inserted(v)) {
      const auto& [x, offset] = m_on[v];
      if(x.is_valid())
        result = {m_on[v], {m_surface.mesh.opposite(x), offset - m_surface.vector[x]}};
    } else
      for(Halfedge_index x : m_surface.mesh.halfedges())
        if(m_surface.mesh.source(x) == v)
          result.push_back({x, {0, 0}});
    return result;
  }

  // Returns the edge of T1 that contains the edge of `h`, and the position of the source on it.
  std::optional<On_input> on_input(Halfedge_index h) const
  {
    for(const On_input& start : outgoing_halfedges_at(m_tri.mesh().source(h))) {
      const Vector &along = m_surface.vector[start.halfedge], end = start.offset + m_vector[h];
      if(det(along, m_vector[h]) == 0 && dot(along, m_vector[h]) > 0 &&
         dot(along, end) <= dot(along, along))
        return start;
    }
    return {};
  }

  std::int64_t normal_coordinate(Halfedge_index h) const
  {
    if(on_input(h))
      return -1;
    return crossings_with_input({m_point[m_tri.mesh().source(h)], m_vector[h]});
  }

  void check(Edge_index e) const
  {
    const Halfedge_index h = m_tri.mesh().halfedge(e);
    ASSERT_EQ(m_tri.coordinates().normal_coordinate(e), normal_coordinate(h)) << e;
    // A flip in a thin quadrilateral multiplies errors by up to a hundred.
    EXPECT_NEAR(m_tri.length(e) / length(m_vector[h]), 1, 1e-9) << e;
    for(Halfedge_index x : {h, m_tri.mesh().opposite(h)})
      check_roundabout(x);
  }

  void check_roundabout(Halfedge_index h) const
  {
    const Vertex_index v = m_tri.mesh().source(h);
    const auto r = m_tri.coordinates().roundabout(h);
    const auto outgoing_halfedges = outgoing_halfedges_at(v);
    ASSERT_EQ(m_tri.outgoing_halfedges().degree(v), outgoing_halfedges.size());
    ASSERT_LT(r, (std::max)(outgoing_halfedges.size(), std::size_t(1)));
    const auto first = std::min_element(
      outgoing_halfedges.begin(), outgoing_halfedges.end(),
      [&](const On_input& a, const On_input& b) {
        return is_before(m_vector[h], m_surface.vector[a.halfedge], m_surface.vector[b.halfedge]);
      });
    if(first != outgoing_halfedges.end()) {
      ASSERT_EQ(m_tri.outgoing_halfedges().halfedge(v, r), first->halfedge) << h;
    }
  }

  void check_around(Vertex_index m) const
  {
    check_place(m);
    for(Edge_index e : edges_at(m))
      check(e);
  }

  // Checks the stored position of an inserted vertex.
  void check_place(Vertex_index v) const
  {
    if(!m_tri.is_inserted(v))
      return;
    const Halfedge_index along = IT::halfedge_of(m_tri.inserted_vertex(v));
    const Location location = IT::face_location(m_tri.inserted_vertex(v), m_tri.input_mesh());
    const auto& [x, offset] = m_on[v];
    EXPECT_LT(double(flat_distance(location, m_surface.vector, m_surface.point, m_surface.mesh,
                                   m_point[v], m_surface)),
              m_rounding * m_longest);
    ASSERT_EQ(along.is_valid(), x.is_valid());
    if(!along.is_valid())
      return;
    EXPECT_EQ(Edge_index(along), Edge_index(x));
    const Vector& edge = m_surface.vector[x];
    EXPECT_NEAR(m_tri.place_along(x, v), double(dot(edge, offset)) / double(dot(edge, edge)),
                m_rounding * m_longest / length(edge));
  }

public:
  // Returns the distance of a point in a face of a mesh with these vectors from a position, modulo
  // the lattice.
  static Real flat_distance(const Location& location, const std::vector<Vector>& vector,
                            const std::vector<Vector>& point, const Delta_complex& mesh,
                            const Vector& place, const Flat_surface& s)
  {
    const auto side = IT::sides(location.first, mesh);
    const auto real = [](const Vector& v) { return Place{Real(v.x), Real(v.y)}; };
    const Place p = real(point[mesh.source(side[0])] - place) +
                    Real(location.second[1]) * real(vector[side[0]]) -
                    Real(location.second[2]) * real(vector[side[2]]);
    return reduced_norm(p, real(s.a), real(s.b));
  }

  static Real reduced_norm(const Place& p, const Place& a, const Place& b)
  {
    const Real i = std::round(det(p, b) / det(a, b)), j = std::round(det(a, p) / det(a, b));
    return norm(p - i * a - j * b);
  }

private:
  Flat_surface m_surface;
  Triangulation m_tri;
  Inserter m_inserter;
  std::vector<Vector> m_vector; // of each halfedge of T2
  std::vector<Vector> m_point;  // a lift of each vertex of T2
  std::vector<On_input> m_on;   // for each vertex of T2
  double m_rounding;            // relative error of distances on T1
  double m_longest;             // edge of T1
};

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_FLAT_INSERTION_H
