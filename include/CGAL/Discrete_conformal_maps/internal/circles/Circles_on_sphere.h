// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/circles/Balanced_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Spherical_circle_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Hessian_solver.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Cholesky.h>

#include <Eigen/Core>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the hyperideal polyhedron of a decorated sphere as circles on the unit sphere. The
// polyhedron is rigid, and unique up to Moebius transformations (Schlenker 1998). Radii grow from
// zero, for which the ideal polyhedron is known, to their values. Newton's method corrects the
// angle defects on this path. The Moebius transformations form the kernel of the Hessian. They are
// excluded by fixed circles at the corners of a face. One eigenvalue of the Hessian is negative, as
// for equal scale factors on a smooth sphere.
class Circles_on_sphere
{
  typedef Eigen::VectorXd Vector;

public:
  // `mesh` is T_2 with the lengths of its tangents and the radii. `circles` contains the scale
  // factors and positions of the ideal polyhedron, and the masses of vertices. `order` is an
  // elimination order of the vertices, if it is known.
  Circles_on_sphere(const Delta_complex& mesh, std::vector<Double_double> tangent,
                    std::vector<Double_double> radius, Balanced_circles<Double_double> circles,
                    std::shared_ptr<Shared_order> order)
    : m_mesh(mesh),
      m_tangent(std::move(tangent)),
      m_radius(std::move(radius)),
      m_circles(std::move(circles)),
      m_newton(std::move(order))
  {}

  // Follows the polyhedra to the final radii with numbers of this type. If they suffice and the
  // layout is good, the last polyhedron has their digits, and otherwise the digits of
  // `Double_double`. If these digits do not distinguish the centers of circles, centers have the
  // digits of `Decimal_1500`. Returns whether the search has reached the radii.
  template <typename FT>
  bool run(bool digits_suffice, Any_visitor& visitor)
  {
    typedef Precise<FT> Number;
    m_invisible_error = digits_suffice ? tolerance::gradient : tolerance::invisible_gradient;
    if(!grow<FT>(visitor) ||
       !((digits_suffice && has_good_layout()) ||
         reach<Number>(1, visitor, m_circles.log_scale(), m_newton.has_factorization())))
      return false;
    if(has_good_layout())
      m_circles.balance();
    else
      separate<Number>();
    return true;
  }

  // Returns whether lengths on the sphere may exceed the range of `double` and of `Double_double`.
  bool is_wide() const
  {
    const std::vector<Double_double>& u = m_circles.log_scale();
    return std::any_of(u.begin(), u.end(), [](const Double_double& x) {
      return !(std::abs(x.high()) <= tolerance::narrow_log_scales);
    });
  }

  // Returns why the radii have not been reached.
  std::string cause() const
  {
    if(m_part > 0)
      return "circles grow only to the part " + std::to_string(m_part) +
             " of the squares of their radii";
    const std::optional<double> error = ideal_error<Wide_number<Double_double>>();
    return !error ? "lengths on the sphere exceed the range of numbers"
           : !std::isfinite(*error)
             ? "a face of the polyhedron without circles contains the center "
               "within rounding"
           : *error > tolerance::layout_angle
             ? "rounding of lengths exceeds angles of the polyhedron without circles"
             : "circles do not grow";
  }

  // Calls `function` with the circles.
  template <typename Function>
  void visit_circles(const Function& function) const
  {
    if(m_separate_circles)
      function(*m_separate_circles);
    else
      function(m_circles);
  }

  // Returns the flips from T_2 to T_3.
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  // Returns the greatest angle defect of the last polyhedron.
  double angle_error() const { return m_angle_error; }
  // Returns the number of factorizations.
  std::size_t newton_steps() const { return m_steps; }

private:
  static constexpr double least_step = 1e-5, least_part = 1e-30, greatest_change = 2,
                          greatest_start_error = 1;
  static constexpr std::size_t steps_of_Newton = 25;
  template <typename FT>
  static constexpr bool has_more_digits = !std::is_same_v<FT, double>;
  template <typename FT>
  static constexpr double enough =
    has_more_digits<FT> ? tolerance::extended_gradient : tolerance::gradient;
  // The number type of the last polyhedron, and of positions on the path to it.
  template <typename FT>
  using Precise = std::conditional_t<std::is_same_v<FT, double>, Double_double, FT>;
  template <typename FT>
  using Position = std::conditional_t<std::is_same_v<FT, double>, double, Double_double>;

  // Grows the radii, starting from the fraction of their squares that has been reached.
  template <typename FT>
  bool grow(Any_visitor& visitor)
  {
    if(m_part == 0 && !is_near_ideal<FT>())
      return false;
    std::vector<Path_point> path{{m_part, m_circles.log_scale()}};
    for(double step = 1; m_part < 1 && step > smallest_step<FT>() && m_steps < most_steps<FT>;) {
      const double next = (std::min)(1., m_part + step);
      const bool is_reached = reach<FT>(next, visitor, predicted(path, next));
      step *= is_reached ? 2 : 0.25;
      if(!is_reached)
        continue;
      m_part = next;
      if(m_part < 1)
        m_circles.balance();
      extend(path);
    }
    return m_part == 1;
  }

  // Stores the balanced scale factors for a fraction of the squared radii.
  struct Path_point
  {
    double part;
    std::vector<Double_double> log_scale;
  };

  // Tiny changes of scale factors can reverse faces in narrow parts of the surface. So searches
  // start at scale factors that are extrapolated from this number of points of the path.
  static constexpr std::size_t path_length = 3;
  // Returns whether lengths may exceed the range of `double`. Then paths are longer.
  template <typename FT>
  static constexpr bool has_wide_range = !std::is_same_v<FT, Position<FT>>;
  template <typename FT>
  static constexpr std::size_t most_steps = has_wide_range<FT> ? 2000 : 1000;

  // Returns the step at which the search ends. If lengths exceed the range of `double`, tiny
  // radii can change scale factors much.
  template <typename FT>
  double smallest_step() const
  {
    return least_step * (has_wide_range<FT> ? (std::max)(m_part, least_part) : 1.);
  }

  // Adds the last polyhedron to the path. Without circles, scale factors are no part of a smooth
  // function of the logarithm of the fraction.
  void extend(std::vector<Path_point>& path) const
  {
    if(path.front().part == 0 || path.size() == path_length)
      path.erase(path.begin());
    path.push_back({m_part, m_circles.log_scale()});
  }

  // Returns the scale factors for `next` on the polynomial through the points of the path.
  static std::vector<Double_double> predicted(const std::vector<Path_point>& path, double next)
  {
    if(path.size() == 1)
      return path.front().log_scale;
    std::vector<Double_double> result(path.front().log_scale.size(), Double_double(0));
    for(const Path_point& p : path) {
      Double_double weight = 1;
      for(const Path_point& q : path)
        if(q.part != p.part)
          weight *= std::log(next / q.part) / std::log(p.part / q.part);
      for(std::size_t v = 0; v < result.size(); ++v)
        result[v] += weight * p.log_scale[v];
    }
    return result;
  }

  // Returns the greatest angle defect without circles, or nothing if lengths exceed their range.
  template <typename FT>
  std::optional<double> ideal_error() const
  {
    auto ideal = surface_with<FT>(0);
    if(!ideal.scale(m_circles.log_scale()))
      return {};
    return ideal.defects().template lpNorm<Eigen::Infinity>();
  }

  // Returns whether circles can start to grow with numbers of this type.
  template <typename FT>
  bool is_near_ideal() const
  {
    if(is_wide() && !has_wide_range<FT>)
      return false;
    const std::optional<double> error = ideal_error<FT>();
    return error && *error < greatest_start_error;
  }

  // Returns whether positions agree with lengths. A length cross ratio has four lengths.
  bool has_good_layout() const { return 4 * m_layout_error < tolerance::good_cross_ratio; }

  // Returns the surface whose squared radii are this fraction of the final ones.
  template <typename FT>
  Spherical_circle_surface<FT> surface_with(double part) const
  {
    const Double_double factor = sqrt(Double_double(part));
    std::vector<FT> radii;
    for(const Double_double& r : m_radius)
      radii.push_back(converted<FT>(factor * r));
    const auto tangent = [this, part](Edge_index e) {
      const Double_double t = m_tangent[e.idx()], sum = m_radius[m_mesh.vertex(e, 0).idx()] +
                                                        m_radius[m_mesh.vertex(e, 1).idx()];
      return converted<FT>(part == 1 ? t : Double_double(sqrt(t * t + (1 - part) * (sum * sum))));
    };
    return {m_mesh, boost::make_function_property_map<Edge_index>(tangent), std::move(radii)};
  }

  // Makes steps of Newton's method for the radii of this fraction. A factorization is used again
  // while its steps reduce the defects. The last search has left one for the first step if
  // `is_factorized` is true.
  template <typename FT>
  bool reach(double part, Any_visitor& visitor, std::vector<Double_double> u,
             bool is_factorized = false)
  {
    auto surface = surface_with<FT>(part);
    double before = std::numeric_limits<double>::infinity();
    for(std::size_t step = 0; step < steps_of_Newton && surface.scale(u); ++step) {
      const Vector defect = surface.defects();
      const double error = defect.lpNorm<Eigen::Infinity>();
      if(!std::isfinite(error) || (step > 3 && error > before && error > tolerance::curvature))
        return false;
      visitor.after_iteration(m_steps, error, before);
      if(ends_with(surface, u, error, before))
        return true;
      if(!(step == 0 && is_factorized) && !Fixed_face::leads_to(enough<FT>, error, before)) {
        ++m_steps;
        if(!m_newton.factorize(surface))
          return false;
      }
      before = error;
      if(!move(u, m_newton.direction(defect, surface)))
        return false;
    }
    return false;
  }

  // Returns whether this polyhedron is the last one of the search, and keeps it then. The layout
  // can end the search before defects are as small as possible. If it is bad in `double`, more
  // digits follow. If it is good in more digits, defects of this size do not change it.
  template <typename FT>
  bool ends_with(const Spherical_circle_surface<FT>& surface, const std::vector<Double_double>& u,
                 double error, double before)
  {
    const bool is_last = is_enough<FT>(error, before);
    if(!is_last && !(error < (has_more_digits<FT> ? m_invisible_error : tolerance::curvature)))
      return false;
    keep(surface, u, error);
    return is_last || has_good_layout() == has_more_digits<FT>;
  }

  // Returns whether defects are small enough, or as small as the numbers permit.
  template <typename FT>
  static bool is_enough(double error, double before)
  {
    return error < enough<FT> ||
           (error < tolerance::curvature && error > tolerance::contraction * before);
  }

  // Computes steps of Newton's method with fixed circles at the corners of a face.
  class Fixed_face
  {
  public:
    explicit Fixed_face(std::shared_ptr<Shared_order> order) : m_order(std::move(order)) {}

    bool has_factorization() const { return m_solver.has_value(); }

    // Returns whether the factorization is used again. A new factorization takes as long as some
    // steps. So the steps that are left must be fewer if they reduce errors like the last one.
    // Before the first step, the error is infinite.
    static bool leads_to(double enough, double error, double before)
    {
      const double contraction = error / before;
      return std::isfinite(before) && contraction <= tolerance::contraction &&
             error * std::pow(contraction, tolerance::corrections) <= enough;
    }

    // Returns false if the matrix is singular.
    template <typename Surface>
    bool factorize(const Surface& surface)
    {
      const auto corner = surface.corners_of_greatest_face();
      if(!m_solver || corner != m_corner)
        m_solver.emplace(rows_without(corner, surface.mesh()), m_order);
      m_corner = corner;
      return m_solver->factorize(surface.matrix(), Vector::Zero(surface.mesh().num_vertices()));
    }

    // Returns the changes of scale factors. The variables w satisfy dw = cos R du.
    template <typename Surface>
    Vector direction(const Vector& defect, const Surface& surface)
    {
      Vector result = -m_solver->solve(defect);
      for(Vertex_index v : surface.mesh().vertices())
        result[Eigen::Index(v.idx())] *=
          std::hypot(1, static_cast<double>(surface.scaled_radius(v)));
      return result;
    }

  private:
    typedef Hessian_solver<Intrinsic_triangulations::internal::Indefinite_Cholesky<double>> Solver;

    static Solver::Order rows_without(const std::array<Vertex_index, 3>& corner,
                                      const Delta_complex& mesh)
    {
      Solver::Order result;
      for(Vertex_index v : mesh.vertices())
        if(!mesh.is_isolated(v) && std::find(corner.begin(), corner.end(), v) == corner.end())
          result.push_back(Eigen::Index(v.idx()));
      return result;
    }

    std::shared_ptr<Shared_order> m_order;
    std::optional<Solver> m_solver;
    std::array<Vertex_index, 3> m_corner;
  };

  static bool move(std::vector<Double_double>& u, const Vector& change)
  {
    const double greatest = change.lpNorm<Eigen::Infinity>();
    if(!std::isfinite(greatest))
      return false;
    const double factor = (std::min)(1., greatest_change / greatest);
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += factor * change[Eigen::Index(v)];
    return true;
  }

  template <typename FT>
  void keep(const Spherical_circle_surface<FT>& surface, const std::vector<Double_double>& u,
            double error)
  {
    const auto centers = surface.template centers<Position<FT>>();
    m_layout_error = surface.layout_error(centers);
    m_circles.assign(u, radii<Double_double>(surface), points(centers));
    m_flips = surface.flips();
    m_angle_error = error;
  }

  // Computes the last polyhedron again, with digits that distinguish the centers of its circles.
  template <typename FT>
  void separate()
  {
    auto surface = surface_with<FT>(1);
    surface.scale(m_circles.log_scale());
    m_separate_circles.emplace(m_circles.mass());
    m_separate_circles->assign(m_circles.log_scale(), radii<Decimal_1500>(surface),
                               surface.template centers<Decimal_1500>());
    m_separate_circles->balance();
  }

  template <typename Number, typename Surface>
  static std::vector<Number> radii(const Surface& surface)
  {
    std::vector<Number> result;
    for(Vertex_index v : surface.mesh().vertices())
      result.push_back(converted<Number>(surface.scaled_radius(v)));
    return result;
  }

  // Returns the points with the digits of `Double_double`.
  template <typename Point>
  static std::vector<std::array<Double_double, 3>> points(const std::vector<Point>& points)
  {
    std::vector<std::array<Double_double, 3>> result;
    for(const auto& [x, y, z] : points)
      result.push_back({Double_double(x), Double_double(y), Double_double(z)});
    return result;
  }

  const Delta_complex& m_mesh;
  std::vector<Double_double> m_tangent, m_radius;
  Balanced_circles<Double_double> m_circles;
  std::optional<Balanced_circles<Decimal_1500>> m_separate_circles;
  std::vector<Halfedge_index> m_flips;
  Fixed_face m_newton;
  double m_part = 0;                                        // the fraction of the squared radii
  double m_invisible_error = tolerance::invisible_gradient; // changes no position in `double`
  // These are errors of the last polyhedron.
  double m_angle_error = std::numeric_limits<double>::infinity(), m_layout_error = m_angle_error;
  std::size_t m_steps = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
