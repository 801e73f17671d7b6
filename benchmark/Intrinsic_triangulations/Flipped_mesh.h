// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_FLIPPED_MESH_H
#define INTRINSIC_BENCHMARK_FLIPPED_MESH_H

#include "method.h"

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <cstddef>

namespace Methods {

// Stores T1 and T2 with only its lengths. Decisions and lengths are computed by the library, so
// that methods differ only in their correspondence.
class Flipped_mesh
{
public:
  typedef Delta_complex::Property_map<Edge_index, double> Length_map;

  explicit Flipped_mesh(const IT::Intrinsic_triangulation<>& tri)
    : m_input(tri.input_mesh()),
      m_mesh(m_input),
      m_input_length(length_map(m_input)),
      m_length(length_map(m_mesh))
  {}
  Flipped_mesh(const Flipped_mesh&) = delete;
  Flipped_mesh& operator=(const Flipped_mesh&) = delete;

  const Delta_complex& input() const { return m_input; }
  const Delta_complex& mesh() const { return m_mesh; }
  const Length_map& input_length_map() const { return m_input_length; }
  double length(Halfedge_index h) const { return m_length[m_mesh.edge(h)]; }

  // Calls `after_flip(h)` for every flip, with `h` after flip_edge().
  template <typename After_flip>
  std::size_t make_Delaunay(const After_flip& after_flip)
  {
    IT::Edge_stack stack(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      stack.push(e);
    std::size_t flips = 0;
    const std::size_t limit = IT::default_flip_limit(m_mesh.num_edges());
    while(!stack.empty()) {
      const Halfedge_index h = m_mesh.halfedge(stack.pop());
      if(is_Delaunay(h))
        continue;
      if(flips++ == limit)
        throw IT::Flip_limit_exceeded("not Delaunay after as many flips as are allowed");
      flip(h);
      after_flip(h);
      const Halfedge_index o = m_mesh.opposite(h);
      for(Halfedge_index x : {m_mesh.next(h), m_mesh.prev(h), m_mesh.next(o), m_mesh.prev(o)})
        stack.push(m_mesh.edge(x));
    }
    return flips;
  }

private:
  typedef IT::Euclidean_geometry_traits<> Traits;

  static Length_map length_map(Delta_complex& mesh)
  {
    return mesh.add_property_map<Edge_index, double>("e:length", 0).first;
  }

  bool is_Delaunay(Halfedge_index h) const
  {
    return IT::flip_status(h, m_mesh) != IT::Operation_status::possible ||
           Traits::Is_locally_Delaunay()(IT::diamond(m_length, h, m_mesh));
  }

  void flip(Halfedge_index h)
  {
    const double length = Traits::Compute_flipped_length()(IT::diamond(m_length, h, m_mesh));
    if(!Traits::Is_length()(length))
      throw IT::Numerical_error("no positive finite length");
    IT::flip_edge(h, m_mesh);
    m_length[m_mesh.edge(h)] = length;
  }

  Delta_complex m_input, m_mesh;
  Length_map m_input_length, m_length;
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_FLIPPED_MESH_H
