// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_MESH_H
#define INTRINSIC_MAP_MESH_H

#include "writing/Map_part.h"
#include "writing/Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>

#include <vector>

using Conformal_map = CGAL::Discrete_conformal_maps::Discrete_conformal_map;
using Planar_map = CGAL::Discrete_conformal_maps::Planar_conformal_map;
using Hyperbolic_map = CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map;
using Spherical_map = CGAL::Discrete_conformal_maps::Spherical_conformal_map;

using Cones = std::vector<Mesh::Vertex_index>;

// Return the common subdivision of the three triangulations of a map, with the map, restricted to
// the input. The vertices that are mapped come first. In the following, -1 means none:
// - a vertex has the number of the input vertex;
// - an edge or a face has the edges or faces of the three triangulations that contain it.
// Indices in the input refer to the input. Indices in the other two refer to the double, if the
// input has a boundary.

// Returns the mesh on the input, with the map as texture. It consists of homogeneous coordinates (x
// w, y w, w), which are linear on each face. Otherwise it consists of positions (x, y), between
// which the map is projective. Vertices have the logarithmic scale factor (linear on faces of the
// input), and whether they are cones. Edges have whether their two faces are apart in the plane.
Output_mesh flat_mesh(const Planar_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous);

// Returns the mesh. Homogeneous coordinates belong to the Klein disk, positions to the Poincare
// disk.
Output_mesh flat_mesh(const Hyperbolic_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous);

// Returns the mesh on the unit sphere. Vertices have the logarithmic scale factor, which is zero
// outside of the input. They also have the position in the input (input_x, ...), and homogeneous
// coordinates (homogeneous_x, ..., _w), which are linear on faces of the subdivision. The texture
// of a disk is its image in the unit disk.
Output_mesh sphere_mesh(const Spherical_map& map, const Map_part& part);

#endif // INTRINSIC_MAP_MESH_H
