// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_tracer.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Stores a trace with the scales of its points. A scale is the quotient of the vectors of a point
// on T2 and on T1.
template <typename Traits>
struct Scaled_trace
{
  typedef typename Traits::FT FT;

  void add(const Trace_point<FT>& p, [[maybe_unused]] const FT& scale_of_p = FT(1))
  {
    points.push_back(p);
    if constexpr(Has_scale<Traits>::value)
      scales.push_back(scale_of_p);
  }

  FT scale([[maybe_unused]] std::size_t point) const
  {
    if constexpr(Has_scale<Traits>::value)
      return scales[point];
    else
      return FT(1);
  }

  std::vector<Trace_point<FT>> points;
  std::vector<FT> scales; // empty where all are 1
  bool is_certain = true; // whether strips are as long as the edge
};

// Finds the start of the edge of `h` on T2 at its vertex `v`: the first half of Algorithm 1. The
// loop ends, because the outgoing halfedges around `v` have all numbers. Complexity: linear in the
// degree of `v`.
template <typename Traits>
Curve_start<typename Traits::Integer> find_curve(Halfedge_index h, Vertex_index v,
                                                 const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::Integer Integer;
  const Delta_complex& mesh = tri.mesh();
  const auto& coordinates = tri.coordinates();
  const auto degree = tri.outgoing_halfedges().degree(v),
             number = tri.outgoing_halfedges().number(v, h);
  Halfedge_index outgoing = first_outgoing_halfedge(v, mesh);
  for(;;) {
    const auto r = coordinates.roundabout(outgoing);
    const Integer passed(number >= r ? number - r : number + degree - r);
    const bool along = coordinates.is_shared(mesh.edge(outgoing));
    if(along && passed == 0)
      return {outgoing, Integer(-1)};
    if(passed < coordinates.outgoing_halfedges_from(outgoing, mesh))
      return {outgoing, passed - Integer(along ? 1 : 0)};
    outgoing = next_around_source(outgoing, mesh);
  }
}

// Adds the points on the halfedge `h` of T1, the first of its edge. They lead from the vertex `v`
// on it to the next vertex of T2, which is returned.
template <typename Traits>
Vertex_index trace_part(Halfedge_index h, Vertex_index v, Edge_tracer<Traits>& tracer,
                        const Intrinsic_triangulation<Traits>& tri, Scaled_trace<Traits>& trace)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.mesh();
  const auto start = find_curve(h, v, tri);
  Halfedge_index last = start.outgoing;
  if(trace.points.empty())
    trace.add({{h, FT(0)}, {start.outgoing, FT(0)}});
  if(!start.is_shared()) {
    tracer.trace(start.outgoing, start.k);
    last = tracer.last_outgoing();
  }
  const Part_of_edge<FT> part = part_of_edge(h, v, mesh.target(last), tri);
  if(!start.is_shared()) {
    trace.is_certain &= tracer.has_length(part.length(tri.input_length(Edge_index(h))));
    for(std::size_t m = 0; m < tracer.size(); ++m) {
      const auto& position = tracer.position(m);
      trace.add(
        {{h, part(position.along_line)}, {tracer.crossing(m).halfedge, position.along_edge}},
        scale_of<Traits>(position));
    }
  }
  trace.add({{h, part.end}, {last, FT(1)}});
  return mesh.target(last);
}

// Returns the trace of the halfedge `h` of T1, the first of its edge.
template <typename Traits>
Scaled_trace<Traits> trace_first_halfedge(Halfedge_index h,
                                          const Intrinsic_triangulation<Traits>& tri)
{
  Scaled_trace<Traits> trace;
  Edge_tracer<Traits> tracer(tri);
  Vertex_index v = tri.input_mesh().source(h);
  do
    v = trace_part(h, v, tracer, tri, trace);
  while(tri.is_inserted(v));
  return trace;
}

// Turns a trace into the trace of the opposite halfedge.
template <typename Traits>
void reverse_trace(Scaled_trace<Traits>& trace, const Intrinsic_triangulation<Traits>& tri)
{
  std::reverse(trace.points.begin(), trace.points.end());
  std::reverse(trace.scales.begin(), trace.scales.end());
  for(auto& p : trace.points)
    p = {reversed(p.on_input, tri.input_mesh()), reversed(p.on_intrinsic, tri.mesh())};
}

template <typename Traits>
Scaled_trace<Traits> scaled_input_trace(Halfedge_index h,
                                        const Intrinsic_triangulation<Traits>& tri)
{
  auto trace = trace_first_halfedge(first_halfedge(Edge_index(h)), tri);
  if(!trace.is_certain)
    return {trace_edge(Side::input, h, Correspondence<Traits>(tri)), {}, true};
  if(!is_first_halfedge(h))
    reverse_trace(trace, tri);
  return trace;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// traces the halfedge `h` of \f$T_1\f$ over \f$T_2\f$ (Algorithms 1 to 3). `tri` has both
/// triangulations.
///
/// \returns the points where it meets edges of \f$T_2\f$, from its source to its target, both
///   included. Positions on `h` never decrease. At a crossing the halfedge of \f$T_2\f$ is the
///   halfedge through which `h` leaves a face. At the ends, and at inserted vertices, it starts or
///   ends at the vertex. The sequence of crossed edges is exact; positions are rounded.
///
/// Complexity: linear in the crossings, and in the degree of the source in \f$T_2\f$. If lengths
/// of \f$T_2\f$ are as short as rounding errors, it is the complexity of `Correspondence`. To
/// trace many edges use `Correspondence`, which is linear in all crossings.
/// \throws Numerical_error if the layout has no positive finite length
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_input_edge(const Intrinsic_triangulation<Traits>& tri, Halfedge_index h)
{
  return internal::scaled_input_trace(h, tri).points;
}

namespace internal {

template <typename Traits>
Scaled_trace<Traits> scaled_intrinsic_trace(Halfedge_index h,
                                            const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const Halfedge_index o = tri.mesh().opposite(h);
  Scaled_trace<Traits> trace;
  trace.add({tri.start_on_outgoing(h), {h, FT(0)}});
  const Edge_course course = Edge_courses<Traits>(tri)(h);
  typename Traits::Geodesic_strip strip;
  if(!course.empty())
    tri.lay_out(strip, h, course);
  for(std::size_t m = 0; m < course.size(); ++m) {
    const auto position = crossing_not_before<Traits>(trace.points.back().on_intrinsic.t, m, strip);
    trace.add({{course[m], position.along_edge}, {h, position.along_line}},
              1 / scale_of<Traits>(position));
  }
  trace.add({reversed_if_valid(tri.start_on_outgoing(o), tri.input_mesh()), {h, FT(1)}});
  return trace;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// traces the halfedge `h` of \f$T_2\f$ over \f$T_1\f$. `tri` has both triangulations.
///
/// \returns the points where it meets edges of \f$T_1\f$, from its source to its target, both
///   included. Positions on `h` never decrease. At a crossing the halfedge of \f$T_1\f$ is the
///   halfedge through which `h` leaves a face. At the ends it starts or ends at the vertex, or
///   contains the inserted vertex. It is null if the vertex has been inserted inside a face. The
///   sequence of crossed edges is exact; positions are rounded.
///
/// Complexity: linear in the crossings of all edges of \f$T_1\f$ that `h` crosses, since their
/// ends identify them. To trace many edges use `Correspondence`, which is linear in all crossings.
/// \throws Numerical_error if a layout has no positive finite length
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_intrinsic_edge(const Intrinsic_triangulation<Traits>& tri, Halfedge_index h)
{
  return internal::scaled_intrinsic_trace(h, tri).points;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACE_H
