// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <string>
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
    if constexpr(Has_distance<Traits>::value)
      lay_out_strip(m_strip, m_tri, Exits{m_crossings});
    else
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_TRACER_H
