// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <limits>
#include <vector>

using namespace Test_surfaces;

namespace {

using Triangulation = IT::Intrinsic_triangulation<>;
using Location = IT::Face_location<double>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Returns locations that are no points of a surface with the faces 0 to 11.
std::vector<Location> wrong_locations()
{
  const Face_index f(0);
  return {{f, {not_a_number, 0.75, 0.25}},
          {f, {-0.5, 0.75, 0.75}},
          {f, {0.5, 0.75, 0.75}},
          {f, {1., 1., 1.}},
          {f, {0., 0., 0.}},
          {f, {1e300, -1e300, 1.}},
          {Face_index(12), {1, 0, 0}},
          {Delta_complex::null_face(), {1, 0, 0}}};
}

} // namespace

TEST(Invalid_parameters, sources_of_distances)
{
  const Mesh mesh = cube();
  const Triangulation t(mesh);
  const auto surface = t.input();
  IT::Shortest_paths paths(surface);
  for(const Vertex_index v : {Vertex_index(8), Vertex_index(77), Delta_complex::null_vertex()}) {
    EXPECT_THROW(paths.add_source(v), IT::Invalid_input);
    EXPECT_THROW(IT::geodesic_distances(mesh, v), IT::Invalid_input);
    EXPECT_THROW(IT::geodesic_distances(t, v), IT::Invalid_input);
    EXPECT_THROW(IT::heat_distance(surface, v), IT::Invalid_input);
    EXPECT_THROW(IT::trace_geodesic(surface, v, std::complex<double>(1)), IT::Invalid_input);
  }
  for(const Location& p : wrong_locations()) {
    EXPECT_THROW(paths.add_source(p), IT::Invalid_input);
    EXPECT_THROW(paths.add_source(IT::Curve_segment<double>{p.first, {1, 0, 0}, p.second}),
                 IT::Invalid_input);
    EXPECT_THROW(IT::geodesic_distances(mesh, p), IT::Invalid_input);
    EXPECT_THROW(IT::heat_distance(surface, p), IT::Invalid_input);
    EXPECT_THROW(IT::trace_geodesic(surface, p, std::complex<double>(1)), IT::Invalid_input);
  }
  EXPECT_EQ(paths.add_source(Vertex_index(7)), 0u); // nothing has been added before
}

TEST(Invalid_parameters, inserted_vertices)
{
  Triangulation t((cube()));
  IT::Vertex_inserter<> inserter(t);
  for(const Location& p : wrong_locations())
    EXPECT_THROW(inserter.insert(p), IT::Invalid_input);
  EXPECT_EQ(t.number_of_inserted_vertices(), 0u);
  EXPECT_TRUE(t.is_valid());
}

TEST(Invalid_parameters, bounds_of_refinements)
{
  namespace parameters = IT::parameters;
  Triangulation t((cube()));
  for(const double degrees : {not_a_number, -5., 60.001, 90., 1e308})
    EXPECT_THROW(IT::refine(t, parameters::minimum_angle(degrees)), IT::Invalid_input);
  for(const double radius : {not_a_number, -1., 0.})
    EXPECT_THROW(IT::refine(t, parameters::maximum_circumradius(radius)), IT::Invalid_input);
  EXPECT_EQ(t.number_of_inserted_vertices(), 0u);
}

TEST(Invalid_parameters, values_of_level_sets)
{
  const Triangulation t((cube()));
  for(const std::size_t n : {0, 2, 7, 9})
    EXPECT_THROW(IT::level_set(t.input(), std::vector<double>(n, 1.), 0.5), IT::Invalid_input);
}
