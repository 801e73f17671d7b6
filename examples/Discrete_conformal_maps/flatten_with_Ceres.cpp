// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens a surface with the minimizers of this package and of the Ceres Solver.

#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

void print(const char* name, const DCM::Planar_conformal_map& map)
{
  const DCM::Minimization_result& result = map.minimization();
  std::cout << name << ": " << to_string(result.status) << " after " << result.iterations
            << " steps, with " << result.evaluations << " evaluations and " << result.factorizations
            << " factorizations\n";
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  const DCM::Planar_conformal_map newton = DCM::flatten(mesh);
  const DCM::Planar_conformal_map ceres =
    DCM::flatten(mesh, DCM::parameters::minimizer(DCM::Ceres_minimizer()));
  if(newton.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(newton.status()) << '\n';
    return 1;
  }
  if(ceres.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(ceres.status()) << '\n';
    return 1;
  }
  print("Newton", newton);
  print("Ceres", ceres);

  double difference = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    difference = (std::max)(difference, std::abs(newton.log_scale(v) - ceres.log_scale(v)));
  std::cout << "scale factors agree to 1e-9: " << (difference < 1e-9 ? "yes" : "no") << '\n';
}
