// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the edge of the intrinsic Delaunay triangulation that crosses most edges of the mesh, and
// traces it over the mesh.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/trace.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// `mesh` has no removed elements, so its halfedges have the same indices in T1.
Point position(const IT::Edge_point<double>& p, const Mesh& mesh)
{
  const Point &source = mesh.point(mesh.source(p.halfedge)),
              &target = mesh.point(mesh.target(p.halfedge));
  return source + p.t * (target - source);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);

  const auto n = tri.coordinates().normal_coordinate_map();
  const auto edges = tri.mesh().edges();
  const IT::Edge_index e = *std::max_element(
    edges.begin(), edges.end(), [&](IT::Edge_index a, IT::Edge_index b) { return n[a] < n[b]; });

  std::cout << "edge " << e << " of length " << tri.length(e) << " crosses " << n[e] << " edges\n";
  for(const auto& p : IT::trace_intrinsic_edge(tri, tri.mesh().halfedge(e)))
    std::cout << "at " << p.on_intrinsic.t << ": " << position(p.on_input, mesh) << '\n';
}
