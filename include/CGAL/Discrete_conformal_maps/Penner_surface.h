// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Edge_stack.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::Vertex_index;

/// \ingroup PkgDiscreteConformalMapsEnergy
/// whether a triangulation follows the scale factors.
enum class Flipping
{
  to_Delaunay, ///< edges are flipped until the triangulation is Delaunay
  none         ///< the triangulation stays; scaled lengths may violate the triangle inequality
};

/// \ingroup PkgDiscreteConformalMapsEnergy
/// a closed ideal hyperbolic polyhedron in the triangulation that is Delaunay for given scale
/// factors (Section 4.1.2), or in a fixed one: connectivity and Penner lengths
/// \f$\ell = e^{\lambda/2}\f$, without correspondence.
///
/// Ptolemy flips and scaling commute, so the triangulation goes from one set of scale factors to
/// the next by few flips, whatever the steps between them. All that is computed from lengths are
/// sums, products and quotients of positive numbers: flips lose no digits.
///
/// \tparam FT_ a floating point type, of any precision
template <typename FT_ = double>
class Penner_surface
{
  typedef Intrinsic_triangulations::Ideal_geometry_traits<FT_> Geometry;
  typedef Intrinsic_triangulations::Diamond<FT_> Diamond;

public:
  /// the number type.
  typedef FT_ FT;

  /// copies a surface.
  /// \param mesh the connectivity, without boundary
  /// \param length a readable property map from the edges to positive lengths
  /// \param flipping whether `scale()` flips edges
  template <typename EdgeLengthMap>
  Penner_surface(const Delta_complex& mesh, const EdgeLengthMap& length,
                 Flipping flipping = Flipping::to_Delaunay)
    : m_flipping(flipping),
      m_mesh(mesh),
      m_length(mesh.num_edges()),
      m_scaled_length(mesh.num_edges()),
      m_root_of_scale(mesh.num_vertices(), FT(1)),
      m_stack(mesh.num_edges())
  {
    for(Edge_index e : mesh.edges())
      m_length[e.idx()] = FT(get(length, e));
  }

  /// the triangulation. Its edges keep no identity: they turn as they are flipped.
  const Delta_complex& mesh() const { return m_mesh; }

  /// whether `scale()` flips edges.
  Flipping flipping() const { return m_flipping; }

  /// the length of `e`, multiplied by \f$e^{(u_i + u_j)/2}\f$ (Equation 4.1).
  const FT& scaled_length(Edge_index e) const { return m_scaled_length[e.idx()]; }

  /// the number of flips of all calls of `scale()`.
  std::size_t number_of_flips() const { return m_flips; }

  /// takes other scale factors and, unless the triangulation is fixed, flips to the one that is
  /// Delaunay with them. Complexity: linear in the vertices, edges and flips.
  /// \param u the logarithmic scale factors, by the numbers of vertices
  /// \throws Intrinsic_triangulations::Numerical_error if a scaled length is no length
  /// \post unless the triangulation is fixed, the scaled lengths obey Equation 4.5 but for
  ///       rounding, hence the triangle inequality
  void scale(const std::vector<FT>& u)
  {
    using std::exp;
    for(Vertex_index v : m_mesh.vertices())
      m_root_of_scale[v.idx()] = exp(u[v.idx()] / 2);
    for(Edge_index e : m_mesh.edges())
      set_scaled_length(e);
    if(m_flipping == Flipping::to_Delaunay)
      flip_to_Delaunay();
  }

private:
  void set_scaled_length(Edge_index e)
  {
    const Halfedge_index h(2 * e.idx());
    m_scaled_length[e.idx()] = m_length[e.idx()] * m_root_of_scale[m_mesh.source(h).idx()] *
                               m_root_of_scale[m_mesh.target(h).idx()];
    if(!m_geometry.is_length_object()(m_scaled_length[e.idx()]))
      throw Intrinsic_triangulations::Numerical_error(
        "edge " + std::to_string(e.idx()) + " has no positive finite length after scaling");
  }

  Diamond diamond(const std::vector<FT>& length, Halfedge_index h) const
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const auto of = [&](Halfedge_index x) { return length[Edge_index(x).idx()]; };
    return {of(h), of(m_mesh.next(h)), of(m_mesh.prev(h)), of(m_mesh.next(o)), of(m_mesh.prev(o))};
  }

  void flip_to_Delaunay()
  {
    const auto is_Delaunay = m_geometry.is_locally_Delaunay_object();
    for(Edge_index e : m_mesh.edges())
      m_stack.push_if(!is_Delaunay(diamond(m_scaled_length, m_mesh.halfedge(e))), e);
    Intrinsic_triangulations::internal::flip_waiting(
      m_mesh, m_stack, [&](Halfedge_index h) { return is_Delaunay(diamond(m_scaled_length, h)); },
      [&](Halfedge_index h) { flip(h); });
  }

  void flip(Halfedge_index h)
  {
    const Edge_index e(h);
    m_length[e.idx()] = m_geometry.compute_flipped_length_object()(diamond(m_length, h));
    flip_edge(h, m_mesh);
    set_scaled_length(e);
    ++m_flips;
  }

  Flipping m_flipping;
  Geometry m_geometry;
  Delta_complex m_mesh;
  std::vector<FT> m_length;        // without scale factors
  std::vector<FT> m_scaled_length; // with them
  std::vector<FT> m_root_of_scale; // e^(u/2)
  Intrinsic_triangulations::internal::Edge_stack m_stack;
  std::size_t m_flips = 0;
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H
