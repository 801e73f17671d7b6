// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Transfers a function from a mesh to its intrinsic Delaunay triangulation and back. Each result is
// the closest function in the L2 norm.

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// Returns the height of the vertices above the plane z = 0.
Eigen::VectorXd heights(const Mesh& mesh)
{
  Eigen::VectorXd result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Mesh::Vertex_index v : mesh.vertices())
    result[static_cast<Eigen::Index>(v.idx())] = mesh.point(v).z();
  return result;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const IT::Correspondence<> correspondence(tri);

  const Eigen::VectorXd height = heights(mesh);
  const Eigen::VectorXd there = IT::transfer_function(correspondence, IT::Side::input, height);
  const Eigen::VectorXd back = IT::transfer_function(correspondence, IT::Side::intrinsic, there);

  const auto mass = IT::mass_matrix(tri.input());
  const auto intrinsic_mass = IT::mass_matrix(tri.intrinsic());
  const Eigen::VectorXd error = back - height;
  std::cout << "integral on the mesh " << (mass * height).sum()
            << ", on the Delaunay triangulation " << (intrinsic_mass * there).sum() << '\n'
            << "relative error after both transfers: "
            << std::sqrt(error.dot(mass * error) / height.dot(mass * height)) << '\n';
}
