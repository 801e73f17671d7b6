// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/flat_modulus.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/surface_type.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <complex>
#include <optional>
#include <variant>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// the metric of constant curvature of a surface, and its map.
struct Uniformization
{
  /// the topology of the surface, which determines the type of the map
  Surface_type type = Surface_type::sphere;
  /// the map: of a sphere to the sphere, of a disk to a hemisphere, of a torus or an annulus to the
  /// plane. All other surfaces are mapped to the hyperbolic plane
  std::variant<Spherical_conformal_map, Planar_conformal_map, Hyperbolic_conformal_map> map;
  /// the modulus of a torus (see `torus_modulus()`), or the imaginary unit times the modulus of an
  /// annulus (see `annulus_modulus()`), if the map is a success
  std::optional<std::complex<double>> modulus;

  /// returns the map to the sphere, or null if `map` is another one.
  const Spherical_conformal_map* spherical() const
  {
    return std::get_if<Spherical_conformal_map>(&map);
  }
  /// returns the map to the plane, or null if `map` is another one.
  const Planar_conformal_map* flat() const { return std::get_if<Planar_conformal_map>(&map); }
  /// returns the map to the hyperbolic plane, or null if `map` is another one.
  const Hyperbolic_conformal_map* hyperbolic() const
  {
    return std::get_if<Hyperbolic_conformal_map>(&map);
  }

  /// returns the status of the map.
  Map_status status() const
  {
    return std::visit([](const auto& any) { return any.status(); }, map);
  }
};

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// gives a surface the discretely conformal metric of constant curvature that its topology allows.
/// A sphere becomes round, a disk a hemisphere, a torus flat, and an annulus a flat cylinder. All
/// surfaces with more handles or boundaries become hyperbolic. Boundaries become geodesics. The
/// hemisphere is the unit disk of the Riemann mapping theorem:
/// `Spherical_conformal_map::to_plane()`.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a connected manifold triangle mesh
/// \param np the parameters of `uniformize_hyperbolic()` other than `vertex_condition_map`. A
///        `minimizer` is for surfaces that become flat or hyperbolic; scale factors on the sphere
///        have bounds, which `Bounded_Newton_minimizer` keeps.
///
/// Complexity: the complexity of `map_to_sphere()`, `flatten()` or `uniformize_hyperbolic()`. These
/// functions throw further exceptions.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not connected
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Uniformization uniformize(const Graph& g,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  Uniformization result;
  result.type = surface_type(g);
  switch(result.type) {
    case Surface_type::sphere:
    case Surface_type::disk: result.map = map_to_sphere(g, np); break;
    case Surface_type::hyperbolic: result.map = uniformize_hyperbolic(g, np); break;
    default:
      auto straight = boost::make_function_property_map<Vertex>(
        [](Vertex) { return Vertex_condition::curvature(0); });
      typedef internal_np::Named_parameters<decltype(straight), internal_np::vertex_condition_map_t,
                                            NamedParameters>
        Parameters;
      result.map = flatten(g, Parameters(straight, np));
      if(result.status() == Map_status::success)
        result.modulus = result.type == Surface_type::torus
                           ? torus_modulus(*result.flat())
                           : std::complex<double>(0, annulus_modulus(*result.flat()));
  }
  return result;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_H
