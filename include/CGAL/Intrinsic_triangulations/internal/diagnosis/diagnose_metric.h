// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_METRIC_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_complex.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Exact_point = Exact_predicates_inexact_constructions_kernel::Point_3;

// Returns the excess of the longest side over the sum of the other two, relative to the perimeter.
inline double triangle_inequality_excess(std::array<double, 3> sides)
{
  std::sort(sides.begin(), sides.end());
  return ((sides[2] - sides[1]) - sides[0]) / (sides[0] + sides[1] + sides[2]);
}

// Measures an embedding, rounded to `double`.
template <class Points>
class Embedded_metric
{
public:
  Embedded_metric(const Diagnosis_complex& complex, const Points& points,
                  Input_diagnosis& diagnosis)
    : m_complex(complex), m_points(points), m_diagnosis(diagnosis)
  {}

  // Differences are computed before they are rounded, so distinct points have a positive distance.
  double length(std::size_t e) const
  {
    const auto& [u, v] = m_complex.edge_ends[e];
    const auto& p = m_points[u];
    const auto& q = m_points[v];
    return std::hypot(CGAL::to_double(p[0] - q[0]), CGAL::to_double(p[1] - q[1]),
                      CGAL::to_double(p[2] - q[2]));
  }

  void check_vertices()
  {
    m_is_finite.assign(m_complex.number_of_vertices, true);
    for(std::size_t v = 0; v < m_complex.number_of_vertices; ++v) {
      const Exact_point p = point(v);
      m_is_finite[v] = std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
      if(!m_is_finite[v])
        m_diagnosis.add(Defect_kind::NON_FINITE_COORDINATE, m_complex.vertex(v));
    }
  }

  // An edge at a broken vertex is not reported again.
  bool is_measurable(std::size_t e) const
  {
    const auto& [u, v] = m_complex.edge_ends[e];
    return m_is_finite[u] && m_is_finite[v];
  }

  // Lengths of collinear points may miss equality by rounding, but the points do not.
  void check_shape(std::size_t f, const std::array<double, 3>& sides, double angle)
  {
    const std::size_t c = m_complex.first_corner[f];
    if(collinear(corner_point(c), corner_point(c + 1), corner_point(c + 2)))
      m_diagnosis.add(Defect_kind::DEGENERATE_FACE, m_complex.face(f));
    else {
      if(angle < needle_angle_in_degrees)
        m_diagnosis.add(Defect_kind::NEEDLE_FACE, m_complex.face(f));
      check_height(f, sides);
    }
  }

private:
  typedef std::array<std::array<double, 3>, 3> Corners;

  void check_height(std::size_t f, const std::array<double, 3>& sides)
  {
    const std::size_t c = m_complex.first_corner[f];
    Corners corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const Exact_point p = corner_point(c + i);
      corners[i] = {p.x(), p.y(), p.z()};
    }
    const auto longest = std::max_element(sides.begin(), sides.end());
    if(!is_within_rounding(corners, sides, *longest))
      return;
    const std::size_t apex = c + static_cast<std::size_t>(longest - sides.begin() + 2) % 3;
    m_diagnosis.add(Defect_kind::VERTEX_WITHIN_ROUNDING,
                    {{m_complex.corner_vertex[apex], Input_diagnosis::none}, f});
  }

  // Returns whether the least height is at most a unit in the last place of the greatest
  // coordinate. Lengths decide, unless the height is as small as their rounding error, or its
  // square root.
  static bool is_within_rounding(const Corners& p, const std::array<double, 3>& sides,
                                 double longest)
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    double greatest = 0;
    for(const auto& corner : p)
      for(double x : corner)
        greatest = (std::max)(greatest, std::abs(x));
    const double unit = epsilon * greatest;
    const double height = quadrupled_area(sides[0], sides[1], sides[2]) / (2 * longest);
    if(height > unit + 16 * std::sqrt(epsilon) * longest)
      return false;
    typedef Exact_ring R;
    const auto normal = cross(vector_between<R>(p[0], p[1]), vector_between<R>(p[0], p[2]));
    const R base = (std::max)({squared_distance<R>(p[0], p[1]), squared_distance<R>(p[1], p[2]),
                               squared_distance<R>(p[2], p[0])});
    return dot(normal, normal) <= R(unit) * R(unit) * base;
  }

  Exact_point point(std::size_t v) const
  {
    const auto& p = m_points[v];
    return Exact_point(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  }

  Exact_point corner_point(std::size_t c) const { return point(m_complex.corner_vertex[c]); }

  const Diagnosis_complex& m_complex;
  const Points& m_points;
  Input_diagnosis& m_diagnosis;
  std::vector<bool> m_is_finite;
};

// Measures given lengths, rounded to `double`.
class Abstract_metric
{
public:
  Abstract_metric(const Diagnosis_complex& complex, const std::vector<double>& lengths,
                  Input_diagnosis& diagnosis)
    : m_complex(complex), m_lengths(lengths), m_diagnosis(diagnosis)
  {}

  double length(std::size_t e) const { return m_lengths[e]; }

  void check_vertices() const {}

  bool is_measurable(std::size_t) const { return true; }

  void check_shape(std::size_t f, const std::array<double, 3>& sides, double angle)
  {
    const double excess = triangle_inequality_excess(sides);
    const double rounding = rounding_unit<double>();
    if(excess > rounding)
      m_diagnosis.add(Defect_kind::TRIANGLE_INEQUALITY_VIOLATED, m_complex.face(f));
    else if(excess >= -rounding)
      m_diagnosis.add(Defect_kind::DEGENERATE_FACE, m_complex.face(f));
    else if(angle < needle_angle_in_degrees)
      m_diagnosis.add(Defect_kind::NEEDLE_FACE, m_complex.face(f));
  }

private:
  const Diagnosis_complex& m_complex;
  const std::vector<double>& m_lengths;
  Input_diagnosis& m_diagnosis;
};

// Diagnoses lengths and angles of an embedding or of given lengths.
template <class Metric>
class Metric_diagnoser
{
public:
  Metric_diagnoser(const Diagnosis_complex& complex, Metric metric, Input_diagnosis& diagnosis)
    : m_complex(complex),
      m_metric(metric),
      m_diagnosis(diagnosis),
      m_corner_length(complex.corner_vertex.size())
  {}

  void operator()()
  {
    m_metric.check_vertices();
    for(std::size_t e = 0; e < m_complex.number_of_edges(); ++e)
      check_edge(e);
    for(std::size_t f = 0; f < m_complex.number_of_faces(); ++f)
      if(m_complex.degree(f) == 3)
        check_triangle(f);
  }

private:
  void check_edge(std::size_t e)
  {
    const double length = m_metric.length(e);
    for(std::size_t i = m_complex.first_side[e]; i < m_complex.first_side[e + 1]; ++i)
      m_corner_length[m_complex.sides[i].corner] = length;
    if(!m_metric.is_measurable(e))
      return;
    if(length == 0)
      m_diagnosis.add(Defect_kind::ZERO_LENGTH_EDGE, m_complex.edge(e));
    if(is_length(length))
      note_length(length);
    else
      m_diagnosis.add(Defect_kind::INVALID_LENGTH, m_complex.edge(e));
    if(is_length(length) && length > 0 && !m_is_in_range(length))
      m_diagnosis.add(Defect_kind::LENGTH_OUT_OF_RANGE, m_complex.edge(e));
  }

  static bool is_length(double length) { return std::isfinite(length) && length >= 0; }

  void note_length(double length)
  {
    Input_diagnosis::Statistics& s = m_diagnosis.statistics();
    s.min_edge_length = (std::min)(s.min_edge_length, length);
    s.max_edge_length = (std::max)(s.max_edge_length, length);
  }

  // A triangle with a side of zero length has no angles. The side has been reported.
  void check_triangle(std::size_t f)
  {
    const std::size_t c = m_complex.first_corner[f];
    const std::array<double, 3> sides = {m_corner_length[c], m_corner_length[c + 1],
                                         m_corner_length[c + 2]};
    if(!std::all_of(sides.begin(), sides.end(), [](double l) { return is_length(l) && l > 0; }))
      return;
    Input_diagnosis::Statistics& s = m_diagnosis.statistics();
    const double angle = smallest_angle(sides);
    s.min_angle = (std::min)(s.min_angle, angle);
    m_metric.check_shape(f, sides, angle);
  }

  const Diagnosis_complex& m_complex;
  Metric m_metric;
  Input_diagnosis& m_diagnosis;
  std::vector<double> m_corner_length; // of the side that leaves the corner
  Euclidean_geometry_traits<double>::Is_length m_is_in_range;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_METRIC_H
