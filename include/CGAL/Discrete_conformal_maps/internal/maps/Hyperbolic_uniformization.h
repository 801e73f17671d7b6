// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_HYPERBOLIC_UNIFORMIZATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_HYPERBOLIC_UNIFORMIZATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Hyperbolic_faces.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_builder.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/with_digits_as_needed.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Touching_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Vertex_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/exact_promises.h>
#include <CGAL/Intrinsic_triangulations/Tree_cotree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::Tree_cotree;

// Executes the steps from a doubled problem to a map, whose group is the group of the whole double.
class Hyperbolic_uniformization
{
public:
  Hyperbolic_uniformization(Doubled_problem& problem, Any_visitor& visitor)
    : m_problem(problem), m_visitor(visitor), m_scale(problem), m_builder(problem)
  {
    m_builder.set_geometry(Image_geometry::hyperbolic);
  }

  void find_scale_factors(const Any_minimizer& minimizer)
  {
    m_visitor.start(Flattening_stage::optimize);
    if(!m_builder.attempt([&] { m_scale.minimize(minimizer, tolerance::curvature, m_visitor); }))
      m_scale.stop();
  }

  Hyperbolic_conformal_map finish()
  {
    m_problem.complete();
    const std::vector<Map_promise> exact =
      exact_promises(m_problem, [this] { return m_scale.errors(); });
    m_layout.exists = m_builder.flip_if_in_range(m_scale);
    m_visitor.start(Flattening_stage::layout);
    if(!m_layout.exists || !m_builder.attempt([this] { lay_out(); }))
      leave_out();
    std::vector<Map_promise> promises = this->promises();
    promises.insert(promises.end(), exact.begin(), exact.end());
    m_builder.subdivide(m_visitor);
    if(m_layout.exists)
      m_builder.find_crowded([this](Halfedge_index h) {
        return (std::min)(height_in_Klein_disk(h), length_in_disk(h)); // keeps NaN
      });
    auto map = m_builder.template map<Hyperbolic_conformal_map>(std::move(m_layout));
    m_builder.judge(map, std::move(promises));
    return map;
  }

private:
  const Delta_complex& mesh() const { return m_builder.mesh(); }

  void leave_out()
  {
    m_layout.exists = false;
    m_layout.component.assign(mesh().num_faces(), 0);
    m_layout.groups.clear();
    m_layout.position.assign(mesh().num_halfedges(), {0, 0, 1});
    m_layout.seam.assign(mesh().num_edges(), m_layout.no_seam);
  }

  // Returns the length of a side of a face, in the Poincare disk. A hyperbolic length shrinks by
  // half of 1 - r^2 at the distance r from the center.
  double length_in_disk(Halfedge_index h) const
  {
    const double t =
      (std::max)(m_layout.position[h.idx()][2], m_layout.position[mesh().next(h).idx()][2]);
    return 2 * std::asinh(m_builder.scaled_length(h)) / (1 + t);
  }

  // Returns the height over the side `h` of a face in the Klein disk, whose points are (x, y) / t.
  // The determinant of the corners (x, y, t) is twice the sine of Hyperbolic_triangle.
  double height_in_Klein_disk(Halfedge_index h) const
  {
    std::array<double, 3> length;
    std::array<std::array<double, 3>, 3> corner;
    double area = 2;
    for(std::size_t s = 0; s < 3; ++s, h = mesh().next(h)) {
      length[s] = m_builder.scaled_length(h);
      corner[s] = m_layout.position[h.idx()];
      area /= corner[s][2];
    }
    area *= Hyperbolic_triangle<double>(length).corner(0).sine;
    const auto& [x0, y0, t0] = corner[0];
    const auto& [x1, y1, t1] = corner[1];
    return area / (std::max)(tolerance::unit, std::hypot(x1 / t1 - x0 / t0, y1 / t1 - y0 / t0));
  }

  // Returns the promises measured in the precision of the layout.
  std::vector<Map_promise> promises() const
  {
    std::vector<Map_promise> result = m_errors.promises(m_layout.exists);
    if(!m_layout.exists)
      return result;
    double relation = 0;
    for(const Fuchsian_group& group : m_layout.groups)
      relation =
        greater_error(relation, group.precise_generators.empty() ? group.relation_error
                                                                 : group.precise_relation_error);
    result.push_back(
      {"closing", m_layout.max_gluing_error, tolerance::gluing, Map_status::not_glued});
    result.push_back({"generators", relation, tolerance::gluing, Map_status::not_glued});
    return result;
  }

  // Lays out the faces. Errors grow exponentially with the distance from the origin, but shrink
  // with the rounding unit.
  void lay_out()
  {
    m_is_cone = m_problem.cones();
    double error = 1;
    if(!m_scale.is_extended())
      error = lay_out(m_builder.scaled_lengths(m_scale.precise_values<double>()));
    if(error > tolerance::gluing && tolerance::extended_gain * error <= tolerance::gluing)
      error = lay_out_with_more_digits<Double_double>();
    if(!(error <= tolerance::gluing)) {
      m_scale.sharpen(m_builder.data().ab, m_visitor);
      lay_out_with_more_digits<Decimal_115>();
    }
  }

  // Lays out the faces with more digits, which scale factors have already if the surface has
  // needles. If a triangulation is Delaunay with rounded scale factors, precise scale factors give
  // it another metric.
  template <typename FT>
  double lay_out_with_more_digits()
  {
    const std::vector<FT> u = m_problem.has_needles()
                                ? m_scale.precise_values<FT>()
                                : m_scale.template refine<FT>(m_builder.data().ab, m_visitor);
    m_builder.set_scale_factors(m_scale);
    return lay_out(m_builder.flip_again(u));
  }

  void set_components(const Tree_cotree& cut)
  {
    m_layout.component.clear();
    for(Face_index f : mesh().faces())
      m_layout.component.push_back(cut.component(f));
    m_layout.groups.assign(cut.number_of_components(), Fuchsian_group());
    for(std::size_t c = 0; c < m_layout.groups.size(); ++c)
      m_layout.groups[c].genus = cut.generators(c).size() / 2;
    const auto topology = m_problem.topology();
    m_layout.topology.resize(m_layout.groups.size());
    for(Face_index f : mesh().faces())
      m_layout.topology[m_layout.component[f.idx()]] =
        topology[m_problem.component(mesh().target(mesh().halfedge(f)))];
    m_has_cone.assign(m_layout.groups.size(), 0);
    for(Halfedge_index h : mesh().halfedges())
      m_has_cone[m_layout.component[mesh().face(h).idx()]] |= m_is_cone[mesh().source(h).idx()];
  }

  // Lays out the faces, and returns the error of the motion that must be the identity. `length`
  // contains sinh(x/2) for all edges with lengths x.
  template <typename FT>
  double lay_out(const std::vector<FT>& length)
  {
    std::vector<double> rounded_length;
    for(const FT& l : length)
      rounded_length.push_back(static_cast<double>(l));
    Tree_cotree cut(mesh(), crossing_lengths(mesh(), rounded_length));
    cut.close_ends(m_is_cone);
    set_components(cut);
    const Hyperbolic_faces<FT> layout(mesh(), length, cut);
    set_positions(layout, cut);
    set_gluings(layout, cut);
    set_areas(length);
    m_errors = defect_errors<Hyperbolic_triangle<FT>>(m_problem, mesh(), length);
    double error = m_layout.max_gluing_error = gluing_error(layout, cut);
    for(std::size_t c = 0; c < m_layout.groups.size(); ++c)
      if(const double relation = set_group(layout, cut, c); !(relation <= error)) // keeps NaN
        error = relation;
    return error;
  }

  // Sets the positions. Corners without a seam between them are one point, up to rounding.
  template <typename FT>
  void set_positions(const Hyperbolic_faces<FT>& layout, const Tree_cotree& cut)
  {
    m_layout.position.resize(mesh().num_halfedges());
    for(Vertex_index v : mesh().vertices())
      if(!mesh().is_isolated(v))
        cut.for_each_corner(v, [&](Halfedge_index h, Halfedge_index first) {
          const auto p = layout.frame(first).image_of_origin();
          for(std::size_t i = 0; i < 3; ++i)
            m_layout.position[h.idx()][i] = static_cast<double>(p[i]);
        });
  }

  template <typename FT>
  static Disk_motion<> rounded(const Disk_motion<FT>& motion)
  {
    const auto& e = motion.entries();
    return {static_cast<double>(e[0]), static_cast<double>(e[1]), static_cast<double>(e[2]),
            static_cast<double>(e[3])};
  }

  template <typename FT>
  void set_gluings(const Hyperbolic_faces<FT>& layout, const Tree_cotree& cut)
  {
    m_layout.seam.assign(mesh().num_edges(), m_layout.no_seam);
    m_layout.gluing.clear();
    for(Edge_index e : mesh().edges())
      if(cut.is_seam(e)) {
        m_layout.seam[e.idx()] = m_layout.gluing.size();
        m_layout.gluing.push_back(rounded(layout.gluing(mesh().halfedge(e))));
      }
  }

  template <typename FT>
  double gluing_error(const Hyperbolic_faces<FT>& layout, const Tree_cotree& cut) const
  {
    std::vector<char> is_open(mesh().num_vertices(), 0);
    for(Edge_index e : mesh().edges())
      if(cut.is_open(e))
        is_open[mesh().vertex(e, 0).idx()] = is_open[mesh().vertex(e, 1).idx()] = 1;
    double result = 0;
    for(Vertex_index v : mesh().vertices())
      if(is_open[v.idx()] && !m_is_cone[v.idx()]) {
        const double error = layout.gluing_error(v);
        result = error <= result ? result : error; // keeps NaN
      }
    return result;
  }

  template <typename FT>
  void set_areas(const std::vector<FT>& length)
  {
    for(Face_index f : mesh().faces()) {
      const auto side = sides(f, mesh());
      const auto of = [&](std::size_t s) {
        return static_cast<double>(length[Edge_index(side[s]).idx()]);
      };
      m_layout.groups[m_layout.component[f.idx()]].area +=
        2 * Hyperbolic_triangle<double>({of(0), of(1), of(2)}).half_defect();
    }
  }

  // Returns the error of the relation in the precision of the layout, or the error of the stored
  // generators if it is greater.
  template <typename FT>
  double set_group(const Hyperbolic_faces<FT>& layout, const Tree_cotree& cut, std::size_t c)
  {
    Fuchsian_group& group = m_layout.groups[c];
    const std::vector<Edge_index>& edges = cut.generators(c);
    std::vector<Disk_motion<FT>> motion;
    for(Edge_index e : edges)
      motion.push_back(layout.gluing(mesh().halfedge(e)));
    for(const Disk_motion<FT>& m : motion)
      group.generators.push_back(rounded(m));
    if(m_has_cone[c])
      return 0;
    for(Halfedge_index h : cut.relation(c)) {
      const auto i = static_cast<std::size_t>(std::find(edges.begin(), edges.end(), Edge_index(h)) -
                                              edges.begin());
      group.relation.push_back({i, !Intrinsic_triangulations::is_first_halfedge(h)});
    }
    group.relation_error = relation_error(group, rounded_to_digits(group.generators, 0));
    if constexpr(std::is_same_v<FT, double>)
      return group.relation_error;
    else {
      const double error = relation_error(group, motion);
      set_precise_generators(motion, error, group);
      return greater_error(error, group.precise_relation_error);
    }
  }

  // Rounds motions to the digits that matter for the error of the relation; more digits are noise.
  template <typename FT>
  static void set_precise_generators(const std::vector<Disk_motion<FT>>& motion, double error,
                                     Fuchsian_group& group)
  {
    group.known_digits = std::numeric_limits<double>::digits10;
    do {
      group.precise_generators = rounded_to_digits(motion, ++group.known_digits);
      group.precise_relation_error = relation_error(group, group.precise_generators);
    } while(!(group.precise_relation_error <= 2 * error) &&
            group.known_digits < std::numeric_limits<FT>::max_digits10);
  }

  // Returns the rounded motions, or all digits if `digits` is zero.
  template <typename FT>
  static std::vector<Disk_motion<Decimal_115>>
  rounded_to_digits(const std::vector<Disk_motion<FT>>& motions, int digits)
  {
    const auto number = [&](const FT& x) {
      const Decimal_115 exact = converted<Decimal_115>(x);
      return digits == 0 ? exact : Decimal_115(exact.str(digits));
    };
    std::vector<Disk_motion<Decimal_115>> result;
    for(const Disk_motion<FT>& motion : motions) {
      const auto& e = motion.entries();
      result.emplace_back(number(e[0]), number(e[1]), number(e[2]), number(e[3]));
    }
    return result;
  }

  Doubled_problem& m_problem;
  Any_visitor& m_visitor;
  Hyperbolic_scale_factors m_scale;
  Map_builder m_builder;
  Hyperbolic_layout m_layout;
  std::vector<char> m_is_cone;                      // for each vertex
  std::vector<char> m_has_cone;                     // for each component
  Defect_errors m_errors = unknown_defect_errors(); // of the scaled surface
};

// Returns the map. Rounded lengths of a double are not symmetric, and generators of its group
// multiply the difference. More digits are used if the map is then not glued.
template <typename Visitor>
Hyperbolic_conformal_map
uniformized(const Intrinsic_triangulations::Intrinsic_triangulation<>& input,
            const Map_parameters& parameters, Visitor visitor)
{
  const Vertex_circles circles(parameters.radii);
  const auto work = std::make_shared<Search_work>();
  const auto find = [&](Intrinsic_triangulations::Intrinsic_triangulation<> surface,
                        Exactness exactness) {
    Doubled_problem problem(std::move(surface), parameters.conditions, Flipping::to_Delaunay,
                            exactness, circles);
    problem.check_hyperbolic();
    Touching_circles(problem).check();
    problem.set_concurrency(parameters.concurrency);
    problem.share_work(work);
    Hyperbolic_uniformization uniformization(problem, visitor);
    uniformization.find_scale_factors(minimizer_of(parameters));
    return uniformization.finish();
  };
  return with_digits_as_needed(input, find, !circles.exist());
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_HYPERBOLIC_UNIFORMIZATION_H
