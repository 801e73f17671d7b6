// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the factor by which logarithmic scale factors that sum up to `u` multiply lengths.
template <typename FT>
FT length_factor(const FT& u)
{
  using std::exp;
  return exp(u / 2);
}

// Returns the length of an edge ij after scaling (Equation 4.1). It is multiplied by the factors of
// i and j, which are computed once for each vertex. With less rounding, it is multiplied by the
// factor of u_i + u_j.
template <typename FT, typename... Factor>
FT scaled_length(const FT& length, const Factor&... factor)
{
  return (length * ... * factor);
}

// Returns the length with the circles at the ends. Radii are multiplied by squared factors of
// lengths.
template <typename FT>
Intrinsic_triangulations::Decorated_length<FT>
scaled(const Intrinsic_triangulations::Decorated_length<FT>& edge, const FT& u_i, const FT& u_j)
{
  const FT i = length_factor(u_i), j = length_factor(u_j);
  return {scaled_length(edge.tangent, length_factor(FT(u_i + u_j))),
          scaled_length(edge.source_radius, i, i), scaled_length(edge.target_radius, j, j)};
}

// Represents a closed ideal polyhedron with Penner lengths, or a hyperideal one with the tangents
// of circles. Its edges are flipped by Ptolemy's relation (Equation 4.4) or its generalization, and
// the flips are recorded.
template <typename FT>
class Ptolemy_surface
{
public:
  typedef Intrinsic_triangulations::Diamond<FT> Diamond;
  typedef Intrinsic_triangulations::Decorated_length<FT> Decorated_length;

  // `length` is a readable property map of lengths; `radii` are the radii of all vertices, or
  // empty.
  template <typename EdgeLengthMap>
  Ptolemy_surface(const Delta_complex& mesh, const EdgeLengthMap& length,
                  std::vector<FT> radii = {})
    : m_mesh(Intrinsic_triangulations::internal::without_maps(mesh)),
      m_length(mesh.num_edges()),
      m_radii(std::move(radii))
  {
    for(Edge_index e : mesh.edges())
      m_length[e.idx()] = FT(get(length, e));
  }

  const Delta_complex& mesh() const { return m_mesh; }
  const FT& length(Edge_index e) const { return m_length[e.idx()]; }

  // Returns all flips so far. Flips of another surface with this connectivity can be replayed.
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  void replay(const std::vector<Halfedge_index>& flips)
  {
    for(Halfedge_index h : flips)
      flip(h);
  }

  // Returns the edge ij of `h` and its faces ijk and jil, optionally with other lengths of edges.
  Diamond diamond(Halfedge_index h) const { return diamond(h, m_length); }
  Diamond diamond(Halfedge_index h, const std::vector<FT>& length) const
  {
    return Intrinsic_triangulations::internal::diamond_of(
      [&](Halfedge_index x) { return length[Edge_index(x).idx()]; }, h, m_mesh);
  }

  // Returns whether vertices have circles.
  bool has_radii() const { return !m_radii.empty(); }
  const std::vector<FT>& radii() const { return m_radii; }

  // Returns the edge of `h` with the circles at its ends, optionally with other lengths and radii.
  Decorated_length decorated_length(Halfedge_index h) const
  {
    return decorated_length(h, m_length, m_radii);
  }
  Decorated_length decorated_length(Halfedge_index h, const std::vector<FT>& length,
                                    const std::vector<FT>& radii) const
  {
    return {length[Edge_index(h).idx()], radii[m_mesh.source(h).idx()],
            radii[m_mesh.target(h).idx()]};
  }

  // Calls `function` with the diamond of `h`, and with radii if they exist. Flips with radii need
  // square roots, which rational numbers do not have.
  template <typename Function>
  auto of_diamond(const Function& function, Halfedge_index h, const std::vector<FT>& length,
                  [[maybe_unused]] const std::vector<FT>& radii) const
  {
    if constexpr(Intrinsic_triangulations::internal::Has_square_root<FT>::value)
      if(has_radii()) {
        const auto edge = [&](Halfedge_index x) { return decorated_length(x, length, radii); };
        return function(Intrinsic_triangulations::internal::diamond_of(edge, h, m_mesh));
      }
    return function(diamond(h, length));
  }

  // Flips the edge of `h`.
  // \pre `flip_status(h, mesh())` returns that it is possible
  void flip(Halfedge_index h)
  {
    m_length[Edge_index(h).idx()] =
      of_diamond(m_geometry.compute_flipped_length_object(), h, m_length, m_radii);
    flip_edge(h, m_mesh);
    m_flips.push_back(h);
  }

private:
  Intrinsic_triangulations::Hyperideal_geometry_traits<FT> m_geometry;
  Delta_complex m_mesh;
  std::vector<FT> m_length;
  std::vector<FT> m_radii;
  std::vector<Halfedge_index> m_flips;
};

// Stores the horocyclic arcs of two decorated triangles ijk and jil, each multiplied by the length
// of ij (Equation 4.15).
template <typename FT>
struct Horocyclic_arcs
{
  explicit Horocyclic_arcs(const Intrinsic_triangulations::Diamond<FT>& d)
    : at_i(d.jk / d.ki + d.lj / d.il),
      at_j(d.ki / d.jk + d.il / d.lj),
      at_k(d.ij / d.jk * (d.ij / d.ki)),
      at_l(d.ij / d.il * (d.ij / d.lj))
  {}

  FT at_i, at_j, // of both triangles
    at_k, at_l;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H
