// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Delaunay_by_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_decisions_of.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Edge_stack.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Exact decisions about flips, and lengths that stay within `certified_length_error()`: that of a
// flipped edge comes from its diamond as long as error bounds allow, otherwise from its strip.
template <typename Traits>
class Exact_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef Traced_crossings<Traits> Crossings;

public:
  // \pre the stored lengths are within `certified_length_error()`
  explicit Exact_flipping(Triangulation& tri)
    : m_tri(tri), m_mesh(tri.mesh()), m_decisions(tri, Crossings(tri))
  {
    // an edge of T1 has a length of a few roundings
    m_error.reserve(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      m_error.push_back(static_cast<float>(m_decisions.is_input_edge(m_mesh.halfedge(e))
                                             ? input_length_error()
                                             : certified_length_error()));
  }

  bool is_certainly_Delaunay(Edge_index e) const
  {
    return m_by_lengths.is_certain(diamond(m_tri.length_map(), m_mesh.halfedge(e), m_mesh));
  }

  bool is_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    if(!m_tri.can_be_turned(h))
      return true;
    return m_decisions.is_Delaunay(h, is_straight_in_space(greatest_error_around(h)));
  }

  bool can_be_turned(Halfedge_index h) const { return m_tri.can_be_turned(h); }

  Exact_decisions<Traits, Crossings>& decisions() { return m_decisions; }

  // returns true: it is always possible
  bool flip(Halfedge_index h)
  {
    const double error = greatest_error_around(h);
    const Bounded_length flipped = flipped_length(diamond(m_tri.length_map(), h, m_mesh), error);
    const Edge_index e = m_mesh.edge(h);
    const double in_plane = is_straight_in_space(error) ? length_in_plane(h, flipped.length) : 0;
    m_tri.turn(h, [&] {
      return m_tri.coordinates().is_shared(e) ? m_tri.shared_length(h)
             : in_plane > 0                   ? in_plane
             : flipped.is_good()              ? flipped.length
                                              : m_decisions.length(h);
    });
    m_error[e.idx()] =
      static_cast<float>(in_plane > 0 || m_decisions.is_input_edge(h) ? input_length_error()
                         : flipped.is_good()                          ? 2 * flipped.error
                                                                      : certified_length_error());
    return true;
  }

  // Computes all lengths anew.
  void recompute_lengths()
  {
    const auto length = [this](Halfedge_index h) { return m_decisions.length(h); };
    m_tri.set_lengths(length);
  }

  // Sets all lengths of `tri`. If `length()` throws, nothing has changed.
  template <typename Length>
  static void set_lengths(Triangulation& tri, Length& length)
  {
    tri.set_lengths(length);
  }

private:
  double greatest_error_around(Halfedge_index h) const
  {
    float error = m_error[m_mesh.edge(h).idx()];
    for(Edge_index e : edges_around(h, m_mesh))
      error = (std::max)(error, m_error[e.idx()]);
    return double(error);
  }

  // Whether edges are straight lines in space, or edges of T1, as those with the least error are.
  static bool is_straight_in_space(double error) { return error == float(input_length_error()); }

  // Returns the length of the other diagonal if the faces at the edge of `h`, whose sides are straight
  // in space, lie in one plane, and 0 otherwise. There its ends are as far apart as on the surface.
  // What could underflow is left out.
  double length_in_plane(Halfedge_index h, double flipped_length)
  {
    const auto& points = m_tri.input_metric().points;
    if(points.empty())
      return 0;
    const auto u = vector_between<double>(points[m_mesh.target(m_mesh.next(h))],
                                          points[m_mesh.target(m_mesh.next(m_mesh.opposite(h)))]);
    const double distance = std::sqrt(dot(u, u));
    const bool is_in_plane = !m_tri.coordinates().is_shared(m_mesh.edge(h)) ||
                             (std::abs(distance - flipped_length) < 1e-6 * distance &&
                              m_decisions.is_flat(m_tri.input_halfedge(h)));
    return is_in_plane && distance > 1e-100 ? distance : 0;
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Exact_decisions<Traits, Crossings> m_decisions;
  Delaunay_by_lengths m_by_lengths;
  std::vector<float> m_error; // relative error bounds of the lengths
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
