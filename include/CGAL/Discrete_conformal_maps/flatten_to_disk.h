// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Fixed_point_acceleration.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/circle_angles.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>

#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// The exterior angles of a boundary whose components are circles, found by repetition: those that a
// circle has depend on the lengths in the plane.
class Circular_boundary
{
  typedef Eigen::VectorXd Vector;
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface;

public:
  // The angles of circles with the lengths that the boundary has on the surface come first.
  explicit Circular_boundary(const Surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    for(const Boundary_loop& loop : single_boundary_loops(mesh, 3, "a circle")) {
      m_circles.emplace_back();
      for(Halfedge_index h : loop)
        m_circles.back().push_back({mesh.source(h), mesh.edge(h)});
    }
    m_angle = angles([&](Edge_index e) { return surface.length(e); });
  }

  // Calls `set(v, condition)` with what the angles prescribe at each vertex of the boundary.
  template <typename Set>
  void prescribe(const Set& set) const
  {
    Eigen::Index i = 0;
    for(const Circle& circle : m_circles)
      for(const Side& side : circle)
        set(side.source, Vertex_condition::curvature(m_angle[i++]));
  }

  // Moves the angles towards those of circles with the lengths of the image, and returns the
  // greatest difference of both before.
  double update(const std::vector<double>& length)
  {
    const Vector image = angles([&](Edge_index e) { return length[e.idx()]; });
    const double change = (image - m_angle).lpNorm<Eigen::Infinity>();
    const Vector next = closed(m_acceleration.next(m_angle, image));
    // pi and above are too great for a boundary
    m_angle = (next.array() < boost::math::constants::pi<double>()).all() ? next : image;
    return change;
  }

private:
  struct Side
  {
    Vertex_index source;
    Edge_index edge;
  };
  typedef std::vector<Side> Circle;

  template <typename Length>
  Vector angles(const Length& length) const
  {
    std::vector<double> result;
    for(const Circle& circle : m_circles) {
      std::vector<double> lengths;
      for(const Side& side : circle)
        lengths.push_back(length(side.edge));
      const std::vector<double> angle = circle_angles(lengths);
      result.insert(result.end(), angle.begin(), angle.end());
    }
    return Eigen::Map<const Vector>(result.data(), Eigen::Index(result.size()));
  }

  // Scales the angles of each circle so that they sum up to a whole turn: combinations of many of
  // them lose digits.
  Vector closed(Vector angle) const
  {
    Eigen::Index begin = 0;
    for(const Circle& circle : m_circles) {
      auto own = angle.segment(begin, Eigen::Index(circle.size()));
      own *= boost::math::constants::two_pi<double>() / own.sum();
      begin += own.size();
    }
    return angle;
  }

  std::vector<Circle> m_circles;
  Vector m_angle; // at the source of each side
  Fixed_point_acceleration m_acceleration;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// maps every component of a surface to a disk, discretely conformally: its boundary vertices lie
/// on a circle.
///
/// The exterior angles of a polygon in a circle depend on the lengths of its edges, and these on
/// the angles. So the surface is flattened several times, each time with the angles for the lengths
/// before, until they change by at most \f$10^{-10}\f$; Anderson's method accelerates this. The
/// `minimization()` of the result is the last one. Where no edge of \f$T^B\f$ and \f$T^C\f$ crosses
/// the boundary, the image of a disk without cones is, up to a Moebius transformation, that of
/// `map_to_sphere()` in the plane, which takes one minimization. This function also allows several
/// components, and handles if there are cones.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh whose components have one boundary loop each; isolated
///   vertices are allowed
/// \param np the parameters of `flatten()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_condition_map}
///     \cgalParamDescription{what is prescribed at each vertex inside}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `Vertex_condition` as
///       value}
///     \cgalParamDefault{curvature zero}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_log_scale}
///     \cgalParamDescription{as for `flatten()`, for the vertices inside: none of the boundary
///       becomes a cone}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how many times the surface may be flattened}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: that of `flatten()`, as a rule about ten times.
/// \returns a map with one of the statuses of `flatten()`; if a minimization fails, the map that it
///   gave
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh, or as `flatten()`
///   does: a component with handles has no disk without cones inside
/// \throws Intrinsic_triangulations::Numerical_error if the boundary has not become a circle in
///   that number of iterations, or where numbers have not enough digits
/// \throws Intrinsic_triangulations::Overflow_error where integers have not enough digits
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map flatten_to_disk(const Graph& g,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto rounds = static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_iterations), 100));
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  std::vector<Vertex_condition> conditions =
    internal::vertex_conditions(g, input.mesh(), np, Vertex_condition());
  internal::Circular_boundary boundary(input);
  boundary.prescribe([&](Vertex_index v, const auto& c) { conditions[v.idx()] = c; });
  const auto solve = [&](auto& problem, auto& flattening, const auto& find) {
    flattening.keep_cones_inside();
    double change = 0;
    for(std::size_t i = 0; i < rounds; ++i) {
      find();
      if(!flattening.has_succeeded())
        return;
      change = boundary.update(flattening.boundary_lengths());
      if(change <= internal::tolerance::circle_angle)
        return;
      boundary.prescribe([&](Vertex_index v, const auto& c) { problem.set_condition(v, c); });
    }
    std::ostringstream text;
    text << "the boundary has not become a circle: after " << rounds
         << " rounds its angles still change by " << change << " radians";
    throw Intrinsic_triangulations::Numerical_error(text.str());
  };
  return internal::flattened(std::move(input), conditions, internal::initial_log_scales(g, np),
                             std::numeric_limits<double>::infinity(), np, solve);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
