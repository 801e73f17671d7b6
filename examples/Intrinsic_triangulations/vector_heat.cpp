// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Transports a tangent vector from a vertex to all others by the vector heat method, on the
// intrinsic Delaunay triangulation of a mesh. The length of the vector stays the same.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const IT::Vector_heat<> heat(tri.intrinsic());
  const auto field = heat.transport(IT::Vertex_index(0), std::complex<double>(2, 0));
  std::cout << "lengths from " << field.cwiseAbs().minCoeff() << " to "
            << field.cwiseAbs().maxCoeff() << '\n';
  for(const Eigen::Index v : {1000, 2000})
    std::cout << "at vertex " << v << ": " << std::arg(field[v])
              << " radians from the first outgoing halfedge\n";
}
