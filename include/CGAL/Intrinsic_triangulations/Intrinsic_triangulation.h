// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Vertex_spokes.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/flip_to_shared.h>
#include <CGAL/Intrinsic_triangulations/internal/input/copy_input.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// whether points inside faces have distances in this geometry, so that vertices can be inserted
template <typename Traits, typename = void>
struct Has_distance : std::false_type
{};

template <typename Traits>
struct Has_distance<Traits, std::void_t<decltype(std::declval<Traits>().compute_distance_object())>>
  : std::true_type
{};

template <typename Traits>
class Input_splitter;

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// a triangulation \f$T_2\f$ of a surface that is given by an input triangulation \f$T_1\f$ with
/// edge lengths, and the correspondence between the two.
///
/// The edges of \f$T_2\f$ are geodesics on the surface of \f$T_1\f$. The class owns the
/// connectivity and edge lengths of both, and the integer coordinates (normal coordinates and
/// roundabouts) that say how the edges of \f$T_1\f$ run over \f$T_2\f$. Its operations keep them
/// consistent. \f$T_1\f$ never changes, and the mesh that it was made from is only read.
///
/// Vertices of both triangulations, and edges and faces of \f$T_1\f$, have the numbers of their
/// order in the ranges `vertices(g)`, `edges(g)`, `faces(g)` of the input; `halfedge(e, g)` becomes
/// halfedge
/// \f$2e\f$. Isolated vertices are kept. \f$T_2\f$ can have more vertices (Section 3.5), whose
/// places on
/// \f$T_1\f$ are kept too; they come after those of the input.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Intrinsic_triangulation
{
  typedef Intrinsic_triangulation Self;

public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of normal coordinates.
  typedef typename Traits::Integer Integer;
  /// the type of the integer coordinates.
  typedef Integer_coordinates<Integer> Coordinates;
  /// the type of numbers of elements.
  typedef Delta_complex::size_type size_type;
  /// the type of the maps of edge lengths.
  typedef Delta_complex::Property_map<Edge_index, FT> Edge_length_map;

  /// \name Construction
  /// @{

  /// creates a triangulation of the empty surface.
  Intrinsic_triangulation() { attach(); }

  /// creates the triangulation \f$T_2 = T_1\f$ of the surface of `g`.
  ///
  /// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`; a Delta-complex, with loops
  ///         and parallel edges, is welcome
  /// \tparam NamedParameters a sequence of named parameters
  /// \param g the input; every face a triangle, with or without boundary, of any genus and number
  ///        of components
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the positions of the vertices, whose distances are the edge lengths}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{edge_length_map}
  ///     \cgalParamDescription{the lengths of the edges themselves; no positions are needed then}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with value type convertible to `FT`}
  ///     \cgalParamDefault{unused}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{edge_is_constrained_map}
  ///     \cgalParamDescription{the edges that must stay in \f$T_2\f$}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
  ///     \cgalParamDefault{no edge is constrained}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{geom_traits}
  ///     \cgalParamDescription{an instance of the traits class}
  ///     \cgalParamDefault{`Traits()`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// Complexity: linear.
  /// \throws Invalid_input if a face is not a triangle, an edge has no face, a vertex has more than
  ///         one umbrella, a length is not positive and finite, or the triangle inequality fails in
  ///         a face
  template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Intrinsic_triangulation(const Graph& g,
                                   const NamedParameters& np = CGAL::parameters::default_values())
    : m_traits(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits), Traits()))
  {
    m_input.resize(internal::size_of(vertices(g)), internal::size_of(edges(g)),
                   internal::size_of(faces(g)));
    m_input_length = add_length_map(m_input);
    internal::with_numbering(g, [&](const auto& numbering) {
      internal::copy_connectivity(g, numbering, m_input);
      copy_lengths(g, numbering, np);
    });
    m_mesh = m_input;
    attach();
    m_spokes = Vertex_spokes(m_input, m_coordinates.roundabout_map());
    internal::with_numbering(g, [&](const auto& numbering) { copy_constraints(g, numbering, np); });
  }

  /// creates the triangulation from \f$T_1\f$ and \f$T_2\f$ as a file has them: `input` has the
  /// property map "e:length", `mesh` has this map and "e:normal_coordinate", "h:roundabout",
  /// "e:is_constrained", and `inserted` has the places of the vertices that only `mesh` has, in
  /// their order. Complexity: linear in the elements and crossings.
  /// \throws Invalid_input if they do not fit together.
  Intrinsic_triangulation(Delta_complex input, Delta_complex mesh,
                          std::vector<Inserted_vertex<FT>> inserted = {},
                          const Traits& traits = Traits())
    : m_traits(traits),
      m_input(std::move(input)),
      m_mesh(std::move(mesh)),
      m_inserted(std::move(inserted))
  {
    attach();
    for(const Delta_complex* complex : {&m_input, &m_mesh})
      if(!is_valid_Delta_complex(*complex))
        throw Invalid_input(internal::Delta_complex_defect(*complex));
    m_spokes = Vertex_spokes(m_input, boost::dummy_property_map());
    for(Edge_index e : m_input.edges())
      check_length(e);
    check_inserted();
    number_inserted_spokes();
    check_triangles(m_input, m_input_length);
    check_triangles(m_mesh, m_length);
    const std::string defect = this->defect();
    if(!defect.empty())
      throw Invalid_input(defect);
  }

  /// copies everything. Complexity: linear.
  Intrinsic_triangulation(const Self& other)
    : m_traits(other.m_traits),
      m_input(other.m_input),
      m_spokes(other.m_spokes),
      m_mesh(other.m_mesh),
      m_inserted(other.m_inserted)
  {
    attach();
  }

  /// moves everything; of `other` only assignment and destruction are left. Complexity: constant.
  Intrinsic_triangulation(Self&& other) noexcept = default;
  /// moves everything; of `other` only assignment and destruction are left.
  Self& operator=(Self&& other) noexcept = default;
  /// copies everything. Complexity: linear.
  Self& operator=(const Self& other) { return *this = Self(other); }

  /// @}
  /// \name Access
  /// @{

  /// the connectivity of \f$T_1\f$.
  const Delta_complex& input_mesh() const { return m_input; }

  /// the connectivity of \f$T_2\f$.
  const Delta_complex& mesh() const { return m_mesh; }

  /// the length of the edge `e` of \f$T_1\f$.
  const FT& input_length(Edge_index e) const { return m_input_length[e]; }

  /// the length of the edge `e` of \f$T_2\f$.
  const FT& length(Edge_index e) const { return m_length[e]; }

  /// the edge lengths of \f$T_1\f$.
  const Edge_length_map& input_length_map() const { return m_input_length; }
  /// the edge lengths of \f$T_2\f$.
  const Edge_length_map& length_map() const { return m_length; }

  /// the spokes of \f$T_1\f$.
  const Vertex_spokes& spokes() const { return m_spokes; }

  /// the integer coordinates of \f$T_2\f$.
  const Coordinates& coordinates() const { return m_coordinates; }

  /// whether the edge `e` of \f$T_2\f$ must not be flipped.
  bool is_constrained(Edge_index e) const { return m_is_constrained[e]; }

  /// the geometry.
  const Traits& traits() const { return m_traits; }

  /// @}
  /// \name Flipping
  /// @{

  /// whether the edge of `h` is not constrained, lies in two faces, and their union is strictly
  /// convex, so that `flip()` gives a triangulation of the surface again.
  bool is_flippable(Halfedge_index h) const
  {
    return can_be_turned(h) && m_traits.is_convex_object()(diamond(m_length, h, m_mesh));
  }

  /// whether the edge `e` of \f$T_2\f$ satisfies the local Delaunay condition (Equation 2.6), or is
  /// constrained, or has not two faces. Decision: exact for exact traits, filtered for floating
  /// point.
  bool is_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return m_traits.is_locally_Delaunay_object()(diamond(m_length, h, m_mesh)) || !can_be_turned(h);
  }

  /// turns the edge of `h` counterclockwise into the other diagonal of its two faces (see
  /// `flip_edge()`) and updates its length and integer coordinates. The coordinates are exact, and
  /// an edge that is in
  /// \f$T_1\f$ too has its length there, to the bit. Complexity: constant; no
  /// memory is allocated.
  /// \throws Numerical_error if the new length is not positive and finite
  /// \throws Overflow_error if the new normal coordinate is out of range
  /// After an exception nothing has changed.
  /// \pre `is_flippable(h)`, or the edge of `h` is not Delaunay
  void flip(Halfedge_index h)
  {
    CGAL_precondition(can_be_turned(h));
    const FT length = m_traits.compute_flipped_length_object()(diamond(m_length, h, m_mesh));
    if(!m_traits.is_length_object()(length))
      throw Numerical_error("flipping edge " + std::to_string(m_mesh.edge(h).idx()) +
                            " gives no positive finite length");
    m_coordinates.flip(h, m_mesh, m_spokes);
    const Edge_index e = m_mesh.edge(h);
    m_length[e] = m_coordinates.is_shared(e) ? shared_length(h) : length;
  }

  /// computes the length of every edge of \f$T_2\f$ afresh, from the lengths of \f$T_1\f$ in the
  /// strip of triangles that the edge passes. Where many flips have let rounding add up, this takes
  /// it away: the strips are known exactly. Complexity: linear in the edges and crossings.
  /// \throws Numerical_error if a length is not positive and finite
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  /// After an exception nothing has changed.
  void recompute_lengths()
  {
    const internal::Input_crossings crossings(m_coordinates, m_mesh, m_spokes);
    std::vector<FT> lengths(m_mesh.num_edges());
    typename Traits::Geodesic_strip strip;
    for(Edge_index e : m_mesh.edges()) {
      const Halfedge_index h(2 * e.idx());
      const auto exit = [&](std::size_t m) { return m_input.opposite(crossings(e, m)); };
      lengths[e] = m_coordinates.is_shared(e) ? shared_length(h)
                   : crossings.count(e) == 0
                     ? distance_from_inserted(input_location(h), input_location(m_mesh.opposite(h)))
                     : lay_out(strip, h, exit, crossings.count(e));
      if(!m_traits.is_length_object()(lengths[e]))
        throw Numerical_error("the strip of edge " + std::to_string(e.idx()) +
                              " has no positive finite length");
    }
    for(Edge_index e : m_mesh.edges())
      m_length[e] = lengths[e];
  }

  /// turns \f$T_2\f$ back into \f$T_1\f$ by flips that follow the integer coordinates alone
  /// (Mosher's algorithm, Algorithm 4). Constraints stay, for they are on edges of \f$T_1\f$.
  /// Complexity: finite; in practice below the number of crossings.
  /// \returns the number of flips
  /// \throws Overflow_error if a normal coordinate on the way is out of range; nothing has changed
  ///   then.
  /// \pre no vertex has been inserted
  std::size_t flip_to_input()
  {
    CGAL_precondition(number_of_inserted_vertices() == 0);
    Self result(*this);
    const std::size_t flips =
      internal::flip_to_shared(result.m_coordinates, result.m_mesh, result.m_spokes);
    for(Edge_index e : result.m_mesh.edges())
      result.m_length[e] = result.shared_length(result.m_mesh.halfedge(e));
    *this = std::move(result);
    return flips;
  }

  /// @}
  /// \name Inserted Vertices
  /// Section 3.5. `Vertex_inserter` calls these operations with the right arguments. Vertices can
  /// be inserted if `Traits` is a model of `IntrinsicGeometryTraitsWithDistance`.
  /// @{

  /// the number of vertices that only \f$T_2\f$ has.
  size_type number_of_inserted_vertices() const
  {
    return m_mesh.number_of_vertices() - m_input.number_of_vertices();
  }

  /// whether `v` is a vertex of \f$T_2\f$ only.
  bool is_inserted(Vertex_index v) const { return v.idx() >= m_input.number_of_vertices(); }

  /// where the inserted vertex `v` lies on \f$T_1\f$. \pre `is_inserted(v)`
  const Inserted_vertex<FT>& inserted_vertex(Vertex_index v) const
  {
    return m_inserted[v.idx() - m_input.number_of_vertices()];
  }

  /// inserts a vertex into a face of \f$T_2\f$ and joins it to the corners (see
  /// `Integer_coordinates::split_face()`). Complexity: constant.
  /// \param p the point on \f$T_2\f$
  /// \param at the integer coordinates of the edges from the new vertex to the corners of the face,
  ///        in the order of the coordinates of `p`
  /// \param q the same point on \f$T_1\f$
  /// \returns the new vertex
  /// \throws Numerical_error if an edge has no positive finite length
  /// \throws Overflow_error if a normal coordinate is out of range
  /// After an exception nothing has changed.
  Vertex_index split_face(const Face_location<FT>& p, const Face_split<Integer>& at,
                          const Inserted_vertex<FT>& q)
  {
    const auto side = sides(p.first, m_mesh);
    std::array<FT, 3> spoke_length;
    for(std::size_t s = 0; s < 3; ++s)
      spoke_length[s] = at.n[s] < 0 ? shared_length(q, at.r[s], m_mesh.source(side[s]))
                                    : checked_length(distance_to_corner(side[0], p.second, s));
    const Vertex_index m =
      m_coordinates.split_face(side[0], at, first_inserted_spoke(q.along), m_mesh, m_spokes);
    set_inserted(m, q);
    for(std::size_t s = 0; s < 3; ++s)
      set_edge(m_mesh.prev(side[s]), spoke_length[s], false);
    return m;
  }

  /// inserts a vertex \f$m\f$ into the edge \f$ij\f$ of `h` in \f$T_2\f$ (see
  /// `Integer_coordinates::split_edge()`). The parts of a shared edge have the lengths of those
  /// parts of the edge of \f$T_1\f$; both parts of a constrained edge are constrained. Complexity:
  /// constant.
  /// \param h the halfedge from \f$i\f$ to \f$j\f$; afterwards it leads from \f$m\f$ to \f$j\f$
  /// \param t the place of \f$m\f$ on it, between 0 and 1
  /// \param n the normal coordinates of the new edges
  /// \param r the roundabouts of the halfedges from \f$m\f$ along these edges
  /// \param q the place of \f$m\f$ on \f$T_1\f$; that of `place_on_shared()` if the edge is shared
  /// \returns \f$m\f$
  /// \throws Numerical_error if an edge has no positive finite length
  /// \throws Overflow_error if a normal coordinate is out of range
  /// After an exception nothing has changed.
  /// \pre the two sides of the edge are not in one face
  Vertex_index split_edge(Halfedge_index h, const FT& t, const Edge_split<Integer>& n,
                          const Edge_split<size_type>& r, const Inserted_vertex<FT>& q)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const Edge_index e = m_mesh.edge(h);
    const bool was_constrained = m_is_constrained[e];
    const Vertex_index i = m_mesh.source(h), j = m_mesh.target(h);
    const Edge_split<FT> length{
      n.im < 0 ? shared_length(q, r.im, i) : checked_length(t * m_length[e]),
      n.mj < 0 ? shared_length(q, r.mj, j) : checked_length((1 - t) * m_length[e]),
      n.mk < 0 ? shared_length(q, r.mk, apex(h)) : distance_to_apex(h, t),
      n.ml < 0 ? shared_length(q, r.ml, apex(o)) : distance_to_apex(o, 1 - t)};
    const Vertex_index m =
      m_coordinates.split_edge(h, n, r, first_inserted_spoke(q.along), m_mesh, m_spokes);
    set_inserted(m, q);
    const Halfedge_index im = first_part(h);
    set_edge(im, length.im, was_constrained);
    set_edge(h, length.mj, was_constrained);
    if(!m_mesh.is_border(im))
      set_edge(m_mesh.next(im), length.mk, false);
    if(!m_mesh.is_border(o))
      set_edge(m_mesh.next(o), length.ml, false);
    return m;
  }

  /// the first part of an edge that has been split, of which `h` is the second part.
  Halfedge_index first_part(Halfedge_index h) const
  {
    return m_mesh.prev(m_mesh.is_border(h) ? h : m_mesh.opposite(m_mesh.prev(h)));
  }

  /// the place on \f$T_1\f$ of the point at `t` on the halfedge `h` of \f$T_2\f$.
  /// \pre the edge of `h` is shared and \f$0 < t < 1\f$
  /// \throws Numerical_error if there is no number between the places of its ends
  Inserted_vertex<FT> place_on_shared(Halfedge_index h, const FT& t) const
  {
    const Edge_point<FT> start = start_on_spoke(h), end = start_on_spoke(m_mesh.opposite(h));
    const Edge_point<FT> p{start.halfedge, start.t + t * (1 - end.t - start.t)};
    if(!(start.t < p.t && p.t < 1 - end.t))
      throw Numerical_error("no place is left on edge " + std::to_string(m_mesh.edge(h).idx()));
    const Edge_point<FT> inside = m_input.is_border(p.halfedge) ? reversed(p, m_input) : p;
    return {inside.halfedge, face_location(inside, m_input)};
  }

  /// the number of the spoke `spoke` at a vertex inserted on its edge.
  size_type number_of_inserted_spoke(Halfedge_index spoke) const
  {
    return first_inserted_spoke(spoke) == spoke ? 0 : 1;
  }

  /// removes an inserted vertex that three edges, or on the boundary two faces, are left at (see
  /// `remove_degree_3_vertex()`). If it lies on an edge of \f$T_1\f$ and both parts are edges of
  /// \f$T_2\f$, the edge in their place is shared again. The elements are marked as removed, see
  /// `collect_garbage()`. Complexity: constant.
  /// \returns the face that takes the place
  /// \pre `is_inserted(v)`, and `removal_status(v, mesh()) == Operation_status::possible`
  Face_index remove_degree_3_vertex(Vertex_index v)
  {
    const Merged_edge merged = merged_edge(v);
    const Face_index f = Intrinsic_triangulations::remove_degree_3_vertex(v, m_mesh);
    if(merged.side.is_valid()) {
      m_coordinates.set_shared(merged.side, merged.r_source, merged.r_target);
      set_edge(merged.side, shared_length(merged.side), merged.is_constrained);
    }
    return f;
  }

  /// gives the elements of \f$T_2\f$ consecutive numbers again after vertices have been removed;
  /// those of the input keep theirs. Complexity: linear.
  void collect_garbage()
  {
    typedef Inserted_vertex<FT> Place;
    auto place = m_mesh.template add_property_map<Vertex_index, Place>("v:inserted", Place()).first;
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        place[v] = inserted_vertex(v);
    m_mesh.collect_garbage();
    m_inserted.clear();
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        m_inserted.push_back(place[v]);
    m_mesh.remove_property_map(place);
    number_inserted_spokes();
  }

  /// @}
  /// \name Correspondence
  /// @{

  /// the distance of two points of one face of \f$T_1\f$; `Traits` is a model of
  /// `IntrinsicGeometryTraitsWithDistance`. \pre `p.first == q.first`
  FT distance(const Face_location<FT>& p, const Face_location<FT>& q) const
  {
    return m_traits.compute_distance_object()(
      side_lengths(m_input.halfedge(p.first), m_input, m_input_length), p.second, q.second);
  }

  /// the place of the source of the halfedge `h` of \f$T_2\f$ on `input_spoke_before(h)`, if that
  /// is not null.
  Edge_point<FT> start_on_spoke(Halfedge_index h) const
  {
    const Halfedge_index spoke = input_spoke_before(h);
    return {spoke, spoke.is_valid() ? place_along(spoke, m_mesh.source(h)) : FT(0)};
  }

  /// the place of the vertex `v` of \f$T_2\f$ on the halfedge `input` of \f$T_1\f$, whose source it
  /// is unless it has been inserted. \pre it lies on the edge of `input`
  FT place_along(Halfedge_index input, Vertex_index v) const
  {
    if(!is_inserted(v))
      return FT(0);
    const Inserted_vertex<FT>& m = inserted_vertex(v);
    const FT t = edge_point(m.along, m.location, m_input).t;
    return input == m.along ? t : FT(1 - t);
  }

  /// the place of the vertex `v` of \f$T_2\f$ in a face of \f$T_1\f$: in that of `at.halfedge`,
  /// which contains `v`, unless `v` lies inside a face. If `v` is a vertex of \f$T_1\f$, its place
  /// is `at`.
  Face_location<FT> input_location(Vertex_index v, const Edge_point<FT>& at) const
  {
    if(!is_inserted(v))
      return face_location(at, m_input);
    if(!inserted_vertex(v).along.is_valid())
      return inserted_vertex(v).location;
    return face_location(Edge_point<FT>{at.halfedge, place_along(at.halfedge, v)}, m_input);
  }

  /// the place of the source of the halfedge `h` of \f$T_2\f$ in the face of \f$T_1\f$ into which
  /// `h` leads, or which lies on its left if its edge is shared. \pre `h` is no border halfedge
  Face_location<FT> input_location(Halfedge_index h) const
  {
    return input_location(m_mesh.source(h), {input_spoke_before(h), FT(0)});
  }

  /// lays out the triangles of \f$T_1\f$ through which the halfedge `h` of \f$T_2\f$ runs.
  /// \param strip the strip to be laid out
  /// \param h the halfedge
  /// \param exit a function: exit(m) is the halfedge of \f$T_1\f$ through which `h` leaves a face
  ///        as its number m
  /// \param n the number of crossings, positive
  /// \returns the length of `h`
  template <typename Exit>
  FT lay_out(typename Traits::Geodesic_strip& strip, Halfedge_index h, const Exit& exit,
             std::size_t n) const
  {
    if constexpr(internal::Has_distance<Traits>::value)
      internal::lay_out_strip(
        strip, m_input, m_input_length, exit, n,
        std::make_pair(
          coordinates_beyond(exit(0), input_location(h)),
          coordinates_beyond(m_input.opposite(exit(n - 1)), input_location(m_mesh.opposite(h)))));
    else
      internal::lay_out_strip(strip, m_input, m_input_length, exit, n);
    return strip.length();
  }

  /// the halfedge of \f$T_1\f$ that coincides with the halfedge `h` of \f$T_2\f$.
  /// \pre the edge of `h` is shared
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    return m_coordinates.shared_halfedge(h, m_mesh, m_spokes);
  }

  /// the last spoke of \f$T_1\f$ at or clockwise from the halfedge `h` of \f$T_2\f$ around its
  /// source; null if the source lies inside a face of \f$T_1\f$.
  Halfedge_index input_spoke_before(Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.source(h);
    if(m_spokes.degree(v) == 0)
      return Delta_complex::null_halfedge();
    const size_type r = m_coordinates.roundabout(h);
    if(m_coordinates.is_shared(m_mesh.edge(h)))
      return m_spokes.halfedge(v, r);
    return m_spokes.halfedge(v, (r == 0 ? m_spokes.degree(v) : r) - 1);
  }

  /// checks everything: connectivity, lengths, integer coordinates, and that every edge of
  /// \f$T_1\f$ runs over \f$T_2\f$ to its other end. Complexity: linear in the elements and
  /// crossings.
  bool is_valid(bool verbose = false) const
  {
    std::string defect = internal::Delta_complex_defect(m_mesh);
    if(defect.empty())
      defect = this->defect();
    if(verbose && !defect.empty())
      std::cerr << defect << '\n';
    return defect.empty();
  }

  /// @}

private:
  friend class internal::Input_splitter<Traits>;

  static Edge_length_map add_length_map(Delta_complex& mesh)
  {
    return mesh.template add_property_map<Edge_index, FT>("e:length", FT(0)).first;
  }

  // (re)binds the property maps to the meshes
  void attach()
  {
    m_input_length = add_length_map(m_input);
    m_length = add_length_map(m_mesh);
    m_coordinates = Coordinates(m_mesh);
    m_is_constrained =
      m_mesh.template add_property_map<Edge_index, bool>("e:is_constrained", false).first;
  }

  bool can_be_turned(Halfedge_index h) const
  {
    return flip_status(h, m_mesh) == Operation_status::possible && !is_constrained(m_mesh.edge(h));
  }

  // the length of an edge that lies along one of T1
  FT shared_length(Halfedge_index h) const
  {
    return part_length(start_on_spoke(h), start_on_spoke(m_mesh.opposite(h)));
  }

  // the length of such an edge from a new vertex at `m` to the vertex `v`, along spoke `r` of the
  // new one
  FT shared_length(const Inserted_vertex<FT>& m, size_type r, Vertex_index v) const
  {
    const Halfedge_index first = first_inserted_spoke(m.along);
    const Halfedge_index spoke = r == 0 ? first : m_input.opposite(first);
    const FT t = edge_point(m.along, m.location, m_input).t;
    const Halfedge_index back = m_input.opposite(spoke);
    return checked_length(
      part_length({spoke, spoke == m.along ? t : FT(1 - t)}, {back, place_along(back, v)}));
  }

  // The length of the part of an edge of T1 between two points, one seen from each of its ends. It
  // is the same to the bit from both sides.
  FT part_length(const Edge_point<FT>& start, const Edge_point<FT>& end) const
  {
    const bool is_even = start.halfedge.idx() % 2 == 0;
    const FT &first = is_even ? start.t : end.t, &last = is_even ? end.t : start.t;
    const FT& length = m_input_length[m_input.edge(start.halfedge)];
    return first == 0 && last == 0 ? length : FT((1 - last - first) * length);
  }

  // of the corner opposite to `h`; null beyond the boundary
  Vertex_index apex(Halfedge_index h) const
  {
    return m_mesh.is_border(h) ? Delta_complex::null_vertex() : m_mesh.target(m_mesh.next(h));
  }

  static std::array<FT, 3> side_lengths(Halfedge_index h, const Delta_complex& mesh,
                                        const Edge_length_map& length)
  {
    return {length[mesh.edge(h)], length[mesh.edge(mesh.next(h))], length[mesh.edge(mesh.prev(h))]};
  }

  // in the face of `h` in T2, whose corner 0 is the source of `h`
  FT distance_to_corner(Halfedge_index h, const std::array<FT, 3>& p, std::size_t corner) const
  {
    return m_traits.compute_distance_object()(side_lengths(h, m_mesh, m_length), p,
                                              barycentric_coordinates(corner, FT(0)));
  }

  // the distance from the point at `t` on `h` to the opposite corner, 0 beyond the boundary
  FT distance_to_apex(Halfedge_index h, const FT& t) const
  {
    if(m_mesh.is_border(h))
      return FT(0);
    return checked_length(distance_to_corner(h, barycentric_coordinates(0, t), 2));
  }

  // the coordinates of a point of the face of `side` in T1, that of the corner opposite to `side`
  // first
  std::array<FT, 3> coordinates_beyond(Halfedge_index side, const Face_location<FT>& p) const
  {
    return coordinates_from(m_input.prev(side), p, m_input);
  }

  // A distance that is asked for only if vertices have been inserted; otherwise 0, which is no
  // length.
  FT distance_from_inserted([[maybe_unused]] const Face_location<FT>& p,
                            [[maybe_unused]] const Face_location<FT>& q) const
  {
    if constexpr(internal::Has_distance<Traits>::value)
      return distance(p, q);
    else
      return FT(0);
  }

  FT checked_length(const FT& length) const
  {
    if(!m_traits.is_length_object()(length))
      throw Numerical_error("an edge at an inserted vertex has no positive finite length");
    return length;
  }

  void set_edge(Halfedge_index h, const FT& length, bool is_constrained)
  {
    m_length[m_mesh.edge(h)] = length;
    m_is_constrained[m_mesh.edge(h)] = is_constrained;
  }

  void set_inserted(Vertex_index v, const Inserted_vertex<FT>& place)
  {
    const std::size_t i = v.idx() - m_input.number_of_vertices();
    if(i >= m_inserted.size())
      m_inserted.resize(i + 1);
    m_inserted[i] = place;
  }

  // The edge that takes the place of two at an inserted vertex which lie along one edge of T1.
  struct Merged_edge
  {
    Halfedge_index side; // null if there are no such two
    size_type r_source, r_target;
    bool is_constrained;
  };

  // \pre `v` has three spokes
  Merged_edge merged_edge(Vertex_index v) const
  {
    const Halfedge_index a = first_spoke(v, m_mesh);
    if(m_mesh.is_border(v))
      return merged_edge(next_spoke(next_spoke(a, m_mesh), m_mesh), a, a);
    Halfedge_index x = a;
    do {
      const Halfedge_index y = next_spoke(x, m_mesh);
      if(m_coordinates.is_shared(m_mesh.edge(x)) && m_coordinates.is_shared(m_mesh.edge(y)))
        return merged_edge(x, y, m_mesh.next(x));
      x = y;
    } while(x != a);
    return {};
  }

  // `side` will lead from the target of the spoke `x` to that of the spoke `y`
  Merged_edge merged_edge(Halfedge_index x, Halfedge_index y, Halfedge_index side) const
  {
    return {side, m_coordinates.roundabout(m_mesh.opposite(x)),
            m_coordinates.roundabout(m_mesh.opposite(y)),
            is_constrained(m_mesh.edge(x)) && is_constrained(m_mesh.edge(y))};
  }

  template <typename Graph, typename Numbering, typename NamedParameters>
  void copy_lengths(const Graph& g, const Numbering& numbering, const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    using CGAL::parameters::is_default_parameter;
    if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_length_map_t>::value) {
      const auto length = get_parameter(np, internal_np::edge_length_map);
      set_input_lengths(g, numbering, [&](auto e) { return FT(get(length, e)); });
      check_triangles(m_input, m_input_length);
    } else {
      const auto point = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, g));
      set_input_lengths(g, numbering, [&](auto e) {
        return internal::distance<FT>(get(point, source(e, g)), get(point, target(e, g)));
      });
    }
  }

  template <typename Graph, typename Numbering, typename Length>
  void set_input_lengths(const Graph& g, const Numbering& numbering, const Length& length)
  {
    for(auto e : edges(g)) {
      const Edge_index e_input = m_input.edge(numbering.halfedge_of(halfedge(e, g)));
      m_input_length[e_input] = length(e);
      check_length(e_input);
    }
  }

  template <typename Graph, typename Numbering, typename NamedParameters>
  void copy_constraints(const Graph& g, const Numbering& numbering, const NamedParameters& np)
  {
    using CGAL::parameters::get_parameter;
    using CGAL::parameters::is_default_parameter;
    typedef CGAL::internal_np::edge_is_constrained_t Tag;
    if constexpr(!is_default_parameter<NamedParameters, Tag>::value) {
      const auto is_constrained = get_parameter(np, CGAL::internal_np::edge_is_constrained);
      for(auto e : edges(g))
        m_is_constrained[m_mesh.edge(numbering.halfedge_of(halfedge(e, g)))] =
          get(is_constrained, e);
    }
  }

  [[noreturn]] void fail_at_length(Edge_index e) const
  {
    throw Invalid_input("the length of edge " + std::to_string(e.idx()) + " between vertices " +
                        std::to_string(m_input.vertex(e, 0).idx()) + " and " +
                        std::to_string(m_input.vertex(e, 1).idx()) +
                        " is zero, not finite, or beyond the range of its number type");
  }

  void check_length(Edge_index e) const
  {
    if(!m_traits.is_length_object()(m_input_length[e]))
      fail_at_length(e);
  }

  void check_triangles(const Delta_complex& mesh, const Edge_length_map& length_map) const
  {
    const auto is_triangle = m_traits.is_triangle_object();
    for(Face_index f : mesh.faces()) {
      const Halfedge_index h = mesh.halfedge(f);
      const auto length = [&](Halfedge_index x) { return length_map[mesh.edge(x)]; };
      if(!is_triangle(length(h), length(mesh.next(h)), length(mesh.prev(h))))
        throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()));
    }
  }

  // Whether the place of an inserted vertex makes sense by itself.
  bool is_valid_place(const Inserted_vertex<FT>& m) const
  {
    const auto& [f, p] = m.location;
    if(!f.is_valid() || !m_input.has_valid_index(f) || !(p[0] >= 0 && p[1] >= 0 && p[2] >= 0) ||
       CGAL::abs(p[0] + p[1] + p[2] - 1) > rounding_unit<FT>())
      return false;
    if(!m.along.is_valid())
      return true;
    return m_input.has_valid_index(m.along) && m_input.face(m.along) == f &&
           p[(side_number(m.along, m_input) + 2) % 3] == 0;
  }

  void check_inserted() const
  {
    if(!internal::Has_distance<Traits>::value && !m_inserted.empty())
      throw Invalid_input("vertices cannot be inserted in this geometry");
    for(std::size_t i = 0; i < m_inserted.size(); ++i)
      if(!is_valid_place(m_inserted[i]))
        throw Invalid_input("inserted vertex " + std::to_string(i) + " has no place in the input");
    if(m_mesh.num_vertices() != m_input.num_vertices() + m_inserted.size())
      throw Invalid_input("the numbers of vertices and of places do not fit");
  }

  // The first of the spokes of an inserted vertex follows from the boundary, or from the parity.
  void number_inserted_spokes()
  {
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        m_spokes.set_inserted(v, first_inserted_spoke(inserted_vertex(v).along));
  }

  Halfedge_index first_inserted_spoke(Halfedge_index along) const
  {
    return along.is_valid()
             ? internal::first_inserted_spoke(along, m_input.is_border(along),
                                              m_input.is_border(m_input.opposite(along)))
             : along;
  }

  static std::ptrdiff_t Euler_characteristic(const Delta_complex& mesh)
  {
    return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) +
           std::ptrdiff_t(mesh.number_of_faces());
  }

  // What is wrong between the two valid complexes, empty if nothing is.
  std::string defect() const
  {
    if(m_mesh.num_vertices() != m_input.num_vertices() + m_inserted.size() ||
       Euler_characteristic(m_mesh) != Euler_characteristic(m_input))
      return "the two triangulations differ in their numbers of elements";
    for(Edge_index e : m_mesh.edges()) {
      if(!m_traits.is_length_object()(m_length[e]))
        return "edge " + std::to_string(e.idx()) + " has no positive finite length";
      if(m_is_constrained[e] && !m_coordinates.is_shared(e))
        return "edge " + std::to_string(e.idx()) + " is constrained but not in the input";
    }
    if(!m_coordinates.is_valid(m_mesh, m_spokes))
      return "the integer coordinates contradict each other";
    for(Edge_index e : m_mesh.edges())
      if(m_coordinates.is_shared(e) && m_length[e] != shared_length(m_mesh.halfedge(e)))
        return "edge " + std::to_string(e.idx()) + " is in the input with another length";
    return internal::curve_defect(m_coordinates, m_mesh, m_input, m_spokes);
  }

  Traits m_traits;
  Delta_complex m_input; // T1
  Edge_length_map m_input_length;
  Vertex_spokes m_spokes;
  Delta_complex m_mesh; // T2
  Edge_length_map m_length;
  Coordinates m_coordinates;
  Delta_complex::Property_map<Edge_index, bool> m_is_constrained;
  std::vector<Inserted_vertex<FT>> m_inserted; // vertices of T2 after those of T1
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
