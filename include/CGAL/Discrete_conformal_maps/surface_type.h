// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <unordered_set>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// the topology of a connected surface, as far as it decides which constant curvature it can have.
enum class Surface_type
{
  sphere,    ///< closed, genus zero
  disk,      ///< genus zero with one boundary
  torus,     ///< closed, genus one
  annulus,   ///< genus zero with two boundaries
  hyperbolic ///< all others
};

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the name of `type`.
inline const char* to_string(Surface_type type)
{
  switch(type) {
    case Surface_type::sphere: return "sphere";
    case Surface_type::disk: return "disk";
    case Surface_type::torus: return "torus";
    case Surface_type::annulus: return "annulus";
    case Surface_type::hyperbolic: return "hyperbolic";
  }
  return "unknown";
}

namespace internal {

// the faces that can be reached from `start` through edges
template <typename Graph>
std::size_t number_of_connected_faces(const Graph& g,
                                      typename boost::graph_traits<Graph>::face_descriptor start)
{
  typedef typename boost::graph_traits<Graph>::face_descriptor Face;
  std::unordered_set<Face> reached{start};
  std::vector<Face> stack{start};
  while(!stack.empty()) {
    const Face f = stack.back();
    stack.pop_back();
    for(auto h : CGAL::halfedges_around_face(halfedge(f, g), g))
      if(const auto o = opposite(h, g); !is_border(o, g) && reached.insert(face(o, g)).second)
        stack.push_back(face(o, g));
  }
  return reached.size();
}

template <typename Graph>
std::size_t number_of_boundary_loops(const Graph& g)
{
  typedef typename boost::graph_traits<Graph>::halfedge_descriptor Halfedge;
  std::unordered_set<Halfedge> seen;
  std::size_t result = 0;
  for(auto h : halfedges(g))
    if(is_border(h, g) && seen.insert(h).second) {
      ++result;
      for(auto x = next(h, g); x != h; x = next(x, g))
        seen.insert(x);
    }
  return result;
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the topology of a surface. Isolated vertices do not count. Complexity: linear.
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not connected or has no faces
template <typename Graph>
Surface_type surface_type(const Graph& g)
{
  const auto faces_of_g = faces(g);
  const auto number_of_faces =
    static_cast<std::size_t>(std::distance(faces_of_g.begin(), faces_of_g.end()));
  const auto halfedges_of_g = halfedges(g);
  const auto number_of_edges =
    static_cast<std::size_t>(std::distance(halfedges_of_g.begin(), halfedges_of_g.end())) / 2;
  std::size_t number_of_vertices = 0;
  for(auto v : vertices(g))
    number_of_vertices += halfedge(v, g) != boost::graph_traits<Graph>::null_halfedge();
  if(number_of_faces == 0 ||
     internal::number_of_connected_faces(g, *faces_of_g.begin()) != number_of_faces)
    throw Intrinsic_triangulations::Invalid_input("the surface is not connected");
  const std::size_t loops = internal::number_of_boundary_loops(g);
  // that of the surface with its boundaries filled
  const std::size_t characteristic = number_of_vertices + number_of_faces + loops - number_of_edges;
  if(characteristic == 2 && loops < 3)
    return loops == 0   ? Surface_type::sphere
           : loops == 1 ? Surface_type::disk
                        : Surface_type::annulus;
  return characteristic == 0 && loops == 0 ? Surface_type::torus : Surface_type::hyperbolic;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_SURFACE_TYPE_H
