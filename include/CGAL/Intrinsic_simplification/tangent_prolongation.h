// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_TANGENT_PROLONGATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_TANGENT_PROLONGATION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Curve_tracer.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Computes the rotations of tangent spaces of fine vertices by the map, from the directions of the
// images of their edges.
class Tangent_map
{
  typedef std::complex<double> Complex;
  typedef Intrinsic_triangulations::Tangent_frames<double> Frames;
  typedef Intrinsic_triangulations::Flat_face<double> Flat_face;

public:
  Tangent_map(const Surface_map& map, const Frames& fine_frames, const Frames& coarse_frames)
    : m_map(map),
      m_fine(map.fine().mesh()),
      m_coarse(map.coarse().mesh()),
      m_fine_frames(fine_frames),
      m_coarse_frames(coarse_frames),
      m_weight(m_fine.num_halfedges(), 0),
      m_turn(m_fine.num_vertices(), 0),
      m_place(m_fine.num_vertices())
  {
    for(Halfedge_index h : m_fine.halfedges())
      if(!m_fine.is_border(h))
        weigh_corner(h);
    Curve_tracer tracer(map, true);
    for(Edge_index e : m_fine.edges()) {
      const auto& pieces = tracer.trace(m_fine.halfedge(e, 0));
      add_direction(m_fine.halfedge(e, 0), pieces.front().face, pieces.front().from,
                    pieces.front().to);
      add_direction(m_fine.halfedge(e, 1), pieces.back().face, pieces.back().to,
                    pieces.back().from);
    }
  }

  Eigen::SparseMatrix<Complex> matrix() const
  {
    return Intrinsic_triangulations::assembled<Eigen::SparseMatrix<Complex, Eigen::RowMajor>>(
      m_fine.num_vertices(), m_coarse.num_vertices(), [this](std::size_t i, auto& entries) {
        const Vertex_index v(static_cast<Vertex_index::size_type>(i));
        const Vertex_index coarse = m_map.coarse_vertex(v);
        if(coarse.is_valid())
          entries.emplace_back(int(coarse.idx()), m_fine.is_isolated(v) ? Complex(1) : back(v));
        else
          this->add_row(v, entries);
      });
  }

private:
  // Adds a corner to the rotation. Halfedges represent the directions around them.
  void weigh_corner(Halfedge_index h)
  {
    const Halfedge_index next = next_around_source(h, m_fine);
    double corner = m_fine_frames.angle(next) - m_fine_frames.angle(h);
    if(corner <= 0)
      corner += 2 * pi<double>();
    m_weight[h] += corner;
    m_weight[next] += corner;
  }

  Flat_face flat_face(Face_index f) const
  {
    return Flat_face(m_coarse.halfedge(f), m_map.coarse());
  }

  static std::array<double, 3> coordinates(const Face_point& p)
  {
    std::array<double, 3> result = p.weight;
    normalize(result);
    return result;
  }

  // Adds the direction of the image of the fine halfedge `h`, which starts at `p` towards `q`.
  void add_direction(Halfedge_index h, Face_index surface_face, const Face_point& p,
                     const Face_point& q)
  {
    const Vertex_index v = m_fine.source(h);
    const Face_index f = m_map.coarse().level_face(surface_face);
    const Flat_face face = flat_face(f);
    const Complex vector = face.between(coordinates(p), coordinates(q));
    if(is_single(p.corners)) {
      const std::size_t c = p.corners == bit(0) ? 0 : p.corners == bit(1) ? 1 : 2;
      add_turn(h, std::polar(1., vertex_angle(f, c, vector / face.direction(c))));
    } else if(vector != 0.)
      add_turn(h, vector / std::abs(vector));
    m_place[v] = {f, coordinates(p)};
  }

  void add_turn(Halfedge_index h, const Complex& direction)
  {
    m_turn[m_fine.source(h)] += m_weight[h] * direction * std::polar(1., -m_fine_frames.angle(h));
  }

  // Returns the normalized angle of a vector at a corner of a coarse face, given in the frame of
  // the side after the corner.
  double vertex_angle(Face_index f, std::size_t corner, const Complex& vector) const
  {
    const Halfedge_index side = Intrinsic_triangulations::sides(f, m_coarse)[corner];
    return m_coarse_frames.angle(side) +
           m_coarse_frames.scale(m_coarse.source(side)) * std::arg(vector);
  }

  // Returns the rotation from the coarse surface back to the tangent space of `v`.
  Complex back(Vertex_index v) const
  {
    const double size = std::abs(m_turn[v]);
    if(!(size > 0))
      throw Intrinsic_triangulations::Numerical_error("the directions around vertex " +
                                                      std::to_string(v.idx()) + " are lost");
    return std::conj(m_turn[v]) / size;
  }

  // Adds a row. Vectors at the corners of the coarse face are transported straight to the image of
  // `v`.
  template <typename Entries>
  void add_row(Vertex_index v, Entries& entries) const
  {
    const auto& [f, p] = m_place[v];
    const auto sides = Intrinsic_triangulations::sides(f, m_coarse);
    const Flat_face face = flat_face(f);
    for(std::size_t c = 0; c < 3; ++c) {
      if(p[c] == 0)
        continue;
      Complex way = -face.to_corner(c, p);
      if(way == 0.)
        way = face.direction(c);
      const Complex turn =
        std::polar(1., std::arg(way) - vertex_angle(f, c, way / face.direction(c)));
      entries.emplace_back(int(m_coarse.source(sides[c]).idx()), p[c] * back(v) * turn);
    }
  }

  const Surface_map& m_map;
  const Delta_complex &m_fine, &m_coarse;
  const Frames &m_fine_frames, &m_coarse_frames;
  std::vector<double> m_weight;               // of each fine halfedge
  std::vector<Complex> m_turn;                // of each fine vertex, times some positive number
  std::vector<Surface_map::Location> m_place; // of each fine vertex, on the coarse surface
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// returns the complex matrix that maps tangent vectors at the vertices of the coarse level to
/// tangent vectors at the vertices of the fine level.
///
/// For a fine vertex, the vectors at the corners of the coarse face are transported straight to its
/// image and interpolated. Then they are rotated like the tangent space of the vertex, by the
/// rotation that is closest to the differential of the map. So no vector becomes longer than the
/// longest vector at a corner. A parallel field keeps its length; without scaling it is reproduced.
/// Entries have the absolute values of `prolongation_matrix()`, or less if a coarse face has a
/// vertex twice.
/// \param map the map
/// \param fine_frames,coarse_frames the frames of both levels, by which tangent vectors are complex
///   numbers
///
/// Complexity: the time to trace all fine edges.
/// \throws Intrinsic_triangulations::Numerical_error if rounding leaves no direction around a
///   vertex
inline Eigen::SparseMatrix<std::complex<double>>
tangent_prolongation_matrix(const Surface_map& map,
                            const Intrinsic_triangulations::Tangent_frames<double>& fine_frames,
                            const Intrinsic_triangulations::Tangent_frames<double>& coarse_frames)
{
  return internal::Tangent_map(map, fine_frames, coarse_frames).matrix();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_TANGENT_PROLONGATION_H
