// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharp_edges.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace {

using Vector = Kernel::Vector_3;

// The normal of the face of `h`, of any length.
Vector normal(Mesh::Halfedge_index h, const Mesh& mesh)
{
  const Point& p = mesh.point(mesh.source(h));
  const Point& q = mesh.point(mesh.target(h));
  return CGAL::cross_product(q - p, mesh.point(mesh.target(mesh.next(h))) - q);
}

// Zero if a vector is zero.
double angle_in_degrees(const Vector& a, const Vector& b)
{
  const double sine = std::sqrt(CGAL::cross_product(a, b).squared_length());
  return std::atan2(sine, a * b) * 180 / boost::math::constants::pi<double>();
}

} // namespace

Mesh::Property_map<Mesh::Edge_index, bool> mark_sharp_edges(Mesh& mesh, double degrees)
{
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  for(const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if(!mesh.is_border(e))
      is_sharp[e] = angle_in_degrees(normal(h, mesh), normal(mesh.opposite(h), mesh)) >= degrees;
  }
  return is_sharp;
}
