// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_flow.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What the heat method does before, between and after its two systems of equations.
template <typename FT>
class Heat_method
{
  typedef Source_part<FT> Part;

public:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  // what the sources determine directly
  struct Source_values
  {
    Vector moments;           // of the heat
    Vector distance;          // infinite where it is not known
    bool are_several = false; // on some component

    bool is_known(Eigen::Index v) const { return distance[v] < infinity(); }

    // Where distances are prescribed. With one source on each component, constants are subtracted.
    auto prescribed() const
    {
      return boost::make_function_property_map<Vertex_index>(
        [this](Vertex_index v) { return are_several && is_known(v.idx()); });
    }
  };

  template <typename Surface>
  explicit Heat_method(const Surface& surface)
    : m_components(surface.mesh()),
      m_mean_length(time_steps(surface, FT(1), m_components)),
      m_gradient(gradient_matrix(surface)),
      m_divergence(divergence_matrix(surface))
  {
    for(FT& length : m_mean_length)
      length = CGAL::sqrt(length);
  }

  // of vertices
  template <typename VertexRange>
  Source_values values_at(const VertexRange& sources) const
  {
    std::vector<Part> parts;
    for(Vertex_index v : sources)
      parts.push_back(Part::at_vertex(v));
    return values_of(parts);
  }

  template <typename Surface>
  Source_values values_of(const Distance_sources<Surface>& sources) const
  {
    return values_of(sources.m_parts);
  }

  // The divergence of the unit vectors against the gradient of the heat, integrated.
  Vector moments(const Vector& heat) const { return -(m_divergence * unit_descent(heat)); }

  // Where there are several sources on a component, the values there are known already.
  Vector without_error_at_sources(Vector distance, const Source_values& sources) const
  {
    std::vector<FT> error(m_components.size(), FT(0)), weight = error;
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(sources.is_known(v)) {
        error[component(v)] += sources.moments[v] * (distance[v] - sources.distance[v]);
        weight[component(v)] += sources.moments[v];
      }
    // without a source, all distances become infinite
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(const std::size_t c = component(v); weight[c] > 0)
        distance[v] -= Digits<FT>::few(error[c] / weight[c]);
      else
        distance[v] = infinity();
    return distance;
  }

  // For a surface whose order of elimination is known already.
  template <typename Surface, typename VertexIsFixedMap>
  static Poisson_solver<FT> poisson_solver(const Surface& surface, const Elimination_order& order,
                                           const VertexIsFixedMap& is_fixed)
  {
    return Poisson_solver<FT>(surface, order, is_fixed);
  }

private:
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  std::size_t component(Eigen::Index v) const { return m_components[static_cast<std::size_t>(v)]; }

  // On a curve, there is as much heat as with a vertex for each mean edge length.
  Source_values values_of(const std::vector<Part>& parts) const
  {
    const Eigen::Index n = m_divergence.rows();
    Source_values result{Vector::Zero(n), Vector::Constant(n, infinity())};
    std::vector<char> has_source(m_components.size(), 0);
    for(const Part& part : parts) {
      if(part.is_vertex() && result.distance[part.vertex().idx()] == 0)
        continue;
      const std::size_t c = component(part.vertex().idx());
      const FT unit = part.length > 0 ? m_mean_length[c] : FT(1);
      for(const auto& [v, moment, distance] : part.corners) {
        result.moments[v.idx()] += moment / unit;
        result.distance[v.idx()] = (std::min)(result.distance[v.idx()], distance);
      }
      result.are_several = result.are_several || has_source[c] || part.length > 0;
      has_source[c] = 1;
    }
    return result;
  }

  // against the gradient of the heat, of length one; zero where the gradient is
  Vector unit_descent(const Vector& heat) const
  {
    using std::hypot;
    Vector field = -(m_gradient * heat);
    for(Eigen::Index i = 0; i < field.size(); i += 2)
      if(const FT norm = hypot(field[i], field[i + 1]); norm > 0)
        field.template segment<2>(i) /= norm;
    return field;
  }

  Mesh_components m_components;
  std::vector<FT> m_mean_length; // of the edges of each component
  Eigen::SparseMatrix<FT> m_gradient, m_divergence;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H
