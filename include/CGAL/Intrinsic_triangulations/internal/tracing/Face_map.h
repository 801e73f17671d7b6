// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MAP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename FT>
using Barycentric_coordinates = std::array<FT, 3>;

// Returns a number proportional, with a common positive factor, to the signed area of the triangle
// abc.
template <typename FT>
FT orientation(const Barycentric_coordinates<FT>& a, const Barycentric_coordinates<FT>& b,
               const Barycentric_coordinates<FT>& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Returns (b - a) . (d - c).
template <typename FT>
FT dot(const Barycentric_coordinates<FT>& a, const Barycentric_coordinates<FT>& b,
       const Barycentric_coordinates<FT>& c, const Barycentric_coordinates<FT>& d)
{
  FT sum(0);
  for(std::size_t s = 0; s < 3; ++s)
    sum += (b[s] - a[s]) * (d[s] - c[s]);
  return sum;
}

// Returns the position, from 0 to 1, of the point closest to `p` on the segment from `a` to `b`.
template <typename FT>
FT closest_between(const Barycentric_coordinates<FT>& a, const Barycentric_coordinates<FT>& b,
                   const Barycentric_coordinates<FT>& p)
{
  const FT square = dot(a, b, a, b);
  return square > 0 ? std::clamp<FT>(dot(a, b, a, p) / square, FT(0), FT(1)) : FT(0);
}

template <typename FT>
Barycentric_coordinates<FT> point_between(const Barycentric_coordinates<FT>& a,
                                          const Barycentric_coordinates<FT>& b, const FT& t)
{
  Barycentric_coordinates<FT> result;
  for(std::size_t s = 0; s < 3; ++s)
    result[s] = (1 - t) * a[s] + t * b[s];
  return result;
}

template <typename FT>
FT squared_distance(const Barycentric_coordinates<FT>& a, const Barycentric_coordinates<FT>& b,
                    const Barycentric_coordinates<FT>& p)
{
  const auto foot = point_between(a, b, closest_between(a, b, p));
  return dot(foot, p, foot, p);
}

// Represents a projective map, given by the corners of a convex polygon and their images. As
// vectors, corners are multiples of their images, and the map is linear. If all factors are equal,
// barycentric coordinates are mapped linearly, too. All sums are convex combinations of images, so
// rounding in nearly flat polygons is not amplified.
template <typename FT>
class Polygon_map
{
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  // Adds a corner, which is `scale` times its image.
  void add_corner(const Coordinates& corner, const Coordinates& image, const FT& scale)
  {
    m_corner[m_size] = corner;
    m_scale[m_size] = scale;
    m_image[m_size++] = image;
  }

  std::size_t size() const { return m_size; }
  const Coordinates& corner(std::size_t c) const { return m_corner[c]; }
  const Coordinates& image(std::size_t c) const { return m_image[c]; }
  const FT& scale(std::size_t c) const { return m_scale[c]; }

  Polygon_map inverse() const
  {
    Polygon_map result = *this;
    std::swap(result.m_corner, result.m_image);
    for(std::size_t c = 0; c < m_size; ++c)
      result.m_scale[c] = 1 / m_scale[c];
    return result;
  }

  // Returns the image of a point of the polygon, with coordinates that sum up to one.
  Coordinates operator()(const Coordinates& p) const
  {
    Coordinates weight{}; // of corners 0, best, best + 1
    std::size_t best = 0;
    FT best_quality(0);
    for(std::size_t c = 1; c + 1 < m_size; ++c) {
      const FT area = orientation(m_corner[0], m_corner[c], m_corner[c + 1]);
      if(!(area > 0))
        continue;
      const Coordinates w{orientation(p, m_corner[c], m_corner[c + 1]) / area,
                          orientation(m_corner[0], p, m_corner[c + 1]) / area,
                          orientation(m_corner[0], m_corner[c], p) / area};
      const FT quality = (std::min)({w[0], w[1], w[2]});
      if(best == 0 || quality > best_quality) {
        best = c;
        best_quality = quality;
        weight = w;
      }
    }
    return best == 0 ? image_on_diagonal(p) : image_in_triangle(p, {0, best, best + 1}, weight);
  }

private:
  // Returns the image of a point of a triangle, given its barycentric coordinates. If the triangle
  // is thin, the coordinates have large rounding errors, and only one coordinate is used. It is the
  // coordinate across the longest side, or across a side on which the point lies. The position
  // along that side is computed by projection.
  Coordinates image_in_triangle(const Coordinates& p, const std::array<std::size_t, 3>& corner,
                                const Coordinates& weight) const
  {
    const std::size_t s = apex(corner, weight);
    const std::size_t a = corner[s], b = corner[(s + 1) % 3], c = corner[(s + 2) % 3];
    const FT t = place_along(b, c, p), foot = place_along(b, c, m_corner[a]);
    FT across = std::clamp(weight[s], FT(0), FT(1));
    // The other two weights must not become negative.
    if(across * foot > t)
      across = t / foot;
    if(across * (1 - foot) > 1 - t)
      across = (1 - t) / (1 - foot);
    return combination({across, 1 - t - across * (1 - foot), t - across * foot}, a, b, c);
  }

  // Returns the corner of a triangle opposite to a side on which a point lies, or to the longest
  // side.
  std::size_t apex(const std::array<std::size_t, 3>& corner, const Coordinates& weight) const
  {
    std::size_t result = 0;
    FT longest(-1);
    for(std::size_t s = 0; s < 3; ++s) {
      if(weight[s] == 0)
        return s;
      const Coordinates &b = m_corner[corner[(s + 1) % 3]], &c = m_corner[corner[(s + 2) % 3]];
      const FT squared = dot(b, c, b, c);
      if(squared > longest) {
        longest = squared;
        result = s;
      }
    }
    return result;
  }

  // Returns the position of the projection of `p` on the line from corner `a` to corner `b`, from 0
  // to 1.
  FT place_along(std::size_t a, std::size_t b, const Coordinates& p) const
  {
    return std::clamp<FT>(dot(m_corner[a], m_corner[b], m_corner[a], p) /
                            dot(m_corner[a], m_corner[b], m_corner[a], m_corner[b]),
                          FT(0), FT(1));
  }

  // Returns the image in a polygon without area. The point is projected to the longest diagonal or
  // side.
  Coordinates image_on_diagonal(const Coordinates& p) const
  {
    std::size_t from = 0, to = 0;
    FT longest(-1);
    for(std::size_t a = 0; a < m_size; ++a)
      for(std::size_t b = a + 1; b < m_size; ++b) {
        const FT squared = dot(m_corner[a], m_corner[b], m_corner[a], m_corner[b]);
        if(squared > longest) {
          longest = squared;
          from = a;
          to = b;
        }
      }
    const FT t = longest > 0 ? place_along(from, to, p) : FT(0);
    return combination({1 - t, t, FT(0)}, from, to, to);
  }

  // Returns the image of the point with barycentric coordinates `weight` with respect to three
  // corners.
  Coordinates combination(Coordinates weight, std::size_t a, std::size_t b, std::size_t c) const
  {
    const std::array<std::size_t, 3> corner{a, b, c};
    for(std::size_t s = 0; s < 3; ++s)
      weight[s] = (std::max)(weight[s], FT(0)) * m_scale[corner[s]];
    const FT sum = weight[0] + weight[1] + weight[2];
    Coordinates image;
    for(std::size_t s = 0; s < 3; ++s)
      image[s] =
        (weight[0] * m_image[a][s] + weight[1] * m_image[b][s] + weight[2] * m_image[c][s]) / sum;
    return image;
  }

  std::array<Coordinates, 6> m_corner, m_image;
  std::array<FT, 6> m_scale;
  std::size_t m_size = 0;
};

// Maps points of one face to the other triangulation. The region between curves that contains a
// point is found, and the point is mapped with this region.
//
// `Marks` describes the sides of the face:
// - crossings(s): the number of crossings on side s
// - here(s, p): the position of crossing p on side s
// - across(s, p): the position on the halfedge of the other triangulation that leaves the face at
//   crossing p
// - scale(s, p): how many times the vector across the vector here is
// - outgoing_before(s): the last outgoing halfedge of the other triangulation at or clockwise from
//   side s
// - vertex_across(s, at): the position of the source of side s on the other triangulation. It is
//   `at` unless the source is not a vertex of it: then only the face of `at` counts.
template <typename FT, typename Marks>
class Face_map
{
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  Face_map(const Marks& marks, const Delta_complex& other)
    : m_marks(marks),
      m_other(other),
      m_regions({marks.crossings(0), marks.crossings(1), marks.crossings(2)})
  {}

  Face_location<FT> operator()(const Coordinates& p) const
  {
    for(std::size_t s = 0; s < 3; ++s)
      if(p[(s + 1) % 3] == 0 && p[(s + 2) % 3] == 0)
        return m_marks.vertex_across(s, {m_marks.outgoing_before(s), FT(0)});
    const auto [f, map] = region_map(region_of(p));
    return {f, map(p)};
  }

  const Face_regions& regions() const { return m_regions; }

  Coordinates coordinates(const Region_corner& corner) const
  {
    return barycentric_coordinates(
      corner.side, corner.is_vertex() ? FT(0) : m_marks.here(corner.side, corner.mark));
  }

  // Returns the index of the region in which `p` lies.
  std::size_t region_of(const Coordinates& p) const
  {
    return m_regions.find([&](std::size_t s, std::size_t j) { return is_at_corner(s, j, p); },
                          [&](std::size_t j) { return is_before_curve(j, p); });
  }

  // Returns the face of the other triangulation in which region `m` lies, and the map of the region
  // to it.
  std::pair<Face_index, Polygon_map<FT>> region_map(std::size_t m) const
  {
    const Region region = m_regions[m];
    std::pair<Face_index, Polygon_map<FT>> result;
    for(std::size_t c = 0; c < region.size(); ++c) {
      const Face_location<FT> image = corner_across(region, c);
      result.first = image.first;
      result.second.add_corner(coordinates(region[c]), image.second, scale(region[c]));
    }
    return result;
  }

private:
  // Returns whether `p` is on the side of corner `s` of curve `j` around it.
  bool is_at_corner(std::size_t s, std::size_t j, const Coordinates& p) const
  {
    const auto curve = m_regions.curve_around(s, j);
    return orientation(coordinates(curve[0]), coordinates(curve[1]), p) > 0;
  }

  // Returns whether `p` is between the side after the apex and curve `j` from the apex.
  bool is_before_curve(std::size_t j, const Coordinates& p) const
  {
    Coordinates apex{};
    apex[m_regions.apex()] = FT(1);
    return orientation(coordinates(m_regions.end_of_curve(j)), apex, p) > 0;
  }

  FT scale(const Region_corner& corner) const
  {
    return corner.is_vertex() ? FT(1) : m_marks.scale(corner.side, corner.mark);
  }

  // Returns the position of a corner in the face of the other triangulation in which the region
  // lies.
  Face_location<FT> corner_across(const Region& region, std::size_t c) const
  {
    const Region_corner& corner = region[c];
    if(corner.is_vertex())
      return m_marks.vertex_across(corner.side, vertex_on_left_side(region, c));
    const Edge_point<FT> outward = m_marks.across(corner.side, corner.mark);
    return face_location(corner.arc_follows ? reversed(outward, m_other) : outward, m_other);
  }

  // Returns the position of a corner that is a vertex, on a halfedge of the other triangulation
  // with the region on its left.
  Edge_point<FT> vertex_on_left_side(const Region& region, std::size_t c) const
  {
    if(region[c].arc_follows) // towards a mark
      return {m_marks.across(region.next(c).side, region.next(c).mark).halfedge, FT(0)};
    const Region_corner& previous = region.previous(c);
    if(previous.arc_follows) // away from a mark
      return {m_other.opposite(m_marks.across(previous.side, previous.mark).halfedge), FT(1)};
    return {m_marks.outgoing_before(region[c].side), FT(0)};
  }

  const Marks& m_marks;
  const Delta_complex& m_other;
  Face_regions m_regions;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_MAP_H
