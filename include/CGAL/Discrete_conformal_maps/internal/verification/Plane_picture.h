// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANE_PICTURE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANE_PICTURE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the positions of the faces of T_3 in the plane.
struct Planar_layout
{
  bool exists = false;
  std::vector<char> is_laid_out;              // for each face
  std::vector<std::complex<double>> position; // of the source of each halfedge
  std::vector<char> is_seam;                  // for each edge
  double scale = 1;                           // positions have been multiplied by it since then
};

// Compares the faces of T_3 in the plane, with positions in `double`, with their scaled lengths.
//
// A side or a face is crowded if it has another shape in the picture, and rounding of its corners
// explains the difference. Crowded sides and faces do not contribute to errors.
class Plane_picture
{
public:
  // The picture refers to both arguments.
  Plane_picture(const Map_data& data, const Planar_layout& layout)
    : m_data(data),
      m_layout(layout),
      m_length(mesh().num_edges()),
      m_rounding(tolerance::roundings_of_position * tolerance::unit * size()),
      m_is_crowded(mesh().num_halfedges(), 0)
  {
    for(Edge_index e : mesh().edges())
      m_length[e.idx()] = data.scaled_length(mesh().halfedge(e));
    for(Halfedge_index h : mesh().halfedges())
      m_is_crowded[h.idx()] = is_laid_out(mesh().face(h)) && has_changed_by_rounding(h);
  }

  bool is_laid_out(Face_index f) const { return f.is_valid() && m_layout.is_laid_out[f.idx()]; }

  // Returns whether the side `h` of a face that is laid out is crowded.
  bool is_crowded(Halfedge_index h) const { return m_is_crowded[h.idx()] != 0; }

  bool is_crowded(Face_index f) const
  {
    const auto side = sides(f, mesh());
    return std::any_of(side.begin(), side.end(), [&](Halfedge_index h) { return is_crowded(h); }) ||
           (!is_positive(f) && height(f) <= m_rounding);
  }

  // Returns for each face of T_3 whether it is crowded.
  std::vector<char> crowded_faces() const
  {
    std::vector<char> result(mesh().num_faces(), 0);
    for(Face_index f : mesh().faces())
      result[f.idx()] = is_laid_out(f) && is_crowded(f);
    return result;
  }

  // Returns the number of faces that are reversed or have no area, exactly.
  std::size_t number_of_collapsed_faces() const
  {
    const auto faces = mesh().faces();
    return std::size_t(std::count_if(faces.begin(), faces.end(), [this](Face_index f) {
      return is_laid_out(f) && !is_positive(f) && !is_crowded(f);
    }));
  }

  // Returns the greatest relative difference of a length in the plane from the scaled length. The
  // two sides of a seam have the same scaled length. If the difference is zero, the charts close
  // up.
  double edge_length_error() const
  {
    return greatest_error(
      [this](Halfedge_index h) { return std::abs(length_of(h) / scaled_length(h) - 1); });
  }

  // Returns the greatest error of a cross ratio. With circles, it is the error of the Gram
  // coordinates, hence of inversive distances. Radii are scaled by their factors, and distances of
  // centers are distances of positions.
  double max_cross_ratio_error() const
  {
    if(m_data.bc.traits().has_radii())
      return max_Gram_error();
    const auto counts = [this](Halfedge_index h) {
      const Halfedge_index o = mesh().opposite(h);
      return is_laid_out(mesh().face(h)) && is_laid_out(mesh().face(o)) &&
             !is_crowded(mesh().next(h)) && !is_crowded(mesh().prev(h)) &&
             !is_crowded(mesh().next(o)) && !is_crowded(mesh().prev(o));
    };
    const auto ideal = [this](Halfedge_index h) { return m_data.bc.length(mesh().edge(h)); };
    return greatest_cross_ratio_error(
      mesh(), counts, [this](Halfedge_index h) { return length_of(h); }, ideal);
  }

  // Returns whether every difference from the scaled lengths is a rounding error.
  bool is_faithful() const
  {
    return edge_length_error() <= tolerance::promised_length / 8 &&
           number_of_collapsed_faces() == 0;
  }

private:
  double max_Gram_error() const
  {
    return greatest_error([this](Halfedge_index h) {
      const double length = scaled_length(h), error = length_of(h) - length;
      return std::abs(error * (length_of(h) + length)) /
             (2 * m_data.scaled_decorated_length(h).gram());
    });
  }

  // Returns the greatest error of a side of a face, without crowded sides.
  template <typename Error>
  double greatest_error(const Error& error) const
  {
    double result = 0;
    for(Halfedge_index h : mesh().halfedges())
      if(!mesh().is_border(h) && is_laid_out(mesh().face(h)) && !is_crowded(h))
        result = greater_error(result, error(h));
    return result;
  }

  const Delta_complex& mesh() const { return m_data.bc.mesh(); }
  const std::complex<double>& at(Halfedge_index h) const { return m_layout.position[h.idx()]; }

  // Returns the length of a side in the plane.
  double length_of(Halfedge_index h) const
  {
    return std::abs(at(mesh().next(h)) - at(h)) / m_layout.scale;
  }

  double scaled_length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  // Returns whether rounding has changed a cross ratio, which has the errors of four lengths. A
  // length of zero indicates underflow.
  bool has_changed_by_rounding(Halfedge_index h) const
  {
    const double length = scaled_length(h), error = std::abs(length_of(h) - length);
    return (length == 0 || error > tolerance::promised_length / 8 * length) && error <= m_rounding;
  }

  // Returns the greatest coordinate. Charts have been moved, so positions that are small now have
  // the rounding errors of their earlier positions.
  double size() const
  {
    double result = 0;
    for(Halfedge_index h : mesh().halfedges())
      if(is_laid_out(mesh().face(h)))
        result = (std::max)({result, std::abs(at(h).real()), std::abs(at(h).imag())});
    return result;
  }

  bool is_positive(Face_index f) const
  {
    const auto side = sides(f, mesh());
    const auto point = [this](Halfedge_index h) {
      return Plane_predicates<double>::Point{at(h).real(), at(h).imag()};
    };
    return Plane_predicates<double>().orientation(point(side[0]), point(side[1]), point(side[2])) >
           0;
  }

  // Returns the height above the longest side of a triangle with the scaled lengths.
  double height(Face_index f) const
  {
    const auto side = sides(f, mesh());
    std::array<double, 3> length;
    for(std::size_t s = 0; s < 3; ++s)
      length[s] = scaled_length(side[s]);
    return std::sqrt(
             Intrinsic_triangulations::squared_quadrupled_area(length[0], length[1], length[2])) /
           (2 * (std::max)({length[0], length[1], length[2]}));
  }

  const Map_data& m_data;
  const Planar_layout& m_layout;
  std::vector<double> m_length;   // the scaled length of each edge
  double m_rounding;              // its error by rounding of positions
  std::vector<char> m_is_crowded; // for each halfedge
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANE_PICTURE_H
