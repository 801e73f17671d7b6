// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_INPUT_MESH_H
#define INTRINSIC_INPUT_MESH_H

#include "Polygon_soup.h"
#include "Soup_repair.h"

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Triangles that are no surface, with their cover. Those of a cloud of points are around one point
// each.
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
  std::vector<std::int64_t> parents; // of the faces that were read, if polygons have been split
  CGAL::Intrinsic_triangulations::Input_diagnosis diagnosis;
  Repair_report repairs;

  // Of what was read.
  std::size_t number_of_vertices() const
  {
    return covered ? covered->soup.points.size() : mesh.number_of_vertices();
  }
};

// What a command accepts beside valid meshes.
struct Input_tolerance
{
  bool is_repair_wanted = false;
  bool is_strict = false; // no polygon is split into triangles
  bool are_zero_lengths_allowed = false;
  bool are_soups_allowed = false; // edges and vertices that are not manifold, any orientation
  std::size_t neighbors = 0;      // in a cloud of points; zero if there must be faces
};

// Reads a mesh; repairs, and notes unless `is_quiet`, are printed on standard error.
// Throws Program_error if the file cannot be read or if the mesh, repaired if wanted, has a fatal
// defect.
Input_mesh read_input(const std::string& path, const Input_tolerance& tolerance, bool is_quiet);

#endif // INTRINSIC_INPUT_MESH_H
