// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_SPHERICAL_CONFORMAL_MAP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_SPHERICAL_CONFORMAL_MAP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Convexity_certificate.h>
#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Holds the positions of the vertices of a sphere or of a doubled disk.
struct Spherical_layout
{
  bool exists = false, is_disk = false, is_flat = false;
  bool is_extended = false; // whether more digits than those of `double` were needed
  Vertex_index at_infinity;
  std::vector<std::array<Double_double, 2>> in_plane;
  std::vector<std::array<double, 3>> position; // on the unit sphere
  Convexity_certificate certificate;
  std::size_t lost_in_output = 0, bound_violations = 0;

  template <typename Number>
  std::array<Number, 3> position_in(Vertex_index v) const
  {
    if(v == at_infinity)
      return turned<Number>({Number(0), Number(0), Number(-1)});
    const auto number = [](const Double_double& x) {
      return Number(Number(x.high()) + Number(x.low()));
    };
    const Number x = number(in_plane[v.idx()][0]), y = number(in_plane[v.idx()][1]),
                 square = x * x + y * y, scale = 1 / (1 + square);
    return turned<Number>({2 * x * scale, 2 * y * scale, (1 - square) * scale});
  }

  // Rounds the positions of the vertices of `mesh`.
  void round_positions(const Delta_complex& mesh)
  {
    for(Vertex_index v : mesh.vertices()) {
      const auto p = position_in<Double_double>(v);
      position.push_back({p[0].high(), p[1].high(), p[2].high()});
    }
  }

  double max_inscribed_error() const
  {
    double result = 0;
    for(const auto& p : position)
      result = (std::max)(result, std::abs(std::hypot(p[0], p[1], p[2]) - 1));
    return result;
  }

private:
  // Turns a point. For a disk, the mirror plane becomes the plane of the equator.
  template <typename Number>
  std::array<Number, 3> turned(const std::array<Number, 3>& p) const
  {
    return is_disk ? std::array<Number, 3>{p[2], p[0], p[1]} : p;
  }
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSphere
/// a discrete conformal map of a sphere, or of a disk to a hemisphere (Section 4.4). It has three
/// triangulations with the correspondence of each to the next, scale factors, and positions on the
/// unit sphere.
///
/// \f$T_1\f$ is the input; a disk is doubled (see `Discrete_conformal_map`). \f$T_2\f$ is the
///   intrinsic Delaunay triangulation of \f$T_1\f$. \f$T_3\f$ has the same ideal polyhedron as
///   \f$T_2\f$. Its faces form a convex polyhedron with vertices on the unit sphere and with
///   lengths \f$e^{(u_i+u_j)/2}\ell_{ij}\f$, which is unique up to Moebius transformations. The
///   center of mass of the vertices is the center of the sphere, so the polyhedron is unique up to
///   rotations. The mass of a vertex is a third of the area of its faces in the input. If loops
///   give one vertex more than 45 percent of the mass, the same mass is added to all vertices until
///   it has 45 percent. The vertex from which the sphere was unfolded has the position (0, 0, -1).
///
/// The image of a disk is the upper hemisphere, and its boundary is the equator. A vertex of the
/// boundary has the position (-1, 0, 0). If all vertices of a disk are on the boundary, the image
/// is a flat polygon in the plane of the equator (`is_flat()`). 32 digits may be too few to
/// distinguish its vertices around the center of mass. Then the two ends of the disk that are
/// farthest from each other become antipodal. The polyhedron of a sphere can also be a flat polygon
/// with two sides.
///
/// With circles at the vertices, positions are the centers of circles on the sphere, and their
/// center of mass is the center of the sphere. The vertices of the polyhedron are the poles of the
/// circles, see \ref dcm_spherical_circles. The certificate counts edges that measurements find
/// concave.
///
/// An isolated vertex of the input has the position (0, 0, 1), or (1, 0, 0) beside a disk, and the
/// logarithmic scale factor zero.
///
/// Images of long limbs can be smaller than the spacing of numbers of type `double`;
/// `lost_in_output()` counts such triangles. The map stores positions with 32 digits. Differences
/// of positions have 32 digits relative to the image of infinity.
class Spherical_conformal_map : public Discrete_conformal_map
{
public:
  /// a point in space.
  typedef std::array<double, 3> Point;
  /// a number with twice the digits of `double`.
  typedef Intrinsic_triangulations::Double_double Double_double;
  /// \deprecated Use `Double_double`.
  [[deprecated("use Double_double")]] typedef Double_double Extended;

  /// \cond SKIP_IN_MANUAL
  Spherical_conformal_map() = default;
  Spherical_conformal_map(std::unique_ptr<const internal::Map_data> data,
                          internal::Spherical_layout layout)
    : Discrete_conformal_map(std::move(data)), m_layout(std::move(layout))
  {}
  /// \endcond

  /// returns whether the input is a disk.
  bool is_disk() const { return m_layout.is_disk; }

  /// returns whether the image is a convex polygon inscribed in a great circle. It is inscribed in
  /// the equator if the input is a disk without inner vertices. It has two sides if the input is a
  /// sphere.
  bool is_flat() const { return m_layout.is_flat; }

  /// returns whether vertices have positions. They have none if the scale factors have not been
  /// found, or if numbers have too few digits for a layout.
  bool is_laid_out() const { return m_layout.exists; }

  /// returns the vertex from which the sphere was unfolded into the plane.
  Vertex_index vertex_at_infinity() const { return m_layout.at_infinity; }

  /// returns the position of `v` on the unit sphere, rounded to `double`.
  /// \pre `is_laid_out()`
  const Point& position(Vertex_index v) const { return m_layout.position[v.idx()]; }

  /// returns the angle between the center and the circle at `v` on the unit sphere. It is zero if
  /// no radii were given. The center of the circle is `position(v)`.
  double circle_radius(Vertex_index v) const { return std::atan(scaled_radius(v)); }

  /// returns the position of `v` on the unit sphere, in more digits.
  std::array<Double_double, 3> precise_position(Vertex_index v) const
  {
    return position_in<Double_double>(v);
  }

  /// returns the point of the unit sphere whose stereographic projection is
  /// `stereographic_position(v)`, up to a few roundings of `Number`. As a point of the polyhedron
  /// it is as accurate as the scale factors, see `max_curvature_error()`.
  /// \tparam Number a floating point type, of any precision
  template <typename Number>
  std::array<Number, 3> position_in(Vertex_index v) const
  {
    return m_layout.position_in<Number>(v);
  }

  /// returns the position of `v` in the plane: the stereographic projection, from the vertex at
  /// infinity, of its position on the sphere. It is unspecified for the vertex at infinity.
  const std::array<Double_double, 2>& stereographic_position(Vertex_index v) const
  {
    return m_layout.in_plane[v.idx()];
  }

  /// returns the certificate of exact predicates about the polyhedron with the stored positions in
  /// the plane.
  const Convexity_certificate& certificate() const { return m_layout.certificate; }

  /// returns the number of faces of \f$T_3\f$ that are reversed as seen from the center, or have an
  /// edge that is not convex. Vertices are at `position()`; the number is exact for these rounded
  /// numbers. Edges between parts of one flat face may be concave by rounding, and count. Faces of
  /// a disk count if they have an inner vertex. Faces of a flat image count if they have no area.
  /// If the input is a disk, they also count if they are reversed in its plane.
  std::size_t lost_in_output() const { return m_layout.lost_in_output; }

  /// returns the greatest distance of a `position()` from the sphere.
  double max_inscribed_error() const { return m_layout.max_inscribed_error(); }

  /// returns the number of vertices that violate a bound of Section 4.4.3. Their scale factors are
  /// too small or, at neighbors of the vertex at infinity, too great.
  std::size_t bound_violations() const { return m_layout.bound_violations; }

  /// returns whether `double` had too few digits.
  bool is_extended() const { return m_layout.is_extended; }

  /// returns the homogeneous coordinates of a point of the polyhedron, as a vector
  /// `(x w, y w, z w, w)`. They are linear on the faces of the common subdivision (Section 4.4.6).
  /// \param on_C a face of \f$T_3\f$ and weights of its corners, such as
  ///        `Triple_subdivision::location()` gives
  std::array<double, 4> homogeneous_coordinates(const Face_location& on_C) const
  {
    const Delta_complex& mesh = ideal().mesh();
    const auto side = sides(on_C.first, mesh);
    const std::array<double, 3> weight = homogeneous_weights(on_C);
    std::array<double, 4> result{0, 0, 0, 0};
    for(std::size_t s = 0; s < 3; ++s) {
      const Vertex_index v = mesh.source(side[s]);
      const double distance = std::hypot(1, scaled_radius(v)); // of the vertex from the center
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += weight[s] * distance * position(v)[c];
      result[3] += weight[s];
    }
    return result;
  }

  /// returns the image of a point of the polyhedron with these homogeneous coordinates. It is on
  /// the sphere, computed by `project()`, or on the polygon if `is_flat()`.
  Point image(const std::array<double, 4>& homogeneous) const
  {
    const auto& [x, y, z, w] = homogeneous;
    return is_flat() ? Point{x / w, y / w, z / w} : project(homogeneous);
  }

  /// returns the image of a point of the polyhedron on the sphere, along the ray from the center.
  static Point project(const std::array<double, 4>& homogeneous)
  {
    const double norm = std::hypot(homogeneous[0], homogeneous[1], homogeneous[2]);
    return {homogeneous[0] / norm, homogeneous[1] / norm, homogeneous[2] / norm};
  }

  /// returns the image of a point of the sphere in the plane, by stereographic projection from (0,
  /// 0, -1). The image of a disk is the unit disk.
  /// \pre the third coordinate of `p` is greater than -1
  static std::complex<double> to_plane(const Point& p)
  {
    return std::complex<double>(p[0], p[1]) / (1 + p[2]);
  }

  /// returns the image of a point of the input, by piecewise projective interpolation: on the
  /// sphere, or on the polygon if `is_flat()`. Complexity: see `place_on_C()`.
  template <typename Place = Face_location>
  Point operator()(const Place& p) const
  {
    return image(homogeneous_coordinates(place_on_C(p)));
  }

private:
  internal::Spherical_layout m_layout;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_SPHERICAL_CONFORMAL_MAP_H
