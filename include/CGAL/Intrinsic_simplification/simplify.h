// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Removal_status.h>
#include <CGAL/Intrinsic_simplification/Transport_cost.h>
#include <CGAL/Intrinsic_simplification/internal/operations/Vertex_heap.h>
#include <CGAL/Intrinsic_simplification/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// a visitor that does nothing. A class derived from it redefines only the functions that it needs.
///
/// \cgalModels `SimplificationVisitor`
struct Default_simplification_visitor
{
  /// is called before a vertex is removed, with its flattened star and its cost.
  void before_removal(const Flattened_star& /* star */, double /* cost */) {}
  /// is called after the vertex `v` has been removed and the triangulation has become Delaunay
  /// again.
  void after_removal(Vertex_index /* v */) {}
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the result of a simplification.
struct Simplification_result
{
  std::size_t removed = 0;  ///< the number of vertices that have been removed
  double greatest_cost = 0; ///< the greatest cost of a removal
  /// the number of vertices that could not be removed at the end, for each reason. Vertices whose
  /// star has changed since the last attempt are not counted.
  std::array<std::size_t, number_of_removal_statuses> skipped{};
};

namespace internal {

// Runs the greedy loop (Algorithm 6).
template <typename Cost, typename Visitor>
class Simplifier
{
public:
  Simplifier(Evolving_surface& surface, Cost& cost, Visitor& visitor)
    : m_surface(surface),
      m_cost(cost),
      m_visitor(visitor),
      m_heap(surface.mesh().num_vertices()),
      m_status(surface.mesh().num_vertices(), Removal_status::possible)
  {}

  Simplification_result operator()(std::size_t number_of_vertices, double maximum_cost)
  {
    m_surface.make_Delaunay();
    for(Vertex_index v : m_surface.mesh().vertices())
      evaluate(v);
    while(m_surface.mesh().number_of_vertices() > number_of_vertices && !m_heap.empty() &&
          m_heap.key(m_heap.top()) <= maximum_cost)
      remove_top();
    for(Vertex_index v : m_surface.mesh().vertices())
      ++m_result.skipped[static_cast<std::size_t>(m_status[v])];
    m_result.skipped[0] = 0;
    return m_result;
  }

private:
  // Computes the cost of removing `v`, and leaves its star in m_star.
  void evaluate(Vertex_index v)
  {
    m_status[v] = m_surface.flatten(v, m_star);
    if(m_status[v] == Removal_status::possible)
      m_heap.set(v, m_cost(m_star));
    else if(m_heap.contains(v))
      m_heap.remove(v);
  }

  // Removes the top vertex. A cost in the heap may be outdated if it depends on more than the star.
  void remove_top()
  {
    m_prefetcher(m_heap, m_surface.surface(), m_cost);
    const Vertex_index v = m_heap.top();
    evaluate(v);
    if(!m_heap.contains(v) || m_heap.top() != v)
      return;
    const double cost = m_heap.key(v);
    m_visitor.before_removal(m_star, cost);
    m_touched.clear();
    m_status[v] = m_surface.remove(m_star, [&](Vertex_index u) { m_touched.push_back(u); });
    m_heap.remove(v);
    if(m_status[v] == Removal_status::possible)
      finish_removal(v, cost);
  }

  void finish_removal(Vertex_index v, double cost)
  {
    m_cost.after_removal(m_star);
    ++m_result.removed;
    m_result.greatest_cost = (std::max)(m_result.greatest_cost, cost);
    std::sort(m_touched.begin(), m_touched.end());
    m_touched.erase(std::unique(m_touched.begin(), m_touched.end()), m_touched.end());
    for(Vertex_index u : m_touched)
      if(u != v)
        evaluate(u);
    m_visitor.after_removal(v);
  }

  Evolving_surface& m_surface;
  Cost& m_cost;
  Visitor& m_visitor;
  Vertex_heap m_heap;
  Star_prefetcher m_prefetcher;
  std::vector<Removal_status> m_status; // of each vertex
  Flattened_star m_star;
  std::vector<Vertex_index> m_touched; // changed by the last removal
  Simplification_result m_result;
};

template <typename Cost, typename Visitor>
Simplification_result simplified(Evolving_surface& surface, Cost& cost,
                                 std::size_t number_of_vertices, double maximum_cost,
                                 Visitor& visitor)
{
  return Simplifier(surface, cost, visitor)(number_of_vertices, maximum_cost);
}

template <typename NamedParameters>
void check_target()
{
  using Intrinsic_triangulations::internal::has_parameter;
  if(!has_parameter<NamedParameters, internal_np::number_of_vertices_t>() &&
     !has_parameter<NamedParameters, internal_np::maximum_cost_t>())
    throw Intrinsic_triangulations::Invalid_input(
      "simplification needs a target: number_of_vertices() or maximum_cost()");
}

// Returns `run(number_of_vertices, maximum_cost, visitor)` for the parameters.
template <typename NamedParameters, typename Run>
Simplification_result with_target(const NamedParameters& np, const Run& run)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  check_target<NamedParameters>();
  Default_simplification_visitor silent;
  auto&& visitor = Intrinsic_triangulations::internal::visitor_of(np, silent);
  return run(static_cast<std::size_t>(choose_parameter(
               get_parameter(np, internal_np::number_of_vertices), std::size_t(0))),
             double(choose_parameter(get_parameter(np, internal_np::maximum_cost),
                                     std::numeric_limits<double>::infinity())),
             visitor);
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// makes a surface Delaunay and removes vertices from it, the cheapest first (Algorithm 6)
/// \cgalCite{LGCSJC23}.
///
/// It can be called again, with the same cost or another one.
///
/// \tparam Cost a model of `RemovalCost`
/// \tparam NamedParameters a sequence of named parameters
/// \param surface the surface
/// \param cost the cost, which is notified of each removal
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_vertices}
///     \cgalParamDescription{the number of vertices at which to stop; with 0, all removable
///       vertices are removed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0 if there is a `maximum_cost`; there is none otherwise}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_cost}
///     \cgalParamDescription{the greatest allowed cost of a removal}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no bound}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every removal; an exception that it throws stops the
///                           simplification and leaves `surface` valid}
///     \cgalParamType{a model of `SimplificationVisitor`; it is copied unless
///       `std::ref()` refers to it}
///     \cgalParamDefault{`Default_simplification_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// One of the first two parameters must be given.
///
/// \returns the numbers of removals and of remaining vertices
///
/// Complexity: \f$O(r \log n)\f$ for \f$r\f$ removals among \f$n\f$ vertices, plus linear in the
/// size of the surface. Degrees and numbers of flips for a removal count as bounded. Memory besides
/// the history: 21 bytes for each vertex.
/// \throws Intrinsic_triangulations::Invalid_input if neither a number of vertices nor a greatest
///   cost is given; then the surface is not changed
/// \throws Intrinsic_triangulations::Flip_limit_exceeded,
///   Intrinsic_triangulations::Numerical_error and Intrinsic_triangulations::Overflow_error as
///   `Evolving_surface::remove()`; after the first two, `surface` is valid, but may not be Delaunay
template <typename Cost, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Simplification_result simplify(Evolving_surface& surface, Cost& cost,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::with_target(
    np, [&](std::size_t number_of_vertices, double maximum_cost, auto& visitor) {
      return internal::simplified(surface, cost, number_of_vertices, maximum_cost, visitor);
    });
}

/// \ingroup PkgIntrinsicSimplificationRef
/// the weight of area in the default cost; curvature has weight one. With it, solutions of Poisson
/// problems on coarse surfaces are best on average (\ref is_quality).
constexpr double default_area_weight = 2;

/// \ingroup PkgIntrinsicSimplificationRef
/// the weight of the change of area in the default cost. It improves distances on coarse surfaces,
/// and does not affect solutions of Poisson problems (\ref is_quality).
constexpr double default_area_change_weight = 6;

/// \ingroup PkgIntrinsicSimplificationRef
/// the weight of the change of area at the boundary in the default cost. With it, a flat surface
/// with as many vertices as corners keeps its corners (\ref is_cost).
constexpr double default_boundary_change_weight = 12;

/// \ingroup PkgIntrinsicSimplificationRef
/// returns a cost for `surface` with four masses. Curvature has weight one, area
/// `default_area_weight`. The change of area has `default_area_change_weight`, and at the boundary
/// also `default_boundary_change_weight`. Complexity: linear.
inline Transport_cost default_cost(const Evolving_surface& surface)
{
  Transport_cost cost(surface);
  cost.add_curvature(surface);
  cost.add_area(surface, default_area_weight);
  cost.add_area_change(surface, default_area_change_weight);
  cost.add_boundary_change(surface, default_boundary_change_weight);
  return cost;
}

namespace internal {

template <typename Visitor>
Simplification_result simplified(Evolving_surface& surface, std::size_t number_of_vertices,
                                 double maximum_cost, Visitor& visitor)
{
  Transport_cost cost = default_cost(surface);
  return simplified(surface, cost, number_of_vertices, maximum_cost, visitor);
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// simplifies `surface` with `default_cost()`. Named parameters, result and exceptions are
/// described at the function with a cost. Complexity: the complexity of that function.
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
Simplification_result simplify(Evolving_surface& surface,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::with_target(
    np, [&](std::size_t number_of_vertices, double maximum_cost, auto& visitor) {
      return internal::simplified(surface, number_of_vertices, maximum_cost, visitor);
    });
}

} // namespace CGAL::Intrinsic_simplification

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/compiled/Intrinsic_triangulation.h>

namespace CGAL::Intrinsic_simplification {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Evolving_surface::Evolving_surface(
  const Surface_mesh<Point_3<Simple_cartesian<double>>>&,
  const CGAL::parameters::Default_named_parameters&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Evolving_surface::Evolving_surface(
  const Surface_mesh<Point_3<Epick>>&, const CGAL::parameters::Default_named_parameters&);

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Simplification_result
simplified(Evolving_surface&, Transport_cost&, std::size_t, double,
           Default_simplification_visitor&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Simplification_result
simplified(Evolving_surface&, std::size_t, double, Default_simplification_visitor&);

} // namespace internal
} // namespace CGAL::Intrinsic_simplification
#endif

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFY_H
