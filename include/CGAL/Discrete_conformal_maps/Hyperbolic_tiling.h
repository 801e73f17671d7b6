// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TILING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TILING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Disk_motion.h>
#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// the domain of a component of a hyperbolic map, and its images. They tile the Poincare disk if
/// the component has no cones.
class Hyperbolic_tiling
{
public:
  /// an image of the domain.
  struct Tile
  {
    Disk_motion<> motion; ///< the motion from the domain to this image
    int depth;            ///< the number of sides between the domain and this image
  };

  /// makes the tiling of one component of `map`. Complexity: linear.
  Hyperbolic_tiling(const Hyperbolic_conformal_map& map, std::size_t component)
  {
    const Delta_complex& mesh = map.ideal().mesh();
    for(Halfedge_index h : mesh.halfedges())
      if(map.component(mesh.face(h)) == component && map.is_seam(mesh.edge(h))) {
        if(m_corners.empty())
          follow_boundary(map, h);
        add_side(map.gluing(h));
      }
  }

  /// returns the vertices on the boundary of the domain, counterclockwise. Geodesics join
  /// consecutive vertices.
  const std::vector<std::complex<double>>& corners() const { return m_corners; }

  /// returns the motions to the images beyond the sides of the domain, one for each side.
  const std::vector<Disk_motion<>>& side_motions() const { return m_sides; }

  /// returns the domain, then its images across up to `depth` sides, each once. Images whose center
  /// is closer to the boundary of the disk than `margin` are left out.
  ///
  /// Complexity: quadratic in the number of tiles.
  std::vector<Tile> tiles(int depth, double margin = 1e-3) const
  {
    std::vector<Tile> result{{Disk_motion<>(), 0}};
    for(std::size_t i = 0; i < result.size() && result[i].depth < depth; ++i)
      for(const Disk_motion<>& side : m_sides) {
        const Tile tile{result[i].motion * side, result[i].depth + 1};
        const std::complex<double> center = tile.motion(0);
        const auto is_known = [&](const Tile& t) { return are_close(t.motion(0), center); };
        if(std::abs(center) < 1 - margin && std::none_of(result.begin(), result.end(), is_known))
          result.push_back(tile);
      }
    return result;
  }

private:
  // Returns whether two points are close in the hyperbolic plane. Images of a point inside the
  // domain are much farther apart.
  static bool are_close(const std::complex<double>& z, const std::complex<double>& w)
  {
    return std::abs(z - w) < 1e-6 * std::abs(1. - std::conj(z) * w);
  }

  void follow_boundary(const Hyperbolic_conformal_map& map, Halfedge_index start)
  {
    const Delta_complex& mesh = map.ideal().mesh();
    Halfedge_index h = start;
    do {
      m_corners.push_back(map.position(h));
      h = mesh.next(h);
      while(!map.is_seam(mesh.edge(h)))
        h = mesh.next(Intrinsic_triangulations::opposite(h));
    } while(h != start);
  }

  // Adds a side. All edges along one side have one motion.
  void add_side(const Disk_motion<>& motion)
  {
    const auto is_known = [&](const Disk_motion<>& m) { return are_close(m(0), motion(0)); };
    if(std::none_of(m_sides.begin(), m_sides.end(), is_known))
      m_sides.push_back(motion);
  }

  std::vector<std::complex<double>> m_corners;
  std::vector<Disk_motion<>> m_sides;
};

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the center \f$c\f$ of the circle that contains the geodesic through the points `z` and
/// `w` of the Poincare disk. It is not finite if the geodesic is a diameter. The radius is
/// \f$\sqrt{|c|^2 - 1}\f$. Complexity: constant.
inline std::complex<double> geodesic_center(const std::complex<double>& z,
                                            const std::complex<double>& w)
{
  // The circle meets the unit circle at right angles: 2 Re(c conj(p)) = 1 + |p|^2 for both points.
  const double det = z.real() * w.imag() - w.real() * z.imag();
  const double a = 1 + std::norm(z), b = 1 + std::norm(w);
  return std::complex<double>(a * w.imag() - b * z.imag(), b * z.real() - a * w.real()) / (2 * det);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TILING_H
