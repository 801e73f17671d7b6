// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_SIGNPOST_BASELINE_H
#define INTRINSIC_BENCHMARK_SIGNPOST_BASELINE_H

#include "Flipped_mesh.h"
#include "Traced_map.h"
#include "method.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <complex>
#include <cstddef>
#include <iterator>
#include <vector>

namespace Methods {

// Implements signposts (Sharp, Soliman, Crane 2019). Every halfedge of T2 stores its direction in
// the tangent space of T1 at its source. An edge is found on T1 by walking in this direction for
// its length.
class Signpost_baseline
{
public:
  explicit Signpost_baseline(const IT::Intrinsic_triangulation<>& tri)
    : m_tri(tri), m_frames(IT::Surface_view(m_tri.input(), m_tri.input_length_map()))
  {
    for(Halfedge_index h : m_tri.mesh().halfedges())
      m_angle.push_back(m_frames.angle(h));
  }

  std::size_t make_Delaunay()
  {
    return m_tri.make_Delaunay([this](Halfedge_index h) {
      update_angle(h);
      update_angle(m_tri.mesh().opposite(h));
    });
  }

  Subdivision_size subdivide() const
  {
    Traced_map curves(m_tri.input(), m_tri.mesh());
    for(Edge_index e : m_tri.mesh().edges())
      curves.add(trace(m_tri.mesh().halfedge(e)));
    return curves.subdivide();
  }

private:
  // Sets the direction of `h` to the direction of the previous outgoing halfedge, turned by the
  // angle between them.
  void update_angle(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index before = IT::previous_around_source(h, mesh);
    const auto length = [&](Halfedge_index x) { return m_tri.length(x); };
    const double angle = IT::corner_angle<double>(length(mesh.next(before)), length(before),
                                                  length(mesh.prev(before)));
    m_angle[h] = m_angle[before] + angle * scale(mesh.source(h));
  }

  // Returns the factor from angles on the surface to normalized angles.
  double scale(Vertex_index v) const
  {
    const double sum = m_frames.angle_sum(v);
    return (m_frames.angle_defect(v) + sum) / sum;
  }

  Traced_curve trace(Halfedge_index h) const
  {
    Traced_curve result{h, {}, {}};
    result.end = IT::trace_geodesic(IT::Surface_view(m_tri.input(), m_tri.input_length_map()),
                                    m_tri.mesh().source(h), std::polar(m_tri.length(h), m_angle[h]),
                                    IT::At_boundary::stop, std::back_inserter(result.crossings))
                   .end.first;
    return result;
  }

  Flipped_mesh m_tri;
  IT::Tangent_frames<double> m_frames; // of T1
  std::vector<double> m_angle;         // normalized, of each halfedge of T2
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_SIGNPOST_BASELINE_H
