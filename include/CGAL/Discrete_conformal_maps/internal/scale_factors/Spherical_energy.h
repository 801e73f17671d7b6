// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Lobachevsky_function.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Angle_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Partially_decorated_surface.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cmath>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents the spherical energy. Its minimum under lower bounds are the scale factors that unfold
// a sphere, without one of its vertices, into the plane (Section 4.4.2). It is a model of
// `ConvexEnergy`. Scale factors are the sum of an origin and a variable, as in `Conformal_energy`.
// The variables of the vertex at infinity and of isolated vertices have no influence.
template <typename FT_ = double>
class Spherical_energy
  : public Angle_energy<Spherical_energy<FT_>, Partially_decorated_surface<FT_>, Flat_triangle<FT_>>
{
  typedef Angle_energy<Spherical_energy, Partially_decorated_surface<FT_>, Flat_triangle<FT_>> Base;
  friend Base;

public:
  typedef FT_ FT;
  using Base::surface;

  // `length` is a readable property map of the lengths of edges.
  template <typename EdgeLengthMap>
  Spherical_energy(const Delta_complex& complex, const EdgeLengthMap& length,
                   Vertex_index at_infinity)
    : Base(Partially_decorated_surface<FT>(complex, length, at_infinity), false)
  {}

  FT value() const;

  // Returns the derivative by one variable, after some have been moved. The gradient has the angle
  // defects, with pi instead of 2 pi on the boundary of the remaining surface. A vertex begins with
  // two right angles for each half of an edge without a face.
  double derivative(Vertex_index v) const
  {
    Angle_difference<FT> defect(FT(0));
    for_each_outgoing_halfedge(v, mesh(), [&](Halfedge_index h) {
      if(is_remaining(mesh().face(h))) {
        const auto corner = Base::triangle({h, mesh().next(h), mesh().prev(h)}).corner(0);
        defect.add_supplement(corner, Angle_difference<FT>::rounded_angle(corner));
      }
      if(is_remaining(Edge_index(h)))
        defect.subtract_half_turn();
    });
    return defect.value();
  }

private:
  using Base::mesh;

  template <typename Index>
  bool is_remaining(Index i) const
  {
    return surface().is_remaining(i);
  }

  // Sums up the angles for all derivatives.
  void sum_angles()
  {
    std::vector<Angle_difference<FT>> defect(Base::size(), Angle_difference<FT>(0));
    for(Halfedge_index h : mesh().halfedges()) {
      const Vertex_index v = mesh().source(h);
      if(is_remaining(mesh().face(h)))
        defect[v.idx()].add_supplement(Base::corner(h), Base::rounded_angle(h));
      if(is_remaining(Edge_index(h)))
        defect[v.idx()].subtract_half_turn();
    }
    for(Vertex_index v : mesh().vertices())
      Base::set_gradient(v, v == surface().vertex_at_infinity() ? 0 : defect[v.idx()].value());
  }
};

template <typename FT>
FT Spherical_energy<FT>::value() const
{
  using std::log;
  const FT pi = Intrinsic_triangulations::pi<FT>();
  FT sum(0);
  for(Vertex_index v : mesh().vertices())
    if(v != surface().vertex_at_infinity() && !mesh().is_isolated(v))
      sum += 2 * pi * this->scale_factors()[v.idx()];
  for(Halfedge_index h : mesh().halfedges()) {
    if(!is_remaining(Edge_index(h)))
      continue;
    const FT lambda = 2 * log(surface().scaled_length(Edge_index(h)));
    sum -= pi / 2 * lambda;
    if(!is_remaining(mesh().face(h)))
      continue;
    const FT facing = Base::angle(mesh().prev(h));
    sum += facing * lambda + 2 * Lobachevsky_function(facing);
  }
  return sum;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_ENERGY_H
