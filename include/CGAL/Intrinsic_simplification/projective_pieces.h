// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PROJECTIVE_PIECES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PROJECTIVE_PIECES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
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
/// a convex polygon inside one face of each level, on which the map between them is one projective
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
  std::vector<Corner> corners; ///< counterclockwise; no two adjacent sides are on a line
  /// the matrix that maps homogeneous coordinates on the fine face to the coarse face, by rows.
  std::array<Coordinates, 3> matrix;

  /// maps a point of the piece to the coarse face. Its coordinates need not sum up to one;
  /// coordinates of the result sum up to one.
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

  // Returns the determinant of the matrix without a row and a column, with its sign.
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

// Returns whether the area exceeds the rounding error between equal lines.
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

// Returns the area of a piece, relative to its face of the coarse level.
inline double coarse_area(const Projective_piece& p)
{
  return polygon_area(p.corners.size(), [&](std::size_t c) { return p.corners[c].coarse; });
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// writes the pieces of a face of the fine level (Section 5.2). They are convex polygons, and the
/// map to the coarse level is one projective map on each.
///
/// The face is carried through the operations, and every edge that crosses it at any time cuts it.
/// Finally parts in one face of the coarse level are joined again, unless the scale beside an edge
/// between them changed. Without scaling, the pieces are the polygons into which the edges of the
/// coarse level cut the face.
///
/// Despite rounding, the pieces are always a subdivision of the face. An edge that passes a point
/// of another edge within rounding runs through it. Parts without area on both levels, up to
/// rounding, are left out. A matrix and `Surface_map` map a point to the same point up to the
/// rounding of a product of matrices, one for each operation. The difference is mostly about 1e-13,
/// and greater if a face has been part of long slivers.
/// \param f a face of the fine level
/// \param map the map
/// \param out an output iterator to which `Projective_piece` can be assigned
/// \returns the end of the output
/// \throws Intrinsic_triangulations::Invalid_input if a vertex has been inserted into the face
///   between the levels (see `refine()`)
///
/// Complexity: linear in the parts into which edges of any time cut the face, times the operations
/// that move a part, up to logarithms.
template <typename OutputIterator>
OutputIterator projective_pieces(Face_index f, const Surface_map& map, OutputIterator out)
{
  internal::Face_cutter cutter(map);
  internal::Cell_joiner joiner;
  internal::for_each_piece(f, map, cutter, joiner, [&](const Projective_piece& p) { *out++ = p; });
  return out;
}

/// \ingroup PkgIntrinsicSimplificationRef
/// writes the pieces of all faces of the fine level, face by face, as for one face.
/// \param map the map
/// \param out an output iterator to which `Projective_piece` can be assigned
/// \returns the end of the output
/// \throws Intrinsic_triangulations::Invalid_input as for one face
/// \throws Intrinsic_triangulations::Numerical_error if the areas of pieces do not sum up to the
///   area of each face of the coarse level: rounding has misplaced a part. This needs vertices
///   about as close to each other as rounding
///
/// Complexity: the sum over all faces of the fine level.
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
