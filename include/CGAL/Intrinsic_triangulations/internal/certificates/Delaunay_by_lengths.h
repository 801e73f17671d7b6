// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DELAUNAY_BY_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DELAUNAY_BY_LENGTHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>

namespace CGAL::Intrinsic_triangulations::internal {

// Decides whether the edge ij of a diamond is locally Delaunay, if this is so, or not so, for all
// lengths within `certified_length_error()` of the given ones.
class Delaunay_by_lengths
{
public:
  Uncertain<bool> operator()(const Diamond<double>& length) const
  {
    if(is_certain(length))
      return true;
    return m_by_lengths(length) ? Uncertain<bool>::indeterminate() : Uncertain<bool>(false);
  }

  // whether it certainly is; branch-free
  bool is_certain(const Diamond<double>& length) const { return m_by_lengths.is_certain(length); }

private:
  Euclidean_geometry_traits<double>::Is_locally_Delaunay m_by_lengths{certified_length_error()};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DELAUNAY_BY_LENGTHS_H
