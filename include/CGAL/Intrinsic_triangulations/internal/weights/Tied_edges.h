// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_TIED_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_TIED_EDGES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Vertex_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds edges that must be ties if all hidden vertices have their bounds as weights. Let the faces
// of a fan have positive area. Then the difference between a weight and its bound is a positive
// combination of signed lengths of dual edges inside the fan. All these differences are zero, and
// they are linearly independent. If fans that share edges have as many edges in total as there are
// fans, all dual edges are zero.
class Tied_edges
{
public:
  // `has_area(bound)` returns whether all faces of a fan have positive area.
  template <typename Has_area>
  Tied_edges(const Delta_complex& mesh, const std::map<Vertex_index, Hidden_weight>& hidden,
             const Has_area& has_area)
    : m_sets(boost::make_assoc_property_map(m_rank), boost::make_assoc_property_map(m_parent))
  {
    for(const auto& [v, weight] : hidden)
      m_sets.make_set(v);
    for(const auto& [v, weight] : hidden)
      for_each_inner_edge(weight.bound, mesh, [&, v = v](Edge_index e) {
        m_sets.union_set(m_fan.try_emplace(e, v).first->second, v);
      });
    for(const auto& [v, weight] : hidden)
      if(has_area(weight.bound))
        ++m_excess[m_sets.find_set(v)];
    for(const auto& [e, v] : m_fan)
      --m_excess[m_sets.find_set(v)];
  }

  std::set<Edge_index> determined()
  {
    std::set<Edge_index> result;
    for(const auto& [e, v] : m_fan)
      if(m_excess[m_sets.find_set(v)] == 0)
        result.insert(e);
    return result;
  }

private:
  // Calls `use(e)` for the edges that a geodesic may cross, or for all edges of a narrow cone.
  template <typename Use>
  static void for_each_inner_edge(const Weight_bound& bound, const Delta_complex& mesh,
                                  const Use& use)
  {
    const std::vector<Halfedge_index> outgoing = bound.fan(mesh);
    for(std::size_t i = bound.faces > 0 ? 1 : 0; i + 1 < outgoing.size(); ++i)
      use(mesh.edge(outgoing[i]));
  }

  typedef std::map<Vertex_index, std::size_t> Rank;
  typedef std::map<Vertex_index, Vertex_index> Parent;

  Rank m_rank;
  Parent m_parent;
  boost::disjoint_sets<boost::associative_property_map<Rank>,
                       boost::associative_property_map<Parent>>
    m_sets;
  std::map<Edge_index, Vertex_index> m_fan; // of one of the vertices whose fans contain the edge
  std::map<Vertex_index, long> m_excess;    // of fans over edges
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_TIED_EDGES_H
