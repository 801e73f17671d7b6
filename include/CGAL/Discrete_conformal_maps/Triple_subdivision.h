// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/subdivision/Face_chords.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Marked_edges.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

using Intrinsic_triangulations::Correspondence;
using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Face_location;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::Side;
using Intrinsic_triangulations::Surface_place;
using Intrinsic_triangulations::Vertex_index;

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// names one of the three triangulations of a surface (Figure 4.1).
enum class Layer
{
  A, ///< \f$T^A\f$, the input
  B, ///< \f$T^B\f$, the intrinsic Delaunay triangulation of the input
  C  ///< \f$T^C\f$, the ideal Delaunay triangulation at the end
};

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the polygon mesh into which the edges of \f$T^A\f$, \f$T^B\f$ and \f$T^C\f$ together cut the
/// surface (Section 4.2.2). Every face of it is part of one face of each.
///
/// All three have the same vertices; these come first, with their numbers. They are followed by the
/// crossings of edges of \f$T^A\f$ and \f$T^B\f$ and of \f$T^B\f$ and \f$T^C\f$, with the numbers
/// of the two correspondences, and then by those of \f$T^A\f$ and \f$T^C\f$ inside faces of
/// \f$T^B\f$.
///
/// In each face of \f$T^B\f$, edges of \f$T^A\f$ and edges of \f$T^C\f$ are straight lines. The
/// order of their ends around the face alone decides which of them cross, and in which order. Hence
/// the connectivity is always valid. It is exact unless rounding has exchanged an end of an edge of
/// \f$T^A\f$ and an end of an edge of \f$T^C\f$ on an edge of \f$T^B\f$, which
/// `certify_order_of_ends()` finds out. Where the two are at one place, they remain two vertices. Places of crossings are rounded; along every edge they do not
/// decrease.
///
/// The object refers to the three triangulations and is valid until they change.
///
/// \tparam FT_ the type of coordinates
/// \tparam Point the point type of the mesh
template <typename FT_ = double, typename Point = Intrinsic_triangulations::No_point>
class Triple_subdivision
  : public Intrinsic_triangulations::Subdivision_base<Triple_subdivision<FT_, Point>, Layer, 3, FT_,
                                                      Point>
{
  typedef Intrinsic_triangulations::Subdivision_base<Triple_subdivision, Layer, 3, FT_, Point> Base;
  friend Base;

public:
  /// the type of coordinates.
  typedef FT_ FT;
  /// the type of numbers of elements.
  typedef typename Base::size_type size_type;

  /// builds the subdivision from the correspondence of \f$T^A\f$ (`Side::input`) and \f$T^B\f$
  /// (`Side::intrinsic`), and that of \f$T^B\f$ (`Side::input`) and \f$T^C\f$ (`Side::intrinsic`).
  /// Complexity: linear in the vertices, edges and crossings.
  /// \throws Overflow_error if there are more edges than a `Surface_mesh` can number
  /// \pre \f$T^B\f$ is the same mesh in both; neither has inserted vertices
  template <typename Traits_AB, typename Traits_BC>
  Triple_subdivision(const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc)
    : Base({&ab.mesh(Side::input), &ab.mesh(Side::intrinsic), &bc.mesh(Side::intrinsic)}),
      m_first_crossing_of_bc(ab.mesh(Side::input).number_of_vertices() + ab.number_of_crossings()),
      m_first_crossing_of_ac(m_first_crossing_of_bc + bc.number_of_crossings())
  {
    CGAL_precondition(ab.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(bc.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(internal::is_same_complex(ab.mesh(Side::intrinsic), bc.mesh(Side::input)));
    check_number_of_edges(std::uint64_t(ab.mesh(Side::intrinsic).number_of_edges()) +
                          ab.number_of_crossings() + bc.number_of_crossings());
    Builder(internal::Marked_edges<FT>(ab, bc), *this).build();
  }

  /// returns whether `v` is a crossing of an edge of `layer` with one of another triangulation.
  /// Edges that are in \f$T^B\f$ too count as edges of \f$T^B\f$ alone.
  bool is_crossing(Layer layer, Vertex_index v) const
  {
    if(this->is_vertex(layer, v))
      return false;
    return layer == Layer::A   ? !is_between(m_first_crossing_of_bc, m_first_crossing_of_ac, v)
           : layer == Layer::B ? v.idx() < m_first_crossing_of_ac
                               : v.idx() >= m_first_crossing_of_bc;
  }

  /// returns the place of `v` on `layer`. The null face if `v` is isolated. Complexity: constant,
  /// or linear in the degree of `v` for \f$T^C\f$.
  Surface_place<FT> place(Layer layer, Vertex_index v) const
  {
    return layer == Layer::C ? place_on_C(v) : m_place[Base::index(layer)][v.idx()];
  }

  /// returns the coordinates of the target of `h` in the parent of its face, in the order of
  /// `Face_location`.
  ///
  /// On \f$T^C\f$ these are homogeneous coordinates: nonnegative weights of the corners, for the
  /// decoration of the ideal polyhedron that the correspondence has. They are linear in each face
  /// of the subdivision, seen in \f$T^B\f$, and continuous across its edges: the weights in two
  /// faces around a vertex belong to the same vertices of \f$T^C\f$ or are zero. They do not sum up
  /// to one, except in Euclidean geometry.
  /// \pre `h` is no border halfedge
  std::array<FT, 3> coordinates(Layer layer, Halfedge_index h) const
  {
    return layer == Layer::C ? m_on_C[h.idx()].second : Base::coordinates(layer, h);
  }

  /// returns `v` as a convex combination of one vertex of `layer`, or of the corners of a face.
  Intrinsic_triangulations::Vertex_weights<FT> weights(Layer layer, Vertex_index v) const
  {
    return this->is_vertex(layer, v) ? Base::weights(layer, v)
                                     : this->corner_weights(layer, place(layer, v).location);
  }

private:
  static void check_number_of_edges(std::uint64_t number)
  {
    if(number >= (std::numeric_limits<size_type>::max)() / 2)
      throw Intrinsic_triangulations::Overflow_error("more edges than a mesh can number");
  }

  static bool is_between(size_type first, size_type end, Vertex_index v)
  {
    return first <= v.idx() && v.idx() < end;
  }

  // in a face on the left of an edge of C that leaves `v`, if there is one
  Surface_place<FT> place_on_C(Vertex_index v) const
  {
    Surface_place<FT> result{};
    if(this->mesh().is_isolated(v))
      return result;
    for(Halfedge_index h : CGAL::halfedges_around_target(v, this->mesh()))
      if(!result.along.is_valid() && !this->mesh().is_border(h))
        result = {this->parent_halfedge(Layer::C, this->mesh().next(h)), m_on_C[h.idx()]};
    auto& b = result.location.second;
    const FT sum = b[0] + b[1] + b[2];
    for(FT& x : b)
      x /= sum;
    return result;
  }

  void copy_corner(Halfedge_index from, Halfedge_index to)
  {
    m_on_C.resize(this->mesh().number_of_halfedges());
    m_on_C[to.idx()] = m_on_C[from.idx()];
  }

  class Builder;

  size_type m_first_crossing_of_bc, m_first_crossing_of_ac;
  std::array<std::vector<Surface_place<FT>>, 2> m_place; // of each vertex, on A and B
  std::vector<Face_location<FT>> m_on_C;                 // of the target of each halfedge
};

// Cuts each face of B along its chords. The pieces of edges of B come first; a chord with n
// crossings consists of n + 1 pieces too.
template <typename FT, typename Point>
class Triple_subdivision<FT, Point>::Builder
{
  typedef internal::Mark<FT> Mark;
  typedef internal::Chord_end Chord_end;
  typedef std::array<Surface_place<FT>, 2> Place; // on A and C

public:
  Builder(const internal::Marked_edges<FT>& edges, Triple_subdivision& result)
    : m_marks(edges),
      m_numbers(edges.numbers()),
      m_b(edges.mesh()),
      m_chords(edges),
      m_result(result),
      m_mesh(result.mesh())
  {}

  void build()
  {
    m_result.resize_mesh(m_result.m_first_crossing_of_ac, m_numbers.number_of_pieces(), 0);
    m_result.resize_parents(m_numbers.number_of_pieces(), 0);
    resize_places();
    for(Halfedge_index h : m_b.halfedges())
      set_pieces(h);
    for(Face_index f : m_b.faces())
      add_face(f);
    link_border();
    Intrinsic_triangulations::internal::set_halfedges_of_vertices(m_mesh);
  }

private:
  static Layer layer(std::size_t family) { return family == 0 ? Layer::A : Layer::C; }
  static Halfedge_index opposite(Halfedge_index h) { return Intrinsic_triangulations::opposite(h); }

  // ---- Pieces ----

  // piece `p` of the halfedge `h` of B, counted from its source
  Halfedge_index piece_of_side(Halfedge_index h, std::size_t p) const
  {
    return m_numbers.piece(h, static_cast<size_type>(p));
  }

  // piece `i` of a chord, counted from its first end
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
    return Vertex_index(m_first_crossing + static_cast<size_type>(x));
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
        m_result.set_parent(layer(family), piece, m_marks.spoke(family, h));
  }

  // ---- Faces ----

  void add_face(Face_index f)
  {
    m_chords.set_face(f);
    m_linked.clear();
    add_crossings();
    add_pieces();
    resize_places();
    set_places_of_crossings(f);
    for(std::size_t s = 0; s < 3; ++s) {
      link_side(s);
      link_corner(s);
      set_places_on_side(f, s);
    }
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x)
      link_crossing(x);
    for(const auto& [h, face_of_A] : m_linked)
      if(m_mesh.face(h) == m_mesh.null_face())
        m_result.add_face(h, {face_of_A, f, m_result.m_on_C[h.idx()].first});
  }

  void resize_places()
  {
    for(auto& places : m_result.m_place)
      places.resize(m_mesh.number_of_vertices());
    m_result.m_on_C.resize(m_mesh.number_of_halfedges());
  }

  Surface_place<FT>& place(Layer layer, Vertex_index v)
  {
    return m_result.m_place[Base::index(layer)][v.idx()];
  }

  void add_crossings()
  {
    m_first_crossing = m_mesh.num_vertices();
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x)
      m_mesh.add_vertex();
  }

  void set_places_of_crossings(Face_index f)
  {
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x) {
      const auto& chord = m_chords[m_chords.crossings()[x].earlier];
      place(Layer::B, crossing_vertex(x)) = {
        Halfedge_index(),
        {f, internal::between(chord.place[0], chord.place[1], m_chords.places(x)[0])}};
    }
  }

  void add_pieces()
  {
    m_first_piece.clear();
    const auto& crossings = m_chords.crossings();
    check_number_of_edges(std::uint64_t(m_mesh.num_edges()) + m_chords.size() +
                          2 * crossings.size());
    for(std::size_t c = 0; c < m_chords.size(); ++c) {
      const auto& chord = m_chords[c];
      m_first_piece.push_back(m_mesh.num_edges());
      Vertex_index v = chord.vertex[0];
      for(std::size_t i = 0; i <= crossings.number_on(c); ++i) {
        const Halfedge_index h = m_result.add_edge();
        m_mesh.set_target(opposite(h), v);
        v = i < crossings.number_on(c) ? crossing_vertex(crossings.on(c, i)) : chord.vertex[1];
        m_mesh.set_target(h, v);
        m_result.set_parent(layer(chord.family), h, chord.along);
      }
    }
  }

  // At the target of `in`, `out` is the next halfedge around the face on their left.
  void link(Halfedge_index in, Halfedge_index out, const Place& on_A_and_C)
  {
    m_mesh.set_next(in, out);
    place(Layer::A, m_mesh.target(in)) = on_A_and_C[0];
    m_result.m_on_C[in.idx()] = on_A_and_C[1].location;
    m_linked.push_back({in, on_A_and_C[0].location.first});
  }

  void link_side(std::size_t s)
  {
    const Halfedge_index h = m_chords.sides()[s];
    for(std::size_t p = 0; p < m_chords.marks(s).size(); ++p) {
      const Mark& mark = m_chords.marks(s)[p];
      const Halfedge_index inward = first_piece_from(m_chords.end_at_mark(s, p));
      const std::size_t k = mark.family;
      const Delta_complex& mesh = m_marks.mesh(k);
      Place place;
      place[1 - k] = mark.other;
      place[k] = internal::place_on_edge(opposite(mark.across), reversed(mark.weight), mesh);
      link(piece_of_side(h, p), inward, place);
      place[k] = internal::place_on_edge(mark.across, mark.weight, mesh);
      link(opposite(inward), piece_of_side(h, p + 1), place);
    }
  }

  // From the side after the corner to the side before it. Each region between chords is in the face
  // on the left of the last spoke passed.
  void link_corner(std::size_t s)
  {
    const Halfedge_index before = m_chords.sides()[(s + 2) % 3], after = m_chords.sides()[s];
    Halfedge_index out = piece_of_side(after, 0);
    Place place;
    for(std::size_t k = 0; k < 2; ++k)
      place[k] = internal::place_of_source<FT>(m_marks.spoke(k, after), m_marks.mesh(k));
    for(std::size_t i = m_chords.number_at_corner(s); i-- > 0;) {
      const Chord_end& end = m_chords.end_at_corner(s, i);
      const auto& chord = m_chords[end.chord];
      const Halfedge_index inward = first_piece_from(end);
      link(opposite(inward), out, place);
      out = inward;
      place[chord.family] = internal::place_of_source<FT>(
        end.is_first ? chord.along : opposite(chord.along), m_marks.mesh(chord.family));
    }
    link(piece_of_side(before, m_chords.marks((s + 2) % 3).size()), out, place);
  }

  void set_places_on_side(Face_index f, std::size_t s)
  {
    using Intrinsic_triangulations::barycentric_coordinates;
    const Halfedge_index h = m_chords.sides()[s];
    place(Layer::B, m_b.source(h)) = {h, {f, barycentric_coordinates(s, FT(0))}};
    for(const Mark& mark : m_chords.marks(s))
      place(Layer::B, mark.vertex) = {h, {f, barycentric_coordinates(s, mark.here)}};
  }

  // The later chord crosses the earlier one from right to left.
  void link_crossing(std::size_t x)
  {
    const auto& crossing = m_chords.crossings()[x];
    const std::size_t c = crossing.earlier, d = crossing.later;
    const Halfedge_index c_in = piece_of_chord(c, crossing.rank[0]),
                         c_out = piece_of_chord(c, crossing.rank[0] + 1),
                         d_in = piece_of_chord(d, crossing.rank[1]),
                         d_out = piece_of_chord(d, crossing.rank[1] + 1);
    const auto place = [&](bool left_of_c, bool left_of_d) {
      Place result;
      result[m_chords[c].family] = place_on_chord(c, m_chords.places(x)[0], left_of_c);
      result[m_chords[d].family] = place_on_chord(d, m_chords.places(x)[1], left_of_d);
      return result;
    };
    link(c_in, d_out, place(true, true));
    link(d_in, opposite(c_in), place(false, true));
    link(opposite(c_out), opposite(d_in), place(false, false));
    link(opposite(d_out), c_out, place(true, false));
  }

  // a point of a chord, in the face of A or C on one of its sides
  Surface_place<FT> place_on_chord(std::size_t c, const FT& t, bool is_left) const
  {
    const auto& chord = m_chords[c];
    const Delta_complex& mesh = m_marks.mesh(chord.family);
    const auto weight = internal::between(chord.weight[0], chord.weight[1], t);
    return is_left ? internal::place_on_edge(chord.along, weight, mesh)
                   : internal::place_on_edge(opposite(chord.along), reversed(weight), mesh);
  }

  static std::array<FT, 2> reversed(const std::array<FT, 2>& weight)
  {
    return {weight[1], weight[0]};
  }

  // edges on the boundary have no marks, hence are one piece each
  void link_border()
  {
    for(Halfedge_index h : m_b.halfedges())
      if(m_b.is_border(h))
        m_mesh.set_next(piece_of_side(h, 0), piece_of_side(m_b.next(h), 0));
  }

  const internal::Marked_edges<FT>& m_marks;
  const Intrinsic_triangulations::Edge_marks& m_numbers;
  const Delta_complex& m_b;
  internal::Face_chords<FT> m_chords; // of the face at hand, as all that follows
  std::vector<size_type> m_first_piece;
  std::vector<std::pair<Halfedge_index, Face_index>> m_linked; // and the face of A on its left
  size_type m_first_crossing = 0;
  Triple_subdivision& m_result;
  typename Base::Mesh& m_mesh;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
