// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_TRANSPORT_COST_H
#define CGAL_INTRINSIC_SIMPLIFICATION_TRANSPORT_COST_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/internal/operations/Vertex_heap.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the cost of removing a vertex: the distance by which curvature, area, or other data on the
/// vertices would move (Section 5.3).
///
/// Each signed quantity is split into two positive masses. A vertex carries its mass and its
/// moment: the sum, over the parts of the mass, of mass times the tangent vector to its origin. A
/// removed vertex passes both to its neighbors, in the shares of Equation 5.7. Its cost is the sum
/// of the lengths of the vectors that its neighbors would have (Equation 5.5). It approximates the
/// optimal transport of the masses. All masses are fractions of their sum over the surface, so
/// costs are lengths.
///
/// Memory: for each vertex three numbers for each mass.
///
/// \cgalModels `RemovalCost`
class Transport_cost
{
public:
  /// makes a cost without masses, which is zero.
  explicit Transport_cost(const Evolving_surface& surface)
    : m_number_of_vertices(surface.mesh().num_vertices())
  {}

  /// adds the curvature of the vertices (Section 5.3.2): \f$2\pi\f$, or \f$\pi\f$ on the boundary,
  /// minus the sum of angles. Complexity: linear.
  /// \param surface the surface
  /// \param weight the factor of this part of the cost
  void add_curvature(const Evolving_surface& surface, double weight = 1)
  {
    std::vector<double> defect(m_number_of_vertices, 0);
    const Delta_complex& mesh = surface.mesh();
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        defect[v] = angle_defect(v, surface.surface());
    add_quantity(defect, weight);
  }

  /// adds the area of the surface, a third of each face for each of its corners. Complexity:
  /// linear.
  /// \param surface the surface
  /// \param weight the factor of this part of the cost
  void add_area(const Evolving_surface& surface, double weight = 1)
  {
    std::vector<double> area(m_number_of_vertices, 0);
    const Delta_complex& mesh = surface.mesh();
    for(Halfedge_index h : mesh.halfedges())
      if(!mesh.is_border(h))
        area[mesh.target(h)] += Face_metric(h, surface.surface()).quadrupled_area();
    add_quantity(area, weight);
  }

  /// adds the change of area by flattening, as a fraction of the area of the surface. Its cost is
  /// the cost of moving this area along the edges in the shares of Equation 5.7. It moves no mass.
  /// Complexity: linear.
  /// \param surface the surface
  /// \param weight the factor of this part of the cost
  void add_area_change(const Evolving_surface& surface, double weight = 1)
  {
    m_area_change_factor += weight * inverse_area(surface);
  }

  /// adds the change of area by flattening at the boundary, as a fraction of the area of the
  /// surface. Its cost is the cost of moving this area once around the boundaries of the surface.
  /// So corners of flat parts are kept, however few vertices are left. It moves no mass, and is
  /// zero on a surface without boundary. Complexity: linear.
  /// \param surface the surface
  /// \param weight the factor of this part of the cost
  void add_boundary_change(const Evolving_surface& surface, double weight = 1)
  {
    const Delta_complex& mesh = surface.mesh();
    double length = 0;
    for(Halfedge_index h : mesh.halfedges())
      if(mesh.is_border(h))
        length += surface.surface().length(h);
    m_boundary_change_factor += weight * length * inverse_area(surface);
  }

  /// adds the Laplacian of a function that is linear on the faces: the product with the cotan
  /// Laplacian. It is zero on parts on which the function is linear. So vertices remain at changes
  /// of the gradient, and the prolongation of their values is close to the function. For a color
  /// call it once for each component. Complexity: linear.
  /// \param surface the surface, Delaunay at best (`Evolving_surface::make_Delaunay()`)
  /// \param value a range of numbers, one for each vertex
  /// \param weight the factor of this part of the cost
  /// \throws Intrinsic_triangulations::Invalid_input if a value is infinite or NaN
  /// \throws Intrinsic_triangulations::Numerical_error if a face is too thin to have cotangents
  /// \pre nothing has been removed yet
  template <typename Range>
  void add_function(const Evolving_surface& surface, const Range& value, double weight = 1)
  {
    Intrinsic_triangulations::internal::check_all_finite(value, "the value");
    const std::vector<double> x(value.begin(), value.end());
    std::vector<double> laplacian(m_number_of_vertices, 0);
    const Delta_complex& mesh = surface.mesh();
    for(Halfedge_index h : mesh.halfedges())
      if(!mesh.is_border(h)) {
        const Vertex_index v = mesh.source(h), w = mesh.target(h);
        const double flux = opposite_cotangent(h, surface.surface()) / 2 * (x[w] - x[v]);
        laplacian[v] += flux;
        laplacian[w] -= flux;
      }
    add_quantity(laplacian, weight);
  }

  /// adds a signed quantity on the vertices. More vertices remain at great values. Complexity:
  /// linear.
  /// \param value a range of numbers, one for each vertex
  /// \param weight the factor of this part of the cost
  /// \throws Intrinsic_triangulations::Invalid_input if a value is infinite or NaN
  /// \pre nothing has been removed yet
  template <typename Range>
  void add_quantity(const Range& value, double weight = 1)
  {
    Intrinsic_triangulations::internal::check_all_finite(value, "the value");
    double positive = 0, negative = 0;
    for(const double x : value)
      (x > 0 ? positive : negative) += std::abs(x);
    if(positive > 0)
      add_mass(value, weight / (positive + negative));
    if(negative > 0)
      add_mass(value, -weight / (positive + negative));
  }

  /// returns the cost of removing the center of `star`. Complexity: linear in its degree, for each
  /// mass.
  double operator()(const Flattened_star& star)
  {
    find_moments(star);
    double cost = change_of_area(star);
    for(std::size_t n = 0; n < star.size(); ++n)
      if(star[n].first_with_neighbor == n && star[n].weight > 0)
        for(std::size_t c = 0; c < m_channels; ++c)
          cost +=
            std::sqrt(std::norm(m_moment[n * m_channels + c])); // far from over- and underflow
    return cost;
  }

  /// moves the masses of the center of `star` to its neighbors. Complexity: as for the cost.
  void after_removal(const Flattened_star& star)
  {
    find_moments(star);
    for(std::size_t n = 0; n < star.size(); ++n)
      for(std::size_t c = 0; c < m_channels; ++c) {
        State& target = state(star[n].neighbor, c);
        if(star[n].first_with_neighbor == n && star[n].weight > 0)
          target.moment = m_moment[n * m_channels + c];
        target.mass += star[n].weight * state(star.center(), c).mass;
      }
    for(std::size_t c = 0; c < m_channels; ++c)
      state(star.center(), c) = {0, 0};
  }

  /// returns the number of masses.
  std::size_t number_of_masses() const { return m_channels; }

  /// returns the mass with index `c` of a vertex.
  double mass(Vertex_index v, std::size_t c) const { return m_state[v * m_channels + c].mass; }

  /// returns the moment with index `c` of a vertex, in its frame: the mass times the vector to the
  /// center of its origin.
  std::complex<double> moment(Vertex_index v, std::size_t c) const
  {
    return m_state[v * m_channels + c].moment;
  }

  /// returns the sum of the lengths of the vectors over all vertices and masses. For weights that
  /// sum up to one, this is about the mean distance by which masses have moved. Complexity: linear.
  double total() const
  {
    double sum = 0;
    for(const State& s : m_state)
      sum += std::abs(s.moment);
    return sum;
  }

private:
  typedef std::complex<double> Complex;
  typedef Intrinsic_triangulations::Face_metric<double> Face_metric;

  struct State
  {
    double mass;
    Complex moment;
  };

  State& state(Vertex_index v, std::size_t c) { return m_state[v * m_channels + c]; }

  friend void prefetch_vertex(Vertex_index v, const Transport_cost* cost)
  {
    if(cost->m_channels > 0)
      internal::prefetch(&cost->m_state[v * cost->m_channels], cost->m_channels * sizeof(State));
  }

  // Returns the angle defect. A defect within rounding error counts as zero.
  static double angle_defect(Vertex_index v, const Intrinsic_surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    double sum = 0;
    std::size_t corners = 0;
    bool is_border = false;
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      if(mesh.is_border(h))
        is_border = true;
      else
        sum += surface.corner_angle(h);
      ++corners;
    });
    const double defect = (is_border ? 1 : 2) * pi<double>() - sum;
    return std::abs(defect) > internal::angle_rounding(corners) ? defect : 0;
  }

  static double opposite_cotangent(Halfedge_index h, const Intrinsic_surface& surface)
  {
    const double result = Face_metric(h, surface).cotangent(0);
    if(!std::isfinite(result))
      throw Intrinsic_triangulations::Numerical_error("a face has no area");
    return result;
  }

  // Returns the inverse of the area, or zero for a surface without area.
  static double inverse_area(const Evolving_surface& surface)
  {
    double quadrupled = 0;
    for(Face_index f : surface.mesh().faces())
      quadrupled += Face_metric(f, surface.surface()).quadrupled_area();
    return quadrupled > 0 ? 4 / quadrupled : 0;
  }

  // Returns the cost of the change of area by flattening.
  double change_of_area(const Flattened_star& star) const
  {
    const double boundary = star.is_border() ? m_boundary_change_factor : 0;
    return std::abs(star.area_change()) * (m_area_change_factor * mean_length(star) + boundary);
  }

  // Returns the mean distance from the center, weighted by the shares of the neighbors.
  static double mean_length(const Flattened_star& star)
  {
    double sum = 0;
    for(std::size_t n = 0; n < star.size(); ++n)
      sum += star[n].weight * star[n].length;
    return sum;
  }

  // Adds the positive part of `factor * value` as another mass of each vertex.
  template <typename Range>
  void add_mass(const Range& value, double factor)
  {
    std::vector<State> states(m_number_of_vertices * (m_channels + 1), State{0, 0});
    auto x = value.begin();
    for(std::size_t v = 0; v < m_number_of_vertices; ++v, ++x) {
      for(std::size_t c = 0; c < m_channels; ++c)
        states[v * (m_channels + 1) + c] = m_state[v * m_channels + c];
      states[v * (m_channels + 1) + m_channels].mass = (std::max)(factor * *x, 0.);
    }
    m_state.swap(states);
    ++m_channels;
  }

  // Computes the moments of the neighbors after the removal (Equations 5.6 and 5.8, times the
  // mass), each at its first outgoing halfedge.
  void find_moments(const Flattened_star& star)
  {
    m_moment.resize(star.size() * m_channels);
    for(std::size_t n = 0; n < star.size(); ++n)
      if(star[n].first_with_neighbor == n)
        for(std::size_t c = 0; c < m_channels; ++c)
          m_moment[n * m_channels + c] = state(star[n].neighbor, c).moment;
    for(std::size_t n = 0; n < star.size(); ++n)
      if(star[n].weight > 0)
        add_share(star, n);
  }

  void add_share(const Flattened_star& star, std::size_t n)
  {
    const Star_halfedge& outgoing = star[n];
    const Complex& back = outgoing.direction_back;
    const Complex transport = -back * std::conj(outgoing.direction);
    for(std::size_t c = 0; c < m_channels; ++c) {
      const State& s = state(star.center(), c);
      m_moment[outgoing.first_with_neighbor * m_channels + c] +=
        outgoing.weight * (transport * s.moment + s.mass * outgoing.length * back);
    }
  }

  std::size_t m_number_of_vertices, m_channels = 0;
  double m_area_change_factor = 0, m_boundary_change_factor = 0;
  std::vector<State> m_state;    // of each vertex, all masses together
  std::vector<Complex> m_moment; // of the outgoing halfedges of the star at hand
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_TRANSPORT_COST_H
