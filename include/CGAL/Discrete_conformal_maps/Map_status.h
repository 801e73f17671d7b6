// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMaps
/// the outcome of the computation of a discrete conformal map. Success is measured on the result:
/// see `Map_promise`. `triangle_inequality` and `no_minimum` occur in fixed triangulations only.
enum class Map_status
{
  success,             ///< the map keeps all promises
  not_converged,       ///< the scale factors have not been found: see `Minimization_status`
  triangle_inequality, ///< in some faces the scaled lengths violate the triangle inequality, so
                       ///< nothing is laid out
  no_minimum, ///< no scale factors give this triangulation the prescribed angles. Some vertices
              ///< together need greater angles than their faces have, or smaller angles than the
              ///< faces between them have
  wrong_curvature,  ///< a vertex of the scaled surface has a wrong curvature, or a boundary vertex
                    ///< a wrong exterior angle
  not_laid_out,     ///< numbers have too few digits for a layout: there are no positions
  layout_collapsed, ///< in the plane or the hyperbolic plane some faces are reversed or have no
                    ///< area: they are smaller than rounding
  not_closed,       ///< in the plane, edges have wrong lengths, so that the two sides of a seam
                    ///< differ
  not_circular,     ///< the boundary of a disk is not a circle
  not_rectangular,  ///< the sides of a rectangle are not straight, or its angles are not right
  not_convex,       ///< the image on the sphere is not a convex polyhedron, or violates a bound of
                    ///< Section 4.4.3
  not_inscribed,    ///< vertices are not on the sphere, boundary vertices of a disk are not on the
                    ///< equator, or interior vertices are not above it
  not_conformal,    ///< a length cross ratio of the image differs from the input
  not_glued         ///< in the hyperbolic plane, faces do not close up around a vertex, or the
                    ///< generators do not satisfy their relation
};

namespace internal {

struct Status_text
{
  const char *name, *message, *advice;
};

inline Status_text text_of(Map_status status)
{
  switch(status) {
    case Map_status::success: return {"success", "the map keeps all of its promises", ""};
    case Map_status::not_converged:
      return {"not_converged", "the minimization has not converged",
              "allow cones or choose another target; as a last resort, lengthen the edges of "
              "almost flat faces (mollification)"};
    case Map_status::triangle_inequality:
      return {"triangle_inequality",
              "the scale factors of the triangulation of the mesh violate the triangle inequality",
              "allow flips (the parameter flipping)"};
    case Map_status::no_minimum:
      return {"no_minimum", "the triangulation of the mesh has no such scale factors",
              "allow flips (the parameter flipping)"};
    case Map_status::wrong_curvature:
      return {"wrong_curvature", "the scaled surface does not have the prescribed curvatures",
              "prescribe smaller curvatures; as a last resort, lengthen the edges of almost flat "
              "faces (mollification)"};
    case Map_status::not_laid_out:
      return {"not_laid_out", "numbers have too few digits for a layout",
              "allow cones, or prescribe smaller curvatures, so that scale factors differ less"};
    case Map_status::layout_collapsed:
      return {"layout_collapsed", "some faces are smaller than rounding in the plane",
              "allow cones, or prescribe smaller curvatures, so that scale factors differ less"};
    case Map_status::not_closed:
      return {"not_closed", "edges in the plane do not have the scaled lengths",
              "allow cones, or prescribe smaller curvatures, so that scale factors differ less"};
    case Map_status::not_circular:
      return {"not_circular", "the boundary has not become a circle",
              "allow more rounds, or map to the hemisphere, which takes one minimization"};
    case Map_status::not_rectangular:
      return {"not_rectangular", "the image of a boundary is not a rectangle",
              "choose other corners, as far from each other as possible"};
    case Map_status::not_convex:
      return {"not_convex", "the image is not convex",
              "flatten with cones; as a last resort, lengthen the edges of almost flat faces "
              "(mollification)"};
    case Map_status::not_inscribed:
      return {"not_inscribed", "the vertices are not on the sphere or the hemisphere",
              "flatten with cones, so that scale factors differ less"};
    case Map_status::not_conformal:
      return {"not_conformal", "length cross ratios of the image differ from the mesh",
              "allow cones, so that scale factors differ less; as a last resort, lengthen the "
              "edges of thin faces (mollification)"};
    case Map_status::not_glued:
      return {"not_glued", "the faces do not close up in the hyperbolic plane",
              "cut the surface, or prescribe cones, so that its domain is smaller"};
  }
  return {"unknown", "unknown", ""};
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsMaps
/// returns the name of `status`.
inline const char* to_string(Map_status status) { return internal::text_of(status).name; }

/// \ingroup PkgDiscreteConformalMapsMaps
/// returns the meaning of `status`, as part of a sentence for users.
inline const char* message(Map_status status) { return internal::text_of(status).message; }

/// \ingroup PkgDiscreteConformalMapsMaps
/// returns advice after `status`, as part of a sentence for users; empty after success. Complexity:
/// constant.
inline const char* advice(Map_status status) { return internal::text_of(status).advice; }

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H
