// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores where an edge of T1 starts on T2: as curve number `k` in the corner of `outgoing`, or
// along `outgoing` if `k` is -1.
template <typename Integer>
struct Curve_start
{
  Halfedge_index outgoing;
  Integer k;

  bool is_shared() const { return k < 0; }
};

// Stores the positions on a halfedge of T1 of two successive vertices of T2.
template <typename FT>
struct Part_of_edge
{
  FT begin, end;

  FT length(const FT& whole) const { return (end - begin) * whole; }

  // Returns the position on the halfedge at the fraction `t` of the part.
  FT operator()(const FT& t) const { return (std::min)(FT(begin + t * (end - begin)), end); }
};

// Returns the part of the halfedge `h` of T1 from the vertex `v` of T2 to the vertex `w`.
template <typename Traits>
Part_of_edge<typename Traits::FT> part_of_edge(Halfedge_index h, Vertex_index v, Vertex_index w,
                                               const Intrinsic_triangulation<Traits>& tri)
{
  return {tri.place_along(h, v), 1 - tri.place_along(tri.input_mesh().opposite(h), w)};
}

// Returns crossing `m` of a strip. The order along the line is known: rounding may move a crossing,
// but not before the previous one at `least`.
template <typename Traits>
typename Traits::Geodesic_strip::Crossing
crossing_not_before(const typename Traits::FT& least, std::size_t m,
                    const typename Traits::Geodesic_strip& strip)
{
  if constexpr(Has_distance<Traits>::value)
    return strip.crossing(m, least);
  else {
    auto result = strip.crossing(m);
    result.along_line = (std::max)(result.along_line, least);
    return result;
  }
}

// Follows edges of T1 over T2, first through the crossings (Algorithm 2), then along the straight
// line in the strip of triangles (Algorithm 3). One object traces many edges and allocates no
// memory for edges that are no longer than earlier ones.
template <typename Traits>
class Edge_tracer
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef typename Traits::Integer Integer;
  typedef typename Triangulation::Coordinates Coordinates;

public:
  typedef typename Coordinates::Crossing Crossing;

  explicit Edge_tracer(const Triangulation& tri) : m_tri(tri), m_mesh(tri.mesh()) {}

  // Traces curve number `k` of the curves that start in the corner of `outgoing`.
  void trace(Halfedge_index outgoing, const Integer& k)
  {
    m_crossings.clear();
    Crossing c = m_tri.coordinates().first_crossing(outgoing, k, m_mesh);
    do
      m_crossings.push_back(c);
    while(m_tri.coordinates().advance(c, m_mesh) != Coordinates::Turn::ends);
    lay_out_strip_of(m_tri.traits(), m_strip, m_tri, Exits{m_crossings});
    recover_positions();
  }

  std::size_t size() const { return m_crossings.size(); }

  // Returns crossing number `m` of the curve, through which it leaves the face of the halfedge.
  const Crossing& crossing(std::size_t m) const { return m_crossings[m]; }

  // Returns the last halfedge of T2 at or clockwise from the end of the curve.
  Halfedge_index last_outgoing() const
  {
    return m_mesh.opposite(m_mesh.prev(m_mesh.opposite(m_crossings.back().halfedge)));
  }

  // Returns whether the strip is as long as the curve. Rounded lengths of T2 can turn a strip
  // around a vertex that is nearly at the position of another vertex.
  bool has_length([[maybe_unused]] const FT& length) const
  {
    if constexpr(Has_distance<Traits>::value && is_rounded<FT>())
      return CGAL::abs(m_strip.length() - length) <= path_tolerance<FT>() * length;
    else
      return true;
  }

  // Returns the barycentric coordinates of crossing `m` along the curve, which never decrease, and
  // along the halfedge.
  const typename Traits::Geodesic_strip::Crossing& position(std::size_t m) const
  {
    return m_positions[m];
  }

private:
  // Iterates over the halfedges of T2 through which the curve leaves faces.
  struct Exits
  {
    const std::vector<Crossing>& crossings;

    std::size_t size() const { return crossings.size(); }
    Halfedge_index operator[](std::size_t m) const { return crossings[m].halfedge; }
  };

  void recover_positions()
  {
    if(!m_tri.traits().is_length_object()(m_strip.length()))
      throw Numerical_error("the strip of an edge of the input from vertex " +
                            std::to_string(first_vertex().idx()) +
                            " has no positive finite length");
    m_positions.clear();
    for(std::size_t m = 0; m < size(); ++m)
      m_positions.push_back(
        crossing_not_before<Traits>(m == 0 ? FT(0) : m_positions.back().along_line, m, m_strip));
  }

  Vertex_index first_vertex() const
  {
    return m_mesh.target(m_mesh.next(m_crossings.front().halfedge));
  }

  const Triangulation& m_tri;
  const Delta_complex& m_mesh;
  typename Traits::Geodesic_strip m_strip;
  std::vector<Crossing> m_crossings;
  std::vector<typename Traits::Geodesic_strip::Crossing> m_positions;
};

// Stores the positions on T2 at which the parts of the edges of T1 start, along the first halfedges
// of the edges. One part starts at the source, and one at each inserted vertex.
template <typename Traits>
class Part_starts
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;
  typedef Delta_complex::size_type size_type;

public:
  // Numbers the parts, as marks on the edges of T1, and allocates memory for their starts.
  Part_starts(const Triangulation& tri, Edge_marks& numbers)
    : m_tri(tri), m_rank(tri.number_of_inserted_vertices()), m_numbers(numbers)
  {
    numbers = count_parts();
    m_starts.reserve(numbers.size());
  }

  // Allocates the starts. Must be called before `find()`.
  void resize() { m_starts.resize(m_numbers.size()); }

  // Finds the starts. Also stores the last outgoing halfedge at or clockwise from each halfedge of
  // T1 in `outgoing_before`.
  void find(std::vector<Halfedge_index>& outgoing_before, Concurrency concurrency)
  {
    for_each_in_chunks<Halfedge_index>(concurrency, m_tri.mesh(), [&](Halfedge_index h) {
      const Vertex_index v = m_tri.mesh().source(h);
      const auto note = [&](const Integer& k, Halfedge_index start) {
        if(!m_tri.is_inserted(v))
          outgoing_before[start.idx()] = h;
        if(is_first_halfedge(start))
          m_starts[number(Edge_index(start), v)] = {h, k};
      };
      if(m_tri.coordinates().is_shared(m_tri.mesh().edge(h)))
        note(Integer(-1), m_tri.input_halfedge(h));
      m_tri.coordinates().for_each_curve_end(h, m_tri.mesh(), m_tri.outgoing_halfedges(), note);
    });
  }

  // Returns the part of the edge `e` of T1 that starts at the vertex `v` of T2.
  const Curve_start<Integer>& operator()(Edge_index e, Vertex_index v) const
  {
    return m_starts[number(e, v)];
  }

private:
  // Parts of an edge are in the order of the indices of their starts.
  Edge_marks count_parts()
  {
    std::vector<size_type> count(m_tri.input_mesh().num_edges(), 1);
    for(std::size_t i = 0; i < m_rank.size(); ++i) {
      const auto* p = on_edge(m_tri.inserted_vertices()[i]);
      if(p != nullptr)
        m_rank[i] = count[Edge_index(p->halfedge).idx()]++;
    }
    return Edge_marks(std::move(count));
  }

  size_type number(Edge_index e, Vertex_index v) const
  {
    return m_numbers.before(e) +
           (m_tri.is_inserted(v) ? m_rank[v.idx() - m_tri.input_mesh().number_of_vertices()] : 0);
  }

  const Triangulation& m_tri;
  std::vector<size_type> m_rank; // of each inserted vertex on its edge
  const Edge_marks& m_numbers;
  std::vector<Curve_start<Integer>> m_starts;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H
