// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Search_work.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents half of the energy of a double, as a function of the scale factors on the surface
// itself. Copies have equal scale factors. It is a model of `ConvexEnergy`. All faces at a vertex
// of the surface exist. If the second copy is not deep enough for a point, it is extended. Then all
// energies of the problem begin with the new triangulation at their next evaluation. A surface
// without boundary has its own energy.
template <typename Energy>
class Symmetric_energy
{
  typedef Doubled_problem::Triangulation Triangulation;

public:
  typedef typename Energy::FT FT;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  // `make(triangulation)` returns the energy of a doubled surface. `triangulation` is the
  // triangulation of the problem. It may have been moved into the function, and then has no seams.
  template <typename Make>
  Symmetric_energy(Doubled_problem& problem, const Triangulation& triangulation, const Make& make)
    : m_problem(problem),
      m_make([&problem, make] { return make(problem.triangulation()); }),
      m_origin(problem.size(), FT(0)),
      m_part(Eigen::Index(problem.size()))
  {
    for(std::size_t v = 0; v < size(); ++v)
      m_part[Eigen::Index(v)] = problem.part(v);
    m_energy.emplace(make(triangulation));
    m_version = problem.version();
  }

  std::size_t size() const { return m_problem.size(); }

  // Returns whether the triangulation follows the scale factors, so that the derivatives of angles
  // are continuous.
  bool has_smooth_gradient() const { return m_problem.flipping() == Flipping::to_Delaunay; }

  // Returns the elimination order of the variables.
  std::shared_ptr<Shared_order> shared_order() const { return m_problem.order(); }

  void evaluate(const Vector& x)
  {
    m_has_Hessian = false;
    for(bool has_ended = false; !has_ended; has_ended = !has_extended()) {
      if(m_version != m_problem.version())
        restart();
      evaluate_expanded(x);
    }
    m_gradient = m_energy->gradient().head(x.size()).cwiseProduct(m_part);
  }

  // Returns the gradient at a point by the scale factors that are not prescribed.
  Vector free_gradient_at(const Vector& x)
  {
    evaluate(x);
    return m_problem.free_part(m_gradient);
  }

  void set_origin(const std::vector<FT>& origin)
  {
    m_origin = origin;
    m_energy->set_origin(m_problem.expanded(origin));
  }
  void move_origin() { set_origin(scale_factors()); }

  // Lets the search end once all searches for the map have done this work. The energy adds its
  // flips, and the faces that it measures, to the work of the problem.
  void limit_work(double end) { m_end_of_work = end; }
  bool has_worked_enough() const
  {
    const double sure =
      tolerance::sure_measurements * double(m_energy->surface().mesh().num_faces());
    return m_problem.work().done() >= (std::max)(m_end_of_work, sure);
  }

  // Moves some variables, and returns the sum of the derivatives by them, or NaN if a scaled length
  // is not a length. All other values are unchanged until `evaluate()`.
  double derivative_at(const std::vector<std::size_t>& variables, const std::vector<FT>& u)
  {
    if(m_next_copy.size() != m_problem.originals().size())
      m_next_copy = m_problem.next_copies();
    std::vector<Vertex_index> vertices;
    std::vector<FT> values;
    for(std::size_t i = 0; i < variables.size(); ++i)
      for(auto v = Vertex_index(Delta_complex::size_type(variables[i])); v.is_valid();
          v = m_next_copy[v.idx()]) {
        vertices.push_back(v);
        values.push_back(u[i]);
      }
    try {
      note_work(usual_degree * vertices.size(), [&] { m_energy->move_some(vertices, values); });
    } catch(const Intrinsic_triangulations::Error&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    double result = 0;
    for(std::size_t v : variables)
      result +=
        m_part[Eigen::Index(v)] * m_energy->derivative(Vertex_index(Delta_complex::size_type(v)));
    return result;
  }

  std::vector<FT> scale_factors() const
  {
    const std::vector<FT>& u = m_energy->scale_factors();
    return {u.begin(), u.begin() + std::ptrdiff_t(size())};
  }

  const FT& scale_factor(std::size_t v) const { return m_energy->scale_factors()[v]; }

  // Returns the energy of the existing part of the double.
  const Energy& energy() const { return *m_energy; }

  FT value() const
  {
    return m_energy->weighted_value(
      [&](Vertex_index v) { return v.idx() < size() ? m_part[Eigen::Index(v.idx())] : 0; },
      [&](Face_index f) { return m_problem.part(f); });
  }

  const Vector& gradient() const { return m_gradient; }
  double gradient_error() const { return m_energy->gradient_error(); }

  // Returns the Hessian. It consists of the columns of vertices of the surface, with columns of
  // copies added to the rows, and half of it transposed. Ties between faces across the boundary are
  // not broken symmetrically, where entries vanish.
  const Matrix& Hessian() const
  {
    if(m_problem.has_no_copies())
      return m_energy->Hessian();
    if(!m_has_Hessian) {
      const std::vector<Vertex_index> next = m_problem.next_copies();
      Intrinsic_triangulations::assemble(
        m_problem.concurrency(), size(), size(),
        [&](std::size_t v, auto& entries) {
          this->collect_column(Vertex_index(Delta_complex::size_type(v)), next, entries);
        },
        m_Hessian);
      make_symmetric(m_Hessian);
    }
    m_has_Hessian = true;
    return m_Hessian;
  }

private:
  static constexpr std::size_t usual_degree = 6;

  // Begins with the triangulation that the problem has now.
  void restart()
  {
    m_energy.emplace(m_make());
    m_energy->set_origin(m_problem.expanded(m_origin));
    m_version = m_problem.version();
  }

  void evaluate_expanded(const Vector& x)
  {
    note_work(m_energy->surface().mesh().num_faces(),
              [&] { m_energy->evaluate(m_problem.expanded(x)); });
  }

  // Executes a function that measures so many faces, and notes its work with its flips.
  template <typename Function>
  void note_work(std::size_t measured, const Function& function)
  {
    const std::size_t before = m_energy->surface().flips().size();
    const auto note = [&] {
      m_problem.work().template add<FT>(measured + m_energy->surface().flips().size() - before);
    };
    try {
      function();
    } catch(...) {
      note();
      throw;
    }
    note();
  }

  // Makes the matrix symmetric, because rounding of the sums below depends on the order of their
  // terms.
  static void make_symmetric(Matrix& matrix)
  {
    for(Eigen::Index column = 0; column < matrix.cols(); ++column)
      for(Matrix::InnerIterator i(matrix, column); i && i.row() < column; ++i)
        matrix.coeffRef(column, i.row()) = i.value();
  }

  template <typename Entries>
  void collect_column(Vertex_index v, const std::vector<Vertex_index>& next, Entries& entries) const
  {
    const auto is_copy = [&](Vertex_index w) { return m_problem.original(w) == v; };
    Entries column;
    for(Vertex_index w = v; w.is_valid(); w = next[w.idx()]) {
      column.clear();
      m_energy->collect_column(w, is_copy, column);
      for(const auto& [row, entry] : column) {
        if(w == v)
          entries.emplace_back(int(m_problem.originals()[std::size_t(row)].idx()),
                               m_part[Eigen::Index(v.idx())] * entry / 2);
        if(std::size_t(row) < size())
          entries.emplace_back(row, m_part[row] * entry / 2);
      }
    }
  }

  bool has_extended()
  {
    if(!m_energy->gradient().allFinite() || !m_problem.has_exceeded(m_energy->surface().flips()))
      return false;
    m_problem.extend(m_energy->surface().flips());
    return true;
  }

  Doubled_problem& m_problem;
  std::function<Energy()> m_make;
  std::vector<FT> m_origin;
  std::optional<Energy> m_energy;
  std::size_t m_version; // of the triangulation of the energy
  Vector m_part;         // of each vertex of the double that counts for the surface
  Vector m_gradient;
  double m_end_of_work = tolerance::work_for_map;
  std::vector<Vertex_index> m_next_copy; // see `Doubled_problem::next_copies()`
  mutable Matrix m_Hessian;
  mutable bool m_has_Hessian = false;
};

// `triangulation` is the argument of the constructor.
template <typename FT, typename Triangle>
Symmetric_energy<Conformal_energy<FT, Triangle>>
symmetric_energy(Doubled_problem& problem, const Doubled_problem::Triangulation& triangulation)
{
  const auto make = [&problem](const Doubled_problem::Triangulation& t) {
    const auto energy = [&](const auto& target) {
      Conformal_energy<FT, Triangle> result(t.mesh(), problem.template lengths<FT>(t),
                                            problem.expanded(target), problem.flipping(),
                                            problem.template radii<FT>());
      result.set_concurrency(problem.concurrency());
      return result;
    };
    // More digits than targets have make a difference only for needles on the exact surface.
    if constexpr(Triangle::has_similar_ones && !std::is_same_v<FT, double>)
      if(problem.has_needles())
        return energy(problem.template balanced_target_defect<FT>());
    return energy(Eigen::VectorXd(problem.target_defect() + problem.bends()));
  };
  return {problem, triangulation, make};
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_ENERGY_H
