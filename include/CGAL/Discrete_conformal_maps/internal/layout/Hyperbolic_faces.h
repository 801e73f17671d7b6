// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HYPERBOLIC_FACES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HYPERBOLIC_FACES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Disk_motion.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Intrinsic_triangulations/Cut_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::Cut_graph;

// Returns for each edge a distance between its two faces. A face contributes a third of its median
// at the edge. Lengths are given as sinh(x/2).
inline std::vector<double> crossing_lengths(const Delta_complex& mesh,
                                            const std::vector<double>& length)
{
  // The median m to the side c satisfies cosh m = (cosh a + cosh b) / (2 cosh(c/2)). The formula
  // is evaluated without cancellation.
  const auto median = [&](Halfedge_index h) {
    const auto squared = [&](Halfedge_index x) {
      return length[Edge_index(x).idx()] * length[Edge_index(x).idx()];
    };
    const double c = squared(h), cosh = std::sqrt(1 + c);
    const double sinh2 =
      (squared(mesh.next(h)) + squared(mesh.prev(h)) - c / (1 + cosh)) / (2 * cosh);
    return 2 * std::asinh(std::sqrt((std::max)(sinh2, 0.)));
  };
  std::vector<double> result(mesh.num_edges());
  for(Edge_index e : mesh.edges())
    result[e.idx()] = (median(mesh.halfedge(e)) + median(mesh.opposite(mesh.halfedge(e)))) / 3;
  return result;
}

// Lays out the faces of closed hyperbolic surfaces in the Poincare disk, side by side along a
// tree. Each corner of a face has a frame. The frame is the motion that maps the origin to the
// corner, and the real direction to the halfedge that starts at the corner.
template <typename FT>
class Hyperbolic_faces
{
public:
  typedef Disk_motion<FT> Motion;

  // `length` contains sinh(x/2) for all edges with lengths x.
  Hyperbolic_faces(const Delta_complex& mesh, const std::vector<FT>& length, const Cut_graph& cut)
    : m_mesh(mesh), m_cut(cut), m_frame(mesh.num_halfedges()), m_along(mesh.num_edges())
  {
    for(Edge_index e : mesh.edges())
      m_along[e.idx()] = Motion::translation(length[e.idx()]);
    for(const Cut_graph::Step& step : cut.steps())
      place(step, length);
  }

  // Returns the frame at the source of `h`, in the face of `h`.
  const Motion& frame(Halfedge_index h) const { return m_frame[h.idx()]; }

  // Returns the motion that moves the face beyond `h` to its position beside the face of `h`.
  Motion gluing(Halfedge_index h) const
  {
    return beyond(h) * m_frame[m_mesh.opposite(h).idx()].inverse();
  }

  // Returns the error of the product of the motions around `v`. The motions map the faces around
  // `v` to their positions one after the other, so their product must be the identity.
  double gluing_error(Vertex_index v) const
  {
    Motion product;
    const Halfedge_index start = m_mesh.opposite(m_mesh.halfedge(v));
    Halfedge_index h = start;
    do {
      if(m_cut.is_open(Edge_index(h)))
        product = product * gluing(h);
      h = m_mesh.next(m_mesh.opposite(h));
    } while(h != start);
    return product.distance_to_identity();
  }

private:
  // Returns the frame of the opposite halfedge of `h`, with its face beside the face of `h`.
  Motion beyond(Halfedge_index h) const
  {
    return m_frame[h.idx()] * m_along[Edge_index(h).idx()] * Motion::rotation(FT(0), FT(1));
  }

  void place(const Cut_graph::Step& step, const std::vector<FT>& length)
  {
    const bool is_entry = step.entry.is_valid();
    const Halfedge_index h = is_entry ? step.entry : m_mesh.halfedge(step.face);
    const std::array<Halfedge_index, 3> side{h, m_mesh.next(h), m_mesh.prev(h)};
    const Hyperbolic_triangle<FT> triangle({length[Edge_index(side[0]).idx()],
                                            length[Edge_index(side[1]).idx()],
                                            length[Edge_index(side[2]).idx()]});
    m_frame[h.idx()] = is_entry ? beyond(m_mesh.opposite(h)) : Motion();
    for(std::size_t s = 1; s < 3; ++s)
      m_frame[side[s].idx()] = m_frame[side[s - 1].idx()] * m_along[Edge_index(side[s - 1]).idx()] *
                               turn(triangle.corner(s));
    if(!is_entry)
      move_to_origin(side);
  }

  // Returns the rotation by pi minus an angle.
  static Motion turn(const Corner<FT>& angle)
  {
    using std::sqrt;
    const FT norm = sqrt(angle.cosine * angle.cosine + angle.sine * angle.sine);
    const bool is_obtuse = angle.cosine < 0;
    // The two numbers are the cosine and the sine of half the angle. If the angle is obtuse, they
    // are the sine and the cosine.
    const FT greater = sqrt((norm + (is_obtuse ? FT(-angle.cosine) : angle.cosine)) / (2 * norm)),
             lesser = angle.sine / (2 * norm * greater);
    return is_obtuse ? Motion::rotation(greater, lesser) : Motion::rotation(lesser, greater);
  }

  // Moves the first face of a component such that its center is the origin.
  void move_to_origin(const std::array<Halfedge_index, 3>& side)
  {
    using std::sqrt;
    std::array<FT, 3> sum{FT(0), FT(0), FT(0)};
    for(Halfedge_index h : side) {
      const std::array<FT, 3> p = frame(h).image_of_origin();
      for(std::size_t i = 0; i < 3; ++i)
        sum[i] += p[i];
    }
    const FT norm = sqrt(sum[2] * sum[2] - sum[0] * sum[0] - sum[1] * sum[1]);
    const Motion shift =
      Motion::translation_to(sum[0] / norm, sum[1] / norm, sum[2] / norm).inverse();
    for(Halfedge_index h : side)
      m_frame[h.idx()] = shift * m_frame[h.idx()];
  }

  const Delta_complex& m_mesh;
  const Cut_graph& m_cut;
  std::vector<Motion> m_frame; // the frame at the source of each halfedge
  std::vector<Motion> m_along; // the translation along each edge by its length
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HYPERBOLIC_FACES_H
