// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "subdivision_checks.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

namespace Test_data_meshes {

using namespace Test_surfaces;
namespace PMP = CGAL::Polygon_mesh_processing;

std::vector<std::string> all_data_meshes()
{
  std::vector<std::string> result;
#ifdef CGAL_DATA_DIR
  std::error_code none_there;
  for(const auto& file : std::filesystem::directory_iterator(
        std::filesystem::path(CGAL_DATA_DIR) / "meshes", none_there)) {
    const std::string extension = file.path().extension().string();
    if(extension == ".off" || extension == ".ply" || extension == ".stl")
      result.push_back(file.path().string());
  }
  std::sort(result.begin(), result.end());
#endif
  return result;
}

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  bool is_read;

  explicit Soup(const std::string& file) : is_read(read_soup(file, points, polygons)) {}

  bool is_valid_polygon(const std::vector<std::size_t>& polygon) const
  {
    return std::set<std::size_t>(polygon.begin(), polygon.end()).size() == 3 &&
           polygon.size() == 3 && *std::max_element(polygon.begin(), polygon.end()) < points.size();
  }

  // Whether an edge joins coincident points.
  bool has_edge_of_no_length(const std::vector<std::size_t>& polygon) const
  {
    return points[polygon[0]] == points[polygon[1]] || points[polygon[1]] == points[polygon[2]] ||
           points[polygon[2]] == points[polygon[0]];
  }

  // Whether it is an oriented manifold of triangles, by CGAL's own judgement.
  bool is_surface() const
  {
    return !polygons.empty() &&
           std::all_of(polygons.begin(), polygons.end(),
                       [&](const auto& p) { return is_valid_polygon(p); }) &&
           PMP::is_polygon_soup_a_polygon_mesh(polygons) &&
           std::none_of(polygons.begin(), polygons.end(),
                        [&](const auto& p) { return has_edge_of_no_length(p); });
  }
};

bool meets_itself(Face_index f, const Delta_complex& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  const Vertex_index a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
  return a == b || b == c || c == a;
}

void check_subdivision(const Correspondence& c)
{
  const Triangulation& t = c.triangulation();
  const Subdivision s(c);
  check_areas(s, c, 1e-12);
  const auto faces = t.mesh().faces();
  if(std::none_of(faces.begin(), faces.end(),
                  [&](Face_index f) { return meets_itself(f, t.mesh()); })) {
    EXPECT_NEAR(relative_areas(Side::intrinsic, s, t).first, 1, 1e-9);
  }
}

double size_of(const Mesh& mesh)
{
  const auto box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// Checks that points are mapped back to themselves. Faces of T1 may have no area; then a point can
// return in another face.
void check_points_across(const Correspondence& c, const Mesh& mesh)
{
  CGAL::Random random(1);
  const Flat_faces input(Side::input, c.triangulation());
  const Flat_faces intrinsic(Side::intrinsic, c.triangulation());
  for(int i = 0; i < 500; ++i) {
    const Location p = random_location(input.mesh(), random);
    const Location p_back =
      IT::point_across(c, Side::intrinsic, IT::point_across(c, Side::input, p));
    EXPECT_LT(std::sqrt(CGAL::squared_distance(place_in_space(p, input.mesh(), mesh),
                                               place_in_space(p_back, input.mesh(), mesh))),
              1e-9 * size_of(mesh))
      << i;
    const Location q = random_location(intrinsic.mesh(), random);
    const Location q_back =
      IT::point_across(c, Side::input, IT::point_across(c, Side::intrinsic, q));
    EXPECT_LT(static_cast<double>(intrinsic.path(q, q_back)), 1e-9 * size_of(mesh)) << i;
  }
}

void check_save_and_load(const Triangulation& t)
{
  std::stringstream first, second;
  EXPECT_TRUE(IT::write_intrinsic_triangulation(first, t));
  EXPECT_TRUE(IT::write_intrinsic_triangulation(second, IT::read_intrinsic_triangulation(first)));
  EXPECT_TRUE(first.str() == second.str());
}

void check_surface(const Soup& soup)
{
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  EXPECT_TRUE(IT::is_Delaunay(t));
  EXPECT_TRUE(t.is_valid(true));
  const Correspondence c(t);
  check_subdivision(c);
  check_points_across(c, mesh);
  check_save_and_load(t);
}

// Checks a defect. A graph can only be made if the combinatorics are valid; every other defect has
// a name.
void check_refused(const Soup& soup, const IT::Input_diagnosis& diagnosis,
                   const std::string& defect)
{
  EXPECT_GT(diagnosis.number_of_fatal_defects(), 0u);
  std::ostringstream words;
  words << diagnosis;
  EXPECT_EQ(words.str().find("error: " + defect), 0u) << diagnosis;
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  EXPECT_THROW(Triangulation{mesh}, IT::Invalid_input);
}

class Data_mesh : public testing::TestWithParam<std::string>
{};

TEST_P(Data_mesh, works_or_is_refused_with_a_reason)
{
  const Soup soup(GetParam());
  const std::string defect = refusal_of_data_mesh(GetParam());
  ASSERT_TRUE(soup.is_read);
  EXPECT_EQ(soup.polygons.empty(), defect == "no faces");
  if(soup.polygons.empty())
    return;
  const auto diagnosis = IT::diagnose_polygon_soup(soup.points, soup.polygons);
  EXPECT_EQ(diagnosis.is_valid(), soup.is_surface()) << diagnosis;
  EXPECT_EQ(soup.is_surface(), defect.empty());
  if(soup.is_surface())
    check_surface(soup);
  else
    check_refused(soup, diagnosis, defect);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Data_mesh);
INSTANTIATE_TEST_SUITE_P(, Data_mesh, testing::ValuesIn(all_data_meshes()), test_name);

TEST(Data_meshes, all_but_the_refused_are_surfaces)
{
  const auto files = all_data_meshes();
  if(files.empty())
    GTEST_SKIP() << "CGAL's data files are not here";
  std::size_t refused = 0;
  for(const std::string& file : files)
    refused += !refusal_of_data_mesh(file).empty();
  EXPECT_LE(refused, refused_data_meshes().size());
  EXPECT_GE(files.size() - refused, 115u);
}

} // namespace Test_data_meshes
