// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_mesh.h"

namespace {

template <class Faces>
Output_mesh points_and_polygons(const Mesh& mesh, const Faces& faces)
{
  Output_mesh result;
  result.points.assign(mesh.points().begin(), mesh.points().end());
  result.polygons = polygons_of(mesh, faces);
  return result;
}

} // namespace

Output_mesh output_mesh(const Mesh& mesh) { return points_and_polygons(mesh, mesh.faces()); }

Output_mesh output_mesh(const Polygon_soup& soup)
{
  Output_mesh result;
  result.points = soup.points;
  result.polygons = soup.polygons;
  return result;
}

Output_mesh output_mesh_with_edges(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces)
{
  Output_mesh result = points_and_polygons(mesh, faces);
  result.edges.reserve(mesh.number_of_edges());
  for(const Mesh::Edge_index e : mesh.edges())
    result.edges.push_back({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  return result;
}
