// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_TRIPLE_SUBDIVISION_BUILDER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_TRIPLE_SUBDIVISION_BUILDER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Face_chords.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Marked_edges.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/set_halfedges_of_vertices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

// Cuts each face of B along its chords. The pieces of edges of B come first. A chord with n
// crossings also consists of n + 1 pieces.
template <typename FT, typename Point>
class Triple_subdivision<FT, Point>::Builder
{
  typedef internal::Mark<FT> Mark;
  typedef internal::Chord_end Chord_end;
  typedef Intrinsic_triangulations::Edge_location<FT> Edge_location;
  typedef Intrinsic_triangulations::Face_location<FT> Face_location;
  typedef Intrinsic_triangulations::Vertex_location Vertex_location;
  typedef std::array<Surface_point<FT>, 2> On_A_and_C;

  // Counts elements inside faces of B.
  struct Size
  {
    std::uint64_t vertices, edges, faces;
  };

public:
  Builder(const internal::Marked_edges<FT>& edges,
          Intrinsic_triangulations::Concurrency concurrency, Triple_subdivision& result)
    : m_concurrency(concurrency),
      m_marks(edges),
      m_numbers(edges.numbers()),
      m_b(edges.mesh()),
      m_last_face(m_b.num_vertices()),
      m_first(m_b.num_faces()),
      m_result(result),
      m_mesh(result.mesh())
  {}

  void build()
  {
    resize(number_elements());
    for_each<Halfedge_index>([this](Halfedge_index h) { set_pieces(h); });
    for_each_face([](Face_builder& builder, Face_index f) { builder.add_face(f); });
    for_each<Halfedge_index>([this](Halfedge_index h) { link_border(h); });
    Intrinsic_triangulations::set_halfedges_of_vertices(m_mesh, m_concurrency);
  }

private:
  class Face_builder;

  template <typename Index, typename Function>
  void for_each(const Function& f) const
  {
    Intrinsic_triangulations::for_each_in_chunks<Index>(m_concurrency, m_b, f);
  }

  // Calls `f` for all faces with a builder that is used for all faces of a chunk.
  template <typename Function>
  void for_each_face(const Function& f)
  {
    Intrinsic_triangulations::for_each_chunk(m_concurrency, m_b.num_faces(),
                                             [&](std::size_t begin, std::size_t end) {
                                               Face_builder builder(*this);
                                               for(std::size_t i = begin; i < end; ++i)
                                                 f(builder, Face_index(static_cast<size_type>(i)));
                                             });
  }

  // Numbers the elements inside faces, face by face, and returns the numbers of all elements.
  Size number_elements()
  {
    for_each_face([this](Face_builder& builder, Face_index f) { m_first[f] = builder.size(f); });
    Size size{m_result.m_first_crossing_of_ac, m_numbers.number_of_pieces(), 0};
    for(Face_index f : m_b.faces()) {
      const Size inside = std::exchange(m_first[f], size);
      size = {size.vertices + inside.vertices, size.edges + inside.edges,
              size.faces + inside.faces};
      for(Halfedge_index h : sides(f, m_b))
        m_last_face[m_b.source(h)] = f;
    }
    check_number_of_edges(size.edges);
    return size;
  }

  void resize(const Size& size)
  {
    const auto vertices = static_cast<size_type>(size.vertices),
               edges = static_cast<size_type>(size.edges),
               faces = static_cast<size_type>(size.faces);
    m_result.reserve_parents(edges, faces);
    for(auto& places : m_result.m_place)
      places.reserve(vertices);
    m_result.m_on_C.reserve(2 * edges);
    Intrinsic_triangulations::run_together(
      m_concurrency,
      [&] {
        m_result.resize_parents(edges, faces);
        for(auto& places : m_result.m_place)
          places.resize(vertices);
        m_result.m_on_C.resize(2 * edges);
      },
      [&] { m_result.resize_mesh(vertices, edges, faces); });
  }

  // Returns whether `f` is the last face at the source of `h`. A vertex of several faces has its
  // position in the last of these faces.
  bool is_last_at_source(Face_index f, Halfedge_index h) const
  {
    return m_last_face[m_b.source(h)] == f;
  }
  bool is_last_at_marks(Face_index f, Halfedge_index h) const
  {
    const Face_index other = m_b.face(opposite(h));
    return !other.is_valid() || other <= f;
  }

  static Layer layer(std::size_t family) { return family == 0 ? Layer::A : Layer::C; }

  // Returns piece `p` of the halfedge `h` of B, counted from its source.
  Halfedge_index piece_of_side(Halfedge_index h, std::size_t p) const
  {
    return m_numbers.piece(h, static_cast<size_type>(p));
  }

  void set_pieces(Halfedge_index h)
  {
    const Edge_index e(h);
    for(size_type p = 0; p < m_numbers.size(e); ++p)
      m_mesh.set_target(piece_of_side(h, p), m_marks.mark(h, p).vertex);
    m_mesh.set_target(m_numbers.last_piece(h), m_b.target(h));
    if(Intrinsic_triangulations::is_first_halfedge(h))
      for(size_type p = 0; p < m_numbers.number_of_pieces(e); ++p)
        set_parents(piece_of_side(h, p), h);
  }

  void set_parents(Halfedge_index piece, Halfedge_index h)
  {
    m_result.set_parent(Layer::B, piece, h);
    for(std::size_t family = 0; family < 2; ++family)
      if(m_marks.count(family, Edge_index(h)) == 0)
        m_result.set_parent(layer(family), piece, m_marks.outgoing(family, h));
  }

  // A boundary edge has no marks, so it is one piece.
  void link_border(Halfedge_index h)
  {
    if(m_b.is_border(h))
      m_mesh.set_next(piece_of_side(h, 0), piece_of_side(m_b.next(h), 0));
  }

  Surface_point<FT>& place(Layer layer, Vertex_index v)
  {
    return m_result.m_place[Base::index(layer)][v.idx()];
  }

  Intrinsic_triangulations::Concurrency m_concurrency;
  const internal::Marked_edges<FT>& m_marks;
  const Intrinsic_triangulations::Edge_marks& m_numbers;
  const Delta_complex& m_b;
  std::vector<Face_index> m_last_face; // at each vertex of B
  std::vector<Size> m_first;           // elements of each face of B
  Triple_subdivision& m_result;
  typename Base::Mesh& m_mesh;
};

// Cuts faces one after the other.
template <typename FT, typename Point>
class Triple_subdivision<FT, Point>::Builder::Face_builder
{
public:
  explicit Face_builder(Builder& builder)
    : m_builder(builder),
      m_marks(builder.m_marks),
      m_result(builder.m_result),
      m_mesh(builder.m_mesh),
      m_chords(builder.m_marks)
  {}

  // Returns the numbers of elements in a face. If n lines do not cross, they cut a disk into n + 1
  // parts. Each crossing adds one part.
  Size size(Face_index f)
  {
    m_chords.order_ends(f);
    const std::size_t crossings = m_chords.crossings().size(), chords = m_chords.size();
    return {crossings, chords + 2 * crossings, 1 + chords + crossings};
  }

  void add_face(Face_index f)
  {
    m_face = f;
    m_chords.set_face(f);
    m_linked.clear();
    add_pieces();
    set_places_of_crossings();
    for(std::size_t s = 0; s < 3; ++s) {
      link_side(s);
      link_corner(s);
      set_places_on_side(s);
    }
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x)
      link_crossing(x);
    add_parts();
  }

private:
  // Stores a halfedge and the faces of A and C on its left.
  struct Linked
  {
    Halfedge_index halfedge;
    Face_index face_of_A, face_of_C;
  };

  // Returns piece `i` of a chord, counted from its first end.
  Halfedge_index piece_of_chord(std::size_t chord, std::size_t i) const
  {
    return Halfedge_index(2 * (m_first_piece[chord] + static_cast<size_type>(i)));
  }

  Halfedge_index first_piece_from(const Chord_end& end) const
  {
    return end.is_first ? piece_of_chord(end.chord, 0) : opposite(last_piece(end.chord));
  }

  Halfedge_index last_piece(std::size_t chord) const
  {
    return piece_of_chord(chord, m_chords.crossings().number_on(chord));
  }

  Vertex_index crossing_vertex(std::size_t x) const
  {
    return Vertex_index(static_cast<size_type>(m_builder.m_first[m_face].vertices + x));
  }

  void set_places_of_crossings()
  {
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x) {
      const auto& chord = m_chords[m_chords.crossings()[x].earlier];
      m_builder.place(Layer::B, crossing_vertex(x)) = Face_location(
        m_face, internal::between(chord.place[0], chord.place[1], m_chords.places(x)[0]));
    }
  }

  void add_pieces()
  {
    m_first_piece.clear();
    const auto& crossings = m_chords.crossings();
    auto e = static_cast<size_type>(m_builder.m_first[m_face].edges);
    for(std::size_t c = 0; c < m_chords.size(); ++c) {
      const auto& chord = m_chords[c];
      m_first_piece.push_back(e);
      Vertex_index v = chord.vertex[0];
      for(std::size_t i = 0; i <= crossings.number_on(c); ++i) {
        const Halfedge_index h(2 * e++);
        m_mesh.set_target(opposite(h), v);
        v = i < crossings.number_on(c) ? crossing_vertex(crossings.on(c, i)) : chord.vertex[1];
        m_mesh.set_target(h, v);
        m_result.set_parent(layer(chord.family), h, chord.along);
      }
    }
  }

  // Adds the parts. Each part is found by one of the linked halfedges.
  void add_parts()
  {
    auto part = static_cast<size_type>(m_builder.m_first[m_face].faces);
    for(const auto& [h, face_of_A, face_of_C] : m_linked)
      if(m_mesh.face(h) == m_mesh.null_face())
        m_result.set_face(Face_index(part++), h, {face_of_A, m_face, face_of_C});
  }

  // Links `in` with `out`, the next halfedge around the face on their left.
  void link(Halfedge_index in, Halfedge_index out, const On_A_and_C& on_A_and_C, bool is_last)
  {
    m_mesh.set_next(in, out);
    if(is_last)
      m_builder.place(Layer::A, m_mesh.target(in)) = on_A_and_C[0];
    const auto [face_of_C, on_C] = face_location(on_A_and_C[1], m_marks.mesh(1));
    m_result.m_on_C[in.idx()] = on_C;
    m_linked.push_back({in, face_location(on_A_and_C[0], m_marks.mesh(0)).first, face_of_C});
  }

  void link_side(std::size_t s)
  {
    const Halfedge_index h = m_chords.sides()[s];
    const bool is_last = m_builder.is_last_at_marks(m_face, h);
    for(std::size_t p = 0; p < m_chords.marks(s).size(); ++p) {
      const Mark& mark = m_chords.marks(s)[p];
      const Halfedge_index inward = first_piece_from(m_chords.end_at_mark(s, p));
      const std::size_t k = mark.family;
      On_A_and_C place;
      place[1 - k] = mark.other;
      place[k] = reversed(mark.across);
      link(m_builder.piece_of_side(h, p), inward, place, is_last);
      place[k] = mark.across;
      link(opposite(inward), m_builder.piece_of_side(h, p + 1), place, is_last);
    }
  }

  // Links the halfedges at a corner, from the side after it to the side before it. Each region
  // between chords is in the face on the left of the last outgoing halfedge passed.
  void link_corner(std::size_t s)
  {
    const Halfedge_index before = m_chords.sides()[(s + 2) % 3], after = m_chords.sides()[s];
    const bool is_last = m_builder.is_last_at_source(m_face, after);
    Halfedge_index out = m_builder.piece_of_side(after, 0);
    On_A_and_C place;
    for(std::size_t k = 0; k < 2; ++k)
      place[k] = Vertex_location{m_marks.outgoing(k, after)};
    for(std::size_t i = m_chords.number_at_corner(s); i-- > 0;) {
      const Chord_end& end = m_chords.end_at_corner(s, i);
      const auto& chord = m_chords[end.chord];
      const Halfedge_index inward = first_piece_from(end);
      link(opposite(inward), out, place, is_last);
      out = inward;
      place[chord.family] = Vertex_location{end.is_first ? chord.along : opposite(chord.along)};
    }
    link(m_builder.piece_of_side(before, m_chords.marks((s + 2) % 3).size()), out, place, is_last);
  }

  void set_places_on_side(std::size_t s)
  {
    const Halfedge_index h = m_chords.sides()[s];
    if(m_builder.is_last_at_source(m_face, h))
      m_builder.place(Layer::B, m_builder.m_b.source(h)) = Vertex_location{h};
    if(m_builder.is_last_at_marks(m_face, h))
      for(const Mark& mark : m_chords.marks(s))
        m_builder.place(Layer::B, mark.vertex) = Edge_location{h, {1 - mark.here, mark.here}};
  }

  // Links the halfedges at a crossing. The later chord crosses the earlier one from right to left.
  void link_crossing(std::size_t x)
  {
    const auto& crossing = m_chords.crossings()[x];
    const std::size_t c = crossing.earlier, d = crossing.later;
    const Halfedge_index c_in = piece_of_chord(c, crossing.rank[0]),
                         c_out = piece_of_chord(c, crossing.rank[0] + 1),
                         d_in = piece_of_chord(d, crossing.rank[1]),
                         d_out = piece_of_chord(d, crossing.rank[1] + 1);
    const auto place = [&](bool left_of_c, bool left_of_d) {
      On_A_and_C result;
      result[m_chords[c].family] = place_on_chord(c, m_chords.places(x)[0], left_of_c);
      result[m_chords[d].family] = place_on_chord(d, m_chords.places(x)[1], left_of_d);
      return result;
    };
    link(c_in, d_out, place(true, true), true);
    link(d_in, opposite(c_in), place(false, true), true);
    link(opposite(c_out), opposite(d_in), place(false, false), true);
    link(opposite(d_out), c_out, place(true, false), true);
  }

  // Returns a point of a chord, in the face of A or C on one of its sides.
  Edge_location place_on_chord(std::size_t c, const FT& t, bool is_left) const
  {
    const auto& chord = m_chords[c];
    const Edge_location p{chord.along, internal::between(chord.weight[0], chord.weight[1], t)};
    return is_left ? p : reversed(p);
  }

  Builder& m_builder;
  const internal::Marked_edges<FT>& m_marks;
  Triple_subdivision& m_result;
  typename Base::Mesh& m_mesh;
  internal::Face_chords<FT> m_chords; // this and the next members are of one face
  Face_index m_face;
  std::vector<size_type> m_first_piece;
  std::vector<Linked> m_linked;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_TRIPLE_SUBDIVISION_BUILDER_H
