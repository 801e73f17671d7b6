// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_SIDES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_SIDES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Determines on which side of a curve each vertex is.
//
// Consider the function that increases by one from the left of the curve to its right. Such a
// function exists if the curve is a boundary of regions. Along the boundary of a face,
// counterclockwise, it increases by one at the start of a segment, and decreases at its end. So
// only the order of ends along edges counts. The function is computed at one point of each edge,
// between ends of segments, and at vertices.
template <typename FT>
class Curve_sides
{
public:
  // Refers to both arguments.
  Curve_sides(const Delta_complex& mesh, const Surface_curve<FT>& curve)
    : m_mesh(mesh),
      m_at_edge(mesh.num_edges()),
      m_at_vertex(mesh.num_vertices()),
      m_is_on_curve(mesh.num_vertices(), 0)
  {
    for(const Curve_segment<FT>& segment : curve)
      if(segment.source != segment.target) {
        m_segments.emplace_back(segment.face.idx(), &segment);
        note_end(segment.face, segment.source);
        note_end(segment.face, segment.target);
      }
    std::stable_sort(m_segments.begin(), m_segments.end(),
                     [](const auto& s, const auto& t) { return s.first < t.first; });
    std::sort(m_ends_on_edges.begin(), m_ends_on_edges.end());
  }

  // Returns -1 for vertices on the left and 1 for vertices on the right. Returns 0 for vertices on
  // the curve and on components without a curve. Returns nothing if the curve does not separate a
  // component into a left side and a right side. Complexity: linear in the faces, times the
  // logarithm of the number of segments.
  std::optional<std::vector<int>> operator()()
  {
    std::vector<int> result(m_at_vertex.size(), 0);
    for(const Face_index f : m_mesh.faces()) {
      if(m_at_edge[Edge_index(m_mesh.halfedge(f)).idx()])
        continue;
      if(!follow_component(f) || m_greatest - m_least != (m_has_curve ? 1 : 0))
        return std::nullopt;
      if(m_has_curve)
        for(const Vertex_index v : m_vertices)
          result[v.idx()] = *m_at_vertex[v.idx()] == m_least ? -1 : 1;
    }
    return result;
  }

private:
  typedef std::size_t Size;
  typedef std::array<Halfedge_index, 3> Sides;
  typedef std::array<FT, 3> Point;
  typedef std::vector<std::pair<Size, const Curve_segment<FT>*>> Segments_by_face;
  typedef std::pair<typename Segments_by_face::const_iterator,
                    typename Segments_by_face::const_iterator>
    Segments;

  // Stores values of the function around a face, minus its value before the first vertex. Vertices
  // and points of edges have values, and points inside the face beside points of edges. `range`
  // contains the least and the greatest value.
  struct Values
  {
    std::array<int, 3> vertex{0, 0, 0}, edge{0, 0, 0}, inside{0, 0, 0};
    std::array<int, 2> range{0, 0};
    bool exist = true;

    void extend_range(int value)
    {
      range = {(std::min)(range[0], value), (std::max)(range[1], value)};
    }
  };
  // Stores positions on the boundary of a face, in their order, and the increase of the function at
  // each of them.
  typedef std::vector<std::pair<FT, int>> Changes;

  // Points this near to a vertex or a side count as being on it. They differ by rounding only.
  static FT tolerance() { return 16 * rounding_unit<FT>(); }

  static bool is_at_corner(const Point& p, Size k) { return FT(1) - p[k] <= tolerance(); }
  static bool is_on_side(const Point& p, Size k) { return p[(k + 2) % 3] <= tolerance(); }

  // Returns the position of a point on a side, from its source.
  static FT along_side(const Point& p, Size k) { return p[(k + 1) % 3]; }

  // Returns the position on the boundary of a face, counterclockwise from its first corner: the
  // number of the side plus the position on it. Points inside the face have none.
  static std::optional<FT> boundary_position(const Point& p)
  {
    for(Size k = 0; k < 3; ++k)
      if(is_at_corner(p, k))
        return FT(static_cast<double>(k));
    for(Size k = 0; k < 3; ++k)
      if(is_on_side(p, k))
        return FT(static_cast<double>(k)) + along_side(p, k);
    return std::nullopt;
  }

  void note_end(Face_index f, const Point& p)
  {
    const Sides h = sides(f, m_mesh);
    bool is_vertex = false;
    for(Size k = 0; k < 3; ++k)
      if(is_at_corner(p, k)) {
        m_is_on_curve[m_mesh.source(h[k]).idx()] = 1;
        is_vertex = true;
      }
    for(Size k = 0; k < 3; ++k)
      if(!is_vertex && is_on_side(p, k))
        m_ends_on_edges.emplace_back(Edge_index(h[k]).idx(), on_halfedge(h[k], along_side(p, k)));
  }

  // Maps positions on a halfedge to positions on the first halfedge of its edge, and back.
  static FT on_halfedge(Halfedge_index h, const FT& t)
  {
    return is_first_halfedge(h) ? t : FT(1) - t;
  }

  // Returns the position on the first halfedge of `e` at which the function is computed: the
  // midpoint of the longest part without ends.
  FT position(Edge_index e) const
  {
    FT from(0), best(0), longest(0);
    const auto end_part = [&](const FT& to) {
      if(to - from > longest) {
        longest = to - from;
        best = (from + to) / 2;
      }
      from = to;
    };
    for(auto i = std::lower_bound(m_ends_on_edges.begin(), m_ends_on_edges.end(),
                                  std::pair<Size, FT>(e.idx(), FT(0)));
        i != m_ends_on_edges.end() && i->first == e.idx(); ++i)
      end_part(i->second);
    end_part(FT(1));
    return best;
  }

  Values values_around(Face_index f, const Sides& h)
  {
    const auto is_before = [](const auto& s, Size face) { return s.first < face; };
    const Segments segments{
      std::lower_bound(m_segments.begin(), m_segments.end(), Size(f.idx()), is_before),
      std::lower_bound(m_segments.begin(), m_segments.end(), Size(f.idx()) + 1, is_before)};
    Values result;
    if(segments.first == segments.second)
      return result;
    m_has_curve = true;
    const Changes changes = changes_around(segments);
    const auto up_to = [&](const FT& position) {
      int sum = 0;
      for(const auto& [at, change] : changes)
        sum += at < position ? change : 0;
      return sum;
    };
    for(Size k = 0; k < 3; ++k) {
      const FT side(static_cast<double>(k)), t = on_halfedge(h[k], position(Edge_index(h[k])));
      result.vertex[k] = up_to(side);
      result.edge[k] = up_to(side + t);
      result.inside[k] = result.edge[k];
      for(auto i = segments.first; i != segments.second; ++i)
        result.inside[k] -= direction_at(*i->second, k, t);
    }
    const int in_loop = changes.empty() ? value_in_loop(segments) : 0;
    result.extend_range(in_loop);
    extend_range_between(changes, result);
    result.exist = changes.empty() ? in_loop != 0 : up_to(FT(3)) == 0;
    return result;
  }

  static Changes changes_around(const Segments& segments)
  {
    Changes result;
    for(auto i = segments.first; i != segments.second; ++i) {
      if(const auto at = boundary_position(i->second->source))
        result.emplace_back(*at, 1);
      if(const auto at = boundary_position(i->second->target))
        result.emplace_back(*at, -1);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Adds the values between changes to the range. A thin region may contain no vertex, and no point
  // of an edge with a value.
  static void extend_range_between(const Changes& changes, Values& values)
  {
    int value = 0;
    for(Size n = 0; n < changes.size(); ++n) {
      value += changes[n].second;
      const FT next = n + 1 < changes.size() ? changes[n + 1].first : FT(3);
      if(next - changes[n].first > tolerance())
        values.extend_range(value);
    }
  }

  // Returns the value in a loop inside a face, minus the value around it. Returns zero if the
  // segments are not one simple loop, in their order or the reverse order.
  static int value_in_loop(const Segments& segments)
  {
    typedef Exact_predicates_inexact_constructions_kernel Kernel;
    const auto point = [](const Point& p) {
      return Kernel::Point_2(static_cast<double>(p[1]), static_cast<double>(p[2]));
    };
    std::vector<Kernel::Point_2> sources, targets;
    for(auto i = segments.first; i != segments.second; ++i) {
      sources.push_back(point(i->second->source));
      targets.push_back(point(i->second->target));
    }
    const auto follow = [&](const auto& from, const auto& to) {
      for(Size n = 0; n < from.size(); ++n)
        if(squared_distance(to[n], from[(n + 1) % from.size()]) > curve_gap() * curve_gap())
          return false;
      return true;
    };
    const bool is_forward = follow(sources, targets);
    if(sources.size() < 3 || !(is_forward || follow(targets, sources)) ||
       !is_simple_2(sources.begin(), sources.end(), Kernel()))
      return 0;
    const int orientation = orientation_2(sources.begin(), sources.end(), Kernel());
    return is_forward ? -orientation : orientation;
  }

  // Returns 1 if the segment runs along side `k` past the position `t` on it. Returns -1 for the
  // opposite direction, and otherwise 0.
  static int direction_at(const Curve_segment<FT>& segment, Size k, const FT& t)
  {
    if(!is_on_side(segment.source, k) || !is_on_side(segment.target, k))
      return 0;
    const FT from = along_side(segment.source, k), to = along_side(segment.target, k);
    return from < t && t < to ? 1 : to < t && t < from ? -1 : 0;
  }

  // Computes the function on a component, up to a constant. Returns whether it exists.
  bool follow_component(Face_index start)
  {
    const Halfedge_index h = m_mesh.halfedge(start);
    m_vertices.clear();
    m_least = m_greatest = 0;
    m_has_curve = false;
    m_at_edge[Edge_index(h).idx()] = 0;
    m_waiting.assign(1, start);
    if(!m_mesh.is_border(opposite(h)))
      m_waiting.push_back(m_mesh.face(opposite(h)));
    while(!m_waiting.empty()) {
      const Face_index f = m_waiting.back();
      m_waiting.pop_back();
      if(!visit(f))
        return false;
    }
    return true;
  }

  // Computes the function around a face from its value at one of the edges. Returns whether this
  // agrees with the values that are known.
  bool visit(Face_index f)
  {
    const Sides h = sides(f, m_mesh);
    const Values values = values_around(f, h);
    Size known = 0;
    while(!m_at_edge[Edge_index(h[known]).idx()])
      ++known;
    const int base = *m_at_edge[Edge_index(h[known]).idx()] - values.edge[known];
    bool agrees = values.exist;
    for(Size k = 0; k < 3; ++k) {
      const Halfedge_index o = opposite(h[k]);
      const bool is_new = set(m_at_edge[Edge_index(h[k]).idx()], base + values.edge[k], agrees);
      if(is_new && !m_mesh.is_border(o))
        m_waiting.push_back(m_mesh.face(o));
      const Vertex_index v = m_mesh.source(h[k]);
      if(!m_is_on_curve[v.idx()] && set(m_at_vertex[v.idx()], base + values.vertex[k], agrees))
        m_vertices.push_back(v);
      extend_range(base + values.inside[k]);
    }
    for(const int value : values.range)
      extend_range(base + value);
    return agrees;
  }

  // Sets a value unless it is known, and returns whether it was not. Otherwise, `agrees` becomes
  // false if the values differ.
  bool set(std::optional<int>& known, int value, bool& agrees)
  {
    const bool is_new = !known;
    if(is_new)
      known = value;
    agrees = agrees && *known == value;
    extend_range(value);
    return is_new;
  }

  void extend_range(int value)
  {
    m_least = (std::min)(m_least, value);
    m_greatest = (std::max)(m_greatest, value);
  }

  const Delta_complex& m_mesh;
  Segments_by_face m_segments;
  std::vector<std::pair<Size, FT>> m_ends_on_edges; // edges, and positions on first halfedges
  std::vector<std::optional<int>> m_at_edge;        // the function at one point of each edge
  std::vector<std::optional<int>> m_at_vertex;      // the function at vertices off the curve
  std::vector<char> m_is_on_curve;                  // whether a vertex is

  // ---- A component ----

  std::vector<Face_index> m_waiting;
  std::vector<Vertex_index> m_vertices; // off the curve
  int m_least = 0, m_greatest = 0;      // values of the function
  bool m_has_curve = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_CURVE_SIDES_H
