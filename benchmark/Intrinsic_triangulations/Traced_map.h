// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_TRACED_MAP_H
#define INTRINSIC_BENCHMARK_TRACED_MAP_H

#include "method.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace Methods {

typedef IT::Face_location<double> Location;

// Stores an edge of T2 as it was traced over T1.
struct Traced_curve
{
  Halfedge_index halfedge;                       // of T2, from the start of the curve
  std::vector<IT::Edge_point<double>> crossings; // where it leaves faces of T1
  Face_index end;                                // the face in which it ends
};

// Checks whether traced curves are the edges of a triangulation with the connectivity of T2, and
// counts the pieces into which they cut T1. T1 has no loops and no parallel edges.
//
// Curves must start and end at the correct vertices. With the order of their crossings along edges
// of T1 and the order of T2 around vertices they define a map. Its faces are found by walking
// around them. Curves that meet, or leave a vertex in the wrong order, make it a map on a surface
// with more handles.
class Traced_map
{
public:
  // `inserted` contains the positions of the vertices that only T2 has, which come after the
  // others.
  Traced_map(const Delta_complex& input, const Delta_complex& mesh,
             std::vector<Location> inserted = {})
    : m_input(input),
      m_mesh(mesh),
      m_inserted(std::move(inserted)),
      m_on_edge(input.num_edges()),
      m_is_shared(input.num_edges(), false),
      m_start(mesh.num_halfedges()),
      m_curve(mesh.num_edges(), none)
  {}

  // Throws Failure if the curve does not lead from vertex to vertex.
  void add(Traced_curve curve)
  {
    const Halfedge_index h = curve.halfedge, back = m_mesh.opposite(h);
    trim(curve);
    const auto& crossings = curve.crossings;
    if(crossings.empty() && !is_inserted(m_mesh.source(h)) && !is_inserted(m_mesh.target(h)))
      return add_shared(h);
    const Face_index face = crossings.empty() ? curve.end : m_input.face(crossings[0].halfedge);
    m_start[h] = {corner(face, m_mesh.source(h)), false};
    m_start[back] = {corner(curve.end, m_mesh.target(h)), false};
    check_continuity(curve);
    const std::size_t c = m_curves.size();
    for(std::size_t k = 0; k < crossings.size(); ++k) {
      const auto& p = crossings[k];
      m_on_edge[m_input.edge(p.halfedge)].push_back({is_first(p.halfedge) ? p.t : 1 - p.t, c, k});
    }
    m_curve[m_mesh.edge(h)] = c;
    m_curves.push_back(std::move(curve));
  }

  // Throws Failure if the curves meet or are in the wrong order.
  Subdivision_size subdivide()
  {
    number_pieces();
    for(Edge_index e : m_input.edges())
      order_crossings(e);
    for(Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        set_rotation(is_inserted(v) ? outgoing_halfedges(v) : outgoing_halfedges_of_both(v));
    std::size_t crossings = 0;
    for(const auto& on_edge : m_on_edge)
      crossings += on_edge.size();
    const Subdivision_size size{m_mesh.number_of_vertices() + crossings, m_before.size() / 2,
                                count_faces()};
    check(size, m_input);
    return size;
  }

private:
  // Numbers a half of a piece of an edge. The two halves of a piece differ in the last bit.
  typedef std::size_t Dart;

  // Stores where a halfedge of T2 leaves a vertex of T1: along the outgoing halfedge, or in the
  // corner after it.
  struct Start
  {
    Halfedge_index outgoing;
    bool is_shared;
  };
  // Stores crossing `k` of a curve, on the first halfedge of its edge.
  struct Crossing
  {
    double t;
    std::size_t curve, k;
  };

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool is_inserted(Vertex_index v) const { return v.idx() >= m_input.num_vertices(); }
  const Location& place(Vertex_index v) const
  {
    return m_inserted[v.idx() - m_input.num_vertices()];
  }
  static bool is_first(Halfedge_index h) { return h.idx() % 2 == 0; }

  // ---- One curve ----

  // Returns the side of `f` that leaves `v`, or null at inserted vertices.
  Halfedge_index corner(Face_index f, Vertex_index v) const
  {
    if(f.is_valid() && is_inserted(v) && place(v).first == f)
      return Halfedge_index();
    if(f.is_valid() && !is_inserted(v))
      for(Halfedge_index h : IT::sides(f, m_input))
        if(m_input.source(h) == v)
          return h;
    throw Failure("a trace does not lead from vertex to vertex");
  }

  // Trims an end that is wrong by some rounding errors. It may be in any face at the correct
  // vertex, or in the face before or after the face of an inserted vertex.
  void trim(Traced_curve& curve) const
  {
    const Vertex_index v = m_mesh.target(curve.halfedge);
    auto& crossings = curve.crossings;
    if(is_inserted(v)) {
      if(curve.end != place(v).first)
        move_end(curve, v);
      return;
    }
    corner(curve.end, v);
    const auto is_at_end = [&](const IT::Edge_point<double>& p) {
      return m_input.source(p.halfedge) == v || m_input.target(p.halfedge) == v;
    };
    while(!crossings.empty() && is_at_end(crossings.back())) {
      curve.end = m_input.face(crossings.back().halfedge);
      crossings.pop_back();
    }
  }

  void move_end(Traced_curve& curve, Vertex_index v) const
  {
    const auto& [f, b] = place(v);
    auto& crossings = curve.crossings;
    if(!crossings.empty() && m_input.face(crossings.back().halfedge) == f)
      crossings.pop_back();
    else {
      const auto side = IT::sides(f, m_input);
      for(std::size_t s = 0; s < 3 && curve.end != f; ++s)
        if(m_input.face(m_input.opposite(side[s])) == curve.end) {
          const double from = b[(s + 1) % 3], to = b[s];
          crossings.push_back({m_input.opposite(side[s]), from + to > 0 ? to / (from + to) : 0.5});
          curve.end = f;
        }
    }
    curve.end = f;
  }

  void add_shared(Halfedge_index h)
  {
    const Halfedge_index shared = m_input.halfedge(m_mesh.source(h), m_mesh.target(h));
    if(!shared.is_valid())
      throw Failure("a trace does not lead from vertex to vertex");
    if(m_is_shared[m_input.edge(shared)])
      throw Failure("two traces coincide");
    m_is_shared[m_input.edge(shared)] = true;
    m_start[h] = {shared, true};
    m_start[m_mesh.opposite(h)] = {m_input.opposite(shared), true};
  }

  void check_continuity(const Traced_curve& curve) const
  {
    const auto& crossings = curve.crossings;
    for(std::size_t k = 0; k < crossings.size(); ++k) {
      const Halfedge_index entry = m_input.opposite(crossings[k].halfedge);
      const bool is_last = k + 1 == crossings.size();
      if(m_input.is_border(entry) ||
         m_input.face(entry) != (is_last ? curve.end : m_input.face(crossings[k + 1].halfedge)) ||
         (!is_last && crossings[k + 1].halfedge == entry))
        throw Failure("a trace runs into a vertex");
    }
  }

  // ---- All curves ----

  // Numbers the pieces; pieces of T1 come first.
  void number_pieces()
  {
    std::size_t number = 0;
    for(const auto& crossings : m_on_edge) {
      m_first_on_edge.push_back(number);
      number += crossings.size() + 1;
    }
    for(const Traced_curve& curve : m_curves) {
      m_first_of_curve.push_back(number);
      number += curve.crossings.size() + 1;
    }
    m_before.assign(2 * number, none);
    m_is_border.assign(2 * number, false);
    for(Edge_index e : m_input.edges())
      for(std::size_t p = 0; p <= m_on_edge[e].size(); ++p)
        for(unsigned side : {0U, 1U})
          m_is_border[2 * (m_first_on_edge[e] + p) + side] =
            m_input.is_border(m_input.halfedge(e, side));
  }

  // Sets the darts that leave a vertex, counterclockwise.
  void set_rotation(const std::vector<Dart>& outgoing_halfedges)
  {
    for(std::size_t i = 0; i < outgoing_halfedges.size(); ++i)
      m_before[outgoing_halfedges[(i + 1) % outgoing_halfedges.size()]] = outgoing_halfedges[i];
  }

  void order_crossings(Edge_index e)
  {
    auto& crossings = m_on_edge[e];
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& p, const Crossing& q) { return p.t < q.t; });
    for(std::size_t i = 0; i < crossings.size(); ++i) {
      const auto& [t, c, k] = crossings[i];
      const Dart before = 2 * (m_first_on_edge[e] + i) + 1, after = before + 1,
                 back = 2 * (m_first_of_curve[c] + k) + 1, on = back + 1;
      // The curve comes from the left of the halfedge that it crosses.
      if(is_first(m_curves[c].crossings[k].halfedge))
        set_rotation({after, back, before, on});
      else
        set_rotation({before, back, after, on});
    }
  }

  Dart dart_of_input(Halfedge_index h) const
  {
    const std::size_t e = m_input.edge(h), first = m_first_on_edge[e];
    return is_first(h) ? 2 * first : 2 * (first + m_on_edge[e].size()) + 1;
  }

  Dart dart(Halfedge_index h) const
  {
    const std::size_t c = m_curve[m_mesh.edge(h)], first = m_first_of_curve[c];
    return m_curves[c].halfedge == h ? 2 * first : 2 * (first + m_curves[c].crossings.size()) + 1;
  }

  std::vector<Dart> outgoing_halfedges(Vertex_index v) const
  {
    std::vector<Dart> result;
    IT::for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) { result.push_back(dart(h)); });
    return result;
  }

  // Returns the outgoing halfedges of T2 in their order, between the outgoing halfedges of T1.
  std::vector<Dart> outgoing_halfedges_of_both(Vertex_index v) const
  {
    std::vector<Halfedge_index> input, intrinsic;
    IT::for_each_outgoing_halfedge(v, m_input, [&](Halfedge_index h) { input.push_back(h); });
    IT::for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) { intrinsic.push_back(h); });
    const auto rank = [&](Halfedge_index h) {
      const auto i = std::find(input.begin(), input.end(), m_start[h].outgoing) - input.begin();
      return 2 * i + (m_start[h].is_shared ? 0 : 1);
    };
    const auto descent =
      std::adjacent_find(intrinsic.begin(), intrinsic.end(),
                         [&](Halfedge_index a, Halfedge_index b) { return rank(a) > rank(b); });
    if(descent != intrinsic.end())
      std::rotate(intrinsic.begin(), descent + 1, intrinsic.end());
    std::vector<Dart> result;
    auto next = intrinsic.begin();
    for(Halfedge_index outgoing : input) {
      result.push_back(dart_of_input(outgoing));
      for(; next != intrinsic.end() && m_start[*next].outgoing == outgoing; ++next)
        if(!m_start[*next].is_shared)
          result.push_back(dart(*next));
    }
    if(next != intrinsic.end())
      throw Failure("traces leave a vertex in the wrong order");
    return result;
  }

  // Walks around all faces, which must have as many sides as convex polygons that lie in a triangle
  // of each triangulation.
  std::size_t count_faces() const
  {
    std::size_t count = 0;
    std::vector<bool> is_seen(m_before.size(), false);
    for(Dart first = 0; first < m_before.size(); ++first) {
      if(is_seen[first])
        continue;
      std::size_t degree = 0;
      for(Dart d = first; !is_seen[d]; d = m_before[d ^ 1]) {
        is_seen[d] = true;
        ++degree;
      }
      if(!m_is_border[first] && (degree < 3 || degree > 6))
        throw Failure("a face is no convex polygon");
      count += m_is_border[first] ? 0 : 1;
    }
    return count;
  }

  const Delta_complex &m_input, &m_mesh;
  std::vector<Location> m_inserted;
  std::vector<Traced_curve> m_curves;
  std::vector<std::vector<Crossing>> m_on_edge; // of T1
  std::vector<bool> m_is_shared;                // edges of T1 that are edges of T2
  std::vector<Start> m_start;                   // of each halfedge of T2
  std::vector<std::size_t> m_curve;             // of each edge of T2; none if it is shared
  std::vector<std::size_t> m_first_on_edge;     // piece of each edge of T1
  std::vector<std::size_t> m_first_of_curve;    // piece of each curve
  std::vector<Dart> m_before;    // for each dart the one before, counterclockwise around its source
  std::vector<bool> m_is_border; // darts along the boundary of T1
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_TRACED_MAP_H
