// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SIGNATURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SIGNATURES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Tree_cotree.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the loop that `h` closes along a tree, without the common part of its two paths.
// `entry(v)` is the last halfedge of the path to `v`, null for the root.
template <typename Entry>
std::vector<Halfedge_index> tree_loop(Halfedge_index h, const Entry& entry,
                                      const Delta_complex& mesh)
{
  const auto path_from_root = [&](Vertex_index v) {
    std::vector<Halfedge_index> result;
    for(Halfedge_index x = entry(v); x.is_valid(); x = entry(mesh.source(x)))
      result.push_back(x);
    std::reverse(result.begin(), result.end());
    return result;
  };
  const auto there = path_from_root(mesh.source(h)), back = path_from_root(mesh.target(h));
  std::size_t common = 0;
  while(common < (std::min)(there.size(), back.size()) && there[common] == back[common])
    ++common;
  std::vector<Halfedge_index> result(there.begin() + static_cast<std::ptrdiff_t>(common),
                                     there.end());
  result.push_back(h);
  for(std::size_t i = back.size(); i-- > common;)
    result.push_back(opposite(back[i]));
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// computes a number for each edge. The exclusive or of the numbers of a closed curve depends only
/// on its homology class modulo 2. If it is not zero and boundary loops are filled, the curve does
/// not separate its component. Random numbers represent the generators of a `Tree_cotree`. A curve
/// that bounds has zero. Another curve has zero with probability \f$2^{-64}\f$.
///
/// Each generator closes a curve across edges, along the tree of faces. The number of an edge is
/// the exclusive or of the random numbers of all curves that cross it.
class Loop_signatures
{
public:
  /// the number of an edge, or of a homology class.
  typedef std::uint64_t Signature;

  /// computes the numbers of the edges of `mesh`, which is referred to. Complexity:
  /// \f$O(n \log n)\f$.
  explicit Loop_signatures(const Delta_complex& mesh,
                           Boundary_loops boundary = Boundary_loops::filled)
    : m_mesh(mesh),
      m_trees(mesh, boundary),
      m_signature(mesh.num_edges(), 0),
      m_entry(mesh.num_vertices()),
      m_parent(mesh.num_faces())
  {
    for(std::size_t c = 0; c < m_trees.number_of_components(); ++c)
      m_generators.insert(m_generators.end(), m_trees.generators(c).begin(),
                          m_trees.generators(c).end());
    set_entries();
    set_signatures();
  }

  /// returns the number of `e`.
  Signature operator[](Edge_index e) const { return m_signature[e]; }

  /// returns the number of a curve.
  Signature of(const std::vector<Halfedge_index>& curve) const
  {
    Signature sum = 0;
    for(Halfedge_index h : curve)
      sum ^= m_signature[Edge_index(h)];
    return sum;
  }

  /// returns the generators. With boundary loops that are open, their loops along the tree of
  /// vertices are a basis of the homology over the integers.
  const std::vector<Edge_index>& generators() const { return m_generators; }

  /// returns the loop of an edge along the tree of vertices.
  std::vector<Halfedge_index> loop(Edge_index e) const
  {
    return internal::tree_loop(
      first_halfedge(e), [&](Vertex_index v) { return m_entry[v.idx()]; }, m_mesh);
  }

  /// calls `visit(h)` for the halfedges of the generator `e` and of the tree of faces that its
  /// curve crosses from the right to the left. Common parts of both paths to the root are visited
  /// in both directions.
  template <typename Visit>
  void for_each_on_curve(Edge_index e, const Visit& visit) const
  {
    const Halfedge_index h = first_halfedge(e);
    visit(h);
    for(Halfedge_index x = parent(h); x.is_valid(); x = parent(opposite(x)))
      visit(opposite(x));
    for(Halfedge_index x = parent(opposite(h)); x.is_valid(); x = parent(opposite(x)))
      visit(x);
  }

private:
  // Returns the halfedge that leads out of the face of `h` to its parent.
  Halfedge_index parent(Halfedge_index h) const { return m_parent[m_trees.face(h).idx()]; }

  // Leads paths from a root to all vertices of a component along the tree.
  void set_entries()
  {
    std::vector<bool> is_reached(m_mesh.num_vertices(), false);
    std::vector<Vertex_index> open;
    for(Vertex_index root : m_mesh.vertices()) {
      if(is_reached[root] || m_mesh.is_isolated(root))
        continue;
      is_reached[root] = true;
      for(open.assign(1, root); !open.empty();) {
        const Vertex_index v = open.back();
        open.pop_back();
        for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
          const Vertex_index w = m_mesh.target(h);
          if(!m_trees.is_in_tree(Edge_index(h)) || is_reached[w])
            return;
          is_reached[w] = true;
          m_entry[w.idx()] = h;
          open.push_back(w);
        });
      }
    }
  }

  // Common edges of the paths from both sides of an edge to the root cancel.
  void set_signatures()
  {
    std::mt19937_64 random;
    for(const Cut_graph::Step& step : m_trees.steps()) {
      m_parent.resize((std::max)(m_parent.size(), std::size_t(step.face.idx()) + 1));
      m_parent[step.face.idx()] = step.entry;
    }
    std::vector<Signature> sum(m_parent.size(), 0);
    for(Edge_index e : m_generators) {
      m_signature[e] = random();
      for(Halfedge_index h : {m_mesh.halfedge(e, 0), m_mesh.halfedge(e, 1)})
        sum[m_trees.face(h).idx()] ^= m_signature[e];
    }
    for(auto step = m_trees.steps().rbegin(); step != m_trees.steps().rend(); ++step)
      if(step->entry.is_valid()) {
        m_signature[Edge_index(step->entry)] = sum[step->face.idx()];
        sum[m_trees.face(opposite(step->entry)).idx()] ^= sum[step->face.idx()];
      }
  }

  const Delta_complex& m_mesh;
  Tree_cotree m_trees;
  std::vector<Signature> m_signature;
  std::vector<Halfedge_index> m_entry;  // the last halfedge of the path to a vertex
  std::vector<Halfedge_index> m_parent; // leads out of a face to its parent
  std::vector<Edge_index> m_generators;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SIGNATURES_H
