// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/data_meshes.h"
#include "flat_maps.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

namespace Test_flatten_data {

using namespace Test_surfaces;
namespace PMP = CGAL::Polygon_mesh_processing;

// Reads a surface, or returns an empty mesh if the file contains none.
Mesh read(const std::string& file)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh result;
  if(read_soup(file, points, polygons) && IT::diagnose_polygon_soup(points, polygons).is_valid())
    PMP::polygon_soup_to_polygon_mesh(points, polygons, result);
  return result;
}

Conditions conditions_with_cones(const Delta_complex& mesh, const std::vector<Vertex_index>& cones)
{
  Conditions result = default_conditions(mesh);
  for(Vertex_index v : cones)
    result[v] = Vertex_condition::log_scale(0);
  return result;
}

double laid_out_length(const Planar_conformal_map& map, Halfedge_index h)
{
  return std::abs(map.position(mesh_C(map).next(h)) - map.position(h));
}

// Checks that the length cross ratios of the faces in the plane are the cross ratios of the ideal
// polyhedron. Returns the greatest relative error, beyond the effect of rounded coordinates on
// short edges.
double worst_cross_ratio(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  const Used_faces is_used = used_faces(map);
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * size_of(map);
  double worst = 0;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    if(!is_used[mesh.face(h)] || !is_used[mesh.face(o)])
      continue;
    const std::array<Halfedge_index, 4> side{mesh.next(h), mesh.prev(h), mesh.next(o),
                                             mesh.prev(o)};
    const auto cross_ratio = [&](const auto& length) {
      return length(side[0]) / length(side[1]) * length(side[2]) / length(side[3]);
    };
    const double in_plane = cross_ratio([&](Halfedge_index x) { return laid_out_length(map, x); });
    const double ideal =
      cross_ratio([&](Halfedge_index x) { return map.ideal().length(mesh.edge(x)); });
    double shortest = std::numeric_limits<double>::infinity();
    for(Halfedge_index x : side)
      shortest = (std::min)(shortest, laid_out_length(map, x));
    worst = (std::max)(worst, std::abs(in_plane / ideal - 1) - rounding / shortest);
  }
  return worst;
}

std::size_t number_of_flipped_faces(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  const Used_faces is_used = used_faces(map);
  std::size_t result = 0;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const Complex a = map.position(h), b = map.position(mesh.next(h)),
                  c = map.position(mesh.prev(h));
    result += is_used[f] && !((std::conj(b - a) * (c - a)).imag() > 0);
  }
  return result;
}

class Flattened_data_mesh : public testing::TestWithParam<std::string>
{};

// Returns three cones for each component, the fewest that spheres and disks allow. Other vertices
// are flat or straight.
Conditions three_cones(const Delta_complex& mesh)
{
  const IT::Mesh_components component(mesh);
  std::vector<int> cones(component.size(), 0);
  Conditions result(mesh.number_of_vertices());
  for(const bool is_border : {true, false})
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_border(v) == is_border && cones[component[v]] < 3) {
        result[v] = Vertex_condition::log_scale(0);
        ++cones[component[v]];
      }
  return result;
}

TEST_P(Flattened_data_mesh, is_flat_and_conformal)
{
  const Mesh mesh = read(GetParam());
  ASSERT_EQ(mesh.is_empty(), !refusal_of_data_mesh(GetParam()).empty());
  if(mesh.is_empty())
    GTEST_SKIP() << refusal_of_data_mesh(GetParam());
  const Planar_conformal_map map = DCM::flatten(mesh);
  EXPECT_LT(map.max_curvature_error(), 1e-10);
  const Delta_complex input = Triangulation(mesh).mesh();
  check_conditions(map, input, conditions_with_cones(input, map.cones()), 1e-9);
  EXPECT_LT(worst_cross_ratio(map), 1e-10);
  EXPECT_EQ(number_of_flipped_faces(map), 0u);
  for(Vertex_index v : mesh.vertices())
    EXPECT_LE(std::abs(map.log_scale(v)), 5);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Flattened_data_mesh);
INSTANTIATE_TEST_SUITE_P(, Flattened_data_mesh, testing::ValuesIn(data_meshes(1300000)), test_name);

// Scale factors range from exp(-72) to 1, so `double` has too few digits for the curvatures.
TEST(Flattened_data_meshes, extended_precision_takes_over)
{
  const Mesh mesh = read(CGAL::data_file_path("meshes/b9_mesh.off"));
  if(mesh.is_empty())
    GTEST_SKIP() << "CGAL's data files are not here";
  const Triangulation t(mesh);
  const Conditions condition = three_cones(t.mesh());
  const Planar_conformal_map map = flatten(t, condition);
  EXPECT_LT(map.max_curvature_error(), 1e-11);
  EXPECT_LT(map.minimization().gradient_error, 1e-15); // less than double can have
  EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
  // An angle changes by up to 1e11 times the rounding error of the scale factors.
  check_conditions(map, t.mesh(), condition, 1e-3);
}

} // namespace Test_flatten_data
