// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_FLATTENED_STAR_H
#define CGAL_INTRINSIC_SIMPLIFICATION_FLATTENED_STAR_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/Removal_status.h>
#include <CGAL/Intrinsic_simplification/internal/operations/angles.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Finds the first outgoing halfedge of a star to each neighbor, by a small hash table that remains
// in the cache.
class First_halfedges
{
public:
  void start(std::size_t number_of_outgoing_halfedges)
  {
    m_bits = 3;
    while((std::size_t(1) << m_bits) < 2 * number_of_outgoing_halfedges)
      ++m_bits;
    m_entries.assign(std::size_t(1) << m_bits, {Vertex_index(), none});
  }

  // Returns the index of the first outgoing halfedge to `j`, or `n` if none has been added before.
  std::size_t first(Vertex_index j, std::size_t n)
  {
    std::size_t place = (j.idx() * 2654435769U) >> (32 - m_bits);
    while(m_entries[place].second != none && m_entries[place].first != j)
      place = (place + 1) % m_entries.size();
    if(m_entries[place].second == none)
      m_entries[place] = {j, static_cast<std::uint32_t>(n)};
    return m_entries[place].second;
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t m_bits = 0;
  std::vector<std::pair<Vertex_index, std::uint32_t>> m_entries;
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// an edge that leaves the center of a star, with its length and direction before the center is
/// flattened.
struct Star_halfedge
{
  Halfedge_index halfedge;             ///< the halfedge from the center
  Vertex_index neighbor;               ///< the target of the halfedge
  double length;                       ///< the length of the edge
  std::complex<double> direction;      ///< its direction at the center, of length one
  std::complex<double> direction_back; ///< the direction of the opposite halfedge at the neighbor
  /// the change of the angle at the neighbor, in the two faces of the outgoing halfedge, by
  /// flattening. The curvature of the neighbor changes by its negative
  double angle_change;
  /// the share of this outgoing halfedge in the total change (Equation 5.7). Shares are equal if
  /// the center is already flat, and zero for loops
  double weight;
  /// the index of the first outgoing halfedge with this neighbor
  std::size_t first_with_neighbor;
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the faces around a vertex, and the scale of the vertex that makes them flat (Section 5.1.1).
///
/// The center gets the scale factor \f$u\f$: the length of an edge is multiplied by \f$e^{u/2}\f$
/// for each end at the center. The other edges of the star keep their lengths. The sum of angles at
/// the center decreases strictly with \f$u\f$. So at most one \f$u\f$ makes it \f$2\pi\f$ at an
/// interior vertex, or \f$\pi\f$ on the boundary, which becomes straight.
///
/// An object can be reused for other vertices; it keeps its memory.
class Flattened_star
{
public:
  /// computes the outgoing halfedges of `v` and its scale factor. A scale factor other than zero
  /// has about half of its digits, enough for a cost. Complexity: linear in the degree of `v`, for
  /// each step of Newton's method.
  /// \returns whether `v` can be flattened; if it can, the functions below return the result
  Removal_status flatten(Vertex_index v, const Intrinsic_surface& surface)
  {
    const Removal_status status = collect(v, surface);
    if(status != Removal_status::possible)
      return status;
    if(!solve(internal::nearly_flat))
      return Removal_status::not_flattenable;
    set_angle_changes();
    set_weights();
    return Removal_status::possible;
  }

  /// computes the scale factor up to rounding. Angle changes and shares do not change. Complexity:
  /// see `flatten()`.
  /// \returns whether the center can be flattened after all
  bool sharpen() { return solve(internal::angle_rounding(size())); }

  /// returns the center.
  Vertex_index center() const { return m_center; }

  /// returns whether the center is on the boundary.
  bool is_border() const { return m_is_border; }

  /// returns whether an edge is a loop at the center.
  bool has_loop() const { return m_has_loop; }

  /// returns the number of outgoing halfedges; a loop counts twice.
  std::size_t size() const { return m_outgoing_halfedges.size(); }

  /// returns the number of corners of faces at the center.
  std::size_t number_of_corners() const { return size() - (m_is_border ? 1 : 0); }

  /// returns the outgoing halfedge with index `n`, in counterclockwise order; at the boundary the
  /// first and the last are border edges.
  const Star_halfedge& operator[](std::size_t n) const { return m_outgoing_halfedges[n]; }

  /// returns the outgoing halfedge after `n` in counterclockwise order.
  std::size_t next(std::size_t n) const { return n + 1 == size() ? 0 : n + 1; }

  /// returns the scale factor \f$u\f$; exactly zero if the center is flat up to rounding.
  double scale_factor() const { return m_u; }

  /// returns the rounding error of the sum of angles at the center. It is large if faces are thin.
  double angle_rounding() const { return rounding_of(excess()); }

  /// returns the increase of the area of the star by flattening, to about half of the digits.
  double area_change() const { return m_area_change; }

  /// returns the length of an outgoing halfedge after flattening.
  double flat_length(std::size_t n) const
  {
    return m_outgoing_halfedges[n].length * m_power[ends(n)];
  }

  /// returns the length of the edge opposite to the center, between the outgoing halfedges `n` and
  /// `next(n)`, after flattening.
  double flat_opposite_length(std::size_t n) const
  {
    return m_opposite[n] * m_power[opposite_ends(n)];
  }

private:
  // Represents the sides of the triangle between two outgoing halfedges.
  struct Corner
  {
    double p, q, opposite;
  };

  // Stores the sum of the angles at the center for a scale factor, minus the angle of a flat
  // vertex.
  struct Angle_excess
  {
    double value;      // positive if the sum is too large
    double derivative; // with respect to the scale factor
    bool is_valid;     // whether there are triangles with these sides
  };

  typedef std::complex<double> Complex;

  double flat_angle() const { return (m_is_border ? 1 : 2) * pi<double>(); }

  // Returns the number of ends of an outgoing halfedge at the center.
  std::size_t ends(std::size_t n) const
  {
    return m_outgoing_halfedges[n].neighbor == m_center ? 2 : 1;
  }

  std::size_t opposite_ends(std::size_t n) const { return ends(n) + ends(next(n)) - 2; }

  Corner corner(std::size_t n) const
  {
    return {flat_length(n), flat_length(next(n)), flat_opposite_length(n)};
  }

  Corner original_corner(std::size_t n) const
  {
    return {m_outgoing_halfedges[n].length, m_outgoing_halfedges[next(n)].length, m_opposite[n]};
  }

  void set_scale(double u)
  {
    m_u = u;
    m_power[1] = std::exp(u / 2);
    m_power[2] = m_power[1] * m_power[1];
  }

  Removal_status collect(Vertex_index v, const Intrinsic_surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    m_center = v;
    m_outgoing_halfedges.clear();
    m_opposite.clear();
    m_has_loop = false;
    set_scale(0);
    if(mesh.is_isolated(v))
      return Removal_status::isolated;
    bool is_protected = false;
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      is_protected = is_protected || surface.is_constrained(mesh.edge(h));
      add_outgoing(h, surface);
    });
    m_is_border = mesh.is_border(m_outgoing_halfedges.back().halfedge);
    if(is_protected)
      return Removal_status::protected_vertex;
    return m_has_loop ? status_with_loops() : degree_status();
  }

  void add_outgoing(Halfedge_index h, const Intrinsic_surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    const Vertex_index j = mesh.target(h);
    m_has_loop = m_has_loop || j == m_center;
    m_outgoing_halfedges.push_back({h, j, surface.length(h), surface.direction(h),
                                    surface.direction(opposite(h)), 0, 0,
                                    m_outgoing_halfedges.size()});
    m_opposite.push_back(mesh.is_border(h) ? 0 : surface.length(mesh.next(h)));
  }

  Removal_status degree_status() const
  {
    return size() < 3 ? Removal_status::low_degree : Removal_status::possible;
  }

  Removal_status status_with_loops() const
  {
    if(m_is_border && (ends(0) == 2 || ends(size() - 1) == 2))
      return Removal_status::border_loop;
    for(std::size_t n = 0; n < number_of_corners(); ++n)
      if(opposite_ends(n) == 2)
        return Removal_status::self_face;
    return degree_status();
  }

  Angle_excess excess() const
  {
    namespace IT = Intrinsic_triangulations;
    internal::Angle_sum sum;
    Angle_excess result{0, 0, true};
    for(std::size_t n = 0; n < number_of_corners(); ++n) {
      const Corner c = corner(n);
      const double product = IT::doubled_corner_product(c.opposite, c.p, c.q);
      const double area = IT::quadrupled_area(c.opposite, c.p, c.q);
      const double scale = 1 / (2 * c.p * c.q);
      sum.add(product * scale, area * scale);
      if(area > internal::rounding_unit() * (c.p * c.q))
        result.derivative += angle_derivative(n, c, product) / area;
      else
        result.is_valid = false;
    }
    result.value = sum.minus(flat_angle());
    return result;
  }

  // Returns the derivative of the angle by the scale factor, times four times the area.
  double angle_derivative(std::size_t n, const Corner& c, double product) const
  {
    if(!m_has_loop)
      return -c.opposite * c.opposite;
    const double p = static_cast<double>(ends(n)), q = static_cast<double>(ends(next(n)));
    return (p + q - 2) * c.opposite * c.opposite - p * c.p * c.p - q * c.q * c.q +
           (p + q) * product / 2;
  }

  // Returns the rounding error of an excess. On thin faces, rounding of their lengths changes it
  // most. An error that lengths cannot have, see `length_rounding`, does not count.
  double rounding_of(const Angle_excess& e) const
  {
    const double by_lengths =
      internal::roundings_of_scale * internal::rounding_unit() * std::abs(e.derivative);
    return (std::max)(internal::angle_rounding(size()),
                      (std::min)(by_lengths, internal::length_rounding));
  }

  // Applies Newton's method, restricted to the interval in which the excess changes its sign. A
  // last step squares an excess of `tolerance`. On thin faces, all steps can leave a rounding
  // error. Beyond the triangle inequality an angle counts as 0 or pi, so that the excess is
  // continuous and decreases everywhere.
  bool solve(double tolerance)
  {
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for(int step = 0; step < 100; ++step) {
      const Angle_excess e = excess();
      if(std::abs(e.value) <= internal::angle_rounding(size()))
        return is_solution(e);
      (e.value > 0 ? low : high) = m_u;
      set_scale(next_scale(e, low, high));
      if(std::abs(e.value) <= tolerance)
        return is_solution(e);
    }
    const Angle_excess last = excess();
    return std::abs(last.value) <= rounding_of(last) && is_solution(last);
  }

  static bool is_solution(const Angle_excess& e)
  {
    return e.is_valid && std::abs(e.value) <= internal::greatest_last_step * std::abs(e.derivative);
  }

  double next_scale(const Angle_excess& e, double low, double high) const
  {
    const double newton = m_u - e.value / e.derivative;
    if(newton > low && newton < high && std::abs(newton - m_u) < internal::greatest_newton_step)
      return newton;
    if(std::isfinite(low) && std::isfinite(high))
      return low + (high - low) / 2;
    return e.value > 0 ? m_u + 1 : m_u - 1;
  }

  void set_angle_changes()
  {
    m_change.assign(2 * size(), Complex(1));
    m_area_change = 0;
    if(m_u != 0)
      for(std::size_t n = 0; n < number_of_corners(); ++n) {
        const Corner before = original_corner(n), after = corner(n);
        const double old_area = quadrupled_area(before), new_area = quadrupled_area(after);
        m_area_change += share(n) * (new_area - old_area) / 4;
        m_change[2 * n] = internal::turn({before.p, before.opposite, before.q, old_area},
                                         {after.p, after.opposite, after.q, new_area});
        m_change[2 * next(n) + 1] = internal::turn({before.q, before.opposite, before.p, old_area},
                                                   {after.q, after.opposite, after.p, new_area});
      }
    for(std::size_t n = 0; n < size(); ++n)
      m_outgoing_halfedges[n].angle_change = angle_change(n);
  }

  double angle_change(std::size_t n) const
  {
    const Complex &after = m_change[2 * n], &before = m_change[2 * n + 1];
    if(m_has_loop || !(after.real() > 0) || !(before.real() > 0))
      return share(n) * std::arg(after) + share(previous(n)) * std::arg(before);
    return internal::argument(after * before);
  }

  // Returns the part of a face that counts for a corner: a face with a loop has two corners at the
  // center.
  double share(std::size_t n) const
  {
    return n < number_of_corners() && opposite_ends(n) > 0 ? 0.5 : 1;
  }

  std::size_t previous(std::size_t n) const { return n == 0 ? size() - 1 : n - 1; }

  static double quadrupled_area(const Corner& c)
  {
    return Intrinsic_triangulations::quadrupled_area(c.opposite, c.p, c.q);
  }

  void set_weights()
  {
    double sum = 0;
    std::size_t others = 0;
    for(std::size_t n = 0; n < size(); ++n)
      if(ends(n) == 1) {
        sum += std::abs(m_outgoing_halfedges[n].angle_change);
        ++others;
      }
    for(std::size_t n = 0; n < size(); ++n) {
      Star_halfedge& outgoing = m_outgoing_halfedges[n];
      outgoing.weight = ends(n) == 2 ? 0
                        : sum > 0    ? std::abs(outgoing.angle_change) / sum
                                     : 1 / static_cast<double>(others);
    }
    m_neighbors.start(size());
    for(std::size_t n = 0; n < size(); ++n)
      m_outgoing_halfedges[n].first_with_neighbor =
        m_neighbors.first(m_outgoing_halfedges[n].neighbor, n);
  }

  Vertex_index m_center;
  bool m_is_border = false, m_has_loop = false;
  double m_u = 0;
  double m_area_change = 0;
  std::array<double, 3> m_power{1, 1, 1}; // by the number of ends at the center
  std::vector<Star_halfedge> m_outgoing_halfedges;
  std::vector<double> m_opposite; // of each corner
  std::vector<Complex> m_change;  // of the angles after and before each outgoing halfedge
  internal::First_halfedges m_neighbors;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_FLATTENED_STAR_H
