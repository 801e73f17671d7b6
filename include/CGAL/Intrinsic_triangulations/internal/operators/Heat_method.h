// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the greatest time step factor that is accepted. Heat that flows longer is constant up to
// about one part in the factor, so rounding errors decide about its gradient. Searches for a factor
// multiply it by 16 as long as it is at most `greatest_time_step_factor()`.
constexpr double limit_of_time_step_factors() { return 16 * greatest_time_step_factor(); }

// Returns the time step factor, which is `standard` by default.
template <typename FT, typename NamedParameters>
FT checked_time_step_factor(const NamedParameters& np, double standard = 1)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef Intrinsic_triangulations::internal_np::time_step_factor_t Tag;
  const FT factor(choose_parameter(get_parameter(np, Tag()), FT(standard)));
  if(!(factor > 0) || !(factor <= FT(limit_of_time_step_factors())))
    throw Invalid_input("the time step factor is not positive and at most 1.6e13");
  return factor;
}

// Returns the time for which heat flows on each component.
template <typename Surface, typename FT>
std::vector<FT> time_steps(const Surface& surface, const FT& factor,
                           const Mesh_components& components)
{
  const Delta_complex& mesh = surface.mesh();
  const auto& length = surface.length_map();
  std::vector<FT> result(components.size(), FT(0)), count(components.size(), FT(0));
  for(Edge_index e : mesh.edges()) {
    const std::size_t c = components[mesh.vertex(e, 0).idx()];
    result[c] += get(length, e);
    count[c] += 1;
  }
  for(std::size_t c = 0; c < result.size(); ++c)
    result[c] = Digits<FT>::few(factor * CGAL::square(result[c] / count[c]));
  return result;
}

// Returns A / t, where a third of the area around a vertex is its capacity for heat.
template <typename Surface, typename FT>
Eigen::Matrix<FT, Eigen::Dynamic, 1> decay_rates(const Surface& surface, const FT& factor,
                                                 const Mesh_components& components)
{
  const auto time = time_steps(surface, factor, components);
  Eigen::Matrix<FT, Eigen::Dynamic, 1> result = lumped_mass_matrix(surface).diagonal();
  for(Eigen::Index v = 0; v < result.size(); ++v)
    if(const FT t = time[components[static_cast<std::size_t>(v)]]; t > 0)
      result[v] /= t;
    else
      result[v] = FT(1); // an isolated vertex has no other entry in its row
  return result;
}

template <typename Scalar, typename Vector>
Eigen::SparseMatrix<Scalar> plus_diagonal(const Eigen::SparseMatrix<Scalar>& matrix,
                                          const Vector& diagonal)
{
  Eigen::SparseMatrix<Scalar> result(matrix.rows(), matrix.cols());
  result = diagonal.template cast<Scalar>().asDiagonal();
  return result + matrix;
}

// Computes one backward Euler step of the heat flow: (A / t + L) u = sources. The equation is free
// of units of length.
template <typename FT>
class Heat_flow
{
public:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic> Columns;

  template <typename Surface, typename NamedParameters>
  Heat_flow(const Surface& surface, const NamedParameters& np)
    : m_components(surface.mesh()),
      m_rate(decay_rates(surface, checked_time_step_factor<FT>(np), m_components)),
      m_factorization(plus_diagonal(cotan_laplacian(surface), m_rate), "heat flow")
  {}

  // Returns A / t.
  const Vector& rates() const { return m_rate; }
  // Returns the elimination order of the vertices, which other matrices of the surface can use,
  // too.
  const Elimination_order& order() const { return m_factorization.order(); }

  // Returns the heat at the sources. Heat falls exponentially with distance, and must not fall
  // below the range of its number type.
  static FT unit()
  {
    typedef std::numeric_limits<FT> Limits;
    return (Limits::max)() * Limits::epsilon() * Limits::epsilon();
  }

  std::vector<std::size_t> number_of_sources(const Vector& sources) const
  {
    std::vector<std::size_t> result(m_components.size(), 0);
    for(Eigen::Index v = 0; v < sources.size(); ++v)
      if(sources[v] != 0)
        ++result[m_components[static_cast<std::size_t>(v)]];
    return result;
  }

  // Returns the heat from `sources`, times unit().
  Vector spread(const Vector& sources) const { return m_factorization.solve(unit() * sources); }

  // Returns the heat from `sources`, times unit(), which reaches all vertices of components with a
  // source.
  Vector spread_everywhere(const Vector& sources) const
  {
    Vector heat = spread(sources);
    check_everywhere(heat, sources);
    return heat;
  }

  // Returns the heat from the sources of each column, times unit(), on components with a source.
  Columns spread_columns_everywhere(const Columns& sources) const
  {
    Columns heat = m_factorization.solve_columns(unit() * sources);
    for(Eigen::Index k = 0; k < heat.cols(); ++k)
      check_everywhere(heat.col(k), sources.col(k));
    return heat;
  }

private:
  void check_everywhere(const Vector& heat, const Vector& sources) const
  {
    const auto count = number_of_sources(sources);
    for(Eigen::Index v = 0; v < heat.size(); ++v)
      if(count[m_components[static_cast<std::size_t>(v)]] > 0 &&
         !(CGAL::abs(heat[v]) > (std::numeric_limits<FT>::min)()))
        throw Underflow_error("no heat reaches vertex " + std::to_string(v) +
                              "; a greater time step factor is needed");
  }

  Mesh_components m_components;
  Vector m_rate;
  Factorization<FT> m_factorization;
};

// Implements the steps of the heat method before, between and after its two systems of equations.
template <typename FT>
class Heat_method
{
  typedef Source_part<FT> Part;

public:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  // Stores the values that the sources determine directly.
  struct Source_values
  {
    Vector moments;           // of the heat
    Vector distance;          // infinite where it is not known
    bool are_several = false; // on some component

    bool is_known(Eigen::Index v) const { return distance[v] < infinity(); }

    // Returns the map of vertices with prescribed distances. With one source on each component,
    // constants are subtracted.
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
      m_number_of_vertices(static_cast<Eigen::Index>(surface.mesh().num_vertices()))
  {
    for(FT& length : m_mean_length)
      length = CGAL::sqrt(length);
    for(Face_index f : surface.mesh().faces())
      if(const Face_metric<FT> metric(f, surface); has_gradients(metric, f))
        m_faces.emplace_back(metric, surface.mesh().halfedge(f), surface.mesh(),
                             share_of_operators(surface));
  }

  template <typename VertexRange>
  Source_values values_of(const VertexRange& sources) const
  {
    std::vector<Part> parts;
    for(Vertex_index v : sources)
      parts.push_back(Part::at_vertex(v));
    return values_of_parts(parts);
  }

  Source_values values_of(Vertex_index source) const { return values_of(std::array{source}); }

  template <typename Surface>
  Source_values values_of(const Distance_sources<Surface>& sources) const
  {
    return values_of_parts(sources.m_parts);
  }

  Eigen::Index number_of_vertices() const { return m_number_of_vertices; }

  // Returns the integrated divergence of the unit vectors opposite to the gradient of the heat.
  Vector moments(const Vector& heat) const
  {
    Vector result = Vector::Zero(m_number_of_vertices);
    for(const Face& face : m_faces) {
      const std::array<FT, 2> moment = face.moments(face.unit_gradient(heat));
      result[face.corner[0]] -= moment[0];
      result[face.corner[1]] -= moment[1];
      result[face.corner[2]] += moment[0] + moment[1];
    }
    return result;
  }

  // Subtracts the error at the sources. If a component has several sources, their values are known
  // already.
  Vector without_error_at_sources(Vector distance, const Source_values& sources) const
  {
    std::vector<FT> error(m_components.size(), FT(0)), weight = error;
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(sources.is_known(v)) {
        error[component(v)] += sources.moments[v] * (distance[v] - sources.distance[v]);
        weight[component(v)] += sources.moments[v];
      }
    // If a component has no source, all its distances become infinite.
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(const std::size_t c = component(v); !(weight[c] > 0))
        distance[v] = infinity();
      else if(sources.is_known(v))
        distance[v] = sources.distance[v];
      else
        distance[v] -= Digits<FT>::few(error[c] / weight[c]);
    return distance;
  }

  // Returns a solver for a surface whose elimination order is known.
  template <typename Surface, typename VertexIsFixedMap>
  static Poisson_solver<FT> poisson_solver(const Surface& surface, const Elimination_order& order,
                                           const VertexIsFixedMap& is_fixed)
  {
    return Poisson_solver<FT>(surface, order, is_fixed);
  }

private:
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  std::size_t component(Eigen::Index v) const { return m_components[static_cast<std::size_t>(v)]; }

  // A curve gets as much heat as one vertex for each mean edge length.
  Source_values values_of_parts(const std::vector<Part>& parts) const
  {
    const Eigen::Index n = m_number_of_vertices;
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

  // Represents a face with an area. `side[k]` is the gradient of the hat function of `corner[k]`,
  // times the doubled area, over the longest side. The three gradients add up to zero. `weight` is
  // half the longest side, times the factor of the operators.
  struct Face
  {
    std::array<Vertex_index::size_type, 3> corner;
    std::array<std::array<FT, 2>, 2> side;
    FT weight;

    Face(const Face_metric<FT>& metric, Halfedge_index h, const Delta_complex& mesh,
         const FT& share)
      : corner{mesh.target(mesh.next(h)).idx(), mesh.source(h).idx(), mesh.target(h).idx()},
        weight((std::max)({metric.length(0), metric.length(1), metric.length(2)}))
    {
      for(std::size_t k = 0; k < 2; ++k)
        side[k] = {metric.turned_side(k)[0] / weight, metric.turned_side(k)[1] / weight};
      weight *= share / 2;
    }

    // Returns the direction of the gradient of the heat, or zero if the corners have equal heat up
    // to rounding. Sources can be equally far from all corners of a face. Numbers are scaled,
    // because heat and its squares use the whole range of `FT`. Precondition: heat is zero or
    // normal.
    std::array<FT, 2> unit_gradient(const Vector& heat) const
    {
      const FT a = heat[corner[0]], b = heat[corner[1]], c = heat[corner[2]];
      const FT unit = (std::max)({CGAL::abs(a), CGAL::abs(b), CGAL::abs(c)});
      if(!(unit > 0))
        return {FT(0), FT(0)};
      const FT inverse = FT(1) / unit, u = (a - c) * inverse, v = (b - c) * inverse;
      if((std::max)(CGAL::abs(u), CGAL::abs(v)) <= rounding_unit<FT>())
        return {FT(0), FT(0)};
      const FT x = u * side[0][0] + v * side[1][0], y = u * side[0][1] + v * side[1][1];
      const FT squared = x * x + y * y;
      if(!(squared > 0))
        return {FT(0), FT(0)};
      const FT scale = FT(1) / CGAL::sqrt(squared);
      return {scale * x, scale * y};
    }

    // Returns the integrals of a vector against the gradients of the first two hat functions.
    std::array<FT, 2> moments(const std::array<FT, 2>& vector) const
    {
      const FT x = weight * vector[0], y = weight * vector[1];
      return {side[0][0] * x + side[0][1] * y, side[1][0] * x + side[1][1] * y};
    }
  };

  Mesh_components m_components;
  std::vector<FT> m_mean_length; // of the edges of each component
  Eigen::Index m_number_of_vertices;
  std::vector<Face> m_faces;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_METHOD_H
