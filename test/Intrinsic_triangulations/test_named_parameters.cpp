// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests use sequences of named parameters, of the package and of CGAL.

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <functional>
#include <memory>

namespace Test_named_parameters {

using namespace Test_surfaces;
namespace np = IT::parameters;
using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;
using CGAL::parameters::is_default_parameter;

typedef IT::internal_np::minimum_angle_t Angle_tag;
typedef CGAL::internal_np::number_of_iterations_t Iterations_tag;

template <typename NamedParameters>
int angle(const NamedParameters& parameters)
{
  return choose_parameter(get_parameter(parameters, IT::internal_np::minimum_angle), -1);
}

template <typename NamedParameters>
int iterations(const NamedParameters& parameters)
{
  return choose_parameter(get_parameter(parameters, CGAL::internal_np::number_of_iterations), -1);
}

// Takes the class of sequences apart, as functions of CGAL do.
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
int iterations_of_class(const CGAL_NP_CLASS& parameters)
{
  return iterations(parameters);
}

struct Not_copyable
{
  int value = 0;

  Not_copyable() = default;
  Not_copyable(const Not_copyable&) = delete;
  Not_copyable& operator=(const Not_copyable&) = delete;
};

struct Flip_counter : IT::Default_refinement_visitor
{
  std::size_t insertions = 0;

  template <typename... Arguments>
  void after_insertion(const Arguments&...)
  {
    ++insertions;
  }
};

TEST(Named_parameters, chain_in_any_order)
{
  const auto one = np::minimum_angle(1).number_of_iterations(2);
  const auto other = np::number_of_iterations(2).minimum_angle(1);
  static_assert(!std::is_same<decltype(one), decltype(other)>::value, "two orders, two types");
  EXPECT_EQ(angle(one), 1);
  EXPECT_EQ(iterations(one), 2);
  EXPECT_EQ(angle(other), 1);
  EXPECT_EQ(iterations(other), 2);
  const auto longer = other.geom_traits(0).maximum_circumradius(1.).visitor(0);
  EXPECT_EQ(angle(longer), 1);
  EXPECT_EQ(iterations(longer), 2);
}

TEST(Named_parameters, that_are_missing_are_default)
{
  const auto parameters = np::time_step_factor(1).minimum_angle(2);
  typedef std::remove_const_t<decltype(parameters)> Parameters;
  static_assert(!is_default_parameter<Parameters, Angle_tag>::value, "given");
  static_assert(is_default_parameter<Parameters, Iterations_tag>::value, "missing");
  EXPECT_EQ(iterations(parameters), -1);
}

TEST(Named_parameters, count_once_if_repeated)
{
  EXPECT_EQ(angle(np::minimum_angle(1).minimum_angle(2)), 2);
  EXPECT_EQ(iterations(np::number_of_iterations(1).minimum_angle(2).number_of_iterations(3)), 3);
  static_assert(
    std::is_same<decltype(get_parameter(np::minimum_angle(1).minimum_angle(2.5), Angle_tag())),
                 double>::value,
    "the type is that of the last value");
}

TEST(Named_parameters, refer_to_objects)
{
  Not_copyable object;
  const auto by_reference = np::visitor(std::ref(object)).minimum_angle(1);
  get_parameter_reference(by_reference, CGAL::internal_np::visitor).value = 3;
  EXPECT_EQ(object.value, 3);
  // An object that cannot be copied is referred to without std::ref, as a constant.
  const auto by_value = np::minimum_angle(1).visitor(object);
  EXPECT_EQ(&get_parameter_reference(by_value, CGAL::internal_np::visitor), &object);
}

TEST(Named_parameters, are_read_by_CGAL)
{
  EXPECT_EQ(iterations_of_class(np::number_of_iterations(1).minimum_angle(2)), 1);
  const Mesh mesh = tetrahedron();
  const auto doubled = boost::make_function_property_map<Mesh::Vertex_index>([&](auto v) {
    const Point& p = mesh.point(v);
    return Point(2 * p.x(), 2 * p.y(), 2 * p.z());
  });
  const auto h = *mesh.halfedges().begin();
  namespace PMP = CGAL::Polygon_mesh_processing;
  EXPECT_DOUBLE_EQ(PMP::edge_length(h, mesh, np::minimum_angle(25).vertex_point_map(doubled)),
                   2 * PMP::edge_length(h, mesh));
}

TEST(Named_parameters, reach_the_algorithms)
{
  const Mesh mesh = random_sphere(40, 1);
  const auto length = boost::make_function_property_map<Mesh::Edge_index>([&](Mesh::Edge_index e) {
    return 2 * std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                mesh.point(mesh.vertex(e, 1))));
  });
  const auto first =
    boost::make_function_property_map<Mesh::Edge_index>([](auto e) { return e.idx() == 0; });
  IT::Intrinsic_triangulation<> t(mesh, np::edge_is_constrained_map(first).edge_length_map(length));
  EXPECT_DOUBLE_EQ(t.input_length(IT::Edge_index(0)), get(length, Mesh::Edge_index(0)));
  EXPECT_TRUE(t.is_constrained(IT::Edge_index(0)));
  Flip_counter counter;
  const IT::Refinement_result result =
    IT::refine(t, np::visitor(std::ref(counter)).minimum_angle(20).maximum_number_of_insertions(3));
  EXPECT_EQ(result.status, IT::Refinement_status::insertion_limit);
  EXPECT_EQ(counter.insertions, 3u);
}

// Represents a visitor with functions that are not constant, whose copies count together.
struct Counting_visitor : IT::Default_refinement_visitor
{
  void after_flip(IT::Halfedge_index) { ++own, ++*all; }
  template <typename Traits>
  void after_insertion(IT::Vertex_index, const IT::Vertex_inserter<Traits>&)
  {
    ++own, ++*all;
  }

  std::size_t own = 0;
  std::shared_ptr<std::size_t> all = std::make_shared<std::size_t>(0);
};

// Checks that `run(v)` calls a function with a visitor, and with one that `std::ref()` refers to.
template <typename Run>
void expect_notified(const Run& run)
{
  Counting_visitor copied, referred;
  run(copied);
  run(std::ref(referred));
  EXPECT_GT(*copied.all, 0u);
  EXPECT_EQ(copied.own, 0u);
  EXPECT_EQ(referred.own, *copied.all);
}

TEST(Named_parameters, take_visitors_and_references_to_them)
{
  const Mesh mesh = perturbed(embedded_torus(6, 5), 0.4, 3);
  expect_notified([&](const auto& visitor) {
    IT::Intrinsic_triangulation<> tri(mesh);
    IT::make_Delaunay(tri, np::visitor(visitor));
  });
  expect_notified([&](const auto& visitor) {
    IT::Intrinsic_triangulation<> tri(mesh);
    IT::refine(tri, np::visitor(visitor));
  });
}

} // namespace Test_named_parameters
