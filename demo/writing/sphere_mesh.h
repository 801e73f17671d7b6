// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SPHERE_MESH_H
#define INTRINSIC_SPHERE_MESH_H

#include "writing/Map_front.h"
#include "writing/Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>

#include <string>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input,
// with points on the unit sphere. The vertices of the input come first. -1 stands for none:
// - of a vertex: the number of the input vertex, the logarithmic scale factor at vertices of the
//   input and zero elsewhere, its place in the input (input_x, ...), and homogeneous coordinates
//   (homogeneous_x, ..., _w), which are linear on faces of the subdivision;
// - of an edge and of a face: the edges and faces of the three triangulations of which it is a
// part. Of a disk, the texture is its image in the unit disk.
Output_mesh sphere_mesh(const CGAL::Discrete_conformal_maps::Spherical_conformal_map& map,
                        const Map_front& front);

// A line "x y z", with all digits that the map has, for a vertex of the input.
std::string precise_position(const CGAL::Discrete_conformal_maps::Spherical_conformal_map& map,
                             Mesh::Vertex_index v);

// Lines "index x y z", with all digits that the map has, for each vertex of the input.
std::string precise_positions(const CGAL::Discrete_conformal_maps::Spherical_conformal_map& map,
                              const Mesh& input);

#endif // INTRINSIC_SPHERE_MESH_H
