// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Marked_edges.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

using Intrinsic_triangulations::Correspondence;
using Intrinsic_triangulations::Side;
using Intrinsic_triangulations::Surface_point;

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the three triangulations of a surface (Figure 4.1): \f$T_1\f$, \f$T_2\f$ and \f$T_3\f$. The
/// paper has these letters as superscripts.
enum class Layer
{
  A, ///< \f$T_1\f$, the input
  B, ///< \f$T_2\f$, the intrinsic Delaunay triangulation of the input
  C  ///< \f$T_3\f$, the ideal Delaunay triangulation at the end
};

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the polygon mesh into which the edges of \f$T_1\f$, \f$T_2\f$ and \f$T_3\f$ together cut the
/// surface (Section 4.2.2). Every face is part of one face of each triangulation.
///
/// All three have the same vertices; these come first, with their indices. Crossings of edges of
/// \f$T_1\f$ and \f$T_2\f$ follow, then crossings of \f$T_2\f$ and \f$T_3\f$, with the numbers of
/// the two correspondences. The last vertices are crossings of \f$T_1\f$ and \f$T_3\f$ inside faces
/// of \f$T_2\f$.
///
/// In each face of \f$T_2\f$, edges of \f$T_1\f$ and edges of \f$T_3\f$ are straight lines. The
/// order of their ends around the face alone decides which edges cross, and in which order. Hence
/// the connectivity is always valid. It is exact unless rounding has exchanged ends of edges of
/// \f$T_1\f$ and \f$T_3\f$ on an edge of \f$T_2\f$. `certify_order_of_ends()` decides this. Two
/// ends at one position remain two vertices. Positions of crossings are rounded; along every edge
/// they do not decrease.
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
  /// the type of indices of elements.
  typedef typename Base::size_type size_type;

  /// builds the subdivision from two correspondences. The first is between \f$T_1\f$
  /// (`Side::input`) and \f$T_2\f$ (`Side::intrinsic`), the second between \f$T_2\f$
  /// (`Side::input`) and \f$T_3\f$ (`Side::intrinsic`). Complexity: linear in the vertices, edges
  /// and crossings.
  /// \tparam NamedParameters a sequence of named parameters
  /// \param ab the crossings of \f$T_1\f$ and \f$T_2\f$
  /// \param bc the crossings of \f$T_2\f$ and \f$T_3\f$
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads are used; see \ref dcm_parallel}
  ///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  ///                    `CGAL::Parallel_if_available_tag`}
  ///     \cgalParamDefault{`CGAL::Sequential_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \param number_of_original_faces if \f$T_1\f$ is a symmetric double, its faces with smaller
  ///   indices are the original. Edges of \f$T_3\f$ on the line of symmetry then lie on the side of
  ///   the copy, and never cut the original by rounding
  /// \throws Overflow_error if there are more edges than a `Surface_mesh` can number
  /// \pre \f$T_2\f$ is the same mesh in both; neither has inserted vertices
  template <typename Traits_AB, typename Traits_BC,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Triple_subdivision(const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc,
                     const NamedParameters& np = CGAL::parameters::default_values(),
                     std::size_t number_of_original_faces = 0)
    : Base({&ab.mesh(Side::input), &ab.mesh(Side::intrinsic), &bc.mesh(Side::intrinsic)}),
      m_first_crossing_of_bc(ab.mesh(Side::input).number_of_vertices() + ab.number_of_crossings()),
      m_first_crossing_of_ac(m_first_crossing_of_bc + bc.number_of_crossings())
  {
    CGAL_precondition(ab.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(bc.triangulation().number_of_inserted_vertices() == 0);
    CGAL_precondition(internal::is_same_complex(ab.mesh(Side::intrinsic), bc.mesh(Side::input)));
    check_number_of_edges(std::uint64_t(ab.mesh(Side::intrinsic).number_of_edges()) +
                          ab.number_of_crossings() + bc.number_of_crossings());
    Builder(internal::Marked_edges<FT>(ab, bc, number_of_original_faces),
            Intrinsic_triangulations::concurrency_of(np), *this)
      .build();
  }

  /// returns whether `v` is a crossing of an edge of `layer` with an edge of another triangulation.
  /// Edges that are also in \f$T_2\f$ count as edges of \f$T_2\f$ alone.
  bool is_crossing(Layer layer, Vertex_index v) const
  {
    if(this->is_vertex(layer, v))
      return false;
    return layer == Layer::A   ? !is_between(m_first_crossing_of_bc, m_first_crossing_of_ac, v)
           : layer == Layer::B ? v.idx() < m_first_crossing_of_ac
                               : v.idx() >= m_first_crossing_of_bc;
  }

  /// returns the position of `v` on `layer`. Complexity: constant, or linear in the degree of `v`
  /// for \f$T_3\f$.
  Surface_point<FT> place(Layer layer, Vertex_index v) const
  {
    return layer == Layer::C ? place_on_C(v) : m_place[Base::index(layer)][v.idx()];
  }

  /// returns the coordinates of the target of `h` in the parent of its face, in the order of
  /// `Face_location`.
  ///
  /// On \f$T_3\f$ these are homogeneous coordinates: nonnegative weights of the corners, for the
  /// decoration of the ideal polyhedron in the correspondence. They are linear in each face of the
  /// subdivision, seen in \f$T_2\f$, and continuous across its edges. In two faces around a vertex,
  /// weights belong to the same vertices of \f$T_3\f$ or are zero. They do not sum up to one,
  /// except in Euclidean geometry.
  /// \pre `h` is not a border halfedge
  std::array<FT, 3> coordinates(Layer layer, Halfedge_index h) const
  {
    return layer == Layer::C ? m_on_C[h.idx()] : Base::coordinates(layer, h);
  }

  /// returns `v` as a convex combination of one vertex of `layer`, or of the corners of a face.
  Intrinsic_triangulations::Vertex_weights<FT> weights(Layer layer, Vertex_index v) const
  {
    return this->is_vertex(layer, v)
             ? Base::weights(layer, v)
             : this->corner_weights(layer, face_location(place(layer, v), this->mesh(layer)));
  }

  /// \cond SKIP_IN_MANUAL
  // Divides the weight of a crossing among the source and the target of `on_C`, in proportion to
  // `part`.
  void divide_weight(Vertex_index crossing, Halfedge_index on_C, const std::array<FT, 2>& part)
  {
    for(Halfedge_index h : CGAL::halfedges_around_target(crossing, this->mesh())) {
      const Halfedge_index before = this->parent_halfedge(Layer::C, h);
      const Halfedge_index along =
        before.is_valid() ? before : this->parent_halfedge(Layer::C, this->mesh().next(h));
      std::array<FT, 3>& on_face = m_on_C[h.idx()];
      const FT factor = (on_face[0] + on_face[1] + on_face[2]) / (part[0] + part[1]);
      const Intrinsic_triangulations::Edge_location<FT> p{on_C,
                                                          {factor * part[0], factor * part[1]}};
      on_face = face_location(along == on_C ? p : reversed(p), this->mesh(Layer::C)).second;
    }
  }
  /// \endcond

private:
  static void check_number_of_edges(std::uint64_t number)
  {
    if(number >= (std::numeric_limits<size_type>::max)() / 2)
      throw Intrinsic_triangulations::Overflow_error("more edges than a mesh can index");
  }

  static bool is_between(size_type first, size_type end, Vertex_index v)
  {
    return first <= v.idx() && v.idx() < end;
  }

  // Returns a location in a face on the left of an edge of C that leaves `v`, if one exists.
  Surface_point<FT> place_on_C(Vertex_index v) const
  {
    Halfedge_index along;
    if(this->mesh().is_isolated(v))
      return Intrinsic_triangulations::Vertex_location{along};
    Intrinsic_triangulations::Face_location<FT> p;
    for(Halfedge_index h : CGAL::halfedges_around_target(v, this->mesh()))
      if(!along.is_valid() && !this->mesh().is_border(h)) {
        along = this->parent_halfedge(Layer::C, this->mesh().next(h));
        p = this->location(Layer::C, h);
      }
    if(this->is_vertex(Layer::C, v))
      return Intrinsic_triangulations::Vertex_location{along};
    const FT sum = p.second[0] + p.second[1] + p.second[2];
    for(FT& x : p.second)
      x /= sum;
    if(!along.is_valid())
      return p;
    const auto b = coordinates_from(along, p, this->mesh(Layer::C));
    return Intrinsic_triangulations::Edge_location<FT>{along, {b[0], b[1]}};
  }

  void copy_corner(Halfedge_index from, Halfedge_index to)
  {
    m_on_C.resize(this->mesh().number_of_halfedges());
    m_on_C[to.idx()] = m_on_C[from.idx()];
  }

  class Builder;

  size_type m_first_crossing_of_bc, m_first_crossing_of_ac;
  std::array<std::vector<Surface_point<FT>>, 2> m_place; // of each vertex, on A and B
  std::vector<std::array<FT, 3>> m_on_C; // the coordinates of the target of each halfedge
};

} // namespace CGAL::Discrete_conformal_maps

#include <CGAL/Discrete_conformal_maps/internal/subdivision/Triple_subdivision_builder.h>

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
