// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_POLYGON_SOUP_H
#define INTRINSIC_POLYGON_SOUP_H

#include "reading/Mesh_data.h"
#include "reading/Polygons.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// Stores a mesh with the indices of its file.
struct Polygon_soup
{
  std::vector<Point> points;
  Polygons polygons;
  std::string format;             // that of the content, if the extension names another
  std::size_t merged_corners = 0; // of a format that has no indices
  std::vector<std::int64_t>
    parents; // of triangles, the polygons they are parts of, if there are any

  std::vector<bool> is_reversed; // whether a repair has reversed a polygon; empty if none
  Mesh_data data;
};

// Copies corner data and groups from polygons to their parts. Part i is part of polygon
// `parents[i]`, and has corners of this polygon.
void carry_to_parts(const Polygons& polygons, const std::vector<std::int64_t>& parents,
                    const Polygons& parts, Mesh_data& data);

// Builds the mesh of a soup. Vertices and faces keep their indices, isolated vertices too. Edges
// are numbered in the order of faces: first the edges that a face follows from the smaller to the
// larger index, then the others. The first halfedge of an edge leads to the larger index. The
// halfedge of a face leaves its first corner, so barycentric coordinates are in the order of the
// soup.
// Precondition: the diagnosis of the soup is valid, except for faces that are not triangles.
Mesh mesh_of(const Polygon_soup& soup);

// Returns the connectivity that `mesh_of()` builds, without points, if the polygons are triangles
// and form a surface. Otherwise, returns nothing: a diagnosis names the defects, and takes longer.
std::optional<CGAL::Intrinsic_triangulations::Delta_complex>
complex_of(std::size_t number_of_points, const Polygons& polygons);

// Returns the corners of a face in the order of barycentric coordinates, from the source of its
// halfedge.
template <class Any_mesh, class Faces>
Polygons polygons_of(const Any_mesh& mesh, const Faces& faces)
{
  Polygons result;
  result.reserve(faces.size(), 3 * faces.size());
  for(const typename Any_mesh::Face_index f : faces) {
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result.add_corner(mesh.source(h));
    result.close();
  }
  return result;
}

#endif // INTRINSIC_POLYGON_SOUP_H
