// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Inscribed_polygon.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/best_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/vertex_masses.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Circle_sphere_mapping.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_builder.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/with_digits_as_needed.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Vertex_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/exact_promises.h>
#include <CGAL/Discrete_conformal_maps/surface_type.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Checks the surface.
// \throws Invalid_input if the surface is neither a sphere nor a disk
inline void check_sphere(const Doubled_problem& problem)
{
  const auto& types = problem.topology();
  const auto has_faces = [](const auto& type) { return type.components > 0; };
  check_connected(std::size_t(std::count_if(types.begin(), types.end(), has_faces)));
  const auto type = std::find_if(types.begin(), types.end(), has_faces);
  if(type->genus > 0 || type->boundary_loops > 1)
    throw Intrinsic_triangulations::Invalid_input("the surface is " + description(*type) +
                                                  ", neither a sphere nor a disk: use uniformize");
}

// Executes the steps from a closed or doubled surface to its map.
class Sphere_mapping
{
public:
  Sphere_mapping(Doubled_problem& problem, Any_visitor& visitor)
    : m_problem(problem), m_visitor(visitor), m_mass(vertex_masses(problem)), m_builder(problem)
  {
    check_sphere(problem);
  }

  Spherical_conformal_map run()
  {
    if(has_vertices_inside(m_problem)) {
      store(best_unfolding(m_problem, m_mass, m_visitor));
      if(m_layout.exists)
        find_lost_faces();
    } else if(!store_polygon<Double_double>())
      store_polygon<Decimal_1500>();
    m_problem.drop_surface();
    m_builder.subdivide(m_visitor);
    if(m_layout.exists)
      m_builder.find_crowded([this](Halfedge_index h) { return m_builder.scaled_length(h); });
    auto map = m_builder.template map<Spherical_conformal_map>(std::move(m_layout));
    m_builder.judge(map, std::move(m_promises));
    return map;
  }

private:
  typedef Spherical_conformal_map::Point Point;

  // Stores a polygon with numbers of this type, and returns whether it is good.
  template <typename FT>
  bool store_polygon()
  {
    const Inscribed_polygon<FT> polygon(m_problem, m_mass,
                                        vertices_at_infinity(m_problem, m_mass).front(), m_visitor);
    if(std::is_same<FT, Double_double>::value && !polygon.result().is_good(tolerance::cross_ratio))
      return false;
    store(polygon.result());
    m_layout.lost_in_output = number_of_faces(
      [&](Face_index f) { return polygon.is_original(f) && orientation(f, 0, 1) <= 0; });
    return true;
  }

  // Stores the result of the unfolding, and its promises.
  void store(Unfolded_sphere sphere)
  {
    const std::vector<Map_promise> exact = promises_on_exact_surface(sphere);
    if(!sphere.is_good(tolerance::good_cross_ratio))
      m_builder.set_cause(sphere.cause);
    m_layout = std::move(sphere.layout);
    m_layout.is_disk = !m_problem.has_no_copies();
    m_errors = {sphere.angle_error, 0};
    m_promises = m_errors.promises(m_layout.exists, tolerance::layout_angle);
    m_builder.flip(m_layout.exists ? std::move(sphere.flips) : std::vector<Halfedge_index>());
    m_builder.set_scale_factors(sphere.log_scale,
                                m_layout.exists ? Map_status::success : Map_status::not_converged,
                                sphere.minimization, sphere.angle_error);
    if(!m_layout.exists)
      return;
    m_layout.round_positions(m_builder.mesh());
    add_promises(sphere.cross_ratio_error);
    m_promises.insert(m_promises.end(), exact.begin(), exact.end());
  }

  void add_promises(double cross_ratio_error)
  {
    const Convexity_certificate& c = m_layout.certificate;
    const auto add = [&](const char* name, double error, double bound, Map_status status) {
      m_promises.push_back({name, error, bound, status});
    };
    add("convexity", double(c.concave_edges + c.flipped_triangles + (c.is_simple ? 0u : 1u)), 0,
        m_layout.is_flat ? Map_status::layout_collapsed : Map_status::not_convex);
    add("bounds", double(m_layout.bound_violations), 0, Map_status::not_convex);
    add("sphere", m_layout.max_inscribed_error(), tolerance::inscribed, Map_status::not_inscribed);
    if(m_layout.is_disk)
      add("hemisphere", hemisphere_error(m_layout, m_problem), tolerance::inscribed,
          Map_status::not_inscribed);
    add("cross_ratio", cross_ratio_error, tolerance::cross_ratio, Map_status::not_conformal);
  }

  // Returns the errors on the exact surface, whose lengths the problem has. They are errors of the
  // scale factors of the plane at vertices that are not at their bounds. A polygon has no such
  // errors.
  Scale_errors errors(const Unfolded_sphere& sphere)
  {
    if(sphere.in_plane.empty())
      return {};
    auto energy = spherical_energy<Double_double>(m_problem, sphere.layout.at_infinity);
    std::vector<Double_double> u;
    Minimization_domain domain;
    for(Vertex_index v : m_problem.surface().vertices()) {
      const Scale_in_plane& scale = sphere.in_plane[v.idx()];
      u.push_back(scale.value);
      domain.is_fixed.push_back(scale.is_at_bound || v == sphere.layout.at_infinity ||
                                m_problem.surface().is_isolated(v));
    }
    energy.set_origin(u);
    energy.evaluate(Eigen::VectorXd::Zero(Eigen::Index(u.size())));
    return scale_errors<true>(energy, domain);
  }

  std::vector<Map_promise> promises_on_exact_surface(const Unfolded_sphere& sphere)
  {
    if(!sphere.layout.exists)
      return {};
    return exact_promises(m_problem, [&] { return errors(sphere); });
  }

  // ---- What rounding to `double` loses ----

  // Finds lost faces. Without a face in the plane, a sphere is a flat polygon in the plane y = 0,
  // seen from both sides.
  void find_lost_faces()
  {
    m_layout.is_flat =
      !m_layout.is_disk && number_of_faces([this](Face_index f) { return is_finite(f); }) == 0;
    m_layout.lost_in_output = number_of_faces([this](Face_index f) {
      return m_layout.is_flat ? orientation(f, 0, 2) == 0 : is_inside(f) && !is_convex(f);
    });
  }

  // Returns the number of faces of T_3 that satisfy a predicate.
  template <typename Predicate>
  std::size_t number_of_faces(const Predicate& predicate) const
  {
    const auto faces = m_builder.mesh().faces();
    return std::size_t(std::count_if(faces.begin(), faces.end(), predicate));
  }

  // Returns whether the predicate is true for a corner of a face.
  template <typename Predicate>
  bool has_corner(Face_index f, const Predicate& predicate) const
  {
    const auto side = sides(f, m_builder.mesh());
    return std::any_of(side.begin(), side.end(),
                       [&](Halfedge_index h) { return predicate(m_builder.mesh().source(h)); });
  }

  bool is_finite(Face_index f) const
  {
    return !has_corner(f, [this](Vertex_index v) { return v == m_layout.at_infinity; });
  }

  // Returns whether a face is inside. A face of a disk is inside it if it has an interior vertex.
  // All other faces are on the back of the disk.
  bool is_inside(Face_index f) const
  {
    return has_corner(f, [this](Vertex_index v) { return m_problem.is_inside(v); });
  }

  // Returns whether a face is not flipped as seen from the center, and no face beside it is above
  // it.
  bool is_convex(Face_index f) const
  {
    const Delta_complex& mesh = m_builder.mesh();
    const auto side = sides(f, mesh);
    const auto orientation_from = [&](const Point& p) {
      return Plane_predicates<double>().orientation(
        at(mesh.source(side[0])), at(mesh.source(side[1])), at(mesh.source(side[2])), p);
    };
    const auto is_under_neighbor = [&](Halfedge_index h) {
      return !mesh.is_border(Edge_index(h)) &&
             orientation_from(at(mesh.target(mesh.next(mesh.opposite(h))))) < 0;
    };
    return orientation_from({0, 0, 0}) > 0 &&
           std::none_of(side.begin(), side.end(), is_under_neighbor);
  }

  // Returns the orientation in the plane of two coordinates.
  int orientation(Face_index f, std::size_t x, std::size_t y) const
  {
    const auto side = sides(f, m_builder.mesh());
    const auto point = [&](std::size_t s) {
      const Point& p = at(m_builder.mesh().source(side[s]));
      return Plane_predicates<double>::Point{p[x], p[y]};
    };
    return Plane_predicates<double>().orientation(point(0), point(1), point(2));
  }

  const Point& at(Vertex_index v) const { return m_layout.position[v.idx()]; }

  Doubled_problem& m_problem;
  Any_visitor& m_visitor;
  std::vector<double> m_mass;
  Map_builder m_builder;
  Spherical_layout m_layout;
  Defect_errors m_errors;
  std::vector<Map_promise> m_promises;
};

// Maps a surface with circles at its vertices.
// \throws Invalid_input if the surface is neither a sphere nor a disk with a vertex inside
inline Spherical_conformal_map mapped_with_circles(Doubled_problem& problem, Any_visitor& visitor)
{
  check_sphere(problem);
  if(!has_vertices_inside(problem))
    throw Intrinsic_triangulations::Invalid_input(
      "a disk without inner vertices has no hemisphere with circles: leave out the radii");
  problem.complete();
  return Circle_sphere_mapping(problem, visitor).run();
}

template <typename Visitor>
Spherical_conformal_map mapped_to_sphere(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                                         const Map_parameters& parameters, Visitor visitor)
{
  const Vertex_circles circles(parameters.radii);
  const std::vector<Vertex_condition> none(input.mesh().num_vertices());
  const auto work = std::make_shared<Search_work>();
  const auto find = [&](Intrinsic_triangulations::Intrinsic_triangulation<> surface,
                        Exactness exactness) {
    Doubled_problem problem(std::move(surface), none, Flipping::to_Delaunay, exactness, circles);
    problem.set_concurrency(parameters.concurrency);
    if(circles.exist())
      return mapped_with_circles(problem, visitor);
    problem.share_work(work);
    return Sphere_mapping(problem, visitor).run();
  };
  // No caller has chosen a number of steps, so more digits may prevent each failure. Searches with
  // circles take as long again.
  const auto needs_digits = [&](const Discrete_conformal_map& map) {
    return circles.exist() ? may_need_digits(map) : map.status() != Map_status::success;
  };
  return with_digits_as_needed(std::move(input), find, !circles.exist(), needs_digits);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H
