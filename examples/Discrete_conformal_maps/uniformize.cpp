// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gives a surface the conformal metric of constant curvature that suits its topology. Prints the
// modulus of a torus, or the generators of the group of a hyperbolic surface.

#include <CGAL/Discrete_conformal_maps/uniformize.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off"),
                                  mesh))
    return 1;

  const DCM::Uniformization result = DCM::uniformize(mesh);
  std::cout << "the surface is of the type " << DCM::to_string(result.type) << '\n';
  if(result.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(result.status()) << '\n';
    return 1;
  }
  if(result.modulus)
    std::cout << "its modulus is " << *result.modulus << '\n';
  if(result.hyperbolic()) {
    std::cout << "its area is " << result.hyperbolic()->area() << '\n';
    for(const DCM::Disk_motion<>& motion : result.hyperbolic()->group(0).generators)
      std::cout << "z -> (" << motion.a() << " z + " << motion.b() << ") / ("
                << std::conj(motion.b()) << " z + " << std::conj(motion.a()) << ")\n";
  }
  return 0;
}
