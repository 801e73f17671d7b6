// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_RESULT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_RESULT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// states how a refinement has ended.
enum class Refinement_status
{
  bounds_met,             ///< every face obeys the bounds
  bounds_met_but_excused, ///< every face that violates a bound is excused by a small-angle vertex
  insertion_limit,        ///< the allowed number of insertions was used up
  no_room                 ///< rounded numbers leave no room for vertices that would be needed
};

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns the name of `status`.
inline const char* to_string(Refinement_status status)
{
  switch(status) {
    case Refinement_status::bounds_met: return "bounds_met";
    case Refinement_status::bounds_met_but_excused: return "bounds_met_but_excused";
    case Refinement_status::insertion_limit: return "insertion_limit";
    case Refinement_status::no_room: return "no_room";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// states why a face violates the bounds after a refinement.
enum class Remaining_reason
{
  at_small_angle_vertex,     ///< exactly one of its corners is a small-angle vertex (Section 3.6)
  beside_small_angle_vertex, ///< it lies in faces of \f$T_1\f$ at a small-angle vertex, and
                             ///< only edges of \f$T_1\f$ that end at this vertex cross it
  insertion_limit,           ///< no more insertions were allowed
  no_room,                   ///< rounded numbers leave no room for the new edges
  at_rounding,               ///< it is of the order of the rounding of coordinates on \f$T_1\f$
                             ///< (only with exact decisions)
  no_area,                   ///< its corners lie on a line, exactly, along a boundary or
                             ///< constrained edge (only with exact decisions)
  at_narrow_vertex [[deprecated("use at_small_angle_vertex")]] = at_small_angle_vertex,
  ///< \deprecated
  beside_narrow_vertex [[deprecated("use beside_small_angle_vertex")]] = beside_small_angle_vertex
  ///< \deprecated
};

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns a short sentence for `reason`.
inline const char* to_string(Remaining_reason reason)
{
  switch(reason) {
    case Remaining_reason::at_small_angle_vertex:
      return "one of its corners is a small-angle vertex";
    case Remaining_reason::beside_small_angle_vertex:
      return "it lies in input faces at a small-angle vertex";
    case Remaining_reason::insertion_limit: return "no more insertions are allowed";
    case Remaining_reason::no_room: return "there is no room for new edges";
    case Remaining_reason::at_rounding: return "it is as small as the rounding of coordinates";
    case Remaining_reason::no_area: return "it has no area";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// describes a face that violates the bounds after a refinement.
struct Remaining_face
{
  Face_index face;         ///< the face of \f$T_2\f$
  Remaining_reason reason; ///< the reason
  Vertex_index vertex;     ///< the small-angle vertex that excuses it; null if none does
};

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns whether a small-angle vertex excuses `f`. Complexity: constant.
inline bool is_excused(const Remaining_face& f)
{
  return f.reason == Remaining_reason::at_small_angle_vertex ||
         f.reason == Remaining_reason::beside_small_angle_vertex;
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// describes what `refine()` has done.
struct Refinement_result
{
  Refinement_status status = Refinement_status::bounds_met; ///< how it ended
  std::size_t insertions = 0;                               ///< the number of vertices inserted
  std::size_t removals = 0;                                 ///< how many of them were removed again
  std::size_t flips = 0;                 ///< the number of flips to Delaunay, without
                                         ///< flips that remove vertices
  bool is_exact = false;                 ///< whether the decisions were exact
  std::vector<Remaining_face> remaining; ///< the faces that violate the bounds
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_RESULT_H
