// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PROJECTIVE_PIECES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PROJECTIVE_PIECES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Cell_joiner.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Face_cutter.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// a convex polygon inside one face of both levels on which the map between them is one projective
/// map.
struct Projective_piece
{
  /// barycentric coordinates.
  typedef std::array<double, 3> Coordinates;
  /// a corner of the polygon, as a point of either face.
  struct Corner
  {
    Coordinates fine;   ///< in the face of the fine level
    Coordinates coarse; ///< in the face of the coarse level
  };

  Face_index fine_face;        ///< the face of the fine level
  Face_index coarse_face;      ///< the face of the coarse level
  std::vector<Corner> corners; ///< counterclockwise; no two sides that meet are on a line
  /// the matrix that takes homogeneous coordinates on the fine face to those on the coarse face, by
  /// rows.
  std::array<Coordinates, 3> matrix;

  /// maps a point of the piece to the coarse face. Its coordinates need not sum up to one, those of
  /// the result do.
  Coordinates to_coarse(const Coordinates& b) const
  {
    return product([this](std::size_t r, std::size_t c) { return matrix[r][c]; }, b);
  }

  /// maps a point of the piece to the fine face: the inverse of `to_coarse()`.
  Coordinates to_fine(const Coordinates& b) const
  {
    return product([this](std::size_t r, std::size_t c) { return cofactor(c, r); }, b);
  }

private:
  template <typename Entry>
  static Coordinates product(const Entry& entry, const Coordinates& b)
  {
    Coordinates result{};
    for(std::size_t r = 0; r < 3; ++r)
      for(std::size_t c = 0; c < 3; ++c)
        result[r] += entry(r, c) * b[c];
    internal::normalize(result);
    return result;
  }

  // the determinant of the matrix without a row and a column, with its sign
  double cofactor(std::size_t r, std::size_t c) const
  {
    const Coordinates &x = matrix[(r + 1) % 3], &y = matrix[(r + 2) % 3];
    return x[(c + 1) % 3] * y[(c + 2) % 3] - x[(c + 2) % 3] * y[(c + 1) % 3];
  }
};

namespace internal {

inline Projective_piece projective_piece(Face_index fine_face, const Cell& cell,
                                         const std::vector<const Face_point*>& corners,
                                         const Surface_level& coarse)
{
  Projective_piece result{fine_face, coarse.level_face(cell.face), {}, {}};
  for(const Face_point* p : corners) {
    result.corners.push_back({p->along, p->weight});
    normalize(result.corners.back().fine);
    normalize(result.corners.back().coarse);
  }
  for(std::size_t r = 0; r < 3; ++r)
    for(std::size_t c = 0; c < 3; ++c)
      result.matrix[r][c] = cell.image[c].weight[r];
  return result;
}

// whether it is more than what rounding leaves between lines that are the same
inline bool has_area(const std::vector<const Face_point*>& corners)
{
  return polygon_area(corners.size(), [&](std::size_t c) { return corners[c]->along; }) >
           rounding() ||
         polygon_area(corners.size(), [&](std::size_t c) { return corners[c]->weight; }) >
           rounding();
}

template <typename Visit>
void for_each_piece(Face_index f, const Surface_map& map, Face_cutter& cutter, Cell_joiner& joiner,
                    const Visit& visit)
{
  joiner.join(cutter.cut(f), cutter,
              [&](const Cell& cell, const std::vector<const Face_point*>& corners) {
                if(has_area(corners))
                  visit(projective_piece(f, cell, corners, map.coarse()));
              });
}

// in units of its face of the coarse level
inline double coarse_area(const Projective_piece& p)
{
  return polygon_area(p.corners.size(), [&](std::size_t c) { return p.corners[c].coarse; });
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// writes the pieces of a face of the fine level: the convex polygons on each of which the map to
/// the coarse level is one projective map (Section 5.2).
///
/// The face is carried through the operations and is cut by every edge that crosses it at any time.
/// In the end parts are joined again, unless they are in different faces of the coarse level, or
/// the scale was changed beside an edge while it was between them. So where nothing is scaled, the
/// pieces are the polygons into which the edges of the coarse level cut the face.
///
/// The pieces are a subdivision of the face whatever rounding does. Edges that come to a point of
/// another within rounding run through it; what has no more area than rounding on both levels is
/// left out. A point carried by a matrix and by `Surface_map` comes to the same place up to the
/// rounding of a product of as many matrices as there are operations: mostly 1e-13, and worse where
/// a face has been part of long slivers.
/// \param f a face of the fine level
/// \param map the map
/// \param out an output iterator to which `Projective_piece` can be assigned
/// \returns the end of the output
/// \throws Intrinsic_triangulations::Invalid_input if a vertex has been inserted into the face
///   between the levels (see `refine()`)
/// Complexity: linear in the parts into which edges of any time cut the face, times the operations
/// that move a part and the logarithms of both numbers.
template <typename OutputIterator>
OutputIterator projective_pieces(Face_index f, const Surface_map& map, OutputIterator out)
{
  internal::Face_cutter cutter(map);
  internal::Cell_joiner joiner;
  internal::for_each_piece(f, map, cutter, joiner, [&](const Projective_piece& p) { *out++ = p; });
  return out;
}

/// \ingroup PkgIntrinsicSimplificationRef
/// writes the pieces of all faces of the fine level, face by face; otherwise as for one face.
/// \param map the map
/// \param out an output iterator to which `Projective_piece` can be assigned
/// \returns the end of the output
/// \throws Intrinsic_triangulations::Numerical_error if the pieces do not have the area of each
///   face of the coarse level together: rounding has taken a part to another place. This needs
///   vertices about as near to each other as rounding.
template <typename OutputIterator>
OutputIterator projective_pieces(const Surface_map& map, OutputIterator out)
{
  internal::Face_cutter cutter(map);
  internal::Cell_joiner joiner;
  std::vector<double> area(map.coarse().mesh().number_of_faces(), 0);
  for(Face_index f : map.fine().mesh().faces())
    internal::for_each_piece(f, map, cutter, joiner, [&](const Projective_piece& p) {
      area[p.coarse_face] += internal::coarse_area(p);
      *out++ = p;
    });
  for(std::size_t f = 0; f < area.size(); ++f)
    if(!(std::abs(area[f] - 1) <= internal::tiling_rounding))
      throw Intrinsic_triangulations::Numerical_error("by rounding, pieces do not tile face " +
                                                      std::to_string(f) + " of the coarse level");
  return out;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PROJECTIVE_PIECES_H
