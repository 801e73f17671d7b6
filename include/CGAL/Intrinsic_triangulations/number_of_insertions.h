// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NUMBER_OF_INSERTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NUMBER_OF_INSERTIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns how many vertices `refine()` may insert by default. If circumradii are bounded, the
/// limit is 10,000,000. Otherwise it is 1,000,000 plus 20 for each face of \f$T_1\f$. For angles of
/// more than 30 degrees, refinement need not end, and the limit is 100,000 plus 20 for each face.
/// It never exceeds 10,000,000. Refinements of ordinary meshes to 32 degrees that end insert fewer
/// than 8 vertices for each face. The number for a narrow tube or strip is proportional to its
/// length divided by its width. Complexity: constant.
/// \param faces the number of faces of \f$T_1\f$
/// \param minimum_angle the least angle, in degrees
/// \param maximum_circumradius the greatest circumradius
template <typename FT>
std::size_t default_maximum_number_of_insertions(std::size_t faces, const FT& minimum_angle,
                                                 const FT& maximum_circumradius)
{
  const std::size_t most = 10000000, least = minimum_angle > 30 ? 100000 : 1000000;
  return maximum_circumradius == std::numeric_limits<FT>::infinity()
           ? (std::min)(most, least + 20 * faces)
           : most;
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns a lower bound for the number of vertices that are inserted into `tri` before no
/// circumradius exceeds `circumradius`. The equilateral triangle has the greatest area of all with
/// this circumradius, and a new vertex adds at most two faces. Infinity is a possible result.
/// Complexity: linear.
template <typename Traits>
double least_number_of_insertions(const Intrinsic_triangulation<Traits>& tri,
                                  const typename Traits::FT& circumradius)
{
  double area = 0;
  for(Face_index f : tri.mesh().faces())
    area += CGAL::to_double(Face_metric<typename Traits::FT>(f, tri.intrinsic()).area());
  const double radius = CGAL::to_double(circumradius), greatest_area = 0.75 * std::sqrt(3.);
  const double faces = area / radius / radius / greatest_area;
  return (std::max)(0., (faces - double(tri.mesh().number_of_faces())) / 2);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns how many vertices `refine()` may insert into `tri` by default. Complexity: linear.
/// \param tri the triangulation
/// \param minimum_angle the least angle, in degrees
/// \param maximum_circumradius the greatest circumradius
/// \throws Invalid_input if the bound on circumradii needs more, see `least_number_of_insertions()`
template <typename Traits>
std::size_t default_maximum_number_of_insertions(const Intrinsic_triangulation<Traits>& tri,
                                                 const typename Traits::FT& minimum_angle,
                                                 const typename Traits::FT& maximum_circumradius)
{
  const std::size_t result = default_maximum_number_of_insertions(
    tri.input_mesh().number_of_faces(), minimum_angle, maximum_circumradius);
  const double least = least_number_of_insertions(tri, maximum_circumradius);
  if(least <= double(result))
    return result;
  std::ostringstream text;
  text << "faces with circumradii of at most " << maximum_circumradius << " need at least " << least
       << " insertions, more than the default of " << result
       << ": ask for larger faces, or set the maximum number of insertions";
  throw Invalid_input(text.str());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NUMBER_OF_INSERTIONS_H
