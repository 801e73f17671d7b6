// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances on the intrinsic Delaunay triangulation of an OpenMesh, and keeps them in a
// property of its vertices.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

struct Double_precision : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};
typedef OpenMesh::TriMesh_ArrayKernelT<Double_precision> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh,
                              argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off")))
    return 1;
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const auto distance = IT::heat_distance(tri.intrinsic(), IT::Vertex_index(0));

  OpenMesh::VPropHandleT<double> property;
  mesh.add_property(property, "distance");
  Mesh::VertexHandle farthest(0);
  for(const Mesh::VertexHandle v : mesh.vertices()) {
    mesh.property(property, v) = distance[v.idx()];
    if(mesh.property(property, v) > mesh.property(property, farthest))
      farthest = v;
  }
  std::cout << "the farthest vertex is at " << mesh.point(farthest) << ", at a distance of "
            << mesh.property(property, farthest) << '\n';
}
