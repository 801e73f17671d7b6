// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>

#include <boost/property_map/property_map.hpp>

namespace Test_surface {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;
using IT::Side;

// ---- A surface that offers no more than is asked for ----

class Length_archetype
{
public:
  using key_type = Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  explicit Length_archetype(const Triangulation& t) : m_triangulation(&t) {}
  friend double get(const Length_archetype& map, Edge_index e)
  {
    return map.m_triangulation->length(e);
  }

private:
  const Triangulation* m_triangulation;
};

class Surface_archetype
{
public:
  explicit Surface_archetype(const Triangulation& t) : m_triangulation(t) {}
  Surface_archetype(const Surface_archetype&) = delete;
  Surface_archetype& operator=(const Surface_archetype&) = delete;

  const Delta_complex& mesh() const { return m_triangulation.mesh(); }
  Length_archetype length_map() const { return Length_archetype(m_triangulation); }

private:
  const Triangulation& m_triangulation;
};

// Returns the results that all algorithms on a surface compute from one vertex, in one vector.
template <typename Surface>
Eigen::VectorXcd results(const Surface& surface)
{
  const Vertex_index v(0);
  const IT::Tangent_frames<> frames(surface);
  const Eigen::VectorXd distance = IT::heat_distance(surface, v);
  const IT::Geodesic<double> there = IT::trace_geodesic(surface, v, {0.3, 0.2});
  const IT::Geodesic<double> on = IT::trace_geodesic(surface, there.end, there.direction);
  const auto logarithms = IT::logarithmic_map(surface, v);
  const Halfedge_index outgoing = surface.mesh().halfedge(there.end.first);
  Eigen::VectorXcd result(11);
  result << distance.sum(), IT::cotan_laplacian(surface).norm(), IT::mass_matrix(surface).norm(),
    IT::solve_poisson(surface, distance).norm(), IT::connection_laplacian(surface, frames).norm(),
    (IT::divergence_matrix(surface) * IT::gradient_matrix(surface)).norm(),
    IT::Vector_heat<>(surface).transport(v, 1.).sum(), on.end.second[0], logarithms.back().vector,
    IT::logarithm(surface, outgoing, there.end),
    IT::tangent_vector_at_vertex(surface, outgoing, there.direction);
  return result;
}

TEST(Intrinsic_surface, archetype)
{
  Triangulation t(perturbed(random_sphere(30, 1), 0.3, 1));
  IT::make_Delaunay(t);
  EXPECT_EQ(results(Surface_archetype(t)), results(t.intrinsic()));
}

TEST(Intrinsic_surface, models_of_one_surface_give_equal_results)
{
  Triangulation t(perturbed(random_sphere(30, 2), 0.3, 2));
  EXPECT_EQ(results(t), results(t.input()));
  IT::make_Delaunay(t);
  const Eigen::VectorXcd expected = results(t.intrinsic());
  EXPECT_EQ(results(t), expected);
  EXPECT_EQ(results(t.surface(Side::intrinsic)), expected);
  EXPECT_EQ(results(IT::Surface_view(t.mesh(), t.length_map())), expected);
  EXPECT_EQ(results(t.surface(Side::input)), results(t.input()));
  EXPECT_NE(results(t.input()), expected);
}

// Returns the connectivity of a mesh. Its vertices on the boundary have other halfedges than border
// halfedges, if possible.
Delta_complex connectivity_of(const Mesh& mesh)
{
  Delta_complex result;
  result.resize(mesh.num_vertices(), mesh.num_edges(), mesh.num_faces());
  for(Halfedge_index h : mesh.halfedges()) {
    result.set_next(h, mesh.next(h));
    result.set_target(h, mesh.target(h));
    result.set_face(h, mesh.face(h));
    if(!mesh.is_border(h))
      result.set_halfedge(mesh.target(h), h);
  }
  for(Face_index f : mesh.faces())
    result.set_halfedge(f, mesh.halfedge(f));
  return result;
}

TEST(Intrinsic_surface, connectivity_that_is_moved_is_not_copied)
{
  for(const Mesh& mesh : {perturbed(random_sphere(30, 3), 0.3, 3), four_components(), square(),
                          punctured(embedded_torus(6, 5), {0, 17})}) {
    const auto np = IT::parameters::vertex_point_map(mesh.points());
    const Delta_complex complex = connectivity_of(mesh);
    const Triangulation expected(complex, np);
    Delta_complex moved = complex;
    const Triangulation t(std::move(moved), np);
    expect_equal(t, expected);
    EXPECT_EQ(moved.num_vertices(), 0);
    EXPECT_TRUE(t.is_valid());
  }
}

TEST(Intrinsic_surface, property_maps_of_the_input_are_not_moved)
{
  Triangulation flipped(perturbed(random_sphere(30, 4), 0.3, 4));
  IT::make_Delaunay(flipped);
  const auto np = IT::parameters::edge_length_map(flipped.length_map());
  const Triangulation expected(flipped.mesh(), np), t(Delta_complex(flipped.mesh()), np);
  expect_equal(t, expected);
  expect_equal_to_input(t);
}

TEST(Intrinsic_surface, connectivity_that_is_moved_is_checked)
{
  Mesh two = tetrahedron();
  two += tetrahedron();
  Delta_complex bow_tie = connectivity_of(two);
  for(Halfedge_index h : bow_tie.halfedges())
    if(bow_tie.target(h) == Vertex_index(4))
      bow_tie.set_target(h, Vertex_index(0));
  bow_tie.set_halfedge(Vertex_index(4), Delta_complex::null_halfedge());
  const auto np = IT::parameters::vertex_point_map(two.points());
  EXPECT_THROW(Triangulation(std::move(bow_tie), np), IT::Invalid_input);
}

TEST(Intrinsic_surface, number_type_is_that_of_the_lengths)
{
  const Triangulation t(tetrahedron());
  static_assert(std::is_same_v<IT::Length_of<Surface_archetype>, double>);
  static_assert(std::is_same_v<decltype(t.input()), decltype(t.intrinsic())>);
  static_assert(std::is_same_v<IT::Length_map_of<Triangulation>, Triangulation::Edge_length_map>);
  EXPECT_EQ(&t.input().mesh(), &t.input_mesh());
  EXPECT_EQ(&t.intrinsic().mesh(), &t.mesh());
}

} // namespace Test_surface
