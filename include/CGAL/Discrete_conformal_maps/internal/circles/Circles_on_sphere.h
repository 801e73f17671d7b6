// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/circles/Balanced_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Spherical_circle_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/SparseCholesky>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the hyperideal polyhedron of a decorated sphere as circles on the unit sphere. The
// polyhedron is rigid, and unique up to Moebius transformations (Schlenker 1998). Radii grow from
// zero, for which the ideal polyhedron is known, to their values. Newton's method corrects the
// angle defects on this path. The Moebius transformations form the kernel of the Hessian. They are
// excluded by fixed circles at the corners of a face. Then the Hessian agrees with the Hessian in
// the plane, as seen from a point inside the face.
class Circles_on_sphere
{
  typedef Eigen::VectorXd Vector;

public:
  typedef Balanced_circles::Point Point;

  // `mesh` is T_2 with the lengths of its tangents and the radii. `circles` contains the scale
  // factors and positions of the ideal polyhedron, and the masses of vertices.
  Circles_on_sphere(const Delta_complex& mesh, std::vector<Extended> tangent,
                    std::vector<Extended> radius, Balanced_circles circles)
    : m_mesh(mesh),
      m_tangent(std::move(tangent)),
      m_radius(std::move(radius)),
      m_circles(std::move(circles))
  {}

  // Follows the polyhedra to the final radii with numbers of this type. Returns whether it has
  // reached the radii. The balanced circles have the final digits.
  template <typename FT>
  bool run(Any_visitor& visitor)
  {
    return grow<FT>(visitor) && reach<Extended>(1, visitor);
  }

  // Returns why the radii have not been reached.
  std::string cause() const
  {
    if(m_part > 0)
      return "circles grow only to the part " + std::to_string(m_part) +
             " of the squares of their radii";
    auto ideal = surface_with<Extended>(0);
    const bool has_lengths = ideal.scale(m_circles.log_scale());
    const double error = has_lengths ? ideal.defects().lpNorm<Eigen::Infinity>() : 0;
    return !has_lengths            ? "lengths on the sphere exceed the range of numbers"
           : !std::isfinite(error) ? "a face of the polyhedron without circles contains the center "
                                     "within rounding"
           : error > tolerance::layout_angle
             ? "rounding of lengths exceeds angles of the polyhedron without circles"
             : "circles do not grow";
  }

  const Balanced_circles& circles() const { return m_circles; }
  // Returns the flips from T_2 to T_3.
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  // Returns the greatest angle defect of the last polyhedron.
  double angle_error() const { return m_angle_error; }
  // Returns the number of factorizations.
  std::size_t newton_steps() const { return m_steps; }

private:
  static constexpr double least_step = 1e-5, greatest_change = 2;
  static constexpr std::size_t most_steps = 1000, steps_of_Newton = 25;

  // Grows the radii, starting from the fraction of their squares that has been reached.
  template <typename FT>
  bool grow(Any_visitor& visitor)
  {
    for(double step = 1; m_part < 1 && step > least_step && m_steps < most_steps;) {
      const double next = (std::min)(1., m_part + step);
      const bool is_reached = reach<FT>(next, visitor);
      m_part = is_reached ? next : m_part;
      step *= is_reached ? 2 : 0.25;
    }
    return m_part == 1;
  }

  // Returns the surface whose squared radii are this fraction of the final ones.
  template <typename FT>
  Spherical_circle_surface<FT> surface_with(double part) const
  {
    const Extended factor = sqrt(Extended(part));
    std::vector<FT> radii;
    for(const Extended& r : m_radius)
      radii.push_back(converted<FT>(factor * r));
    const auto tangent = [this, part](Edge_index e) {
      const Extended t = m_tangent[e.idx()], sum = m_radius[m_mesh.vertex(e, 0).idx()] +
                                                   m_radius[m_mesh.vertex(e, 1).idx()];
      return converted<FT>(part == 1 ? t : Extended(sqrt(t * t + (1 - part) * (sum * sum))));
    };
    return {m_mesh, boost::make_function_property_map<Edge_index>(tangent), std::move(radii)};
  }

  // Makes steps of Newton's method for the radii of this fraction. A factorization is used again
  // while its steps reduce the defects.
  template <typename FT>
  bool reach(double part, Any_visitor& visitor)
  {
    auto surface = surface_with<FT>(part);
    std::vector<Extended> u = m_circles.log_scale();
    Fixed_face newton;
    double before = std::numeric_limits<double>::infinity();
    for(std::size_t step = 0; step < steps_of_Newton && surface.scale(u); ++step) {
      const Vector defect = surface.defects();
      const double error = defect.lpNorm<Eigen::Infinity>();
      if(!std::isfinite(error) || (step > 3 && error > before && error > tolerance::curvature))
        return false;
      visitor.after_iteration(m_steps, error, before);
      if(is_enough<FT>(error, before)) {
        keep(surface, u, error);
        return true;
      }
      if(!newton.contracts(error, before)) {
        ++m_steps;
        if(!newton.factorize(surface))
          return false;
      }
      before = error;
      if(!move(u, newton.direction(defect, surface)))
        return false;
    }
    return false;
  }

  // Returns whether defects are small enough, or as small as the numbers permit.
  template <typename FT>
  static bool is_enough(double error, double before)
  {
    constexpr double enough =
      std::is_same_v<FT, double> ? tolerance::gradient : tolerance::extended_gradient;
    return error < enough ||
           (error < tolerance::curvature && error > tolerance::contraction * before);
  }

  // Computes steps of Newton's method with fixed circles at the corners of a face.
  class Fixed_face
  {
  public:
    // Returns whether the last step was good enough to use its factorization again.
    bool contracts(double error, double before)
    {
      return m_corrections++ < tolerance::corrections && error <= tolerance::contraction * before;
    }

    template <typename Surface>
    bool factorize(const Surface& surface)
    {
      m_corrections = 0;
      m_corner = surface.corners_of_greatest_face();
      m_solver.compute(surface.matrix(m_corner));
      return m_solver.info() == Eigen::Success;
    }

    // Returns the changes of scale factors. The variables w satisfy dw = cos R du.
    template <typename Surface>
    Vector direction(Vector defect, const Surface& surface) const
    {
      for(Vertex_index v : m_corner)
        defect[Eigen::Index(v.idx())] = 0;
      Vector result = -m_solver.solve(defect);
      for(Vertex_index v : surface.mesh().vertices())
        result[Eigen::Index(v.idx())] *=
          std::hypot(1, static_cast<double>(surface.scaled_radius(v)));
      return result;
    }

  private:
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
    std::array<Vertex_index, 3> m_corner;
    std::size_t m_corrections = tolerance::corrections;
  };

  static bool move(std::vector<Extended>& u, const Vector& change)
  {
    const double greatest = change.lpNorm<Eigen::Infinity>();
    if(!std::isfinite(greatest))
      return false;
    const double factor = (std::min)(1., greatest_change / greatest);
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += factor * change[Eigen::Index(v)];
    return true;
  }

  template <typename Surface>
  void keep(const Surface& surface, const std::vector<Extended>& u, double error)
  {
    std::vector<Extended> radii;
    for(Vertex_index v : surface.mesh().vertices())
      radii.emplace_back(surface.scaled_radius(v));
    m_circles.assign(u, radii, surface.centers());
    m_circles.balance();
    m_flips = surface.flips();
    m_angle_error = error;
  }

  const Delta_complex& m_mesh;
  std::vector<Extended> m_tangent, m_radius;
  Balanced_circles m_circles;
  std::vector<Halfedge_index> m_flips;
  double m_part = 0; // the fraction of the squared radii
  double m_angle_error = std::numeric_limits<double>::infinity();
  std::size_t m_steps = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
