// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_PATH_CHECKS_H
#define INTRINSIC_TRIANGULATIONS_TEST_PATH_CHECKS_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Whether paths are connected and as long as they say.
namespace Test_surfaces {

using Path = IT::Surface_path<double>;
using Path_place = IT::Surface_place<double>;

inline bool is_vertex(const Path_place& p) { return IT::internal::is_corner(p.location.second); }

// The places in a face at which a path that has come to it can leave it, or end.
inline std::vector<Location> places_in(Face_index f, const Path_place& p, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  std::vector<Location> result;
  for(Halfedge_index h : faces.sides(f))
    if(!p.along.is_valid() ? h == mesh.halfedge(f)
       : is_vertex(p)      ? mesh.source(h) == mesh.source(p.along)
                           : h == p.along || h == mesh.opposite(p.along)) {
      const double t =
        is_vertex(p) || !p.along.is_valid() ? 0 : IT::edge_point(p.along, p.location, mesh).t;
      result.push_back(p.along.is_valid() ? faces.on(h, h == p.along   ? t
                                                        : is_vertex(p) ? 0
                                                                       : 1 - t)
                                          : p.location);
    }
  return result;
}

// A straight piece in a face; without a face if there is none.
struct Piece_of_path
{
  Location from, to;
};

// Within a face; coordinates need not sum up to one exactly.
inline Real length(const Piece_of_path& piece, const Flat_faces& faces)
{
  if(piece.from.first == Delta_complex::null_face() || piece.from.first != piece.to.first)
    return std::numeric_limits<Real>::infinity();
  const Halfedge_index h = faces.mesh().halfedge(piece.from.first);
  return norm(faces.place(h, piece.from) - faces.place(h, piece.to));
}

// An edge from one place to the next, which are vertices.
inline Piece_of_path edge_of_path(const Path_place& p, const Path_place& q, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  if(mesh.source(p.along) != mesh.source(q.along) && mesh.target(p.along) != mesh.source(q.along))
    return {{Delta_complex::null_face(), {}}, {}};
  const bool is_border = mesh.is_border(p.along);
  const Halfedge_index h = is_border ? mesh.opposite(p.along) : p.along;
  return {faces.on(h, is_border), faces.on(h, !is_border)};
}

// Between two places on one edge that are not both its ends.
inline Piece_of_path part_of_edge(const Path_place& p, const Path_place& q, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Halfedge_index h = mesh.is_border(p.along) ? mesh.opposite(p.along) : p.along;
  const auto on = [&](const Path_place& x) {
    const bool is_border = mesh.is_border(x.along);
    const Halfedge_index inner = is_border ? mesh.opposite(x.along) : x.along;
    const double t =
      is_vertex(x) ? (x.along == inner ? 0 : 1) : IT::edge_point(inner, x.location, mesh).t;
    return faces.on(h, inner == h ? t : 1 - t);
  };
  return {on(p), on(q)};
}

// Whether a place is that of a vertex inserted on an edge; its face need not be the one before it.
inline bool is_inserted_on_edge(const Path_place& p, const Flat_faces& faces)
{
  const auto& inserted = faces.triangulation().inserted_vertices();
  const auto is_at = [&](const Path_place& v) {
    if(!v.along.is_valid() || Edge_index(v.along) != Edge_index(p.along))
      return false;
    const double s = IT::edge_point(v.along, v.location, faces.mesh()).t,
                 t = IT::edge_point(p.along, p.location, faces.mesh()).t;
    return std::abs((v.along == p.along ? s : 1 - s) - t) < 1e-12;
  };
  return &faces.mesh() == &faces.triangulation().input_mesh() &&
         std::any_of(inserted.begin(), inserted.end(), is_at);
}

// Piece `k` in the face in which it runs.
inline Piece_of_path piece_of_path(const Path& path, std::size_t k, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Path_place &p = path.places[k], &q = path.places[k + 1];
  if(is_vertex(p) && is_vertex(q))
    return edge_of_path(p, q, faces);
  if(p.along.is_valid() && q.along.is_valid() && !is_vertex(q) &&
     mesh.edge(p.along) == mesh.edge(q.along))
    return part_of_edge(p, q, faces);
  const bool is_crossing =
    k > 0 && p.along.is_valid() && !is_vertex(p) && !mesh.is_border(mesh.opposite(p.along));
  const Face_index f = is_crossing          ? mesh.face(mesh.opposite(p.along))
                       : p.along.is_valid() ? mesh.face(p.along)
                                            : p.location.first;
  const Location start =
    is_crossing ? faces.on(mesh.opposite(p.along), 1 - IT::edge_point(p.along, p.location, mesh).t)
    : is_vertex(p) ? faces.on(p.along, 0)
                   : p.location;
  if(q.along.is_valid() && !is_vertex(q) && k + 2 < path.places.size() &&
     !is_inserted_on_edge(q, faces))
    return {start, q.location};
  if(is_crossing && is_vertex(q) && !is_inserted_on_edge(p, faces) &&
     mesh.source(q.along) == mesh.target(mesh.next(mesh.opposite(p.along))))
    return {start, faces.apex(mesh.opposite(p.along))};
  Piece_of_path result{start, {Delta_complex::null_face(), {}}};
  if(f != Delta_complex::null_face())
    for(const Location& end : places_in(f, q, faces))
      if(length({start, end}, faces) < length(result, faces))
        result.to = end;
  return result;
}

inline Real sum_of_pieces(const Path& path, const Flat_faces& faces)
{
  Real sum = 0;
  for(std::size_t k = 0; k + 1 < path.places.size(); ++k)
    sum += length(piece_of_path(path, k, faces), faces);
  return sum;
}

// Its pieces add up; they are in one face each.
inline void expect_valid(const Path& path, const Flat_faces& faces, double tolerance)
{
  EXPECT_NEAR(static_cast<double>(sum_of_pieces(path, faces)), path.length, tolerance)
    << path.places.size();
}

// ---- Surfaces on which brute force finds distances ----

inline std::vector<Named_mesh> small_meshes()
{
  return {
    {"tetrahedron", tetrahedron()},
    {"octahedron", octahedron()},
    {"cube", cube()},
    {"random sphere", random_sphere(9, 3)},
    {"spikes", perturbed(random_sphere(9, 4), 0.8, 1)},
    {"double disk", perturbed(bipyramid(5, 0), 0.2, 2)},
    {"torus", embedded_torus(4, 3)},
    {"rough torus", perturbed(embedded_torus(4, 3), 0.5, 3)},
    {"holes", punctured(perturbed(embedded_torus(4, 3), 0.3, 6), {1, 16})},
    {"grid", perturbed(grid(3, 2, [](double x, double y) { return Point(x, y, 0); }), 0.4, 4)}};
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_PATH_CHECKS_H
