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

// Whether a point may be further away from a mesh than the tolerance of a Point_finder.
enum class Reach
{
  nearby,
  anywhere
};

// The point of the mesh that `text` stands for: a vertex by its index, "FACE:a,b,c" with
// barycentric coordinates in the order of the corners of the face in the file, or "x,y,z", the
// nearest point of the mesh. Throws Program_error if it stands for none.
// Precondition: if the mesh covers triangles, `text` is "x,y,z".
Surface_location surface_point(const std::string& text, const Input_mesh& input,
                               Reach reach = Reach::nearby);

// The point "FACE:a,b,c" of a triangulation with so many faces. Throws Program_error if there is
// none.
Surface_location face_point(const std::string& text, std::size_t number_of_faces);

// The barycentric coordinates of the point of a triangle that is nearest to `p`.
std::array<double, 3> nearest_in_triangle(const Point& p, const std::array<Point, 3>& corners);

// Finds nearest points of a mesh.
class Point_finder
{
public:
  // The mesh has faces, and stays.
  explicit Point_finder(const Mesh& mesh);

  // Points further away are not meant to be on the mesh: a twentieth of its diagonal.
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

// The vertex at `p`. Throws Program_error, which names the point `text`, if there is none.
CGAL::Intrinsic_triangulations::Vertex_index vertex_at(const Surface_location& p,
                                                       const std::string& text, const Mesh& mesh);

Point position(const Surface_location& p, const Mesh& mesh);

#endif // INTRINSIC_SURFACE_POINTS_H
