// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/Edge_tracer.h>
#include <CGAL/Intrinsic_triangulations/internal/Input_crossings.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// all crossings of edges of \f$T_1\f$ with edges of \f$T_2\f$, in order along both, with their places.
///
/// The roles of the two triangulations are symmetric: every query takes the side on which it is asked.
/// Orders and incidences are exact. Places are rounded, but never out of order: along every edge of
/// either side they do not decrease.
///
/// The object refers to the triangulation and is valid until that changes.
/// Memory: 36 bytes for each crossing (with `double`), and 20 for each edge.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Correspondence
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of normal coordinates.
  typedef typename Traits::Integer Integer;
  /// the type of numbers of elements.
  typedef Delta_complex::size_type size_type;

  /// a crossing as seen from a halfedge of one side.
  struct Crossing
  {
    size_type id;          ///< its number among all crossings
    Edge_point<FT> here;   ///< its place on the halfedge from which it is seen
    Edge_point<FT> across; ///< its place on the halfedge of the other side that leaves the face of
                           ///< the first one there
  };

  /// traces all edges of \f$T_1\f$ over \f$T_2\f$.
  /// Complexity: linear in the vertices, edges and crossings, whatever the degrees.
  /// \throws Numerical_error if the layout of an edge has no positive finite length
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  explicit Correspondence(const Triangulation& tri)
    : m_tri(tri),
      m_first_on_input(tri.input_mesh().num_edges(), 0),
      m_count_on_input(tri.input_mesh().num_edges(), 0),
      m_spoke_before(tri.input_mesh().num_halfedges()),
      m_first_on_intrinsic(internal::first_crossings(tri.coordinates(), tri.mesh())),
      m_records(m_first_on_intrinsic.back())
  {
    m_order_on_input.reserve(m_records.size());
    trace_all();
    order_along_intrinsic();
  }

  Correspondence(Triangulation&&) = delete; // it would refer to what is gone

  /// the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// the connectivity of one side.
  const Delta_complex& mesh(Side side) const
  {
    return side == Side::input ? m_tri.input_mesh() : m_tri.mesh();
  }

  /// the number of all crossings.
  size_type number_of_crossings() const { return static_cast<size_type>(m_records.size()); }

  /// whether the edge `e` of `side` is in the other triangulation too.
  bool is_shared(Side side, Edge_index e) const
  {
    return side == Side::input ? m_count_on_input[e] == shared : m_tri.coordinates().is_shared(e);
  }

  /// the number of crossings on the edge `e` of `side`.
  size_type number_of_crossings(Side side, Edge_index e) const
  {
    if(side == Side::intrinsic)
      return m_first_on_intrinsic[e.idx() + 1] - m_first_on_intrinsic[e];
    return is_shared(side, e) ? 0 : m_count_on_input[e];
  }

  /// crossing `p` on the halfedge `h` of `side`, counted from its source. Complexity: constant.
  Crossing crossing(Side side, Halfedge_index h, size_type p) const
  {
    const Edge_index e(h);
    const size_type from_even = is_even(h) ? p : number_of_crossings(side, e) - 1 - p;
    return side == Side::input
             ? seen_from_input(h, m_order_on_input[m_first_on_input[e] + from_even])
             : seen_from_intrinsic(h, m_first_on_intrinsic[e] + from_even);
  }

  /// the crossing with number `id`: its places on the first halfedges of its two edges.
  Trace_point<FT> crossing(size_type id) const
  {
    const Record& record = m_records[id];
    return {{even(record.input), record.s}, {first_halfedge(record.intrinsic), record.t}};
  }

  /// the number of crossing `id` along the edge of \f$T_1\f$ on which it lies, from the source of its
  /// first halfedge.
  size_type rank_on_input(size_type id) const { return m_records[id].rank; }

  /// the halfedge of the other side that is the last spoke at or clockwise from the halfedge `h` of
  /// `side` around its source: `h` itself if its edge is shared, otherwise it starts in the same corner.
  Halfedge_index spoke_before(Side side, Halfedge_index h) const
  {
    if(side == Side::input)
      return m_spoke_before[h.idx()];
    return m_tri.input_spoke_before(h);
  }

private:
  static constexpr size_type shared = (std::numeric_limits<size_type>::max)();

  struct Record
  {
    Halfedge_index input; // leaves the face of the first halfedge of the intrinsic edge
    Edge_index intrinsic;
    size_type rank; // along the first halfedge of the input edge
    FT s, t;        // along the first halfedges of the input edge and the intrinsic edge
  };

  static bool is_even(Halfedge_index h) { return h.idx() % 2 == 0; }
  static Halfedge_index even(Halfedge_index h) { return Halfedge_index(h.idx() & ~size_type(1)); }
  static Halfedge_index twin(Halfedge_index h) { return Halfedge_index(h.idx() ^ 1); }
  // mesh.halfedge(e) is the halfedge that `e` was made from
  static Halfedge_index first_halfedge(Edge_index e) { return Halfedge_index(2 * e.idx()); }
  static Edge_point<FT> on(Halfedge_index h, const FT& t)
  {
    return {h, is_even(h) ? t : FT(1 - t)};
  }

  Crossing seen_from_intrinsic(Halfedge_index h, size_type id) const
  {
    const Record& r = m_records[id];
    return {id, on(h, r.t), on(is_even(h) ? r.input : twin(r.input), r.s)};
  }

  // The intrinsic edge leaves the face of `r.input` from its left to its right, against its first
  // halfedge.
  Crossing seen_from_input(Halfedge_index h, size_type id) const
  {
    const Record& r = m_records[id];
    const Halfedge_index first = first_halfedge(r.intrinsic);
    return {id, on(h, r.s), on(h == r.input ? twin(first) : first, r.t)};
  }

  // Every curve is met at both its ends; it is traced from the source of its first halfedge.
  void trace_all()
  {
    const Delta_complex& mesh = m_tri.mesh();
    const auto& coordinates = m_tri.coordinates();
    for(Halfedge_index h : mesh.halfedges())
      if(coordinates.is_shared(mesh.edge(h)))
        note_shared(h);
    internal::Edge_tracer<Traits> tracer(m_tri);
    coordinates.for_each_curve_end(mesh, m_tri.spokes(),
                                   [&](Halfedge_index h, const Integer& k, Halfedge_index start) {
                                     m_spoke_before[start.idx()] = h;
                                     if(is_even(start)) {
                                       tracer.trace(h, k);
                                       record(start, tracer);
                                     }
                                   });
  }

  void note_shared(Halfedge_index h)
  {
    const Halfedge_index input = m_tri.input_halfedge(h);
    m_spoke_before[input.idx()] = h;
    m_count_on_input[Edge_index(input)] = shared;
  }

  void record(Halfedge_index start, const internal::Edge_tracer<Traits>& tracer)
  {
    const Edge_index e(start);
    m_first_on_input[e] = static_cast<size_type>(m_order_on_input.size());
    m_count_on_input[e] = static_cast<size_type>(tracer.size());
    for(size_type m = 0; m < m_count_on_input[e]; ++m) {
      const auto& c = tracer.crossing(m);
      const auto& position = tracer.position(m);
      const Edge_index crossed(c.halfedge);
      const size_type p = static_cast<size_type>(c.number);
      const bool forward = is_even(c.halfedge);
      const size_type id = forward ? m_first_on_intrinsic[crossed] + p
                                   : m_first_on_intrinsic[crossed.idx() + 1] - 1 - p;
      m_records[id] = {forward ? start : twin(start), crossed, m, position.along_line,
                       on(c.halfedge, position.along_edge).t};
      m_order_on_input.push_back(id);
    }
  }

  // Rounding may move a crossing, but never past another.
  void order_along_intrinsic()
  {
    for(size_type id = 1; id < m_records.size(); ++id)
      if(m_records[id].intrinsic == m_records[id - 1].intrinsic)
        m_records[id].t = (std::max)(m_records[id].t, m_records[id - 1].t);
  }

  const Triangulation& m_tri;
  std::vector<size_type> m_first_on_input; // into m_order_on_input
  std::vector<size_type> m_count_on_input;
  std::vector<size_type> m_order_on_input; // crossings along each edge of T1
  std::vector<Halfedge_index> m_spoke_before;
  std::vector<size_type>
    m_first_on_intrinsic; // into m_records, which are ordered along the edges of T2
  std::vector<Record> m_records;
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// the trace of the halfedge `h` of `side` over the other triangulation, as `trace_input_edge()` and
/// `trace_intrinsic_edge()` give it. Complexity: linear in its crossings.
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_edge(Side side, Halfedge_index h, const Correspondence<Traits>& correspondence)
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  const Side other = side == Side::input ? Side::intrinsic : Side::input;
  const auto point = [side](const Edge_point<FT>& here, const Edge_point<FT>& there) {
    return side == Side::input ? Trace_point<FT>{here, there} : Trace_point<FT>{there, here};
  };
  const Halfedge_index back =
    correspondence.spoke_before(side, correspondence.mesh(side).opposite(h));
  const Edge_index e(h);
  std::vector<Trace_point<FT>> trace;
  trace.reserve(correspondence.number_of_crossings(side, e) + 2);
  trace.push_back(point({h, FT(0)}, {correspondence.spoke_before(side, h), FT(0)}));
  for(size_type p = 0; p < correspondence.number_of_crossings(side, e); ++p) {
    const auto c = correspondence.crossing(side, h, p);
    trace.push_back(point(c.here, reversed(c.across, correspondence.mesh(other))));
  }
  trace.push_back(point({h, FT(1)}, {correspondence.mesh(other).opposite(back), FT(1)}));
  return trace;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
