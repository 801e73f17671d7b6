// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_PAIR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_PAIR_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Part_of_input_edge.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template <typename Traits>
class Intrinsic_triangulation;

/// \ingroup PkgIntrinsicTriangulationsRef
/// two triangulations \f$T_1\f$ and \f$T_2\f$ of one surface, with connectivity and edge lengths
/// of both. Integer coordinates (normal coordinates and roundabouts) determine how the edges of
/// \f$T_1\f$ run over \f$T_2\f$. Vertices that only \f$T_2\f$ has are stored with their positions
/// on \f$T_1\f$. The operations that change \f$T_2\f$ are members of `Intrinsic_triangulation`.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
template <typename Traits_>
class Triangulation_pair
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of normal coordinates.
  typedef typename Traits::Integer Integer;
  /// the type of the integer coordinates.
  typedef Integer_coordinates<Integer> Coordinates;
  /// the type of numbers and indices of elements.
  typedef Delta_complex::size_type size_type;
  /// the type of the maps of edge lengths.
  typedef Delta_complex::Property_map<Edge_index, FT> Edge_length_map;
  /// the type of the exact metric of \f$T_1\f$: `Input_metric`. It is an empty class if the
  /// geometry is not Euclidean, or if numbers are exact themselves.
  typedef internal::Input_metric_of<Traits> Metric;

  /// \name The Two Surfaces
  /// @{

  /// returns \f$T_1\f$ as a model of `IntrinsicSurface`.
  Surface_view<Edge_length_map> input() const { return {m_input, m_input_length}; }
  /// returns \f$T_2\f$ as a model of `IntrinsicSurface`.
  Surface_view<Edge_length_map> intrinsic() const { return {m_mesh, m_length}; }
  /// returns one of the two as a model of `IntrinsicSurface`.
  Surface_view<Edge_length_map> surface(Side side) const
  {
    return side == Side::input ? input() : intrinsic();
  }

  /// returns the connectivity of \f$T_1\f$.
  const Delta_complex& input_mesh() const { return m_input; }
  /// returns the connectivity of \f$T_2\f$.
  const Delta_complex& mesh() const { return m_mesh; }

  /// returns the length of the edge `e` of \f$T_1\f$.
  const FT& input_length(Edge_index e) const { return m_input_length[e]; }
  /// returns the length of the edge `e` of \f$T_2\f$.
  const FT& length(Edge_index e) const { return m_length[e]; }

  /// returns the edge lengths of \f$T_1\f$.
  const Edge_length_map& input_length_map() const { return m_input_length; }
  /// returns the edge lengths of \f$T_2\f$.
  const Edge_length_map& length_map() const { return m_length; }

  /// returns the outgoing halfedges of \f$T_1\f$.
  const Outgoing_halfedges& outgoing_halfedges() const { return m_outgoing_halfedges; }

  /// returns the integer coordinates of \f$T_2\f$.
  const Coordinates& coordinates() const { return m_coordinates; }

  /// returns the number of edges of \f$T_1\f$ that the edge of `h` crosses.
  /// \throws Overflow_error if they are more than a `Surface_mesh` can number
  size_type number_of_crossings(Halfedge_index h) const
  {
    return internal::countable(m_coordinates.crossings(h));
  }

  /// returns whether the edge `e` of \f$T_2\f$ must not be flipped.
  bool is_constrained(Edge_index e) const { return m_is_constrained[e]; }

  /// returns the geometry.
  const Traits& traits() const { return m_traits; }

  /// returns the exact metric of \f$T_1\f$, on which exact decisions depend.
  const Metric& input_metric() const { return m_input_metric; }

  /// @}
  /// \name Inserted Vertices
  /// @{

  /// returns the number of vertices that only \f$T_2\f$ has.
  size_type number_of_inserted_vertices() const
  {
    return m_mesh.number_of_vertices() - m_input.number_of_vertices();
  }

  /// returns whether `v` is a vertex of \f$T_2\f$ only.
  bool is_inserted(Vertex_index v) const { return v.idx() >= m_input.number_of_vertices(); }

  /// returns the position of the inserted vertex `v` on \f$T_1\f$. \pre `is_inserted(v)`
  const Surface_point<FT>& inserted_vertex(Vertex_index v) const
  {
    return m_inserted[v.idx() - m_input.number_of_vertices()];
  }

  /// returns the positions of the inserted vertices on \f$T_1\f$, in the order of their indices.
  const std::vector<Surface_point<FT>>& inserted_vertices() const { return m_inserted; }

  /// returns the point of \f$T_1\f$ at `t` on the halfedge `h` of \f$T_2\f$.
  /// \pre the edge of `h` is shared and \f$0 < t < 1\f$
  /// \throws Numerical_error if the weights of its ends are adjacent numbers
  Edge_location<FT> point_on_shared(Halfedge_index h, const FT& t) const
  {
    if constexpr(internal::Is_exact<Traits>::value)
      return part_of_input_edge(h).point(t, m_input);
    const Edge_point<FT> start = start_on_outgoing(h), end = start_on_outgoing(m_mesh.opposite(h));
    const Edge_point<FT> p{start.halfedge, start.t + t * (1 - end.t - start.t)};
    if(!(start.t < p.t && p.t < 1 - end.t))
      throw Numerical_error("no position is left on edge " + std::to_string(m_mesh.edge(h).idx()));
    return edge_location(m_input.is_border(p.halfedge) ? reversed(p, m_input) : p);
  }

  /// returns the first of the two outgoing halfedges of a vertex inserted on the edge of `along`;
  /// null if `along` is null. It is the halfedge on the boundary, or the first halfedge of its
  /// edge.
  Halfedge_index first_inserted_outgoing(Halfedge_index along) const
  {
    return along.is_valid()
             ? internal::first_inserted_outgoing(along, m_input.is_border(along),
                                                 m_input.is_border(m_input.opposite(along)))
             : along;
  }

  /// returns the index of the outgoing halfedge `outgoing` at a vertex inserted on its edge.
  size_type number_of_inserted_outgoing(Halfedge_index outgoing) const
  {
    return first_inserted_outgoing(outgoing) == outgoing ? 0 : 1;
  }

  /// @}
  /// \name Correspondence
  /// @{

  /// returns the distance of two points of one face of \f$T_1\f$; `Traits` is a model of
  /// `IntrinsicGeometryTraitsWithDistance`. \pre `p.first == q.first`
  FT distance(const Face_location<FT>& p, const Face_location<FT>& q) const
  {
    return m_traits.compute_distance_object()(
      internal::side_lengths(m_input.halfedge(p.first), input()), p.second, q.second);
  }

  /// returns the position of the source of the halfedge `h` of \f$T_2\f$ on
  /// `input_outgoing_before(h)`, if that is not null.
  Edge_point<FT> start_on_outgoing(Halfedge_index h) const
  {
    const Halfedge_index outgoing = input_outgoing_before(h);
    return {outgoing, outgoing.is_valid() ? place_along(outgoing, m_mesh.source(h)) : FT(0)};
  }

  /// returns the position of the vertex `v` of \f$T_2\f$ on the halfedge `input` of \f$T_1\f$. `v`
  /// is its source unless it has been inserted.
  /// \pre it lies on the edge of `input`
  FT place_along(Halfedge_index input, Vertex_index v) const
  {
    return on_input_edge(input, v).weight[1];
  }

  /// returns the vertex `v` of \f$T_2\f$ as a point of the halfedge `input` of \f$T_1\f$, whose
  /// source it is unless it has been inserted. \pre it lies on the edge of `input`
  Edge_location<FT> on_input_edge(Halfedge_index input, Vertex_index v) const
  {
    if(!is_inserted(v))
      return {input, {FT(1), FT(0)}};
    const Edge_location<FT>& p = *on_edge(inserted_vertex(v));
    return p.halfedge == input ? p : reversed(p);
  }

  /// returns the position of the vertex `v` of \f$T_2\f$ in a face of \f$T_1\f$. This is the face
  /// of `at.halfedge`, which contains `v`, unless `v` lies inside a face. If `v` is a vertex of
  /// \f$T_1\f$, the result is `at`.
  Face_location<FT> input_location(Vertex_index v, const Edge_point<FT>& at) const
  {
    if(!is_inserted(v))
      return face_location(at, m_input);
    if(const auto* inside = std::get_if<Face_location<FT>>(&inserted_vertex(v)))
      return *inside;
    return face_location(Edge_point<FT>{at.halfedge, place_along(at.halfedge, v)}, m_input);
  }

  /// returns the position of the source of the halfedge `h` of \f$T_2\f$ in a face of \f$T_1\f$.
  /// `h` leads into this face, or the face lies on its left if its edge is shared.
  /// \pre `h` is not a border halfedge
  Face_location<FT> input_location(Halfedge_index h) const
  {
    return input_location(m_mesh.source(h), {input_outgoing_before(h), FT(0)});
  }

  /// lays out the triangles of \f$T_1\f$ through which the halfedge `h` of \f$T_2\f$ runs.
  /// \param strip the strip to be laid out: `Traits::Geodesic_strip`, or one with another number
  ///        type, to which lengths are converted
  /// \param h the halfedge
  /// \param exits the halfedges of \f$T_1\f$ through which `h` leaves faces, at least one: an
  ///        `Edge_course`, or another random access range
  /// \returns the length of `h`
  template <typename Strip, typename Exits>
  auto lay_out(Strip& strip, Halfedge_index h, const Exits& exits) const
  {
    if constexpr(internal::Has_distance<Traits>::value)
      internal::lay_out_strip(
        strip, input(), exits,
        std::make_pair(coordinates_beyond(exits[0], input_location(h)),
                       coordinates_beyond(m_input.opposite(exits[exits.size() - 1]),
                                          input_location(m_mesh.opposite(h)))));
    else
      internal::lay_out_strip_of(m_traits, strip, input(), exits);
    return strip.length();
  }

  /// returns the halfedge of \f$T_1\f$ that coincides with the halfedge `h` of \f$T_2\f$.
  /// \pre the edge of `h` is shared
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    return m_coordinates.shared_halfedge(h, m_mesh, m_outgoing_halfedges);
  }

  /// returns the last outgoing halfedge of \f$T_1\f$ at or clockwise from the halfedge `h` of
  /// \f$T_2\f$ around its source. It is null if the source lies inside a face of \f$T_1\f$.
  Halfedge_index input_outgoing_before(Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.source(h);
    if(m_outgoing_halfedges.degree(v) == 0)
      return m_mesh.null_halfedge();
    const size_type r = m_coordinates.roundabout(h);
    if(m_coordinates.is_shared(m_mesh.edge(h)))
      return m_outgoing_halfedges.halfedge(v, r);
    return m_outgoing_halfedges.halfedge(v, (r == 0 ? m_outgoing_halfedges.degree(v) : r) - 1);
  }

  /// returns the length of the part of an edge of \f$T_1\f$ between two points, `start` on one of
  /// its halfedges and `end` on the other. The result is bitwise equal from both sides.
  FT part_length(const Edge_point<FT>& start, const Edge_point<FT>& end) const
  {
    const bool is_first = is_first_halfedge(start.halfedge);
    const FT &first = is_first ? start.t : end.t, &last = is_first ? end.t : start.t;
    const FT& length = m_input_length[m_input.edge(start.halfedge)];
    return first == 0 && last == 0 ? length : FT((1 - last - first) * length);
  }

  /// returns the length that the edge of `h` in \f$T_2\f$ has on \f$T_1\f$.
  /// \pre the edge of `h` is shared
  FT shared_length(Halfedge_index h) const
  {
    if constexpr(internal::Is_exact<Traits>::value)
      return part_of_input_edge(h).length(m_input_length);
    return part_length(start_on_outgoing(h), start_on_outgoing(m_mesh.opposite(h)));
  }

  /// returns the part of an edge of \f$T_1\f$ that coincides with the halfedge `h` of \f$T_2\f$.
  /// Its length and its positions lose no digits, however near its ends are to each other.
  /// \pre the edge of `h` is shared; `FT` is `double`
  internal::Part_of_input_edge part_of_input_edge(Halfedge_index h) const
  {
    const Halfedge_index outgoing = input_outgoing_before(h);
    return {outgoing, on_input_edge(outgoing, m_mesh.source(h)).weight,
            reversed(on_input_edge(opposite(outgoing), m_mesh.target(h))).weight};
  }

  /// @}

private:
  friend class Intrinsic_triangulation<Traits>;

  explicit Triangulation_pair(const Traits& traits = Traits(), Delta_complex input = {},
                              Delta_complex mesh = {}, std::vector<Surface_point<FT>> inserted = {},
                              Metric metric = {})
    : m_traits(traits),
      m_input(std::move(input)),
      m_input_metric(std::move(metric)),
      m_mesh(std::move(mesh)),
      m_inserted(std::move(inserted))
  {
    attach();
  }

  Triangulation_pair(const Triangulation_pair& other)
    : m_traits(other.m_traits),
      m_input(other.m_input),
      m_input_metric(other.m_input_metric),
      m_outgoing_halfedges(other.m_outgoing_halfedges),
      m_mesh(other.m_mesh),
      m_inserted(other.m_inserted)
  {
    attach();
  }

  Triangulation_pair(Triangulation_pair&& other) = default;
  Triangulation_pair& operator=(Triangulation_pair&& other) = default;
  Triangulation_pair& operator=(const Triangulation_pair& other)
  {
    return *this = Triangulation_pair(other);
  }

  // Binds the property maps to the meshes.
  void attach()
  {
    m_input_length = stored_length_map<FT>(m_input);
    m_length = stored_length_map<FT>(m_mesh);
    m_coordinates = Coordinates(m_mesh);
    m_is_constrained = stored_constraint_map(m_mesh);
  }

  // Inserts a vertex whose new edges have the lengths `length`.
  Vertex_index insert_into_face(Face_index f, const Face_split<Integer>& at,
                                const Surface_point<FT>& q, const std::array<FT, 3>& length)
  {
    const auto side = sides(f, m_mesh);
    const Vertex_index m = m_coordinates.split_face(
      side[0], at, first_inserted_outgoing(halfedge_of(q)), m_mesh, m_outgoing_halfedges);
    set_inserted(m, q);
    for(std::size_t s = 0; s < 3; ++s)
      set_edge(m_mesh.prev(side[s]), length[s], false);
    return m;
  }

  Vertex_index insert_into_edge(Halfedge_index h, const Edge_split<Integer>& n,
                                const Edge_split<size_type>& r, const Surface_point<FT>& q,
                                const Edge_split<FT>& length)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const bool was_constrained = m_is_constrained[m_mesh.edge(h)];
    const Vertex_index m = m_coordinates.split_edge(
      h, n, r, first_inserted_outgoing(halfedge_of(q)), m_mesh, m_outgoing_halfedges);
    set_inserted(m, q);
    const Halfedge_index im = first_part(h, m_mesh);
    set_edge(im, length.im, was_constrained);
    set_edge(h, length.mj, was_constrained);
    if(!m_mesh.is_border(im))
      set_edge(m_mesh.next(im), length.mk, false);
    if(!m_mesh.is_border(o))
      set_edge(m_mesh.next(o), length.ml, false);
    return m;
  }

  // Returns a function that undoes the next insertion into the edge of `h`.
  auto undo_of_split(Halfedge_index h)
  {
    const auto first = [this](Halfedge_index x) {
      return m_mesh.is_border(x) ? x : m_mesh.halfedge(m_mesh.face(x));
    };
    const Edge_index e = m_mesh.edge(h);
    return [this, h, e, n = m_coordinates.normal_coordinate(e), length = FT(m_length[e]),
            firsts = std::array{first(h), first(m_mesh.opposite(h))}] {
      const size_type r = m_coordinates.roundabout(first_part(h, m_mesh));
      join_edge(h, m_mesh);
      for(Halfedge_index x : firsts)
        if(!m_mesh.is_border(x))
          m_mesh.set_halfedge(m_mesh.face(x), x);
      m_coordinates.set(e, n);
      m_coordinates.set(h, r);
      m_length[e] = length;
    };
  }

  void set_edge(Halfedge_index h, const FT& length, bool is_constrained)
  {
    m_length[m_mesh.edge(h)] = length;
    m_is_constrained[m_mesh.edge(h)] = is_constrained;
  }

  void set_inserted(Vertex_index v, const Surface_point<FT>& place)
  {
    const std::size_t i = v.idx() - m_input.number_of_vertices();
    m_inserted.resize((std::max)(m_inserted.size(), i + 1));
    m_inserted[i] = place;
  }

  // The first outgoing halfedge of an inserted vertex follows from the boundary, or from the
  // parity.
  void number_inserted_outgoing_halfedges()
  {
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        m_outgoing_halfedges.set_inserted(v,
                                          first_inserted_outgoing(halfedge_of(inserted_vertex(v))));
  }

  // Sets all lengths. If `length()` throws, nothing is changed.
  template <typename Length>
  void set_lengths(Length& length)
  {
    std::vector<FT> lengths(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      lengths[e] = length(first_halfedge(e));
    for(Edge_index e : m_mesh.edges())
      m_length[e] = lengths[e];
  }

  // Returns the coordinates of a point of the face of `side` in T1, beginning with the corner
  // opposite to `side`.
  std::array<FT, 3> coordinates_beyond(Halfedge_index side, const Face_location<FT>& p) const
  {
    return coordinates_from(m_input.prev(side), p, m_input);
  }

  Traits m_traits;
  Delta_complex m_input; // T1
  Edge_length_map m_input_length;
  Metric m_input_metric;
  Outgoing_halfedges m_outgoing_halfedges;
  Delta_complex m_mesh; // T2
  Edge_length_map m_length;
  Coordinates m_coordinates;
  Delta_complex::Property_map<Edge_index, bool> m_is_constrained;
  std::vector<Surface_point<FT>> m_inserted; // vertices of T2 after those of T1
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_PAIR_H
