// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace Test_surfaces {

// Calls `visit(mesh)` for CGAL's triangle meshes up to a size of files in bytes. What is no surface
// may be refused with a reason, which is printed; but most must not be.
template <typename Visit>
void for_each_data_mesh(std::uintmax_t largest_file, const Visit& visit)
{
  const std::vector<std::string> files = data_meshes(largest_file);
  std::size_t visited = 0;
  for(const std::string& file : files) {
    SCOPED_TRACE(file);
    Mesh mesh;
    if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) ||
       !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
      continue;
    try {
      visit(mesh);
      ++visited;
    } catch(const IT::Invalid_input& e) {
      std::cout << file << ": " << e.what() << '\n';
    }
  }
  EXPECT_TRUE(files.empty() || visited > files.size() / 2);
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_DATA_MESHES_H
