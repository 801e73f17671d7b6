// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLAT_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLAT_FACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename FT>
FT dot(const std::complex<FT>& v, const std::complex<FT>& w)
{
  return v.real() * w.real() + v.imag() * w.imag();
}

template <typename FT>
FT cross(const std::complex<FT>& v, const std::complex<FT>& w)
{
  return v.real() * w.imag() - v.imag() * w.real();
}

// This is faster than std::abs(), which prevents squares out of range.
template <typename FT>
FT norm_of(const std::complex<FT>& v)
{
  return CGAL::sqrt(dot(v, v));
}

template <typename FT>
std::complex<FT> normalized(const std::complex<FT>& v)
{
  return v / norm_of(v);
}

// Returns the distance of 0 from the segment between two points.
template <typename FT>
FT distance_from_segment(const std::complex<FT>& p, const std::complex<FT>& q)
{
  const std::complex<FT> d = q - p;
  const FT squared = dot(d, d);
  const FT t = squared > 0 ? std::clamp<FT>(-dot(p, d) / squared, FT(0), FT(1)) : FT(0);
  return norm_of(p + t * d);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// the lengths of the sides of a face, and quantities that follow from them. Side `s` leads from
/// corner `s` to the next; side 0 is any halfedge of the face.
/// \tparam FT the number type of lengths
template <typename FT>
class Face_metric
{
public:
  /// measures the face of `h`. Side 0 is `h`.
  /// \tparam Surface a model of `IntrinsicSurface`
  template <typename Surface>
  Face_metric(Halfedge_index h, const Surface& surface)
    : m_length(internal::side_lengths(h, surface)),
      m_quadrupled_area(
        Intrinsic_triangulations::quadrupled_area(m_length[0], m_length[1], m_length[2]))
  {}

  /// measures the face `f`. Side 0 is `halfedge(f)`.
  template <typename Surface>
  Face_metric(Face_index f, const Surface& surface)
    : Face_metric(surface.mesh().halfedge(f), surface)
  {}

  /// returns the length of side `s`.
  const FT& length(std::size_t s) const { return m_length[s]; }
  /// returns the length up to which lengths are rounding error.
  FT tolerance() const { return rounding_unit<FT>() * (m_length[0] + m_length[1] + m_length[2]); }
  /// returns the product of the three lengths.
  FT product() const { return m_length[0] * m_length[1] * m_length[2]; }
  /// returns the area.
  FT area() const { return m_quadrupled_area / 4; }
  /// returns twice the area.
  FT doubled_area() const { return m_quadrupled_area / 2; }
  /// returns four times the area.
  const FT& quadrupled_area() const { return m_quadrupled_area; }
  /// returns the radius of the circumcircle.
  FT circumradius() const { return product() / m_quadrupled_area; }

  /// returns the integral of the product of the hat functions of corners `a` and `b`.
  FT hat_product(std::size_t a, std::size_t b) const { return area() / (a == b ? 6 : 12); }

  /// returns twice the scalar product of the sides at the corner opposite to side `s`.
  FT corner_product(std::size_t s) const
  {
    return doubled_corner_product(m_length[s], m_length[(s + 1) % 3], m_length[(s + 2) % 3]);
  }

  /// returns the cotangent of the corner opposite to side `s`.
  FT cotangent(std::size_t s) const { return corner_product(s) / m_quadrupled_area; }

  /// returns side `s` turned counterclockwise by a right angle, with side 0 on the x-axis. This is
  /// the gradient of the hat function of the opposite corner, times the doubled area.
  std::array<FT, 2> turned_side(std::size_t s) const
  {
    const FT width = 2 * m_length[0], height = m_quadrupled_area / width;
    if(s == 0)
      return {FT(0), m_length[0]};
    if(s == 1)
      return {-height, -corner_product(2) / width};
    return {height, -corner_product(1) / width};
  }

private:
  std::array<FT, 3> m_length;
  FT m_quadrupled_area;
};

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// a face that is laid out in the plane, with one of its halfedges on the x-axis. The directions of
/// its sides come from the corner angles, and its points have barycentric coordinates. So no
/// position is subtracted from another.
/// \tparam FT a floating point type
template <typename FT>
class Flat_face : public Face_metric<FT>
{
  typedef Face_metric<FT> Base;

public:
  /// a vector of the plane.
  typedef std::complex<FT> Vector;
  /// barycentric coordinates: coordinate `k` belongs to the source of side `k`.
  typedef std::array<FT, 3> Place;

  /// the point at which a ray leaves the face: on side `index`, or at corner `index`.
  struct Exit
  {
    bool is_corner;    ///< whether it is a corner
    std::size_t index; ///< of the side, or of the corner
    Place place;       ///< its coordinates
    FT distance;       ///< from the start of the ray
  };

  /// lays out the face of `h`, with `h` on the x-axis.
  template <typename Surface>
  Flat_face(Halfedge_index h, const Surface& surface)
    : Base(h, surface), m_direction{Vector(1), -std::conj(turn(1)), -turn(0)}
  {}

  /// returns the unit vector along side `s`.
  const Vector& direction(std::size_t s) const { return m_direction[s]; }

  /// returns the vector along side `s`.
  Vector side(std::size_t s) const { return this->length(s) * m_direction[s]; }

  /// returns the vector from the point `p` to corner `k`.
  Vector to_corner(std::size_t k, const Place& p) const
  {
    const std::size_t before = (k + 2) % 3;
    return p[before] * side(before) - p[(k + 1) % 3] * side(k);
  }

  /// returns the vector from `p` to `q`.
  Vector between(const Place& p, const Place& q) const
  {
    return (q[1] - p[1]) * side(0) - (q[2] - p[2]) * side(2);
  }

  /// returns the point at which the ray from `p` with unit direction `d` leaves the face.
  Exit exit(const Place& p, const Vector& d) const
  {
    std::array<FT, 3> left, ahead; // how far corner k is to the left of the ray and along it
    for(std::size_t k = 0; k < 3; ++k) {
      const Vector v = to_corner(k, p);
      left[k] = internal::cross(d, v);
      ahead[k] = internal::dot(d, v);
    }
    const std::size_t corner = corner_hit(left, ahead);
    return corner < 3 ? corner_exit(corner, ahead[corner]) : side_exit(left, ahead, d);
  }

private:
  // Returns the rotation by the angle at corner `k`.
  Vector turn(std::size_t k) const
  {
    return internal::normalized(Vector(this->corner_product((k + 1) % 3), this->quadrupled_area()));
  }

  // Returns the nearest corner on the ray, or 3 if none is on the ray.
  std::size_t corner_hit(const std::array<FT, 3>& left, const std::array<FT, 3>& ahead) const
  {
    std::size_t result = 3;
    for(std::size_t k = 0; k < 3; ++k)
      if(ahead[k] > 0 && CGAL::abs(left[k]) <= this->tolerance() &&
         (result == 3 || ahead[k] < ahead[result]))
        result = k;
    return result;
  }

  static Exit corner_exit(std::size_t k, const FT& distance)
  {
    Exit result{true, k, {FT(0), FT(0), FT(0)}, distance};
    result.place[k] = FT(1);
    return result;
  }

  // Returns the side through which the ray leaves. Its source is on the right of the ray, and its
  // target is on the left. If rounding leaves a choice, a side other than side 0 is preferred,
  // because the ray mostly enters through side 0.
  static std::size_t side_crossed(const std::array<FT, 3>& left)
  {
    const auto margin = [&](std::size_t s) { return (std::min)(-left[s], left[(s + 1) % 3]); };
    std::size_t result = margin(2) > margin(1) ? 2 : 1;
    return margin(0) > margin(result) ? 0 : result;
  }

  // Returns the exit through a side, with the distance of the rounded position. This is stable for
  // sides almost along the ray.
  Exit side_exit(const std::array<FT, 3>& left, const std::array<FT, 3>& ahead,
                 const Vector& d) const
  {
    const std::size_t s = side_crossed(left), next = (s + 1) % 3;
    const FT to_source = (std::max)(-left[s], FT(0)), to_target = (std::max)(left[next], FT(0));
    const FT sum = to_source + to_target, t = sum > 0 ? to_source / sum : FT(0);
    Exit result{false, s, {FT(0), FT(0), FT(0)}, ahead[s] + t * internal::dot(d, side(s))};
    result.place[s] = sum > 0 ? to_target / sum : FT(1);
    result.place[next] = t;
    result.distance = (std::max)(result.distance, FT(0));
    return result;
  }

  std::array<Vector, 3> m_direction;
};

namespace internal {

template <typename Surface>
Length_of<Surface> angle_at_source(Halfedge_index h, const Surface& surface)
{
  const Delta_complex& mesh = surface.mesh();
  return corner_angle<Length_of<Surface>>(edge_length(mesh.next(h), surface),
                                          edge_length(h, surface),
                                          edge_length(mesh.prev(h), surface));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLAT_FACE_H
