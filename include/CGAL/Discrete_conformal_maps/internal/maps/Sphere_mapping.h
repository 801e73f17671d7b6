// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Inscribed_polygon.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Unfolded_sphere.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Map_builder.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The steps from a closed or doubled surface to its map.
template <typename Visitor>
class Sphere_mapping
{
public:
  Sphere_mapping(Doubled_problem& problem, std::size_t number_of_original_faces, Visitor& visitor)
    : m_problem(problem),
      m_visitor(visitor),
      m_mass(vertex_areas()),
      m_builder(problem, number_of_original_faces, m_map)
  {
    check();
  }

  Spherical_conformal_map run()
  {
    if(has_vertices_inside()) {
      const Unfolded_sphere sphere = unfold();
      store_layout(sphere);
      m_map.m_is_flat = sphere.is_laid_out() && m_problem.has_no_copies() && has_no_face_in_plane();
      if(sphere.is_laid_out())
        m_map.m_lost_in_output = m_map.is_flat() ? lost_in_flat_output() : lost_in_output();
    } else {
      const Inscribed_polygon polygon(m_problem, m_mass, candidates().front(), m_visitor);
      m_map.m_is_flat = true;
      store_layout(polygon);
      m_map.m_lost_in_output = lost_in_output(polygon);
    }
    m_problem.drop_surface();
    m_builder.subdivide(m_visitor);
    return std::move(m_map);
  }

private:
  static constexpr std::size_t maximum_number_of_trials = 4;

  // \throws Invalid_input if the surface is not a sphere
  void check() const
  {
    const auto& types = m_problem.topology();
    const auto has_faces = [](const auto& type) { return type.components > 0; };
    if(std::count_if(types.begin(), types.end(), has_faces) != 1)
      throw Intrinsic_triangulations::Invalid_input("the surface is not connected");
    const auto type = std::find_if(types.begin(), types.end(), has_faces);
    if(type->genus > 0 || type->boundary_loops > 1)
      throw Intrinsic_triangulations::Invalid_input(
        "the surface is " + description(*type) + ", neither a sphere nor a disk: use uniformize");
  }

  // A third of the area of each face of the double belongs to each of its corners.
  std::vector<double> vertex_areas() const
  {
    const auto& triangulation = m_problem.triangulation();
    const Delta_complex& mesh = m_problem.surface();
    std::vector<double> result(mesh.num_vertices(), 0);
    for(Face_index f : mesh.faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh);
      const auto length = [&](std::size_t s) {
        return triangulation.input_length(mesh.edge(side[s]));
      };
      const double area = std::sqrt(Intrinsic_triangulations::squared_quadrupled_area(
                            length(0), length(1), length(2))) /
                          4;
      for(Halfedge_index h : side)
        result[mesh.target(h).idx()] += area / (3 * m_problem.part(mesh.target(h).idx()));
    }
    return result;
  }

  // Vertices with much area are best at infinity: all others can be seen from there. Of a disk,
  // they are on the boundary.
  std::vector<Vertex_index> candidates() const
  {
    std::vector<Vertex_index> all, on_boundary;
    for(Vertex_index v : m_problem.surface().vertices()) {
      if(!m_problem.surface().is_isolated(v))
        all.push_back(v);
      if(m_problem.is_on_boundary(v))
        on_boundary.push_back(v);
    }
    std::vector<Vertex_index>& result = on_boundary.empty() ? all : on_boundary;
    std::stable_sort(result.begin(), result.end(), [this](Vertex_index v, Vertex_index w) {
      return m_mass[v.idx()] > m_mass[w.idx()];
    });
    return result;
  }

  bool has_vertices_inside() const
  {
    const auto vertices = m_problem.surface().vertices();
    return std::any_of(vertices.begin(), vertices.end(), [this](Vertex_index v) {
      return !m_problem.surface().is_isolated(v) && !m_problem.is_on_boundary(v);
    });
  }

  // The first good result, or else the best. Results with different copies of a disk cannot be
  // compared: unless the first is good, they have all of it.
  Unfolded_sphere unfold()
  {
    const std::vector<Vertex_index> vertices = candidates();
    // vertices far apart in the order of areas are most likely far apart on the surface
    const std::size_t stride = 1 + vertices.size() / (4 * maximum_number_of_trials);
    std::optional<Unfolded_sphere> best;
    best.emplace(m_problem, m_mass, vertices.front(), m_visitor);
    if(!best->is_good() && m_problem.complete())
      best.emplace(m_problem, m_mass, vertices.front(), m_visitor);
    for(std::size_t i = stride;
        !best->is_good() && i < vertices.size() && i < maximum_number_of_trials * stride;
        i += stride)
      if(Unfolded_sphere next(m_problem, m_mass, vertices[i], m_visitor); next < *best)
        best.emplace(std::move(next));
    return std::move(*best);
  }

  template <typename Sphere>
  void store_layout(const Sphere& sphere)
  {
    m_map.m_is_laid_out = sphere.is_laid_out();
    m_builder.flip(sphere.is_laid_out() ? sphere.flips() : std::vector<Halfedge_index>());
    m_builder.set_scale_factors(sphere);
    if(!sphere.cause().empty() && !sphere.is_good())
      m_builder.set_cause(sphere.cause());
    m_map.m_at_infinity = sphere.vertex_at_infinity();
    m_map.m_is_extended = sphere.is_extended();
    const Defect_errors errors{sphere.max_curvature_error(), 0};
    std::vector<Map_promise> promises =
      errors.promises(sphere.is_laid_out(), tolerance::layout_angle);
    if(sphere.is_laid_out())
      take_positions(sphere, promises);
    m_builder.judge(errors.greatest(), std::move(promises));
  }

  // Adds what is promised about them.
  template <typename Sphere>
  void take_positions(const Sphere& sphere, std::vector<Map_promise>& promises)
  {
    m_map.m_in_plane = sphere.positions();
    m_map.m_certificate = sphere.certificate();
    m_map.m_bound_violations = sphere.bound_violations();
    for(Vertex_index v : m_map.ideal().mesh().vertices()) {
      const auto p = m_map.precise_position(v);
      m_map.m_position.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    const Convexity_certificate& c = m_map.certificate();
    const auto add = [&](const char* name, double error, double bound, Map_status status) {
      promises.push_back({name, error, bound, status});
    };
    add("convexity", double(c.concave_edges + c.flipped_triangles + (c.is_simple ? 0u : 1u)), 0,
        m_map.is_flat() ? Map_status::layout_collapsed : Map_status::not_convex);
    add("bounds", double(m_map.bound_violations()), 0, Map_status::not_convex);
    add("sphere", m_map.max_inscribed_error(), tolerance::inscribed, Map_status::not_inscribed);
    if(!m_problem.has_no_copies())
      add("hemisphere", hemisphere_error(), tolerance::inscribed, Map_status::not_inscribed);
    add("cross_ratio", sphere.cross_ratio_error(), tolerance::cross_ratio,
        Map_status::not_conformal);
  }

  // the greatest distance from the equator of a vertex on the boundary, and of others below it
  double hemisphere_error() const
  {
    double result = 0;
    for(Vertex_index v : m_problem.surface().vertices()) {
      const double z = m_map.position(v)[2];
      result = greater_error(result, m_problem.is_on_boundary(v) ? std::abs(z) : -z);
    }
    return result;
  }

  // Then the polyhedron is a flat polygon, seen from both sides.
  bool has_no_face_in_plane() const
  {
    const Delta_complex& mesh = m_map.ideal().mesh();
    const auto is_at_infinity = [&](Face_index f) {
      const auto side = Intrinsic_triangulations::sides(f, mesh);
      return std::any_of(side.begin(), side.end(), [&](Halfedge_index h) {
        return mesh.target(h) == m_map.vertex_at_infinity();
      });
    };
    const auto faces = mesh.faces();
    return std::all_of(faces.begin(), faces.end(), is_at_infinity);
  }

  // of a sphere, whose polygon is in the plane y = 0
  std::size_t lost_in_flat_output() const
  {
    const Delta_complex& mesh = m_map.ideal().mesh();
    const auto at = [&](Halfedge_index h) {
      const Spherical_conformal_map::Point& p = m_map.position(mesh.source(h));
      return Plane_predicates<double>::Point{p[0], p[2]};
    };
    std::size_t result = 0;
    for(Face_index f : mesh.faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh);
      result += Plane_predicates<double>().orientation(at(side[0]), at(side[1]), at(side[2])) == 0;
    }
    return result;
  }

  std::size_t lost_in_output(const Inscribed_polygon& polygon) const
  {
    const Delta_complex& mesh = m_map.ideal().mesh();
    const auto at = [&](Halfedge_index h) {
      const Spherical_conformal_map::Point& p = m_map.position(mesh.source(h));
      return Plane_predicates<double>::Point{p[0], p[1]};
    };
    std::size_t result = 0;
    for(Face_index f : mesh.faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh);
      result += polygon.is_original(f) &&
                Plane_predicates<double>().orientation(at(side[0]), at(side[1]), at(side[2])) <= 0;
    }
    return result;
  }

  // The faces of a disk are those with a vertex inside; others are on its back.
  std::size_t lost_in_output() const
  {
    typedef Spherical_conformal_map::Point Point;
    const Delta_complex& mesh = m_map.ideal().mesh();
    const auto at = [&](Vertex_index v) { return m_map.position(v); };
    const Plane_predicates<double> predicates;
    const Point center{0, 0, 0};
    const auto is_inside = [&](Halfedge_index h) {
      const Vertex_index v = mesh.source(h);
      return v.idx() < m_problem.size() && !m_problem.is_on_boundary(v);
    };
    std::size_t result = 0;
    for(Face_index f : mesh.faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh);
      if(std::none_of(side.begin(), side.end(), is_inside))
        continue;
      const Point p = at(mesh.source(side[0])), q = at(mesh.source(side[1])),
                  r = at(mesh.source(side[2]));
      bool is_good = predicates.orientation(p, q, r, center) > 0;
      for(Halfedge_index h : side) {
        if(mesh.is_border(Edge_index(h)))
          continue;
        const Point beyond = at(mesh.target(mesh.next(mesh.opposite(h))));
        is_good = is_good && predicates.orientation(p, q, r, beyond) >= 0;
      }
      result += !is_good;
    }
    return result;
  }

  Doubled_problem& m_problem;
  Visitor& m_visitor;
  std::vector<double> m_mass;
  Spherical_conformal_map m_map;
  Map_builder m_builder;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_SPHERE_MAPPING_H
