// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/more_generators.h"
#include "../Intrinsic_triangulations/refined_meshes.h"

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include "../Intrinsic_triangulations/results.h" // after Eigen

namespace Test_parallel_maps {

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
using DCM::Layer;

constexpr std::array<Layer, 3> layers{Layer::A, Layer::B, Layer::C};

Results map_results(const DCM::Discrete_conformal_map& map)
{
  Results results;
  const auto& s = map.subdivision();
  results.add_subdivision(s, layers);
  for(auto h : s.mesh().halfedges())
    if(!s.mesh().is_border(h))
      for(Layer layer : layers)
        for(double x : s.coordinates(layer, h))
          results.add(x);
  for(auto v : map.ideal().mesh().vertices())
    results.add(map.log_scale(v));
  return results;
}

TEST(Parallel, flat_maps)
{
  for(const Mesh& mesh : {large_torus(), large_square()})
    expect_same_results([&](auto tag) {
      const auto map = DCM::flatten(mesh, DCM::parameters::concurrency_tag(tag));
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      Results results = map_results(map);
      for(auto h : map.ideal().mesh().halfedges())
        results.add(map.position(h).real());
      return results;
    });
}

// Edges of three triangulations are compared, each flipped at random from the previous one.
TEST(Parallel, triple_subdivision)
{
  for(const Mesh& mesh : {large_torus(), large_square()})
    for(unsigned int seed : {1u, 2u}) {
      Triangulation ab(mesh);
      flip_at_random(ab, 4 * mesh.number_of_edges(), seed);
      Triangulation bc(ab.mesh(), IT::parameters::edge_length_map(ab.length_map()));
      flip_at_random(bc, 4 * mesh.number_of_edges(), seed + 10);
      const IT::Correspondence<> first(ab), second(bc);
      expect_same_results([&](auto tag) {
        Results results;
        const DCM::Triple_subdivision<> s(first, second, DCM::parameters::concurrency_tag(tag));
        EXPECT_GT(s.mesh().number_of_faces(), 2 * mesh.number_of_faces());
        results.add_subdivision(s, layers);
        return results;
      });
    }
}

template <typename Energy, typename Tag>
Results energy_results(Energy energy, const Eigen::VectorXd& x, Tag tag)
{
  energy.set_concurrency(tag);
  energy.evaluate(x);
  Results results;
  results.add_matrix(energy.Hessian());
  for(double g : energy.gradient())
    results.add(g);
  results.add(energy.gradient_error());
  results.add(energy.number_of_flat_faces());
  results.add(static_cast<double>(energy.value()));
  return results;
}

template <typename Energy>
void check_energy(const Triangulation& tri)
{
  const auto n = static_cast<Eigen::Index>(tri.mesh().number_of_vertices());
  const Energy energy(tri.mesh(), tri.length_map(), Eigen::VectorXd::Zero(n));
  CGAL::Random random(4);
  Eigen::VectorXd x(n);
  for(double& u : x)
    u = random.get_double(-0.3, 0.3);
  expect_same_results([&](auto tag) { return energy_results(energy, x, tag); });
}

TEST(Parallel, energies)
{
  Triangulation tri(large_torus());
  IT::make_Delaunay(tri);
  check_energy<DCM::Conformal_energy<double>>(tri);
  check_energy<DCM::Conformal_energy<long double>>(tri);
  check_energy<DCM::Hyperbolic_conformal_energy<double>>(tri);
}

TEST(Parallel, spherical_maps)
{
  const Mesh mesh = perturbed(unit_sphere(30), 0.005, 8);
  expect_same_results([&](auto tag) {
    return map_results(DCM::map_to_sphere(mesh, DCM::parameters::concurrency_tag(tag)));
  });
}

} // namespace Test_parallel_maps
