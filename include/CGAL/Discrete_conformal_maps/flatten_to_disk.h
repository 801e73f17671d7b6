// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/maps/Flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/vertex_conditions.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Fixed_point_acceleration.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/circle_angles.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Boundary_image.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// The exterior angles of a boundary whose components are circles, found by repetition: those that a
// circle has depend on the lengths in the plane.
class Circular_boundary : public Free_shape
{
  typedef Eigen::VectorXd Vector;
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface;

public:
  // The angles of circles with the lengths that the boundary has on the surface come first.
  // `rounds` is how many times they may be changed.
  Circular_boundary(const Surface& surface, std::size_t rounds)
    : m_components(surface.mesh()), m_rounds(rounds)
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

  // Finds scale factors until the angles are those of circles, or have been changed often enough.
  template <typename Flattening, typename Find>
  void solve(Doubled_problem& problem, Flattening& flattening, const Find& find)
  {
    for(std::size_t i = 0; i < m_rounds; ++i) {
      find();
      if(!flattening.has_succeeded())
        return;
      m_change = update(flattening.boundary_lengths());
      if(m_change <= tolerance::circle_angle)
        return;
      if(i + 1 < m_rounds) // otherwise the angles stay those of the map
        prescribe([&](Vertex_index v, const auto& c) { problem.set_condition(v, c); });
    }
  }

  // Angles have changed by little in the end, and vertices have the same distance from the center
  // if the disk is not cut.
  std::vector<Map_promise> promises(const Planar_conformal_map& map,
                                    const std::vector<char>& is_whole) const
  {
    const Boundary_image image(map);
    double radius = 0;
    for(const Circle& circle : m_circles) {
      Boundary_image::Vertices vertices;
      for(const Side& side : circle)
        vertices.push_back(side.source);
      if(is_whole[m_components[vertices.front().idx()]])
        radius = greater_error(radius, image.radius_error(vertices));
    }
    return {{"circle_angle", m_change, tolerance::circle_angle, Map_status::not_circular},
            {"equal_radii", radius, tolerance::promised_length, Map_status::not_circular}};
  }

private:
  struct Side
  {
    Vertex_index source;
    Edge_index edge;
  };
  typedef std::vector<Side> Circle;

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

  Intrinsic_triangulations::Mesh_components m_components;
  std::size_t m_rounds;
  std::vector<Circle> m_circles;
  Vector m_angle;                                            // at the source of each side
  double m_change = std::numeric_limits<double>::infinity(); // of the angles, in the last round
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
///   \cgalParamNBegin{cones}
///     \cgalParamDescription{as for `flatten()`: none of the boundary becomes a cone}
///     \cgalParamType{`Cones`}
///     \cgalParamDefault{`Cones::automatic`: yes if there is a `maximum_log_scale`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how many times the surface may be flattened}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: that of `flatten()`, as a rule about ten times.
/// \returns a map with one of the statuses of `flatten()`, or `Map_status::not_circular` if the
///   boundary has not become a circle in that number of iterations; if a minimization fails, the
///   map that it gave
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh, or as `flatten()`
///   does: a component with handles has no disk without cones inside
/// \throws Intrinsic_triangulations::Numerical_error, Intrinsic_triangulations::Overflow_error as
///   `flatten()` does
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map flatten_to_disk(const Graph& g,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto rounds = static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_iterations), 100));
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  std::vector<Vertex_condition> conditions =
    internal::vertex_conditions(g, input.mesh(), np, Vertex_condition());
  internal::Circular_boundary boundary(input, rounds);
  boundary.prescribe([&](Vertex_index v, const auto& c) { conditions[v.idx()] = c; });
  return internal::flattened(std::move(input), conditions, internal::initial_log_scales(g, np),
                             false, np, std::move(boundary));
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
