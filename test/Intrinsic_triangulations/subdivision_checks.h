// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_SUBDIVISION_CHECKS_H
#define INTRINSIC_TRIANGULATIONS_TEST_SUBDIVISION_CHECKS_H

#include "measuring.h"

// Whether a common subdivision is one of both triangulations.
namespace Test_surfaces {

using Subdivision = IT::Common_subdivision<>;
using Barycentric = std::array<double, 3>;

// ---- Numbers ----

inline void check_numbers(const Subdivision& s, const Correspondence& c)
{
  const Triangulation& t = c.triangulation();
  std::int64_t crossings = 0, shared = 0;
  std::int64_t parts = t.input_mesh().number_of_edges(); // of input edges
  for(Edge_index e : t.mesh().edges()) {
    crossings += (std::max<std::int64_t>)(0, t.coordinates().normal_coordinate(e));
    shared += t.coordinates().normal_coordinate(e) == -1;
  }
  for(Vertex_index v : t.mesh().vertices())
    parts += t.is_inserted(v) && IT::on_edge(t.inserted_vertex(v)) != nullptr;
  const auto edges = std::int64_t(t.mesh().number_of_edges());
  EXPECT_TRUE(s.mesh().is_valid(true));
  EXPECT_EQ(std::int64_t(s.mesh().number_of_vertices()),
            std::int64_t(t.mesh().number_of_vertices()) + crossings);
  EXPECT_EQ(std::int64_t(s.mesh().number_of_edges()), edges + parts - shared + 2 * crossings);
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
  EXPECT_EQ(number_of_border_edges(s.mesh()), number_of_border_edges(t.mesh()));
  for(Face_index f : s.mesh().faces()) {
    EXPECT_GE(sides_of(f, s).size(), 3u);
    EXPECT_LE(sides_of(f, s).size(), 6u);
  }
}

// Checks the numbers and the area of the faces on T1, if no face meets itself.
inline void check_areas(const Subdivision& s, const Correspondence& c, double tolerance)
{
  check_numbers(s, c);
  const auto [area, wrong] = relative_areas(Side::input, s, c.triangulation());
  EXPECT_NEAR(area, 1, tolerance);
  EXPECT_GT(wrong, -tolerance);
}

// ---- Edges ----

using Ends = std::multiset<std::pair<Vertex_index, Vertex_index>>;

// Checks that the pieces of every edge are the pieces between the points of its trace.
inline void check_pieces(const Subdivision& s, const Correspondence& c)
{
  const auto n = c.mesh(Side::input).number_of_vertices();
  for(Side side : both_sides) {
    std::vector<Ends> pieces(c.mesh(side).number_of_edges());
    for(Edge_index e : s.mesh().edges())
      if(const Edge_index parent = s.parent_edge(side, e); parent.is_valid())
        pieces[parent].insert(std::minmax({s.mesh().vertex(e, 0), s.mesh().vertex(e, 1)}));
    for(Edge_index e : c.mesh(side).edges()) {
      const Halfedge_index h = c.mesh(side).halfedge(e);
      std::vector<Vertex_index> chain{c.mesh(side).source(h)};
      for(Delta_complex::size_type p = 0; p < c.number_of_crossings(side, e); ++p)
        chain.push_back(Vertex_index(n + c.crossing(side, h, p).id));
      chain.push_back(c.mesh(side).target(h));
      Ends expected;
      for(std::size_t k = 0; k + 1 < chain.size(); ++k)
        expected.insert(std::minmax({chain[k], chain[k + 1]}));
      EXPECT_EQ(pieces[e], expected);
    }
  }
  for(Edge_index e : s.mesh().edges())
    EXPECT_TRUE(s.parent_edge(Side::input, e).is_valid() ||
                s.parent_edge(Side::intrinsic, e).is_valid());
}

// ---- Corners of faces in both parents ----

// Whether the piece from a to b runs along its parent edge, forward, if it has one in the face.
inline bool runs_along(const Barycentric& a, const Barycentric& b, Edge_index parent, Face_index f,
                       const Flat_faces& faces)
{
  if(!parent.is_valid())
    return true;
  for(std::size_t k = 0; k < 3; ++k)
    if(Edge_index(faces.sides(f)[k]) == parent && a[(k + 2) % 3] == 0 && b[(k + 2) % 3] == 0 &&
       a[(k + 1) % 3] <= b[(k + 1) % 3])
      return true;
  return false;
}

// Returns all layouts of the corners of `f` in its parent whose sides are on their parents.
inline std::vector<Polygon> layouts(Side side, Face_index f, const Subdivision& s,
                                    const Flat_faces& faces)
{
  const Face_index parent = s.parent_face(side, f);
  std::vector<std::vector<Barycentric>> partial{{}};
  const auto halfedges = sides_of(f, s);
  for(Halfedge_index h : halfedges) {
    std::vector<std::vector<Barycentric>> longer;
    for(const auto& corners : partial)
      for(const Location& p : places_in(side, parent, s.mesh().target(h), s, faces)) {
        longer.push_back(corners);
        longer.back().push_back(p.second);
      }
    partial = longer;
  }
  std::vector<Polygon> result;
  for(const auto& corners : partial) {
    bool fits = true;
    for(std::size_t k = 0; k < corners.size(); ++k)
      fits =
        fits && runs_along(corners[k], corners[(k + 1) % corners.size()],
                           s.parent_edge(side, s.mesh().edge(halfedges[(k + 1) % corners.size()])),
                           parent, faces);
    if(!fits)
      continue;
    result.emplace_back();
    for(const Barycentric& b : corners)
      result.back().push_back(faces.place(faces.sides(parent)[0], {parent, b}));
  }
  return result;
}

// Returns the greatest difference of the distances of corners.
inline Real difference(const Polygon& p, const Polygon& q)
{
  Real result = 0;
  for(std::size_t a = 0; a < p.size(); ++a)
    for(std::size_t b = 0; b < a; ++b)
      result = (std::max)(result, std::abs(norm(p[a] - p[b]) - norm(q[a] - q[b])));
  return result;
}

struct Measures
{
  std::vector<Real> area_of_input_face, area_of_intrinsic_face;
  std::array<std::vector<Real>, 2> length_of_edge; // of either side, measured on the other
};

// Checks that the face is congruent in both of its parents. Adds its measures.
inline void check_face(Face_index f, const Subdivision& s, const Triangulation& t,
                       Measures& measures)
{
  const Flat_faces input(Side::input, t), intrinsic(Side::intrinsic, t);
  const Real size = (std::max)(input.longest_edge(), intrinsic.longest_edge());
  std::pair<Polygon, Polygon> best;
  Real least = std::numeric_limits<Real>::infinity();
  for(const Polygon& p : layouts(Side::input, f, s, input))
    for(const Polygon& q : layouts(Side::intrinsic, f, s, intrinsic))
      if(difference(p, q) < least) {
        least = difference(p, q);
        best = {p, q};
      }
  ASSERT_LT(static_cast<double>(least / size), 1e-9) << f;
  EXPECT_GT(area(best.first), -1e-12 * size * size) << f;
  EXPECT_GT(area(best.second), -1e-12 * size * size) << f;
  measures.area_of_input_face[s.parent_face(Side::input, f)] += area(best.first);
  measures.area_of_intrinsic_face[s.parent_face(Side::intrinsic, f)] += area(best.second);
  const auto halfedges = sides_of(f, s);
  for(std::size_t k = 0; k < halfedges.size(); ++k) { // corner k is the target of halfedge k
    const std::size_t before = (k + halfedges.size() - 1) % halfedges.size();
    const Edge_index e = s.mesh().edge(halfedges[k]);
    const Real faces = s.mesh().is_border(e) ? 1 : 2;
    const Real on_input = norm(best.first[k] - best.first[before]);
    const Real on_intrinsic = norm(best.second[k] - best.second[before]);
    const Real gap = std::abs(on_input - on_intrinsic);
    if(const Edge_index p = s.parent_edge(Side::input, e); p.is_valid()) {
      measures.length_of_edge[0][p] += on_intrinsic / faces;
      EXPECT_LT(double(gap / t.input_length(p)), 1e-9) << e;
    }
    if(const Edge_index p = s.parent_edge(Side::intrinsic, e); p.is_valid()) {
      measures.length_of_edge[1][p] += on_input / faces;
      EXPECT_LT(double(gap / t.length(p)), 1e-9) << e;
    }
  }
}

inline void check_measures(const Subdivision& s, const Triangulation& t)
{
  const Flat_faces input(Side::input, t), intrinsic(Side::intrinsic, t);
  Measures measures{std::vector<Real>(input.mesh().number_of_faces()),
                    std::vector<Real>(intrinsic.mesh().number_of_faces()),
                    {std::vector<Real>(input.mesh().number_of_edges()),
                     std::vector<Real>(intrinsic.mesh().number_of_edges())}};
  for(Face_index f : s.mesh().faces())
    check_face(f, s, t, measures);
  Real area = 0;
  for(Face_index f : t.input_mesh().faces()) {
    area += measures.area_of_input_face[f];
    EXPECT_NEAR(double(measures.area_of_input_face[f] / input.area(f)), 1, 1e-11);
  }
  for(Face_index f : t.mesh().faces())
    EXPECT_NEAR(double(measures.area_of_intrinsic_face[f] / intrinsic.area(f)), 1, 1e-11);
  EXPECT_NEAR(double(area / input.area()), 1, 1e-12);
  for(Edge_index e : t.input_mesh().edges())
    EXPECT_NEAR(double(measures.length_of_edge[0][e] / t.input_length(e)), 1, 1e-9);
  for(Edge_index e : t.mesh().edges())
    EXPECT_NEAR(double(measures.length_of_edge[1][e] / t.length(e)), 1, 1e-9);
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_SUBDIVISION_CHECKS_H
