// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/subdivision/Edge_marks.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Face_chords.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

using Intrinsic_triangulations::Correspondence;
using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Face_location;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::Side;
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
/// \f$T^A\f$ and an end of an edge of \f$T^C\f$ on an edge of \f$T^B\f$. Where the two are at one
/// place, they remain two vertices. Places of crossings are rounded; along every edge they do not
/// decrease.
///
/// \tparam FT_ the type of coordinates
/// \tparam Point the point type of the mesh
template <typename FT_ = double, typename Point = Intrinsic_triangulations::No_point>
class Triple_subdivision
{
public:
  /// the type of coordinates.
  typedef FT_ FT;
  /// the type of the mesh.
  typedef Surface_mesh<Point> Mesh;
  /// the type of numbers of elements.
  typedef typename Delta_complex::size_type size_type;

  /// builds the subdivision from the correspondence of \f$T^A\f$ (`Side::input`) and \f$T^B\f$
  /// (`Side::intrinsic`), and that of \f$T^B\f$ (`Side::input`) and \f$T^C\f$ (`Side::intrinsic`).
  /// Complexity: linear in the vertices, edges and crossings.
  /// \throws Overflow_error if there are more edges than a `Surface_mesh` can number
  /// \pre \f$T^B\f$ is the same mesh in both; neither has inserted vertices
  template <typename Traits_AB, typename Traits_BC>
  Triple_subdivision(const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc)
    : m_number_of_input_vertices(ab.mesh(Side::input).number_of_vertices()),
      m_first_crossing_of_bc(m_number_of_input_vertices + ab.number_of_crossings()),
      m_first_crossing_of_ac(m_first_crossing_of_bc + bc.number_of_crossings())
  {
    CGAL_precondition(ab.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(bc.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(internal::is_same_complex(ab.mesh(Side::intrinsic), bc.mesh(Side::input)));
    check_number_of_edges(std::uint64_t(ab.mesh(Side::intrinsic).number_of_edges()) +
                          ab.number_of_crossings() + bc.number_of_crossings());
    Builder(internal::Edge_marks<FT>(ab, bc), *this).build();
  }

  /// copies everything. Complexity: linear.
  Triple_subdivision(const Triple_subdivision& other)
    : m_number_of_input_vertices(other.m_number_of_input_vertices),
      m_first_crossing_of_bc(other.m_first_crossing_of_bc),
      m_first_crossing_of_ac(other.m_first_crossing_of_ac),
      m_mesh(other.m_mesh)
  {
    attach();
  }

  /// takes everything from `other`. Complexity: constant.
  Triple_subdivision(Triple_subdivision&& other) = default;
  /// takes everything from `other`. Complexity: constant.
  Triple_subdivision& operator=(Triple_subdivision&& other) = default;
  /// copies everything. Complexity: linear.
  Triple_subdivision& operator=(const Triple_subdivision& other)
  {
    return *this = Triple_subdivision(other);
  }

  /// the mesh.
  const Mesh& mesh() const { return m_mesh; }

  /// the mesh, for more properties and for points; its connectivity must stay.
  Mesh& mesh() { return m_mesh; }

  /// the number of vertices of each of the three triangulations.
  size_type number_of_input_vertices() const { return m_number_of_input_vertices; }

  /// whether `v` is a vertex of the three triangulations.
  bool is_input_vertex(Vertex_index v) const { return v.idx() < m_number_of_input_vertices; }

  /// whether `v` is a crossing of an edge of `layer` with one of another triangulation. Edges that
  /// are in
  /// \f$T^B\f$ too count as edges of \f$T^B\f$ alone.
  bool is_crossing(Layer layer, Vertex_index v) const
  {
    if(is_input_vertex(v))
      return false;
    return layer == Layer::A   ? !is_between(m_first_crossing_of_bc, m_first_crossing_of_ac, v)
           : layer == Layer::B ? v.idx() < m_first_crossing_of_ac
                               : v.idx() >= m_first_crossing_of_bc;
  }

  /// the face of `layer` of which `f` is a part.
  Face_index parent_face(Layer layer, Face_index f) const { return m_parent_face[index(layer)][f]; }

  /// the edge of `layer` of which `e` is a part, or a null edge.
  Edge_index parent_edge(Layer layer, Edge_index e) const { return m_parent_edge[index(layer)][e]; }

  /// the place of `v` on \f$T^A\f$. The null face if `v` is isolated.
  const Face_location<FT>& place_on_A(Vertex_index v) const { return m_place_on_A[v]; }

  /// the place of `v` on \f$T^B\f$. The null face if `v` is isolated.
  const Face_location<FT>& place_on_B(Vertex_index v) const { return m_place_on_B[v]; }

  /// the place of the target of `h` in `parent_face(Layer::C, mesh().face(h))`, as homogeneous
  /// coordinates: nonnegative weights of its corners, in the order of `Face_location`, for the
  /// decoration of the ideal polyhedron that the correspondence has. They are linear in each face
  /// of the subdivision, seen in
  /// \f$T^B\f$, and continuous across its edges: the weights in two faces around a vertex belong to
  /// the same vertices of \f$T^C\f$ or are zero. They do not sum up to one, except in Euclidean
  /// geometry. The null face if `h` is a border halfedge.
  const Face_location<FT>& place_on_C(Halfedge_index h) const { return m_place_on_C[h]; }

private:
  template <typename Index, typename Value>
  using Map = typename Mesh::template Property_map<Index, Value>;

  static std::size_t index(Layer layer) { return static_cast<std::size_t>(layer); }

  static void check_number_of_edges(std::uint64_t number)
  {
    if(number >= (std::numeric_limits<size_type>::max)() / 2)
      throw Intrinsic_triangulations::Overflow_error("more edges than a mesh can number");
  }

  static bool is_between(size_type first, size_type end, Vertex_index v)
  {
    return first <= v.idx() && v.idx() < end;
  }

  // (re)binds the property maps to the mesh
  void attach()
  {
    m_place_on_A = add_map<Vertex_index, Face_location<FT>>("v:place_on_A");
    m_place_on_B = add_map<Vertex_index, Face_location<FT>>("v:place_on_B");
    m_place_on_C = add_map<Halfedge_index, Face_location<FT>>("h:place_on_C");
    const std::array<const char*, 3> face_map{"f:face_of_A", "f:face_of_B", "f:face_of_C"};
    const std::array<const char*, 3> edge_map{"e:edge_of_A", "e:edge_of_B", "e:edge_of_C"};
    for(std::size_t layer = 0; layer < 3; ++layer) {
      m_parent_face[layer] = add_map<Face_index, Face_index>(face_map[layer]);
      m_parent_edge[layer] = add_map<Edge_index, Edge_index>(edge_map[layer]);
    }
  }

  template <typename Index, typename Value>
  Map<Index, Value> add_map(const char* name)
  {
    return m_mesh.template add_property_map<Index, Value>(name).first;
  }

  class Builder;

  size_type m_number_of_input_vertices, m_first_crossing_of_bc, m_first_crossing_of_ac;
  Mesh m_mesh;
  Map<Vertex_index, Face_location<FT>> m_place_on_A, m_place_on_B;
  Map<Halfedge_index, Face_location<FT>> m_place_on_C;
  std::array<Map<Face_index, Face_index>, 3> m_parent_face;
  std::array<Map<Edge_index, Edge_index>, 3> m_parent_edge;
};

// Cuts each face of B along its chords. An edge of B with n marks becomes n + 1 edges, its
// "pieces"; these come first. A chord with n crossings becomes n + 1 pieces too.
template <typename FT, typename Point>
class Triple_subdivision<FT, Point>::Builder
{
  typedef internal::Mark<FT> Mark;
  typedef internal::Chord_end Chord_end;
  typedef std::array<Face_location<FT>, 2> Place; // on A and C

public:
  Builder(const internal::Edge_marks<FT>& marks, Triple_subdivision& result)
    : m_marks(marks), m_b(marks.mesh()), m_chords(marks), m_result(result), m_mesh(result.m_mesh)
  {}

  void build()
  {
    m_mesh.resize(m_result.m_first_crossing_of_ac,
                  m_b.num_edges() + m_result.m_first_crossing_of_ac - m_b.num_vertices(), 0);
    m_result.attach();
    for(Halfedge_index h : m_b.halfedges())
      set_pieces(h);
    for(Face_index f : m_b.faces())
      add_face(f);
    link_border();
    link_vertices();
  }

private:
  static Halfedge_index opposite(Halfedge_index h) { return Intrinsic_triangulations::opposite(h); }

  // ---- Pieces ----

  // piece `p` of the halfedge `h` of B, counted from its source
  Halfedge_index piece_of_side(Halfedge_index h, std::size_t p) const
  {
    const Edge_index e(h);
    const size_type first = m_marks.number_before(e) + e.idx(), i = static_cast<size_type>(p);
    return h.idx() % 2 == 0 ? Halfedge_index(2 * (first + i))
                            : Halfedge_index(2 * (first + m_marks.count(e) - i) + 1);
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
    for(size_type p = 0; p < m_marks.count(e); ++p)
      m_mesh.set_target(piece_of_side(h, p), m_marks.mark(h, p).vertex);
    m_mesh.set_target(piece_of_side(h, m_marks.count(e)), m_b.target(h));
    if(h.idx() % 2 == 0)
      for(size_type p = 0; p <= m_marks.count(e); ++p)
        set_parents(Edge_index(piece_of_side(h, p)), h);
  }

  void set_parents(Edge_index piece, Halfedge_index h)
  {
    m_result.m_parent_edge[1][piece] = Edge_index(h);
    for(std::size_t family = 0; family < 2; ++family)
      if(m_marks.count(family, Edge_index(h)) == 0)
        m_result.m_parent_edge[2 * family][piece] = Edge_index(m_marks.spoke(family, h));
  }

  // ---- Faces ----

  void add_face(Face_index f)
  {
    m_chords.set_face(f);
    m_linked.clear();
    add_crossings(f);
    add_pieces();
    for(std::size_t s = 0; s < 3; ++s) {
      link_side(s);
      link_corner(s);
      set_places_on_side(f, s);
    }
    for(std::size_t x = 0; x < m_chords.crossings().size(); ++x)
      link_crossing(x);
    for(const auto& [h, face_of_A] : m_linked)
      if(m_mesh.face(h) == m_mesh.null_face())
        add_face_of(h, {face_of_A, f, m_result.m_place_on_C[h].first});
  }

  void add_crossings(Face_index f)
  {
    m_first_crossing = m_mesh.num_vertices();
    const auto& crossings = m_chords.crossings();
    for(std::size_t x = 0; x < crossings.size(); ++x) {
      const auto& chord = m_chords[crossings[x].earlier];
      m_result.m_place_on_B[m_mesh.add_vertex()] = {
        f, internal::between(chord.place[0], chord.place[1], m_chords.places(x)[0])};
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
        const Halfedge_index h = m_mesh.add_edge();
        m_mesh.set_target(opposite(h), v);
        v = i < crossings.number_on(c) ? crossing_vertex(crossings.on(c, i)) : chord.vertex[1];
        m_mesh.set_target(h, v);
        m_result.m_parent_edge[2 * chord.family][m_mesh.edge(h)] = Edge_index(chord.along);
      }
    }
  }

  // At the target of `in`, `out` is the next halfedge around the face on their left.
  void link(Halfedge_index in, Halfedge_index out, const Place& place)
  {
    m_mesh.set_next(in, out);
    m_result.m_place_on_A[m_mesh.target(in)] = place[0];
    m_result.m_place_on_C[in] = place[1];
    m_linked.push_back({in, place[0].first});
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
      place[k] = internal::location_on_edge(opposite(mark.across), reversed(mark.weight), mesh);
      link(piece_of_side(h, p), inward, place);
      place[k] = internal::location_on_edge(mark.across, mark.weight, mesh);
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
      place[k] = internal::location_of_source<FT>(m_marks.spoke(k, after), m_marks.mesh(k));
    for(std::size_t i = m_chords.number_at_corner(s); i-- > 0;) {
      const Chord_end& end = m_chords.end_at_corner(s, i);
      const auto& chord = m_chords[end.chord];
      const Halfedge_index inward = first_piece_from(end);
      link(opposite(inward), out, place);
      out = inward;
      place[chord.family] = internal::location_of_source<FT>(
        end.is_first ? chord.along : opposite(chord.along), m_marks.mesh(chord.family));
    }
    link(piece_of_side(before, m_chords.marks((s + 2) % 3).size()), out, place);
  }

  void set_places_on_side(Face_index f, std::size_t s)
  {
    using Intrinsic_triangulations::barycentric_coordinates;
    m_result.m_place_on_B[m_b.source(m_chords.sides()[s])] = {f, barycentric_coordinates(s, FT(0))};
    for(const Mark& mark : m_chords.marks(s))
      m_result.m_place_on_B[mark.vertex] = {f, barycentric_coordinates(s, mark.here)};
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
  Face_location<FT> place_on_chord(std::size_t c, const FT& t, bool is_left) const
  {
    const auto& chord = m_chords[c];
    const Delta_complex& mesh = m_marks.mesh(chord.family);
    const auto weight = internal::between(chord.weight[0], chord.weight[1], t);
    return is_left ? internal::location_on_edge(chord.along, weight, mesh)
                   : internal::location_on_edge(opposite(chord.along), reversed(weight), mesh);
  }

  static std::array<FT, 2> reversed(const std::array<FT, 2>& weight)
  {
    return {weight[1], weight[0]};
  }

  void add_face_of(Halfedge_index first, const std::array<Face_index, 3>& parent)
  {
    const Face_index f = m_mesh.add_face();
    m_mesh.set_halfedge(f, first);
    for(std::size_t layer = 0; layer < 3; ++layer)
      m_result.m_parent_face[layer][f] = parent[layer];
    Halfedge_index h = first;
    do {
      m_mesh.set_face(h, f);
      h = m_mesh.next(h);
    } while(h != first);
  }

  // edges on the boundary have no marks, hence are one piece each
  void link_border()
  {
    for(Halfedge_index h : m_b.halfedges())
      if(m_b.is_border(h))
        m_mesh.set_next(piece_of_side(h, 0), piece_of_side(m_b.next(h), 0));
  }

  void link_vertices()
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h) || m_mesh.is_isolated(m_mesh.target(h)))
        m_mesh.set_halfedge(m_mesh.target(h), h);
  }

  const internal::Edge_marks<FT>& m_marks;
  const Delta_complex& m_b;
  internal::Face_chords<FT> m_chords; // of the face at hand, as all that follows
  std::vector<size_type> m_first_piece;
  std::vector<std::pair<Halfedge_index, Face_index>> m_linked; // and the face of A on its left
  size_type m_first_crossing = 0;
  Triple_subdivision& m_result;
  Mesh& m_mesh;
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
