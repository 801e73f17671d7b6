// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::Vertex_index;

// A closed ideal polyhedron with Penner lengths. Its edges turn by Ptolemy's relation (Equation
// 4.4).
template <typename FT>
class Ptolemy_surface
{
public:
  typedef Intrinsic_triangulations::Diamond<FT> Diamond;

  // `length` is a readable property map of positive lengths
  template <typename EdgeLengthMap>
  Ptolemy_surface(const Delta_complex& mesh, const EdgeLengthMap& length)
    : m_mesh(mesh), m_length(mesh.num_edges()), m_stack(mesh.num_edges())
  {
    for(Edge_index e : mesh.edges())
      m_length[e.idx()] = FT(get(length, e));
  }

  const Delta_complex& mesh() const { return m_mesh; }
  const FT& length(Edge_index e) const { return m_length[e.idx()]; }

  // the edge ij of `h` and its faces ijk and jil, with other lengths of edges if wanted
  Diamond diamond(Halfedge_index h) const { return diamond(h, m_length); }
  Diamond diamond(Halfedge_index h, const std::vector<FT>& length) const
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const auto of = [&](Halfedge_index x) { return length[Edge_index(x).idx()]; };
    return {of(h), of(m_mesh.next(h)), of(m_mesh.prev(h)), of(m_mesh.next(o)), of(m_mesh.prev(o))};
  }

  // Flips edges for which `is_good(h)` is false, and calls `after_flip(h)`. Returns the number of
  // flips.
  template <typename Is_good, typename After_flip>
  std::size_t flip_until(const Is_good& is_good, const After_flip& after_flip)
  {
    std::size_t count = 0;
    const std::size_t limit =
      Intrinsic_triangulations::internal::default_flip_limit(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      m_stack.push(e);
    Intrinsic_triangulations::internal::flip_waiting(
      m_mesh, m_stack, is_good, [&](Halfedge_index h) {
        if(count++ == limit)
          throw Intrinsic_triangulations::Flip_limit_exceeded(
            "not Delaunay after as many Ptolemy flips as are allowed");
        flip(h);
        after_flip(h);
      });
    return count;
  }

  // \pre `flip_status(h, mesh())` says that it is possible
  void flip(Halfedge_index h)
  {
    m_length[Edge_index(h).idx()] = m_geometry.compute_flipped_length_object()(diamond(h));
    flip_edge(h, m_mesh);
  }

private:
  Intrinsic_triangulations::Ideal_geometry_traits<FT> m_geometry;
  Delta_complex m_mesh;
  std::vector<FT> m_length;
  Intrinsic_triangulations::internal::Edge_stack m_stack;
};

// The horocyclic arcs of two decorated triangles ijk and jil, each multiplied by the length of ij
// (Equation 4.15).
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

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PTOLEMY_SURFACE_H
