// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests trace edges of one level over the other.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/trace.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

namespace Test_trace {

using namespace Test_surfaces;
using IS::Trace_end;
using IS::Trace_piece;
using IS::Trace_place;
using Trace = std::vector<Trace_piece>;

// Returns the vertex at an end, which must be at a vertex.
Vertex_index vertex_of(const Trace_piece& piece, std::size_t end, const Delta_complex& mesh)
{
  const Coordinates& b = piece.ends[end].coordinates;
  EXPECT_EQ(piece.ends[end].place, Trace_place::vertex);
  const auto s = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
  EXPECT_EQ(b[s], 1);
  return mesh.source(IT::sides(piece.face, mesh)[s]);
}

// Returns the side of the face that contains an end, and its position on it.
IT::Edge_point<double> edge_point(const Trace_piece& piece, std::size_t end,
                                  const Delta_complex& mesh)
{
  const Coordinates& b = piece.ends[end].coordinates;
  EXPECT_EQ(piece.ends[end].place, Trace_place::edge);
  const auto s = static_cast<std::size_t>(std::min_element(b.begin(), b.end()) - b.begin());
  EXPECT_EQ(b[s], 0);
  return {IT::sides(piece.face, mesh)[(s + 1) % 3], b[(s + 2) % 3]};
}

void expect_meeting(const Trace_piece& piece, const Trace_piece& next, const Delta_complex& mesh)
{
  const Trace_place place = piece.ends[1].place;
  ASSERT_EQ(place, next.ends[0].place);
  EXPECT_EQ(piece.ends[1].t, next.ends[0].t);
  if(place == Trace_place::vertex) {
    EXPECT_EQ(vertex_of(piece, 1, mesh), vertex_of(next, 0, mesh));
  } else if(place == Trace_place::face) {
    EXPECT_EQ(piece.face, next.face);
    EXPECT_EQ(piece.ends[1].coordinates, next.ends[0].coordinates);
  } else if(std::count(piece.ends[1].coordinates.begin(), piece.ends[1].coordinates.end(), 0.) ==
            1) {
    const auto p = edge_point(piece, 1, mesh), q = edge_point(next, 0, mesh);
    EXPECT_EQ(p.halfedge, mesh.opposite(q.halfedge));
    EXPECT_NEAR(p.t, 1 - q.t, 1e-15);
  }
}

// Checks that a trace is a connected curve along the edge, whose pieces never lead from a side to
// itself.
void expect_curve(const Trace& trace, const Delta_complex& mesh)
{
  ASSERT_FALSE(trace.empty());
  EXPECT_EQ(trace.front().ends[0].t, 0);
  EXPECT_EQ(trace.back().ends[1].t, 1);
  for(std::size_t n = 0; n < trace.size(); ++n) {
    const auto& [from, to] = trace[n].ends;
    EXPECT_LE(from.t, to.t);
    if(n + 1 < trace.size())
      expect_meeting(trace[n], trace[n + 1], mesh);
  }
}

Coordinates between(const Trace_piece& piece, double x)
{
  const auto& [from, to] = piece.ends;
  Coordinates result;
  for(std::size_t s = 0; s < 3; ++s)
    result[s] = (1 - x) * from.coordinates[s] + x * to.coordinates[s];
  return result;
}

// Whether a point lies on the edge of h, or near one of its ends, at a place between `low` and
// `high`.
bool is_on_edge(const Location& p, Halfedge_index h, double low, double high,
                const Delta_complex& mesh)
{
  constexpr double tolerance = 1e-9;
  for(Halfedge_index side : IT::sides(p.first, mesh)) {
    const Coordinates b = IT::coordinates_from(side, p, mesh);
    const double t = side == h ? b[1] : b[0];
    if(mesh.edge(side) == mesh.edge(h) && b[2] < tolerance && t > low - tolerance &&
       t < high + tolerance)
      return true;
    if(b[0] > 1 - tolerance && ((mesh.source(side) == mesh.source(h) && low < tolerance) ||
                                (mesh.source(side) == mesh.target(h) && high > 1 - tolerance)))
      return true;
  }
  return false;
}

// Checks that a trace ends at the image of a vertex.
void expect_end(const Trace_piece& piece, std::size_t end, Vertex_index coarse,
                const Surface_map& map)
{
  const Vertex_index v = map.coarse().surface_vertex(coarse);
  if(map.fine().level_vertex(v).is_valid()) {
    EXPECT_EQ(map.fine().surface_vertex(vertex_of(piece, end, map.fine().mesh())), v);
    return;
  }
  const Delta_complex& mesh = map.coarse().mesh();
  const Location p = map.to_fine(location(IT::first_outgoing_halfedge(coarse, mesh), 0, mesh));
  EXPECT_EQ(piece.ends[end].place, mesh.is_border(coarse) ? Trace_place::edge : Trace_place::face);
  expect_same_place(p, {piece.face, piece.ends[end].coordinates}, map.fine().mesh());
}

TEST(Trace, coarse_edges_lie_on_the_fine_surface)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    const Delta_complex &fine = s.fine.mesh(), &coarse = s.coarse.mesh();
    for(Halfedge_index h : coarse.halfedges()) {
      SCOPED_TRACE("halfedge " + std::to_string(h.idx()));
      const Trace trace = IS::trace_coarse_edge(h, map);
      expect_curve(trace, fine);
      expect_end(trace.front(), 0, coarse.source(h), map);
      expect_end(trace.back(), 1, coarse.target(h), map);
      for(const Trace_piece& piece : trace)
        for(const double x : {0., 0.5, 1.}) {
          const double low = piece.ends[x == 1 ? 1 : 0].t, high = piece.ends[x == 0 ? 0 : 1].t;
          EXPECT_TRUE(
            is_on_edge(map.to_coarse({piece.face, between(piece, x)}), h, low, high, coarse));
        }
    }
  });
}

TEST(Trace, fine_edges_lie_on_the_coarse_surface)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    const Delta_complex &fine = s.fine.mesh(), &coarse = s.coarse.mesh();
    for(Halfedge_index h : fine.halfedges()) {
      SCOPED_TRACE("halfedge " + std::to_string(h.idx()));
      const Trace trace = IS::trace_fine_edge(h, map);
      expect_curve(trace, coarse);
      for(const Trace_piece& piece : trace)
        for(const double x : {0., 0.5, 1.}) {
          const double low = piece.ends[x == 1 ? 1 : 0].t, high = piece.ends[x == 0 ? 0 : 1].t;
          EXPECT_TRUE(is_on_edge(map.to_fine({piece.face, between(piece, x)}), h, low, high, fine));
        }
    }
  });
}

// Returns the number of crossings, of vertices between the ends, and of bends.
std::array<std::size_t, 3> counts(const Trace& trace)
{
  std::array<std::size_t, 3> result{};
  for(std::size_t n = 0; n + 1 < trace.size(); ++n) {
    const Trace_place place = trace[n].ends[1].place;
    ++result[place == Trace_place::edge ? 0 : place == Trace_place::vertex ? 1 : 2];
  }
  return result;
}

// Each crossing of a coarse and a fine edge is found by the traces of both.
TEST(Trace, coarse_and_fine_edges_cross_each_other)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    std::size_t of_coarse = 0, of_fine = 0, through_vertices = 0;
    for(Edge_index e : s.coarse.mesh().edges()) {
      const auto found = counts(IS::trace_coarse_edge(s.coarse.mesh().halfedge(e), map));
      of_coarse += found[0];
      through_vertices += found[1];
    }
    for(Edge_index e : s.fine.mesh().edges())
      of_fine += counts(IS::trace_fine_edge(s.fine.mesh().halfedge(e), map))[0];
    EXPECT_TRUE(through_vertices > 0 || of_coarse == of_fine);
  });
}

// Lengths are random: no edge passes through a vertex up to rounding.
TEST(Trace, the_other_way_round_is_the_same)
{
  for_each_random_surface([](const Simplified& s, const Surface_map& map) {
    for(Edge_index e : s.coarse.mesh().edges()) {
      const Halfedge_index h = s.coarse.mesh().halfedge(e);
      const Trace there = IS::trace_coarse_edge(h, map);
      Trace back = IS::trace_coarse_edge(s.coarse.mesh().opposite(h), map);
      std::reverse(back.begin(), back.end());
      ASSERT_EQ(there.size(), back.size());
      for(std::size_t n = 0; n < there.size(); ++n) {
        EXPECT_EQ(there[n].face, back[n].face);
        for(std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(there[n].ends[0].coordinates[c], back[n].ends[1].coordinates[c], 1e-9);
      }
    }
  });
}

// ---- Flips alone: the integer coordinates of the core tell the truth ----

typedef std::tuple<Vertex_index, Vertex_index, std::vector<Edge_index>> Crossed;

TEST(Trace, after_flips_agrees_with_integer_coordinates)
{
  for(const auto& [c, seed] : traced(complexes(), 5)) {
    auto tri = triangulation(c.mesh, random_lengths(c.mesh, seed));
    Evolving_surface surface(tri);
    const Surface_level fine(surface);
    surface.make_Delaunay();
    IT::make_Delaunay(tri);
    const Surface_level coarse(surface);
    const Surface_map map(surface, fine, coarse);
    std::multiset<Crossed> expected, found;
    for(Halfedge_index h : tri.mesh().halfedges()) {
      std::vector<Edge_index> crossed;
      const auto trace = IT::trace_intrinsic_edge(tri, h);
      for(std::size_t n = 1; n + 1 < trace.size(); ++n)
        crossed.push_back(tri.input_mesh().edge(trace[n].on_input.halfedge));
      expected.insert({tri.mesh().source(h), tri.mesh().target(h), crossed});
    }
    for(Halfedge_index h : coarse.mesh().halfedges()) {
      const Trace trace = IS::trace_coarse_edge(h, map);
      std::vector<Edge_index> crossed;
      for(std::size_t n = 0; n + 1 < trace.size(); ++n)
        crossed.push_back(fine.mesh().edge(edge_point(trace[n], 1, fine.mesh()).halfedge));
      found.insert({coarse.mesh().source(h), coarse.mesh().target(h), crossed});
    }
    EXPECT_EQ(expected, found);
  }
}

// ---- Flat surfaces ----

double length(const Trace& trace, const Surface_level& level, const Mesh& mesh)
{
  double sum = 0;
  for(const Trace_piece& piece : trace)
    sum += std::sqrt(
      CGAL::squared_distance(place({piece.face, piece.ends[0].coordinates}, level, mesh),
                             place({piece.face, piece.ends[1].coordinates}, level, mesh)));
  return sum;
}

// No three of the points are on a line, except for points on the boundary.
TEST(Trace, of_a_flat_polygon_is_straight)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map& map) {
    for(Edge_index e : s.coarse.mesh().edges()) {
      const Halfedge_index h = s.coarse.mesh().halfedge(e);
      const Trace trace = IS::trace_coarse_edge(h, map);
      EXPECT_NEAR(length(trace, s.fine, mesh), s.coarse.length_map()[e],
                  1e-9 * s.coarse.length_map()[e]);
      const Point from = mesh.point(s.coarse.surface_vertex(s.coarse.mesh().source(h)));
      const Point to = mesh.point(s.coarse.surface_vertex(s.coarse.mesh().target(h)));
      std::size_t crossings = 0;
      for(Edge_index f : mesh.edges())
        crossings += cross(from, to, mesh.point(mesh.vertex(f, 0)), mesh.point(mesh.vertex(f, 1)));
      EXPECT_EQ(counts(trace)[0], crossings);
      EXPECT_EQ(counts(trace)[1], 0u);
      for(const Trace_piece& piece : trace) {
        const Point there = place({piece.face, piece.ends[1].coordinates}, s.fine, mesh);
        const Point expected = from + piece.ends[1].t * (to - from);
        EXPECT_LT(std::sqrt(CGAL::squared_distance(there, expected)), 1e-8);
      }
    }
  });
}

// A subdivided cube loses all but its corners at no cost.
TEST(Trace, of_a_cube_is_straight)
{
  const Mesh mesh = subdivided(cube(), 3);
  const Simplified s = simplified_by_curvature(Evolving_surface(mesh), 8);
  const Surface_map map(s.surface, s.fine, s.coarse);
  for(Edge_index e : s.coarse.mesh().edges()) {
    const Trace trace = IS::trace_coarse_edge(s.coarse.mesh().halfedge(e), map);
    EXPECT_NEAR(length(trace, s.fine, mesh), s.coarse.length_map()[e], 1e-9);
    EXPECT_EQ(counts(trace)[2], 0u);
  }
}

} // namespace Test_trace
