// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines until triangulations are simplicial, writes them as ordinary meshes, and reads these
// back. Checks that they are valid for CGAL, without loops and double edges, unchanged, Delaunay,
// and have the required angles. Faults are printed to standard error.
// Usage: benchmark_simplicial [--min-angle DEGREES] [mesh...]

#include "../Table.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace fs = std::filesystem;

// Reads a mesh, and returns whether CGAL considers it manifold and consistently oriented. Polygons
// are split. Isolated vertices are removed, because CGAL considers no mesh with them valid.
bool read(const std::string& file, Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(file, points, polygons) || polygons.empty() ||
     !PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return false;
  PMP::remove_isolated_points_in_polygon_soup(points, polygons);
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return CGAL::is_triangle_mesh(mesh) || PMP::triangulate_faces(mesh);
}

// Returns whether all edges and triples of corners are different, and have different vertices.
bool is_simplicial(const Mesh& mesh)
{
  std::set<std::set<Mesh::Vertex_index>> edges, faces;
  for(const Mesh::Edge_index e : mesh.edges())
    edges.insert({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
    faces.insert({corners.begin(), corners.end()});
  }
  const auto has_size = [](std::size_t n) {
    return [n](const std::set<Mesh::Vertex_index>& s) { return s.size() == n; };
  };
  return edges.size() == mesh.number_of_edges() && faces.size() == mesh.number_of_faces() &&
         std::all_of(edges.begin(), edges.end(), has_size(2)) &&
         std::all_of(faces.begin(), faces.end(), has_size(3));
}

bool are_same(const Mesh& a, const Mesh& b)
{
  return a.number_of_edges() == b.number_of_edges() && a.number_of_faces() == b.number_of_faces() &&
         std::equal(a.points().begin(), a.points().end(), b.points().begin(), b.points().end());
}

// Describes the fault, or returns an empty text.
std::string fault_of(const Mesh& written)
{
  const fs::path file = fs::temp_directory_path() / "benchmark_simplicial.off";
  CGAL::IO::write_polygon_mesh(file.string(), written, CGAL::parameters::stream_precision(17));
  Mesh mesh;
  const bool is_read = CGAL::IO::read_polygon_mesh(file.string(), mesh);
  fs::remove(file);
  if(!is_read)
    return "not read back";
  if(!CGAL::is_valid_polygon_mesh(mesh))
    return "not valid";
  if(!is_simplicial(mesh))
    return "not simplicial";
  return are_same(mesh, written) ? "" : "another mesh";
}

std::string fault_of(const IT::Intrinsic_triangulation<>& triangulation,
                     const IT::Refinement_result& result)
{
  if(!IT::certify_Delaunay(triangulation).is_Delaunay())
    return "not Delaunay";
  return std::all_of(result.remaining.begin(), result.remaining.end(), IT::is_excused)
           ? ""
           : "small angles: " + std::string(to_string(result.status));
}

struct Counts
{
  std::size_t meshes = 0, faultless = 0, with_excused_faces = 0;
};

void measure(const std::string& file, double angle, Counts& counts)
{
  Mesh mesh;
  if(!read(file, mesh))
    return;
  ++counts.meshes;
  std::string fault;
  try {
    IT::Intrinsic_triangulation<> triangulation(mesh);
    const auto result =
      IT::refine(triangulation, IT::parameters::minimum_angle(angle).simplicial(true));
    triangulation.collect_garbage();
    counts.with_excused_faces += !result.remaining.empty();
    fault = fault_of(triangulation, result);
    if(fault.empty())
      fault = fault_of(IT::extrinsic_mesh(triangulation, mesh.points()));
  } catch(const std::exception& error) {
    fault = error.what();
  }
  if(fault.empty())
    ++counts.faultless;
  else
    std::cerr << file << ": " << fault << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  double angle = 25;
  if(files.size() >= 2 && files[0] == "--min-angle") {
    angle = std::atof(files[1].c_str());
    files.erase(files.begin(), files.begin() + 2);
  }
  if(files.empty()) {
    for(const auto& file : fs::directory_iterator(CGAL::data_file_path("meshes")))
      files.push_back(file.path().string());
    std::sort(files.begin(), files.end());
  }
  const Table table({"bound (degrees)", "meshes", "without fault", "with excused faces"}, 0);
  Counts counts;
  for(const std::string& file : files)
    measure(file, angle, counts);
  table.row(angle, counts.meshes, counts.faultless, counts.with_excused_faces);
}
