// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Convexity_certificate.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Conformal_barycenter.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Stereographic_triangulation.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The vertices of a sphere in the plane, one at infinity, such that the inverse of the
// stereographic projection has their center of mass in the center of the sphere; and the
// triangulation that is convex there.
template <typename FT>
class Sphere_layout
{
public:
  typedef std::array<FT, 2> Point;

  // `length` has the lengths in the plane of the edges of `mesh`; `mass` are those of the vertices
  // of the surface itself. A doubled disk has its axis on the real line, with the disk above it.
  Sphere_layout(const Delta_complex& mesh, const std::vector<FT>& length, Vertex_index at_infinity,
                const std::vector<double>& mass, const Doubled_problem& problem)
    : m_problem(problem),
      m_at_infinity(at_infinity),
      m_position(Plane_layout<FT>(mesh, length, at_infinity, problem).positions())
  {
    center(mass);
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_isolated(v))
        at(v) = {FT(0), FT(0)};
    Stereographic_triangulation<FT> triangulation(mesh, m_position, at_infinity);
    m_flips = triangulation.make_convex();
    m_certificate = triangulation.certificate();
  }

  // that of the vertex at infinity has no meaning, and those of isolated vertices are the origin
  const std::vector<Point>& positions() const { return m_position; }
  // by how much the plane was scaled down
  const FT& scale() const { return m_scale; }
  // the flips that were needed
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  const Convexity_certificate& certificate() const { return m_certificate; }

private:
  Point& at(Vertex_index v) { return m_position[v.idx()]; }

  // The mirror images of vertices have mass, too.
  void center(std::vector<double> mass)
  {
    std::vector<Point> position(m_position.begin(),
                                m_position.begin() + std::ptrdiff_t(mass.size()));
    for(Vertex_index v : m_problem.surface().vertices())
      if(m_problem.number_of_copies(v.idx()) > 1) {
        position.push_back({at(v)[0], -at(v)[1]});
        mass.push_back(mass[v.idx()]);
      }
    const Conformal_barycenter<FT> center(position, mass, m_at_infinity.idx());
    m_scale = center.height();
    for(Point& p : m_position)
      p = {(p[0] - center.base()[0]) / m_scale,
           (m_problem.has_no_copies() ? FT(p[1] - center.base()[1]) : p[1]) / m_scale};
  }

  const Doubled_problem& m_problem;
  Vertex_index m_at_infinity;
  std::vector<Point> m_position;
  FT m_scale = FT(1);
  std::vector<Halfedge_index> m_flips;
  Convexity_certificate m_certificate;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_LAYOUT_H
