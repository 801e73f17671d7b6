// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_PATH_CHECKS_H
#define INTRINSIC_TRIANGULATIONS_TEST_PATH_CHECKS_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Surface_path.h>

// Whether paths are connected and as long as they say.
namespace Test_surfaces {

using Path = IT::Surface_path<double>;
using Path_place = IT::Surface_point<double>;

inline Halfedge_index along(const Path_place& p) { return IT::halfedge_of(p); }

inline bool is_vertex(const Path_place& p) { return IT::is_at_vertex(p); }

// Returns the position on a halfedge of its edge.
inline double place_on(Halfedge_index h, const Path_place& p)
{
  if(is_vertex(p))
    return h == along(p) ? 0 : 1;
  return IT::on_edge(p)->weight[h == along(p) ? 1 : 0];
}

// Returns the positions in a face at which a path that has entered it can leave it, or end.
inline std::vector<Location> places_in(Face_index f, const Path_place& p, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  if(!along(p).is_valid())
    return {IT::face_location(p, mesh)};
  std::vector<Location> result;
  for(Halfedge_index h : faces.sides(f))
    if(is_vertex(p) ? mesh.source(h) == mesh.source(along(p))
                    : Edge_index(h) == Edge_index(along(p)))
      result.push_back(faces.on(h, is_vertex(p) ? 0 : place_on(h, p)));
  return result;
}

// Represents a straight piece in a face, or without a face if none exists.
struct Piece_of_path
{
  Location from, to;
};

// Returns the length within a face. Coordinates need not sum up to one exactly.
inline Real length(const Piece_of_path& piece, const Flat_faces& faces)
{
  if(piece.from.first == Delta_complex::null_face() || piece.from.first != piece.to.first)
    return std::numeric_limits<Real>::infinity();
  const Halfedge_index h = faces.mesh().halfedge(piece.from.first);
  return norm(faces.place(h, piece.from) - faces.place(h, piece.to));
}

// Returns an edge from one position to the next, which are vertices.
inline Piece_of_path edge_of_path(const Path_place& p, const Path_place& q, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  if(mesh.source(along(p)) != mesh.source(along(q)) &&
     mesh.target(along(p)) != mesh.source(along(q)))
    return {{Delta_complex::null_face(), {}}, {}};
  const bool is_border = mesh.is_border(along(p));
  const Halfedge_index h = is_border ? mesh.opposite(along(p)) : along(p);
  return {faces.on(h, is_border), faces.on(h, !is_border)};
}

// Returns the part between two positions on one edge that are not both its ends.
inline Piece_of_path part_of_edge(const Path_place& p, const Path_place& q, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Halfedge_index h = mesh.is_border(along(p)) ? mesh.opposite(along(p)) : along(p);
  const auto on = [&](const Path_place& x) { return faces.on(h, place_on(h, x)); };
  return {on(p), on(q)};
}

// Whether a place is that of a vertex inserted on an edge; its face need not be the one before it.
inline bool is_inserted_on_edge(const Path_place& p, const Flat_faces& faces)
{
  const auto& inserted = faces.triangulation().inserted_vertices();
  const auto is_at = [&](const Path_place& v) {
    return IT::on_edge(v) && Edge_index(along(v)) == Edge_index(along(p)) &&
           std::abs(place_on(along(p), v) - place_on(along(p), p)) < 1e-12;
  };
  return &faces.mesh() == &faces.triangulation().input_mesh() &&
         std::any_of(inserted.begin(), inserted.end(), is_at);
}

// Returns piece `k` in its face.
inline Piece_of_path piece_of_path(const Path& path, std::size_t k, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Path_place &p = path.places[k], &q = path.places[k + 1];
  if(is_vertex(p) && is_vertex(q))
    return edge_of_path(p, q, faces);
  if(along(p).is_valid() && along(q).is_valid() && !is_vertex(q) &&
     mesh.edge(along(p)) == mesh.edge(along(q)))
    return part_of_edge(p, q, faces);
  const bool is_crossing =
    k > 0 && along(p).is_valid() && !is_vertex(p) && !mesh.is_border(mesh.opposite(along(p)));
  const Face_index f = is_crossing           ? mesh.face(mesh.opposite(along(p)))
                       : along(p).is_valid() ? mesh.face(along(p))
                                             : IT::face_location(p, mesh).first;
  const Location start = is_crossing
                           ? faces.on(mesh.opposite(along(p)), place_on(mesh.opposite(along(p)), p))
                         : is_vertex(p) ? faces.on(along(p), 0)
                                        : IT::face_location(p, mesh);
  if(along(q).is_valid() && !is_vertex(q) && k + 2 < path.places.size() &&
     !is_inserted_on_edge(q, faces))
    return {start, IT::face_location(q, mesh)};
  if(is_crossing && is_vertex(q) && !is_inserted_on_edge(p, faces) &&
     mesh.source(along(q)) == mesh.target(mesh.next(mesh.opposite(along(p)))))
    return {start, faces.apex(mesh.opposite(along(p)))};
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

// Checks that the lengths of pieces add up, and each piece is in one face.
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
