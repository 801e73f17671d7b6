// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_BUILDER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_BUILDER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Wide_number.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Axis_crossings.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/certify_ideal_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

inline Any_minimizer minimizer_of(const Map_parameters& parameters)
{
  return parameters.minimizer ? parameters.minimizer : Newton_minimizer();
}

// Executes the steps from scale factors to the common parts of all maps.
class Map_builder
{
  auto concurrency() const
  {
    return Intrinsic_triangulations::parameters::concurrency_tag(m_problem.concurrency());
  }

public:
  explicit Map_builder(Doubled_problem& problem) : m_problem(problem)
  {
    m_data.number_of_original_faces = problem.surface().num_faces();
    m_data.counts = problem.order()->counts();
  }

  void set_geometry(Image_geometry geometry) { m_data.geometry = geometry; }

  // Stores scale factors at the vertices of the surface itself, and how they were found.
  template <typename Values>
  void set_scale_factors(const Values& u, Map_status search, const Minimization_result& result,
                         double max_curvature_error)
  {
    m_outcome.status = search;
    m_outcome.minimization = result;
    m_outcome.max_curvature_error = max_curvature_error;
    const auto all = m_problem.expanded(u);
    m_data.log_scale.assign(all.data(), all.data() + all.size());
  }
  template <typename Scale_factors>
  void set_scale_factors(const Scale_factors& scale)
  {
    set_scale_factors(scale.values(), scale.status(), scale.result(), scale.max_curvature_error());
  }

  // Records that a numerical error has ended the search or the layout.
  void set_cause(const std::string& message)
  {
    if(m_outcome.cause.empty())
      m_outcome.cause = message;
  }

  // Calls `function()`. Records a numerical error that ends it. Returns whether none occurred.
  template <typename Function>
  bool attempt(const Function& function)
  {
    try {
      function();
      return true;
    } catch(const Intrinsic_triangulations::Numerical_error& e) {
      set_cause(e.what());
    } catch(const Intrinsic_triangulations::Flip_limit_exceeded& e) {
      set_cause(e.what());
    }
    return false;
  }

  // Returns the data of the map.
  const Map_data& data() const { return m_data; }

  // Returns the map that consists of the data and of other parts. Must be called only once.
  template <typename Map, typename... Parts>
  Map map(Parts&&... parts)
  {
    return Map(std::move(m_owner), std::forward<Parts>(parts)...);
  }

  // Records the faces of the input with a part in one of these faces of T_3. The subdivision must
  // exist.
  void set_crowded(const std::vector<char>& is_crowded)
  {
    std::vector<Face_index>& result = m_outcome.crowded_faces;
    result.clear();
    if(std::count(is_crowded.begin(), is_crowded.end(), 1) == 0)
      return;
    const auto& subdivision = *m_data.subdivision;
    for(Face_index f : subdivision.mesh().faces())
      if(const Face_index on_A = subdivision.parent_face(Layer::A, f);
         m_data.is_original(on_A) && is_crowded[subdivision.parent_face(Layer::C, f).idx()])
        result.push_back(on_A);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
  }

  // Records faces of T_3 with a side whose `size(h)` may be only rounding error, or is unknown.
  // `size(h)` is a length in a picture with coordinates of at most one.
  template <typename Size>
  void find_crowded(const Size& size)
  {
    std::vector<char> is_crowded(mesh().num_faces(), 0);
    for(Halfedge_index h : mesh().halfedges())
      if(!mesh().is_border(h))
        is_crowded[mesh().face(h).idx()] |=
          !(size(h) > tolerance::roundings_of_position * tolerance::unit);
    set_crowded(is_crowded);
  }

  // Determines the status of the map and the error of its curvatures, by measurements on it.
  void judge(Discrete_conformal_map& map, std::vector<Map_promise> promises)
  {
    m_outcome.status = status_of(promises, m_outcome.status);
    m_outcome.max_curvature_error = curvature_error_of(promises, m_outcome.max_curvature_error);
    m_outcome.promises = std::move(promises);
    map.set_outcome(m_outcome);
  }

  // Adds corrections at the vertices of the surface itself.
  void add_to_scale_factors(const std::vector<double>& correction)
  {
    for(std::size_t v = 0; v < m_data.log_scale.size(); ++v)
      m_data.log_scale[v] += correction[m_data.input_vertex[v].idx()];
  }

  // Makes the triangulation of the problem ideal Delaunay with the scale factors. `scale` has their
  // values at the vertices of the surface itself.
  template <typename Scale_factors>
  void flip(const Scale_factors& scale)
  {
    flip(flips_to_Delaunay(scale));
    set_scale_factors(scale);
    if(m_problem.is_exact() && !scale.is_wide())
      flip_exactly();
  }

  // Flips like `flip()`, or uses the triangulation of the problem without flips if lengths with
  // these scale factors are out of range. Returns whether they are in range.
  template <typename Scale_factors>
  bool flip_if_in_range(const Scale_factors& scale)
  {
    if(attempt([&] { flip(scale); }))
      return true;
    flip(std::vector<Halfedge_index>());
    set_scale_factors(scale);
    return false;
  }

  // Applies these flips to the triangulation of the problem.
  void flip(std::vector<Halfedge_index> flips)
  {
    m_data.input_vertex = m_problem.originals();
    m_data.ab = std::move(m_problem.triangulation());
    m_data.number_of_flips[1] = m_problem.number_of_flips();
    set_flips(std::move(flips));
  }

  // Makes T_3 ideal Delaunay with more precise scale factors at the vertices of the surface itself.
  // Returns its scaled lengths.
  template <typename FT>
  std::vector<FT> flip_again(const std::vector<FT>& u)
  {
    std::vector<FT> all;
    for(Vertex_index v : m_data.input_vertex)
      all.push_back(u[v.idx()]);
    Penner_surface<FT> surface(m_data.ab.mesh(), m_problem.template lengths<FT>(m_data.ab),
                               m_problem.flipping(), m_problem.template radii<FT>());
    surface.scale(all);
    set_flips(surface.flips());
    std::vector<FT> result;
    for(Edge_index e : mesh().edges())
      result.push_back(surface.has_radii() ? m_data.between_centers(
                                               surface.scaled_decorated_length(mesh().halfedge(e)))
                                           : surface.scaled_length(e));
    return result;
  }

  // Traces T_1 and T_2, and T_2 and T_3, over each other, and computes their common subdivision,
  // unless it exists. Except for a factor of a layout, it needs most memory.
  void subdivide(Any_visitor& visitor)
  {
    if(m_data.subdivision)
      return;
    visitor.start(Flattening_stage::trace);
    m_data.correspondence_ab =
      std::make_unique<Intrinsic_triangulations::Correspondence<>>(m_data.ab, concurrency());
    m_data.correspondence_bc = std::make_unique<
      Intrinsic_triangulations::Correspondence<Discrete_conformal_map::Ideal_traits>>(
      m_data.bc, concurrency());
    visitor.start(Flattening_stage::subdivide);
    m_data.subdivision = std::make_unique<Discrete_conformal_map::Subdivision>(
      *m_data.correspondence_ab, *m_data.correspondence_bc, concurrency(),
      m_data.number_of_original_faces);
    if(!m_problem.has_no_copies())
      Axis_crossings(*m_data.subdivision, m_data.number_of_original_faces, m_data.input_vertex)
        .set_coordinates([&](Halfedge_index h) { return m_data.length(h); });
    m_data.is_partly_original.assign(mesh().num_faces(), 0);
    for(Face_index f : m_data.subdivision->mesh().faces())
      if(m_data.is_original(m_data.subdivision->parent_face(Layer::A, f)))
        m_data.is_partly_original[m_data.subdivision->parent_face(Layer::C, f).idx()] = 1;
  }

  // Returns T_3.
  const Delta_complex& mesh() const { return m_data.bc.mesh(); }

  template <typename FT = double>
  FT scaled_length(Halfedge_index h) const
  {
    return m_data.scaled_length<FT>(h);
  }

  // Returns the scaled lengths of the edges of T_3, by the recorded flips in the precision of the
  // scale factors. `u` contains them for the vertices of the surface itself.
  template <typename FT>
  std::vector<FT> scaled_lengths(const std::vector<FT>& u) const
  {
    Ptolemy_surface<FT> surface(m_data.bc.input_mesh(), m_problem.template lengths<FT>(m_data.ab),
                                m_problem.template radii<FT>());
    surface.replay(m_flips);
    std::vector<FT> result(mesh().num_edges());
    const auto at = [&](Vertex_index v) -> const FT& {
      return u[m_data.input_vertex[v.idx()].idx()];
    };
    for(Edge_index e : mesh().edges()) {
      const Halfedge_index h = mesh().halfedge(e);
      const FT &u_i = at(mesh().source(h)), &u_j = at(mesh().target(h));
      result[e.idx()] =
        surface.has_radii()
          ? m_data.between_centers(scaled(surface.decorated_length(h), u_i, u_j))
          : internal::scaled_length(surface.length(e), length_factor(FT(u_i + u_j)));
    }
    return result;
  }

private:
  // Returns the flips to T_3, with the digits and the range of the scale factors, unless
  // `flip_exactly()` decides in `double`, exactly for these numbers.
  template <typename Scale_factors>
  std::vector<Halfedge_index> flips_to_Delaunay(const Scale_factors& scale)
  {
    if(scale.is_wide()) {
      const std::vector<Double_double> u = scale.template precise_values<Double_double>();
      return m_problem.scaled(std::vector<Wide_number<Double_double>>(u.begin(), u.end())).flips();
    }
    if(m_problem.has_needles() && scale.has_115_digits())
      return m_problem.scaled(scale.template precise_values<Decimal_115>()).flips();
    if(scale.is_extended() && (m_problem.has_needles() || !m_problem.is_exact()))
      return m_problem.scaled(scale.template precise_values<Double_double>()).flips();
    const auto& values = scale.values();
    return m_problem.scaled(std::vector<double>(values.begin(), values.end())).flips();
  }

  // Makes T_3 exactly ideal Delaunay with the stored scale factors and lengths in `double`, if
  // rounding has left it undecided. Edges at which the copy of the surface ends are not flipped.
  void flip_exactly()
  {
    std::vector<double> factor;
    for(const double u : m_data.log_scale)
      factor.push_back(length_factor(u));
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      std::vector<char> stays(mesh().num_edges(), 0);
      for(Edge_index e : m_problem.seams())
        stays[e.idx()] = 1;
      for(Edge_index e : certify_ideal_Delaunay(m_data.bc, factor).non_Delaunay_edges) {
        const Halfedge_index h = mesh().halfedge(e);
        const auto around = Intrinsic_triangulations::edges_around(h, mesh());
        if(stays[e.idx()])
          continue;
        m_data.bc.flip(h);
        m_flips.push_back(h);
        has_changed = true;
        for(Edge_index side : around)
          stays[side.idx()] = 1; // it has another diamond now
      }
    }
    m_data.number_of_flips[2] = m_flips.size();
  }

  void set_flips(std::vector<Halfedge_index> flips)
  {
    m_data.bc = Discrete_conformal_map::Ideal_triangulation(
      m_data.ab.mesh(),
      Intrinsic_triangulations::parameters::edge_length_map(m_problem.lengths<double>(m_data.ab))
        .geom_traits(Discrete_conformal_map::Ideal_traits(m_problem.radii<double>())));
    for(Halfedge_index h : flips)
      m_data.bc.flip(h);
    m_data.number_of_flips[2] = flips.size();
    m_flips = std::move(flips);
  }

  Doubled_problem& m_problem;
  std::unique_ptr<Map_data> m_owner = std::make_unique<Map_data>();
  Map_data& m_data = *m_owner; // stays where it is when the map gets it
  Map_outcome m_outcome;
  std::vector<Halfedge_index> m_flips; // from T_2 to T_3
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_BUILDER_H
