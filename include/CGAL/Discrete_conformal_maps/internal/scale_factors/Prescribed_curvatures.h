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
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <CGAL/number_type_config.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the prescribed curvature or scale factor of each vertex of a surface. Stores the topology
// of its components, which determines the sums of curvatures. A component with boundary is doubled
// (Section 4.3.4): its vertices on the boundary have twice the prescribed exterior angle.
class Prescribed_curvatures
{
public:
  typedef Intrinsic_triangulations::Mesh_components Components;
  typedef Intrinsic_triangulations::Topological_type Topological_type;
  typedef Eigen::VectorXd Vector;

  // `condition` has one entry for each vertex of `surface`.
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

  // Returns the number of vertices of the surface.
  std::size_t size() const { return m_is_fixed.size(); }

  // Returns the components of the surface.
  const Components& components() const { return m_components; }

  // Returns the topology of each component; an isolated vertex has no component.
  const std::vector<Topological_type>& topology() const { return m_topology; }

  // Returns whether a component is doubled.
  bool has_boundary(std::size_t component) const
  {
    return m_topology[component].boundary_loops > 0;
  }

  bool is_isolated(Vertex_index v) const
  {
    return m_topology[m_components[v.idx()]].components == 0;
  }

  // Returns whether a vertex is on the boundary, and false for a vertex of the second copy.
  bool is_on_boundary(Vertex_index v) const
  {
    return v.idx() < size() && m_is_on_boundary[v.idx()];
  }

  // Returns whether a vertex of the surface is not on the boundary, and false for a vertex of the
  // second copy.
  bool is_inside(Vertex_index v) const { return v.idx() < size() && !m_is_on_boundary[v.idx()]; }

  // Returns how many vertices of the double represent a vertex of the surface.
  double number_of_copies(std::size_t v) const
  {
    return has_boundary(m_components[v]) ? 2 * part(v) : 1;
  }

  // Returns the share of a vertex. On the boundary, a vertex of the surface is half a vertex of the
  // double.
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

  // Returns the vertices with prescribed scale factors.
  const std::vector<char>& is_fixed() const { return m_is_fixed; }
  // Returns the prescribed scale factor, or zero if none is prescribed.
  double scale_factor(std::size_t v) const { return m_is_fixed[v] ? m_value[Eigen::Index(v)] : 0; }
  // Returns whether a scale factor other than zero is prescribed.
  bool has_prescribed_scale() const
  {
    for(std::size_t v = 0; v < size(); ++v)
      if(scale_factor(v) != 0)
        return true;
    return false;
  }
  // Returns a gradient by the scale factors with zeros where they are prescribed.
  Vector free_part(Vector gradient) const
  {
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        gradient[Eigen::Index(v)] = 0;
    return gradient;
  }
  // Returns the free variables of an energy of scale factors: all scale factors that are not
  // prescribed. If scaling changes no angles, the variables of a component move together.
  Minimization_domain domain(bool has_similar_ones) const
  {
    Minimization_domain result{m_is_fixed, {}};
    if(has_similar_ones)
      for(std::size_t v = 0; v < size(); ++v)
        result.component.push_back(m_components[v]);
    return result;
  }
  // Returns the prescribed angle defects, and zero elsewhere.
  Vector target_defect() const
  {
    Vector result = m_value;
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        result[Eigen::Index(v)] = 0;
    return result;
  }

  // Returns the angle by which straight boundaries may be bent outwards at each vertex, which is
  // initially zero.
  double bend() const { return m_bend; }

  void straighten_boundaries() { m_bend = 0; }

  // Bends straight boundaries. The sum of all bends is less than the promised error of one angle.
  void bend_straight_boundaries()
  {
    double sides = 1;
    for(std::size_t v = 0; v < size(); ++v)
      sides += part(v) < 1;
    m_bend = (std::min)(tolerance::bend, tolerance::promised_angle / sides);
  }

  // Returns the differences between the tried and the prescribed angle defects. Consider a straight
  // boundary without vertices inside. Every triangle beside the boundary has an interior vertex as
  // corner, even if its boundary side is short and the vertex is far away. Lengths would need
  // digits for the ratio of both. A bend of 1e-13 is a rounding error of angles. It makes triangles
  // with a third corner on the boundary Delaunay if sides are that small. The other exterior angles
  // of the component shrink proportionally.
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

  // Returns the prescribed angle defects with the digits of `FT`. If no scale factor is prescribed,
  // their sums satisfy Gauss and Bonnet. Only the rounding of nonzero defects remains, which is
  // less than a unit.
  template <typename FT>
  std::vector<FT> balanced_target_defect() const
  {
    const Vector rounded = target_defect();
    std::vector<FT> result(rounded.data(), rounded.data() + rounded.size()),
      excess(m_components.size(), FT(0));
    std::vector<double> count(m_components.size(), 0);
    for(std::size_t c = 0; c < excess.size(); ++c)
      excess[c] = -2 * Intrinsic_triangulations::pi<FT>() * double(characteristic(c)) *
                  (has_boundary(c) ? 2 : 1);
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

  // Returns, for each component of the double, the excess of the prescribed curvatures over 2 pi
  // times the Euler characteristic. The curvature of the vertices with prescribed scale factors
  // must be less by this excess (Equation 4.11). It is zero for an isolated vertex.
  std::vector<double> curvature_excess() const
  {
    std::vector<double> sum(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      if(!m_is_fixed[v])
        sum[m_components[v]] += number_of_copies(v) * m_value[Eigen::Index(v)];
    for(std::size_t c = 0; c < sum.size(); ++c)
      sum[c] -= 2 * CGAL_PI * double(characteristic(c)) * (has_boundary(c) ? 2 : 1);
    return sum;
  }

  // Returns whether the prescribed curvatures satisfy Gauss and Bonnet, up to rounding.
  bool is_balanced() const
  {
    const std::vector<double> excess = curvature_excess();
    const std::vector<std::size_t> fixed = number_of_fixed();
    for(std::size_t c = 0; c < excess.size(); ++c)
      if(fixed[c] == 0 && std::abs(excess[c]) > tolerance::curvature)
        return false;
    return true;
  }

  // Returns the least number of vertices with prescribed scale factors that a component needs for
  // this excess. Each can have a curvature of less than 2 pi.
  static std::size_t needed_cones(double excess)
  {
    if(std::abs(excess) <= tolerance::curvature_sum)
      return 0;
    return excess > 0 ? 1
                      : static_cast<std::size_t>(
                          std::floor(-excess / (2 * CGAL_PI) + tolerance::curvature_sum)) +
                          1;
  }

  // Returns how many vertices with prescribed scale factors each component of the double has.
  std::vector<std::size_t> number_of_fixed() const
  {
    std::vector<std::size_t> result(m_components.size(), 0);
    for(std::size_t v = 0; v < size(); ++v)
      if(m_is_fixed[v])
        result[m_components[v]] += std::size_t(number_of_copies(v));
    return result;
  }

  // Checks the conditions.
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

  // Checks the conditions for a hyperbolic metric, whose area, by Gauss and Bonnet, must be
  // positive.
  // \throws Invalid_input if no hyperbolic metric satisfies them
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
  // Returns whether an exterior angle is prescribed that is almost zero, or greater.
  bool is_straight(std::size_t v) const
  {
    return m_is_on_boundary[v] && !m_is_fixed[v] && std::abs(m_value[Eigen::Index(v)]) < 2 * m_bend;
  }
  bool is_convex(std::size_t v) const
  {
    return m_is_on_boundary[v] && !m_is_fixed[v] && m_value[Eigen::Index(v)] >= 2 * m_bend;
  }

  // Sets the topology by Euler's formula, with all boundary loops filled.
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

  // Returns the Euler characteristic of a component, or zero for an isolated vertex.
  long characteristic(std::size_t c) const
  {
    return 2 * (long(m_topology[c].components) - long(m_topology[c].genus)) -
           long(m_topology[c].boundary_loops);
  }

  // Returns the name of a component in a message: its first vertex if other components have faces.
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

  // Returns why a component, whose double would have the area `area`, is not hyperbolic.
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
         << " (Gauss-Bonnet); prescribe greater curvatures";
    return text.str();
  }

  // Returns whether no curvature is prescribed in a component.
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
      if(!m_is_fixed[v] && !(m_value[Eigen::Index(v)] < 2 * CGAL_PI))
        throw Intrinsic_triangulations::Invalid_input(
          "no angle is left at vertex " + std::to_string(v) +
          ": its curvature must be less than 2 pi, on the boundary less than pi");
  }

  // Describes the error in the curvatures of a component.
  std::string unbalanced(std::size_t component, double excess, bool has_fixed) const
  {
    const double own = has_boundary(component) ? excess / 2 : excess; // not of the double
    std::ostringstream text;
    text << "the curvatures prescribed on " << name(component) << " sum up to " << std::abs(own)
         << " radians " << (own > 0 ? "more" : "less")
         << " than 2 pi times its Euler characteristic (Gauss-Bonnet)"
         << ": " << remedy(component, has_fixed);
    return text.str();
  }

  // Returns what can have the curvature that is missing in a component.
  const char* remedy(std::size_t component, bool has_fixed) const
  {
    if(has_fixed)
      return "the cones, and vertices with prescribed scale factors, are too few to have the "
             "difference";
    return has_boundary(component)
             ? "a cone inside or other exterior angles can have the difference"
             : "cones can have the difference";
  }

  Components m_components;
  std::vector<Topological_type> m_topology; // of each component
  std::vector<char> m_is_on_boundary;
  std::vector<char> m_is_fixed;
  Vector m_value; // a scale factor or an angle defect
  double m_bend = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PRESCRIBED_CURVATURES_H
