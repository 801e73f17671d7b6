// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLAT_MESH_H
#define INTRINSIC_FLAT_MESH_H

#include "commands/Statistics.h"
#include "writing/Map_front.h"
#include "writing/Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>

#include <vector>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input,
// with the map as texture: in homogeneous coordinates (x w, y w, w), which are linear on each face,
// or as positions (x, y), between which the map is projective, not linear. The vertices of the
// input come first. -1 stands for none:
// - of a vertex: the number of the input vertex, whether a cone is there, and the logarithmic scale
//   factor (linear on faces of the input);
// - of an edge: the edges of the three triangulations of which it is a part, and whether its two
//   faces are apart in the plane;
// - of a face: the faces of the three of which it is a part.
// In the edges and faces of the input, these have their indices; those of the other two are of the
// double, if there is a boundary.
Output_mesh flat_mesh(const CGAL::Discrete_conformal_maps::Planar_conformal_map& map,
                      const Map_front& front, const std::vector<Mesh::Vertex_index>& cones,
                      bool is_homogeneous);

// As `flat_mesh()`, for a map to the hyperbolic plane: homogeneous coordinates are those of Klein's
// disk, positions those in the Poincare disk.
Output_mesh flat_mesh(const CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map& map,
                      const Map_front& front, const std::vector<Mesh::Vertex_index>& cones,
                      bool is_homogeneous);

// The polygons that have a triangle that is flipped in the plane, as `describe_triangles()` counts
// them.
std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh);

// Adds how many triangles are flipped in the plane or have no area there, with linear texture
// coordinates. Polygons are cut into triangles from their first corners. Of slivers, triangles of
// which rounding of their points may have taken all area in space, both are counted apart.
void describe_triangles(Statistics& statistics, const Output_mesh& mesh);

#endif // INTRINSIC_FLAT_MESH_H
