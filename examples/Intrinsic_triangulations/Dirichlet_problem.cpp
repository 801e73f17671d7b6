// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Dirichlet problem: a harmonic function has the heights of the vertices on the boundary.
// It is computed on the intrinsic Delaunay triangulation, where it satisfies the maximum principle.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <limits>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);

  const auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(mesh.number_of_vertices());
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(mesh.is_border(v)) {
      is_fixed[v] = true;
      values[v] = mesh.point(v).z();
      lowest = (std::min)(lowest, values[v]);
      highest = (std::max)(highest, values[v]);
    }

  // The right-hand side of a harmonic function is zero.
  const IT::Poisson_solver<> solver(tri.intrinsic(), is_fixed);
  const Eigen::VectorXd harmonic =
    solver.solve(Eigen::VectorXd::Zero(mesh.number_of_vertices()), values);
  std::cout << "heights of the boundary from " << lowest << " to " << highest << '\n'
            << "harmonic function from " << harmonic.minCoeff() << " to " << harmonic.maxCoeff()
            << '\n';
}
