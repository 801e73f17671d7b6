// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_MEASURING_H
#define INTRINSIC_TRIANGULATIONS_TEST_MEASURING_H

#include "more_generators.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>

// This file computes lengths and areas in flat faces, from the edge lengths again.
namespace Test_surfaces {

using Correspondence = IT::Correspondence<>;
using IT::Side;
using Edge_place = IT::Edge_point<double>;
using Trace_place = IT::Trace_point<double>;
using Real = long double;

constexpr std::array<Side, 2> both_sides{Side::input, Side::intrinsic};

inline Side other(Side side) { return side == Side::input ? Side::intrinsic : Side::input; }

template <typename Any_subdivision>
std::vector<Halfedge_index> sides_of(Face_index f, const Any_subdivision& s)
{
  std::vector<Halfedge_index> result;
  Halfedge_index h = s.mesh().halfedge(f);
  do {
    result.push_back(h);
    h = s.mesh().next(h);
  } while(h != s.mesh().halfedge(f));
  return result;
}

struct Place // in the plane
{
  Real x, y;

  friend Place operator+(const Place& p, const Place& q) { return {p.x + q.x, p.y + q.y}; }
  friend Place operator-(const Place& p, const Place& q) { return {p.x - q.x, p.y - q.y}; }
  friend Place operator*(Real s, const Place& p) { return {s * p.x, s * p.y}; }
  friend Real det(const Place& p, const Place& q) { return p.x * q.y - p.y * q.x; }
  friend Real norm(const Place& p) { return std::hypot(p.x, p.y); }
};

// Represents one of the two triangulations, each face laid out separately in the plane.
class Flat_faces
{
public:
  Flat_faces(Side side, const Triangulation& t)
    : m_triangulation(t),
      m_mesh(side == Side::input ? t.input_mesh() : t.mesh()),
      m_length(side == Side::input ? t.input_length_map() : t.length_map())
  {}

  const Triangulation& triangulation() const { return m_triangulation; }
  const Delta_complex& mesh() const { return m_mesh; }
  Real length(Halfedge_index h) const { return m_length[m_mesh.edge(h)]; }

  Real longest_edge() const
  {
    Real result = 0;
    for(Edge_index e : m_mesh.edges())
      result = (std::max)(result, Real(m_length[e]));
    return result;
  }

  std::array<Halfedge_index, 3> sides(Face_index f) const
  {
    const Halfedge_index h = m_mesh.halfedge(f);
    return {h, m_mesh.next(h), m_mesh.next(m_mesh.next(h))};
  }

  // Returns the position of a point on a halfedge, in the face of the halfedge.
  Location on(Halfedge_index h, double t) const
  {
    Location result{m_mesh.face(h), {0, 0, 0}};
    const auto s = number(h);
    result.second[s] = 1 - t;
    result.second[(s + 1) % 3] = t;
    return result;
  }

  // Returns the corner opposite to a halfedge.
  Location apex(Halfedge_index h) const { return on(m_mesh.prev(h), 0); }

  // Places the source and the target of `h` on the x-axis, and the apex above.
  std::array<Place, 3> layout(Halfedge_index h) const
  {
    const Real c = length(h), a = length(m_mesh.next(h)), b = length(m_mesh.prev(h));
    return {Place{0, 0}, Place{c, 0},
            Place{(c * c + (b - a) * (b + a)) / (2 * c), 2 * area(m_mesh.face(h)) / c}};
  }

  // Returns the position of `p` in layout(h).
  Place place(Halfedge_index h, const Location& p) const
  {
    const auto corner = layout(h);
    const auto s = number(h);
    Place result{0, 0};
    for(std::size_t k = 0; k < 3; ++k)
      result = result + p.second[(s + k) % 3] * corner[k];
    return result;
  }

  Real area(Face_index f) const
  {
    const auto [a, b, c] = sides(f);
    return area_of_triangle({length(a), length(b), length(c)});
  }

  Real area() const
  {
    Real sum = 0;
    for(Face_index f : m_mesh.faces())
      sum += area(f);
    return sum;
  }

  // Returns the angle from `h` to the next outgoing halfedge at its source.
  Real angle(Halfedge_index h) const
  {
    const Place apex = layout(h)[2];
    return std::atan2(apex.y, apex.x);
  }

  // Returns the distance between points of one face (Equation 3.7).
  Real distance(const Location& p, const Location& q) const
  {
    std::array<Real, 3> w;
    for(std::size_t s = 0; s < 3; ++s)
      w[s] = Real(q.second[s]) - p.second[s];
    Real sum = 0;
    for(std::size_t s = 0; s < 3; ++s)
      sum -= length(sides(p.first)[s]) * length(sides(p.first)[s]) * w[s] * w[(s + 1) % 3];
    return std::sqrt((std::max)(Real(0), sum));
  }

  // Returns the length of a path between points of one face or of neighbors, or infinity if none
  // exists.
  Real path(const Location& p, const Location& q) const
  {
    Real best = p.first == q.first ? distance(p, q) : std::numeric_limits<Real>::infinity();
    for(Halfedge_index g : sides(p.first)) {
      if(m_mesh.face(m_mesh.opposite(g)) == q.first)
        best = (std::min)(best, path_across(g, p, q));
      for(Halfedge_index h : sides(q.first))
        if(m_mesh.source(g) == m_mesh.source(h))
          best = (std::min)(best, distance(p, on(g, 0)) + distance(on(h, 0), q));
    }
    return best;
  }

private:
  std::size_t number(Halfedge_index h) const
  {
    const auto side = sides(m_mesh.face(h));
    return static_cast<std::size_t>(std::find(side.begin(), side.end(), h) - side.begin());
  }

  // Returns the path that crosses the edge on the line between the two positions, or at its nearer
  // end.
  Real path_across(Halfedge_index g, const Location& p, const Location& q) const
  {
    const Halfedge_index o = m_mesh.opposite(g);
    const Place a = place(g, p), c = place(o, q), b{length(g) - c.x, -c.y};
    const Real height = a.y - b.y;
    const Real x = height > 0 ? a.x + (b.x - a.x) * (a.y / height) : a.x;
    const Place via{std::clamp(x, Real(0), length(g)), 0};
    return norm(a - via) + norm(b - via);
  }

  const Triangulation& m_triangulation;
  const Delta_complex& m_mesh;
  const Triangulation::Edge_length_map& m_length;
};

// ---- Traces ----

inline Edge_place on(Side side, const Trace_place& p)
{
  return side == Side::input ? p.on_input : p.on_intrinsic;
}

// Returns both ends of piece `k` of a trace over `faces`, in its face.
inline std::pair<Location, Location> piece(const std::vector<Edge_place>& points, std::size_t k,
                                           const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Halfedge_index from = points[k].halfedge, to = points[k + 1].halfedge;
  if(points.size() == 2) {
    const bool is_border = mesh.is_border(from);
    const Halfedge_index h = is_border ? mesh.opposite(from) : from;
    return {faces.on(h, is_border), faces.on(h, !is_border)};
  }
  const Halfedge_index entry = mesh.opposite(from);
  return {k == 0 ? faces.apex(to) : faces.on(entry, 1 - points[k].t),
          k + 2 == points.size() ? faces.apex(entry) : faces.on(to, points[k + 1].t)};
}

// Returns the lengths of the pieces of a trace of `side`, in the faces of the other side.
inline std::vector<Real> lengths_of_pieces(Side side, const std::vector<Trace_place>& trace,
                                           const Triangulation& t)
{
  const Flat_faces faces(other(side), t);
  std::vector<Edge_place> points;
  for(const Trace_place& p : trace)
    points.push_back(on(other(side), p));
  std::vector<Real> result;
  for(std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto [from, to] = piece(points, k, faces);
    result.push_back(faces.distance(from, to));
  }
  return result;
}

// ---- Faces of the common subdivision ----

// Returns the possible positions of a vertex of the subdivision in a face, which are several if the
// face meets itself.
template <typename Subdivision>
std::vector<Location> places_in(Side side, Face_index parent, Vertex_index v, const Subdivision& s,
                                const Flat_faces& faces)
{
  const auto p = s.place(side, v);
  if(const auto* inside = std::get_if<Location>(&p))
    return inside->first == parent ? std::vector<Location>{*inside} : std::vector<Location>();
  std::vector<Location> result;
  for(Halfedge_index h : faces.sides(parent))
    if(s.is_vertex(side, v)) {
      if(faces.mesh().source(h) == v)
        result.push_back(faces.on(h, 0));
    } else if(const auto* e = IT::on_edge(p); e && Edge_index(h) == Edge_index(e->halfedge))
      result.push_back(faces.on(h, e->weight[e->halfedge == h ? 1 : 0]));
  return result;
}

using Polygon = std::vector<Place>;

inline Real area(const Polygon& p)
{
  Real sum = 0;
  for(std::size_t k = 0; k < p.size(); ++k)
    sum += det(p[k], p[(k + 1) % p.size()]) / 2;
  return sum;
}

// Returns the corners of a face in the layout of its parent, or none if the parent meets itself.
template <typename Subdivision>
Polygon layout(Side side, Face_index f, const Subdivision& s, const Flat_faces& faces)
{
  const Face_index parent = s.parent_face(side, f);
  Polygon result;
  for(Halfedge_index h : halfedges_around_face(s.mesh().halfedge(f), s.mesh())) {
    const auto places = places_in(side, parent, s.mesh().target(h), s, faces);
    if(places.size() != 1)
      return {};
    result.push_back(faces.place(faces.sides(parent)[0], places[0]));
  }
  return result;
}

// Returns the sum of the areas of all faces that can be laid out, and of those parts whose
// orientation is wrong; both relative to the area of T1.
template <typename Subdivision>
std::pair<double, double> relative_areas(Side side, const Subdivision& s, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  Real sum = 0, wrong = 0;
  for(Face_index f : s.mesh().faces()) {
    const Real a = area(layout(side, f, s, faces));
    sum += a;
    wrong += (std::min)(a, Real(0));
  }
  const Real whole = Flat_faces(Side::input, t).area();
  return {static_cast<double>(sum / whole), static_cast<double>(wrong / whole)};
}

// ---- Delaunay triangulations ----

// Returns the error of an angle. Lengths with a relative error u change the cosine of an angle by
// at most 4 u (a^2 + b^2 + c^2) / 2bc. Moreover, |acos(x) - acos(y)| <= pi sqrt(|x - y| / 2), with
// equality only between flat angles. make_Delaunay decides for lengths up to u = 16 epsilon.
inline double error_of_angle_at(Halfedge_index h, const Triangulation& t)
{
  const double a = t.length(t.mesh().edge(t.mesh().next(h))), b = t.length(t.mesh().edge(h)),
               c = t.length(t.mesh().edge(t.mesh().prev(h)));
  const double u = 16 * std::numeric_limits<double>::epsilon();
  return pi * std::sqrt(u * (a * a + b * b + c * c) / (b * c));
}

inline void expect_Delaunay(const Triangulation& t)
{
  const Delta_complex& mesh = t.mesh();
  EXPECT_TRUE(IT::is_Delaunay(t));
  for(Edge_index e : mesh.edges()) {
    if(mesh.is_border(e) || t.is_constrained(e))
      continue;
    const Halfedge_index h = mesh.prev(mesh.halfedge(e, 0)), o = mesh.prev(mesh.halfedge(e, 1));
    EXPECT_LE(angle_at(h, mesh, t.length_map()) + angle_at(o, mesh, t.length_map()),
              pi + error_of_angle_at(h, t) + error_of_angle_at(o, t))
      << e;
  }
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_MEASURING_H
