// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CONVEX_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CONVEX_POSITIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Polyhedron_certificate.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Precise_vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

typedef Exact_predicates_inexact_constructions_kernel Polyhedron_kernel;
typedef std::vector<Polyhedron_kernel::Point_3> Polyhedron_points;

// Decides about positions of type `double`, exactly.
struct Rounded_orientation
{
  typedef Polyhedron_points Points;

  Orientation operator()(const Points& points, const std::array<Vertex_index, 4>& v) const
  {
    return CGAL::orientation(points[v[0].idx()], points[v[1].idx()], points[v[2].idx()],
                             points[v[3].idx()]);
  }
};

// Decides about positions before they are rounded.
struct Precise_orientation
{
  typedef std::vector<Precise_vector> Points;

  double error = 0x1p-95; // of products, relative

  Orientation operator()(const Points& points, const std::array<Vertex_index, 4>& v) const
  {
    return orientation(points[v[0].idx()], points[v[1].idx()], points[v[2].idx()],
                       points[v[3].idx()], error);
  }
};

// Returns the side of the plane of the face of `h` on which the other face at `h` has its third
// corner: POSITIVE is outside.
template <typename Orientation_of>
Orientation side_of_neighbor(Halfedge_index h, const Delta_complex& mesh,
                             const typename Orientation_of::Points& points,
                             const Orientation_of& orientation)
{
  return orientation(points, {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)),
                              mesh.target(mesh.next(opposite(h)))});
}

// Flips edges that are concave, in faces of more than three vertices as a rule. Each flip makes the
// polyhedron larger. Returns the number of flips.
template <typename Orientation_of, typename Is_flippable, typename Flip>
std::size_t flip_concave_edges(const Delta_complex& mesh,
                               const typename Orientation_of::Points& points,
                               const Orientation_of& orientation, const Is_flippable& is_flippable,
                               const Flip& flip)
{
  const auto is_good = [&](Edge_index e) {
    const Halfedge_index h = mesh.halfedge(e);
    return side_of_neighbor(h, mesh, points, orientation) != POSITIVE || !is_flippable(h);
  };
  Edge_stack stack(mesh.num_edges());
  for(Edge_index e : mesh.edges())
    stack.push_if(!is_good(e), e);
  return flip_within_limit(
           mesh, stack, 10 * std::size_t(mesh.num_edges()), [](Edge_index) { return false; },
           is_good, [&](Halfedge_index h) { return flip(h), true; })
    .flips;
}

// Returns the corners of the face of `h`, beginning with the source of `h`.
inline std::array<Polyhedron_kernel::Point_3, 3>
corners_in_space(Halfedge_index h, const Delta_complex& mesh, const Polyhedron_points& points)
{
  return {points[mesh.source(h).idx()], points[mesh.target(h).idx()],
          points[mesh.target(mesh.next(h)).idx()]};
}

// Returns the solid angle of a triangle, seen from the origin (van Oosterom and Strackee 1983).
inline double solid_angle(const std::array<Polyhedron_kernel::Point_3, 3>& corner)
{
  const Polyhedron_kernel::Vector_3 a = corner[0] - CGAL::ORIGIN, b = corner[1] - CGAL::ORIGIN,
                                    c = corner[2] - CGAL::ORIGIN;
  const double la = std::sqrt(a.squared_length()), lb = std::sqrt(b.squared_length()),
               lc = std::sqrt(c.squared_length());
  return 2 * std::atan2(CGAL::cross_product(a, b) * c,
                        la * lb * lc + (a * b) * lc + (b * c) * la + (c * a) * lb);
}

// Decides whether a surface is convex. If the origin sees each face from inside, the surface covers
// the sphere of directions. It is convex if it covers this sphere once and no edge is concave.
// Signs are decided with `points`, whose rounded positions are `rounded`.
template <typename Orientation_of>
Polyhedron_certificate
certified_polyhedron(const Delta_complex& mesh, typename Orientation_of::Points points,
                     const Polyhedron_points& rounded, const Orientation_of& orientation)
{
  Polyhedron_certificate result;
  double angle = 0;
  for(Edge_index e : mesh.edges()) {
    const Orientation side = side_of_neighbor(mesh.halfedge(e), mesh, points, orientation);
    ++(side == NEGATIVE   ? result.convex_edges
       : side == POSITIVE ? result.concave_edges
                          : result.flat_edges);
  }
  const Vertex_index center(static_cast<unsigned>(points.size()));
  points.push_back({0, 0, 0});
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    result.hidden_faces += orientation(points, {mesh.source(h), mesh.target(h),
                                                mesh.target(mesh.next(h)), center}) != NEGATIVE;
    angle += solid_angle(corners_in_space(h, mesh, rounded));
  }
  result.degree = static_cast<int>(std::lround(angle / (4 * pi<double>())));
  return result;
}

// Returns the orientation of three points in the plane z = 0.
inline Orientation orientation_in_plane(const std::array<Polyhedron_kernel::Point_3, 3>& p)
{
  const auto projected = [](const Polyhedron_kernel::Point_3& q) {
    return Polyhedron_kernel::Point_2(q.x(), q.y());
  };
  return CGAL::orientation(projected(p[0]), projected(p[1]), projected(p[2]));
}

// Returns the exterior angle at the second of three points of a polyline in the plane z = 0.
inline double turn_in_plane(const std::array<Polyhedron_kernel::Point_3, 3>& p)
{
  const auto u = p[1] - p[0], v = p[2] - p[1];
  return std::atan2(u.x() * v.y() - u.y() * v.x(), u.x() * v.x() + u.y() * v.y());
}

// Counts the faces and edges of a polygon that is covered twice. Returns its sides, as halfedges of
// the faces above.
inline std::vector<Halfedge_index> count_elements(const Delta_complex& mesh,
                                                  const Polyhedron_points& points,
                                                  Polyhedron_certificate& result)
{
  const auto side = [&](Halfedge_index h) {
    return orientation_in_plane(corners_in_space(h, mesh, points));
  };
  std::vector<Halfedge_index> rim;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    if(side(h) == side(opposite(h)))
      ++result.flat_edges;
    else
      rim.push_back(side(h) == COUNTERCLOCKWISE ? h : opposite(h));
  }
  result.convex_edges = rim.size();
  for(Face_index f : mesh.faces())
    result.hidden_faces += side(mesh.halfedge(f)) == COLLINEAR;
  return rim;
}

// Decides whether a polygon in the plane z = 0 that is covered twice is convex. `flat_edges` are
// its diagonals on both sides, `convex_edges` its sides. An angle of the polygon is the angle of
// the faces above it.
inline Polyhedron_certificate certified_polygon(const Delta_complex& mesh,
                                                const Polyhedron_points& points)
{
  Polyhedron_certificate result;
  result.is_flat = true;
  const std::vector<Halfedge_index> rim = count_elements(mesh, points, result);
  const std::size_t none = mesh.num_vertices();
  std::vector<std::size_t> next(none, none);
  for(Halfedge_index h : rim)
    next[mesh.source(h).idx()] = mesh.target(h).idx();
  double turns = 0;
  for(Halfedge_index h : rim) {
    const std::size_t i = mesh.source(h).idx(), j = next[i], k = next[j];
    if(k == none) {
      ++result.concave_edges;
      continue;
    }
    result.concave_edges += orientation_in_plane({points[i], points[j], points[k]}) == CLOCKWISE;
    turns += turn_in_plane({points[i], points[j], points[k]});
  }
  result.degree =
    rim.size() == none ? static_cast<int>(std::lround(turns / (2 * pi<double>()))) : 0;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CONVEX_POSITIONS_H
