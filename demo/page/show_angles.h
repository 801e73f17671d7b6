// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SHOW_ANGLES_H
#define INTRINSIC_SHOW_ANGLES_H

#include "page/View_page.h"

#include <CGAL/Intrinsic_triangulations/angles.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <boost/property_map/property_map.hpp>

#include <vector>

// Adds the angles of the triangles of a mesh to the histograms of the page.
template <class Any_mesh, class Length_map>
void show_angles(View_page& page, const char* name, const Any_mesh& mesh, const Length_map& length)
{
  std::vector<double> angles(mesh.num_halfedges(), -1);
  CGAL::Intrinsic_triangulations::compute_angles(
    mesh, length,
    boost::make_iterator_property_map(angles.begin(), get(boost::halfedge_index, mesh)));
  for(double& angle : angles)
    angle *= 180 / CGAL::Intrinsic_triangulations::pi<double>();
  page.add_angles(name, angles);
}

#endif // INTRINSIC_SHOW_ANGLES_H
