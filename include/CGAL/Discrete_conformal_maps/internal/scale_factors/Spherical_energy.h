// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Lobachevsky_function.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/assemble_columns.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Partially_decorated_surface.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Sparse>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// The energy whose minimum under lower bounds are the scale factors that unfold a sphere, without
// one of its vertices, into the plane (Section 4.4.2). A model of `ConvexEnergy`. Scale factors are
// the sum of an origin and a variable, as in `Conformal_energy`. The variables of the vertex at
// infinity and of isolated vertices have no influence.
template <typename FT_ = double>
class Spherical_energy
{
public:
  typedef FT_ FT;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  // `length` is a readable property map of the lengths of edges
  template <typename EdgeLengthMap>
  Spherical_energy(const Delta_complex& mesh, const EdgeLengthMap& length, Vertex_index at_infinity)
    : m_surface(mesh, length, at_infinity),
      m_scale_factor(mesh.num_vertices(), FT(0)),
      m_origin(mesh.num_vertices(), FT(0)),
      m_angle(mesh.num_halfedges()),
      m_cotangent(mesh.num_halfedges()),
      m_gradient(Vector::Zero(Eigen::Index(mesh.num_vertices())))
  {}

  std::size_t size() const { return m_origin.size(); }

  // Moves to the point `x`. Where a scaled length is no number, the gradient is none.
  void evaluate(const Vector& x)
  {
    for(std::size_t i = 0; i < m_origin.size(); ++i)
      m_scale_factor[i] = m_origin[i] + FT(x[Eigen::Index(i)]);
    m_has_Hessian = false;
    try {
      m_surface.scale(m_scale_factor);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      m_gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    measure_faces();
    sum_angles();
  }

  // The variable is zero there.
  void set_origin(const std::vector<FT>& origin) { m_origin = origin; }

  const std::vector<FT>& scale_factors() const { return m_scale_factor; }
  const Partially_decorated_surface<FT>& surface() const { return m_surface; }

  // at the source of `h`, in the scaled metric. \pre the face of `h` remains
  const FT& angle(Halfedge_index h) const { return m_angle[h.idx()]; }

  FT value() const;

  // the angle defects, with pi instead of 2 pi on the boundary of the remaining surface
  const Vector& gradient() const { return m_gradient; }
  double gradient_error() const { return m_gradient_error; }

  // the cotan Laplacian of the remaining surface
  const Matrix& Hessian() const
  {
    if(!m_has_Hessian)
      assemble_columns(
        mesh(), [this](Vertex_index v, auto& entries) { collect_column(v, entries); }, m_Hessian);
    m_has_Hessian = true;
    return m_Hessian;
  }

private:
  typedef Flat_triangle<FT> Triangle;

  const Delta_complex& mesh() const { return m_surface.mesh(); }

  bool is_remaining(Halfedge_index h) const { return m_surface.is_remaining(mesh().face(h)); }

  void measure_faces()
  {
    m_error.assign(m_origin.size(), 0.);
    for(Face_index f : mesh().faces()) {
      const auto side = Intrinsic_triangulations::sides(f, mesh());
      if(m_surface.is_remaining(f))
        measure(side);
      else
        for(Halfedge_index h : side)
          m_cotangent[h.idx()] = 0;
    }
  }

  void measure(const std::array<Halfedge_index, 3>& side)
  {
    const auto length = [&](std::size_t s) { return m_surface.scaled_length(Edge_index(side[s])); };
    const Triangle triangle({length(0), length(1), length(2)});
    for(std::size_t s = 0; s < 3; ++s) {
      m_angle[side[s].idx()] = triangle.angle(s);
      m_cotangent[side[s].idx()] = static_cast<double>(triangle.cotangent((s + 2) % 3));
      m_error[mesh().source(side[s]).idx()] += static_cast<double>(triangle.angle_error());
    }
  }

  // A vertex of the remaining surface begins with two right angles for each half of an edge without
  // a face.
  void sum_angles()
  {
    const FT pi = boost::math::constants::pi<FT>();
    std::vector<FT> defect(m_origin.size(), 2 * pi);
    for(Halfedge_index h : mesh().halfedges()) {
      const Vertex_index v = mesh().source(h);
      if(is_remaining(h))
        defect[v.idx()] += pi - m_angle[h.idx()];
      if(m_surface.is_remaining(Edge_index(h)))
        defect[v.idx()] -= pi;
    }
    defect[m_surface.vertex_at_infinity().idx()] = 0;
    for(Vertex_index v : mesh().vertices())
      m_gradient[Eigen::Index(v.idx())] =
        mesh().is_isolated(v) ? 0 : static_cast<double>(defect[v.idx()]);
    m_gradient_error = *std::max_element(m_error.begin(), m_error.end());
  }

  double weight(Halfedge_index h) const
  {
    return (m_cotangent[h.idx()] + m_cotangent[mesh().opposite(h).idx()]) / 2;
  }

  // loops do not count
  void collect_column(Vertex_index v, Column_entries& entries) const
  {
    if(mesh().is_isolated(v))
      return;
    double diagonal = 0;
    Intrinsic_triangulations::for_each_spoke(v, mesh(), [&](Halfedge_index h) {
      const Vertex_index w = mesh().target(h);
      if(w == v || !m_surface.is_remaining(Edge_index(h)))
        return;
      entries.emplace_back(static_cast<int>(w.idx()), -weight(h));
      diagonal += weight(h);
    });
    entries.emplace_back(static_cast<int>(v.idx()), diagonal);
  }

  Partially_decorated_surface<FT> m_surface;
  std::vector<FT> m_scale_factor, m_origin;
  std::vector<FT> m_angle;         // at the source of each halfedge
  std::vector<double> m_cotangent; // of the angle opposite to each halfedge
  std::vector<double> m_error;     // of the sum of angles, for each vertex
  Vector m_gradient;
  double m_gradient_error = 0;
  mutable Matrix m_Hessian;
  mutable bool m_has_Hessian = false;
};

template <typename FT>
FT Spherical_energy<FT>::value() const
{
  using std::log;
  const FT pi = boost::math::constants::pi<FT>();
  FT sum(0);
  for(Vertex_index v : mesh().vertices())
    if(v != m_surface.vertex_at_infinity() && !mesh().is_isolated(v))
      sum += 2 * pi * m_scale_factor[v.idx()];
  for(Halfedge_index h : mesh().halfedges()) {
    if(!m_surface.is_remaining(Edge_index(h)))
      continue;
    const FT lambda = 2 * log(m_surface.scaled_length(Edge_index(h)));
    sum -= pi / 2 * lambda;
    if(!is_remaining(h))
      continue;
    const FT& opposite = m_angle[mesh().prev(h).idx()];
    sum += opposite * lambda + 2 * Lobachevsky_function(opposite);
  }
  return sum;
}

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H
