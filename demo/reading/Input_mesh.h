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

// Triangles that are not a surface, with their cover. Those of a cloud of points are around one
// point each.
struct Covered_soup
{
  Polygon_soup soup;
  bool is_cloud;
  CGAL::Intrinsic_triangulations::Tufted_cover<Point> cover;

  // The factor of operators.
  double share() const { return is_cloud ? 1. / 6 : 1. / 2; }
};

// A mesh that a command can work on, and what was done to it.
struct Input_mesh
{
  Mesh mesh; // the cover, if there is one
  std::optional<Covered_soup> covered;
  // The triangles that faces are, and the edges, if some of the faces have been left out.
  std::vector<Mesh::Face_index> kept_faces;
  std::vector<Mesh::Edge_index> kept_edges;
  std::vector<std::int64_t> parents; // of the faces that were read, if polygons have been split
  std::vector<bool> is_reversed;     // whether a face was read the other way around; empty if none
  CGAL::Intrinsic_triangulations::Input_diagnosis diagnosis;
  Repair_report repairs;
  Cracks cracks;      // of the mesh, unless it is a cover
  Triangle_data data; // at the vertices and triangles of what was read; these only if there are any

  // Of what was read.
  std::size_t number_of_vertices() const
  {
    return covered ? covered->soup.points.size() : mesh.number_of_vertices();
  }

  // The data of a point of the mesh.
  Point_weights weights(const CGAL::Intrinsic_triangulations::Vertex_weights<double>& w) const
  {
    Point_weights result{w.size, {}, w.weight};
    for(std::size_t c = 0; c < w.size; ++c)
      result.point[c] = covered ? covered->cover.input_vertex(w.vertex[c]) : w.vertex[c].idx();
    return result;
  }
  // The point in the face as it was read, with coordinates in the order of its corners there.
  // Without a cover, the function is its own inverse.
  Surface_location as_read(const Surface_location& p) const;

  // What was read as a face of the mesh; -1 for none.
  std::int64_t triangle(Mesh::Face_index f) const
  {
    if(!f.is_valid())
      return -1;
    if(!kept_faces.empty())
      f = kept_faces[f];
    return static_cast<std::int64_t>(covered ? covered->cover.input_face(f) : f.idx());
  }
};

// Reads the mesh of a command; repairs, and notes unless `is_quiet`, are printed on standard error.
// Throws Program_error if the file cannot be read or if the mesh, repaired if wanted, has a fatal
// defect.
Input_mesh read_input(const Common_options& options, bool is_quiet);

#endif // INTRINSIC_INPUT_MESH_H
