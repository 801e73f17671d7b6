// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_INTRINSIC_TRIANGULATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_INTRINSIC_TRIANGULATION_IMPL_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

// The constructors are not inline, so that the compiled library can contain them.
template <typename Traits>
template <typename Graph, typename NamedParameters>
Intrinsic_triangulation<Traits>::Intrinsic_triangulation(const Graph& g, const NamedParameters& np)
  : Base(CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits), Traits()))
{
  m_input.resize(internal::size_of(vertices(g)), internal::size_of(edges(g)),
                 internal::size_of(faces(g)));
  with_numbering(g, [&](const auto& numbering) {
    internal::copy_connectivity(g, numbering, m_input);
    copy_properties(g, np, numbering);
  });
}

template <typename Traits>
template <typename NamedParameters>
Intrinsic_triangulation<Traits>::Intrinsic_triangulation(Delta_complex&& g,
                                                         const NamedParameters& np)
  : Base(CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits), Traits()))
{
  if(g.has_garbage() || internal::has_property_maps(g)) {
    *this = Intrinsic_triangulation(std::as_const(g), np);
    return;
  }
  m_input = std::move(g);
  attach();
  internal::complete_connectivity(m_input);
  copy_properties(m_input, np, internal::Surface_mesh_numbering());
}

// Gives T1 the lengths of the graph, and makes T2.
template <typename Traits>
template <typename Graph, typename NamedParameters, typename Numbering>
void Intrinsic_triangulation<Traits>::copy_properties(const Graph& g, const NamedParameters& np,
                                                      const Numbering& numbering)
{
  internal::copy_lengths(g, np, numbering, input());
  internal::copy_metric(g, np, numbering, m_input, m_input_metric);
  internal::mollify_lengths(np, input(), m_input_metric);
  internal::check_copied_lengths(np, input(), m_traits);
  if constexpr(internal::Is_exact<Traits>::value)
    internal::check_exact_triangles(internal::exact_input(*this));
  else if constexpr(internal::has_metric<Traits>())
    internal::make_triangles_exact(internal::exact_input(*this), m_input_metric);
  m_mesh = m_input;
  attach();
  m_outgoing_halfedges = Outgoing_halfedges(m_input, m_coordinates.roundabout_map());
  internal::copy_constraints(g, np,
                             [&](Halfedge_index h) { m_is_constrained[m_mesh.edge(h)] = true; });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_INTRINSIC_TRIANGULATION_IMPL_H
