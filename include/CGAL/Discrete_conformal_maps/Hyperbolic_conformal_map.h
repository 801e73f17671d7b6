// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_CONFORMAL_MAP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_CONFORMAL_MAP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Disk_motion.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// the group of motions of the hyperbolic plane that belongs to a closed hyperbolic surface. The
/// surface is one component, or the double of a component with boundary. The images of its
/// fundamental domain cover the plane.
struct Fuchsian_group
{
  /// a number of 115 decimal digits.
  typedef internal::Decimal_115 Precise_number;

  /// a generator or its inverse.
  struct Letter
  {
    std::size_t generator; ///< its index
    bool is_inverse;       ///< whether it is the inverse
  };

  std::size_t genus = 0; ///< the genus of the closed surface
  double area = 0;       ///< its area

  /// two motions for each handle. Each moves the fundamental domain across one of its sides, to an
  /// adjacent image. Without cones, they generate the group.
  std::vector<Disk_motion<>> generators;

  /// the generators with all known digits. Empty if cones exist, or if double precision was
  /// sufficient.
  std::vector<Disk_motion<Precise_number>> precise_generators;

  /// the number of known decimal digits of `precise_generators`. With fewer digits, the product of
  /// `relation` has a greater error; more digits do not reduce it.
  int known_digits = 0;

  /// the generators and inverses whose product, from left to right, is the identity. Each generator
  /// occurs once, and so does its inverse. Empty if cones exist.
  std::vector<Letter> relation;

  /// the distance of the product of `relation` from the identity, for `generators`.
  double relation_error = 0;
  /// the same distance for `precise_generators`, if they exist.
  double precise_relation_error = 0;
};

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// returns the distance of the product of motions, in the order of `group.relation`, from the
/// identity (`Disk_motion::distance_to_identity()`). Complexity: linear in the relation.
/// \param group the group
/// \param generators its generators, in any precision
template <typename FT>
double relation_error(const Fuchsian_group& group, const std::vector<Disk_motion<FT>>& generators)
{
  Disk_motion<FT> product;
  for(const Fuchsian_group::Letter& letter : group.relation) {
    const Disk_motion<FT>& motion = generators[letter.generator];
    product = product * (letter.is_inverse ? motion.inverse() : motion);
  }
  return product.distance_to_identity();
}

namespace internal {

// Holds the positions of the faces of T_3 in the hyperbolic plane, and their gluing.
struct Hyperbolic_layout
{
  static constexpr std::size_t no_seam = static_cast<std::size_t>(-1);

  bool exists = false;
  std::vector<std::size_t> component;                               // of each face
  std::vector<Fuchsian_group> groups;                               // of each component
  std::vector<Intrinsic_triangulations::Topological_type> topology; // of each component
  std::vector<std::array<double, 3>> position; // of the source of each halfedge
  std::vector<std::size_t> seam;               // for each edge, its index among the seams
  std::vector<Disk_motion<>> gluing;           // of the first halfedge of each seam
  double max_gluing_error = 0;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// a discrete conformal map of a surface to the hyperbolic plane. The faces of \f$T_3\f$ are
/// hyperbolic triangles. Faces of each component are laid out side by side in the Poincare disk
/// except at seams, and motions glue the seams. A component with boundary is doubled, and its
/// boundary is a geodesic.
///
/// The domain of each component is centered at the origin.
///
/// Points far from the origin are close to the boundary of the disk. At a distance \f$d\f$,
/// coordinates of type `double` have errors of about \f$10^{-16} e^d\f$.
class Hyperbolic_conformal_map : public Discrete_conformal_map
{
public:
  /// \cond SKIP_IN_MANUAL
  Hyperbolic_conformal_map() = default;
  Hyperbolic_conformal_map(std::unique_ptr<const internal::Map_data> data,
                           internal::Hyperbolic_layout layout)
    : Discrete_conformal_map(std::move(data)), m_layout(std::move(layout))
  {}
  /// \endcond

  /// returns whether faces have positions in the hyperbolic plane. They have none if numbers have
  /// too few digits for a layout.
  bool is_laid_out() const { return m_layout.exists; }

  /// returns the number of components, except for isolated vertices; zero without a layout.
  std::size_t number_of_components() const { return m_layout.groups.size(); }

  /// returns the component of the face `f` of \f$T_3\f$.
  std::size_t component(Face_index f) const { return m_layout.component[f.idx()]; }

  /// returns the group of component `c`, or of its double.
  const Fuchsian_group& group(std::size_t c) const { return m_layout.groups[c]; }

  /// returns the genus and the number of boundary loops of component `c`, not of its double.
  const Intrinsic_triangulations::Topological_type& topology(std::size_t c) const
  {
    return m_layout.topology[c];
  }

  /// returns the area of component `c` itself: \f$2\pi(2g - 2 + b)\f$ without cones, for genus
  /// \f$g\f$ and \f$b\f$ boundaries that are geodesics.
  double area(std::size_t c) const
  {
    return topology(c).boundary_loops == 0 ? group(c).area : group(c).area / 2;
  }

  /// returns the area of all components.
  double area() const
  {
    double result = 0;
    for(std::size_t c = 0; c < number_of_components(); ++c)
      result += area(c);
    return result;
  }

  /// returns the hyperbolic length of the edge `e` of \f$T_3\f$.
  double length(Edge_index e) const
  {
    return 2 * std::asinh(data().scaled_length(ideal().mesh().halfedge(e)));
  }

  /// returns the hyperbolic radius of the circle at `v`; zero if no radii were given.
  double circle_radius(Vertex_index v) const { return std::atanh(2 * scaled_radius(v)); }

  /// returns the position of the source of `h`, a halfedge of \f$T_3\f$, in the face of `h`, on the
  /// hyperboloid \f$x^2 + y^2 - t^2 = -1\f$, as \f$(x, y, t)\f$.
  const std::array<double, 3>& hyperboloid_position(Halfedge_index h) const
  {
    return m_layout.position[h.idx()];
  }

  /// returns the image in the Poincare disk.
  std::complex<double> position(Halfedge_index h) const
  {
    return to_disk(m_layout.position[h.idx()]);
  }

  /// returns whether the two faces of the edge `e` of \f$T_3\f$ lie apart.
  bool is_seam(Edge_index e) const { return m_layout.seam[e.idx()] != m_layout.no_seam; }

  /// returns the motion that moves the face beyond the halfedge `h` of \f$T_3\f$ beside the face of
  /// `h`. It is the identity if the edge is no seam.
  Disk_motion<> gluing(Halfedge_index h) const
  {
    if(!is_seam(Edge_index(h)))
      return {};
    const Disk_motion<>& motion = m_layout.gluing[m_layout.seam[Edge_index(h).idx()]];
    return Intrinsic_triangulations::is_first_halfedge(h) ? motion : motion.inverse();
  }

  /// returns the greatest gluing error of a vertex without cone. The product of the gluing motions
  /// around it should be the identity; the error is `Disk_motion::distance_to_identity()`.
  double max_gluing_error() const { return m_layout.max_gluing_error; }

  /// returns the greatest distance of a vertex from the origin.
  double radius() const
  {
    double greatest = 1;
    for(const auto& p : m_layout.position)
      greatest = (std::max)(greatest, p[2]);
    return std::acosh(greatest);
  }

  /// returns the homogeneous coordinates of a point, as a vector \f$(x, y, t)\f$ in the cone over
  /// the hyperboloid. They are linear on the faces of the common subdivision. The point in Klein's
  /// disk is \f$(x/t, y/t)\f$.
  /// \param on_C a face of \f$T_3\f$ and weights of its corners, such as
  ///        `Triple_subdivision::location()` gives
  std::array<double, 3> homogeneous_coordinates(const Face_location& on_C) const
  {
    const Delta_complex& mesh = ideal().mesh();
    std::array<double, 3> result{0, 0, 0};
    const auto side = sides(on_C.first, mesh);
    const std::array<double, 3> weight = homogeneous_weights(on_C);
    for(std::size_t s = 0; s < 3; ++s) {
      const double w = weight[s] * sech_radius(mesh.source(side[s]));
      for(std::size_t i = 0; i < 3; ++i)
        result[i] += w * m_layout.position[side[s].idx()][i];
    }
    return result;
  }

  /// returns the point of the Poincare disk that belongs to a vector in the cone over the
  /// hyperboloid. Its absolute value is less than 1, even if rounding would make it 1.
  static std::complex<double> to_disk(const std::array<double, 3>& p)
  {
    const double square = p[2] * p[2] - p[0] * p[0] - p[1] * p[1];
    const std::complex<double> z =
      std::complex<double>(p[0], p[1]) / (p[2] + std::sqrt((std::max)(square, 0.)));
    constexpr double greatest = 1 - 0x1p-51;
    return std::abs(z) > greatest ? z * (greatest / std::abs(z)) : z;
  }

  /// returns the image of a point of the input in the Poincare disk, by piecewise projective
  /// interpolation (Section 4.2.3 for a hyperbolic target). On every face, the coordinates in
  /// Klein's disk are a projective map. At a side of the domain, it is the image in one of the
  /// faces. Complexity: see `place_on_C()`.
  template <typename Place = Face_location>
  std::complex<double> operator()(const Place& p) const
  {
    return to_disk(homogeneous_coordinates(place_on_C(p)));
  }

private:
  // Returns 1/cosh R for the radius R of the circle. Its vector is n + p/cosh R, with its center p
  // on the hyperboloid and the normal n of the plane of the image.
  double sech_radius(Vertex_index v) const
  {
    const double tanh = 2 * scaled_radius(v);
    return std::sqrt((1 - tanh) * (1 + tanh));
  }

  internal::Hyperbolic_layout m_layout;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_CONFORMAL_MAP_H
