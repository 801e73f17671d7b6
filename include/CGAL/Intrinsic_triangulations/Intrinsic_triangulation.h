// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/lengths_in_strips.h>
#include <CGAL/Intrinsic_triangulations/internal/input/copy_properties.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/inserted_outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/triangulation_defect.h>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename Traits>
class Coordinate_flipping;
template <typename Traits>
class Input_splitter;
template <typename Traits>
class Exact_flipping;
template <typename Traits>
class Exact_insertion;
template <typename Traits>
class Flip_record;
template <typename Traits>
class Vertex_reinserter;

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// a triangulation \f$T_2\f$ of a surface that is given by an input triangulation \f$T_1\f$ with
/// edge lengths, and the correspondence between the two.
///
/// The edges of \f$T_2\f$ are geodesics on the surface of \f$T_1\f$. The class adds the operations
/// that change \f$T_2\f$ to `Triangulation_pair`, and keeps the integer coordinates consistent.
/// \f$T_1\f$ never changes, and the mesh that it was made from is only read.
///
/// Vertices of both triangulations, and edges and faces of \f$T_1\f$, have the order of the ranges
/// `vertices(g)`, `edges(g)`, `faces(g)` of the input. `halfedge(e, g)` becomes halfedge \f$2e\f$.
/// Isolated vertices are kept. \f$T_2\f$ can have more vertices (Section 3.5), whose positions on
/// \f$T_1\f$ are stored, too. Their indices follow the indices of the input vertices.
///
/// Copying takes linear time, moving constant time; an object that has been moved from may only be
/// assigned to or destroyed.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
/// \cgalModels `IntrinsicSurface`, as the surface of \f$T_2\f$
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Intrinsic_triangulation : public Triangulation_pair<Traits_>
{
  typedef Triangulation_pair<Traits_> Base;
  using Base::attach, Base::insert_into_edge, Base::insert_into_face, Base::m_coordinates,
    Base::m_input, Base::m_input_metric, Base::m_inserted, Base::m_is_constrained, Base::m_length,
    Base::m_mesh, Base::m_outgoing_halfedges, Base::m_traits, Base::set_edge, Base::set_lengths,
    Base::undo_of_split;

public:
  using Base::first_inserted_outgoing, Base::input, Base::inserted_vertex, Base::intrinsic,
    Base::is_constrained, Base::is_inserted, Base::shared_length;
  using typename Base::FT, typename Base::Integer, typename Base::size_type, typename Base::Traits;

  /// \name Construction
  /// @{

  /// creates a triangulation of the empty surface.
  Intrinsic_triangulation() = default;

  /// creates the triangulation \f$T_2 = T_1\f$ of the surface of `g`.
  ///
  /// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`; a Delta-complex, with loops
  ///         and parallel edges, is allowed
  /// \tparam NamedParameters a sequence of named parameters
  /// \param g the input: triangles, with or without boundary, of any genus and number of components
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
  ///   \cgalParamNBegin{squared_edge_length_map}
  ///     \cgalParamDescription{the squared lengths of the edges, exact for exact traits}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with value type convertible to
  ///       `Traits::Exact_number` or, without exact traits, to `FT`}
  ///     \cgalParamDefault{unused}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{mollification}
  ///     \cgalParamDescription{the slack that `mollify()` gives to all triangle inequalities,
  ///       relative to the mean edge length; 0 for none}
  ///     \cgalParamType{convertible to `FT`}
  ///     \cgalParamDefault{0}
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
  /// \throws Invalid_input if `g` is no triangulated surface with one fan at each vertex, a length
  ///   is not positive and finite, or the triangle inequality fails. With exact traits and without
  ///   positions it must hold exactly. Lengths of type `double` that exceed it by rounding error
  ///   are shortened.
  template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Intrinsic_triangulation(const Graph& g,
                                   const NamedParameters& np = CGAL::parameters::default_values());

  /// creates the triangulation of the surface of `g` as the constructor of a graph does. `g`
  /// becomes \f$T_1\f$, and is only copied if it has garbage or property maps. Complexity: linear.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Intrinsic_triangulation(Delta_complex&& g,
                                   const NamedParameters& np = CGAL::parameters::default_values());

  /// creates the triangulation from \f$T_1\f$ and \f$T_2\f$ that come from a file. Both
  /// have lengths, see `stored_length_map()`, and `mesh` has `Integer_coordinates`. `inserted` has
  /// the positions of the vertices that only `mesh` has, in their order. Lengths of `input` are
  /// exact unless `metric` is. Constraints of `mesh`, see `stored_constraint_map()`, are kept.
  /// Complexity: linear in the elements and crossings.
  /// \throws Invalid_input if they do not fit together.
  Intrinsic_triangulation(Delta_complex input, Delta_complex mesh,
                          std::vector<Surface_point<FT>> inserted = {},
                          const Traits& traits = Traits(), typename Base::Metric metric = {})
    : Base(traits, std::move(input), std::move(mesh), std::move(inserted), std::move(metric))
  {
    internal::check_Delta_complex(m_input);
    internal::check_Delta_complex(m_mesh);
    m_outgoing_halfedges = Outgoing_halfedges(m_input, boost::dummy_property_map());
    internal::check_lengths(this->input(), m_input_metric, m_traits);
    internal::check_inserted(*this);
    Base::number_inserted_outgoing_halfedges();
    internal::check_correspondence(*this);
    if constexpr(internal::has_metric<Traits>())
      internal::check_exact_triangles(internal::exact_input(*this));
  }

  /// @}
  /// \name Flipping
  /// @{

  /// sets whether the edge `e` must not be flipped. If `e` is neither an edge of \f$T_1\f$ nor a
  /// part of one, functions cannot restart from \f$T_1\f$, and rounding can cause a
  /// `Numerical_error`.
  void set_constrained(Edge_index e, bool is_constrained) { m_is_constrained[e] = is_constrained; }

  /// returns whether `flip()` of the edge of `h` gives a triangulation of the surface. The edge
  /// must not be constrained, must lie in two faces, and their union must be strictly convex.
  bool is_flippable(Halfedge_index h) const
  {
    if constexpr(internal::Is_exact<Traits>::value)
      return can_be_turned(h) && internal::exact_decisions(*this).is_convex(h);
    else
      return can_be_turned(h) &&
             internal::of_diamond(m_traits.is_convex_object(), m_traits, m_length, h, m_mesh);
  }

  /// returns whether the edge `e` of \f$T_2\f$ satisfies the local Delaunay condition (Equation
  /// 2.6), or is constrained, or is on the boundary. Decision: exact for exact traits; in floating
  /// point up to the one-sided tolerance `rounding_unit()`.
  bool is_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    if constexpr(internal::Is_exact<Traits>::value)
      return !can_be_turned(h) || internal::exact_decisions(*this).is_Delaunay(h);
    else
      return internal::of_diamond(m_traits.is_locally_Delaunay_object(), m_traits, m_length, h,
                                  m_mesh) ||
             !can_be_turned(h);
  }

  /// turns the edge of `h` as `flip_edge()` does. It updates length and integer coordinates. The
  /// coordinates are exact. An edge that is also in \f$T_1\f$ has its length in \f$T_1\f$, to the
  /// bit. Complexity: constant; no memory is allocated.
  /// \throws Numerical_error if the new length is not positive and finite
  /// \throws Overflow_error if the new normal coordinate is out of range
  ///
  /// After an exception nothing has changed.
  /// \pre `is_flippable(h)`, or the edge of `h` is not Delaunay
  void flip(Halfedge_index h)
  {
    CGAL_precondition(can_be_turned(h));
    if constexpr(internal::Is_exact<Traits>::value)
      return turn(h, [&] { return internal::exact_decisions(*this).length(h); });
    const FT length =
      internal::of_diamond(m_traits.compute_flipped_length_object(), m_traits, m_length, h, m_mesh);
    if(!m_traits.is_length_object()(length))
      throw Numerical_error("flipping edge " + std::to_string(m_mesh.edge(h).idx()) +
                            " gives no positive finite length");
    m_coordinates.flip(h, m_mesh, m_outgoing_halfedges);
    const Edge_index e = m_mesh.edge(h);
    m_length[e] = m_coordinates.is_shared(e) ? shared_length(h) : length;
  }

  /// computes the length of every edge of \f$T_2\f$ again, from the lengths of \f$T_1\f$ in the
  /// strip of triangles that the edge passes. This removes rounding errors of many flips, since
  /// strips are known exactly. Complexity: linear in the edges and crossings.
  /// \throws Numerical_error if a length is not positive and finite
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  ///
  /// After an exception nothing has changed.
  void recompute_lengths()
  {
    internal::with_lengths_in_strips(*this, [&](auto&& length) { this->set_lengths(length); });
  }

  /// turns \f$T_2\f$ back into \f$T_1\f$, with its elements and without inserted vertices. An edge
  /// of \f$T_1\f$ is constrained if a part of it was constrained. Other constraints are dropped.
  /// Complexity: linear.
  void reset_to_input()
  {
    std::vector<Edge_index> constrained;
    for(Edge_index e : m_mesh.edges())
      if(is_constrained(e) && m_coordinates.is_shared(e))
        constrained.emplace_back(Base::input_outgoing_before(m_mesh.halfedge(e)));
    m_mesh = m_input;
    m_inserted.clear();
    attach();
    m_outgoing_halfedges = Outgoing_halfedges(m_input, m_coordinates.roundabout_map());
    for(Edge_index e : constrained)
      m_is_constrained[e] = true;
  }

  /// @}
  /// \name Inserted Vertices
  /// Section 3.5. `Vertex_inserter` calls these operations with the right arguments. Vertices can
  /// be inserted if `Traits` is a model of `IntrinsicGeometryTraitsWithDistance`. If an operation
  /// throws, nothing has changed.
  /// @{

  /// inserts a vertex into a face of \f$T_2\f$ and joins it to the corners (see
  /// `Integer_coordinates::split_face()`). Complexity: constant.
  /// \param p the point on \f$T_2\f$
  /// \param at the integer coordinates of the edges from the new vertex to the corners of the face,
  ///        in the order of the coordinates of `p`
  /// \param q the same point on \f$T_1\f$
  /// \returns the new vertex
  /// \throws Numerical_error if an edge has no positive finite length
  /// \throws Overflow_error if a normal coordinate is out of range
  Vertex_index split_face(const Face_location<FT>& p, const Face_split<Integer>& at,
                          const Surface_point<FT>& q)
  {
    if constexpr(internal::Is_exact<Traits>::value) {
      const Halfedge_index first = m_mesh.halfedge(p.first);
      const Vertex_index m = insert_into_face(p.first, at, q, {});
      return measured(m, internal::exact_decisions(*this), [&] { take_back(m, first); });
    }
    return insert_into_face(p.first, at, q, internal::lengths_to_corners(*this, p, at, on_edge(q)));
  }

  /// inserts a vertex \f$m\f$ into the edge \f$ij\f$ of `h` in \f$T_2\f$ (see
  /// `Integer_coordinates::split_edge()`). The parts of a shared edge have the lengths of those
  /// parts of the edge of \f$T_1\f$; both parts of a constrained edge are constrained. Complexity:
  /// constant.
  /// \param h the halfedge from \f$i\f$ to \f$j\f$; afterwards it leads from \f$m\f$ to \f$j\f$
  /// \param t the position of \f$m\f$ on it, between 0 and 1
  /// \param n the normal coordinates of the new edges
  /// \param r the roundabouts of the halfedges from \f$m\f$ along these edges
  /// \param q the position of \f$m\f$ on \f$T_1\f$; the result of `point_on_shared()` if the edge
  ///   is shared
  /// \returns \f$m\f$
  /// \throws Numerical_error if an edge has no positive finite length
  /// \throws Overflow_error if a normal coordinate is out of range
  /// \pre the two sides of the edge are not in one face
  Vertex_index split_edge(Halfedge_index h, const FT& t, const Edge_split<Integer>& n,
                          const Edge_split<size_type>& r, const Surface_point<FT>& q)
  {
    if constexpr(internal::Is_exact<Traits>::value) {
      const auto undo = undo_of_split(h);
      return measured(insert_into_edge(h, n, r, q, {}), internal::exact_decisions(*this), undo);
    }
    return insert_into_edge(h, n, r, q, internal::lengths_of_parts(*this, h, t, n, r, on_edge(q)));
  }

  /// removes an inserted vertex that has three edges, or two faces on the boundary (see
  /// `remove_degree_3_vertex()`). If it lies on an edge of \f$T_1\f$ and both parts are edges of
  /// \f$T_2\f$, the edge that replaces them is shared again. The elements are marked as removed,
  /// see `collect_garbage()`. Complexity: constant.
  /// \returns the face that remains
  /// \pre `is_inserted(v)`, and `removal_status(v, mesh()) == Operation_status::possible`
  Face_index remove_degree_3_vertex(Vertex_index v)
  {
    const internal::Merged_edge merged = internal::merged_edge(*this, v);
    const Face_index f = Intrinsic_triangulations::remove_degree_3_vertex(v, m_mesh);
    if(merged.side.is_valid()) {
      m_coordinates.set_shared(merged.side, merged.r_source, merged.r_target);
      set_edge(merged.side, shared_length(merged.side), merged.is_constrained);
    }
    return f;
  }

  /// gives the elements of \f$T_2\f$ consecutive indices after vertices have been removed.
  /// Elements of the input keep their indices. Complexity: linear.
  void collect_garbage()
  {
    auto place = add_property_map<Vertex_index>("v:inserted", Surface_point<FT>());
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        place[v] = inserted_vertex(v);
    m_mesh.collect_garbage();
    m_inserted.clear();
    for(Vertex_index v : m_mesh.vertices())
      if(is_inserted(v))
        m_inserted.push_back(place[v]);
    m_mesh.remove_property_map(place);
    Base::number_inserted_outgoing_halfedges();
  }

  /// adds a property of the elements of \f$T_2\f$, which follows them if they get other indices. It
  /// is lost when \f$T_2\f$ is assigned to, and by `reset_to_input()`. Complexity: linear.
  /// \param name the name
  /// \param value the value of all elements, and of new ones
  template <typename Index, typename Value>
  Delta_complex::Property_map<Index, Value> add_property_map(const std::string& name,
                                                             const Value& value)
  {
    return m_mesh.template add_property_map<Index, Value>(name, value).first;
  }

  /// @}
  /// \name Validity
  /// @{

  /// checks everything: connectivity, lengths, integer coordinates, and that every edge of
  /// \f$T_1\f$ runs over \f$T_2\f$ to its other end. Complexity: linear in the elements and
  /// crossings.
  bool is_valid(bool verbose = false) const
  {
    const std::string of_mesh = internal::Delta_complex_defect(m_mesh),
                      defect = of_mesh.empty() ? internal::correspondence_defect(*this) : of_mesh;
    if(verbose && !defect.empty())
      std::cerr << defect << '\n';
    return defect.empty();
  }

  /// @}

private:
  friend class internal::Coordinate_flipping<Traits>;
  friend class internal::Input_splitter<Traits>;
  friend class internal::Exact_flipping<Traits>;
  friend class internal::Exact_insertion<Traits>;
  friend class internal::Flip_record<Traits>;
  friend class internal::Vertex_reinserter<Traits>;

  template <typename Graph, typename NamedParameters, typename Numbering>
  void copy_properties(const Graph& g, const NamedParameters& np, const Numbering& numbering);

  bool can_be_turned(Halfedge_index h) const
  {
    return flip_status(h, m_mesh) == Operation_status::possible && !is_constrained(m_mesh.edge(h));
  }

  // Undoes the last insertion, of `m` into the face with the first halfedge `first`.
  void take_back(Vertex_index m, Halfedge_index first)
  {
    m_mesh.set_halfedge(m, m_mesh.opposite(m_mesh.prev(first))); // so that this face stays
    remove_degree_3_vertex(m);
  }

  // Sets the lengths of the edges of the new vertex `m` and returns `m`. If a length is not
  // positive and finite, `undo()` undoes the insertion.
  template <typename Decisions, typename Undo>
  Vertex_index measured(Vertex_index m, const Decisions& decisions, const Undo& undo)
  {
    const auto measure = [&](Halfedge_index h) { m_length[m_mesh.edge(h)] = decisions.length(h); };
    internal::change_or_undo([&] { for_each_outgoing_halfedge(m, m_mesh, measure); }, undo);
    return m;
  }

  // Flips the edge of `h`; `length()` then returns its length. Three more flips undo one.
  template <typename Length>
  void turn(Halfedge_index h, const Length& length)
  {
    const auto flip = [&] { m_coordinates.flip(h, m_mesh, m_outgoing_halfedges); };
    flip();
    internal::change_or_undo([&] { m_length[m_mesh.edge(h)] = length(); },
                             [&] { flip(), flip(), flip(); });
  }
};

} // namespace CGAL::Intrinsic_triangulations

#include <CGAL/Intrinsic_triangulations/internal/input/Intrinsic_triangulation_impl.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/compiled/Intrinsic_triangulation.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
