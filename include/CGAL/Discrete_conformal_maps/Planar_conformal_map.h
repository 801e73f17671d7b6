// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/Plane_picture.h>

#include <array>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// a discrete conformal map of a surface to the plane (Section 4.3). It has three triangulations
/// with the correspondence of each to the next, scale factors, and the faces of \f$T_3\f$ in the
/// plane. With a fixed triangulation, all three are the same. The faces of \f$T_3\f$ are flat.
/// Adjacent faces are laid out side by side, except at seams.
///
/// Every component of the input is one chart. Without prescribed scale factors and placed cones, it
/// has the same area as the component. Charts stand side by side and do not overlap each other.
/// Their smallest rectangles are parallel to the axes, and the first rectangle begins at the
/// origin.
class Planar_conformal_map : public Discrete_conformal_map
{
public:
  /// \cond SKIP_IN_MANUAL
  Planar_conformal_map() = default;
  Planar_conformal_map(std::unique_ptr<const internal::Map_data> data,
                       std::vector<Vertex_index> cones, internal::Planar_layout layout)
    : Discrete_conformal_map(std::move(data)),
      m_cones(std::move(cones)),
      m_layout(std::move(layout))
  {}

  internal::Plane_picture picture() const { return {data(), m_layout}; }
  /// \endcond

  /// returns the vertices of the input at which cones were placed.
  const std::vector<Vertex_index>& cones() const { return m_cones; }

  /// returns whether the faces of \f$T_3\f$ have positions in the plane. In a fixed triangulation
  /// they have none if scaled lengths violate the triangle inequality.
  bool is_laid_out() const { return m_layout.exists; }

  /// returns whether the face `f` of \f$T_3\f$ has a position in the plane: `is_laid_out()` holds,
  /// and a part of it belongs to the input. A null face, beyond a border, has none.
  bool is_laid_out(Face_index f) const
  {
    return f.is_valid() && m_layout.is_laid_out[f.idx()] != 0;
  }

  /// returns the position of the source of `h`, a halfedge of \f$T_3\f$, in the face of `h`.
  /// \pre The face is laid out.
  std::complex<double> position(Halfedge_index h) const { return m_layout.position[h.idx()]; }

  /// returns the radius of the circle at `v` in the plane: \f$e^{u}\f$ times the radius that was
  /// given, or zero if no radii were given. `scale()` multiplies it.
  double scaled_radius(Vertex_index v) const
  {
    return m_layout.scale * Discrete_conformal_map::scaled_radius(v);
  }

  /// returns whether the two faces of the edge `e` of \f$T_3\f$ lie apart in the plane. This also
  /// holds if a face is not laid out, since it is not a part of the input.
  bool is_seam(Edge_index e) const { return m_layout.is_seam[e.idx()] != 0; }

  /// returns the homogeneous coordinates of a point, as a vector `(x w, y w, w)`. They are linear
  /// on the faces of the common subdivision.
  /// \param on_C a face of \f$T_3\f$ and weights of its corners, such as
  ///        `Triple_subdivision::location()` gives
  std::array<double, 3> homogeneous_coordinates(const Face_location& on_C) const
  {
    const Delta_complex& mesh = ideal().mesh();
    std::array<double, 3> result{0, 0, 0};
    const auto side = sides(on_C.first, mesh);
    const std::array<double, 3> weight = homogeneous_weights(on_C);
    for(std::size_t s = 0; s < 3; ++s) {
      const double w = weight[s];
      const std::complex<double> z = position(side[s]);
      result[0] += w * z.real();
      result[1] += w * z.imag();
      result[2] += w;
    }
    return result;
  }

  /// returns the point of the plane with these homogeneous coordinates.
  static std::complex<double> to_plane(const std::array<double, 3>& z)
  {
    return std::complex<double>(z[0], z[1]) / z[2];
  }

  /// returns the image of the corner at the target of `h`, a halfedge of `subdivision()`.
  /// \pre The face of `h` is a part of the input, and `is_laid_out()`.
  std::complex<double> image(Halfedge_index h) const
  {
    return to_plane(homogeneous_coordinates(subdivision().location(Layer::C, h)));
  }

  /// returns the image of a point of the input, by piecewise projective interpolation (Section
  /// 4.2.3). At a seam, it is the image in one of the faces. Complexity: see `place_on_C()`.
  /// \pre `is_laid_out()`
  template <typename Place = Face_location>
  std::complex<double> operator()(const Place& p) const
  {
    return to_plane(homogeneous_coordinates(place_on_C(p)));
  }

  /// moves faces in the plane. Adjacent faces without a seam between them must remain adjacent.
  /// Complexity: linear.
  /// \param motion a function that returns the new position of the source of a halfedge of
  ///        \f$T_3\f$ in its face, from the halfedge and the position
  template <typename Motion>
  void transform(const Motion& motion)
  {
    for(Halfedge_index h : ideal().mesh().halfedges())
      if(is_laid_out(ideal().mesh().face(h)))
        m_layout.position[h.idx()] = motion(h, m_layout.position[h.idx()]);
  }

  /// multiplies all positions, and the radii of circles, by a positive factor. Complexity: linear.
  void scale(double factor)
  {
    transform([factor](Halfedge_index, const std::complex<double>& z) { return factor * z; });
    m_layout.scale *= factor;
  }

  /// makes edges seams, so that their faces can be moved apart. Complexity: linear.
  /// \param is_to_be_seam a function that determines whether an edge of \f$T_3\f$ without seam
  ///        becomes one
  template <typename Predicate>
  void add_seams(const Predicate& is_to_be_seam)
  {
    for(Edge_index e : ideal().mesh().edges())
      if(!is_seam(e) && is_to_be_seam(e))
        m_layout.is_seam[e.idx()] = 1;
  }

private:
  std::vector<Vertex_index> m_cones;
  internal::Planar_layout m_layout;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H
