// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_PACK_CIRCLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_PACK_CIRCLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Circle_packing.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Circle_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Packing_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Conformal_barycenter.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Returns the image of a circle under z -> factor / (z - pole) + shift.
// \pre the pole is outside
inline Planar_circle inverted(const Planar_circle& circle, const std::complex<double>& pole,
                              const std::complex<double>& factor, const std::complex<double>& shift)
{
  const std::complex<double> z = circle.center - pole;
  const double power = (std::abs(z) - circle.radius) * (std::abs(z) + circle.radius);
  return {shift + factor * (std::conj(z) / power), std::abs(factor) * circle.radius / power};
}

// Stores the circles of a packing in the plane, and the points at which they touch.
class Packed_circles
{
public:
  Packed_circles(const Planar_conformal_map& map, const Packing_complex& complex)
    : m_complex(complex), m_circles(complex.rest().num_vertices()), m_status(map.status())
  {
    const auto found = {Map_status::success, Map_status::not_laid_out, Map_status::layout_collapsed,
                        Map_status::not_closed, Map_status::not_conformal};
    if(std::find(found.begin(), found.end(), m_status) != found.end())
      lay_out(map);
  }

  // Returns the status of the layout, or of the map if it has no scale factors.
  Map_status status() const { return m_status; }

  bool are_laid_out() const { return m_circles.front().radius > 0; }

  // Maps the packing to the unit disk, or to the sphere. Balances the points at which circles touch
  // the unit circle, or each other on the sphere. Returns whether rounding allows it.
  bool balance()
  {
    try {
      if(m_complex.apex().is_valid())
        move_to_disk();
      else
        move_to_sphere();
      return true;
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      return false;
    }
  }

  // Returns the circles without the circle of the apex.
  std::vector<Planar_circle> circles() const
  {
    return {m_circles.begin(), m_circles.end() - (m_complex.apex().is_valid() ? 1 : 0)};
  }

  double max_tangency_error() const
  {
    double result = 0;
    for(Edge_index e : m_complex.rest().edges())
      result = greater_error(result, tangency_error(e));
    return result;
  }

private:
  typedef std::array<double, 2> Point;

  // Squares of positions are in the range of `double`.
  static constexpr double greatest_log_radius = 345;

  // Lays out the circles. The greatest and the least logarithm of a radius become opposite, so that
  // most radii are in the range of `double`.
  void lay_out(const Planar_conformal_map& map)
  {
    std::vector<double> radius;
    for(Vertex_index v : m_complex.rest().vertices())
      radius.push_back(map.log_scale(v));
    const auto [least, greatest] = std::minmax_element(radius.begin(), radius.end());
    const double middle = (*least + *greatest) / 2;
    if(!(*greatest - middle < greatest_log_radius)) {
      m_status = Map_status::not_laid_out;
      return;
    }
    for(double& r : radius)
      r = std::exp(r - middle);
    const Circle_layout layout(m_complex.rest(), radius);
    m_circles = layout.circles();
    m_status = layout.has_reversed_faces() ? Map_status::layout_collapsed : Map_status::success;
  }

  const Planar_circle& at_end(Edge_index e, unsigned end) const
  {
    return m_circles[m_complex.rest().vertex(e, end).idx()];
  }
  bool is_at_apex(Edge_index e) const
  {
    return m_complex.rest().vertex(e, 0) == m_complex.apex() ||
           m_complex.rest().vertex(e, 1) == m_complex.apex();
  }

  // Returns the tangency error, on the sphere or in the disk. In the disk, the circle of the apex
  // has become the unit circle, which others touch from inside.
  double tangency_error(Edge_index e) const
  {
    const Planar_circle &a = at_end(e, 0), &b = at_end(e, 1);
    if(!m_complex.apex().is_valid())
      return std::abs(distance(on_sphere(a), on_sphere(b)));
    if(!is_at_apex(e))
      return std::abs(std::abs(a.center - b.center) - (a.radius + b.radius));
    const Planar_circle& c = m_complex.rest().vertex(e, 0) == m_complex.apex() ? b : a;
    return std::abs(std::abs(c.center) + c.radius - 1);
  }

  std::complex<double> touching_point(Edge_index e) const
  {
    const Planar_circle &a = at_end(e, 0), &b = at_end(e, 1);
    return a.center + (b.center - a.center) * (a.radius / (a.radius + b.radius));
  }

  // Returns the points at which circles of edges touch, including the circle of the apex if it
  // exists.
  std::vector<Point> touching_points() const
  {
    std::vector<Point> result;
    for(Edge_index e : m_complex.rest().edges())
      if(!m_complex.apex().is_valid() || is_at_apex(e)) {
        const std::complex<double> z = touching_point(e);
        result.push_back({z.real(), z.imag()});
      }
    return result;
  }

  void move_to_sphere()
  {
    const std::vector<Point> points = touching_points();
    const Conformal_barycenter<double> center(points, std::vector<double>(points.size(), 1.),
                                              points.size());
    for(Planar_circle& c : m_circles) {
      const Point p = center.centered({c.center.real(), c.center.imag()});
      c = {{p[0], p[1]}, c.radius / center.height()};
    }
  }

  // Moves the circles to the disk. An inversion turns the circle of the apex inside out. The point
  // that balances the unit circle lies on the hemisphere above the disk. A motion of the disk moves
  // it above the origin.
  void move_to_disk()
  {
    const Planar_circle apex = m_circles.back();
    std::vector<Point> points = touching_points();
    for(Point& p : points) {
      const std::complex<double> z = apex.radius / (std::complex<double>(p[0], p[1]) - apex.center);
      p = {z.real() / std::abs(z), z.imag() / std::abs(z)};
    }
    const Conformal_barycenter<double> center(points, std::vector<double>(points.size(), 1.),
                                              points.size());
    const std::complex<double> base(center.base()[0], center.base()[1]),
      a = base / (1 + center.height());
    // The map is z -> (w - a) / (1 - conj(a) w) for w = r / (z - apex).
    const std::complex<double> pole = apex.center + std::conj(a) * apex.radius;
    for(Planar_circle& c : m_circles)
      c = inverted(c, pole, (1 - std::norm(a)) * apex.radius, -a);
  }

  const Packing_complex& m_complex;
  std::vector<Planar_circle> m_circles;
  Map_status m_status;
};

// Returns the status of a packing with this error.
inline Map_status packing_status(Map_status of_layout, double max_tangency_error)
{
  if(of_layout != Map_status::success || max_tangency_error <= tolerance::promised_angle)
    return of_layout;
  return Map_status::not_closed;
}

// Packs circles between the circles of the outer face, and balances them.
inline Circle_packing packed(const Packing_complex& complex)
{
  std::vector<Vertex_condition> condition(complex.rest().num_vertices());
  for(Vertex_index v : complex.outer_corners())
    condition[v.idx()] = Vertex_condition::log_scale(0);
  const Planar_conformal_map map =
    flatten(complex.rest(),
            parameters::edge_length_map(
              boost::make_function_property_map<Edge_index>([](Edge_index) { return 2.; }))
              .vertex_radius_map(
                boost::make_function_property_map<Vertex_index>([](Vertex_index) { return 1.; }))
              .vertex_condition_map(boost::make_function_property_map<Vertex_index>(
                [&](Vertex_index v) { return condition[v.idx()]; })));
  Packed_circles circles(map, complex);
  const double error = circles.are_laid_out() && circles.balance()
                         ? circles.max_tangency_error()
                         : std::numeric_limits<double>::quiet_NaN();
  return {circles.circles(), complex.apex().is_valid(), error,
          packing_status(circles.status(), error), map.minimization()};
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsCircles
/// packs circles on the sphere, or in the unit disk, that touch if an edge of a triangulation joins
/// their vertices (Koebe, Andreev, Thurston). Only the connectivity of `g` counts.
///
/// - A closed surface of genus zero packs the unit sphere. The packing is unique up to M&ouml;bius
///   transformations and reflections. In the result, the points at which circles touch have their
///   mean in the center.
/// - A disk packs the unit disk. The circles of the boundary touch the unit circle from inside, at
///   points whose mean is the center.
///
/// A face is removed; for a disk it is a face at an added vertex beyond the boundary. Its three
/// circles are equal and touch each other, and all others lie between them. `flatten()` computes
/// the circles, for edges of length 2 and radii 1 and a boundary that is not scaled. Circles that
/// touch are weighted Delaunay for all scale factors, so no edge is flipped. If circles far from
/// this face have too few digits, the computation restarts with the face of the greatest circles.
/// The layout starts at the smallest circle, where `double` has most digits. On the sphere, the
/// centers of circles that are smaller than rounding coincide; their radii are accurate. Radii with
/// quotients up to 10^299 are possible.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param g a connected triangle mesh of genus zero with at most one boundary, in which vertices
///   determine edges and faces
///
/// Complexity: see `flatten()`.
/// \returns the circles, with the measurements on them
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh
template <typename Graph>
Circle_packing pack_circles(const Graph& g)
{
  typedef typename boost::graph_traits<Graph>::edge_descriptor Edge;
  const Intrinsic_triangulations::Intrinsic_triangulation<> input(
    g,
    parameters::edge_length_map(boost::make_function_property_map<Edge>([](Edge) { return 2.; })));
  const Circle_packing first = internal::packed(internal::Packing_complex(input.input_mesh()));
  if(first.status() == Map_status::success || !(first.max_tangency_error() < 1))
    return first;
  std::vector<double> size;
  for(Vertex_index v : input.input_mesh().vertices())
    size.push_back(first.is_disk() ? first.circle(v).radius : first.spherical_circle(v).angle);
  const Circle_packing second =
    internal::packed(internal::Packing_complex(input.input_mesh(), std::move(size)));
  return second.max_tangency_error() < first.max_tangency_error() ? second : first;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_PACK_CIRCLES_H
