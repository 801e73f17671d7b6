// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_PART_MEANS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_PART_MEANS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/conjugate_gradients.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Calls `visit(v, weight)` for the vertices whose values determine the integral over a segment.
template <typename Surface, typename FT, typename Visit>
void for_each_weight(const Surface& surface, const Curve_segment<FT>& segment, const Visit& visit)
{
  const auto h = sides(segment.face, surface.mesh());
  const FT half = segment_length(surface, segment) / 2;
  for(std::size_t k = 0; k < 3; ++k)
    visit(surface.mesh().source(h[k]).idx(), half * (segment.source[k] + segment.target[k]));
}

// Returns a number of the part of each segment of a curve. Two segments are in one part if their
// faces have a common vertex.
template <typename FT>
std::vector<std::size_t> parts_of(const Delta_complex& mesh, const Surface_curve<FT>& curve)
{
  boost::disjoint_sets_with_storage<> sets(mesh.num_vertices());
  for(const Curve_segment<FT>& segment : curve)
    for(Halfedge_index h : sides(segment.face, mesh))
      sets.union_set(mesh.source(h).idx(), mesh.target(h).idx());
  std::map<std::size_t, std::size_t> number; // of each representative
  std::vector<std::size_t> result;
  for(const Curve_segment<FT>& segment : curve) {
    const std::size_t v = sets.find_set(mesh.source(mesh.halfedge(segment.face)).idx());
    result.push_back(number.try_emplace(v, number.size()).first->second);
  }
  return result;
}

// Makes the means of a function over all parts of a curve on a component equal. Of all changes that
// do so, it makes the one whose gradient has the least norm.
//
// The change solves a Poisson equation with forces on the parts, whose sum on each component is
// zero. Conjugate gradients find the forces. So neither time nor memory is quadratic in the number
// of parts.
template <typename FT>
class Part_means
{
public:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef Eigen::SparseMatrix<FT> Matrix;

  template <typename Surface>
  Part_means(const Surface& surface, const Mesh_components& components,
             const Poisson_solver<FT>& poisson, const Surface_curve<FT>& curve)
    : m_components(components), m_poisson(poisson)
  {
    const Matrix integrals = integrals_over_parts(surface, curve);
    std::vector<Eigen::Triplet<FT>> inverses;
    for(int p = 0; p < integrals.cols(); ++p)
      if(const FT length = integrals.col(p).sum(); length > 0) {
        inverses.emplace_back(p, static_cast<int>(m_component.size()), 1 / length);
        m_component.push_back(
          components[index(typename Matrix::InnerIterator(integrals, p).row())]);
      }
    m_means = integrals * matrix_of(inverses, index(integrals.cols()), m_component.size());
  }

  // \throws Numerical_error if the means do not become equal
  void equalize(Vector& function) const
  {
    const Vector unit = greatest_values(function);
    const Vector differences = without_means(m_means.transpose() * function).cwiseQuotient(unit);
    const FT norm = Digits<FT>::few(differences.norm());
    if(norm <= mean_tolerance())
      return;
    const auto forces =
      solve_by_conjugate_gradients(*this, differences, FT(mean_tolerance() / norm),
                                   greatest_number_of_mean_iterations(m_component.size()));
    if(!(forces.error * norm <= greatest_mean_difference()))
      throw Numerical_error("the means over the " + std::to_string(m_component.size()) +
                            " parts of the curve do not become equal: " + to_string(forces.status));
    function -= response(forces.solution.cwiseProduct(unit));
  }

  // Returns the differences of the means from their mean on each component if these forces act on
  // the parts.
  Vector product(const Vector& forces) const
  {
    return without_means(m_means.transpose() * response(forces));
  }

  // Removes what rounding adds to the sum of forces.
  Vector preconditioned(const Vector& differences) const { return without_means(differences); }

private:
  static std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

  template <typename Surface>
  static Matrix integrals_over_parts(const Surface& surface, const Surface_curve<FT>& curve)
  {
    const std::vector<std::size_t> part = parts_of(surface.mesh(), curve);
    std::vector<Eigen::Triplet<FT>> weights;
    for(std::size_t i = 0; i < curve.size(); ++i)
      for_each_weight(surface, curve[i], [&](std::size_t v, const FT& weight) {
        weights.emplace_back(static_cast<int>(v), static_cast<int>(part[i]), weight);
      });
    const std::size_t size = curve.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
    return matrix_of(weights, surface.mesh().num_vertices(), size);
  }

  Vector response(const Vector& forces) const { return m_poisson.solve(Vector(m_means * forces)); }

  // Returns the greatest absolute value of a function on the component of each part, or one where
  // it is zero.
  Vector greatest_values(const Vector& function) const
  {
    using std::abs;
    std::vector<FT> greatest(m_components.size(), FT(0));
    for(Eigen::Index v = 0; v < function.size(); ++v) {
      FT& value = greatest[m_components[index(v)]];
      value = (std::max)(value, FT(abs(function[v])));
    }
    return on_parts(
      [&](std::size_t c) { return greatest[c] > 0 ? Digits<FT>::few(greatest[c]) : FT(1); });
  }

  // Subtracts the mean of the values at the parts of each component.
  Vector without_means(const Vector& values) const
  {
    std::vector<FT> sum(m_components.size(), FT(0));
    std::vector<std::size_t> number(m_components.size(), 0);
    for(std::size_t p = 0; p < m_component.size(); ++p) {
      sum[m_component[p]] += values[static_cast<Eigen::Index>(p)];
      ++number[m_component[p]];
    }
    return values - on_parts([&](std::size_t c) {
             return Digits<FT>::few(FT(sum[c] / static_cast<double>(number[c])));
           });
  }

  template <typename Function>
  Vector on_parts(const Function& of_component) const
  {
    Vector result(static_cast<Eigen::Index>(m_component.size()));
    for(std::size_t p = 0; p < m_component.size(); ++p)
      result[static_cast<Eigen::Index>(p)] = of_component(m_component[p]);
    return result;
  }

  const Mesh_components& m_components;
  const Poisson_solver<FT>& m_poisson;
  std::vector<std::size_t> m_component; // of each part
  Matrix m_means;                       // a column for each part
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_PART_MEANS_H
