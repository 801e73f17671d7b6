// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HEAT_ERROR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HEAT_ERROR_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the relative errors of distances at some vertices, for which they are known exactly.
template <typename FT>
struct Heat_error
{
  std::size_t number_of_vertices = 0; ///< how many vertices are compared, sources left out
  FT greatest_distance = FT(0);       ///< the greatest exact distance of one of these
  FT mean = FT(0);                    ///< the mean of the relative errors
  FT ninety_percent = FT(0);          ///< nine of ten vertices have no greater relative error
  FT greatest = FT(0);                ///< the greatest relative error

  /// makes an estimate without vertices.
  Heat_error() = default;

  /// compares distances with exact distances that are at most `final_length`. Complexity: linear.
  /// \tparam Distances a vector of Eigen or of the standard library
  template <typename Distances = std::vector<FT>>
  Heat_error(const Distances& distance, const std::vector<FT>& exact, const FT& final_length)
  {
    typedef std::decay_t<decltype(distance.size())> Index;
    std::vector<FT> errors;
    for(std::size_t v = 0; v < exact.size(); ++v)
      if(exact[v] > 0 && exact[v] <= final_length && CGAL::is_finite(exact[v])) {
        errors.push_back(CGAL::abs(FT(distance[static_cast<Index>(v)] - exact[v])) / exact[v]);
        greatest_distance = (std::max)(greatest_distance, exact[v]);
        mean += errors.back();
      }
    number_of_vertices = errors.size();
    if(errors.empty())
      return;
    mean /= FT(errors.size());
    const std::size_t last = (9 * errors.size() + 9) / 10 - 1;
    const auto nth = errors.begin() + static_cast<std::ptrdiff_t>(last);
    std::nth_element(errors.begin(), nth, errors.end());
    ninety_percent = *nth;
    greatest = *std::max_element(nth, errors.end());
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HEAT_ERROR_H
