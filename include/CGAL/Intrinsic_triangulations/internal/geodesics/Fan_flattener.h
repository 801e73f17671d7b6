// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLATTENER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLATTENER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan_flipping.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Flips edges out of the fans beside paths, and records the flips, so that it can undo them.
template <typename Traits>
class Fan_flattener
{
  typedef Fan_flipping<Traits> Flipping;

public:
  explicit Fan_flattener(Intrinsic_triangulation<Traits>& tri) : m_mesh(tri.mesh()), m_flipping(tri)
  {}

  bool is_less_than_pi(Fan_ends ends) { return m_flipping.is_less_than_pi(ends); }

  // Returns the number of flips since the last `rewind()`.
  std::size_t number_of_flips() const { return m_flips.size(); }

  // Flips the edges inside the fan as long as one can be flipped. The face of a loop of one edge is
  // at both ends of the fan, and its apex at both ends of the arc. This face is kept unless the
  // whole angle at its apex is less than pi. Flips of its other sides could wind them around the
  // loop endlessly. Returns whether the angles between sides opposite to the apex are known to be
  // at least pi.
  bool flip_out(Fan& outgoing, bool is_one_edge)
  {
    const std::size_t limit = m_flips.size() + 16 * outgoing.size();
    flip_between(outgoing, is_one_edge ? 2 : 1, limit);
    while(is_one_edge && outgoing.size() > 4 && m_flips.size() < limit &&
          is_less_than_pi(
            {m_mesh.next(outgoing[1]), opposite(m_mesh.next(outgoing[outgoing.size() - 3]))})) {
      flip(outgoing[1], m_flipping.other_diagonal(outgoing[1]));
      find_fan({outgoing.front(), outgoing.back()}, m_mesh, outgoing);
      flip_between(outgoing, 2, limit);
    }
    return !is_one_edge && m_flips.size() < limit &&
           std::all_of(outgoing.begin() + 1, outgoing.end() - 1, [&](Halfedge_index h) {
             return flip_status(h, m_mesh) == Operation_status::possible;
           });
  }

  // Undoes all flips.
  void rewind()
  {
    for(; !m_flips.empty(); m_flips.pop_back())
      m_flipping.undo(m_flips.back());
  }

private:
  // Flips edges, and keeps `margin` outgoing halfedges at both ends. Each flip removes one outgoing
  // halfedge. A flip adds one only if a face has two corners at the apex. Then the fan is collected
  // again.
  void flip_between(Fan& outgoing, std::size_t margin, std::size_t limit)
  {
    const Vertex_index apex = m_mesh.source(outgoing.front());
    const Fan_ends ends{outgoing.front(), outgoing.back()};
    for(std::size_t i = margin; i + margin < outgoing.size() && m_flips.size() < limit;) {
      const Halfedge_index h = outgoing[i];
      const auto diagonal = m_flipping.other_diagonal(h);
      if(!m_flipping.is_flippable(h, diagonal)) {
        ++i;
        continue;
      }
      const bool is_loop = m_mesh.target(h) == apex;
      flip(h, diagonal);
      if(is_loop || m_mesh.source(h) == apex || m_mesh.target(h) == apex) {
        find_fan(ends, m_mesh, outgoing);
        i = margin;
      } else {
        outgoing.erase(outgoing.begin() + static_cast<std::ptrdiff_t>(i));
        i = (std::max)(i - 1, margin);
      }
    }
  }

  void flip(Halfedge_index h, const typename Flipping::Diagonal& diagonal)
  {
    const auto record = m_flipping.record(h);
    m_flipping.flip(h, diagonal);
    m_flips.push_back(record);
  }

  const Delta_complex& m_mesh;
  Flipping m_flipping; // decisions are remembered
  std::vector<typename Flipping::Record> m_flips;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLATTENER_H
