// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/certify_order_of_ends.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Intrinsic_triangulations/certify_ideal_Delaunay.h>

#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMaps
/// the results of exact decisions about the triangulations of a map.
struct Map_certificate
{
  /// whether \f$T_2\f$ is ideal Delaunay with its lengths
  Intrinsic_triangulations::Ideal_Delaunay_certificate on_B;
  /// whether \f$T_3\f$ is ideal Delaunay with the scale factors
  Intrinsic_triangulations::Ideal_Delaunay_certificate on_C;
  /// whether the ends of edges of \f$T_1\f$ and \f$T_3\f$ on edges of \f$T_2\f$ are in order
  Order_certificate order;

  /// returns whether both triangulations are ideal Delaunay, and the connectivity of the
  /// subdivision is exact.
  bool is_certified() const { return on_B.is_Delaunay() && on_C.is_Delaunay() && order.is_exact(); }
};

/// \ingroup PkgDiscreteConformalMapsMaps
/// decides exactly, without a tolerance, whether the triangulations of a map are ideal Delaunay,
/// and whether their common subdivision is exact. The map leads to the plane, the sphere or the
/// hyperbolic plane.
///
/// The exact numbers are numbers of type `double` in the map. They are the lengths of \f$T_1\f$,
/// the lengths of \f$T_2\f$ as Penner lengths, and the rounded factors \f$s_i = e^{u_i/2}\f$. The
/// lengths of \f$T_3\f$ are derived from \f$T_2\f$
/// (`Intrinsic_triangulations::certify_ideal_Delaunay()`), and multiplied by \f$s_i s_j\f$.
/// `certify_order_of_ends()` decides the order of ends.
///
/// `Intrinsic_triangulations::certify_Delaunay()` of `Discrete_conformal_map::Delaunay()` decides
/// whether \f$T_2\f$ is the intrinsic Delaunay triangulation of \f$T_1\f$.
///
/// The decisions of the map itself have a one-sided tolerance. So an edge can fail by about
/// \f$10^{-14}\f$ (`Intrinsic_triangulations::Ideal_Delaunay_certificate::greatest_excess`), and in
/// a fixed triangulation by any amount.
///
/// Complexity: usually linear in the edges and crossings.
/// \throws Intrinsic_triangulations::Invalid_input if there are circles at the vertices
/// \throws Intrinsic_triangulations::Overflow_error if there are more crossings than a
///         `Surface_mesh` can number
inline Map_certificate certify(const Discrete_conformal_map& map)
{
  if(map.has_radii())
    throw Intrinsic_triangulations::Invalid_input(
      "a map with circles cannot be certified: decisions depend on square roots of square roots");
  const auto& ideal = map.ideal();
  const Delta_complex& mesh_B = ideal.input_mesh();
  std::vector<double> factor;
  for(Vertex_index v : mesh_B.vertices())
    factor.push_back(internal::length_factor(map.log_scale(v)));
  Map_certificate result;
  result.on_B = Intrinsic_triangulations::internal::Ideal_Delaunay_certifier(
    mesh_B, std::vector<double>(factor.size(), 1.),
    [&](Edge_index e) {
      return Intrinsic_triangulations::internal::Filter_interval(ideal.input_length(e));
    },
    [&](Edge_index e) { return Intrinsic_triangulations::Exact_field(ideal.input_length(e)); })(
    [](Edge_index) { return false; });
  result.on_C = Intrinsic_triangulations::certify_ideal_Delaunay(ideal, factor);
  result.order = certify_order_of_ends(map.subdivision(), map.Delaunay_correspondence(),
                                       map.ideal_correspondence());
  return result;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CERTIFY_H
