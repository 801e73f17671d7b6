// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cctype>

namespace Test_surfaces {

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  return CGAL::IO::read_polygon_mesh(file, mesh) ? mesh : Mesh();
}

Mesh read_repaired_mesh(const std::string& file)
{
  Mesh mesh;
  return CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) ? mesh : Mesh();
}

bool read_soup(const std::string& file, std::vector<Point>& points,
               std::vector<std::vector<std::size_t>>& polygons)
{
  return CGAL::IO::read_polygon_soup(file, points, polygons);
}

const std::map<std::string, std::string>& refused_data_meshes()
{
  static const std::map<std::string, std::string> result = [] {
    std::map<std::string, std::string> files{{"b9.ply", "no faces"},
                                             {"blobby-shuffled.off", "inconsistent orientation"},
                                             {"cube-shuffled.off", "inconsistent orientation"},
                                             {"oblong-shuffled.off", "inconsistent orientation"},
                                             {"tet-shuffled.off", "inconsistent orientation"},
                                             {"building.off", "non-manifold vertex"},
                                             {"cheese-selection-2.off", "non-manifold vertex"},
                                             {"pig.stl", "non-manifold vertex"},
                                             {"polygon_mesh.off", "non-manifold vertex"},
                                             {"cubes.off", "non-manifold edge"},
                                             {"degenerated-sd.off", "zero-length edge"}};
    for(const std::string& name :
        words("3torus P beam corner corner_poly corner_with_hole corner_with_sharp_edge cross_quad "
              "cube-sd cube4-shuffled cube_poly cube_quad double-torus-3-holes "
              "double-torus-example hole mesh_with_colors mpi mpi_and_sphere "
              "non_manifold_face_graph prim pyramid quad quads_to_stitch torus_quad"))
      files[name + ".off"] = "face that is not a triangle";
    return files;
  }();
  return result;
}

std::string refusal_of_data_mesh(const std::string& file)
{
  const auto found = refused_data_meshes().find(std::filesystem::path(file).filename().string());
  return found == refused_data_meshes().end() ? std::string() : found->second;
}

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  std::string name = std::filesystem::path(info.param).filename().string();
  for(char& c : name)
    if(!std::isalnum(static_cast<unsigned char>(c)))
      c = '_';
  return name;
}

} // namespace Test_surfaces
