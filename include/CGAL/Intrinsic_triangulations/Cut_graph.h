// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CUT_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CUT_GRAPH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// cuts a surface into disks: faces that are joined one after the other across edges, a tree for
/// each disk. The edges that are not crossed are open.
class Cut_graph
{
public:
  /// a face, and its halfedge through which it is reached; null for the first face of a disk.
  struct Step
  {
    Halfedge_index entry; ///< in the face
    Face_index face;      ///< the face
  };

  /// prepares for the faces of `mesh`, which is referred to. All edges are open.
  explicit Cut_graph(const Delta_complex& mesh) : m_mesh(mesh), m_is_open(mesh.num_edges(), 1) {}

  /// adds a face that is reached through `entry`.
  void join(Halfedge_index entry, Face_index face)
  {
    m_steps.push_back({entry, face});
    if(entry.is_valid())
      m_is_open[Edge_index(entry).idx()] = 0;
  }

  /// finds the seams: all open edges except edges that are closed again. Edges at the ends of the
  /// graph of open edges are closed, one after the other. Around a vertex with one open edge all
  /// faces fit, unless `is_terminal` holds for the vertex. Complexity: linear.
  void close_ends(const std::vector<char>& is_terminal)
  {
    m_is_seam = m_is_open;
    std::vector<int> count(m_mesh.num_vertices(), 0);
    for(Halfedge_index h : m_mesh.halfedges())
      count[m_mesh.source(h).idx()] += m_is_open[Edge_index(h).idx()];
    for(Vertex_index end : m_mesh.vertices())
      for(Vertex_index v = end; count[v.idx()] == 1 && !is_terminal[v.idx()];) {
        Halfedge_index seam;
        for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
          if(is_seam(Edge_index(h)))
            seam = h;
        });
        m_is_seam[Edge_index(seam).idx()] = 0;
        --count[v.idx()];
        v = m_mesh.target(seam);
        --count[v.idx()];
      }
  }

  /// returns the faces in the order in which they are joined.
  const std::vector<Step>& steps() const { return m_steps; }

  /// returns whether the faces of `e` are not joined across it.
  bool is_open(Edge_index e) const { return m_is_open[e.idx()] != 0; }

  /// returns whether `e` is a seam. \pre `close_ends()` has been called
  bool is_seam(Edge_index e) const { return m_is_seam[e.idx()] != 0; }

  /// calls `visit(h, first)` for the outgoing halfedges `h` of `v`. Consecutive halfedges without
  /// a seam between them are one corner, and `first` is the first of them. Complexity: linear in
  /// the degree.
  /// \pre `close_ends()` has been called, and `v` is not isolated
  template <typename Visit>
  void for_each_corner(Vertex_index v, const Visit& visit) const
  {
    const Halfedge_index any = first_outgoing_halfedge(v, m_mesh);
    Halfedge_index first = any;
    while(!is_seam(Edge_index(first)) && next_around_source(first, m_mesh) != any)
      first = next_around_source(first, m_mesh);
    if(!is_seam(Edge_index(first)))
      first = any;
    Halfedge_index h = first, corner = first;
    do {
      if(is_seam(Edge_index(h)))
        corner = h;
      visit(h, corner);
      h = next_around_source(h, m_mesh);
    } while(h != first);
  }

private:
  const Delta_complex& m_mesh;
  std::vector<Step> m_steps;
  std::vector<char> m_is_open, m_is_seam;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CUT_GRAPH_H
