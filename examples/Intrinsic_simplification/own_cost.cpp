// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies with a user-defined cost: the vertex with the closest neighbor is removed first. The
// remaining vertices have about equal distances.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Transport_cost.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <limits>

namespace IS = CGAL::Intrinsic_simplification;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

struct Nearest_neighbor_cost // a model of RemovalCost
{
  double operator()(const IS::Flattened_star& star) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < star.size(); ++i)
      result = (std::min)(result, star[i].length);
    return result;
  }

  void after_removal(const IS::Flattened_star&) {}
};

template <typename Cost>
void simplify(const Mesh& mesh, Cost cost)
{
  IS::Evolving_surface surface(mesh);
  IS::simplify(surface, cost, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 20));
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for(const IS::Edge_index e : surface.mesh().edges()) {
    shortest = (std::min)(shortest, surface.surface().length(e));
    longest = (std::max)(longest, surface.surface().length(e));
  }
  std::cout << surface.mesh().number_of_vertices() << " vertices, edges from " << shortest << " to "
            << longest << '\n';
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;
  simplify(mesh, Nearest_neighbor_cost());
  IS::Transport_cost transport((IS::Evolving_surface(mesh)));
  transport.add_curvature(IS::Evolving_surface(mesh));
  simplify(mesh, transport);
}
