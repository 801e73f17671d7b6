// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "archetypes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>

namespace Test_concepts {

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

using namespace archetypes;

struct Flattening_visitor_archetype : No_value
{
  std::vector<DCM::Flattening_stage> stages;
  std::size_t steps = 0;

  void start(DCM::Flattening_stage stage) { stages.push_back(stage); }
  void after_iteration(std::size_t, double, double) { ++steps; }
};

// Implements Newton's method on dense matrices, with steps that are halved until the gradient is
// shorter.
class Minimizer_archetype
{
public:
  explicit Minimizer_archetype(double tolerance) : m_tolerance(tolerance) {}
  Minimizer_archetype(const Minimizer_archetype&) = default;
  Minimizer_archetype& operator=(const Minimizer_archetype&) = delete;

  template <typename Energy, typename Visitor>
  DCM::Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                      const DCM::Minimization_domain& domain,
                                      Visitor&& visitor) const
  {
    DCM::Minimization_result result;
    energy.evaluate(u);
    Eigen::VectorXd g = gradient(energy, domain);
    for(; g.norm() > m_tolerance && result.iterations < 100; ++result.iterations) {
      const Eigen::VectorXd base = u, step = direction(energy, g, domain);
      double t = 2;
      do {
        t /= 2;
        u = base + t * step;
        energy.evaluate(u);
      } while(gradient(energy, domain).norm() > g.norm() && t > 1e-9);
      g = gradient(energy, domain);
      visitor.after_iteration(result.iterations + 1, g.norm(), t * step.norm());
    }
    result.gradient_norm = g.lpNorm<Eigen::Infinity>();
    result.gradient_error = energy.gradient_error();
    if(!(g.norm() <= m_tolerance))
      result.status = DCM::Minimization_status::iteration_limit;
    return result;
  }

private:
  template <typename Energy>
  static Eigen::VectorXd gradient(const Energy& energy, const DCM::Minimization_domain& domain)
  {
    Eigen::VectorXd result = energy.gradient();
    for(std::size_t i = 0; i < domain.is_fixed.size(); ++i)
      if(domain.is_fixed[i])
        result[Eigen::Index(i)] = 0;
    return result;
  }

  template <typename Energy>
  static Eigen::VectorXd direction(const Energy& energy, const Eigen::VectorXd& g,
                                   const DCM::Minimization_domain& domain)
  {
    Eigen::MatrixXd hessian = energy.Hessian();
    for(std::size_t i = 0; i < domain.is_fixed.size(); ++i)
      if(domain.is_fixed[i]) {
        hessian.row(Eigen::Index(i)).setZero();
        hessian.col(Eigen::Index(i)).setZero();
      }
    return hessian.completeOrthogonalDecomposition().solve(-g);
  }

  double m_tolerance;
};

// Returns an irregular octahedron, and its cones.
Mesh octahedron()
{
  typedef Mesh::Point Point;
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(1.5, 0, 0)), b = mesh.add_vertex(Point(0, 1, 0)),
             c = mesh.add_vertex(Point(-1, 0.2, 0)), d = mesh.add_vertex(Point(0, -2, 0)),
             top = mesh.add_vertex(Point(0, 0, 1.2)), bottom = mesh.add_vertex(Point(0.1, 0, -1));
  for(const auto& [x, y] : {std::pair(a, b), {b, c}, {c, d}, {d, a}}) {
    mesh.add_face(x, y, top);
    mesh.add_face(y, x, bottom);
  }
  return mesh;
}

auto four_cones()
{
  return boost::make_function_property_map<Mesh::Vertex_index>([](Mesh::Vertex_index v) {
    return DCM::Vertex_condition::curvature(v.idx() < 4 ? CGAL_PI : 0);
  });
}

TEST(Concepts, energy_and_visitor_of_Newton_minimizer) { expect_minimum(DCM::Newton_minimizer()); }

TEST(Concepts, minimizer)
{
  expect_minimum(Minimizer_archetype(1e-13));

  const Mesh mesh = octahedron();
  const auto cones = four_cones();
  const auto map = DCM::flatten(
    mesh, DCM::parameters::vertex_condition_map(cones).minimizer(Minimizer_archetype(1e-13)));
  const auto reference = DCM::flatten(mesh, DCM::parameters::vertex_condition_map(cones));
  EXPECT_LE(map.max_curvature_error(), 1e-13);
  // The scale factors preserve the area. The effect of errors of 1e-13 in curvatures is bounded by
  // the inverse of the Hessian, a Laplacian of six vertices with weights of about one.
  for(Mesh::Vertex_index v : mesh.vertices())
    EXPECT_NEAR(map.log_scale(v), reference.log_scale(v), 1e-11);
}

TEST(Concepts, flattening_visitor)
{
  Flattening_visitor_archetype visitor;
  const auto map = DCM::flatten(
    octahedron(), DCM::parameters::vertex_condition_map(four_cones()).visitor(std::ref(visitor)));
  typedef DCM::Flattening_stage Stage;
  EXPECT_EQ(visitor.stages, (std::vector<Stage>{Stage::cones, Stage::optimize, Stage::layout,
                                                Stage::trace, Stage::subdivide}));
  EXPECT_EQ(visitor.steps, map.minimization().iterations);
  EXPECT_GT(visitor.steps, 0u);
}

} // namespace Test_concepts
