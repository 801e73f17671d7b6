// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Delaunay_filter.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsEnergy
/// whether a triangulation follows the scale factors.
enum class Flipping
{
  to_Delaunay, ///< edges are flipped until the triangulation is Delaunay
  none         ///< the triangulation stays; scaled lengths may violate the triangle inequality
};

/// \ingroup PkgDiscreteConformalMapsEnergy
/// a closed ideal hyperbolic polyhedron in the Delaunay triangulation for given scale factors
/// (Section 4.1.2), or in a fixed triangulation. It consists of connectivity and Penner lengths
/// \f$\ell = e^{\lambda/2}\f$, without correspondence.
///
/// Ptolemy flips and scaling commute. So few flips are needed if scale factors change. Flips lose
/// no digits: they compute sums, products and quotients of positive numbers.
///
/// With circles at the vertices \cgalCite{BL23} the polyhedron is hyperideal, and the triangulation
/// is weighted Delaunay. Its lengths are lengths of tangents
/// (`Intrinsic_triangulations::Decorated_length`). Radii and tangents are scaled. Flips are defined
/// by `Intrinsic_triangulations::Hyperideal_geometry_traits`.
///
/// \tparam FT_ a floating point type, of any precision
template <typename FT_ = double>
class Penner_surface
{
  typedef internal::Ptolemy_surface<FT_> Surface;
  typedef Intrinsic_triangulations::Diamond<FT_> Diamond;
  typedef Intrinsic_triangulations::Decorated_length<FT_> Decorated_length;

public:
  /// the number type.
  typedef FT_ FT;

  /// copies a surface.
  /// \param mesh the connectivity, without boundary
  /// \param length a readable property map from the edges to positive lengths
  /// \param flipping whether `scale()` flips edges
  /// \param radii the radii of circles, by the indices of vertices, if there are circles. Then
  ///   `length` has the lengths of tangents, which can be zero
  template <typename EdgeLengthMap>
  Penner_surface(const Delta_complex& mesh, const EdgeLengthMap& length,
                 Flipping flipping = Flipping::to_Delaunay, std::vector<FT> radii = {})
    : m_flipping(flipping),
      m_surface(mesh, length, std::move(radii)),
      m_scaled_length(mesh.num_edges()),
      m_scaled_radius(m_surface.radii()),
      m_factor(mesh.num_vertices(), FT(1)),
      m_stack(mesh.num_edges())
  {}

  /// returns the triangulation. A flip turns an edge, and keeps its index.
  const Delta_complex& mesh() const { return m_surface.mesh(); }

  /// returns whether `scale()` flips edges.
  Flipping flipping() const { return m_flipping; }

  /// returns the length of `e`, multiplied by \f$e^{(u_i + u_j)/2}\f$ (Equation 4.1).
  const FT& scaled_length(Edge_index e) const { return m_scaled_length[e.idx()]; }

  /// returns whether there are circles at the vertices.
  bool has_radii() const { return m_surface.has_radii(); }

  /// returns the radius of the circle at `v` before scaling. \pre `has_radii()`
  const FT& radius(Vertex_index v) const { return m_surface.radii()[v.idx()]; }

  /// returns the scaled radius of the circle at `v`: \f$e^{u} r\f$. \pre `has_radii()`
  const FT& scaled_radius(Vertex_index v) const { return m_scaled_radius[v.idx()]; }

  /// returns the edge of `h` with its scaled tangent and radii. \pre `has_radii()`
  Decorated_length scaled_decorated_length(Halfedge_index h) const
  {
    return m_surface.decorated_length(h, m_scaled_length, m_scaled_radius);
  }

  /// returns the scaled lengths of the edge of `h` and of the other sides of its faces.
  Diamond scaled_diamond(Halfedge_index h) const { return m_surface.diamond(h, m_scaled_length); }

  /// returns all flips so far, each by a halfedge of the flipped edge.
  const std::vector<Halfedge_index>& flips() const { return m_surface.flips(); }

  /// returns the number of all flips so far.
  std::size_t number_of_flips() const { return flips().size(); }

  /// sets the scale factors and, unless the triangulation is fixed, flips to their Delaunay
  /// triangulation. Complexity: linear in the vertices, edges and flips.
  /// \param u the logarithmic scale factors, by the indices of vertices
  /// \throws Intrinsic_triangulations::Numerical_error if a scaled length is not a length
  /// \throws Intrinsic_triangulations::Flip_limit_exceeded if more than a thousand flips for each
  ///         edge and a million are needed
  /// \post unless the triangulation is fixed, the scaled lengths satisfy Equation 4.5 up to
  ///   rounding, hence the triangle inequality
  void scale(const std::vector<FT>& u)
  {
    set_scale_factors(u);
    if(m_flipping == Flipping::none)
      return;
    if(has_radii() || internal::Delaunay_filter<FT>::is_useful)
      return flip_to_Delaunay([this](Halfedge_index h) { return this->is_Delaunay(h); });
    const auto condition = m_geometry.is_locally_Delaunay_object();
    flip_to_Delaunay([&](Halfedge_index h) { return condition(scaled_diamond(h)); });
  }

#ifndef DOXYGEN_RUNNING
  // Sets other scale factors at some vertices, and flips to their Delaunay triangulation. The
  // current triangulation must be Delaunay with the scale factors before. Complexity: linear in the
  // degrees of the vertices and the flips.
  void scale_at(const std::vector<Vertex_index>& vertices, const std::vector<FT>& u)
  {
    scale_at(vertices, u, [this](Halfedge_index h) { return is_Delaunay(h); });
  }

  // Sets other scale factors at some vertices, with another condition for edges.
  template <typename Is_good>
  void scale_at(const std::vector<Vertex_index>& vertices, const std::vector<FT>& u,
                const Is_good& is_good)
  {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      set_factor(vertices[i], u[i]);
    for(Vertex_index v : vertices)
      for_each_outgoing_halfedge(v, mesh(),
                                 [this](Halfedge_index h) { set_scaled_length(Edge_index(h)); });
    for(Vertex_index v : vertices)
      for_each_outgoing_halfedge(v, mesh(), [&](Halfedge_index h) {
        for(Halfedge_index side : {h, mesh().next(h)})
          m_stack.push_if(!is_good(side), Edge_index(side));
      });
    flip_waiting(is_good);
  }
#endif

  /// sets the scale factors, and keeps the triangulation.
  /// \param u the logarithmic scale factors, by the indices of vertices
  /// \throws Intrinsic_triangulations::Numerical_error if a scaled length is not a length
  void set_scale_factors(const std::vector<FT>& u)
  {
    for(Vertex_index v : mesh().vertices())
      set_factor(v, u[v.idx()]);
    for(Edge_index e : mesh().edges())
      set_scaled_length(e);
  }

  /// flips edges until `is_good(h)` holds for a halfedge of each edge that can be flipped.
  /// \throws Intrinsic_triangulations::Numerical_error,
  ///         Intrinsic_triangulations::Flip_limit_exceeded as `scale()` does
  template <typename Is_good>
  void flip_until(const Is_good& is_good)
  {
    for(Edge_index e : mesh().edges())
      m_stack.push(e);
    flip_waiting(is_good);
  }

private:
  template <typename Is_good>
  void flip_to_Delaunay(const Is_good& is_good)
  {
    for(Edge_index e : mesh().edges())
      m_stack.push_if(!is_good(mesh().halfedge(e)), e);
    flip_waiting(is_good);
  }

  bool is_Delaunay(Halfedge_index h) const
  {
    if constexpr(internal::Delaunay_filter<FT>::is_useful) {
      const Uncertain<bool> rounded = m_surface.of_diamond(
        [](const auto& edges) { return internal::Delaunay_filter<FT>::is_Delaunay(edges); }, h,
        m_scaled_length, m_scaled_radius);
      if(is_certain(rounded))
        return get_certain(rounded);
    }
    return m_surface.of_diamond(m_geometry.is_locally_Delaunay_object(), h, m_scaled_length,
                                m_scaled_radius);
  }

  void set_factor(Vertex_index v, const FT& u)
  {
    m_factor[v.idx()] = internal::length_factor(u);
    if(has_radii())
      m_scaled_radius[v.idx()] =
        internal::scaled_length(m_surface.radii()[v.idx()], m_factor[v.idx()], m_factor[v.idx()]);
  }

  template <typename Is_good>
  void flip_waiting(const Is_good& is_good)
  {
    // All flips are recorded, so the limit also bounds memory.
    const std::size_t limit = 1000000 + 1000 * mesh().num_edges();
    const auto flip = [this](Halfedge_index h) {
      m_surface.flip(h);
      set_scaled_length(Edge_index(h));
    };
    Intrinsic_triangulations::flip_waiting(mesh(), m_stack, is_good, flip, limit);
  }

  void set_scaled_length(Edge_index e)
  {
    const Halfedge_index h(2 * e.idx());
    FT& length = m_scaled_length[e.idx()];
    length = internal::scaled_length(m_surface.length(e), m_factor[mesh().source(h).idx()],
                                     m_factor[mesh().target(h).idx()]);
    if(!is_length(h, length))
      throw Intrinsic_triangulations::Numerical_error(
        "edge " + std::to_string(e.idx()) + " has no positive finite length after scaling");
  }

  // Returns whether `length` is the length of an edge. Tangents of circles that touch are zero.
  bool is_length(Halfedge_index h, const FT& length) const
  {
    const typename Intrinsic_triangulations::Ideal_geometry_traits<FT>::Is_length condition;
    return condition(length) ||
           (has_radii() && length == 0 && condition(scaled_decorated_length(h).length()));
  }

  Flipping m_flipping;
  Intrinsic_triangulations::Hyperideal_geometry_traits<FT> m_geometry;
  Surface m_surface;
  std::vector<FT> m_scaled_length;
  std::vector<FT> m_scaled_radius; // of each vertex, if there are circles
  std::vector<FT> m_factor;        // of each vertex, for lengths
  Intrinsic_triangulations::Edge_stack m_stack;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_PENNER_SURFACE_H
