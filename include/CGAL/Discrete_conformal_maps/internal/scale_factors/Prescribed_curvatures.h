// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PRESCRIBED_CURVATURES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PRESCRIBED_CURVATURES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The prescribed curvature or scale factor of each vertex of a surface, and the topology of its
// components, which curvatures have to suit. A component with boundary is doubled (Section 4.3.4):
// its vertices on the boundary have twice the prescribed exterior angle.
class Prescribed_curvatures
{
public:
  typedef Intrinsic_triangulations::Mesh_components Components;
  typedef Intrinsic_triangulations::Topological_type Topological_type;
  typedef Eigen::VectorXd Vector;

  // `condition` has one entry for each vertex of `surface`
  Prescribed_curvatures(const Delta_complex& surface,
                        const std::vector<Vertex_condition>& condition)
    : m_components(surface),
      m_topology(m_components.size()),
      m_is_on_boundary(surface.num_vertices(), 0),
      m_is_fixed(surface.num_vertices(), 0),
      m_value(Vector::Zero(Eigen::Index(surface.num_vertices())))
  {
    set_topology(surface);
    for(Vertex_index v : surface.vertices()) {
      m_is_on_boundary[v.idx()] = surface.is_border(v) && !surface.is_isolated(v);
      set_condition(v, condition[v.idx()]);
    }
  }

  // the number of vertices of the surface
  std::size_t size() const { return m_is_fixed.size(); }

  // the components of the surface
  const Components& components() const { return m_components; }

  // the topology of each of them; an isolated vertex has no component
  const std::vector<Topological_type>& topology() const { return m_topology; }

  // whether a component is doubled
  bool has_boundary(std::size_t component) const
  {
    return m_topology[component].boundary_loops > 0;
  }

  bool is_isolated(Vertex_index v) const
  {
    return m_topology[m_components[v.idx()]].components == 0;
  }

  // false for a vertex of the second copy
  bool is_on_boundary(Vertex_index v) const
  {
    return v.idx() < size() && m_is_on_boundary[v.idx()];
  }

  // how many vertices of the double a vertex of the surface is
  double number_of_copies(std::size_t v) const
  {
    return has_boundary(m_components[v]) ? 2 * part(v) : 1;
  }

  // On the boundary, a vertex of the double is half one of the surface.
  double part(std::size_t v) const
  {
    return is_on_boundary(Vertex_index(Delta_complex::size_type(v))) ? 0.5 : 1;
  }

  void set_condition(Vertex_index v, const Vertex_condition& condition)
  {
    const bool is_scale = condition.quantity == Vertex_condition::Quantity::log_scale;
    const double value = !is_scale && is_on_boundary(v) ? 2 * condition.value : condition.value;
    if(!std::isfinite(value))
      throw Intrinsic_triangulations::Invalid_input("the prescribed value at vertex " +
                                                    std::to_string(v.idx()) + " is NaN");
    m_is_fixed[v.idx()] = is_scale || is_isolated(v);
    m_value[Eigen::Index(v.idx())] = !is_scale && is_isolated(v) ? 0 : value;
  }

  // the vertices where scale factors are prescribed
  const std::vector<char>& is_fixed() const { return m_is_fixed; }
  // the scale factor where it is prescribed
  double scale_factor(std::size_t v) const { return m_is_fixed[v] ? m_value[Eigen::Index(v)] : 0; }
  // The free variables of an energy of scale factors: all that are not prescribed. If scaling
  // changes no angles, the variables of a component move together.
  Minimization_domain domain(bool has_similar_ones) const
  {
    Minimization_domain result{m_is_fixed, {}};
    if(has_similar_ones)
      for(std::size_t v = 0; v < size(); ++v)
        result.component.push_back(m_components[v]);
    return result;
  }
  // the angle defects that are prescribed; zero elsewhere
  Vector target_defect() const
  {
    Vector result = m_value;
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        result[Eigen::Index(v)] = 0;
    return result;
  }

  // Straight boundaries may be bent outwards by this angle at each vertex: zero at first.
  double bend() const { return m_bend; }

  void straighten_boundaries() { m_bend = 0; }

  // Bends them by so little that the sum of all bends is less than is promised of one angle.
  void bend_straight_boundaries()
  {
    double sides = 1;
    for(std::size_t v = 0; v < size(); ++v)
      sides += part(v) < 1;
    m_bend = (std::min)(tolerance::bend, tolerance::promised_angle / sides);
  }

  // Returns by how much the tried angle defects differ from the prescribed ones. Consider a
  // straight boundary without vertices inside. Every triangle beside it reaches to a vertex
  // inside, however small its side on the boundary is and however far that vertex. So lengths of
  // as many digits would be needed. A bend of 1e-13 is a rounding error of angles. It makes
  // triangles with a third corner on the boundary Delaunay if sides are so small. The other
  // exterior angles of the component shrink in proportion.
  Vector bends() const
  {
    Vector result = Vector::Zero(m_value.size());
    if(m_bend == 0)
      return result;
    std::vector<double> bent(m_components.size(), 0), convex(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      if(is_straight(v))
        bent[m_components[v]] += 2 * m_bend - m_value[Eigen::Index(v)];
      else if(is_convex(v))
        convex[m_components[v]] += m_value[Eigen::Index(v)];
    for(std::size_t v = 0; v < size(); ++v)
      if(const std::size_t c = m_components[v]; convex[c] > 0) {
        const double value = m_value[Eigen::Index(v)];
        if(is_straight(v))
          result[Eigen::Index(v)] = 2 * m_bend - value;
        else if(is_convex(v))
          result[Eigen::Index(v)] = -value * bent[c] / convex[c];
      }
    return result;
  }

  // Returns the prescribed angle defects with the digits of `FT`. If no scale factor is
  // prescribed, their sums obey Gauss and Bonnet. Rounding of defects other than zero leaves a
  // part of a unit.
  template <typename FT>
  std::vector<FT> balanced_target_defect() const
  {
    const Vector rounded = target_defect();
    std::vector<FT> result(rounded.data(), rounded.data() + rounded.size()),
      excess(m_components.size(), FT(0));
    std::vector<double> count(m_components.size(), 0);
    for(std::size_t c = 0; c < excess.size(); ++c)
      excess[c] = -2 * straight_angle<FT>() * double(characteristic(c)) * (has_boundary(c) ? 2 : 1);
    for(std::size_t v = 0; v < size(); ++v)
      if(result[v] != 0) {
        excess[m_components[v]] += number_of_copies(v) * result[v];
        count[m_components[v]] += number_of_copies(v);
      }
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t v = 0; v < size(); ++v)
      if(const std::size_t c = m_components[v]; fixed[c] == 0 && result[v] != 0)
        result[v] -= excess[c] / count[c];
    return result;
  }

  // For each component of the double, the excess of the prescribed curvatures over 2 pi times the
  // Euler characteristic. The curvature of the vertices with prescribed scale factors must be less
  // by this excess (Equation 4.11). It is zero for an isolated vertex.
  std::vector<double> curvature_excess() const
  {
    std::vector<double> sum(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      if(!m_is_fixed[v])
        sum[m_components[v]] += number_of_copies(v) * m_value[Eigen::Index(v)];
    for(std::size_t c = 0; c < sum.size(); ++c)
      sum[c] -= 2 * pi() * double(characteristic(c)) * (has_boundary(c) ? 2 : 1);
    return sum;
  }

  // whether the prescribed curvatures obey Gauss and Bonnet, up to rounding
  bool is_balanced() const
  {
    const std::vector<double> excess = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < excess.size(); ++c)
      if(fixed[c] == 0 && std::abs(excess[c]) > tolerance::curvature)
        return false;
    return true;
  }

  // The least number of vertices with prescribed scale factors that a component needs for this
  // excess. Each can have a curvature of less than a full turn.
  static std::size_t needed_cones(double excess)
  {
    if(std::abs(excess) <= tolerance::curvature_sum)
      return 0;
    return excess > 0 ? 1
                      : static_cast<std::size_t>(
                          std::floor(-excess / (2 * pi()) + tolerance::curvature_sum)) +
                          1;
  }

  // how many vertices with prescribed scale factors each component of the double has
  std::vector<std::size_t> number_of_fixed() const
  {
    std::vector<std::size_t> result(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        result[m_components[v]] += std::size_t(number_of_copies(v));
    return result;
  }

  // \throws Invalid_input if no flat metric satisfies the conditions
  void check() const
  {
    check_angles();
    const std::vector<double> excess = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < excess.size(); ++c)
      if(fixed[c] < needed_cones(excess[c]))
        throw Intrinsic_triangulations::Invalid_input(unbalanced(c, excess[c], fixed[c] > 0));
  }

  // \throws Invalid_input if no hyperbolic metric satisfies the conditions: the area, by Gauss and
  // Bonnet, must be positive
  void check_hyperbolic() const
  {
    check_angles();
    const std::vector<double> area = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < area.size(); ++c)
      if(fixed[c] == 0 && !(area[c] > tolerance::curvature_sum))
        throw Intrinsic_triangulations::Invalid_input(not_hyperbolic(c, area[c]));
  }

private:
  // whether an exterior angle is prescribed that is almost zero, or greater
  bool is_straight(std::size_t v) const
  {
    return m_is_on_boundary[v] && !m_is_fixed[v] && std::abs(m_value[Eigen::Index(v)]) < 2 * m_bend;
  }
  bool is_convex(std::size_t v) const
  {
    return m_is_on_boundary[v] && !m_is_fixed[v] && m_value[Eigen::Index(v)] >= 2 * m_bend;
  }

  // by Euler, with all boundary loops filled
  void set_topology(const Delta_complex& surface)
  {
    std::vector<long> filled(m_components.size(), 0);
    const auto component = [&](Halfedge_index h) { return m_components[surface.target(h).idx()]; };
    for(Vertex_index v : surface.vertices())
      if(!surface.is_isolated(v)) {
        m_topology[m_components[v.idx()]].components = 1;
        ++filled[m_components[v.idx()]];
      }
    for(Edge_index e : surface.edges())
      --filled[component(surface.halfedge(e))];
    for(Face_index f : surface.faces())
      ++filled[component(surface.halfedge(f))];
    for(Halfedge_index h : boundary_loops(surface)) {
      ++m_topology[component(h)].boundary_loops;
      ++filled[component(h)];
    }
    for(std::size_t c = 0; c < filled.size(); ++c)
      if(m_topology[c].components > 0)
        m_topology[c].genus = static_cast<std::size_t>(2 - filled[c]) / 2;
  }

  // the Euler characteristic of a component, zero for an isolated vertex
  long characteristic(std::size_t c) const
  {
    return 2 * (long(m_topology[c].components) - long(m_topology[c].genus)) -
           long(m_topology[c].boundary_loops);
  }

  // how a message names a component: by its first vertex if there are others with faces
  std::string name(std::size_t component) const
  {
    const auto has_faces = [](const Topological_type& type) { return type.components > 0; };
    if(std::count_if(m_topology.begin(), m_topology.end(), has_faces) == 1)
      return "the surface";
    std::size_t v = 0;
    while(m_components[v] != component)
      ++v;
    return "the component of vertex " + std::to_string(v);
  }

  // why a component, whose double would have the area `area`, is not hyperbolic
  std::string not_hyperbolic(std::size_t component, double area) const
  {
    const std::string kind = Intrinsic_triangulations::description(m_topology[component]);
    if(is_flat(component))
      return name(component) + " is " + kind +
             ", which is hyperbolic only with cones: use uniformize";
    std::ostringstream text;
    text << name(component) << " is " << kind
         << " and cannot be hyperbolic with the prescribed curvatures: "
         << "its area would be " << (has_boundary(component) ? area / 2 : area)
         << " (Gauss-Bonnet); greater curvatures make it greater";
    return text.str();
  }

  // whether no curvature is prescribed anywhere in a component
  bool is_flat(std::size_t component) const
  {
    for(std::size_t v = 0; v < size(); ++v)
      if(m_components[v] == component && m_value[Eigen::Index(v)] != 0)
        return false;
    return true;
  }

  void check_angles() const
  {
    for(std::size_t v = 0; v < size(); ++v)
      if(!m_is_fixed[v] && !(m_value[Eigen::Index(v)] < 2 * pi()))
        throw Intrinsic_triangulations::Invalid_input(
          "no angle is left at vertex " + std::to_string(v) +
          ": its curvature is too great; it must be less than 2 pi, on the boundary less than pi");
  }

  // the error in the curvatures of a component
  std::string unbalanced(std::size_t component, double excess, bool has_fixed) const
  {
    const double own = has_boundary(component) ? excess / 2 : excess; // not of the double
    std::ostringstream text;
    text << "the curvatures prescribed on " << name(component) << " sum up to " << std::abs(own)
         << " radians " << (own > 0 ? "more" : "less")
         << " than 2 pi times its Euler characteristic (Gauss-Bonnet)"
         << (has_fixed ? ": more than vertices with prescribed scale factors can have"
                       : ": a cone inside or another boundary can have the difference");
    return text.str();
  }

  static double pi() { return boost::math::constants::pi<double>(); }

  Components m_components;
  std::vector<Topological_type> m_topology; // of each component
  std::vector<char> m_is_on_boundary;
  std::vector<char> m_is_fixed;
  Vector m_value; // a scale factor or an angle defect
  double m_bend = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PRESCRIBED_CURVATURES_H
