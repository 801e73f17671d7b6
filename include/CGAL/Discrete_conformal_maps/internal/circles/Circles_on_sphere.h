// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Balanced_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Spherical_circle_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/SparseCholesky>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores a point of the unit sphere and the direction in which an edge leaves it.
struct Spherical_frame
{
  std::array<Extended, 3> position, direction;

  // Returns the frame of the edge behind this corner.
  Spherical_frame turned(const Corner<Extended>& corner) const
  {
    const auto &p = position, &d = direction;
    const std::array<Extended, 3> left{p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2],
                                       p[0] * d[1] - p[1] * d[0]};
    const Extended norm = sqrt(corner.cosine * corner.cosine + corner.sine * corner.sine);
    return {p, sum(corner.cosine / norm, d, corner.sine / norm, left)};
  }

  // Returns the frame of the same edge at its other end, for an edge of length x with sin(x/2) = l.
  Spherical_frame at_end(const Extended& l) const
  {
    const Extended cosine = 1 - 2 * l * l, sine = 2 * l * sqrt(1 - l * l);
    return {sum(cosine, position, sine, direction), sum(sine, position, -cosine, direction)};
  }

private:
  static std::array<Extended, 3> sum(const Extended& x, const std::array<Extended, 3>& a,
                                     const Extended& y, const std::array<Extended, 3>& b)
  {
    return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
  }
};

// Computes the hyperideal polyhedron of a decorated sphere, as circles on the unit sphere. It is
// unique up to Moebius transformations (Schlenker 1998), and rigid. Radii grow from zero, for which
// the ideal polyhedron is known, to their values; Newton's method follows the angle defects. The
// transformations are the kernel of the Hessian. Fixed circles at the corners of a face exclude
// them. Then the Hessian is as in the plane, seen from a point inside the face.
class Circles_on_sphere
{
  typedef Eigen::VectorXd Vector;
  typedef Intrinsic_triangulations::Decorated_length<Extended> Decorated_length;
  typedef Penner_surface<Extended> Surface;

public:
  typedef Balanced_circles::Point Point;

  // `mesh` is T_2 with its lengths of tangents and radii. `circles` has the scale factors and
  // positions of the ideal polyhedron, with the masses of vertices.
  Circles_on_sphere(const Delta_complex& mesh, std::vector<Extended> tangent,
                    std::vector<Extended> radius, Balanced_circles circles)
    : m_mesh(mesh),
      m_tangent(std::move(tangent)),
      m_radius(std::move(radius)),
      m_circles(std::move(circles))
  {}

  // Follows the polyhedra to the radii. Returns whether it has reached them.
  bool run(Any_visitor& visitor)
  {
    double part = 0;
    for(double step = 1; part < 1 && step > least_step && m_steps < most_steps;) {
      const double next = (std::min)(1., part + step);
      const bool is_reached = reach(next, visitor);
      part = is_reached ? next : part;
      step *= is_reached ? 2 : 0.25;
    }
    return part == 1 && measure();
  }

  const Balanced_circles& circles() const { return m_circles; }
  // Returns the flips from T_2 to T_3.
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  // Returns the greatest angle defect of the last polyhedron.
  double angle_error() const { return m_angle_error; }
  std::size_t newton_steps() const { return m_steps; }

private:
  static constexpr double least_step = 1e-5, greatest_change = 2, enough = 1e-24;
  static constexpr std::size_t most_steps = 1000, steps_of_Newton = 25;

  // Returns the surface whose radii have this part of their squares.
  Surface surface_with(double part) const
  {
    const Extended factor = sqrt(Extended(part));
    std::vector<Extended> radii;
    for(const Extended& r : m_radius)
      radii.push_back(factor * r);
    const auto tangent = [this, part](Edge_index e) {
      const Extended t = m_tangent[e.idx()], sum = m_radius[m_mesh.vertex(e, 0).idx()] +
                                                   m_radius[m_mesh.vertex(e, 1).idx()];
      return Extended(sqrt(t * t + (1 - part) * (sum * sum)));
    };
    return {m_mesh, boost::make_function_property_map<Edge_index>(tangent), Flipping::to_Delaunay,
            std::move(radii)};
  }

  static Spherical_circle_triangle<Extended> triangle(const std::array<Halfedge_index, 3>& side,
                                                      const Surface& surface)
  {
    return {surface.scaled_decorated_length(side[0]), surface.scaled_decorated_length(side[1]),
            surface.scaled_decorated_length(side[2])};
  }

  // Newton's method for the radii of this part.
  bool reach(double part, Any_visitor& visitor)
  {
    Surface surface = surface_with(part);
    std::vector<Extended> u = m_circles.log_scale();
    double before = std::numeric_limits<double>::infinity();
    for(std::size_t step = 0; step < steps_of_Newton; ++step) {
      ++m_steps;
      try {
        surface.scale(u);
      } catch(const Intrinsic_triangulations::Numerical_error&) {
        return false;
      }
      Vector defect = Vector::Zero(Eigen::Index(u.size()));
      const Face_index fixed = greatest_face(surface);
      const Eigen::SparseMatrix<double> matrix = differentiate(surface, fixed, defect);
      const double error = defect.lpNorm<Eigen::Infinity>();
      if(!std::isfinite(error) || (step > 3 && error > before && error > tolerance::curvature))
        return false;
      visitor.after_iteration(m_steps, error, before);
      if(error < enough || (error < tolerance::curvature && error > before / 4))
        return keep(surface, u);
      before = error;
      if(!move(u, matrix, defect, fixed, surface))
        return false;
    }
    return false;
  }

  // Adds the angle defects, and returns the derivatives of the sums of angles with the other sign.
  // Corners of the face `fixed` and isolated vertices have the unit matrix.
  Eigen::SparseMatrix<double> differentiate(const Surface& surface, Face_index fixed,
                                            Vector& defect) const
  {
    const Delta_complex& mesh = surface.mesh();
    std::vector<char> is_free(mesh.num_vertices(), 1);
    for(Halfedge_index h : sides(fixed, mesh))
      is_free[mesh.source(h).idx()] = 0;
    std::vector<Angle_difference<Extended>> sums(mesh.num_vertices(),
                                                 Angle_difference<Extended>(0));
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Vertex_index v, Vertex_index w, double x) {
      if(is_free[v.idx()] && is_free[w.idx()])
        entries.emplace_back(int(v.idx()), int(w.idx()), x);
    };
    bool exist = true;
    for(Face_index f : mesh.faces()) {
      const auto side = sides(f, mesh);
      const auto t = triangle(side, surface);
      exist = exist && t.exists();
      for(std::size_t s = 0; s < 3; ++s) {
        const Vertex_index i = mesh.source(side[s]), j = mesh.target(side[s]);
        sums[i.idx()].subtract(t.corner(s), t.corner(s).rounded_angle());
        const double d = static_cast<double>(t.derivative(s)),
                     own = static_cast<double>(t.cosine_of_side(s)) * d;
        add(i, j, -d);
        add(j, i, -d);
        add(i, i, own);
        add(j, j, own);
      }
    }
    for(Vertex_index v : mesh.vertices()) {
      const Eigen::Index i(v.idx());
      if(!mesh.is_isolated(v))
        defect[i] = exist ? sums[v.idx()].value() : std::numeric_limits<double>::quiet_NaN();
      if(mesh.is_isolated(v) || !is_free[v.idx()])
        entries.emplace_back(int(i), int(i), 1);
    }
    Eigen::SparseMatrix<double> result(defect.size(), defect.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // Returns a face whose shortest side is greatest.
  static Face_index greatest_face(const Surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    const auto shortest = [&](Face_index f) {
      const auto t = triangle(sides(f, mesh), surface);
      return (std::min)({t.length(0), t.length(1), t.length(2)});
    };
    Face_index result;
    Extended greatest = 0;
    for(Face_index f : mesh.faces())
      if(const Extended length = shortest(f); !result.is_valid() || length > greatest) {
        result = f;
        greatest = length;
      }
    return result;
  }

  // Makes a step of Newton's method. Its variables are w with dw = cos R du.
  bool move(std::vector<Extended>& u, const Eigen::SparseMatrix<double>& matrix, Vector right,
            Face_index fixed, const Surface& surface) const
  {
    for(Halfedge_index h : sides(fixed, surface.mesh()))
      right[Eigen::Index(surface.mesh().source(h).idx())] = 0;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if(solver.info() != Eigen::Success)
      return false;
    Vector change = -solver.solve(right);
    for(Vertex_index v : surface.mesh().vertices())
      change[Eigen::Index(v.idx())] *= std::hypot(1, surface.scaled_radius(v).high());
    const double greatest = change.lpNorm<Eigen::Infinity>();
    if(!std::isfinite(greatest))
      return false;
    const double factor = (std::min)(1., greatest_change / greatest);
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += factor * change[Eigen::Index(v)];
    return true;
  }

  // Measures the balanced polyhedron.
  bool measure()
  {
    Surface surface = surface_with(1);
    surface.scale(m_circles.log_scale());
    m_flips = surface.flips();
    Vector defect = Vector::Zero(Eigen::Index(m_radius.size()));
    differentiate(surface, greatest_face(surface), defect);
    m_angle_error = defect.lpNorm<Eigen::Infinity>();
    return std::isfinite(m_angle_error);
  }

  bool keep(const Surface& surface, const std::vector<Extended>& u)
  {
    std::vector<Extended> radii;
    for(Vertex_index v : surface.mesh().vertices())
      radii.push_back(surface.scaled_radius(v));
    m_circles.assign(u, radii, lay_out(surface));
    m_circles.balance();
    return true;
  }

  // Returns the centers of the circles, with each face beside the one before. Directions are
  // rotated from face to face. Directions computed from positions would multiply errors.
  static std::vector<Point> lay_out(const Surface& surface)
  {
    const Delta_complex& mesh = surface.mesh();
    std::vector<Point> result(mesh.num_vertices(), Point{0, 0, 1});
    std::vector<char> is_placed(mesh.num_vertices(), 0), is_done(mesh.num_faces(), 0);
    std::queue<std::pair<Halfedge_index, Spherical_frame>> next;
    const auto visit = [&](Halfedge_index h, const Spherical_frame& at_source) {
      if(!std::exchange(is_placed[mesh.source(h).idx()], char(1)))
        result[mesh.source(h).idx()] = at_source.position;
      next.emplace(h, at_source);
    };
    visit(mesh.halfedge(*mesh.faces().begin()), {{0, 0, 1}, {1, 0, 0}});
    for(; !next.empty(); next.pop()) {
      const auto [h, at_source] = next.front();
      if(std::exchange(is_done[mesh.face(h).idx()], char(1)))
        continue;
      const std::array<Halfedge_index, 3> side{h, mesh.next(h), mesh.prev(h)};
      const auto t = triangle(side, surface);
      const Spherical_frame to_third = at_source.turned(t.corner(0));
      visit(mesh.opposite(side[0]), at_source.at_end(t.length(0)));
      visit(mesh.opposite(side[1]), to_third.at_end(t.length(2)).turned(t.corner(2)));
      next.emplace(mesh.opposite(side[2]), to_third);
    }
    return result;
  }

  const Delta_complex& m_mesh;
  std::vector<Extended> m_tangent, m_radius;
  Balanced_circles m_circles;
  std::vector<Halfedge_index> m_flips;
  double m_angle_error = std::numeric_limits<double>::infinity();
  std::size_t m_steps = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLES_ON_SPHERE_H
