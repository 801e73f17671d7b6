// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Vertex_spokes.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/Input_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/copy_input.h>
#include <CGAL/Intrinsic_triangulations/internal/flip_to_shared.h>
#include <CGAL/Intrinsic_triangulations/internal/lay_out_strip.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// a triangulation \f$T_2\f$ of a surface that is given by an input triangulation \f$T_1\f$ with edge
/// lengths, and the correspondence between the two.
///
/// The edges of \f$T_2\f$ are geodesics on the surface of \f$T_1\f$. The class owns the connectivity and
/// edge lengths of both, and the integer coordinates (normal coordinates and roundabouts) that say how
/// the edges of \f$T_1\f$ run over \f$T_2\f$. Its operations keep them consistent. \f$T_1\f$ never
/// changes, and the mesh that it was made from is only read.
///
/// Vertices of both triangulations, and edges and faces of \f$T_1\f$, have the numbers of their order in
/// the ranges `vertices(g)`, `edges(g)`, `faces(g)` of the input; `halfedge(e, g)` becomes halfedge
/// \f$2e\f$. Isolated vertices are kept.
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
  /// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`; a Delta-complex, with loops and
  ///         parallel edges, is welcome
  /// \tparam NamedParameters a sequence of named parameters
  /// \param g the input; every face a triangle, with or without boundary, of any genus and number of
  ///        components
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
  /// \throws Invalid_input if a face is not a triangle, an edge has no face, a vertex has more than one
  ///         umbrella, a length is not positive and finite, or the triangle inequality fails in a face
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

  /// creates the triangulation from \f$T_1\f$ and \f$T_2\f$ as a file has them: `input` has the property
  /// map "e:length", `mesh` has this map and "e:normal_coordinate", "h:roundabout", "e:is_constrained".
  /// Complexity: linear in the elements and crossings.
  /// \throws Invalid_input if the two do not fit together.
  Intrinsic_triangulation(Delta_complex input, Delta_complex mesh, const Traits& traits = Traits())
    : m_traits(traits), m_input(std::move(input)), m_mesh(std::move(mesh))
  {
    attach();
    for(const Delta_complex* complex : {&m_input, &m_mesh})
      if(!is_valid_Delta_complex(*complex))
        throw Invalid_input(internal::Delta_complex_defect(*complex));
    m_spokes = Vertex_spokes(m_input, boost::dummy_property_map());
    check_lengths();
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
      m_mesh(other.m_mesh)
  {
    attach();
  }

  /// moves everything; of `other` only assignment and destruction are left. Complexity: constant.
  Intrinsic_triangulation(Self&& other) = default;
  /// moves everything; of `other` only assignment and destruction are left.
  Self& operator=(Self&& other) = default;
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

  /// whether the edge of `h` is not constrained, lies in two faces, and their union is strictly convex,
  /// so that `flip()` gives a triangulation of the surface again.
  bool is_flippable(Halfedge_index h) const
  {
    return can_be_turned(h) && m_traits.is_convex_object()(diamond(m_length, h, m_mesh));
  }

  /// whether the edge `e` of \f$T_2\f$ satisfies the local Delaunay condition (Equation 2.6), or is
  /// constrained, or has not two faces. Decision: exact for exact traits, filtered for floating point.
  bool is_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return m_traits.is_locally_Delaunay_object()(diamond(m_length, h, m_mesh)) || !can_be_turned(h);
  }

  /// turns the edge of `h` counterclockwise into the other diagonal of its two faces (see `flip_edge()`)
  /// and updates its length and integer coordinates. The coordinates are exact, and an edge that is in
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
    m_length[e] = m_coordinates.is_shared(e) ? input_length_along(h) : length;
  }

  /// computes the length of every edge of \f$T_2\f$ afresh, from the lengths of \f$T_1\f$ in the strip of
  /// triangles that the edge passes. Where many flips have let rounding add up, this takes it away: the
  /// strips are known exactly. Complexity: linear in the edges and crossings.
  /// \throws Numerical_error if a length is not positive and finite
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  /// After an exception nothing has changed.
  void recompute_lengths()
  {
    const internal::Input_crossings crossings(m_coordinates, m_mesh, m_spokes);
    std::vector<FT> lengths(m_mesh.num_edges());
    typename Traits::Geodesic_strip strip;
    for(Edge_index e : m_mesh.edges()) {
      lengths[e] = m_length[e];
      if(crossings.count(e) == 0)
        continue;
      const auto exit = [&](std::size_t m) { return m_input.opposite(crossings(e, m)); };
      internal::lay_out_strip(strip, m_input, m_input_length, exit, crossings.count(e));
      lengths[e] = strip.length();
      if(!m_traits.is_length_object()(lengths[e]))
        throw Numerical_error("the strip of edge " + std::to_string(e.idx()) +
                              " has no positive finite length");
    }
    for(Edge_index e : m_mesh.edges())
      m_length[e] = lengths[e];
  }

  /// turns \f$T_2\f$ back into \f$T_1\f$ by flips that follow the integer coordinates alone (Mosher's
  /// algorithm, Algorithm 4). Constraints stay, for they are on edges of \f$T_1\f$.
  /// Complexity: finite; in practice below the number of crossings.
  /// \returns the number of flips
  /// \throws Overflow_error if a normal coordinate on the way is out of range; nothing has changed then.
  std::size_t flip_to_input()
  {
    Self result(*this);
    const std::size_t flips =
      internal::flip_to_shared(result.m_coordinates, result.m_mesh, result.m_spokes);
    for(Edge_index e : result.m_mesh.edges())
      result.m_length[e] = result.input_length_along(result.m_mesh.halfedge(e));
    *this = std::move(result);
    return flips;
  }

  /// @}
  /// \name Correspondence
  /// @{

  /// the halfedge of \f$T_1\f$ that coincides with the halfedge `h` of \f$T_2\f$.
  /// \pre the edge of `h` is shared
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    return m_coordinates.shared_halfedge(h, m_mesh, m_spokes);
  }

  /// the last spoke of \f$T_1\f$ at or clockwise from the halfedge `h` of \f$T_2\f$ around its source.
  Halfedge_index input_spoke_before(Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.source(h);
    const size_type r = m_coordinates.roundabout(h);
    if(m_coordinates.is_shared(m_mesh.edge(h)))
      return m_spokes.halfedge(v, r);
    return m_spokes.halfedge(v, (r == 0 ? m_spokes.degree(v) : r) - 1);
  }

  /// checks everything: connectivity, lengths, integer coordinates, and that every edge of \f$T_1\f$ runs
  /// over \f$T_2\f$ to its other end. Complexity: linear in the elements and crossings.
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

  const FT& input_length_along(Halfedge_index h) const
  {
    return m_input_length[m_input.edge(input_halfedge(h))];
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
    for(auto e : edges(g))
      m_input_length[m_input.edge(numbering.halfedge_of(halfedge(e, g)))] = length(e);
    check_lengths();
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

  void check_lengths() const
  {
    for(Edge_index e : m_input.edges())
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

  // What is wrong between the two valid complexes, empty if nothing is.
  std::string defect() const
  {
    if(m_mesh.number_of_vertices() != m_input.number_of_vertices() ||
       m_mesh.number_of_edges() != m_input.number_of_edges() ||
       m_mesh.number_of_faces() != m_input.number_of_faces())
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
      if(m_coordinates.is_shared(e) && m_length[e] != input_length_along(m_mesh.halfedge(e)))
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
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
