// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

namespace internal {
template <typename Visitor>
class Flattening;
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// a discrete conformal map of a surface to the plane: three triangulations with the correspondence of
/// each to the next, scale factors, and the faces of the last in the plane (Section 4.3).
///
/// \f$T^A\f$ is the input. A component with boundary is doubled: the faces of its second copy follow those of
/// the input, and so do edges and vertices; the boundary is shared. \f$T^B\f$ is the intrinsic Delaunay
/// triangulation of \f$T^A\f$, and \f$T^C\f$ is the ideal Delaunay triangulation of \f$T^B\f$ with the
/// scale factors; with a fixed triangulation, all three are the same. The faces of \f$T^C\f$ are flat, and can be laid out beside each other except at seams.
///
/// Every component of the input is one chart. Where no scale factors are prescribed and no cones placed,
/// it has the same area as the component. Charts stand side by side and do not overlap each other; the
/// smallest rectangle around each is parallel to the axes, and the first starts at the origin.
class Planar_conformal_map
{
public:
  /// the type of \f$T^A\f$ and \f$T^B\f$.
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Euclidean_triangulation;
  /// the geometry of \f$T^B\f$ and \f$T^C\f$ as one ideal polyhedron.
  typedef Intrinsic_triangulations::Ideal_geometry_traits<> Ideal_traits;
  /// the type of \f$T^B\f$ and \f$T^C\f$.
  typedef Intrinsic_triangulations::Intrinsic_triangulation<Ideal_traits> Ideal_triangulation;
  /// the common subdivision of all three.
  typedef Triple_subdivision<double> Subdivision;
  /// a point of the input.
  typedef Intrinsic_triangulations::Face_location<double> Face_location;

  /// \f$T^A\f$ (as `input_mesh()`) and \f$T^B\f$.
  const Euclidean_triangulation& Delaunay() const { return m_data->ab; }
  /// \f$T^B\f$ (as `input_mesh()`) and \f$T^C\f$, both with the lengths that belong to scale factors of zero.
  const Ideal_triangulation& ideal() const { return m_data->bc; }
  /// the common subdivision of \f$T^A\f$, \f$T^B\f$ and \f$T^C\f$, of the doubled surface.
  const Subdivision& subdivision() const { return *m_data->subdivision; }

  /// whether the face `f` of \f$T^A\f$ is one of the input, not of its second copy.
  bool is_front(Face_index f) const { return f.idx() < m_data->number_of_front_faces; }

  /// the vertex of the input that `v` is, or of which it is the second copy.
  Vertex_index input_vertex(Vertex_index v) const { return m_data->input_vertex[v.idx()]; }

  /// the logarithmic scale factor at `v`.
  double log_scale(Vertex_index v) const { return m_data->log_scale[v.idx()]; }

  /// whether the map has what is prescribed, and if not, why.
  Flattening_status status() const { return m_data->status; }

  /// the vertices of the input at which cones were placed.
  const std::vector<Vertex_index>& cones() const { return m_data->cones; }

  /// how the minimization of the energy has ended.
  const Minimization_result& minimization() const { return m_data->minimization; }

  /// the greatest difference of a curvature from what was prescribed, in radians.
  double max_curvature_error() const { return m_data->max_curvature_error; }

  /// the number of flips that made `layer` of the triangulation before it: \f$T^B\f$ of \f$T^A\f$, or
  /// \f$T^C\f$ of \f$T^B\f$. Zero for \f$T^A\f$.
  std::size_t number_of_flips(Layer layer) const
  {
    return m_data->number_of_flips[static_cast<std::size_t>(layer)];
  }

  /// whether the faces of \f$T^C\f$ are in the plane. In a fixed triangulation they are not if scaled lengths
  /// violate the triangle inequality.
  bool is_laid_out() const { return m_data->has_layout; }

  /// whether the face `f` of \f$T^C\f$ is in the plane: if `is_laid_out()` and a part of it belongs to the input.
  bool is_laid_out(Face_index f) const { return m_data->is_laid_out[f.idx()] != 0; }

  /// the position of the source of `h`, a halfedge of \f$T^C\f$, in the face of `h`.
  /// \pre The face is laid out.
  std::complex<double> position(Halfedge_index h) const { return m_data->position[h.idx()]; }

  /// whether the two faces of the edge `e` of \f$T^C\f$ are not beside each other in the plane; also where a
  /// face is not laid out, since it is no part of the input.
  bool is_seam(Edge_index e) const { return m_data->is_seam[e.idx()] != 0; }

  /// the homogeneous coordinates of a point, as a vector `(x w, y w, w)`. They are linear on the faces of the
  /// common subdivision.
  /// \param on_C a face of \f$T^C\f$ and weights of its corners, such as
  ///        `Triple_subdivision::place_on_C()` gives
  std::array<double, 3> homogeneous_coordinates(const Face_location& on_C) const
  {
    const Delta_complex& mesh = ideal().mesh();
    std::array<double, 3> result{0, 0, 0};
    const auto side = Intrinsic_triangulations::internal::sides(on_C.first, mesh);
    for(std::size_t s = 0; s < 3; ++s) {
      const double w = on_C.second[s] * std::exp(-log_scale(mesh.source(side[s])));
      const std::complex<double> z = position(side[s]);
      result[0] += w * z.real();
      result[1] += w * z.imag();
      result[2] += w;
    }
    return result;
  }

  /// the image of a point of the input, by piecewise projective interpolation (Section 4.2.3).
  /// Complexity: that of `Intrinsic_triangulations::point_across()` with a correspondence, twice.
  /// \pre `is_laid_out()`
  std::complex<double> operator()(const Face_location& p) const
  {
    using Intrinsic_triangulations::Side;
    const Face_location on_B = point_across(Side::input, p, *m_data->correspondence_ab);
    const auto z =
      homogeneous_coordinates(point_across(Side::input, on_B, *m_data->correspondence_bc));
    return std::complex<double>(z[0], z[1]) / z[2];
  }

private:
  template <typename Visitor>
  friend class internal::Flattening;

  // does not move, since the correspondences refer to the triangulations
  struct Data
  {
    Euclidean_triangulation ab;
    Ideal_triangulation bc;
    std::unique_ptr<Intrinsic_triangulations::Correspondence<>> correspondence_ab;
    std::unique_ptr<Intrinsic_triangulations::Correspondence<Ideal_traits>> correspondence_bc;
    std::unique_ptr<Subdivision> subdivision;
    std::size_t number_of_front_faces = 0;
    std::vector<Vertex_index> input_vertex;
    std::vector<double> log_scale;
    Flattening_status status = Flattening_status::success;
    std::vector<Vertex_index> cones;
    Minimization_result minimization;
    double max_curvature_error = 0;
    std::array<std::size_t, 3> number_of_flips{0, 0, 0};
    bool has_layout = true;
    std::vector<char> is_laid_out;              // for each face of T^C
    std::vector<std::complex<double>> position; // of the sources of halfedges of T^C
    std::vector<char> is_seam;                  // for each edge of T^C
  };

  std::unique_ptr<Data> m_data = std::make_unique<Data>();
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_PLANAR_CONFORMAL_MAP_H
