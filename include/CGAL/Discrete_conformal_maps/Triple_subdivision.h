// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/Face_overlay.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsCorrespondence
/// the polygons into which the edges of three triangulations \f$T^A\f$, \f$T^B\f$, \f$T^C\f$ together cut a
/// surface (Section 4.2.2).
///
/// It is made face by face of \f$T^B\f$, to which both others correspond. Which polygons there are follows
/// from the orders of crossings along its edges; only where crossings with \f$T^A\f$ and with \f$T^C\f$ on one
/// edge are so close that rounding decides, it may be that of a surface that differs by as much.
///
/// Vertices are numbered: those of the surface first, then the crossings of \f$T^A\f$ with \f$T^B\f$, those of
/// \f$T^B\f$ with \f$T^C\f$, and those of \f$T^A\f$ with \f$T^C\f$.
///
/// \tparam Traits_AB the geometry of the first correspondence
/// \tparam Traits_BC the geometry of the second correspondence
template <typename Traits_AB, typename Traits_BC>
class Triple_subdivision
{
  typedef internal::Face_overlay<Traits_AB, Traits_BC> Overlay;

public:
  /// the correspondence of \f$T^A\f$ and \f$T^B\f$.
  typedef Intrinsic_triangulations::Correspondence<Traits_AB> Correspondence_AB;
  /// the correspondence of \f$T^B\f$ and \f$T^C\f$.
  typedef Intrinsic_triangulations::Correspondence<Traits_BC> Correspondence_BC;
  /// the number type of coordinates.
  typedef typename Overlay::FT FT;

  /// a corner of a polygon. Its coordinates belong to the corners of the parent faces, in the order of
  /// `Intrinsic_triangulations::Face_location`; those on \f$T^A\f$ sum up to one, those on \f$T^C\f$ are
  /// homogeneous where the map between \f$T^B\f$ and \f$T^C\f$ is projective.
  typedef internal::Overlay_corner<FT> Corner;

  /// a polygon with the faces of which it is a part.
  typedef internal::Overlay_face Face;

  /// makes all polygons. Complexity: \f$O(n \log n)\f$ in their number, and linear but for the order of
  /// crossings along one curve.
  /// \param ab the correspondence with \f$T^A\f$ as the side `input`
  /// \param bc the correspondence with \f$T^C\f$ as the side `intrinsic`
  /// \pre no vertices are inserted, and there is no boundary
  Triple_subdivision(const Correspondence_AB& ab, const Correspondence_BC& bc)
  {
    Overlay overlay(ab, bc, m_faces, m_corners);
    for(Face_index f : ab.mesh(Intrinsic_triangulations::Side::intrinsic).faces())
      overlay.add(f);
    m_number_of_vertices = overlay.number_of_vertices();
  }

  /// the number of vertices.
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /// the polygons.
  const std::vector<Face>& faces() const { return m_faces; }

  /// the corners of all polygons, one after the other in counterclockwise order; those of a face are
  /// number `first_corner` to `end_of_corners`.
  const std::vector<Corner>& corners() const { return m_corners; }

private:
  std::vector<Face> m_faces;
  std::vector<Corner> m_corners;
  std::size_t m_number_of_vertices = 0;
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_TRIPLE_SUBDIVISION_H
