// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

typedef std::array<double, 3> Coordinates;
typedef Intrinsic_triangulations::Face_location<double> Location;

// Two opposite corners of a quadrangle, with the weights that they have in a point, and the place
// where the other diagonal crosses theirs.
struct Diagonal
{
  double first, second, crossing;
};

// Expresses a point of the plane by other corners: of the corners of `from`, takes as much of their
// crossing as the point has, which leaves one with weight zero, and gives it to those of `to`.
// Returns whether the first is left.
inline bool exchange(Diagonal& from, Diagonal& to)
{
  const double p = from.crossing;
  const bool first_left = from.first * p > from.second * (1 - p);
  const double all = first_left ? from.second / p : from.first == 0 ? 0 : from.first / (1 - p);
  from.first = first_left ? (std::max)(from.first - all * (1 - p), 0.) : 0;
  from.second = first_left ? 0 : (std::max)(from.second - all * p, 0.);
  to.first += all * (1 - to.crossing);
  to.second += all * to.crossing;
  return first_left;
}

// sets the coordinates at the places c, c + 1, c + 2
inline void set_from(std::size_t c, double x, double y, double z, Coordinates& b)
{
  b[c] = x;
  b[(c + 1) % 3] = y;
  b[(c + 2) % 3] = z;
}

// A flip of ij to lk with the faces ijk and jil before, and lki and klj after it.
inline void carry_through_flip(const Surface_operation& flip, Location& p)
{
  const Coordinates b = p.second;
  const bool on_left = p.first == Face_index(flip.id[1]);
  const std::size_t c = flip.corner[on_left ? 0 : 1];
  const double x = b[c], y = b[(c + 1) % 3], z = b[(c + 2) % 3];
  Diagonal ij{on_left ? x : y, on_left ? y : x, flip.x[0]};
  Diagonal lk{on_left ? 0 : z, on_left ? z : 0, flip.x[1]};
  if(exchange(ij, lk))
    p = {Face_index(flip.id[1]), {lk.first, lk.second, ij.first}};
  else
    p = {Face_index(flip.id[2]), {lk.second, lk.first, ij.second}};
}

inline void carry_back_through_flip(const Surface_operation& flip, Location& p)
{
  const Coordinates b = p.second;
  const bool has_i = p.first == Face_index(flip.id[1]);
  Diagonal lk{b[has_i ? 0 : 1], b[has_i ? 1 : 0], flip.x[1]};
  Diagonal ij{has_i ? b[2] : 0, has_i ? 0 : b[2], flip.x[0]};
  if(exchange(lk, ij)) {
    p.first = Face_index(flip.id[2]);
    set_from(flip.corner[1], ij.second, ij.first, lk.first, p.second);
  } else {
    p.first = Face_index(flip.id[1]);
    set_from(flip.corner[0], ij.first, ij.second, lk.second, p.second);
  }
}

// the coordinates of the vertex with respect to the targets of its first, second and third spoke
inline Coordinates removed_vertex(const Surface_operation& removal)
{
  const auto& [w_a, w_b] = removal.x;
  return {w_a, w_b, (std::max)(1 - w_a - w_b, 0.)};
}

// where the coordinate that belongs to the target of the first spoke is in the new face
inline std::size_t place_of_first(const Surface_operation& removal)
{
  return removal.kind == Surface_operation::Kind::removal ? 0 : 1;
}

inline void carry_through_removal(const Surface_operation& removal, Location& p)
{
  const Coordinates b = p.second, w = removed_vertex(removal);
  std::size_t n = 0;
  while(p.first != Face_index(removal.id[n]))
    ++n;
  const std::size_t c = removal.corner[n];
  Coordinates at_target{b[c] * w[0], b[c] * w[1], b[c] * w[2]};
  at_target[n] += b[(c + 1) % 3];
  at_target[(n + 1) % 3] += b[(c + 2) % 3];
  p.first = Face_index(removal.id[0]);
  set_from(place_of_first(removal), at_target[0], at_target[1], at_target[2], p.second);
}

// Of which corner a point has the least, compared with a vertex: the point and this corner are on
// opposite sides of the vertex.
inline std::size_t corner_used_up(const Coordinates& vertex, const Coordinates& b)
{
  const Coordinates& w = vertex;
  auto used_up = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
  for(std::size_t m = 0; m < 3; ++m)
    if(w[m] > 0 && b[m] * w[used_up] < b[used_up] * w[m])
      used_up = m;
  return used_up;
}

// Takes out as much of the vertex as the point has: the face is the one opposite to the corner that
// is used up.
inline void carry_back_through_removal(const Surface_operation& removal, Location& p)
{
  const Coordinates w = removed_vertex(removal);
  const std::size_t first = place_of_first(removal);
  Coordinates b{p.second[first], p.second[(first + 1) % 3], p.second[(first + 2) % 3]};
  const std::size_t used_up = corner_used_up(w, b);
  const double at_vertex = b[used_up] / w[used_up];
  for(std::size_t m = 0; m < 3; ++m)
    b[m] = m == used_up ? 0 : (std::max)(b[m] - at_vertex * w[m], 0.);
  const std::size_t n = (used_up + 1) % 3;
  p.first = Face_index(removal.id[n]);
  set_from(removal.corner[n], at_vertex, b[n], b[(n + 1) % 3], p.second);
}

inline void normalize(Coordinates& b)
{
  const double sum = b[0] + b[1] + b[2];
  for(double& x : b)
    x /= sum;
}

// A change of scale is projective on each face (Equation 5.1): linear, as long as coordinates need
// not sum up to one. These are the factors of the coordinates in the face `f`, if that of a corner
// at the vertex is `factor`.
inline Coordinates scale_factors(const Surface_history& history, const Surface_operation& scaling,
                                 double factor, Face_index f)
{
  Coordinates result{1, 1, 1};
  for(std::size_t n = 0; n < scaling.id[2]; ++n) {
    const Surface_history::Corner corner = history.scaled_corner(scaling, n);
    if(corner.face == f)
      result[corner.corner] = factor;
  }
  return result;
}

inline void carry_through_scaling(const Surface_history& history, const Surface_operation& scaling,
                                  double factor, Location& p)
{
  const Coordinates factors = scale_factors(history, scaling, factor, p.first);
  for(std::size_t c = 0; c < 3; ++c)
    p.second[c] *= factors[c];
}

// moves a point of the surface before operation `t` to the surface after it; the operation has to
// involve its face. Coordinates are homogeneous.
inline void carry_forward(const Surface_history& history, Surface_history::Time t, Location& p)
{
  const Surface_operation& operation = history[t];
  switch(operation.kind) {
    case Surface_operation::Kind::scaling:
      return carry_through_scaling(history, operation, operation.x[0], p);
    case Surface_operation::Kind::flip: return carry_through_flip(operation, p);
    case Surface_operation::Kind::removal:
    case Surface_operation::Kind::border_removal: return carry_through_removal(operation, p);
  }
}

inline void carry_backward(const Surface_history& history, Surface_history::Time t, Location& p)
{
  const Surface_operation& operation = history[t];
  switch(operation.kind) {
    case Surface_operation::Kind::scaling:
      return carry_through_scaling(history, operation, 1 / operation.x[0], p);
    case Surface_operation::Kind::flip: return carry_back_through_flip(operation, p);
    case Surface_operation::Kind::removal:
    case Surface_operation::Kind::border_removal: return carry_back_through_removal(operation, p);
  }
}

// calls `visit(f)` for the faces that an operation involves, for some of them more than once
template <typename Visit>
void for_each_face(const Surface_history& history, const Surface_operation& operation,
                   const Visit& visit)
{
  switch(operation.kind) {
    case Surface_operation::Kind::scaling:
      for(std::size_t n = 0; n < operation.id[2]; ++n)
        visit(history.scaled_corner(operation, n).face);
      return;
    case Surface_operation::Kind::flip:
      visit(Face_index(operation.id[1]));
      visit(Face_index(operation.id[2]));
      return;
    case Surface_operation::Kind::removal: visit(Face_index(operation.id[2])); [[fallthrough]];
    case Surface_operation::Kind::border_removal:
      visit(Face_index(operation.id[0]));
      visit(Face_index(operation.id[1]));
  }
}

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H
