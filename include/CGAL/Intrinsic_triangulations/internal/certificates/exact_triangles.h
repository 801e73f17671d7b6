// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_TRIANGLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns a face that violates the triangle inequality, or null if no face does. Lengths of
// positions never do. If lengths satisfy the inequality by more than rounding errors, they need no
// exact test.
template <typename Number>
Face_index violated_triangle(const Exact_surface<Number>& input)
{
  if(input.metric.points.empty())
    for(Face_index f : input.mesh().faces()) {
      const Halfedge_index h = input.mesh().halfedge(f);
      const auto [a, b, c] = side_lengths(h, input);
      if((std::min)({b + c - a, c + a - b, a + b - c}) <= rounding_unit<double>() * (a + b + c) &&
         area_sign(h, input) == NEGATIVE)
        return f;
    }
  return Delta_complex::null_face();
}

template <typename Number>
void check_exact_triangles(const Exact_surface<Number>& input)
{
  if(const Face_index f = violated_triangle(input); f != Delta_complex::null_face())
    throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()) +
                        " by less than rounding");
}

// ---- Lengths in floating point ----

// Returns the greatest number of type `double` that does not exceed the sum of two positive
// numbers.
inline double sum_rounded_down(double a, double b)
{
  if(a < b)
    std::swap(a, b);
  const double sum = a + b;
  return sum - a > b ? std::nextafter(sum, 0) : sum; // the difference is exact
}

// Returns the longest side of a face, and the sum of the other two sides, rounded down.
template <typename Surface>
std::pair<Halfedge_index, double> longest_side(Face_index f, const Surface& surface)
{
  const Delta_complex& mesh = surface.mesh();
  const auto length = [&](Halfedge_index h) { return edge_length(h, surface); };
  const auto side = sides(f, mesh);
  const Halfedge_index longest =
    *std::max_element(side.begin(), side.end(),
                      [&](Halfedge_index g, Halfedge_index h) { return length(g) < length(h); });
  return {longest, sum_rounded_down(length(mesh.next(longest)), length(mesh.prev(longest)))};
}

// Shortens edges that are longer than the sum of the two other sides of a face to this sum. Short
// edges come first, so that an edge shortened later is no shorter. Most edges are shortened at most
// once.
template <typename Surface>
void shorten_to_triangles(const Surface& surface)
{
  typedef std::pair<double, Face_index> Entry;
  const Delta_complex& mesh = surface.mesh();
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> violated;
  const auto push_if_violated = [&](Face_index f) {
    const auto [h, sum] = longest_side(f, surface);
    if(const double length = edge_length(h, surface); length > sum)
      violated.emplace(length, f);
  };
  for(Face_index f : mesh.faces())
    push_if_violated(f);
  while(!violated.empty()) {
    const auto [h, sum] = longest_side(violated.top().second, surface);
    violated.pop();
    if(!(edge_length(h, surface) > sum))
      continue;
    put(surface.length_map(), mesh.edge(h), sum);
    if(const Halfedge_index o = mesh.opposite(h); !mesh.is_border(o))
      push_if_violated(mesh.face(o));
  }
}

// Turns lengths of type `double`, which may violate the triangle inequality by rounding, into the
// exact metric of a surface. Decisions are then free of contradictions. Squared lengths without a
// surface are removed. The lengths are shortened, and then count as exact.
inline void make_triangles_exact(const Exact_surface<double>& input, Input_metric<double>& metric)
{
  if(!metric.squared_lengths.empty() && violated_triangle(input) != Delta_complex::null_face())
    metric.squared_lengths.clear();
  if(metric.points.empty() && metric.squared_lengths.empty())
    shorten_to_triangles(input);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_TRIANGLES_H
