// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIPPED_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIPPED_LENGTHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Keeps the lengths of T2 with more digits than `double` has. They begin with lengths on the exact
// surface of T1. The length of a flipped edge follows from its diamond, in constant time.
template <typename Traits, typename FT_>
class Flipped_lengths
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  typedef FT_ FT;

  // \pre the edges of T2 are straight
  explicit Flipped_lengths(Triangulation& tri) : m_tri(tri), m_flipping(tri)
  {
    Precise_lengths<Traits, FT> lengths(tri);
    m_length.resize(tri.mesh().num_edges());
    for(Edge_index e : tri.mesh().edges())
      m_length[e.idx()] = lengths(tri.mesh().halfedge(e));
  }

  const Triangulation& triangulation() const { return m_tri; }

  auto length_map() const
  {
    return boost::make_function_property_map<Edge_index>(
      [this](Edge_index e) { return m_length[e.idx()]; });
  }

  Diamond<FT> diamond(Halfedge_index h) const
  {
    return Intrinsic_triangulations::diamond(length_map(), h, m_tri.mesh());
  }

  bool can_be_turned(Halfedge_index h) const { return m_flipping.can_be_turned(h); }

  // Flips the edge of `h`, and returns whether its length is positive and finite.
  bool flip(Halfedge_index h)
  {
    const FT length = typename Euclidean_geometry_traits<FT>::Compute_flipped_length()(diamond(h));
    const double rounded = to_double(length);
    const bool result = m_tri.traits().is_length_object()(rounded) &&
                        m_flipping.flip(h, {rounded, certified_length_error()});
    if(result)
      m_length[m_tri.mesh().edge(h).idx()] = length;
    return result;
  }

  // Stores the lengths of T2 on the exact surface, rounded.
  void store() { m_flipping.recompute_lengths(rounding_unit<double>() / 2); }

private:
  Triangulation& m_tri;
  Exact_flipping<Traits> m_flipping;
  std::vector<FT> m_length;
};

// Flips by lengths with twice the digits of `double`.
template <typename Traits>
class Precise_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  explicit Precise_flipping(Triangulation& tri) : m_lengths(tri) {}

  bool is_certainly_Delaunay(Edge_index e) const
  {
    return m_is_Delaunay.is_certain(m_lengths.diamond(halfedge(e)));
  }

  bool is_Delaunay(Edge_index e) const
  {
    return !m_lengths.can_be_turned(halfedge(e)) || m_is_Delaunay(m_lengths.diamond(halfedge(e)));
  }

  bool flip(Halfedge_index h) { return m_lengths.flip(h); }

private:
  Halfedge_index halfedge(Edge_index e) const
  {
    return m_lengths.triangulation().mesh().halfedge(e);
  }

  Flipped_lengths<Traits, Double_double> m_lengths;
  typename Euclidean_geometry_traits<Double_double>::Is_locally_Delaunay m_is_Delaunay;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIPPED_LENGTHS_H
