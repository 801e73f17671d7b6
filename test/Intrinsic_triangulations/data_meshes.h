// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H

#include "generators.h"

namespace Test_surfaces {

// Returns the mesh of a file, empty if there is none.
Mesh read_mesh(const std::string& file);

// Returns the mesh of a file, empty if there is none. What its faces lack in orientation or at
// vertices, CGAL repairs.
Mesh read_repaired_mesh(const std::string& file);

// Reads the points and polygons of a file, and returns whether it has any.
bool read_soup(const std::string& file, std::vector<Point>& points,
               std::vector<std::vector<std::size_t>>& polygons);

// Returns the data files of CGAL 5.5 to 6.2 that are not triangulated surfaces, with the first
// defect of a diagnosis. All others are surfaces.
const std::map<std::string, std::string>& refused_data_meshes();

// Returns why `file` is no surface, empty if it is one.
std::string refusal_of_data_mesh(const std::string& file);

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
    const Mesh mesh = read_repaired_mesh(file);
    const std::string refusal = refusal_of_data_mesh(file);
    EXPECT_EQ(mesh.number_of_faces() == 0, refusal == "no faces");
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
    const Mesh mesh = read_mesh(CGAL::data_file_path("meshes/" + name));
    ASSERT_FALSE(mesh.is_empty());
    visit(mesh);
  }
}

// Returns a name for tests of one mesh each.
std::string test_name(const testing::TestParamInfo<std::string>& info);

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
