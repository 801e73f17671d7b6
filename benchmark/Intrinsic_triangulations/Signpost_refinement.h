// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_SIGNPOST_REFINEMENT_H
#define INTRINSIC_BENCHMARK_SIGNPOST_REFINEMENT_H

#include "Traced_map.h"
#include "method.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <complex>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace Methods {

// Follows a refinement by signposts. Its flips, insertions and lengths are computed by the library.
// The position of a new vertex is found by walking over T1 from its nearest neighbor.
class Signpost_refinement : public IT::Default_refinement_visitor
{
  typedef IT::Intrinsic_triangulation<> Triangulation;

public:
  explicit Signpost_refinement(const Triangulation& tri) : m_tri(tri), m_frames(m_tri.input())
  {
    restart_from_input();
  }
  Signpost_refinement(const Signpost_refinement&) = delete;
  Signpost_refinement& operator=(const Signpost_refinement&) = delete;

  std::size_t refine()
  {
    return IT::refine(m_tri, IT::parameters::minimum_angle(25.).visitor(std::ref(*this)))
      .insertions;
  }

  Subdivision_size subdivide() const
  {
    const Delta_complex& mesh = m_tri.mesh();
    std::vector<Location> inserted;
    for(Vertex_index v : mesh.vertices())
      if(m_tri.is_inserted(v))
        inserted.push_back(m_place[v]);
    Traced_map map(m_tri.input_mesh(), mesh, inserted);
    for(Edge_index e : mesh.edges()) {
      Traced_curve curve{mesh.halfedge(e, 0), {}, {}};
      curve.end = trace(curve.halfedge, std::back_inserter(curve.crossings)).end.first;
      map.add(curve);
    }
    return map.subdivide();
  }

  // ---- The visitor ----

  void after_flip(Halfedge_index h)
  {
    update_angle(h);
    update_angle(m_tri.mesh().opposite(h));
  }

  template <typename Traits>
  void after_insertion(Vertex_index v, const IT::Vertex_inserter<Traits>&)
  {
    const Delta_complex& mesh = m_tri.mesh();
    Halfedge_index nearest = IT::first_outgoing_halfedge(v, mesh);
    IT::for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      update_angle(mesh.opposite(h));
      if(length(h) < length(nearest))
        nearest = h;
    });
    const auto walk = trace(mesh.opposite(nearest), CGAL::Emptyset_iterator());
    m_place[v] = walk.end;
    m_angle[nearest] = std::arg(-walk.direction);
    for(Halfedge_index h = IT::next_around_source(nearest, mesh); h != nearest;
        h = IT::next_around_source(h, mesh))
      update_angle(h);
  }

  void before_exact_flips() { restart_from_input(); }
  void before_exact_refinement() { restart_from_input(); }

private:
  double length(Halfedge_index h) const { return m_tri.length(m_tri.mesh().edge(h)); }

  // Restarts with T2 = T1.
  void restart_from_input()
  {
    m_angle = m_tri.add_property_map<Halfedge_index>("h:signpost", 0.);
    m_place = m_tri.add_property_map<Vertex_index>("v:signpost", Location());
    for(Halfedge_index h : m_tri.mesh().halfedges())
      m_angle[h] = m_frames.angle(h);
  }

  // Sets the direction of `h` to the direction of the previous outgoing halfedge, turned by the
  // angle between them.
  void update_angle(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index before = IT::previous_around_source(h, mesh);
    const Vertex_index v = mesh.source(h);
    m_angle[h] =
      m_angle[before] + IT::corner_angle<double>(length(mesh.next(before)), length(before),
                                                 length(mesh.prev(before))) *
                          (m_tri.is_inserted(v) ? 1 : m_frames.scale(v));
  }

  template <typename OutputIterator>
  IT::Geodesic<double> trace(Halfedge_index h, OutputIterator path) const
  {
    const Vertex_index v = m_tri.mesh().source(h);
    const std::complex<double> vector = std::polar(length(h), m_angle[h]);
    if(m_tri.is_inserted(v))
      return IT::trace_geodesic(m_tri.input(), m_place[v], vector, IT::At_boundary::stop, path);
    return IT::trace_geodesic(m_tri.input(), v, vector, IT::At_boundary::stop, path);
  }

  Triangulation m_tri;
  IT::Tangent_frames<double> m_frames;                         // of T1
  Delta_complex::Property_map<Halfedge_index, double> m_angle; // at vertices of T1 normalized
  Delta_complex::Property_map<Vertex_index, Location> m_place; // of inserted vertices
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_SIGNPOST_REFINEMENT_H
