// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"
#include "weights.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>
#include <CGAL/Intrinsic_triangulations/weighted_laplacian.h>

namespace Test_finite_values {

using namespace Test_surfaces;
using Test_weights::map_of;
using Triangulation = IT::Intrinsic_triangulation<>;
using Values = Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double unfit[] = {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};

// Checks that `call` throws an exception whose message contains `text`.
template <typename Call>
void expect_invalid(const Call& call, const std::string& text)
{
  try {
    call();
    ADD_FAILURE() << "no exception about " << text;
  } catch(const IT::Invalid_input& e) {
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
  }
}

// Returns values of which only the value at vertex 3 is not finite.
Values values_with(double x, const Triangulation& t)
{
  Values result = Values::LinSpaced(Eigen::Index(t.mesh().num_vertices()), 0, 1);
  result[3] = x;
  return result;
}

class Finite_values : public testing::Test
{
protected:
  Triangulation t{tetrahedron()};
};

TEST_F(Finite_values, of_level_sets)
{
  for(const double x : unfit) {
    expect_invalid([&] { IT::level_set(t, values_with(x, t), 0.5); }, "at vertex 3 ");
    expect_invalid([&] { IT::level_set(t, values_with(1, t), x); }, "level");
  }
  // Distances that are infinite at all vertices but one have no curves either.
  std::vector<double> distance(t.mesh().num_vertices(), infinity);
  distance[0] = 0;
  expect_invalid([&] { IT::level_set(t, distance, 0.5); }, "at vertex 1 ");
}

TEST_F(Finite_values, of_functions)
{
  const IT::Correspondence correspondence(t);
  for(const double x : unfit)
    for(const IT::Side side : {IT::Side::input, IT::Side::intrinsic})
      expect_invalid([&] { IT::transfer_function(correspondence, side, values_with(x, t)); },
                     "value at vertex 3 ");
}

// Values that are not read may be anything.
TEST_F(Finite_values, of_Poisson_equations)
{
  const auto is_three =
    boost::make_function_property_map<Vertex_index>([](Vertex_index v) { return v.idx() == 3; });
  const IT::Poisson_solver<> solver(t.input()), with_three(t.input(), is_three);
  const Values fine = values_with(1, t);
  for(const double x : unfit) {
    const Values bad = values_with(x, t);
    expect_invalid([&] { solver.solve(bad); }, "moment at vertex 3 ");
    expect_invalid([&] { solver.solve_columns(bad); }, "moment at vertex 3 ");
    expect_invalid([&] { with_three.solve(fine, bad); }, "value at vertex 3 ");
    expect_invalid([&] { IT::solve_poisson(t.input(), bad); }, "density at vertex 3 ");
    EXPECT_EQ(solver.solve(fine, bad), solver.solve(fine));
    EXPECT_EQ(with_three.solve(bad, fine), with_three.solve(fine, fine));
  }
}

TEST_F(Finite_values, of_vectors)
{
  const IT::Vector_heat<> heat(t.input());
  for(const double x : unfit)
    for(const std::complex<double>& z : {std::complex<double>(x, 1), std::complex<double>(1, x)}) {
      expect_invalid([&] { heat.transport(Vertex_index(3), z); }, "vector at vertex 3 ");
      expect_invalid([&] { IT::trace_geodesic(t.input(), Vertex_index(3), z); }, "tangent vector");
    }
}

TEST_F(Finite_values, of_weights)
{
  for(const double x : unfit) {
    std::vector<double> weights(t.mesh().num_vertices(), 0);
    weights[3] = x;
    expect_invalid([&] { IT::weighted_laplacian(t.input(), map_of(weights)); },
                   "weight at vertex 3 ");
    expect_invalid([&] { IT::make_weighted_Delaunay(t, map_of(weights)); }, "weight at vertex 3 ");
    EXPECT_TRUE(t.is_valid());
  }
}

} // namespace Test_finite_values
