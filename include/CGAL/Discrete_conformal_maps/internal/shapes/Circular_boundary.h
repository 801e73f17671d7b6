// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCULAR_BOUNDARY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCULAR_BOUNDARY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/maps/Flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Round_disk.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/circle_angles.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/flat_boundary_lengths.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Boundary_image.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Finds a fixed point of a function in fewer evaluations than by iteration. A step leads to the
// fixed point of the linear function through the last evaluations (Anderson acceleration).
class Fixed_point_acceleration
{
public:
  typedef Eigen::VectorXd Vector;

  // Returns whether the function has been evaluated, and the best argument.
  bool has_best() const { return m_image.size() > 0; }
  Vector best() const { return m_image - m_residual; }

  // Returns the next argument of the function, whose value at `x` is `image`. The sum of entries is
  // the sum of the entries of the images.
  Vector next(const Vector& x, const Vector& image)
  {
    remember(image, image - x);
    if(m_image_steps.empty())
      return image;
    const auto n = static_cast<Eigen::Index>(m_image_steps.size());
    Eigen::MatrixXd image_steps(x.size(), n), residual_steps(x.size(), n);
    for(Eigen::Index i = 0; i < n; ++i) {
      image_steps.col(i) = m_image_steps[static_cast<std::size_t>(i)];
      residual_steps.col(i) = m_residual_steps[static_cast<std::size_t>(i)];
    }
    return m_image - image_steps * residual_steps.colPivHouseholderQr().solve(m_residual);
  }

private:
  static constexpr std::size_t memory = 5;

  void remember(const Vector& image, const Vector& residual)
  {
    if(m_image.size() > 0) {
      m_image_steps.push_back(image - m_image);
      m_residual_steps.push_back(residual - m_residual);
      if(m_image_steps.size() > memory) {
        m_image_steps.pop_front();
        m_residual_steps.pop_front();
      }
      if(!(residual.norm() < m_residual.norm()))
        return;
    }
    m_image = image;
    m_residual = residual;
  }

  // Stores differences of images and residuals to the best ones before.
  std::deque<Vector> m_image_steps, m_residual_steps;
  Vector m_image, m_residual; // the best ones
};

// Prescribes the exterior angles of a boundary whose components are circles. An iteration finds the
// angles, because they depend on the lengths in the plane.
class Circular_boundary : public Free_shape
{
  typedef Eigen::VectorXd Vector;
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface;

public:
  // The first angles are the angles of circles with the lengths of the boundary on the surface. If
  // there are no such circles, they are the angles of regular polygons.
  // \throws Invalid_input if vertices have circles
  Circular_boundary(const Surface& surface, const Map_parameters& parameters)
    : m_components(surface.mesh()), m_rounds(parameters.number_of_rounds)
  {
    if(Vertex_circles(parameters.radii).exist())
      throw Intrinsic_triangulations::Invalid_input(
        "the centers of circles at the boundary do not lie on a circle: use map_to_sphere()");
    const Delta_complex& mesh = surface.mesh();
    for(const Boundary_loop& loop : single_boundary_loops(mesh, 3, "a circle")) {
      m_circles.emplace_back();
      for(Halfedge_index h : loop)
        m_circles.back().push_back({mesh.source(h), mesh.edge(h)});
    }
    m_angle = angles([&](Edge_index e) { return surface.length(e); });
    for_each_circle(m_angle, [](auto own) {
      if(!own.allFinite())
        own.setConstant(2 * CGAL_PI / double(own.size()));
    });
  }

  void prescribe(std::vector<Vertex_condition>& conditions) const
  {
    for_each_condition([&](Vertex_index v, const Vertex_condition& c) { conditions[v.idx()] = c; });
  }

  // Finds scale factors until the angles are the angles of circles, or the number of rounds is
  // reached.
  template <typename Find>
  void solve(Doubled_problem& problem, Flattening& flattening, const Find& find)
  {
    if(is_crowded_polygon(problem) && take_polygon(problem, flattening))
      return;
    repeat(problem, flattening, find);
    if(!(flattening.has_succeeded() && m_change <= tolerance::circle_angle) && is_polygon(problem))
      take_polygon(problem, flattening);
  }

  // Returns the promises: angles have changed little in the last round. If the disk is not cut,
  // vertices have the same distance from the center.
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
  // Calls `set(v, condition)` with the condition that the angles prescribe at each vertex of the
  // boundary.
  template <typename Set>
  void for_each_condition(const Set& set) const
  {
    Eigen::Index i = 0;
    for(const Circle& circle : m_circles)
      for(const Side& side : circle)
        set(side.source, Vertex_condition::curvature(m_angle[i++]));
  }

  struct Side
  {
    Vertex_index source;
    Edge_index edge;
  };
  typedef std::vector<Side> Circle;

  // This number of rounds suffices for most disks.
  static constexpr std::size_t usual_rounds = 20;
  // If scale factors exceed the range of `double`, rounds are slow. Then only the angles of the
  // hemisphere are close enough to the angles of the circle.
  static constexpr std::size_t greatest_number_of_wide_rounds = 10;

  // Beyond this spread of scale factors, faces lose their shape in the picture.
  static constexpr double usual_spread = 18;

  // Returns whether the first angles are far from the angles of the surface. Then the next angles
  // are also far from them. Searches with bounded differences take long, and searches for a
  // hemisphere take longer.
  static bool is_far_off(const Flattening& flattening)
  {
    return flattening.minimization().iterations > 16 && !flattening.has_bounded_differences();
  }

  bool is_disk(const Doubled_problem& problem) const
  {
    return m_circles.size() == 1 &&
           problem.topology()[m_components[m_circles[0][0].source.idx()]].genus == 0;
  }
  // Returns whether only a flat metric is prescribed inside.
  static bool is_flat(const Doubled_problem& problem)
  {
    const Vector target = problem.target_defect();
    for(Vertex_index v : problem.surface().vertices())
      if(!problem.is_isolated(v) && !problem.is_on_boundary(v) &&
         (problem.is_fixed()[v.idx()] || target[Eigen::Index(v.idx())] != 0))
        return false;
    return problem.flipping() == Flipping::to_Delaunay;
  }
  bool is_polygon(const Doubled_problem& problem) const
  {
    return is_disk(problem) && is_flat(problem) && !has_vertices_inside(problem);
  }

  // Returns whether a polygon is crowded. Disks that are not crowded need few digits.
  bool is_crowded_polygon(Doubled_problem& problem) const
  {
    if(!is_polygon(problem))
      return false;
    const auto polygon = round_polygon<Double_double>(problem, sources());
    return !polygon || spread(polygon->log_scale) > usual_spread;
  }

  // Returns the vertices of the only circle.
  std::vector<Vertex_index> sources() const
  {
    std::vector<Vertex_index> result;
    for(const Side& side : m_circles[0])
      result.push_back(side.source);
    return result;
  }

  // Uses the scale factors of an inscribed polygon. The polygon must have its exterior angles with
  // rounded lengths, or else with lengths of the exact surface.
  bool take_polygon(Doubled_problem& problem, Flattening& flattening)
  {
    const Vector angle_before = m_angle;
    if(is_polygon_taken(problem, flattening) ||
       (problem.make_precise() && is_polygon_taken(problem, flattening)))
      return true;
    m_angle = angle_before;
    prescribe(problem);
    return false;
  }
  bool is_polygon_taken(Doubled_problem& problem, Flattening& flattening)
  {
    problem.straighten_boundaries();
    const auto polygon = round_polygon<Decimal_1500>(problem, sources());
    if(!polygon || !take_angles(*polygon))
      return false;
    prescribe(problem);
    const auto error = exterior_angle_error(problem, *polygon);
    if(!error || !(*error <= tolerance::promised_angle))
      return false;
    m_change = (angles([&](Edge_index e) { return polygon->side_length[e.idx()]; }) - m_angle)
                 .lpNorm<Eigen::Infinity>();
    flattening.take(polygon->log_scale, polygon->flips);
    return true;
  }

  void prescribe(Doubled_problem& problem) const
  {
    for_each_condition([&](Vertex_index v, const auto& c) { problem.set_condition(v, c); });
  }

  // Uses the angles of a disk, if they are less than pi.
  bool take_angles(const Round_disk& disk)
  {
    const std::vector<double> angle = angles_between(disk.half_arc);
    if(*std::max_element(angle.begin(), angle.end()) >= CGAL_PI)
      return false;
    m_angle = closed(Eigen::Map<const Vector>(angle.data(), m_angle.size()));
    m_acceleration = Fixed_point_acceleration();
    return true;
  }

  template <typename Find>
  void repeat(Doubled_problem& problem, Flattening& flattening, const Find& find)
  {
    bool has_started_again = false;
    std::size_t wide_rounds = 0;
    for(std::size_t i = 0; i < m_rounds; ++i) {
      find();
      bool has_next = false; // angles for the next round
      if(flattening.has_succeeded()) {
        m_change = update(flat_boundary_lengths(problem, flattening.scale_factors()));
        if(m_change <= tolerance::circle_angle || (flattening.scale_factors().is_wide() &&
                                                   ++wide_rounds == greatest_number_of_wide_rounds))
          return;
        has_next = m_acceleration.has_best();
      }
      if(!has_next && has_started_again)
        return;
      if(!has_started_again && (!has_next || i + 1 == usual_rounds || is_far_off(flattening))) {
        has_started_again = true;
        if(!start_from_hemisphere(problem, flattening, has_next) && !has_next)
          return;
      }
      if(i + 1 < m_rounds) // the last map keeps its angles
        prescribe(problem);
    }
  }

  // Uses angles and scale factors of the map of the disk to a hemisphere. Unless edges of T_3 cross
  // the boundary, this map is its stereographic projection. Otherwise, the angles are close to the
  // projected angles. They are used if the search succeeds and scale factors differ by little.
  // If rounds may go on without these angles, they are used only for crowded disks. Returns whether
  // the angles are used.
  bool start_from_hemisphere(Doubled_problem& problem, Flattening& flattening, bool may_go_on)
  {
    if(!is_disk(problem) || !(flattening.has_succeeded() || is_flat(problem)))
      return false;
    const std::optional<Round_disk> disk =
      has_vertices_inside(problem) ? round_hemisphere(problem, sources(), flattening.visitor())
                                   : round_polygon<Double_double>(problem, sources());
    if(!disk)
      return false;
    const bool is_usual = !is_flat(problem) || spread(disk->log_scale) <= usual_spread;
    if((may_go_on && is_usual) || !take_angles(*disk))
      return false;
    std::vector<double> log_scale;
    for(const Decimal_115& u : disk->log_scale)
      log_scale.push_back(static_cast<double>(u));
    problem.straighten_boundaries();
    flattening.start_from(log_scale);
    return true;
  }

  // Moves the angles towards the angles of circles with the lengths of the image, and returns the
  // greatest previous difference of both. If there is no circle, the angles move towards the best
  // ones before.
  double update(const std::vector<double>& length)
  {
    const Vector image = angles([&](Edge_index e) { return length[e.idx()]; });
    if(!are_possible(image)) {
      if(m_acceleration.has_best())
        m_angle = (m_angle + m_acceleration.best()) / 2;
      return std::numeric_limits<double>::infinity();
    }
    const double change = (image - m_angle).lpNorm<Eigen::Infinity>();
    const Vector next = closed(m_acceleration.next(m_angle, image));
    m_angle = are_possible(next) ? next : image;
    return change;
  }

  // Returns whether angles are possible at a boundary.
  static bool are_possible(const Vector& angle)
  {
    return angle.allFinite() && (angle.array() < CGAL_PI).all();
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

  // Scales the angles of each circle so that they sum up to 2 pi, because combinations of many
  // angles lose digits.
  Vector closed(Vector angle) const
  {
    for_each_circle(angle, [](auto own) { own *= 2 * CGAL_PI / own.sum(); });
    return angle;
  }

  // Calls `change(own)` with the angles of each circle.
  template <typename Change>
  void for_each_circle(Vector& angle, const Change& change) const
  {
    Eigen::Index begin = 0;
    for(const Circle& circle : m_circles) {
      change(angle.segment(begin, Eigen::Index(circle.size())));
      begin += Eigen::Index(circle.size());
    }
  }

  Intrinsic_triangulations::Mesh_components m_components;
  std::size_t m_rounds;
  std::vector<Circle> m_circles;
  Vector m_angle;                                            // at the source of each side
  double m_change = std::numeric_limits<double>::infinity(); // of the angles, in the last round
  Fixed_point_acceleration m_acceleration;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCULAR_BOUNDARY_H
