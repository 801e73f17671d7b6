// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H

#include "generators.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <cctype>

namespace Test_surfaces {

// Returns the data files of CGAL 5.5 to 6.2 that are not triangulated surfaces, with the first
// defect of a diagnosis. All others are surfaces.
inline const std::map<std::string, std::string>& refused_data_meshes()
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

// Returns why `file` is no surface, empty if it is one.
inline std::string refusal_of_data_mesh(const std::string& file)
{
  const auto found = refused_data_meshes().find(std::filesystem::path(file).filename().string());
  return found == refused_data_meshes().end() ? std::string() : found->second;
}

// Calls `visit(mesh)` for CGAL's triangle meshes up to a size of files in bytes, none left out:
// what the soup lacks in orientation or at vertices, CGAL repairs as it reads.
template <typename Visit>
void for_each_data_mesh(std::uintmax_t largest_file, const Visit& visit)
{
  const std::vector<std::string> files = data_meshes(largest_file);
  if(files.empty())
    GTEST_SKIP() << "CGAL's data files are not here";
  for(const std::string& file : files) {
    SCOPED_TRACE(file);
    Mesh mesh;
    ASSERT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh));
    const std::string refusal = refusal_of_data_mesh(file);
    EXPECT_EQ(CGAL::is_triangle_mesh(mesh), refusal != "face that is not a triangle");
    if(CGAL::is_triangle_mesh(mesh) && refusal != "zero-length edge")
      visit(mesh);
  }
}

// Calls `visit(mesh)` for some of CGAL's meshes.
template <typename Visit>
void for_data_meshes(const std::vector<std::string>& names, const Visit& visit)
{
  if(data_meshes(1000000).empty())
    GTEST_SKIP() << "CGAL's data files are not here";
  for(const std::string& name : names) {
    SCOPED_TRACE(name);
    Mesh mesh;
    ASSERT_TRUE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh));
    visit(mesh);
  }
}

// Returns a name for tests of one mesh each.
inline std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  std::string name = std::filesystem::path(info.param).filename().string();
  for(char& c : name)
    if(!std::isalnum(static_cast<unsigned char>(c)))
      c = '_';
  return name;
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
