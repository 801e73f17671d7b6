// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TOPOLOGICAL_TYPE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TOPOLOGICAL_TYPE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns a border halfedge of each of the closed curves that form the boundary of a surface: the
/// first in the order of `halfedges(g)`. Complexity: linear.
/// \tparam HalfedgeListGraph a model of `HalfedgeListGraph`
template <typename HalfedgeListGraph>
auto boundary_loops(const HalfedgeListGraph& g)
{
  typedef typename boost::graph_traits<HalfedgeListGraph>::halfedge_descriptor Halfedge;
  std::unordered_set<Halfedge> seen;
  std::vector<Halfedge> result;
  for(Halfedge start : halfedges(g))
    if(is_border(start, g) && seen.count(start) == 0) {
      result.push_back(start);
      for(Halfedge h = start; seen.insert(h).second;)
        h = next(h, g);
    }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// the numbers of components, boundaries and handles of an oriented surface. Two connected surfaces
/// are homeomorphic if and only if these numbers are equal. Isolated vertices do not count.
struct Topological_type
{
  std::size_t components = 0;     ///< the number of components
  std::size_t boundary_loops = 0; ///< the number of closed curves that form the boundary
  std::size_t genus = 0;          ///< the number of handles of all components
};

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the type in words, as part of a sentence: "a disk", or "a surface of genus 2 with 3
/// boundaries".
inline std::string description(const Topological_type& type)
{
  const auto count = [](std::size_t n, const std::string& what, const std::string& plural) {
    return std::to_string(n) + " " + (n == 1 ? what : plural);
  };
  if(type.components != 1)
    return "a surface of " + count(type.components, "component", "components");
  if(type.genus == 0 && type.boundary_loops < 3)
    return type.boundary_loops == 0   ? "a sphere"
           : type.boundary_loops == 1 ? "a disk"
                                      : "an annulus";
  if(type.genus == 1 && type.boundary_loops == 0)
    return "a torus";
  return "a surface of genus " + std::to_string(type.genus) +
         (type.boundary_loops == 0
            ? ""
            : " with " + count(type.boundary_loops, "boundary", "boundaries"));
}

namespace internal {

// Returns the number of classes of faces that are connected through edges.
template <typename Graph>
std::size_t number_of_components(const Graph& g)
{
  typedef typename boost::graph_traits<Graph>::face_descriptor Face;
  std::unordered_set<Face> reached;
  std::vector<Face> stack;
  std::size_t result = 0;
  for(Face start : faces(g)) {
    if(reached.insert(start).second) {
      ++result;
      stack.push_back(start);
    }
    while(!stack.empty()) {
      const auto first = halfedge(stack.back(), g);
      stack.pop_back();
      for(const auto h : CGAL::halfedges_around_face(first, g))
        if(const auto o = opposite(h, g); !is_border(o, g) && reached.insert(face(o, g)).second)
          stack.push_back(face(o, g));
    }
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the topological type of a surface. Complexity: linear.
/// \tparam FaceListGraph a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename FaceListGraph>
Topological_type topological_type(const FaceListGraph& g)
{
  Topological_type result;
  result.components = internal::number_of_components(g);
  result.boundary_loops = boundary_loops(g).size();
  const auto halfedges_of_g = halfedges(g);
  const auto faces_of_g = faces(g);
  const auto edges = std::distance(halfedges_of_g.begin(), halfedges_of_g.end()) / 2;
  auto vertices_and_faces = std::distance(faces_of_g.begin(), faces_of_g.end());
  for(const auto v : vertices(g))
    vertices_and_faces += halfedge(v, g) != boost::graph_traits<FaceListGraph>::null_halfedge();
  // Euler's formula holds with all boundary loops filled.
  result.genus = (2 * result.components + static_cast<std::size_t>(edges - vertices_and_faces) -
                  result.boundary_loops) /
                 2;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TOPOLOGICAL_TYPE_H
