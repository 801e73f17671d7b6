// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps the centers of all faces of the intrinsic Delaunay triangulation to the mesh, and back.

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// Returns the largest difference of coordinates, or infinity if the faces differ.
double difference(const IT::Face_location<double>& p, const IT::Face_location<double>& q)
{
  if(p.first != q.first)
    return INFINITY;
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    result = (std::max)(result, std::abs(p.second[c] - q.second[c]));
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

  double largest = 0;
  for(IT::Face_index f : tri.mesh().faces()) {
    const IT::Face_location<double> center(f, {1. / 3, 1. / 3, 1. / 3});
    const auto on_input = IT::point_across(correspondence, IT::Side::intrinsic, center);
    const auto back = IT::point_across(correspondence, IT::Side::input, on_input);
    largest = (std::max)(largest, difference(center, back));
    if(f.idx() < 3)
      std::cout << "face " << f << ": center in face " << on_input.first << " of the mesh, at "
                << PMP::construct_point(on_input, mesh) << '\n';
  }
  std::cout << "largest difference after mapping both ways: " << largest << '\n';
}
