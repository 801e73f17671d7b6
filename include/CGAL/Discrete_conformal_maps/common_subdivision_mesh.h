// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_COMMON_SUBDIVISION_MESH_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_COMMON_SUBDIVISION_MESH_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Input_part.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/hyperbolic_texture_points.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>
#include <CGAL/Discrete_conformal_maps/sphere_points.h>
#include <CGAL/Discrete_conformal_maps/texture_coordinates.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

template <typename Value, std::size_t size, std::size_t... n>
Value made_of(const std::array<double, size>& a, std::index_sequence<n...>)
{
  return Value{a[n]...};
}

// Computes the images of the corners at the targets of halfedges, in the requested coordinates.
template <typename Map>
class Corner_images
{
public:
  Corner_images(const Map& map, const Input_part& part)
    : m_map(map), m_part(part), m_corners(map, part)
  {}

  auto homogeneous() const
  {
    return at_corners(homogeneous_texture_points(m_map, m_part, m_corners));
  }
  auto affine() const { return at_corners(texture_points(m_map, m_part, m_corners)); }

private:
  template <typename Points>
  auto at_corners(Points rounded) const
  {
    return [this, points = std::move(rounded.points)](Halfedge_index h) {
      return points[m_corners.index(h)];
    };
  }

  const Map& m_map;
  const Input_part& m_part;
  Texture_corners m_corners;
};

template <>
class Corner_images<Spherical_conformal_map>
{
public:
  Corner_images(const Spherical_conformal_map& map, const Input_part& part)
    : m_part(part),
      m_homogeneous(homogeneous_coordinates(map, part)),
      m_points(sphere_points(map, part, m_homogeneous).points)
  {}

  auto homogeneous() const
  {
    return [this](Halfedge_index h) { return m_homogeneous[number_of_target(m_part)(h)]; };
  }
  auto affine() const
  {
    return [this](Halfedge_index h) { return m_points[number_of_target(m_part)(h)]; };
  }

  const std::array<double, 3>& at(Vertex_index v) const { return m_points[m_part.number(v)]; }

private:
  const Input_part& m_part;
  std::vector<std::array<double, 4>> m_homogeneous;
  std::vector<std::array<double, 3>> m_points;
};

template <typename Map>
void check_layout(const Map&)
{}

// Puts `images()(h)` into the map that `np` has for `Tag`, if it has one, for the corners of faces.
template <typename Tag, typename Copy, typename Images, typename NamedParameters>
void put_corners(const Input_part& part, const Copy& copy, const Images& images,
                 const NamedParameters& np)
{
  if constexpr(Intrinsic_triangulations::internal::has_parameter<NamedParameters, Tag>()) {
    const auto map = CGAL::parameters::get_parameter(np, Tag());
    typedef typename boost::property_traits<std::decay_t<decltype(map)>>::value_type Value;
    const auto image = images();
    for(Halfedge_index h : part.mesh().halfedges())
      if(part.has(h)) {
        const auto z = image(h);
        put(map, copy.halfedge_of(h),
            made_of<Value>(
              z, std::make_index_sequence<std::tuple_size<std::decay_t<decltype(z)>>::value>()));
      }
  }
}

// Returns whether `np` has texture coordinates.
template <typename NamedParameters>
constexpr bool has_corners()
{
  namespace IT = Intrinsic_triangulations;
  return IT::internal::has_parameter<NamedParameters, internal_np::texture_coordinates_map_t>() ||
         IT::internal::has_parameter<NamedParameters,
                                     internal_np::homogeneous_texture_coordinates_map_t>();
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// adds the common subdivision of the three triangulations of a map to a mesh of any type. Only the
/// part of the input is added, not its second copy. The map is projective on each face. So this
/// mesh with homogeneous texture coordinates is the whole map.
///
/// The vertices of the input come first, in their order, then crossings. Faces are convex polygons,
/// with the orientation of the input. Images are rounded such that no face is reversed, if that is
/// possible (\ref dcm_reversed). Complexity: linear if rounding reverses no face.
///
/// \tparam Map `Planar_conformal_map`, `Hyperbolic_conformal_map` or `Spherical_conformal_map`
/// \tparam Graph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param map the map
/// \param out the mesh; elements that it has are kept
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{input_point_map}
///     \cgalParamDescription{the positions of the vertices of the input}
///     \cgalParamType{a readable property map with `Vertex_index` as key and a point of a kernel as
///                    value, such as `mesh.points()` of a `Surface_mesh` without garbage; for other
///                    graphs, vertices are numbered in the order of `vertices(g)`}
///     \cgalParamDefault{on the unit sphere for a `Spherical_conformal_map`; required otherwise}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the map that gets the positions of the vertices of `out`}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, out)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_vertex_map}
///     \cgalParamDescription{gets the vertex of the input for each vertex of `out`; null for
///       crossings}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key and `Vertex_index` as
///                    value, or `std::array<Vertex_index, 3>` for all three triangulations}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_edge_map}
///     \cgalParamDescription{gets the edge that contains each edge of `out`; null if no edge
///       contains it}
///     \cgalParamType{as before, with edges and `Edge_index`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_face_map}
///     \cgalParamDescription{gets for each face of `out` the face that contains it}
///     \cgalParamType{as before, with faces and `Face_index`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{texture_coordinates_map}
///     \cgalParamDescription{gets for each halfedge of `out` the image of the corner at its target
///       in its face. It is \f$(x, y)\f$ in the plane or the Poincare disk, and \f$(x, y, z)\f$ on
///       the unit sphere. Linear interpolation is exact at vertices, and has the right image of
///       each face. Border halfedges get no value.}
///     \cgalParamType{a writable property map with a halfedge of `Graph` as key and a value type
///       that is made of two (three) `double`, such as `Point_2` of a kernel}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{homogeneous_texture_coordinates_map}
///     \cgalParamDescription{gets these images in the homogeneous coordinates of the map, which are
///       linear on each face. They are \f$(xw, yw, w)\f$ in the plane or in Klein's disk, and
///       \f$(xw, yw, zw, w)\f$ in space}
///     \cgalParamType{as before, with a value type that is made of three (four) `double`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws No_texture_coordinates if texture coordinates are requested of a map that is not laid
///         out; nothing is written then
template <typename Map, typename Graph,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void common_subdivision(const Map& map, Graph& out,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace IT = Intrinsic_triangulations;
  constexpr bool is_spherical = std::is_same_v<Map, Spherical_conformal_map>;
  constexpr bool has_points =
    IT::internal::has_parameter<NamedParameters, internal_np::input_point_map_t>();
  static_assert(has_points || is_spherical, "input_point_map() is missing");
  constexpr bool has_corners = internal::has_corners<NamedParameters>();
  if(has_corners)
    internal::check_layout(map);
  const Input_part part(map);
  const IT::Copied_part copy(part, out);
  IT::write_input_points(
    part, copy, out, [&](Vertex_index v) { return part.input_weights(v); }, np);
  IT::write_parents(part, copy, out, np);
  if constexpr(has_corners || !has_points) {
    const internal::Corner_images<Map> images(map, part);
    if constexpr(!has_points)
      IT::write_points(
        part, copy, out,
        [&](Vertex_index v, auto point) {
          const std::array<double, 3> p = images.at(v);
          return decltype(point)(p[0], p[1], p[2]);
        },
        np);
    internal::put_corners<internal_np::texture_coordinates_map_t>(
      part, copy, [&] { return images.affine(); }, np);
    internal::put_corners<internal_np::homogeneous_texture_coordinates_map_t>(
      part, copy, [&] { return images.homogeneous(); }, np);
  }
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_COMMON_SUBDIVISION_MESH_H
