// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_TABLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_TABLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossing_encloser.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_tracer.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns for each face its least height, relative to its longest side.
template <typename Surface>
std::vector<float> face_heights(const Surface& surface, Concurrency concurrency)
{
  const Delta_complex& mesh = surface.mesh();
  std::vector<float> result(mesh.num_faces());
  for_each_in_chunks<Face_index>(concurrency, mesh, [&](Face_index f) {
    const auto side = side_lengths(mesh.halfedge(f), surface);
    const double a = CGAL::to_double(side[0]), b = CGAL::to_double(side[1]),
                 c = CGAL::to_double(side[2]), longest = (std::max)({a, b, c});
    result[f.idx()] = static_cast<float>(quadrupled_area(a, b, c) / (2 * longest * longest));
  });
  return result;
}

// Returns the least height of the faces at the edge of `h`.
inline float height_around(Halfedge_index h, const Delta_complex& mesh,
                           const std::vector<float>& heights)
{
  float result = 1;
  for(const Halfedge_index x : {h, mesh.opposite(h)})
    if(!mesh.is_border(x))
      result = (std::min)(result, heights[mesh.face(x).idx()]);
  return result;
}

// Stores all crossings of edges of T1 with edges of T2, traced along the edges of T1.
// `Correspondence` answers queries from them.
template <typename Traits>
class Crossing_tables
{
  typedef typename Traits::FT FT;

protected:
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef Delta_complex::size_type size_type;
  typedef Edge_part Part;

  struct Record
  {
    Edge_index intrinsic;
    size_type order; // among all crossings, along the first halfedges of the input edges
    FT s, t;         // along the first halfedges of the input edge and the intrinsic edge
  };

  Crossing_tables(const Triangulation& tri, Concurrency concurrency) : m_tri(tri), m_courses(tri)
  {
    CGAL_precondition(!tri.mesh().has_garbage());
    Part_starts<Traits> starts(tri, m_part_numbers);
    m_on_intrinsic = number_crossings(tri.coordinates(), tri.mesh(), concurrency);
    resize(starts, concurrency);
    starts.find(m_outgoing_before, concurrency);
    trace_all(starts, concurrency);
    note_inserted();
  }

  Edge_index input_edge(size_type id) const { return Edge_index(m_courses.exit(id)); }

  size_type number_of_parts(Edge_index e) const { return m_part_numbers.size(e); }

  const Part& part(Edge_index e, size_type i) const
  {
    return m_parts[m_part_numbers.before(e) + i];
  }

  size_type number_of_crossings_on_input(Edge_index e) const
  {
    const Part& last = part(e, number_of_parts(e) - 1);
    return last.first + last.count - part(e, 0).first;
  }

  static size_type end_of_pieces(const Part& part)
  {
    return part.first_piece + (part.is_shared ? 0 : part.count + 1);
  }

  const Triangulation& m_tri;
  Edge_marks m_part_numbers; // of the parts of the edges of T1
  std::vector<Part> m_parts;
  std::vector<size_type> m_order_on_input; // crossings along each edge of T1
  std::vector<Halfedge_index> m_outgoing_before;
  std::vector<char> m_contains_inserted; // for each face of T1; empty if there are none
  Edge_marks m_on_intrinsic; // the indices of crossings: they are ordered along the edges of T2
  std::vector<Record> m_records;
  Edge_courses<Traits> m_courses;
  std::vector<FT> m_scale; // of the crossings; empty if all are 1

private:
  void note_inserted()
  {
    const Delta_complex& input = m_tri.input_mesh();
    if(m_tri.number_of_inserted_vertices() > 0)
      m_contains_inserted.assign(input.num_faces(), false);
    for(const Surface_point<FT>& p : m_tri.inserted_vertices())
      for_each_location(p, input,
                        [this](const auto& q) { m_contains_inserted[q.first.idx()] = true; });
  }

  void resize(Part_starts<Traits>& starts, Concurrency concurrency)
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
        m_courses = Edge_courses<Traits>(m_tri, m_on_intrinsic);
        m_order_on_input.resize(crossings);
        m_scale.resize(Has_scale<Traits>::value ? crossings : 0);
      });
  }

  // Stores the crossings of a chunk of edges of T1, in order, and counts their pieces.
  struct Chunk
  {
    std::vector<size_type> crossings;
    size_type pieces = 0;
  };

  // Traces every curve along the first halfedge of its edge. The curve occurs at both its ends.
  void trace_all(const Part_starts<Traits>& starts, Concurrency concurrency)
  {
    const std::size_t edges = m_tri.input_mesh().num_edges();
    std::vector<Chunk> chunks(number_of_chunks(edges));
    if constexpr(can_be_doubtful())
      if(m_on_intrinsic.size() > 0)
        note_heights(concurrency);
    for_each_chunk(concurrency, edges, [&](std::size_t begin, std::size_t end) {
      Edge_tracer<Traits> tracer(m_tri);
      for(std::size_t e = begin; e < end; ++e)
        trace(Edge_index(static_cast<size_type>(e)), starts, tracer, chunks[begin / chunk_size]);
    });
    number_along_input(chunks, concurrency);
    settle_places(concurrency);
    m_doubt = Doubt();
  }

  // ---- Thin faces ----

  // Determines which crossings have positions that rounded lengths do not determine.
  struct Doubt
  {
    std::vector<float> input_heights, heights; // of faces, empty if all places are certain
    std::vector<char> is_doubtful;             // for each crossing
  };

  static constexpr bool can_be_doubtful() { return has_metric<Traits>() && is_rounded<FT>(); }

  void note_heights(Concurrency concurrency)
  {
    Doubt& doubt = m_doubt;
    doubt.input_heights = face_heights(m_tri.input(), concurrency);
    doubt.heights = face_heights(m_tri.intrinsic(), concurrency);
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
    return !(input_height * height * height >= least_product_of_heights());
  }

  // Records the undetermined crossings, one or all, of a part of the edge of `input`.
  void note_doubt(Halfedge_index input, const Edge_tracer<Traits>& tracer)
  {
    const Delta_complex& mesh = m_tri.mesh();
    float height = 1;
    for(std::size_t m = 0; m < tracer.size(); ++m)
      height =
        (std::min)(height, height_around(tracer.crossing(m).halfedge, mesh, m_doubt.heights));
    if(!is_doubtful(height_around(input, m_tri.input_mesh(), m_doubt.input_heights), height))
      return;
    for(std::size_t m = 0; m < tracer.size(); ++m) {
      const auto& c = tracer.crossing(m);
      m_doubt.is_doubtful[m_on_intrinsic(c.halfedge, static_cast<size_type>(c.number))] = true;
    }
  }

  // Computes the positions of crossings on edges of T2 with an undetermined crossing on the exact
  // surface. If edges run along each other, positions are kept, because any common position is
  // correct.
  void enclose_doubtful(Concurrency concurrency)
  {
    if(m_doubt.is_doubtful.empty())
      return;
    const std::size_t edges = m_tri.mesh().num_edges();
    for_each_chunk(concurrency, edges, [&](std::size_t begin, std::size_t end) {
      Crossing_encloser<Traits> enclosed(m_tri, m_courses);
      for(std::size_t i = begin; i < end; ++i)
        if(const Edge_index e(static_cast<size_type>(i)); has_doubtful(e))
          set_places(e, enclosed.with_digits_that_help(first_halfedge(e), crossing_width()));
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
      if(const auto& place = places[p]; is_narrow(place, greatest_crossing_width())) {
        on_intrinsic(e, p).s = middle(place.on_input.t);
        on_intrinsic(e, p).t = middle(place.on_intrinsic.t);
      }
  }

  // Each part starts at the end of another one, except for the first.
  void trace(Edge_index e, const Part_starts<Traits>& starts, Edge_tracer<Traits>& tracer,
             Chunk& chunk)
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
        record(part_of_edge(h, v, part.end, m_tri), h, tracer, chunk);
        part.count = static_cast<size_type>(chunk.crossings.size()) - part.first;
      }
      chunk.pieces = end_of_pieces(part);
      v = part.end;
    }
  }

  void record(const Part_of_edge<FT>& part, Halfedge_index input, const Edge_tracer<Traits>& tracer,
              Chunk& chunk)
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
      if constexpr(Has_scale<Traits>::value)
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

  // Marks a crossing whose position on an edge is not computed yet.
  static FT unknown() { return FT(-1); }

  Record& on_intrinsic(Edge_index e, size_type p)
  {
    return m_records[m_on_intrinsic.before(e) + p];
  }

  // Rounding may move a crossing along an edge, but must not reorder crossings. At faces without
  // area, edges run along each other. A crossing at such a face that would move by more than
  // rounding is moved on both of its edges. This ends after few rounds. Otherwise it is moved on
  // one edge, because no move exceeds 1.
  void settle_places(Concurrency concurrency)
  {
    constexpr bool has_distance = Has_distance<Traits>::value;
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

  // Calls `mend(e)` for the edges of T2 whose crossings are out of order by more than rounding.
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

  // Returns whether no crossing is moved by more than `tolerance`. The positions of other crossings
  // on their edges of T2 become unknown.
  bool order_along_input(const FT& tolerance, Concurrency concurrency)
  {
    std::atomic<bool> result(true);
    for_each_in_chunks<Edge_index>(concurrency, m_tri.input_mesh(), [&](Edge_index e) {
      FT s(0);
      const size_type first = part(e, 0).first;
      for(size_type p = 0; p < number_of_crossings_on_input(e); ++p) {
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

  // Computes crossings in the strip of T1 along `e`, because lengths of T1 define the surface and
  // lengths of T2 are rounded.
  void place_along_intrinsic(Edge_index e)
  {
    FT t(0);
    for_each_in_strip(e, [&](const auto& strip, std::size_t m, Halfedge_index exit, Record& r) {
      const auto position = strip.crossing(m, t);
      r.t = t = position.along_line;
      r.s = edge_point(exit, position.along_edge).t;
    });
  }

  // Computes crossings whose position on `e` is unknown, and moves crossings that are out of order.
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
    const Edge_course course = m_courses(first_halfedge(e));
    typename Traits::Geodesic_strip strip;
    if(!CGAL::is_finite(m_tri.lay_out(strip, first_halfedge(e), course)))
      throw Numerical_error("the strip of edge " + std::to_string(e.idx()) +
                            " has no finite length");
    for(size_type m = 0; m < course.size(); ++m)
      f(strip, m, course[m], on_intrinsic(e, m));
  }

  Doubt m_doubt; // while places are found
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_TABLES_H
