// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_CIRCLE_SPHERE_MAPPING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_CIRCLE_SPHERE_MAPPING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Circles_on_sphere.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/best_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/vertex_masses.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_builder.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/spherical_gram_error.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Executes the steps from a closed or doubled surface with circles at its vertices to its map.
class Circle_sphere_mapping
{
public:
  // `problem` is the whole surface with its circles, or its whole double.
  Circle_sphere_mapping(Doubled_problem& problem, Any_visitor& visitor)
    : m_problem(problem),
      m_without_circles(problem.without_circles()),
      m_visitor(visitor),
      m_mass(vertex_masses(problem)),
      m_builder(problem)
  {
    m_builder.set_geometry(Image_geometry::spherical);
    m_layout.is_disk = !problem.has_no_copies();
  }

  Spherical_conformal_map run()
  {
    start_from(rough_unfolding());
    m_layout.exists = grow<double>();
    if(!m_layout.exists) {
      start_from(unfolding(Unfolding_use::map));
      m_layout.exists = grow<double>() || grow_beyond_range();
    }
    if(!m_layout.exists && !m_search->is_wide()) {
      start_from(unfolding(Unfolding_use::precise_start));
      m_layout.exists = grow<double>() || grow<Double_double>() || grow_beyond_range();
    }
    m_layout.at_infinity = m_ideal.layout.at_infinity;
    if(!m_layout.exists)
      m_builder.set_cause(m_ideal.layout.exists ? m_search->cause() : m_ideal.cause);
    if(m_layout.exists)
      m_search->visit_circles([this](const auto& circles) { store_circles(circles); });
    else
      store(m_ideal.log_scale);
    m_problem.drop_surface();
    m_builder.subdivide(m_visitor);
    if(m_layout.exists)
      m_builder.find_crowded([this](Halfedge_index h) { return m_builder.scaled_length(h); });
    const bool exists = m_layout.exists;
    auto map = m_builder.template map<Spherical_conformal_map>(std::move(m_layout));
    if(exists)
      m_promises.push_back({"cross_ratio", greater_error(m_gram_error, max_cross_ratio_error(map)),
                            tolerance::cross_ratio, Map_status::not_conformal});
    m_builder.judge(map, std::move(m_promises));
    return map;
  }

private:
  Unfolded_sphere rough_unfolding()
  {
    const Vertex_index at_infinity = vertices_at_infinity(m_without_circles, m_mass).front();
    return Sphere_unfolding(m_without_circles, m_mass, at_infinity, Unfolding_use::rough_start)
      .run(m_visitor);
  }

  Unfolded_sphere unfolding(Unfolding_use use)
  {
    return best_unfolding(m_without_circles, m_mass, m_visitor, use);
  }

  void start_from(Unfolded_sphere ideal)
  {
    m_ideal = std::move(ideal);
    m_steps += m_ideal.minimization.iterations;
    m_search.emplace(m_problem.triangulation().mesh(), tangents(), m_problem.radii<Double_double>(),
                     ideal_circles(), m_without_circles.expanded_order());
    m_visitor.start(Flattening_stage::optimize);
  }

  // Lets the circles grow, and returns whether they reach their radii.
  template <typename FT>
  bool grow()
  {
    const std::size_t before = m_search->newton_steps();
    const bool is_reached =
      m_ideal.layout.exists && m_search->run<FT>(double_suffices(), m_visitor);
    m_steps += m_search->newton_steps() - before;
    return is_reached;
  }

  // Lets the circles grow if lengths on the sphere may exceed the range of `double`.
  bool grow_beyond_range() { return m_search->is_wide() && grow<Wide_number<Double_double>>(); }

  // Returns whether the digits of `double` can suffice. Two mirror images need the digits of
  // `Double_double`, because their boundary lies on a great circle up to rounding.
  bool double_suffices() const { return m_problem.has_no_copies() && !m_problem.is_measured(); }

  std::vector<Double_double> tangents() const
  {
    const auto length = m_problem.lengths<Double_double>(m_problem.triangulation());
    std::vector<Double_double> result;
    for(Edge_index e : m_problem.triangulation().mesh().edges())
      result.push_back(get(length, e));
    return result;
  }

  // Returns the ideal polyhedron. Copies of vertices are mirror images.
  Balanced_circles<Double_double> ideal_circles() const
  {
    std::vector<std::array<Double_double, 3>> position;
    std::vector<Double_double> log_scale;
    for(std::size_t v = 0; v < m_problem.originals().size(); ++v) {
      const Vertex_index w = m_problem.originals()[v];
      log_scale.push_back(m_ideal.layout.exists ? m_ideal.precise_log_scale(w) : Double_double(0));
      position.push_back(m_ideal.layout.exists ? m_ideal.layout.position_in<Double_double>(w)
                                               : std::array<Double_double, 3>{0, 0, 1});
      if(v >= m_problem.size())
        position.back()[1] = -position.back()[1];
    }
    return Balanced_circles<Double_double>(m_problem.expanded(m_mass), std::move(log_scale),
                                           std::move(position));
  }

  // Stores the scale factors and the triangulation, and how they were found.
  void store(const std::vector<double>& log_scale)
  {
    m_builder.flip(m_layout.exists ? m_search->flips() : std::vector<Halfedge_index>());
    Minimization_result minimization = m_ideal.minimization;
    minimization.iterations = m_steps;
    m_builder.set_scale_factors(log_scale,
                                m_layout.exists ? Map_status::success : Map_status::not_converged,
                                minimization, m_search->angle_error());
    m_promises = Defect_errors{m_search->angle_error(), 0}.promises(m_layout.exists);
  }

  template <typename FT>
  void store_circles(Balanced_circles<FT> circles)
  {
    if(m_layout.is_disk)
      move_mirror_to_center(circles);
    std::vector<double> log_scale;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      log_scale.push_back(circles.log_scale()[v].high());
    store(log_scale);
    circles.rotate(frame(circles));
    store_positions(circles);
    m_gram_error = gram_error(circles);
    add_promises(circles);
  }

  // Moves the mirror plane of a disk to the center, because rounding of the center of mass and its
  // limits leave it beside the center. The second move corrects rounding of the first one.
  template <typename FT>
  void move_mirror_to_center(Balanced_circles<FT>& circles) const
  {
    for(int i = 0; i < 2; ++i) {
      const auto [normal, time] = mirror_plane(circles);
      const double norm = normal.norm();
      if(std::abs(time) < norm)
        circles.move_plane_to_center(normal / norm, std::atanh(time / norm));
    }
  }

  // Returns a vector of Minkowski space that is orthogonal to the mirror plane. Such vectors are
  // the differences of the vectors (pole, 1) / e^u of mirror images.
  template <typename FT>
  std::pair<Eigen::Vector3d, double> mirror_plane(const Balanced_circles<FT>& circles) const
  {
    const std::vector<Double_double>& u = circles.log_scale();
    std::pair<Eigen::Vector3d, double> result(Eigen::Vector3d::Zero(), 0);
    for(std::size_t v = m_problem.size(); v < m_problem.originals().size(); ++v) {
      const Vertex_index w = m_problem.originals()[v];
      const Double_double factor = exp(u[w.idx()] - u[v]);
      const auto &p = circles.pole(w),
                 &copy = circles.pole(Vertex_index(static_cast<Delta_complex::size_type>(v)));
      for(std::size_t c = 0; c < 3; ++c)
        result.first[Eigen::Index(c)] +=
          static_cast<double>(FT(p[c] - converted<FT>(factor) * copy[c]));
      result.second += static_cast<double>(1 - factor);
    }
    return result;
  }

  // Returns the rows of a rotation. It moves the vertex at infinity to (0, 0, -1), and the mirror
  // plane of a disk to y = 0.
  template <typename FT>
  std::array<std::array<FT, 3>, 3> frame(const Balanced_circles<FT>& circles) const
  {
    typedef std::array<FT, 3> Point;
    const auto unit = [](const Point& a) {
      return Balanced_circles<FT>::times(a, 1 / Balanced_circles<FT>::norm(a));
    };
    const Point down = circles.position(m_layout.at_infinity), z{-down[0], -down[1], -down[2]};
    Point y = m_layout.is_disk ? mirror_normal(circles) : farthest_axis(z);
    const FT along = Balanced_circles<FT>::dot(y, z);
    y = unit({y[0] - along * z[0], y[1] - along * z[1], y[2] - along * z[2]});
    return {Point{y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]},
            y, z};
  }

  template <typename FT>
  static std::array<FT, 3> farthest_axis(const std::array<FT, 3>& z)
  {
    const auto size = [](const FT& x) { return std::abs(static_cast<double>(x)); };
    const auto least = std::min_element(
      z.begin(), z.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
    std::array<FT, 3> result{0, 0, 0};
    result[std::size_t(least - z.begin())] = 1;
    return result;
  }

  // Returns the sum of the differences between vertices inside and their copies.
  template <typename FT>
  std::array<FT, 3> mirror_normal(const Balanced_circles<FT>& circles) const
  {
    std::array<FT, 3> result{0, 0, 0};
    for(std::size_t v = m_problem.size(); v < m_problem.originals().size(); ++v) {
      const auto copy = circles.position(Vertex_index(Delta_complex::size_type(v))),
                 p = circles.position(m_problem.originals()[v]);
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += p[c] - copy[c];
    }
    return result;
  }

  template <typename FT>
  void store_positions(const Balanced_circles<FT>& circles)
  {
    std::vector<std::array<FT, 2>> in_plane;
    for(std::size_t v = 0; v < m_problem.originals().size(); ++v) {
      const Vertex_index w{Delta_complex::size_type(v)};
      const bool is_isolated = m_builder.mesh().is_isolated(w);
      const auto p = is_isolated ? std::array<FT, 3>{0, 0, 1} : circles.position(w);
      in_plane.push_back(w == m_layout.at_infinity ? std::array<FT, 2>{0, 0} : projected(p));
    }
    m_layout.in_plane = in_range_of_squares(in_plane);
    m_layout.round_positions(m_builder.mesh());
  }

  // Returns the stereographic projection of a point of the unit sphere. Its distance from (0, 0, 1)
  // determines few digits of its distance from (0, 0, -1) if this distance is small.
  template <typename FT>
  static std::array<FT, 2> projected(const std::array<FT, 3>& p)
  {
    const FT square = p[0] * p[0] + p[1] * p[1],
             height = p[2] < 0 && square < tolerance::near_infinity ? FT(square / (1 - p[2]))
                                                                    : FT(1 + p[2]);
    return {p[0] / height, p[1] / height};
  }

  template <typename FT>
  void add_promises(const Balanced_circles<FT>& circles)
  {
    const auto add = [&](const char* name, double error, double bound, Map_status status) {
      m_promises.push_back({name, error, bound, status});
    };
    add("convexity", measured_concavity(circles), tolerance::promised_angle,
        Map_status::not_convex);
    add("sphere", m_layout.max_inscribed_error(), tolerance::inscribed, Map_status::not_inscribed);
    if(m_layout.is_disk)
      add("hemisphere", hemisphere_error(m_layout, m_problem), tolerance::inscribed,
          Map_status::not_inscribed);
  }

  // Returns the greatest relative error of a Gram coordinate of T_3, with all digits of positions.
  template <typename FT>
  double gram_error(const Balanced_circles<FT>& circles) const
  {
    typedef Distance_of<FT> Distance;
    const Delta_complex& mesh = m_builder.mesh();
    double result = 0;
    for(Edge_index e : mesh.edges()) {
      const Halfedge_index h = mesh.halfedge(e);
      const auto p = circles.position(mesh.source(h)), q = circles.position(mesh.target(h));
      result = greater_error(
        result, spherical_gram_error(m_builder.data().template scaled_decorated_length<Distance>(h),
                                     squared_chord<Distance>(p, q)));
    }
    return result;
  }

  // Returns the greatest sine by which an edge of T_3 is concave, or one if a face is reversed as
  // seen from the center. Counts them in the certificate.
  template <typename FT>
  double measured_concavity(const Balanced_circles<FT>& circles)
  {
    using Intrinsic_triangulations::internal::orientation;
    const Delta_complex& mesh = m_builder.mesh();
    Convexity_certificate& certificate = m_layout.certificate;
    double result = 0;
    for(Edge_index e : mesh.edges()) {
      const Halfedge_index h = mesh.halfedge(e);
      const double sine =
        greater_error(concavity(h, circles), concavity(mesh.opposite(h), circles));
      certificate.concave_edges += sine > tolerance::promised_angle;
      result = greater_error(result, sine);
    }
    for(Face_index f : mesh.faces()) {
      const auto side = sides(f, mesh);
      const auto pole = [&](std::size_t s) { return circles.pole(mesh.source(side[s])); };
      certificate.flipped_triangles += !(orientation(pole(0), pole(1), pole(2)) > 0);
    }
    m_layout.lost_in_output = lost_faces();
    return certificate.flipped_triangles > 0 ? 1 : result;
  }

  // Returns the number of faces of T_3 that are reversed as seen from the center if positions have
  // the digits of `double`. Faces of a disk count if they have an inner vertex.
  std::size_t lost_faces() const
  {
    const Delta_complex& mesh = m_builder.mesh();
    const auto faces = mesh.faces();
    const auto is_inside = [&](Halfedge_index h) { return m_problem.is_inside(mesh.source(h)); };
    return std::size_t(std::count_if(faces.begin(), faces.end(), [&](Face_index f) {
      const auto side = sides(f, mesh);
      const auto at = [&](std::size_t s) { return m_layout.position[mesh.source(side[s]).idx()]; };
      return std::any_of(side.begin(), side.end(), is_inside) &&
             Plane_predicates<double>().orientation(at(0), at(1), at(2), {0, 0, 0}) <= 0;
    }));
  }

  // Returns the sine by which the edge of `h` is concave, seen from its source.
  template <typename FT>
  double concavity(Halfedge_index h, const Balanced_circles<FT>& circles) const
  {
    using Intrinsic_triangulations::internal::orientation;
    typedef Distance_of<FT> Number;
    const Delta_complex& mesh = m_builder.mesh();
    const auto& a = circles.pole(mesh.source(h));
    const auto from_a = [&](Vertex_index v) {
      const auto& p = circles.pole(v);
      const auto difference = [&](std::size_t c) { return converted<Number>(FT(p[c] - a[c])); };
      const std::array<Number, 3> d{difference(0), difference(1), difference(2)};
      return Balanced_circles<Number>::times(d, 1 / Balanced_circles<Number>::norm(d));
    };
    return static_cast<double>(orientation(from_a(mesh.target(h)),
                                           from_a(mesh.source(mesh.prev(h))),
                                           from_a(mesh.source(mesh.prev(mesh.opposite(h))))));
  }

  Doubled_problem& m_problem;
  Doubled_problem m_without_circles;
  Any_visitor& m_visitor;
  std::vector<double> m_mass;
  Unfolded_sphere m_ideal;
  std::optional<Circles_on_sphere> m_search;
  std::size_t m_steps = 0;
  double m_gram_error = 0; // with all digits of positions
  Map_builder m_builder;
  Spherical_layout m_layout;
  std::vector<Map_promise> m_promises;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_CIRCLE_SPHERE_MAPPING_H
