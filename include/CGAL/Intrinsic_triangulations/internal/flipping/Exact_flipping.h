// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_decisions_of.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns how far the apex k of a triangle that is laid out along its side c is displaced if each
// side has a relative error of `error`, and infinity if that may not be small. A change of side a
// moves k along the circle around the end of b, by more than that change by the inverse of the sine
// of the angle at k, and so does a change of b or c. The bound is twice the sum, as the sine may
// change, too, and includes the rounding of the layout.
inline double apex_displacement(double a, double b, double c, double error)
{
  const double area = quadrupled_area(a, b, c), perimeter = a + b + c;
  const double change = error * perimeter;
  if(!(16 * change * (a + b) * a * b <= area * area))
    return std::numeric_limits<double>::infinity();
  return 4 * change * a * b / area + 32 * std::numeric_limits<double>::epsilon() * perimeter;
}

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
                                             ? 4 * std::numeric_limits<double>::epsilon()
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
    const Uncertain<bool> by_lengths = m_by_lengths(diamond(m_tri.length_map(), h, m_mesh));
    return is_certain(by_lengths) ? get_certain(by_lengths)
                                  : m_decisions.Delaunay_sign(h) != NEGATIVE;
  }

  // returns true: it is always possible
  bool flip(Halfedge_index h)
  {
    const Diamond<double> length = diamond(m_tri.length_map(), h, m_mesh);
    const double flipped = m_by_formula(length), bound = flipped_error(length, h) / flipped;
    const bool is_good = bound <= certified_length_error() / 2;
    const Edge_index e = m_mesh.edge(h);
    m_tri.turn(h, [&] {
      return is_good && !m_tri.coordinates().is_shared(e) ? flipped : m_decisions.length(h);
    });
    m_error[e.idx()] = static_cast<float>(is_good ? 2 * bound : certified_length_error());
    return true;
  }

  // Computes all lengths anew.
  void recompute_lengths()
  {
    for(Edge_index e : m_mesh.edges())
      m_tri.m_length[e] = m_decisions.length(m_mesh.halfedge(e));
  }

private:
  // the absolute error of the length by which the edge of `h` would be replaced
  double flipped_error(const Diamond<double>& length, Halfedge_index h) const
  {
    const Halfedge_index o = m_mesh.opposite(h);
    float error = 0;
    for(Halfedge_index side : {h, m_mesh.next(h), m_mesh.prev(h), m_mesh.next(o), m_mesh.prev(o)})
      error = (std::max)(error, m_error[m_mesh.edge(side).idx()]);
    return apex_displacement(length.jk, length.ki, length.ij, double(error)) +
           apex_displacement(length.il, length.lj, length.ij, double(error));
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Exact_decisions<Traits, Crossings> m_decisions;
  Exact_Euclidean_geometry_traits<>::Is_locally_Delaunay m_by_lengths;
  Exact_Euclidean_geometry_traits<>::Compute_flipped_length m_by_formula;
  std::vector<float> m_error; // relative error bounds of the lengths
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
