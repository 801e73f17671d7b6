// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_COORDINATES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_COORDINATES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Input_part.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// is thrown if faces of the input have no texture coordinates: the map is not projective on them,
/// or is not laid out.
class No_texture_coordinates : public Intrinsic_triangulations::Error
{
public:
  using Error::Error;
};

namespace internal {

// Calls `f` with the faces of the subdivision that are on the input.
template <typename Function>
void for_each_original_face(const Planar_conformal_map& map, const Function& f)
{
  for(Face_index part : map.subdivision().mesh().faces())
    if(map.is_original(map.subdivision().parent_face(Layer::A, part)))
      f(part);
}

// Finds the halfedge of the subdivision for each halfedge of a face of T_1 on the input.
class Whole_faces
{
public:
  // Finds the halfedges of faces.
  // \pre the faces of the input are whole
  explicit Whole_faces(const Planar_conformal_map& map) : m_map(map)
  {
    m_part.resize(map.Delaunay().input_mesh().num_halfedges());
    for_each_original_face(map, [&](Face_index f) { add(f); });
  }

  // Returns the halfedge of the subdivision for the halfedge `h` of the input.
  Halfedge_index part(Halfedge_index h) const { return m_part[h.idx()]; }

private:
  void add(Face_index part)
  {
    const auto& mesh = m_map.subdivision().mesh();
    const Delta_complex& input = m_map.Delaunay().input_mesh();
    const Halfedge_index first = input.halfedge(m_map.subdivision().parent_face(Layer::A, part));
    Halfedge_index h = mesh.halfedge(part);
    while(!has_edges(h, first))
      h = mesh.next(h);
    for(Halfedge_index x : {first, input.next(first), input.prev(first)}) {
      m_part[x.idx()] = h;
      h = mesh.next(h);
    }
  }

  // Returns whether the edges of a face of the subdivision, from `h`, are the edges of a face of
  // T_1, from `x`.
  bool has_edges(Halfedge_index h, Halfedge_index x) const
  {
    const auto& mesh = m_map.subdivision().mesh();
    const Delta_complex& input = m_map.Delaunay().input_mesh();
    const auto is_part = [&](Halfedge_index a, Halfedge_index b) {
      return m_map.subdivision().parent_edge(Layer::A, mesh.edge(a)) == input.edge(b);
    };
    return is_part(h, x) && is_part(mesh.next(h), input.next(x)) &&
           is_part(mesh.prev(h), input.prev(x));
  }

  const Planar_conformal_map& m_map;
  std::vector<Halfedge_index> m_part;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns whether edges of \f$T_2\f$ and \f$T_3\f$ cut no face of the input. Then the map is
/// projective on each face, and corners of the input determine the map. Otherwise only the
/// subdivision determines it. Complexity: linear in the faces of the subdivision.
inline bool has_whole_faces(const Planar_conformal_map& map)
{
  std::vector<char> is_met(map.Delaunay().input_mesh().num_faces(), 0);
  bool result = true;
  internal::for_each_original_face(map, [&](Face_index part) {
    char& is_second = is_met[map.subdivision().parent_face(Layer::A, part).idx()];
    result = result && !is_second;
    is_second = 1;
  });
  return result;
}

namespace internal {

inline void check_layout(const Planar_conformal_map& map)
{
  if(!map.is_laid_out())
    throw No_texture_coordinates(std::string("the map is not laid out: ") +
                                 to_string(map.status()));
}

// Calls `write` with the halfedges of the faces of a graph and the images of their targets.
// `images` computes the images of the corners of a part.
template <typename Graph, typename Images, typename Function>
void for_each_corner(const Planar_conformal_map& map, const Graph& g, const Images& images,
                     const Function& write)
{
  check_layout(map);
  if(!has_whole_faces(map))
    throw No_texture_coordinates("edges had to be flipped, so the map is not projective on every "
                                 "face: use common_subdivision()");
  const Whole_faces whole(map);
  const Input_part part(map);
  const Texture_corners corners(map, part);
  const auto points = images(map, part, corners).points;
  Intrinsic_triangulations::with_numbering(g, [&](const auto& numbering) {
    for(auto h : halfedges(g))
      if(face(h, g) != boost::graph_traits<Graph>::null_face())
        write(h, points[corners.index(whole.part(numbering.halfedge_of(h)))]);
  });
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// writes homogeneous texture coordinates \f$(xw, yw, w)\f$ of the corners of a mesh. Interpolated
/// linearly and then divided by the third, they give the exact map. Complexity: linear.
///
/// This is for maps whose faces are whole, which is rare. `common_subdivision()` makes a mesh with
/// texture coordinates for every map.
///
/// \param map the result of `flatten()` for `g`
/// \param g the mesh
/// \param uvw a writable property map with a halfedge of `g` as key and a value type that is made
///   of three `double`. A halfedge has the image of the corner at its target in its face. Border
///   halfedges get no value.
/// \throws No_texture_coordinates if faces of `g` are cut (see `has_whole_faces()`) or are not laid
///         out; nothing is written then
template <typename Graph, typename HalfedgeMap>
void homogeneous_texture_coordinates(const Planar_conformal_map& map, const Graph& g,
                                     HalfedgeMap uvw)
{
  typedef typename boost::property_traits<HalfedgeMap>::value_type Value;
  internal::for_each_corner(
    map, g, [](const auto&... args) { return homogeneous_texture_points(args...); },
    [&](auto h, const std::array<double, 3>& z) {
      put(uvw, h, Value{z[0], z[1], z[2]});
    });
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// writes texture coordinates \f$(x, y)\f$ of the corners of a mesh. Interpolated linearly, they
/// give the map at vertices and, on each edge and face, its image; in between they approximate it.
/// They are rounded such that no face is reversed, if that is possible (\ref dcm_reversed).
/// Complexity: linear.
///
/// This is for maps whose faces are whole, which is rare. `common_subdivision()` makes a mesh with
/// texture coordinates for every map.
///
/// \param map the result of `flatten()` for `g`
/// \param g the mesh
/// \param uv a writable property map with a halfedge of `g` as key. Its value type is made of two
///   `double`, such as `Point_2` of a kernel. A halfedge has the image of the corner at its target
///   in its face. Border halfedges get no value.
/// \throws No_texture_coordinates if faces of `g` are cut (see `has_whole_faces()`) or are not laid
///         out; nothing is written then
template <typename Graph, typename HalfedgeMap>
void texture_coordinates(const Planar_conformal_map& map, const Graph& g, HalfedgeMap uv)
{
  typedef typename boost::property_traits<HalfedgeMap>::value_type Value;
  internal::for_each_corner(
    map, g, [](const auto&... args) { return texture_points(args...); },
    [&](auto h, const std::array<double, 2>& z) {
      put(uv, h, Value{z[0], z[1]});
    });
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TEXTURE_COORDINATES_H
