// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/internal/topology/tree_loop.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// whether loops around boundary components bound
enum class Boundary_loops
{
  filled, // each boundary component is a face
  open    // those of one component of the surface are one face together
};

// A number for each edge, so that the exclusive or of those of a closed curve depends on its
// homology class modulo 2 only. If it is not zero and boundary loops are filled, the curve does not
// separate its component. Random numbers stand for the generators: a curve that bounds has zero,
// and another one has zero with probability $2^{-64}$.
//
// A spanning tree of the vertices and one of the faces across other edges leave the generators, two
// edges for each handle. Each of these closes a curve across edges, along the second tree; the
// number of an edge is that of all curves that cross it.
class Loop_signatures
{
public:
  typedef std::uint64_t Signature;

  explicit Loop_signatures(const Delta_complex& mesh,
                           Boundary_loops boundary = Boundary_loops::filled)
    : m_mesh(mesh),
      m_signature(mesh.num_edges(), 0),
      m_is_used(mesh.num_edges(), false),
      m_entry(mesh.num_vertices())
  {
    span_vertices();
    number_faces(boundary);
    span_faces();
    add_generators();
  }

  Signature operator[](Edge_index e) const { return m_signature[e]; }

  Signature of(const std::vector<Halfedge_index>& curve) const
  {
    Signature sum = 0;
    for(Halfedge_index h : curve)
      sum ^= m_signature[Edge_index(h)];
    return sum;
  }

  // Returns the edges that are left. With boundary loops that are open, their loops along the tree
  // of vertices are a basis of the homology over the integers.
  const std::vector<Edge_index>& generators() const { return m_generators; }

  // returns the loop of an edge along the tree of vertices
  std::vector<Halfedge_index> loop(Edge_index e) const
  {
    return tree_loop(
      first_halfedge(e), [&](Vertex_index v) { return m_entry[v.idx()]; }, m_mesh);
  }

  // Calls `visit(h)` for the halfedges of the generator `e` and of the tree of faces that its curve
  // crosses from the right to the left. What both ways to the root have in common is visited with
  // its opposite.
  template <typename Visit>
  void for_each_on_curve(Edge_index e, const Visit& visit) const
  {
    const Halfedge_index h = first_halfedge(e);
    visit(h);
    for(Halfedge_index x = m_parent[m_face[h]]; x.is_valid(); x = m_parent[m_face[opposite(x)]])
      visit(opposite(x));
    for(Halfedge_index x = m_parent[m_face[opposite(h)]]; x.is_valid();
        x = m_parent[m_face[opposite(x)]])
      visit(x);
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
            m_entry[v.idx()] = h;
            queue.push_back(v);
          }
        });
    }
  }

  // Boundary loops are faces, too.
  void number_faces(Boundary_loops boundary)
  {
    m_face.assign(m_mesh.num_halfedges(), null);
    const Mesh_components components(m_mesh);
    std::map<std::size_t, std::size_t> open; // the face of the boundary of a component
    for(Halfedge_index start : m_mesh.halfedges())
      if(m_face[start] == null) {
        std::size_t f = m_first.size();
        if(boundary == Boundary_loops::open && m_mesh.is_border(start))
          f = open.emplace(components[m_mesh.target(start).idx()], f).first->second;
        for(Halfedge_index h = start; m_face[h] == null; h = m_mesh.next(h))
          m_face[h] = f;
        if(f == m_first.size())
          m_first.push_back(start);
        else
          m_other_starts[f].push_back(start);
      }
  }

  void span_faces()
  {
    m_parent.assign(m_first.size(), Halfedge_index());
    std::vector<bool> is_reached(m_first.size(), false);
    for(std::size_t root = 0; root < m_first.size(); ++root) {
      if(is_reached[root])
        continue;
      is_reached[root] = true;
      const std::size_t begin = m_order.size();
      m_order.push_back(root);
      for(std::size_t i = begin; i < m_order.size(); ++i) {
        const std::size_t f = m_order[i];
        reach_neighbors(m_first[f], is_reached);
        if(const auto others = m_other_starts.find(f); others != m_other_starts.end())
          for(Halfedge_index start : others->second)
            reach_neighbors(start, is_reached);
      }
    }
  }

  void reach_neighbors(Halfedge_index start, std::vector<bool>& is_reached)
  {
    Halfedge_index h = start;
    do {
      const Halfedge_index o = opposite(h);
      if(!m_is_used[Edge_index(h)] && !is_reached[m_face[o]]) {
        is_reached[m_face[o]] = true;
        m_is_used[Edge_index(h)] = true;
        m_parent[m_face[o]] = o;
        m_order.push_back(m_face[o]);
      }
      h = m_mesh.next(h);
    } while(h != start);
  }

  // On the way from both sides of an edge to the root, what is common cancels.
  void add_generators()
  {
    std::mt19937_64 random;
    std::vector<Signature> sum(m_first.size(), 0);
    for(Edge_index e : m_mesh.edges())
      if(!m_is_used[e]) {
        m_generators.push_back(e);
        m_signature[e] = random();
        for(Halfedge_index h : {m_mesh.halfedge(e, 0), m_mesh.halfedge(e, 1)})
          sum[m_face[h]] ^= m_signature[e];
      }
    for(auto f = m_order.rbegin(); f != m_order.rend(); ++f)
      if(m_parent[*f].is_valid()) {
        m_signature[Edge_index(m_parent[*f])] = sum[*f];
        sum[m_face[opposite(m_parent[*f])]] ^= sum[*f];
      }
  }

  static constexpr std::size_t null = static_cast<std::size_t>(-1);

  const Delta_complex& m_mesh;
  std::vector<Signature> m_signature;
  std::vector<bool> m_is_used;         // by one of the trees
  std::vector<Halfedge_index> m_entry; // the last halfedge of the path to a vertex
  std::vector<std::size_t> m_face;
  std::vector<Halfedge_index> m_first;                               // of each face
  std::map<std::size_t, std::vector<Halfedge_index>> m_other_starts; // of faces with several loops
  std::vector<Halfedge_index> m_parent; // leads out of a face to its parent
  std::vector<std::size_t> m_order;     // of faces, parents first
  std::vector<Edge_index> m_generators;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_LOOP_SIGNATURES_H
