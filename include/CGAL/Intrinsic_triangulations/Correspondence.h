// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossing_tables.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// all crossings of edges of \f$T_1\f$ with edges of \f$T_2\f$, in order along both, with their
/// positions.
///
/// The roles of the two triangulations are symmetric: every query takes a side. Orders and
/// incidences are exact. Positions are rounded, and never decrease along an edge of either side. On
/// very thin faces, rounded lengths would displace crossings by more than about \f$10^{-8}\f$ of a
/// side. Then positions are computed with more digits from the exact surface of \f$T_1\f$.
///
/// An edge of \f$T_1\f$ consists of one or more parts: vertices that have been inserted on it lie
/// between them. A part is an edge of \f$T_2\f$, or a curve that crosses such edges.
///
/// The object refers to the triangulation and is valid until that changes. Memory: about 40 bytes
/// for each edge and 32 for each crossing (with `double`). Crossings with scales, in other
/// geometries, take 40 bytes. With inserted vertices memory is up to twice as large.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Correspondence : private internal::Crossing_tables<Traits_>
{
  typedef internal::Crossing_tables<Traits_> Base;
  using Base::input_edge, Base::m_contains_inserted, Base::m_courses, Base::m_on_intrinsic,
    Base::m_order_on_input, Base::m_outgoing_before, Base::m_part_numbers, Base::m_parts,
    Base::m_records, Base::m_tri;
  using typename Base::Record;

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
    size_type id;          ///< its index among all crossings
    Edge_point<FT> here;   ///< its position on the halfedge from which it is seen
    Edge_point<FT> across; ///< its position on the halfedge of the other side that leaves the face
                           ///< of the first one
  };

  /// a part of an edge of \f$T_1\f$.
  typedef Edge_part Part;

  /// traces all edges of \f$T_1\f$ over \f$T_2\f$.
  /// Complexity: linear in the vertices, edges and crossings, for any degrees.
  /// \tparam NamedParameters a sequence of named parameters
  /// \param tri the triangulation
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
  ///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  ///                    `CGAL::Parallel_if_available_tag`}
  ///     \cgalParamDefault{`CGAL::Sequential_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Numerical_error if the layout of an edge has no positive finite length
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  /// \pre \f$T_2\f$ has no garbage, see `Intrinsic_triangulation::collect_garbage()`
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Correspondence(const Triangulation& tri,
                          const NamedParameters& np = CGAL::parameters::default_values())
    : Base(tri, concurrency_of(np))
  {}

  Correspondence(Triangulation&&) = delete; // the object refers to the triangulation
  template <typename NamedParameters>
  Correspondence(Triangulation&&, const NamedParameters&) = delete;

  /// returns the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// returns the connectivity of one side.
  const Delta_complex& mesh(Side side) const
  {
    return side == Side::input ? m_tri.input_mesh() : m_tri.mesh();
  }

  /// returns the number of all crossings.
  size_type number_of_crossings() const { return static_cast<size_type>(m_records.size()); }

  /// returns whether the edge `e` of `side` is in the other triangulation too, or for \f$T_2\f$, a
  /// part of one.
  bool is_shared(Side side, Edge_index e) const
  {
    if(side == Side::intrinsic)
      return m_tri.coordinates().is_shared(e);
    return number_of_parts(e) == 1 && part(e, 0).is_shared;
  }

  /// returns the number of parts of the edge `e` of \f$T_1\f$.
  size_type number_of_parts(Edge_index e) const { return Base::number_of_parts(e); }

  /// returns part `i` of the edge `e` of \f$T_1\f$, counted from the source of its first halfedge.
  const Part& part(Edge_index e, size_type i) const { return Base::part(e, i); }

  /// returns the number of pieces into which crossings cut the parts that are not shared.
  size_type number_of_input_pieces() const
  {
    return m_parts.empty() ? 0 : Base::end_of_pieces(m_parts.back());
  }

  /// returns the piece that ends at crossing `id` in the direction of `h`, a halfedge of the edge
  /// of \f$T_1\f$. The piece is a halfedge of a mesh in which these pieces are the first edges.
  /// Complexity: logarithmic in the number of parts of the edge.
  Halfedge_index piece_to(size_type id, Halfedge_index h) const
  {
    const size_type before = piece_before(id);
    return oriented_like(h, first_halfedge(Edge_index(is_first_halfedge(h) ? before : before + 1)));
  }

  /// returns the number of crossings on the edge `e` of `side`.
  size_type number_of_crossings(Side side, Edge_index e) const
  {
    return side == Side::intrinsic ? m_on_intrinsic.size(e) : Base::number_of_crossings_on_input(e);
  }

  /// returns crossing `p` on the halfedge `h` of `side`, counted from its source. Complexity:
  /// constant.
  Crossing crossing(Side side, Halfedge_index h, size_type p) const
  {
    if(side == Side::intrinsic)
      return seen_from_intrinsic(h, m_on_intrinsic(h, p));
    const Edge_index e(h);
    const size_type n = number_of_crossings(side, e);
    return seen_from_input(h, m_order_on_input[part(e, 0).first + along_first_halfedge(h, p, n)]);
  }

  /// returns the crossing with index `id`: its positions on the first halfedges of its two edges.
  Trace_point<FT> crossing(size_type id) const
  {
    const Record& record = m_records[id];
    return {{first_halfedge(input_edge(id)), record.s},
            {first_halfedge(record.intrinsic), record.t}};
  }

  /// returns the scale of crossing `id` (see the concept `GeodesicStrip`), the ratio of its vector
  /// on \f$T_1\f$ to that on \f$T_2\f$: 1 in Euclidean geometry.
  FT scale([[maybe_unused]] size_type id) const
  {
    if constexpr(internal::Has_scale<Traits>::value)
      return this->m_scale[id];
    else
      return FT(1);
  }

  /// returns the indices of the crossings on the edges of \f$T_2\f$.
  const Edge_marks& crossings_on_intrinsic() const { return m_on_intrinsic; }

  /// returns the course of the halfedge `h` of \f$T_2\f$ over \f$T_1\f$. Complexity: constant.
  Edge_course course(Halfedge_index h) const { return m_courses(h); }

  /// \cond SKIP_IN_MANUAL
  // Returns the courses of all halfedges, for functions that read courses of both triangulations.
  const internal::Edge_courses<Traits>& courses() const { return m_courses; }
  /// \endcond

  /// returns whether the face `f` of \f$T_1\f$ contains inserted vertices, inside it or inside its
  /// edges.
  bool contains_inserted(Face_index f) const
  {
    return !m_contains_inserted.empty() && m_contains_inserted[f.idx()];
  }

  /// returns the last outgoing halfedge of the other side at or clockwise from the halfedge `h` of
  /// `side` around its source. It is `h` itself if its edge is shared; otherwise it starts in the
  /// same corner. It is null if the source lies inside a face of the other side.
  Halfedge_index outgoing_before(Side side, Halfedge_index h) const
  {
    if(side == Side::input)
      return m_outgoing_before[h.idx()];
    return m_tri.input_outgoing_before(h);
  }

private:
  Crossing seen_from_intrinsic(Halfedge_index h, size_type id) const
  {
    const Record& r = m_records[id];
    return {id, edge_point(h, r.t),
            edge_point(opposite(oriented_like(h, m_courses.exit(id))), r.s)};
  }

  // Returns the index of the piece that ends at crossing `id` in the direction of the first
  // halfedge of its edge of T1. The next piece starts at the crossing.
  size_type piece_before(size_type id) const
  {
    const Record& r = m_records[id];
    const auto begin = m_parts.begin() + m_part_numbers.before(input_edge(id));
    const auto end = begin + number_of_parts(input_edge(id));
    const auto part =
      std::upper_bound(begin, end, r.order,
                       [](size_type order, const Part& p) { return order < p.first; }) -
      1;
    return part->first_piece + r.order - part->first;
  }

  // The intrinsic edge leaves the face of its exit along its first halfedge.
  Crossing seen_from_input(Halfedge_index h, size_type id) const
  {
    const Record& r = m_records[id];
    const Halfedge_index first = first_halfedge(r.intrinsic);
    return {id, edge_point(h, r.s),
            edge_point(h == m_courses.exit(id) ? first : opposite(first), r.t)};
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
