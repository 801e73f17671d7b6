// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TRIANGULATION_ON_HYPERBOLIC_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TRIANGULATION_ON_HYPERBOLIC_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#if __has_include(<CGAL/Triangulation_on_hyperbolic_surface_2.h>) || defined(DOXYGEN_RUNNING)
#include <CGAL/Triangulation_on_hyperbolic_surface_2.h>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Returns the position of the apex of a face in the Poincare disk. A vertex of the edge is in the
// origin, and the edge is real. `side` leaves this vertex in the face, and `sign` is the side of
// the edge on which the face lies.
inline std::complex<double> apex_seen_from(Halfedge_index side, double sign,
                                           const Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const auto sinh_half = [&](Halfedge_index h) { return std::sinh(map.length(mesh.edge(h)) / 2); };
  const Hyperbolic_triangle<double> face(
    {sinh_half(side), sinh_half(mesh.next(side)), sinh_half(mesh.prev(side))});
  const Halfedge_index to_apex = sign > 0 ? mesh.prev(side) : side;
  return std::polar(std::tanh(map.length(mesh.edge(to_apex)) / 2), sign * face.angle(0));
}

// Returns the cross ratio (d - b) (c - a) / ((d - a) (c - b)) of an edge. It leads from c to a, and
// b and d are the apexes on its left and right. They lie around c in the origin of the disk.
inline std::complex<double> cross_ratio(Halfedge_index h, const Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const std::complex<double> a = std::tanh(map.length(mesh.edge(h)) / 2),
                             b = apex_seen_from(h, 1, map),
                             d = apex_seen_from(mesh.next(mesh.opposite(h)), -1, map);
  return (d - b) * a / ((d - a) * b);
}

// Returns the positions of a face in the disk, with a dart of its first side.
template <typename Traits>
typename CGAL::Triangulation_on_hyperbolic_surface_2<Traits>::Anchor
anchor_of(Face_index f,
          typename CGAL::Triangulation_on_hyperbolic_surface_2<Traits>::Dart_descriptor dart,
          const Hyperbolic_conformal_map& map)
{
  typedef typename Traits::FT FT;
  typename CGAL::Triangulation_on_hyperbolic_surface_2<Traits>::Anchor result;
  result.dart = dart;
  const auto side = sides(f, map.ideal().mesh());
  for(std::size_t k = 0; k < 3; ++k) {
    const std::complex<double> z = map.position(side[k]);
    result.vertices[k] = typename Traits::Hyperbolic_point_2(FT(z.real()), FT(z.imag()));
  }
  return result;
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns \f$T_3\f$ as a triangulation on a hyperbolic surface of CGAL. It represents a component,
/// or the double of a component with boundary. Without circles it is Delaunay up to rounding.
///
/// The function exists if CGAL has the package `Triangulation_on_hyperbolic_surface_2`, since
/// version 6.1.
///
/// Cross ratios of edges are rounded. They are computed from lengths around the edge in double
/// precision, so they do not lose digits far from the origin of the disk. The anchor is the first
/// face, with its positions in the disk. CGAL derives all other positions from cross ratios, and
/// their errors add up. An exact number type represents the rounded numbers.
///
/// \tparam Traits a model of `HyperbolicSurfaceTraits_2`, whose `FT` is constructed from `double`
/// \param map a map that is laid out
/// \param component the component
///
/// Complexity: linear, except for checks of CGAL.
/// \throws Intrinsic_triangulations::Invalid_input if the component has cones, which hyperbolic
///   surfaces of CGAL cannot have
/// \pre `map.is_laid_out()`
template <typename Traits>
CGAL::Triangulation_on_hyperbolic_surface_2<Traits>
triangulation_on_hyperbolic_surface(const Hyperbolic_conformal_map& map, std::size_t component = 0)
{
  typedef CGAL::Triangulation_on_hyperbolic_surface_2<Traits> Triangulation;
  typedef typename Traits::FT FT;
  if(map.group(component).relation.empty())
    throw Intrinsic_triangulations::Invalid_input(
      "a triangulation on a hyperbolic surface has no cones");
  const Delta_complex& mesh = map.ideal().mesh();
  typename Triangulation::Combinatorial_map_with_cross_ratios darts;
  std::vector<typename Triangulation::Dart_descriptor> dart(mesh.number_of_halfedges());
  std::optional<typename Triangulation::Anchor> anchor;
  for(Face_index f : mesh.faces()) {
    if(map.component(f) != component)
      continue;
    auto next = darts.make_combinatorial_polygon(3);
    for(Halfedge_index h : sides(f, mesh)) {
      dart[h.idx()] = next;
      next = darts.template beta<1>(next);
    }
    if(!anchor)
      anchor = internal::anchor_of<Traits>(f, next, map);
  }
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    if(map.component(mesh.face(h)) != component)
      continue;
    const std::complex<double> ratio = internal::cross_ratio(h, map);
    darts.template sew<2>(dart[h.idx()], dart[mesh.opposite(h).idx()]);
    darts.template set_attribute<1>(
      dart[h.idx()], darts.template create_attribute<1>(
                       typename Traits::Complex(FT(ratio.real()), FT(ratio.imag()))));
  }
  return Triangulation(darts, *anchor);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL has hyperbolic surfaces

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TRIANGULATION_ON_HYPERBOLIC_SURFACE_H
