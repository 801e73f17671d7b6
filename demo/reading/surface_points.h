// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SURFACE_POINTS_H
#define INTRINSIC_SURFACE_POINTS_H

#include "reading/Input_mesh.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Returns the point of the mesh that `text` denotes. Throws Program_error for texts other than
// - the index of a vertex,
// - "FACE:a,b,c" with barycentric coordinates in the order of the corners of the face in the file,
// - "x,y,z" for the nearest point of the mesh, up to the tolerance of a Point_finder away.
// Precondition: if the mesh covers triangles, `text` is "x,y,z".
Surface_location surface_point(const std::string& text, const Input_mesh& input);

// Returns the point "FACE:a,b,c" of a triangulation with so many faces. Throws Program_error if it
// does not exist.
Surface_location face_point(const std::string& text, std::size_t number_of_faces);

// Returns the barycentric coordinates of the point of a triangle that is nearest to `p`.
std::array<double, 3> nearest_in_triangle(const Point& p, const std::array<Point, 3>& corners);

// Finds nearest points of a mesh.
class Point_finder
{
public:
  // The mesh has faces, and must outlive this object.
  explicit Point_finder(const Mesh& mesh);

  // Returns a twentieth of the diagonal of the mesh. Points farther away are not meant to be on it.
  double tolerance() const { return m_tolerance; }

  Surface_location operator()(const Point& p) const;

private:
  struct Ball // around a face
  {
    Point center;
    double radius;
  };

  const Mesh& m_mesh;
  std::vector<Ball> m_balls;
  double m_tolerance;
};

// Returns the vertex at `p`. Throws Program_error, which names the point `text`, if `p` is not a
// vertex.
CGAL::Intrinsic_triangulations::Vertex_index vertex_at(const Surface_location& p,
                                                       const std::string& text, const Mesh& mesh);

Point position(const Surface_location& p, const Mesh& mesh);

#endif // INTRINSIC_SURFACE_POINTS_H
