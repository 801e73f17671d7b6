// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLAT_MODULUS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLAT_MODULUS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Returns the translations that glue the seams of a flat surface without cones, the shortest first.
// Rounding errors of the identity do not count.
inline std::vector<std::complex<double>> seam_translations(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<std::complex<double>> result;
  double longest = 0;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    if(!map.is_seam(e) || !map.is_laid_out(mesh.face(h)) || !map.is_laid_out(mesh.face(o)))
      continue;
    result.push_back(map.position(h) - map.position(mesh.next(o)));
    longest = (std::max)(longest, std::abs(result.back()));
  }
  const auto is_none = [&](const auto& t) {
    return !(std::abs(t) > tolerance::translation * longest);
  };
  result.erase(std::remove_if(result.begin(), result.end(), is_none), result.end());
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& s, const auto& t) { return std::abs(s) < std::abs(t); });
  return result;
}

// Returns whether the axis of a flat double, which contains the boundary, cuts a face that is laid
// out. The axis is straight, so a cut face has vertices on both sides.
inline bool is_cut_by_axis(Face_index f, const Planar_conformal_map& map)
{
  const auto h = sides(f, map.ideal().mesh());
  return std::any_of(h.begin(), h.end(), [&](Halfedge_index x) {
    const Vertex_index v = map.ideal().mesh().source(x);
    return map.input_vertex(v) != v;
  });
}

// Returns the area of a flat surface with straight boundaries, without the second copy, which may
// exist only partly. Faces that the axis cuts are symmetric to it, in pairs or alone.
inline double flat_area(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const auto length = [&](Halfedge_index h) { return map.scaled_length(h); };
  double result = 0;
  for(Face_index f : mesh.faces()) {
    if(!map.is_laid_out(f))
      continue;
    const auto h = sides(f, mesh);
    const double area =
      Intrinsic_triangulations::quadrupled_area(length(h[0]), length(h[1]), length(h[2])) / 4;
    result += is_cut_by_axis(f, map) ? area / 2 : area;
  }
  return result;
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns the modulus of a flat torus: the quotient \f$\tau\f$ of two translations that generate
/// its lattice, with \f$|\tau| \ge 1\f$, \f$-\frac12 \le \mathrm{Re}\,\tau \le \frac12\f$ and
/// \f$\mathrm{Im}\,\tau > 0\f$. It is unique inside this domain. Complexity:
/// \f$O(n \log n)\f$.
/// \pre `map` is a map of one torus without cones.
inline std::complex<double> torus_modulus(const Planar_conformal_map& map)
{
  const std::vector<std::complex<double>> translation = internal::seam_translations(map);
  CGAL_precondition(!translation.empty());
  std::complex<double> a = translation.front(), b = 0;
  // Translations along the seams have two generators, and possibly their sum.
  for(const auto& t : translation)
    if(b == 0. && std::abs((t / a).imag()) > internal::tolerance::translation)
      b = t;
  CGAL_precondition(b != 0.);
  do { // Lagrange's reduction
    if(std::abs(b) < std::abs(a))
      std::swap(a, b);
    b -= std::round((b / a).real()) * a;
  } while(std::abs(b) < std::abs(a));
  const std::complex<double> tau = b / a;
  return tau.imag() > 0 ? tau : -tau;
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns the modulus of a flat annulus with straight boundaries, a cylinder: its height, divided
/// by its circumference. Complexity: linear.
/// \pre `map` is a map of one annulus with curvature zero everywhere.
inline double annulus_modulus(const Planar_conformal_map& map)
{
  const std::vector<double> length = internal::flat_boundary_lengths(map);
  const double circumference = std::accumulate(length.begin(), length.end(), 0.) / 2;
  return internal::flat_area(map) / (circumference * circumference);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLAT_MODULUS_H
