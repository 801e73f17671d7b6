// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/map_distortion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace {

typedef Kernel::Vector_3 Vector;
typedef std::array<Vector, 3> Triangle;

double length(const Vector& a) { return std::sqrt(a.squared_length()); }

double area(const Triangle& t) { return length(CGAL::cross_product(t[1] - t[0], t[2] - t[0])) / 2; }

// Returns the quotient of the greatest and the least stretch of the linear map between two
// triangles.
double stretch_quotient(const Triangle& from, const Triangle& to)
{
  const Vector a = from[1] - from[0], b = from[2] - from[0];
  const Vector c = to[1] - to[0], d = to[2] - to[0];
  const double mean = ((b * b) * (c * c) - 2 * (a * b) * (c * d) + (a * a) * (d * d)) /
                      (8 * area(from) * area(to)); // of the quotient and its inverse
  return mean + std::sqrt((std::max)(mean * mean - 1, 0.));
}

double finite_or_nan(double x)
{
  return std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN();
}

// Stores a corner of a polygon: its position, and the position of its image with its weight.
struct Corner
{
  Vector place = CGAL::NULL_VECTOR, image = CGAL::NULL_VECTOR;
  double weight = 0;
};

typedef std::array<Corner, 3> Triple;

class Distortion
{
public:
  Distortion(const Output_mesh& mesh, Image_kind kind) : m_mesh(mesh), m_kind(kind)
  {
    if(kind == Image_kind::sphere)
      for(const char* name : {"homogeneous_x", "homogeneous_y", "homogeneous_z", "homogeneous_w"})
        m_homogeneous.push_back(find_attribute(mesh.point_data, name));
  }

  // Returns the values of the greatest triangles of polygons.
  std::vector<double> of_polygons(double (Distortion::*value)(const Triple&) const) const
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < m_mesh.polygons.size(); ++i)
      result.push_back(finite_or_nan((this->*value)(greatest_triangle(corners(i)))));
    return result;
  }

  double angle(const Triple& t) const { return stretch_quotient(places(t), tangents(t)); }

  double linear_angle(const Triple& t) const
  {
    return stretch_quotient(places(t), {t[0].image, t[1].image, t[2].image});
  }

  double log_area(const Triple& t) const { return std::log(area(tangents(t)) / area(places(t))); }

  double polygon_area(std::size_t i) const
  {
    const std::vector<Corner> c = corners(i);
    Vector sum = CGAL::NULL_VECTOR;
    for(std::size_t k = 2; k < c.size(); ++k)
      sum += CGAL::cross_product(c[k - 1].place - c[0].place, c[k].place - c[0].place);
    return length(sum) / 2;
  }

  // Returns the interpolation error. Projective interpolation at t with weights v and w is at t w /
  // ((1 - t) v + t w).
  double interpolation_error(std::size_t i) const
  {
    const std::vector<Corner> c = corners(i);
    double result = 0;
    for(std::size_t k = 0; k < c.size(); ++k) {
      const double v = std::sqrt(c[k].weight), w = std::sqrt(c[(k + 1) % c.size()].weight);
      result = (std::max)(result, std::abs(v - w) / (v + w));
    }
    return result;
  }

private:
  std::vector<Corner> corners(std::size_t i) const
  {
    std::vector<Corner> result;
    for(std::size_t k = 0; k < m_mesh.polygons[i].size(); ++k) {
      const auto p = m_mesh.polygons[i][k];
      const auto [x, y, z, w] = homogeneous(i, k);
      result.push_back({m_mesh.points[p] - CGAL::ORIGIN, {x / w, y / w, z / w}, w});
    }
    return result;
  }

  std::array<double, 4> homogeneous(std::size_t i, std::size_t k) const
  {
    if(m_kind != Image_kind::sphere) {
      const auto& z = m_mesh.texture.coordinates[m_mesh.texture.polygons[i][k]];
      return {z[0], z[1], 0, z[2]};
    }
    const std::size_t p = m_mesh.polygons[i][k];
    const auto& h = m_homogeneous;
    return {(*h[0])[p], (*h[1])[p], (*h[2])[p], (*h[3])[p]};
  }

  static Triple greatest_triangle(const std::vector<Corner>& c)
  {
    Triple result{};
    double most = -1;
    for(std::size_t k = 2; k < c.size(); ++k) {
      const Triple t{c[0], c[k - 1], c[k]};
      if(const double here = area(places(t)); here > most) {
        most = here;
        result = t;
      }
    }
    return result;
  }

  static Triangle places(const Triple& t) { return {t[0].place, t[1].place, t[2].place}; }

  // Returns the images of the corners under the derivative of the map at the center.
  Triangle tangents(const Triple& t) const
  {
    const double sum = t[0].weight + t[1].weight + t[2].weight;
    Vector middle = CGAL::NULL_VECTOR;
    for(const Corner& c : t)
      middle += c.weight / sum * c.image;
    Triangle result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = tangent(middle, 3 * t[k].weight / sum * (t[k].image - middle));
    return result;
  }

  // Returns a vector at a point in a frame that is orthonormal in the metric of the image.
  Vector tangent(const Vector& at, const Vector& d) const
  {
    if(m_kind == Image_kind::plane)
      return d;
    const double square = at.squared_length();
    const Vector along = square > 0 ? (d * at) / square * at : CGAL::NULL_VECTOR;
    if(m_kind == Image_kind::sphere)
      return (d - along) / std::sqrt(square);
    return along / (1 - square) + (d - along) / std::sqrt(1 - square);
  }

  const Output_mesh& m_mesh;
  Image_kind m_kind;
  std::vector<const Attribute*> m_homogeneous; // on the sphere
};

// Normalizes logarithms so that the total areas are equal.
void normalize(std::vector<double>& logarithms, const Distortion& distortion)
{
  double before = 0, after = 0;
  for(std::size_t i = 0; i < logarithms.size(); ++i)
    if(std::isfinite(logarithms[i])) {
      before += distortion.polygon_area(i);
      after += distortion.polygon_area(i) * std::exp(logarithms[i]);
    }
  for(double& x : logarithms)
    x -= std::log(after / before);
}

} // namespace

void add_distortion(Output_mesh& mesh, Image_kind kind)
{
  const Distortion distortion(mesh, kind);
  std::vector<double> areas = distortion.of_polygons(&Distortion::log_area);
  normalize(areas, distortion);
  std::vector<Attribute> result{{"angle_distortion", distortion.of_polygons(&Distortion::angle)},
                                {"area_distortion", std::move(areas)}};
  if(kind == Image_kind::plane) {
    result.push_back(
      {"linear_angle_distortion", distortion.of_polygons(&Distortion::linear_angle)});
    std::vector<double> errors;
    for(std::size_t i = 0; i < mesh.polygons.size(); ++i)
      errors.push_back(distortion.interpolation_error(i));
    result.push_back({"interpolation_error", std::move(errors)});
  }
  mesh.polygon_data.insert(mesh.polygon_data.end(), result.begin(), result.end());
}
