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

// Return the common subdivision of the three triangulations of a map, as far as it belongs to the
// input, with the map. The vertices that are mapped come first. What -1 stands for none of:
// - of a vertex: the number of the input vertex;
// - of an edge and of a face: the edges and faces of the three of which it is a part. Those of the
//   input have their indices there; those of the other two are of the double, if there is a
//   boundary.

// On the input, with the map as texture: in homogeneous coordinates (x w, y w, w), which are linear
// on each face, or as positions (x, y), between which the map is projective, not linear. Vertices
// have whether a cone is there, and the logarithmic scale factor (linear on faces of the input);
// edges, whether their two faces are apart in the plane.
Output_mesh flat_mesh(const Planar_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous);

// Homogeneous coordinates are those of Klein's disk, positions those in the Poincare disk.
Output_mesh flat_mesh(const Hyperbolic_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous);

// On the unit sphere. Vertices have the logarithmic scale factor, zero elsewhere than in the input,
// the place in the input (input_x, ...), and homogeneous coordinates (homogeneous_x, ..., _w),
// which are linear on faces of the subdivision. Of a disk, the texture is its image in the unit
// disk.
Output_mesh sphere_mesh(const Spherical_map& map, const Map_part& part);

#endif // INTRINSIC_MAP_MESH_H
