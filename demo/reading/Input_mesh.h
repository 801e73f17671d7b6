// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_INPUT_MESH_H
#define INTRINSIC_INPUT_MESH_H

#include "commands/options.h"
#include "reading/Polygon_soup.h"
#include "reading/Soup_repair.h"
#include "reading/close_points.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

using Surface_location = CGAL::Intrinsic_triangulations::Face_location<double>;

// Stores triangles that are not a surface, with their cover. The triangles of a cloud of points
// belong to one point each.
struct Covered_soup
{
  Polygon_soup soup;
  bool is_cloud;
  CGAL::Intrinsic_triangulations::Tufted_cover<Point> cover;

  // Returns the factor of operators.
  double share() const { return is_cloud ? 1. / 6 : 1. / 2; }
};

// Stores a mesh that a command can process, and its changes since it was read.
struct Input_mesh
{
  Mesh mesh; // the cover, if there is one
  std::optional<Covered_soup> covered;
  // Stores the triangles of the faces, and the edges, if some of the faces have been omitted.
  std::vector<Mesh::Face_index> kept_faces;
  std::vector<Mesh::Edge_index> kept_edges;
  std::vector<std::int64_t> parents; // of the faces that were read, if polygons have been split
  std::vector<bool> is_reversed;     // whether a face was read the other way around; empty if none
  CGAL::Intrinsic_triangulations::Input_diagnosis diagnosis;
  Repair_report repairs;
  Cracks cracks;      // of the mesh, unless it is a cover
  Triangle_data data; // at the vertices and triangles of what was read; these only if there are any

  // Returns the number of vertices that were read.
  std::size_t number_of_vertices() const
  {
    return covered ? covered->soup.points.size() : mesh.number_of_vertices();
  }

  // Returns the weights for the data of a point of the mesh.
  Point_weights weights(const CGAL::Intrinsic_triangulations::Vertex_weights<double>& w) const
  {
    Point_weights result{w.size, {}, w.weight};
    for(std::size_t c = 0; c < w.size; ++c)
      result.point[c] = covered ? covered->cover.input_vertex(w.vertex[c]) : w.vertex[c].idx();
    return result;
  }
  // Returns the point in the face that was read, with coordinates in the order of its corners.
  // Without a cover, the function is its own inverse.
  Surface_location as_read(const Surface_location& p) const;

  // Returns the number of the triangle that was read as a face of the mesh, or -1 for none.
  std::int64_t triangle(Mesh::Face_index f) const
  {
    if(!f.is_valid())
      return -1;
    if(!kept_faces.empty())
      f = kept_faces[f];
    return static_cast<std::int64_t>(covered ? covered->cover.input_face(f) : f.idx());
  }
};

// Reads the mesh of a command. Repairs, and notes unless `is_quiet`, are printed on standard error.
// Throws Program_error if the file cannot be read, or if the mesh, possibly repaired, has a fatal
// defect.
Input_mesh read_input(const Common_options& options, bool is_quiet);

#endif // INTRINSIC_INPUT_MESH_H
