// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the intrinsic Delaunay triangulation of a part with flat sides, whose corners often lie
// on common circles. It is decided in `double` with a certificate, then exactly.

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

template <typename Traits>
void certified_triangulation(const std::string& name, const Mesh& mesh)
{
  IT::Intrinsic_triangulation<Traits> tri(mesh);
  const std::size_t flips = IT::make_Delaunay(tri);
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(tri);
  std::cout << name << ": " << flips << " flips, " << certificate.ties.size() << " ties, "
            << certificate.non_Delaunay_edges.size() << " edges that are not Delaunay\n"
            << "  decided by lengths " << certificate.decided_by_lengths << ", with more digits "
            << certificate.decided_in_floating_point + certificate.decided_in_multiprecision
            << ", exactly " << certificate.decided_exactly << '\n';
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return 1;
  }
  certified_triangulation<IT::Euclidean_geometry_traits<>>("double", mesh);
  certified_triangulation<IT::Exact_Euclidean_geometry_traits<>>("exact", mesh);
}
