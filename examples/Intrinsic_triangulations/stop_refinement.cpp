// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shows the progress of a refinement by a visitor, which stops it after a hundred insertions. The
// triangulation is valid then, and refinement can continue.

#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

struct Stopped
{};

struct Stopping_visitor : IT::Default_refinement_visitor
{
  template <typename Traits>
  void after_insertion(IT::Vertex_index, const IT::Vertex_inserter<Traits>&)
  {
    if(++insertions % 50 == 0)
      std::cout << insertions << " insertions\n";
    if(insertions == 100)
      throw Stopped();
  }

  std::size_t insertions = 0;
};

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cheese.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  Stopping_visitor visitor;
  try {
    IT::refine(tri, IT::parameters::minimum_angle(25).visitor(visitor));
  } catch(const Stopped&) {
    std::cout << "stopped, " << (tri.is_valid() ? "valid" : "not valid") << '\n';
  }
  const IT::Refinement_result result = IT::refine(tri, IT::parameters::minimum_angle(25));
  std::cout << "then: " << IT::to_string(result.status) << '\n';
}
