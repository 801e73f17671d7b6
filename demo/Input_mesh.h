// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_INPUT_MESH_H
#define INTRINSIC_INPUT_MESH_H

#include "Polygon_soup.h"
#include "Soup_repair.h"

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>

#include <string>

// A mesh that a command can work on, and what was done to it.
struct Input_mesh
{
  Mesh mesh;
  CGAL::Intrinsic_triangulations::Input_diagnosis diagnosis;
  Repair_report repairs;
};

// What a command accepts beside valid meshes.
struct Input_tolerance
{
  bool is_repair_wanted = false;
  bool are_zero_lengths_allowed = false;
};

// Reads a mesh; repairs, and notes unless `is_quiet`, are printed on standard error.
// Throws Program_error if the file cannot be read or if the mesh, repaired if wanted, has a fatal
// defect.
Input_mesh read_input(const std::string& path, const Input_tolerance& tolerance, bool is_quiet);

#endif // INTRINSIC_INPUT_MESH_H
