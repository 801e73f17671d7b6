// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/Edge_tracer.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// Where an edge of T1 starts on T2: as curve number `k` in the corner of `spoke`, or along `spoke`.
template <typename Integer>
struct Curve_start
{
  Halfedge_index spoke;
  Integer k;
  bool is_shared;
};

// The first half of Algorithm 1. Complexity: linear in the degree of the source of `h`.
template <typename Traits>
Curve_start<typename Traits::Integer> find_curve(Halfedge_index h,
                                                 const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::Integer Integer;
  const Delta_complex& mesh = tri.mesh();
  const auto& coordinates = tri.coordinates();
  const Vertex_index v = tri.input_mesh().source(h);
  const auto degree = tri.spokes().degree(v), number = tri.spokes().number(v, h);
  Halfedge_index spoke = first_spoke(v, mesh);
  for(;;) {
    const auto r = coordinates.roundabout(spoke);
    const Integer passed(number >= r ? number - r : number + degree - r);
    const bool along = coordinates.is_shared(mesh.edge(spoke));
    if(along && passed == 0)
      return {spoke, Integer(0), true};
    if(passed < coordinates.spokes_from(spoke, mesh))
      return {spoke, passed - Integer(along ? 1 : 0), false};
    spoke = next_spoke(spoke, mesh);
  }
}

// The trace of an edge that both triangulations have.
template <typename FT>
std::vector<Trace_point<FT>> shared_trace(Halfedge_index input, Halfedge_index intrinsic)
{
  return {{{input, FT(0)}, {intrinsic, FT(0)}}, {{input, FT(1)}, {intrinsic, FT(1)}}};
}

// The trace of the even halfedge `h` of T1.
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_even_halfedge(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.mesh();
  const auto start = find_curve(h, tri);
  if(start.is_shared)
    return shared_trace<FT>(h, start.spoke);
  Edge_tracer<Traits> tracer(tri);
  tracer.trace(start.spoke, start.k);
  std::vector<Trace_point<FT>> trace{{{h, FT(0)}, {start.spoke, FT(0)}}};
  for(std::size_t m = 0; m < tracer.size(); ++m) {
    const auto& position = tracer.position(m);
    trace.push_back({{h, position.along_line}, {tracer.crossing(m).halfedge, position.along_edge}});
  }
  const Halfedge_index last = mesh.opposite(tracer.crossing(tracer.size() - 1).halfedge);
  trace.push_back({{h, FT(1)}, {mesh.opposite(mesh.prev(last)), FT(1)}});
  return trace;
}

// Turns a trace into that of the opposite halfedge.
template <typename Traits>
void reverse_trace(std::vector<Trace_point<typename Traits::FT>>& trace,
                   const Intrinsic_triangulation<Traits>& tri)
{
  std::reverse(trace.begin(), trace.end());
  for(auto& p : trace)
    p = {reversed(p.on_input, tri.input_mesh()), reversed(p.on_intrinsic, tri.mesh())};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// traces the halfedge `h` of \f$T_1\f$ over \f$T_2\f$ (Algorithms 1 to 3).
///
/// \returns the points where it meets edges of \f$T_2\f$, from its source to its target, both included;
///   the places on `h` never decrease. At a crossing the halfedge of \f$T_2\f$ is the one through which
///   `h` leaves a face. At the ends it is one that starts or ends at the vertex.
///   The sequence of crossed edges is exact; their places are rounded.
/// Complexity: linear in the crossings, and in the degree of the source in \f$T_2\f$. To trace many edges
/// use `Correspondence`, which is linear in all crossings.
/// \throws Numerical_error if the layout has no positive finite length
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_input_edge(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
{
  const bool is_even = h.idx() % 2 == 0;
  auto trace = internal::trace_even_halfedge(is_even ? h : tri.input_mesh().opposite(h), tri);
  if(!is_even)
    internal::reverse_trace(trace, tri);
  return trace;
}

namespace internal {

// The point where the curve of T1 that is number `number` on the halfedge `h` of T2 crosses it: the
// curve is followed to its end, which tells its edge.
template <typename Traits>
Trace_point<typename Traits::FT> crossing_point(Halfedge_index h,
                                                const typename Traits::Integer& number,
                                                const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Intrinsic_triangulation<Traits>::Coordinates Coordinates;
  const Delta_complex& mesh = tri.mesh();
  const auto& coordinates = tri.coordinates();
  typename Coordinates::Crossing c{h, number};
  std::size_t from_end = 2;
  while(coordinates.advance(c, mesh) != Coordinates::Turn::ends)
    ++from_end;
  const Halfedge_index back = coordinates.spoke_at_end(c, mesh, tri.spokes());
  const auto trace = trace_input_edge(tri.input_mesh().opposite(back), tri);
  return trace[trace.size() - from_end];
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// traces the halfedge `h` of \f$T_2\f$ over \f$T_1\f$.
///
/// \returns the points where it meets edges of \f$T_1\f$, from its source to its target, both included;
///   the places on `h` never decrease. At a crossing the halfedge of \f$T_1\f$ is the one through which
///   `h` leaves a face. At the ends it is one that starts or ends at the vertex.
///   The sequence of crossed edges is exact; their places are rounded.
/// Complexity: linear in the crossings of all the edges of \f$T_1\f$ that `h` crosses, since these are
/// recognised by their ends. To trace many edges use `Correspondence`, which is linear in all crossings.
/// \throws Numerical_error if a layout has no positive finite length
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_intrinsic_edge(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  typedef typename Traits::Integer Integer;
  const auto& coordinates = tri.coordinates();
  const Halfedge_index first = tri.input_spoke_before(h);
  const Halfedge_index last = tri.input_spoke_before(tri.mesh().opposite(h));
  if(coordinates.is_shared(tri.mesh().edge(h)))
    return internal::shared_trace<FT>(first, h);
  std::vector<Trace_point<FT>> trace{{{first, FT(0)}, {h, FT(0)}}};
  for(Integer number(0); number < coordinates.crossings(h); ++number) {
    const auto p = internal::crossing_point(h, number, tri);
    const FT t = (std::max)(p.on_intrinsic.t, trace.back().on_intrinsic.t);
    trace.push_back({reversed(p.on_input, tri.input_mesh()), {h, t}});
  }
  trace.push_back({{tri.input_mesh().opposite(last), FT(1)}, {h, FT(1)}});
  return trace;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H
