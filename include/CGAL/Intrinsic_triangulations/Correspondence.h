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
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossing_encloser.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_tracer.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Part_starts.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/crossing_scale.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/face_heights.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// all crossings of edges of \f$T_1\f$ with edges of \f$T_2\f$, in order along both, with their
/// places.
///
/// The roles of the two triangulations are symmetric: every query takes the side on which it is
/// asked. Orders and incidences are exact. Places are rounded, but never out of order: along every
/// edge of either side they do not decrease. At faces that are so thin that rounded lengths would
/// displace crossings by more than about \f$10^{-8}\f$ of a side, places are computed with more
/// digits from the exact surface of \f$T_1\f$.
///
/// An edge of \f$T_1\f$ consists of one or more parts: vertices that have been inserted on it lie
/// between them. A part is an edge of \f$T_2\f$, or a curve that crosses such edges.
///
/// The object refers to the triangulation and is valid until that changes.
/// Memory: about 40 bytes for each edge and 32 for each crossing (with `double`), 40 in a geometry
/// where crossings have scales, and up to twice as many where vertices have been inserted.
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
    size_type id;          ///< its index among all crossings
    Edge_point<FT> here;   ///< its place on the halfedge from which it is seen
    Edge_point<FT> across; ///< its place on the halfedge of the other side that leaves the face of
                           ///< the first one there
  };

  /// a part of an edge of \f$T_1\f$.
  struct Part
  {
    size_type first;       ///< the number of crossings on all parts before it
    size_type count;       ///< the number of its crossings
    size_type first_piece; ///< the number of pieces into which crossings cut all parts before it; a
                           ///< shared part counts none
    bool is_shared;        ///< whether it is an edge of \f$T_2\f$
    Vertex_index end;      ///< the vertex of \f$T_2\f$ at its end
  };

  /// traces all edges of \f$T_1\f$ over \f$T_2\f$.
  /// Complexity: linear in the vertices, edges and crossings, whatever the degrees.
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
    : Correspondence(tri, concurrency_of(np))
  {}

  Correspondence(Triangulation&&) = delete; // it would refer to what is gone
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
  size_type number_of_parts(Edge_index e) const { return m_part_numbers.size(e); }

  /// part `i` of the edge `e` of \f$T_1\f$, counted from the source of its first halfedge.
  const Part& part(Edge_index e, size_type i) const
  {
    return m_parts[m_part_numbers.before(e) + i];
  }

  /// returns the number of pieces into which crossings cut the parts that are not shared.
  size_type number_of_input_pieces() const
  {
    return m_parts.empty() ? 0 : end_of_pieces(m_parts.back());
  }

  /// returns the piece that ends at crossing `id` in the direction of `h`, a halfedge of the edge
  /// of \f$T_1\f$ there, as a halfedge of a mesh in which these pieces are the first edges.
  /// Complexity: logarithmic in the number of parts of the edge.
  Halfedge_index piece_to(size_type id, Halfedge_index h) const
  {
    const size_type before = piece_before(id);
    return oriented_like(h, first_halfedge(Edge_index(is_first_halfedge(h) ? before : before + 1)));
  }

  /// returns the number of crossings on the edge `e` of `side`.
  size_type number_of_crossings(Side side, Edge_index e) const
  {
    if(side == Side::intrinsic)
      return m_on_intrinsic.size(e);
    const Part& last = part(e, number_of_parts(e) - 1);
    return last.first + last.count - part(e, 0).first;
  }

  /// crossing `p` on the halfedge `h` of `side`, counted from its source. Complexity: constant.
  Crossing crossing(Side side, Halfedge_index h, size_type p) const
  {
    if(side == Side::intrinsic)
      return seen_from_intrinsic(h, m_on_intrinsic(h, p));
    const Edge_index e(h);
    const size_type n = number_of_crossings(side, e);
    return seen_from_input(h, m_order_on_input[part(e, 0).first + along_first_halfedge(h, p, n)]);
  }

  /// returns the crossing with index `id`: its places on the first halfedges of its two edges.
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
      return m_scale[id];
    else
      return FT(1);
  }

  /// returns how many crossings come before crossing `id` on the first halfedge of its edge of
  /// \f$T_1\f$.
  size_type rank_on_input(size_type id) const
  {
    return m_records[id].order - part(input_edge(id), 0).first;
  }

  /// returns the indices of the crossings on the edges of \f$T_2\f$.
  const Edge_marks& crossings_on_intrinsic() const { return m_on_intrinsic; }

  /// returns the course of the halfedge `h` of \f$T_2\f$ over \f$T_1\f$. Complexity: constant.
  Edge_course course(Halfedge_index h) const { return m_courses(h); }

  /// returns the courses of all halfedges of \f$T_2\f$.
  const internal::Edge_courses<Traits>& courses() const { return m_courses; }

  /// returns whether the face `f` of \f$T_1\f$ contains inserted vertices, inside it or inside its
  /// edges.
  bool contains_inserted(Face_index f) const
  {
    return !m_contains_inserted.empty() && m_contains_inserted[f.idx()];
  }

  /// returns the halfedge of the other side that is the last outgoing halfedge at or clockwise from
  /// the halfedge `h` of `side` around its source: `h` itself if its edge is shared, otherwise it
  /// starts in the same corner. Null if the source lies inside a face of the other side.
  Halfedge_index outgoing_before(Side side, Halfedge_index h) const
  {
    if(side == Side::input)
      return m_outgoing_before[h.idx()];
    return m_tri.input_outgoing_before(h);
  }

private:
  Correspondence(const Triangulation& tri, Concurrency concurrency) : m_tri(tri), m_courses(tri)
  {
    CGAL_precondition(!tri.mesh().has_garbage());
    internal::Part_starts<Traits> starts(tri, m_part_numbers);
    m_on_intrinsic = internal::number_crossings(tri.coordinates(), tri.mesh(), concurrency);
    resize(starts, concurrency);
    starts.find(m_outgoing_before, concurrency);
    trace_all(starts, concurrency);
    note_inserted();
  }

  void resize(internal::Part_starts<Traits>& starts, Concurrency concurrency)
  {
    const size_type crossings = m_on_intrinsic.size();
    m_outgoing_before.reserve(m_tri.input_mesh().num_halfedges());
    run_together(
      concurrency,
      [&] {
        starts.resize();
        m_outgoing_before.resize(m_tri.input_mesh().num_halfedges());
      },
      [&] {
        m_parts.resize(m_part_numbers.size());
        m_records.resize(crossings);
        m_courses = internal::Edge_courses<Traits>(m_tri, m_on_intrinsic);
        m_order_on_input.resize(crossings);
        m_scale.resize(internal::Has_scale<Traits>::value ? crossings : 0);
      });
  }

  struct Record
  {
    Edge_index intrinsic;
    size_type order; // among all crossings, along the first halfedges of the input edges
    FT s, t;         // along the first halfedges of the input edge and the intrinsic edge
  };

  Edge_index input_edge(size_type id) const { return Edge_index(m_courses.exit(id)); }

  Crossing seen_from_intrinsic(Halfedge_index h, size_type id) const
  {
    const Record& r = m_records[id];
    return {id, edge_point(h, r.t),
            edge_point(opposite(oriented_like(h, m_courses.exit(id))), r.s)};
  }

  // the index of the piece that ends at crossing `id` in the direction of the first halfedge of
  // its edge of T1; the next one starts there
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

  void note_inserted()
  {
    const Delta_complex& input = m_tri.input_mesh();
    if(m_tri.number_of_inserted_vertices() > 0)
      m_contains_inserted.assign(input.num_faces(), false);
    for(const Surface_point<FT>& p : m_tri.inserted_vertices())
      internal::for_each_location(
        p, input, [this](const auto& q) { m_contains_inserted[q.first.idx()] = true; });
  }

  static size_type end_of_pieces(const Part& part)
  {
    return part.first_piece + (part.is_shared ? 0 : part.count + 1);
  }

  // What a chunk of edges of T1 crosses, in order, and how many pieces that makes.
  struct Chunk
  {
    std::vector<size_type> crossings;
    size_type pieces = 0;
  };

  // Every curve is met at both its ends; it is traced along the first halfedge of its edge.
  void trace_all(const internal::Part_starts<Traits>& starts, Concurrency concurrency)
  {
    const std::size_t edges = m_tri.input_mesh().num_edges();
    std::vector<Chunk> chunks(number_of_chunks(edges));
    if constexpr(can_be_doubtful())
      if(m_on_intrinsic.size() > 0)
        note_heights(concurrency);
    for_each_chunk(concurrency, edges, [&](std::size_t begin, std::size_t end) {
      internal::Edge_tracer<Traits> tracer(m_tri);
      for(std::size_t e = begin; e < end; ++e)
        trace(Edge_index(static_cast<size_type>(e)), starts, tracer, chunks[begin / chunk_size]);
    });
    number_along_input(chunks, concurrency);
    settle_places(concurrency);
    m_doubt = Doubt();
  }

  // ---- Thin faces ----

  // What tells where rounded lengths do not determine places.
  struct Doubt
  {
    std::vector<float> input_heights, heights; // of faces, empty if all places are certain
    std::vector<char> is_doubtful;             // for each crossing
  };

  static constexpr bool can_be_doubtful()
  {
    return internal::has_metric<Traits>() && internal::is_rounded<FT>();
  }

  void note_heights(Concurrency concurrency)
  {
    Doubt& doubt = m_doubt;
    doubt.input_heights = internal::face_heights(m_tri.input(), concurrency);
    doubt.heights = internal::face_heights(m_tri.intrinsic(), concurrency);
    const auto least = [](const std::vector<float>& x) {
      return x.empty() ? 1 : *std::min_element(x.begin(), x.end());
    };
    if(is_doubtful(least(doubt.input_heights), least(doubt.heights)))
      doubt.is_doubtful.assign(m_on_intrinsic.size(), false);
    else
      doubt = Doubt();
  }

  static bool is_doubtful(float input_height, float height)
  {
    return !(input_height * height * height >= internal::least_product_of_heights());
  }

  // Notes the crossings of a part of the edge of `input`, of which one or all are doubtful.
  void note_doubt(Halfedge_index input, const internal::Edge_tracer<Traits>& tracer)
  {
    const Delta_complex& mesh = m_tri.mesh();
    float height = 1;
    for(std::size_t m = 0; m < tracer.size(); ++m)
      height = (std::min)(
        height, internal::height_around(tracer.crossing(m).halfedge, mesh, m_doubt.heights));
    if(!is_doubtful(internal::height_around(input, m_tri.input_mesh(), m_doubt.input_heights),
                    height))
      return;
    for(std::size_t m = 0; m < tracer.size(); ++m) {
      const auto& c = tracer.crossing(m);
      m_doubt.is_doubtful[m_on_intrinsic(c.halfedge, static_cast<size_type>(c.number))] = true;
    }
  }

  // Finds the places of crossings on edges of T2 where one is doubtful on the exact surface. Where
  // edges run along each other, they stay: any common place is right.
  void enclose_doubtful(Concurrency concurrency)
  {
    if(m_doubt.is_doubtful.empty())
      return;
    const std::size_t edges = m_tri.mesh().num_edges();
    for_each_chunk(concurrency, edges, [&](std::size_t begin, std::size_t end) {
      internal::Crossing_encloser<Traits> enclosed(m_tri, m_courses);
      for(std::size_t i = begin; i < end; ++i)
        if(const Edge_index e(static_cast<size_type>(i)); has_doubtful(e))
          set_places(e,
                     enclosed.with_digits_that_help(first_halfedge(e), internal::crossing_width()));
    });
  }

  bool has_doubtful(Edge_index e) const
  {
    const auto begin = m_doubt.is_doubtful.begin() + m_on_intrinsic.before(e),
               end = begin + m_on_intrinsic.size(e);
    return std::find(begin, end, true) != end;
  }

  void set_places(Edge_index e, const std::vector<Trace_point<Interval_nt<>>>& places)
  {
    const auto middle = [](const Interval_nt<>& x) { return x.inf() + (x.sup() - x.inf()) / 2; };
    for(size_type p = 0; p < m_on_intrinsic.size(e); ++p)
      if(const auto& place = places[p];
         internal::is_narrow(place, internal::greatest_crossing_width())) {
        on_intrinsic(e, p).s = middle(place.on_input.t);
        on_intrinsic(e, p).t = middle(place.on_intrinsic.t);
      }
  }

  // Each part but the first starts where another ends.
  void trace(Edge_index e, const internal::Part_starts<Traits>& starts,
             internal::Edge_tracer<Traits>& tracer, Chunk& chunk)
  {
    const Halfedge_index h = first_halfedge(e);
    Vertex_index v = m_tri.input_mesh().source(h);
    for(size_type i = 0; i < number_of_parts(e); ++i) {
      const auto& start = starts(e, v);
      Part& part = m_parts[m_part_numbers.before(e) + i];
      part = {static_cast<size_type>(chunk.crossings.size()), 0, chunk.pieces, start.is_shared(),
              m_tri.mesh().target(start.outgoing)};
      if(!part.is_shared) {
        tracer.trace(start.outgoing, start.k);
        if(!m_doubt.is_doubtful.empty())
          note_doubt(h, tracer);
        part.end = m_tri.mesh().target(tracer.last_outgoing());
        record(internal::part_of_edge(h, v, part.end, m_tri), h, tracer, chunk);
        part.count = static_cast<size_type>(chunk.crossings.size()) - part.first;
      }
      chunk.pieces = end_of_pieces(part);
      v = part.end;
    }
  }

  void record(const internal::Part_of_edge<FT>& part, Halfedge_index input,
              const internal::Edge_tracer<Traits>& tracer, Chunk& chunk)
  {
    const bool is_certain = tracer.has_length(part.length(m_tri.input_length(Edge_index(input))));
    for(std::size_t m = 0; m < tracer.size(); ++m) {
      const auto& c = tracer.crossing(m);
      const auto& position = tracer.position(m);
      const size_type id = m_on_intrinsic(c.halfedge, static_cast<size_type>(c.number));
      Record& r = m_records[id] = {Edge_index(c.halfedge), 0, unknown(), unknown()};
      m_courses.set(id, c.halfedge, opposite(input));
      if(is_certain) {
        r.s = part(position.along_line);
        r.t = edge_point(c.halfedge, position.along_edge).t;
      }
      if constexpr(internal::Has_scale<Traits>::value)
        m_scale[id] = position.scale;
      chunk.crossings.push_back(id);
    }
  }

  // Numbers crossings and pieces from the first chunk on.
  void number_along_input(const std::vector<Chunk>& chunks, Concurrency concurrency)
  {
    std::vector<size_type> first{0}, first_piece{0};
    for(const Chunk& chunk : chunks) {
      first.push_back(first.back() + static_cast<size_type>(chunk.crossings.size()));
      first_piece.push_back(first_piece.back() + chunk.pieces);
    }
    for_each_chunk(concurrency, m_tri.input_mesh().num_edges(),
                   [&](std::size_t begin, std::size_t end) {
                     const std::size_t c = begin / chunk_size;
                     size_type order = first[c];
                     for(size_type id : chunks[c].crossings) {
                       m_records[id].order = order;
                       m_order_on_input[order++] = id;
                     }
                     const auto parts_before = [this](std::size_t e) {
                       return m_part_numbers.before(Edge_index(static_cast<size_type>(e)));
                     };
                     for(size_type i = parts_before(begin); i < parts_before(end); ++i) {
                       m_parts[i].first += first[c];
                       m_parts[i].first_piece += first_piece[c];
                     }
                   });
  }

  // ---- Order ----

  // the place on an edge of a crossing that is still to be found there
  static FT unknown() { return FT(-1); }

  Record& on_intrinsic(Edge_index e, size_type p)
  {
    return m_records[m_on_intrinsic.before(e) + p];
  }

  // Rounding may move a crossing along an edge, but never past another. At faces without area,
  // edges run along each other: there, what would be moved by more than rounding is moved on both
  // its edges, which ends after few rounds; if not, it is moved on one: no move is beyond 1.
  void settle_places(Concurrency concurrency)
  {
    constexpr bool has_distance = internal::Has_distance<Traits>::value;
    if constexpr(has_distance)
      for_each_disorder(concurrency, [this](Edge_index e) { place_along_intrinsic(e); });
    if constexpr(can_be_doubtful())
      enclose_doubtful(concurrency);
    for(int rounds = has_distance ? 32 : 0;
        !order_along_input(rounds > 0 ? rounding_unit<FT>() : FT(1), concurrency); --rounds)
      if constexpr(has_distance)
        for_each_disorder(concurrency, [this](Edge_index e) { move_along_intrinsic(e); });
    for_each_in_chunks<Edge_index>(concurrency, m_tri.mesh(), [this](Edge_index e) {
      FT t(0);
      for(size_type p = 0; p < m_on_intrinsic.size(e); ++p)
        on_intrinsic(e, p).t = t = (std::max)(on_intrinsic(e, p).t, t);
    });
  }

  // Calls `mend(e)` for the edges of T2 along which crossings are out of order by more than
  // rounding.
  template <typename Function>
  void for_each_disorder(Concurrency concurrency, const Function& mend)
  {
    for_each_in_chunks<Edge_index>(concurrency, m_tri.mesh(), [&](Edge_index e) {
      FT t(0);
      for(size_type p = 0; p < m_on_intrinsic.size(e); ++p) {
        const FT& place = on_intrinsic(e, p).t;
        if(t - place > rounding_unit<FT>())
          return mend(e);
        t = (std::max)(t, place);
      }
    });
  }

  // Returns whether no crossing is moved by more than `tolerance`. Others are to be found again on
  // their edges of T2.
  bool order_along_input(const FT& tolerance, Concurrency concurrency)
  {
    std::atomic<bool> result(true);
    for_each_in_chunks<Edge_index>(concurrency, m_tri.input_mesh(), [&](Edge_index e) {
      FT s(0);
      const size_type first = part(e, 0).first;
      for(size_type p = 0; p < number_of_crossings(Side::input, e); ++p) {
        Record& r = m_records[m_order_on_input[first + p]];
        if(s - r.s > tolerance) {
          r.t = unknown();
          result = false;
        }
        r.s = s = (std::max)(r.s, s);
      }
    });
    return result;
  }

  // Finds crossings in the strip of T1 along `e`: its lengths define the surface, while those of T2
  // are rounded.
  void place_along_intrinsic(Edge_index e)
  {
    FT t(0);
    for_each_in_strip(e, [&](const auto& strip, std::size_t m, Halfedge_index exit, Record& r) {
      const auto position = strip.crossing(m, t);
      r.t = t = position.along_line;
      r.s = edge_point(exit, position.along_edge).t;
    });
  }

  // Finds crossings whose place on `e` is unknown, and moves those that are out of order.
  void move_along_intrinsic(Edge_index e)
  {
    FT t(0);
    for_each_in_strip(e, [&](const auto& strip, std::size_t m, Halfedge_index exit, Record& r) {
      if(r.t < 0)
        r.t = strip.along_line(m, edge_point(exit, r.s).t);
      if(r.t < t) {
        r.t = t;
        r.s = edge_point(exit, strip.along_edge(m, t)).t;
      }
      t = r.t;
    });
  }

  template <typename Function>
  void for_each_in_strip(Edge_index e, const Function& f)
  {
    const Edge_course course = this->course(first_halfedge(e));
    typename Traits::Geodesic_strip strip;
    if(!CGAL::is_finite(m_tri.lay_out(strip, first_halfedge(e), course)))
      throw Numerical_error("the strip of edge " + std::to_string(e.idx()) +
                            " has no finite length");
    for(size_type m = 0; m < course.size(); ++m)
      f(strip, m, course[m], on_intrinsic(e, m));
  }

  const Triangulation& m_tri;
  Doubt m_doubt;             // while places are found
  Edge_marks m_part_numbers; // of the parts of the edges of T1
  std::vector<Part> m_parts;
  std::vector<size_type> m_order_on_input; // crossings along each edge of T1
  std::vector<Halfedge_index> m_outgoing_before;
  std::vector<char> m_contains_inserted; // for each face of T1; empty if there are none
  Edge_marks m_on_intrinsic; // the indices of crossings: they are ordered along the edges of T2
  std::vector<Record> m_records;
  internal::Edge_courses<Traits> m_courses;
  std::vector<FT> m_scale; // of the crossings; empty where all are 1
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
