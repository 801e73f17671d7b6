// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// a closed surface that has been made of surfaces with boundary.
struct Glued_surface
{
  /// the surface, with lengths: see `stored_length_map<double>()`.
  Delta_complex mesh;
  /// the vertex that each vertex of the parts has become, by index; null if that has no face.
  std::vector<Vertex_index> vertices;
};

namespace internal {

// Returns the numbers of halfedges after glued edges have become one.
template <typename P>
std::vector<Halfedge_index>
glued_halfedges(const Surface_mesh<P>& mesh,
                const std::vector<std::pair<Halfedge_index, Halfedge_index>>& pairs)
{
  std::vector<Halfedge_index> partner(mesh.num_halfedges());
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(mesh.edge(h)))
      partner[h] = mesh.opposite(h);
  for(const auto& [h, o] : pairs) {
    if(h == o || mesh.is_border(h) || mesh.is_border(o) || partner[h].is_valid() ||
       partner[o].is_valid())
      throw Invalid_input("a side of face " + std::to_string(mesh.face(h).idx()) +
                          " is glued twice, or is not on the boundary");
    partner[h] = o;
    partner[o] = h;
  }
  std::vector<Halfedge_index> result(mesh.num_halfedges());
  Delta_complex::size_type n = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    if(mesh.is_border(h) || result[h].is_valid())
      continue;
    if(!partner[h].is_valid())
      throw Invalid_input("the side from vertex " + std::to_string(mesh.source(h).idx()) +
                          " to vertex " + std::to_string(mesh.target(h).idx()) + " is not glued");
    result[h] = Halfedge_index(n++);
    result[partner[h]] = Halfedge_index(n++);
  }
  return result;
}

// Sets `v` as the target of all halfedges that lead to the target of `h`, and records the vertices
// that it replaces.
template <typename P>
void join_targets(Halfedge_index h, Vertex_index v, const Surface_mesh<P>& parts,
                  const std::vector<Halfedge_index>& before, Glued_surface& result)
{
  result.mesh.set_halfedge(v, h);
  Halfedge_index x = h;
  do {
    result.mesh.set_target(x, v);
    result.vertices[parts.target(before[x])] = v;
    x = opposite(result.mesh.next(x));
  } while(x != h);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// pairs of sides on the boundary of a mesh, given by their vertices, that are to be glued by
/// `glue_boundary()`.
template <typename P, typename LengthMap>
class Paired_sides
{
public:
  /// two halfedges that become opposite, each with a face on its left.
  typedef std::pair<Halfedge_index, Halfedge_index> Pair;

  /// starts without pairs. The mesh must outlive this object. Complexity: linear.
  /// \param mesh the parts, triangulated, without removed elements
  /// \param length a readable property map from the edges of `mesh` to numbers of type `double`
  Paired_sides(const Surface_mesh<P>& mesh, LengthMap length)
    : m_mesh(mesh), m_length(std::move(length)), m_is_paired(mesh.num_edges(), false)
  {}

  /// glues the side from `a` to `b` to the side from `c` to `d`, `a` to `c` and `b` to `d`. The
  /// lengths of both may differ by a hundred-thousandth of their mean, because coordinates of nets
  /// often have few digits. Complexity: linear in the degrees of the vertices.
  /// \throws Invalid_input if a side is not on the boundary or has been paired before, both have
  ///   different lengths, or the surface would not be oriented
  void add(Vertex_index a, Vertex_index b, Vertex_index c, Vertex_index d)
  {
    const Halfedge_index h = side(a, b), o = side(c, d);
    for(Halfedge_index x : {h, o}) {
      if(m_is_paired[m_mesh.edge(x)])
        throw Invalid_input(name(x) + " is glued twice");
      m_is_paired[m_mesh.edge(x)] = true;
    }
    const double x = get(m_length, m_mesh.edge(h)), y = get(m_length, m_mesh.edge(o));
    if(!(std::abs(x - y) <= tolerance * (x + y) / 2))
      throw Invalid_input("the two sides have different lengths, " + std::to_string(x) + " and " +
                          std::to_string(y));
    if(m_mesh.is_border(h) == m_mesh.is_border(o))
      throw Invalid_input("the surface would not be oriented; the sides must run in opposite "
                          "directions around the net");
    m_pairs.emplace_back(inner(h), inner(o));
  }

  /// returns the pairs. Complexity: linear.
  /// \throws Invalid_input if a side of the boundary is in no pair
  const std::vector<Pair>& complete_pairs() const
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h) && !m_is_paired[m_mesh.edge(h)])
        throw Invalid_input(name(m_mesh.opposite(h)) + " is not glued");
    return m_pairs;
  }

private:
  static constexpr double tolerance = 1e-5; // of lengths, relative to their mean

  std::string name(Vertex_index v, Vertex_index w) const
  {
    return "the side from " + std::to_string(v.idx()) + " to " + std::to_string(w.idx());
  }

  std::string name(Halfedge_index h) const { return name(m_mesh.source(h), m_mesh.target(h)); }

  Halfedge_index side(Vertex_index v, Vertex_index w) const
  {
    const Halfedge_index h = m_mesh.halfedge(v, w);
    if(!h.is_valid() || !m_mesh.is_border(m_mesh.edge(h)))
      throw Invalid_input(name(v, w) + " is not on the boundary of the mesh");
    return h;
  }

  Halfedge_index inner(Halfedge_index h) const
  {
    return m_mesh.is_border(h) ? m_mesh.opposite(h) : h;
  }

  const Surface_mesh<P>& m_mesh;
  LengthMap m_length;
  std::vector<bool> m_is_paired; // for each edge
  std::vector<Pair> m_pairs;
};

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// glues sides of surfaces, for example the sides of a polygon in the plane, until no boundary is
/// left. A glued edge has the mean of both lengths. Vertices are numbered in the order of the
/// first of the vertices that were glued. Complexity: linear.
///
/// \param mesh the parts, triangulated, without removed elements
/// \param length a readable property map from the edges of `mesh` to numbers of type `double`
/// \param pairs the halfedges that become opposite, each on the boundary and with a face on its
///   left. The source of one becomes the target of the other
/// \throws Invalid_input if a boundary edge is not in a pair, or more than once, or a halfedge of a
///   pair is not on the boundary
template <typename P, typename LengthMap>
Glued_surface glue_boundary(const Surface_mesh<P>& mesh, const LengthMap& length,
                            const std::vector<std::pair<Halfedge_index, Halfedge_index>>& pairs)
{
  CGAL_precondition(!mesh.has_garbage());
  const std::vector<Halfedge_index> after = internal::glued_halfedges(mesh, pairs);
  Glued_surface result;
  result.vertices.resize(mesh.num_vertices());
  Delta_complex::size_type n = 0;
  for(Halfedge_index h : after)
    n += h.is_valid();
  result.mesh.resize(0, n / 2, mesh.num_faces());
  auto glued_length = stored_length_map<double>(result.mesh);
  std::vector<Halfedge_index> before(n);
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h)) {
      const Halfedge_index g = after[h];
      before[g] = h;
      result.mesh.set_next(g, after[mesh.next(h)]);
      result.mesh.set_face(g, mesh.face(h));
      glued_length[result.mesh.edge(g)] += get(length, mesh.edge(h)) / 2;
    }
  for(Face_index f : mesh.faces())
    result.mesh.set_halfedge(f, after[mesh.halfedge(f)]);
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v) && !result.vertices[v].is_valid()) {
      const Halfedge_index h = mesh.halfedge(v); // a border halfedge on the boundary
      internal::join_targets(after[mesh.is_border(h) ? mesh.prev(mesh.opposite(h)) : h],
                             result.mesh.add_vertex(), mesh, before, result);
    }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H
