// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_SURFACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Radii.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

template <>
struct Eigen::NumTraits<CGAL::Intrinsic_triangulations::Double_double>
  : public Eigen::GenericNumTraits<CGAL::Intrinsic_triangulations::Double_double>
{};

namespace CGAL::Intrinsic_triangulations::internal {

// Computes the curvatures at the edges from the apex of pyramids over the faces of a surface. A
// curvature is a full turn minus the angles between lateral faces. These angles exceed the angles
// of the surface by the curvature of the surface minus the curvature at the apex.
struct Apex_curvatures
{
  typedef Eigen::VectorXd Vector;

  // Returns the curvatures minus these values.
  Vector curvature_minus(const Vector& value) const { return -differences(angle, 1, -value); }
  // Returns the curvatures of the surface minus the curvatures and these values.
  Vector excess_minus(const Vector& value) const { return differences(excess, 0, value); }

  bool exist = true; // whether all pyramids do
  std::vector<Angle_sum> angle, excess;
  // The derivative by the radii is symmetric; its upper triangle is stored. Around short edges far
  // from the apex, sums of rows are tiny differences of entries.
  Eigen::SparseMatrix<Double_double> derivative;

private:
  static Vector differences(const std::vector<Angle_sum>& sums, int turns, const Vector& angles)
  {
    Vector result(angles.size());
    for(Eigen::Index i = 0; i < angles.size(); ++i)
      result[i] = sums[static_cast<std::size_t>(i)].minus(turns, angles[i]);
    return result;
  }
};

// Decides whether the angles between bases of pyramids are at most pi.
class Is_convex_with_apex
{
public:
  Is_convex_with_apex(const Metric_surface& surface, const Radii& radii)
    : m_surface(surface), m_radii(radii)
  {}

  bool is_certain(Edge_index e) const
  {
    const Halfedge_index h = m_surface.mesh().halfedge(e);
    return m_is_Delaunay.is_certain(m_surface.diamond_at(h), weights(h));
  }
  bool operator()(Edge_index e) const
  {
    const Halfedge_index h = m_surface.mesh().halfedge(e);
    return m_is_Delaunay(m_surface.diamond_at(h), weights(h));
  }

private:
  Diamond_weights<Double_double> weights(Halfedge_index h) const
  {
    return diamond_weights(boost::make_function_property_map<Vertex_index>(
                             [this](Vertex_index v) { return m_radii.weight(v.idx()); }),
                           h, m_surface.mesh());
  }

  const Metric_surface& m_surface;
  const Radii& m_radii;
  // Lengths that flips have rounded have this relative error.
  Is_locally_weighted_Delaunay<Double_double> m_is_Delaunay{0x1p-80};
};

// Flips until the angles between bases of pyramids are at most pi. Returns whether that was
// possible, with at most `limit` flips.
inline bool make_convex(Metric_surface& surface, const Radii& radii, std::size_t limit)
{
  const Is_convex_with_apex is_convex(surface, radii);
  Edge_stack stack(surface.mesh().num_edges());
  for(Edge_index e : surface.mesh().edges())
    stack.push_if(!is_convex.is_certain(e), e);
  const auto flip = [&](Halfedge_index h) {
    const bool is_possible = surface.is_flippable(h);
    if(is_possible)
      surface.flip(h);
    return is_possible;
  };
  return flip_within_limit(
           surface.mesh(), stack, limit, [&](Edge_index e) { return is_convex.is_certain(e); },
           is_convex, flip)
    .is_Delaunay();
}

inline Pyramid pyramid(Face_index f, const Metric_surface& surface, const Radii& radii)
{
  std::array<Double_double, 3> side, radius, weight;
  for(std::size_t s = 0; s < 3; ++s) {
    const Halfedge_index h = sides(f, surface.mesh())[s];
    const std::size_t i = surface.mesh().source(h).idx();
    side[s] = surface.length(h);
    radius[s] = radii.radius(i);
    weight[s] = radii.weight(i);
  }
  return {side, radius, weight};
}

inline Apex_curvatures apex_curvatures(const Metric_surface& surface, const Radii& radii)
{
  const Delta_complex& mesh = surface.mesh();
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  const auto index = [](Vertex_index v) { return static_cast<int>(v.idx()); };
  Apex_curvatures result;
  result.angle.resize(mesh.number_of_vertices());
  result.excess.resize(mesh.number_of_vertices());
  std::vector<Eigen::Triplet<Double_double>> entries;
  for(Face_index f : mesh.faces()) {
    const Pyramid p = pyramid(f, surface, radii);
    if(!p.exists()) {
      result.exist = false;
      return result;
    }
    for(std::size_t s = 0; s < 3; ++s) {
      const Halfedge_index h = sides(f, mesh)[s];
      const int i = index(mesh.source(h)), j = index(mesh.target(h));
      p.add_lateral_angle(s, result.angle[mesh.source(h).idx()],
                          result.excess[mesh.source(h).idx()]);
      const Double_double w = p.derivative(s), of_end = -p.cosine_at_apex(s) * w;
      entries.emplace_back((std::min)(i, j), (std::max)(i, j), i == j ? w + w : w);
      entries.emplace_back(i, i, of_end);
      entries.emplace_back(j, j, of_end);
    }
  }
  result.derivative.resize(n, n);
  result.derivative.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_SURFACE_H
