// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_FLOW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_FLOW_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename FT, typename NamedParameters>
FT checked_time_step_factor(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef Intrinsic_triangulations::internal_np::time_step_factor_t Tag;
  const FT factor(choose_parameter(get_parameter(np, Tag()), FT(1)));
  if(!(factor > 0) || !CGAL::is_finite(factor))
    throw Invalid_input("the time step factor is not positive and finite");
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

  const Mesh_components& components() const { return m_components; }
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

  // Returns the number of sources on each component.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_HEAT_FLOW_H
