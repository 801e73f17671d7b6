// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a mesh with good angles on the surface of another mesh, for programs without intrinsic
// triangulations.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/anchor.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return 1;
  }
  IT::Intrinsic_triangulation<> tri(mesh);
  const IT::Refinement_result result =
    IT::refine(tri, IT::parameters::minimum_angle(25).simplicial(true));
  const Mesh refined = IT::extrinsic_mesh(tri, mesh.points());
  std::cout << result.insertions << " vertices inserted (" << to_string(result.status) << "), "
            << refined.number_of_faces() << " faces, "
            << (CGAL::is_valid_polygon_mesh(refined) ? "valid" : "not valid") << '\n';
  if(argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], refined))
    return 1;
  return 0;
}
