// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FINE_DATA_H
#define INTRINSIC_FINE_DATA_H

#include "commands/triangulation_stages.h"
#include "reading/Input_mesh.h"

#include <CGAL/Intrinsic_simplification/Surface_level.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

// How the fine level of a simplification came from the input.
struct Fine_level
{
  const CGAL::Intrinsic_simplification::Delta_complex& mesh;
  const Triangulation* refined; // the input with inserted vertices; null if there are none
  // Of each vertex that closing loops and cutting handles added, those it is in the middle of.
  const std::vector<std::vector<Mesh::Vertex_index>>& sources;
  std::function<Mesh::Face_index(Mesh::Face_index)> input_face; // null for none
};

// The data of the input on the fine level.
Triangle_data fine_data(const Input_mesh& input, const Fine_level& level);

#endif // INTRINSIC_FINE_DATA_H
