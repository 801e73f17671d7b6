// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TREE_COTREE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TREE_COTREE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Cut_graph.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// states whether loops around boundary components bound.
enum class Boundary_loops
{
  filled, ///< each boundary component is a face
  open    ///< the boundary components of one component of the surface are one face together
};

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// cuts each component of a surface into one disk: the faces are joined along shortest paths from a
/// first face. The edges that remain open contain a tree with all vertices. The other open edges
/// are the generators, two for each handle. Edges with the shortest loops through the first face
/// are chosen (Erickson and Whittlesey 2005, on the dual graph). Boundary components count as
/// faces, see `Boundary_loops`; their indices follow the indices of the faces.
class Tree_cotree : public Cut_graph
{
public:
  /// crosses as few edges as possible from the first face of each component to each of its faces.
  /// Complexity: \f$O(n \log n)\f$.
  explicit Tree_cotree(const Delta_complex& mesh, Boundary_loops boundary = Boundary_loops::filled)
    : Tree_cotree(mesh, std::vector<double>(mesh.num_edges(), 1.), boundary, false)
  {}

  /// measures ways by a length for each edge that is crossed. They start at a face from which no
  /// other face of the component is very far away. Complexity: \f$O(n \log n)\f$.
  Tree_cotree(const Delta_complex& mesh, const std::vector<double>& crossing_length)
    : Tree_cotree(mesh, crossing_length, Boundary_loops::filled, true)
  {}

  /// returns the number of components, except for isolated vertices.
  std::size_t number_of_components() const { return m_generators.size(); }

  /// returns the component of a face.
  std::size_t component(Face_index f) const { return m_component[f.idx()]; }

  /// returns the face or the boundary component at the left of `h`.
  Face_index face(Halfedge_index h) const { return m_face[h.idx()]; }

  /// returns whether `e` is in the tree of the vertices.
  bool is_in_tree(Edge_index e) const { return m_is_in_tree[e.idx()] != 0; }

  /// returns the generators of a component, the edges with the shortest loops first.
  const std::vector<Edge_index>& generators(std::size_t component) const
  {
    return m_generators[component];
  }

  /// returns the halfedges of the generators of a component. Their order is the order in which a
  /// walk clockwise around the tree crosses them, as if all vertices were one.
  /// \pre the component is closed
  std::vector<Halfedge_index> relation(std::size_t component) const
  {
    std::vector<Halfedge_index> result;
    if(generators(component).empty())
      return result;
    const Halfedge_index start = m_mesh.halfedge(generators(component).front());
    Halfedge_index h = start;
    do {
      const Edge_index e(h);
      if(is_open(e) && !is_in_tree(e))
        result.push_back(h);
      h = m_mesh.next(is_in_tree(e) ? h : m_mesh.opposite(h));
    } while(h != start);
    return result;
  }

private:
  typedef Dijkstra_search<Face_index, double> Search;
  typedef std::vector<double> Lengths; // of edges

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Tree_cotree(const Delta_complex& mesh, const Lengths& crossing_length, Boundary_loops boundary,
              bool is_central)
    : Cut_graph(mesh), m_mesh(mesh), m_face(mesh.num_halfedges()), m_is_in_tree(mesh.num_edges(), 0)
  {
    set_faces(boundary);
    m_component.assign(mesh.num_faces() + m_boundary.size(), none);
    Search search(m_component.size());
    for(Face_index f : mesh.faces())
      if(m_component[f.idx()] == none)
        join_faces(is_central ? center(f, crossing_length, search)
                              : search_from(f, crossing_length, search),
                   search);
    grow_tree(loop_lengths(crossing_length, search));
  }

  void set_faces(Boundary_loops boundary)
  {
    std::map<std::size_t, std::size_t> open; // for each component, the index of its boundary
    const Mesh_components components(m_mesh);
    for(Halfedge_index start : m_mesh.halfedges())
      if(!m_mesh.is_border(start))
        m_face[start.idx()] = m_mesh.face(start);
      else if(!face(start).is_valid()) {
        std::size_t i = m_boundary.size();
        if(boundary == Boundary_loops::open)
          i = open.emplace(components[m_mesh.target(start).idx()], i).first->second;
        m_boundary.resize((std::max)(m_boundary.size(), i + 1));
        for(Halfedge_index h = start; !face(h).is_valid(); h = m_mesh.next(h)) {
          m_face[h.idx()] =
            Face_index(static_cast<Delta_complex::size_type>(m_mesh.num_faces() + i));
          m_boundary[i].push_back(h);
        }
      }
  }

  template <typename Visit>
  void for_each_side(Face_index f, const Visit& visit) const
  {
    if(f.idx() < m_mesh.num_faces())
      for(Halfedge_index h : sides(f, m_mesh))
        visit(h);
    else
      for(Halfedge_index h : m_boundary[f.idx() - m_mesh.num_faces()])
        visit(h);
  }

  // Finds the shortest paths from `root`. Returns the faces in the order of their distances.
  std::vector<Face_index> search_from(Face_index root, const Lengths& crossing_length,
                                      Search& search) const
  {
    std::vector<Face_index> result;
    search.restart();
    search.reach(root, 0);
    for(Face_index f = search.next(); f.is_valid(); f = search.next()) {
      result.push_back(f);
      for_each_side(f, [&, distance = search.distance(f)](Halfedge_index h) {
        const Halfedge_index o = opposite(h);
        search.reach(face(o), distance + crossing_length[Edge_index(h).idx()], o);
      });
    }
    return result;
  }

  // Searches a face from which no other face is very far away. Among some faces far from each
  // other, it has the least greatest distance. More rounds hardly improve it.
  std::vector<Face_index> center(Face_index start, const Lengths& crossing_length,
                                 Search& search) const
  {
    constexpr int rounds = 6;
    const std::vector<Face_index> faces = search_from(start, crossing_length, search);
    std::vector<double> greatest(faces.size(), 0);
    std::vector<Face_index> result = faces;
    for(int i = 0; i < rounds; ++i) {
      search_from(result.back(), crossing_length, search);
      std::size_t best = 0;
      for(std::size_t k = 0; k < faces.size(); ++k) {
        greatest[k] = (std::max)(greatest[k], search.distance(faces[k]));
        if(greatest[k] < greatest[best])
          best = k;
      }
      result = search_from(faces[best], crossing_length, search);
    }
    return result;
  }

  void join_faces(const std::vector<Face_index>& order, const Search& search)
  {
    for(Face_index f : order) {
      m_component[f.idx()] = m_generators.size();
      join(search.entry(f), f);
    }
    m_generators.emplace_back();
  }

  Lengths loop_lengths(const Lengths& crossing_length, const Search& search) const
  {
    Lengths result(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      result[e.idx()] = crossing_length[e.idx()] + search.distance(face(m_mesh.halfedge(e, 0))) +
                        search.distance(face(m_mesh.halfedge(e, 1)));
    return result;
  }

  // Grows the tree by Kruskal's algorithm, the longest loops first.
  void grow_tree(const Lengths& loop_length)
  {
    std::vector<Edge_index> edges;
    for(Edge_index e : m_mesh.edges())
      if(is_open(e))
        edges.push_back(e);
    std::stable_sort(edges.begin(), edges.end(), [&](Edge_index a, Edge_index b) {
      return loop_length[a.idx()] > loop_length[b.idx()];
    });
    boost::disjoint_sets_with_storage<> sets(m_mesh.num_vertices());
    for(Edge_index e : edges) {
      const auto a = sets.find_set(m_mesh.vertex(e, 0).idx()),
                 b = sets.find_set(m_mesh.vertex(e, 1).idx());
      if(a == b)
        m_generators[component(face(m_mesh.halfedge(e)))].push_back(e);
      else {
        sets.link(a, b);
        m_is_in_tree[e.idx()] = 1;
      }
    }
    for(auto& generators : m_generators)
      std::reverse(generators.begin(), generators.end());
  }

  const Delta_complex& m_mesh;
  std::vector<Face_index> m_face;                      // at the left of each halfedge
  std::vector<std::vector<Halfedge_index>> m_boundary; // the sides of the faces that are boundaries
  std::vector<std::size_t> m_component;                // of each face
  std::vector<std::vector<Edge_index>> m_generators;   // of each component
  std::vector<char> m_is_in_tree;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TREE_COTREE_H
