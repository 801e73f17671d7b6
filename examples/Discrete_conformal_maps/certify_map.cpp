// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Decides in exact arithmetic which edges of a map to the plane are still Delaunay after rounding.

#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

void print(const char* name, const IT::Ideal_Delaunay_certificate& c)
{
  std::cout << name << ": " << c.decided_in_floating_point << " edges decided in floating point, "
            << c.decided_exactly << " exactly; " << c.ties.size() << " ties, "
            << c.non_Delaunay_edges.size() << " not Delaunay, by at most " << c.greatest_excess
            << '\n';
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"),
                                  mesh))
    return 1;

  const DCM::Planar_conformal_map map = DCM::flatten(mesh);
  if(map.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(map.status()) << '\n';
    return 1;
  }
  const DCM::Map_certificate certificate = DCM::certify(map);

  print("T2", certificate.on_B);
  print("T3", certificate.on_C);
  const DCM::Order_certificate& order = certificate.order;
  std::cout << "ends on edges of T2: " << order.decided_in_floating_point
            << " pairs decided in floating point, " << order.decided_in_multiprecision
            << " with more digits, " << order.decided_exactly << " exactly; " << order.ties.size()
            << " at one position, " << order.exchanged.size() << " exchanged, "
            << order.undecided.size() << " undecided\n";
  std::cout << (certificate.is_certified() ? "certified\n" : "not certified\n");
}
