// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// A number for each edge, so that the exclusive or of those of a closed curve depends on its
// homology class modulo 2 only, where boundary loops count as filled. If it is not zero, the curve
// does not separate its component. Random numbers stand for the generators: a curve that separates
// has zero, and another one has zero with probability $2^{-64}$.
//
// A spanning tree of the vertices and one of the faces across other edges leave two edges for each
// handle. Each of these closes a curve across edges, along the second tree; the number of an edge
// is that of all curves that cross it.
class Loop_signatures
{
public:
  typedef std::uint64_t Signature;

  explicit Loop_signatures(const Delta_complex& mesh)
    : m_mesh(mesh), m_signature(mesh.num_edges(), 0), m_is_used(mesh.num_edges(), false)
  {
    span_vertices();
    number_faces();
    span_faces();
  }

  Signature operator[](Edge_index e) const { return m_signature[e]; }

  Signature of(const std::vector<Halfedge_index>& curve) const
  {
    Signature sum = 0;
    for(Halfedge_index h : curve)
      sum ^= m_signature[Edge_index(h)];
    return sum;
  }

private:
  // Marks the edges of a spanning forest.
  void span_vertices()
  {
    std::vector<bool> is_reached(m_mesh.num_vertices(), false);
    std::vector<Vertex_index> queue;
    for(Vertex_index root : m_mesh.vertices()) {
      if(is_reached[root] || m_mesh.is_isolated(root))
        continue;
      is_reached[root] = true;
      queue.assign(1, root);
      for(std::size_t i = 0; i < queue.size(); ++i)
        for_each_spoke(queue[i], m_mesh, [&](Halfedge_index h) {
          if(const Vertex_index v = m_mesh.target(h); !is_reached[v]) {
            is_reached[v] = true;
            m_is_used[Edge_index(h)] = true;
            queue.push_back(v);
          }
        });
    }
  }

  // Boundary loops are faces after the others.
  void number_faces()
  {
    m_face.assign(m_mesh.num_halfedges(), null);
    for(Halfedge_index start : m_mesh.halfedges())
      if(m_face[start] == null) {
        for(Halfedge_index h = start; m_face[h] == null; h = m_mesh.next(h))
          m_face[h] = m_first.size();
        m_first.push_back(start);
      }
  }

  void span_faces()
  {
    std::vector<Halfedge_index> parent(m_first.size()); // leads out of the face to its parent
    std::vector<std::size_t> order;
    std::vector<bool> is_reached(m_first.size(), false);
    for(std::size_t root = 0; root < m_first.size(); ++root) {
      if(is_reached[root])
        continue;
      is_reached[root] = true;
      const std::size_t begin = order.size();
      order.push_back(root);
      for(std::size_t i = begin; i < order.size(); ++i)
        reach_neighbors(order[i], is_reached, parent, order);
    }
    add_generators(order, parent);
  }

  void reach_neighbors(std::size_t f, std::vector<bool>& is_reached,
                       std::vector<Halfedge_index>& parent, std::vector<std::size_t>& order)
  {
    Halfedge_index h = m_first[f];
    do {
      const Halfedge_index o = opposite(h);
      if(!m_is_used[Edge_index(h)] && !is_reached[m_face[o]]) {
        is_reached[m_face[o]] = true;
        m_is_used[Edge_index(h)] = true;
        parent[m_face[o]] = o;
        order.push_back(m_face[o]);
      }
      h = m_mesh.next(h);
    } while(h != m_first[f]);
  }

  // On the way from both sides of an edge to the root, what is common cancels.
  void add_generators(const std::vector<std::size_t>& order,
                      const std::vector<Halfedge_index>& parent)
  {
    std::mt19937_64 random;
    std::vector<Signature> sum(m_first.size(), 0);
    for(Edge_index e : m_mesh.edges())
      if(!m_is_used[e]) {
        m_signature[e] = random();
        for(Halfedge_index h : {m_mesh.halfedge(e, 0), m_mesh.halfedge(e, 1)})
          sum[m_face[h]] ^= m_signature[e];
      }
    for(auto f = order.rbegin(); f != order.rend(); ++f)
      if(parent[*f].is_valid()) {
        m_signature[Edge_index(parent[*f])] = sum[*f];
        sum[m_face[opposite(parent[*f])]] ^= sum[*f];
      }
  }

  static constexpr std::size_t null = static_cast<std::size_t>(-1);

  const Delta_complex& m_mesh;
  std::vector<Signature> m_signature;
  std::vector<bool> m_is_used; // by one of the trees
  std::vector<std::size_t> m_face;
  std::vector<Halfedge_index> m_first; // of each face
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H
