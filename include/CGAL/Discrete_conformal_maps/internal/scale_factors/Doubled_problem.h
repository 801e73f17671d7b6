// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/concurrency/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The surface that is uniformized, without boundary, and what is prescribed at its vertices. A
// surface with boundary is doubled (Section 4.3.4); the vertices on its boundary have twice the
// prescribed exterior angle.
class Doubled_problem
{
public:
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Triangulation;

private:
  auto lengths(const Triangulation& half)
  {
    m_length.resize(m_double.mesh().num_edges());
    for(Edge_index e : m_half.edges())
      m_length[e.idx()] = m_length[m_double.mirrored(e).idx()] = half.length(e);
    const auto length = boost::make_function_property_map<Edge_index>(
      [this](Edge_index e) { return m_length[e.idx()]; });
    return Intrinsic_triangulations::parameters::edge_length_map(length);
  }

public:
  typedef Intrinsic_triangulations::internal::Mesh_components Components;
  typedef Eigen::VectorXd Vector;

  // `half` is the surface, `condition` has one entry for each of its vertices; the flips to T^B can be
  // decided exactly
  Doubled_problem(const Triangulation& half, const std::vector<Vertex_condition>& condition,
                  Flipping flipping, bool has_exact_flips = false)
    : m_flipping(flipping),
      m_half(half.mesh()),
      m_double(m_half, faces_to_copy(m_half)),
      m_triangulation(m_double.mesh(), lengths(half)),
      m_components(m_double.mesh()),
      m_front(m_double.mesh().num_vertices()),
      m_is_fixed(m_double.mesh().num_vertices(), 0),
      m_value(Vector::Zero(Eigen::Index(m_is_fixed.size())))
  {
    if(flipping == Flipping::to_Delaunay)
      m_number_of_flips = Intrinsic_triangulations::make_Delaunay(
        m_triangulation, Intrinsic_triangulations::parameters::exact_decisions(has_exact_flips));
    for(Vertex_index v : m_half.vertices()) {
      m_front[mirrored(v).idx()] = m_front[v.idx()] = v;
      set_condition(v, condition[v.idx()]);
    }
  }

  Doubled_problem(const Doubled_problem&) = delete;
  Doubled_problem& operator=(const Doubled_problem&) = delete;

  // whether T^B and T^C are Delaunay, or the same as T^A
  Flipping flipping() const { return m_flipping; }

  // whether several threads are used, by those that solve the problem
  Intrinsic_triangulations::internal::Concurrency concurrency() const { return m_concurrency; }
  void set_concurrency(Intrinsic_triangulations::internal::Concurrency c) { m_concurrency = c; }

  // T^A and T^B
  const Triangulation& triangulation() const { return m_triangulation; }
  Triangulation& triangulation() { return m_triangulation; }

  // from T^A to T^B
  std::size_t number_of_flips() const { return m_number_of_flips; }

  std::size_t size() const { return m_is_fixed.size(); }

  bool is_on_boundary(Vertex_index v) const
  {
    return v.idx() < m_half.num_vertices() && m_half.is_border(v) && !m_half.is_isolated(v);
  }

  // the vertices of the surface itself
  auto surface_vertices() const { return m_half.vertices(); }

  // the copy of a vertex of the surface; itself if there is none
  Vertex_index mirrored(Vertex_index v) const { return m_double.mirrored(v); }

  // the vertex of the surface of which `v` is a copy, or which it is
  Vertex_index front(Vertex_index v) const { return m_front[v.idx()]; }

  // the components of the doubled surface
  const Components& components() const { return m_components; }

  // the vertices where scale factors are prescribed
  const std::vector<char>& is_fixed() const { return m_is_fixed; }
  // the scale factor where it is prescribed
  double scale_factor(std::size_t v) const { return m_is_fixed[v] ? m_value[Eigen::Index(v)] : 0; }
  // the angle defects that are prescribed; zero elsewhere
  Vector target_defect() const
  {
    Vector result = m_value;
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        result[Eigen::Index(v)] = 0;
    return result;
  }

  void set_condition(Vertex_index v, const Vertex_condition& condition)
  {
    const bool is_scale = condition.quantity == Vertex_condition::Quantity::log_scale;
    const double value = !is_scale && is_on_boundary(v) ? 2 * condition.value : condition.value;
    if(!std::isfinite(value))
      throw Intrinsic_triangulations::Invalid_input("what is prescribed at vertex " +
                                                    std::to_string(v.idx()) + " is NaN");
    for(Vertex_index x : {v, mirrored(v)}) {
      m_is_fixed[x.idx()] = is_scale || m_half.is_isolated(v);
      m_value[Eigen::Index(x.idx())] = !is_scale && m_half.is_isolated(v) ? 0 : value;
    }
  }

  // the area of each component in one of its triangulations, for these lengths of halfedges
  template <typename Length>
  std::vector<double> areas(const Delta_complex& complex, const Length& length) const
  {
    std::vector<double> result(m_components.size(), 0);
    for(Face_index f : complex.faces()) {
      const auto h = Intrinsic_triangulations::sides(f, complex);
      result[m_components[complex.target(h[0]).idx()]] +=
        std::sqrt(Intrinsic_triangulations::squared_quadrupled_area(length(h[0]), length(h[1]),
                                                                    length(h[2]))) /
        4;
    }
    return result;
  }

  // Of each component, how much the prescribed curvatures exceed 2 pi times the Euler
  // characteristic; this much less must be the curvature of the vertices with prescribed scale
  // factors (Equation 4.11). Zero for an isolated vertex.
  std::vector<double> curvature_excess() const
  {
    const Delta_complex& mesh = m_double.mesh();
    std::vector<double> sum(m_components.size(), 0);
    std::vector<long> characteristic(m_components.size(), 0);
    for(Vertex_index v : mesh.vertices()) {
      if(mesh.is_isolated(v))
        continue;
      sum[m_components[v.idx()]] += m_is_fixed[v.idx()] ? 0 : m_value[Eigen::Index(v.idx())];
      characteristic[m_components[v.idx()]] += !mesh.is_isolated(v); // a point has no curvature
    }
    for(Edge_index e : mesh.edges())
      --characteristic[m_components[mesh.vertex(e, 0).idx()]];
    for(Face_index f : mesh.faces())
      ++characteristic[m_components[mesh.target(mesh.halfedge(f)).idx()]];
    for(std::size_t c = 0; c < sum.size(); ++c)
      sum[c] -= 2 * pi() * double(characteristic[c]);
    return sum;
  }

  // How many vertices with prescribed scale factors a component needs at least, for this excess:
  // each can have a curvature of less than a full turn.
  static std::size_t needed_cones(double excess)
  {
    if(std::abs(excess) <= tolerance::curvature_sum)
      return 0;
    return excess > 0 ? 1
                      : static_cast<std::size_t>(
                          std::floor(-excess / (2 * pi()) + tolerance::curvature_sum)) +
                          1;
  }

  // how many vertices with prescribed scale factors each component has
  std::vector<std::size_t> number_of_fixed() const
  {
    std::vector<std::size_t> result(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      result[m_components[v]] += m_is_fixed[v] != 0;
    return result;
  }

  // \throws Invalid_input if no flat metric has what is prescribed
  void check() const
  {
    check_angles();
    const std::vector<double> excess = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < excess.size(); ++c)
      if(fixed[c] < needed_cones(excess[c]))
        throw Intrinsic_triangulations::Invalid_input(unbalanced(c, excess[c], fixed[c] > 0));
  }

  // \throws Invalid_input if no hyperbolic metric has what is prescribed: the area, by Gauss and
  // Bonnet, must be positive
  void check_hyperbolic() const
  {
    check_angles();
    const std::vector<double> area = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < area.size(); ++c)
      if(fixed[c] == 0 && !(area[c] > tolerance::curvature_sum))
        throw Intrinsic_triangulations::Invalid_input(
          "component " + std::to_string(c) +
          " cannot be hyperbolic with the prescribed curvatures: " + "it would have an area of " +
          std::to_string(area[c]) + " (Gauss-Bonnet)");
  }

private:
  void check_angles() const
  {
    for(std::size_t v = 0; v < size(); ++v)
      if(!m_is_fixed[v] && !(m_value[Eigen::Index(v)] < 2 * pi()))
        throw Intrinsic_triangulations::Invalid_input(
          "no angle is left at vertex " + std::to_string(v) + ": its curvature is too great");
  }

  static std::vector<char> faces_to_copy(const Delta_complex& half)
  {
    const Components components(half);
    std::vector<char> has_boundary(components.size(), 0), result(half.num_faces());
    for(Halfedge_index h : half.halfedges())
      if(half.is_border(h))
        has_boundary[components[half.target(h).idx()]] = 1;
    for(Face_index f : half.faces())
      result[f.idx()] = has_boundary[components[half.target(half.halfedge(f)).idx()]];
    return result;
  }

  bool has_boundary(std::size_t component) const
  {
    for(Vertex_index v : m_half.vertices())
      if(m_components[v.idx()] == component && is_on_boundary(v))
        return true;
    return false;
  }

  // what is wrong with the curvatures of a component
  std::string unbalanced(std::size_t component, double excess, bool has_fixed) const
  {
    const double own = has_boundary(component) ? excess / 2 : excess; // not of the double
    std::ostringstream text;
    text << "the curvatures prescribed on component " << component << " sum up to " << std::abs(own)
         << " radians " << (own > 0 ? "more" : "less")
         << " than 2 pi times its Euler characteristic (Gauss-Bonnet)"
         << (has_fixed ? ": more than vertices with prescribed scale factors can have" : "");
    return text.str();
  }

  static double pi() { return boost::math::constants::pi<double>(); }

  Flipping m_flipping;
  Intrinsic_triangulations::internal::Concurrency m_concurrency;
  Delta_complex m_half;
  std::vector<double> m_length; // of the doubled surface
  Doubled_surface m_double;
  Triangulation m_triangulation;
  std::size_t m_number_of_flips = 0;
  Components m_components;
  std::vector<Vertex_index> m_front;
  std::vector<char> m_is_fixed;
  Vector m_value; // a scale factor or an angle defect
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H
