// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INPUT_PART_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INPUT_PART_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_part.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the part of the common subdivision of a map that belongs to the input, not to the second copy of
/// a surface with boundary. The vertices of the input come first, with their indices.
///
/// The object refers to the map.
class Input_part
  : public Intrinsic_triangulations::Subdivision_part<Discrete_conformal_map::Subdivision>
{
  typedef Intrinsic_triangulations::Subdivision_part<Discrete_conformal_map::Subdivision> Base;

public:
  /// selects the elements. Complexity: linear.
  explicit Input_part(const Discrete_conformal_map& map)
    : Base(
        map.subdivision(), number_of_vertices(map),
        [&](Face_index f) { return map.is_original(map.subdivision().parent_face(Layer::A, f)); }),
      m_map(&map),
      m_number_of_input_vertices(number_of_vertices(map))
  {}

  /// returns the map.
  const Discrete_conformal_map& map() const { return *m_map; }

  /// returns whether `v` is a vertex of the input.
  bool is_of_input(Vertex_index v) const { return v.idx() < m_number_of_input_vertices; }

  /// returns `v` as a convex combination of vertices of the input. If `v` lies on an edge, these
  /// are its two ends. Complexity: constant.
  Intrinsic_triangulations::Vertex_weights<double> input_weights(Vertex_index v) const
  {
    if(is_of_input(v))
      return {1, {v}, {1}};
    auto result = Intrinsic_triangulations::vertex_weights(subdivision().place(Layer::A, v),
                                                           m_map->Delaunay().input_mesh());
    for(std::size_t c = 0; c < result.size; ++c)
      result.vertex[c] = m_map->input_vertex(result.vertex[c]);
    return result;
  }

private:
  // Second copies have greater indices.
  static size_type number_of_vertices(const Discrete_conformal_map& map)
  {
    const Delta_complex& mesh = map.Delaunay().input_mesh();
    return static_cast<size_type>(
      std::count_if(mesh.vertices_begin(), mesh.vertices_end(),
                    [&](Vertex_index v) { return map.input_vertex(v) == v; }));
  }

  const Discrete_conformal_map* m_map;
  size_type m_number_of_input_vertices;
};

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns whether the two faces of the edge `e` of the subdivision belong to `part` and lie apart
/// in the image under `map`. Complexity: constant.
/// \tparam Map `Planar_conformal_map` or `Hyperbolic_conformal_map`
template <typename Map>
bool is_seam(const Map& map, const Input_part& part, Edge_index e)
{
  const Edge_index on_C = part.subdivision().parent_edge(Layer::C, e);
  const Halfedge_index h = part.mesh().halfedge(e);
  return on_C.is_valid() && map.is_seam(on_C) && part.has(h) && part.has(part.mesh().opposite(h));
}

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// the corners of the faces of an input part. Adjacent corners at a vertex, without a seam between
/// them, are one corner with one image. Computed in each face, their images could differ by
/// rounding.
class Texture_corners
{
public:
  /// the type of indices of corners.
  typedef Input_part::size_type size_type;

  /// finds the corners, in the order of faces and their sides. Complexity: linear.
  /// \tparam Map `Planar_conformal_map` or `Hyperbolic_conformal_map`
  template <typename Map>
  Texture_corners(const Map& map, const Input_part& part)
    : m_index(part.mesh().number_of_halfedges(), none)
  {
    for(Face_index f : part.faces())
      for(Halfedge_index h : CGAL::halfedges_around_face(part.mesh().halfedge(f), part.mesh()))
        if(m_index[h.idx()] == none)
          add(h, map, part);
  }

  /// returns the number of corners.
  std::size_t size() const { return m_first.size(); }

  /// returns the index of the corner at the target of `h` in its face.
  size_type index(Halfedge_index h) const { return m_index[h.idx()]; }

  /// returns a halfedge that leads to the corner with index `n`. It is the first one in clockwise
  /// order if the corner ends at a seam or the boundary.
  Halfedge_index halfedge(std::size_t n) const { return m_first[n]; }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();

  // Returns whether the faces of `h` are apart in the image.
  template <typename Map>
  static bool is_open(Halfedge_index h, const Map& map, const Input_part& part)
  {
    return is_seam(map, part, Edge_index(h)) || !part.has(h) || !part.has(part.mesh().opposite(h));
  }

  template <typename Map>
  void add(Halfedge_index h, const Map& map, const Input_part& part)
  {
    const auto& mesh = part.mesh();
    Halfedge_index first = h;
    while(!is_open(first, map, part) && mesh.prev(mesh.opposite(first)) != h)
      first = mesh.prev(mesh.opposite(first));
    for(Halfedge_index x = first; m_index[x.idx()] == none; x = mesh.opposite(mesh.next(x))) {
      m_index[x.idx()] = static_cast<size_type>(m_first.size());
      if(is_open(mesh.next(x), map, part))
        break;
    }
    m_first.push_back(first);
  }

  std::vector<size_type> m_index;      // of each halfedge of the subdivision
  std::vector<Halfedge_index> m_first; // of each corner
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INPUT_PART_H
