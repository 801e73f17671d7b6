// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_FLATTENING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_FLATTENING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Chart_packing.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Cone_tree.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_builder.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Named_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Touching_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/component_areas.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Free_shape.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Plane_picture.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the promises of every map to the plane that has a layout.
inline std::vector<Map_promise> planar_promises(const Plane_picture& picture)
{
  return {
    {"orientation", double(picture.number_of_collapsed_faces()), 0, Map_status::layout_collapsed},
    {"cross_ratio", picture.max_cross_ratio_error(), tolerance::cross_ratio,
     Map_status::not_conformal},
    {"closing", picture.edge_length_error(), tolerance::promised_length, Map_status::not_closed}};
}

// Executes the steps from a doubled problem to a map.
class Flattening
{
public:
  Flattening(Doubled_problem& problem, Any_visitor& visitor)
    : m_problem(problem), m_visitor(visitor), m_scale(problem), m_builder(problem)
  {}

  // Starts from scale factors at the vertices of the input.
  void start_from(const std::vector<double>& log_scale) { m_scale.start_from(log_scale); }

  // Starts from scale factors that were found with bounded differences for the same surface.
  void resume(const std::vector<Double_double>& found) { m_scale.resume(found); }
  const std::vector<Double_double>& found_with_bounds() const
  {
    return m_scale.found_with_bounds();
  }

  // Finds scale factors. If scale factors have a finite bound, the first call places cones before.
  void find_scale_factors(const Any_minimizer& minimizer, const Cone_choice& choice)
  {
    const double bound = choice.maximum_log_scale;
    m_visitor.start(Flattening_stage::cones);
    const bool is_bounded = bound < std::numeric_limits<double>::infinity();
    if(is_bounded && !std::exchange(m_has_placed_cones, true))
      m_scale.place_cones(choice, m_visitor);
    m_problem.check();
    if(!is_bounded) // otherwise cones may be added around which circles touch
      Touching_circles(m_problem).check();
    m_visitor.start(Flattening_stage::optimize);
    do
      m_scale.minimize(m_scale.ending_beyond(bound, minimizer), tolerance::curvature, m_visitor);
    while(is_bounded && m_scale.status() != Map_status::not_converged &&
          m_scale.add_cone_if_beyond(bound));
  }

  // Stores scale factors that need no search, and the flips from T_2 to T_3.
  void take(const std::vector<Decimal_115>& log_scale, const std::vector<Halfedge_index>& flips)
  {
    m_visitor.start(Flattening_stage::cones);
    m_visitor.start(Flattening_stage::optimize);
    m_scale.take(log_scale);
    m_flips = flips;
  }

  // Returns whether scale factors have been found.
  bool has_succeeded() const { return m_scale.status() == Map_status::success; }

  // Returns the result of the last minimization.
  const Minimization_result& minimization() const { return m_scale.result(); }

  Any_visitor& visitor() const { return m_visitor; }

  // Calls `search()`, which finds scale factors. A numerical error ends the search.
  template <typename Search>
  void attempt(const Search& search)
  {
    if(!m_builder.attempt(search))
      m_scale.stop();
  }

  // Returns the scale factors at the vertices of the surface.
  const Scale_values& scale_factors() const { return m_scale; }
  bool has_bounded_differences() const { return m_scale.has_bounded_differences(); }

  // Lays the faces out. `shape` has further promises about the image of the boundary.
  template <typename Shape>
  Planar_conformal_map finish(Named_layout layout, const Shape& shape)
  {
    if(has_succeeded())
      m_builder.attempt([this] { m_scale.sharpen(m_problem.triangulation(), m_visitor); });
    const auto exact = exact_promises(m_problem, [this] { return m_scale.errors(); });
    if(!exact.empty())
      m_rounded_error = exact.back().error;
    m_layout.exists = flip() && m_scale.has_layout();
    if(m_layout.exists)
      find_cut_edges();
    lay_out_or_fail(layout);
    std::vector<Map_promise> promises = m_errors.promises(m_layout.exists);
    if(m_problem.is_exact())
      promises.push_back({"rounded_curvature", m_rounded_error, tolerance::promised_rounded_angle,
                          Map_status::wrong_curvature});
    promises.insert(promises.end(), exact.begin(), exact.end());
    const std::vector<char> is_disk = disks_without_cones();
    m_problem.drop_surface();
    m_builder.subdivide(m_visitor);
    auto map = m_builder.template map<Planar_conformal_map>(m_scale.cones(), std::move(m_layout));
    if(map.is_laid_out()) {
      arrange_charts(map);
      const Plane_picture picture = map.picture();
      m_builder.set_crowded(picture.crowded_faces());
      for(const auto& part :
          {planar_promises(picture), shape.promises(map, whole_charts(map, is_disk))})
        promises.insert(promises.end(), part.begin(), part.end());
    }
    m_builder.judge(map, std::move(promises));
    return map;
  }

private:
  const Delta_complex& mesh() const { return m_builder.mesh(); }

  // Computes T_3, and returns whether it has lengths.
  bool flip()
  {
    if(!m_flips)
      return m_builder.flip_if_in_range(m_scale);
    m_builder.flip(*m_flips);
    m_builder.set_scale_factors(m_scale);
    return true;
  }

  void lay_out_or_fail(Named_layout layout)
  {
    m_visitor.start(Flattening_stage::layout);
    if(m_layout.exists)
      m_layout.exists = m_builder.attempt([&] { lay_out_in_plane(layout); });
    const auto is_finite = [](const std::complex<double>& z) {
      return std::isfinite(z.real()) && std::isfinite(z.imag());
    };
    if(!m_layout.exists ||
       !std::all_of(m_layout.position.begin(), m_layout.position.end(), is_finite))
      leave_out();
  }

  // Finds the cut edges. On a doubled surface, only edges of T_3 with a part inside the input are
  // crossed, which the subdivision determines.
  void find_cut_edges()
  {
    m_is_cut_edge.assign(mesh().num_edges(), m_problem.has_no_copies() ? 0 : 1);
    m_layout.is_laid_out.assign(mesh().num_faces(), 1);
    if(m_problem.has_no_copies())
      return;
    m_builder.subdivide(m_visitor);
    const Map_data& data = m_builder.data();
    const auto& subdivision = *data.subdivision;
    for(Edge_index e : subdivision.mesh().edges())
      if(const Edge_index c = subdivision.parent_edge(Layer::C, e); c.is_valid())
        if(const Halfedge_index h = subdivision.mesh().halfedge(e);
           data.is_original(h) && data.is_original(opposite(h)))
          m_is_cut_edge[c.idx()] = 0;
    m_layout.is_laid_out = data.is_partly_original;
  }

  // Returns the vertices around which faces do not close up: cones and ends of cut edges.
  std::vector<char> terminals() const
  {
    std::vector<char> result = m_problem.cones();
    for(Vertex_index v : mesh().vertices())
      if(mesh().is_isolated(v))
        result[v.idx()] = 0;
    for(Edge_index e : mesh().edges())
      if(m_is_cut_edge[e.idx()])
        result[mesh().vertex(e, 0).idx()] = result[mesh().vertex(e, 1).idx()] = 1;
    return result;
  }

  std::size_t component(Face_index f) const
  {
    return m_problem.component(mesh().target(mesh().halfedge(f)));
  }

  // Returns the logarithm by which the area of each component must grow in the plane to be its area
  // on the surface. `FT` has the range of squared areas in the plane.
  template <typename FT>
  std::vector<double> log_growths() const
  {
    using std::log;
    const auto& Delaunay = m_builder.data().ab;
    const std::vector<FT> flat = component_areas(
      m_problem, mesh(), [&](Halfedge_index h) { return m_builder.scaled_length<FT>(h); });
    const std::vector<double> curved = component_areas(
      m_problem, Delaunay.mesh(), [&](Halfedge_index h) { return Delaunay.length(Edge_index(h)); });
    std::vector<double> result;
    for(std::size_t c = 0; c < flat.size(); ++c)
      result.push_back(static_cast<double>(log(curved[c] / flat[c])));
    return result;
  }

  // Returns the number to be added to the scale factors of each component. If no scale factors are
  // prescribed, it preserves the area of the component. Otherwise it is zero.
  std::vector<double> area_correction() const
  {
    const std::vector<double> log_growth = are_far_apart(m_builder.data().log_scale)
                                             ? log_growths<Wide_number<double>>()
                                             : log_growths<double>();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<double> result(m_problem.size(), 0);
    for(std::size_t v = 0; v < result.size(); ++v)
      if(const std::size_t c = m_problem.components()[v]; fixed[c] == 0)
        result[v] = log_growth[c] / 2;
    return result;
  }

  // Returns for each component whether it is a disk without cones, whose chart is not to be cut.
  std::vector<char> disks_without_cones() const
  {
    const Delta_complex& surface = m_problem.surface();
    std::vector<int> characteristic(m_problem.components().size(), 0);
    for(Vertex_index v : surface.vertices())
      ++characteristic[m_problem.component(v)];
    for(Edge_index e : surface.edges())
      --characteristic[m_problem.component(surface.vertex(e, 0))];
    for(Face_index f : surface.faces())
      ++characteristic[m_problem.component(surface.target(surface.halfedge(f)))];
    std::vector<char> result;
    for(const int c : characteristic)
      result.push_back(c == 1);
    for(Vertex_index v : m_scale.cones())
      result[m_problem.component(v)] = 0;
    return result;
  }

  // Returns for each component whether its chart is not cut, or is not to be cut. Cones and handles
  // require cuts.
  std::vector<char> whole_charts(const Planar_conformal_map& map,
                                 const std::vector<char>& is_disk) const
  {
    std::vector<char> result(m_problem.components().size(), 1);
    for(Edge_index e : mesh().edges()) {
      const Halfedge_index h = mesh().halfedge(e);
      if(map.is_seam(e) && !m_is_cut_edge[e.idx()] && map.is_laid_out(mesh().face(h)) &&
         map.is_laid_out(mesh().face(mesh().opposite(h))))
        result[component(mesh().face(h))] = is_disk[component(mesh().face(h))];
    }
    return result;
  }

  void leave_out()
  {
    m_layout.exists = false;
    m_layout.is_laid_out.assign(mesh().num_faces(), 0);
    m_layout.position.assign(mesh().num_halfedges(), 0);
    m_layout.is_seam.assign(mesh().num_edges(), 1);
  }

  // Lays out the faces. More digits are used if scale factors in `double` do not yield the promised
  // curvatures, or if errors of positions exceed their rounding.
  void lay_out_in_plane(Named_layout layout)
  {
    const std::vector<double> correction = area_correction();
    m_builder.add_to_scale_factors(correction);
    if(!m_scale.is_extended()) {
      const std::vector<double> length =
        measured(std::vector<double>(m_scale.values().begin(), m_scale.values().end()), correction);
      if(m_errors.greatest() <= tolerance::promised_angle && is_faithful(length, layout))
        return;
    }
    if(m_scale.has_115_digits()) {
      const auto length = measured(m_scale.precise_values<Decimal_115>(), correction);
      if(!is_faithful(length, Incremental_layout()))
        lay_out_with_all_digits(length);
      return;
    }
    const std::vector<Double_double> u = m_scale.precise_values<Double_double>();
    if(!m_scale.is_wide() && is_faithful(measured(u, correction), layout))
      return;
    lay_out_with_all_digits(
      measured(std::vector<Wide_number<Double_double>>(u.begin(), u.end()), correction));
  }

  template <typename FT>
  void lay_out_with_all_digits(const std::vector<FT>& length)
  {
    std::vector<Decimal_1500> with_all_digits;
    for(const FT& l : length)
      with_all_digits.push_back(converted<Decimal_1500>(l));
    lay_out(with_all_digits, Incremental_layout());
  }

  template <typename FT, typename Layout_model>
  bool is_faithful(const std::vector<FT>& length, const Layout_model& layout)
  {
    lay_out(length, layout);
    return Plane_picture(m_builder.data(), m_layout).is_faithful();
  }

  // Returns the lengths of the edges of T_3, after their angles have been measured.
  template <typename FT>
  std::vector<FT> measured(std::vector<FT> u, const std::vector<double>& correction)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += FT(correction[v]);
    std::vector<FT> result = m_builder.scaled_lengths(u);
    m_errors = defect_errors<Flat_triangle<FT>>(m_problem, mesh(), result);
    if(m_problem.is_exact())
      m_rounded_error = rounded_curvature_error();
    return result;
  }

  template <typename FT, typename Layout_model>
  void lay_out(const std::vector<FT>& exact, const Layout_model& layout)
  {
    std::vector<double> length(mesh().num_edges());
    for(Edge_index e : mesh().edges())
      length[e.idx()] = m_builder.scaled_length(Halfedge_index(2 * e.idx()));
    const Cut_graph cut = cut_to_pieces(mesh(), length, crossing_order(exact), m_is_cut_edge,
                                        m_layout.is_laid_out, terminals());
    Unfolded_faces<FT> faces(mesh(), exact, cut);
    layout(faces, *m_problem.expanded_order());
    m_layout.position.clear();
    m_layout.is_seam.clear();
    m_layout.position.reserve(mesh().num_halfedges());
    for(Halfedge_index h : mesh().halfedges())
      m_layout.position.push_back(to_complex(faces.position(h)));
    m_layout.is_seam.reserve(mesh().num_edges());
    for(Edge_index e : mesh().edges())
      m_layout.is_seam.push_back(cut.is_seam(e));
  }

  // Returns the greatest error of a curvature on the exact surface, with the scale factors that the
  // map stores in `double`.
  double rounded_curvature_error() const
  {
    const auto& u = m_builder.data().log_scale;
    return defect_errors<Flat_triangle<Double_double>>(
             m_problem, mesh(),
             m_builder.scaled_lengths(
               std::vector<Double_double>(u.begin(), u.begin() + std::ptrdiff_t(m_problem.size()))))
      .greatest();
  }

  // Arranges the charts of different components side by side. Parts beyond the boundary do not
  // count.
  void arrange_charts(Planar_conformal_map& map) const
  {
    const auto& subdivision = map.subdivision();
    std::vector<Hull_points> points(m_problem.components().size());
    for(Halfedge_index h : subdivision.mesh().halfedges())
      if(map.is_original(h)) {
        const Face_index f = subdivision.parent_face(Layer::C, subdivision.mesh().face(h));
        points[component(f)].add(map.image(h));
      }
    const Chart_packing packing(points);
    map.transform([&](Halfedge_index h, const std::complex<double>& z) {
      return packing.motion(component(mesh().face(h)))(z);
    });
  }

  Doubled_problem& m_problem;
  Any_visitor& m_visitor;
  Flat_scale_factors m_scale;
  Map_builder m_builder;
  Planar_layout m_layout;
  std::optional<std::vector<Halfedge_index>> m_flips; // to T_3, if they are known
  bool m_has_placed_cones = false;
  std::vector<char> m_is_cut_edge;                  // edges of T_3 that are not passed
  Defect_errors m_errors = unknown_defect_errors(); // of the scaled surface
  double m_rounded_error = 0;                       // on the exact surface, if it is measured
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_FLATTENING_H
