// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SHARED_ORDER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SHARED_ORDER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Factorization_counts.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the elimination order of the variables of a problem, shared by all objects that factorize
// its matrices. An order takes as long as several factorizations. The matrices differ by some
// flips, and by omitted variables.
class Shared_order
{
public:
  typedef std::vector<Eigen::Index> Order;

  bool is_known() const { return !m_order.empty(); }
  const Order& order() const { return m_order; }

  void set(Order order) { m_order = std::move(order); }

  // An order is outdated if factors have more entries than this multiple of the first number.
  static constexpr double tolerated_growth = 1.2;

  // Sets the number of entries for each row of a factor.
  void set_entries(double entries_of_row) { m_entries = entries_of_row; }
  bool is_good(double entries_of_row) const
  {
    return entries_of_row <= tolerated_growth * m_entries;
  }

  // Returns the variables of `some` in this order.
  Order sorted(const Order& some) const
  {
    std::vector<char> is_wanted(m_order.size(), 0);
    for(Eigen::Index i : some)
      is_wanted[static_cast<std::size_t>(i)] = 1;
    Order result;
    result.reserve(some.size());
    for(Eigen::Index i : m_order)
      if(is_wanted[static_cast<std::size_t>(i)])
        result.push_back(i);
    return result;
  }

  // Returns the order of other variables. Each variable i stands for the variable `origin[i]` of
  // this order, with `multiplicity` times as many neighbors.
  template <typename Index>
  std::shared_ptr<Shared_order> refined(const std::vector<Index>& origin,
                                        int multiplicity = 1) const
  {
    auto result = std::make_shared<Shared_order>();
    result->m_counts = m_counts;
    result->m_entries = multiplicity * m_entries;
    if(!is_known())
      return result;
    std::vector<std::size_t> first(m_order.size() + 1, 0);
    for(Index o : origin)
      ++first[static_cast<std::size_t>(o) + 1];
    std::size_t sum = 0;
    for(Eigen::Index o : m_order)
      sum += std::exchange(first[static_cast<std::size_t>(o) + 1], sum);
    result->m_order.resize(origin.size());
    for(std::size_t i = 0; i < origin.size(); ++i)
      result->m_order[first[static_cast<std::size_t>(origin[i]) + 1]++] =
        static_cast<Eigen::Index>(i);
    return result;
  }

  // Returns the counts of all objects that share the order.
  const std::shared_ptr<Factorization_counts>& counts() const { return m_counts; }

private:
  Order m_order;
  double m_entries = 0;
  std::shared_ptr<Factorization_counts> m_counts = std::make_shared<Factorization_counts>();
};

// Returns the order that an energy shares with other energies, or a new order.
template <typename Energy, typename = void>
struct Order_of_energy
{
  static std::shared_ptr<Shared_order> get(const Energy&)
  {
    return std::make_shared<Shared_order>();
  }
};
template <typename Energy>
struct Order_of_energy<Energy, std::void_t<decltype(std::declval<const Energy&>().shared_order())>>
{
  static std::shared_ptr<Shared_order> get(const Energy& energy) { return energy.shared_order(); }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SHARED_ORDER_H
