// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ABSTRACT_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ABSTRACT_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Determines whether the gradient of an energy has continuous derivatives, as the energy declares.
// Then a path to its minimum exists on which the gradient shrinks proportionally. Such an energy
// can move its origin.
template <typename Energy, typename = void>
struct Has_smooth_gradient
{
  static constexpr bool is_possible = false;
  static bool get(const Energy&) { return false; }
};
template <typename Energy>
struct Has_smooth_gradient<
  Energy, std::void_t<decltype(std::declval<const Energy&>().has_smooth_gradient())>>
{
  static constexpr bool is_possible = true;
  static bool get(const Energy& energy) { return energy.has_smooth_gradient(); }
};

// Determines whether an energy has done all work that a search may take. Only energies that count
// their work limit it.
template <typename Energy, typename = void>
struct Work_of_energy
{
  static bool is_done(const Energy&) { return false; }
};
template <typename Energy>
struct Work_of_energy<Energy,
                      std::void_t<decltype(std::declval<const Energy&>().has_worked_enough())>>
{
  static bool is_done(const Energy& energy) { return energy.has_worked_enough(); }
};

// Represents a convex energy whose type is known only at run time, so that minimizers are compiled
// once for all energies. It is a model of `ConvexEnergy`.
class Abstract_energy
{
public:
  typedef double FT;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  virtual std::size_t size() const = 0;
  virtual void evaluate(const Vector& x) = 0;
  virtual void move_origin() = 0;
  virtual double value() const = 0;
  virtual const Vector& gradient() const = 0;
  virtual double gradient_error() const = 0;
  virtual const Matrix& Hessian() const = 0;
  virtual bool has_smooth_gradient() const = 0;
  virtual bool has_worked_enough() const = 0;
  virtual std::shared_ptr<Shared_order> shared_order() const = 0;

protected:
  ~Abstract_energy() = default;
};

// Refers to an energy of this type.
template <typename Energy>
class Energy_reference final : public Abstract_energy
{
public:
  explicit Energy_reference(Energy& energy) : m_energy(energy) {}

  std::size_t size() const override { return m_energy.size(); }
  void evaluate(const Vector& x) override { m_energy.evaluate(x); }
  void move_origin() override { m_energy.move_origin(); }
  double value() const override { return static_cast<double>(m_energy.value()); }
  const Vector& gradient() const override { return m_energy.gradient(); }
  double gradient_error() const override { return m_energy.gradient_error(); }
  const Matrix& Hessian() const override { return m_energy.Hessian(); }
  bool has_smooth_gradient() const override { return Has_smooth_gradient<Energy>::get(m_energy); }
  bool has_worked_enough() const override { return Work_of_energy<Energy>::is_done(m_energy); }
  std::shared_ptr<Shared_order> shared_order() const override
  {
    return Order_of_energy<Energy>::get(m_energy);
  }

private:
  Energy& m_energy;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ABSTRACT_ENERGY_H
