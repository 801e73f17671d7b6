// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_DELAUNAY_MATCHING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_DELAUNAY_MATCHING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Common_vertices.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Records flips that make a triangulation Delaunay, and the resulting connectivity.
template <typename Traits>
class Recorded_flips
{
public:
  explicit Recorded_flips(Intrinsic_triangulation<Traits>& tri)
  {
    Recorder recorder{{}, flips};
    Intrinsic_triangulations::make_Delaunay(tri, parameters::visitor(std::ref(recorder)));
    mesh = without_maps(tri.mesh());
  }

  void flip(Halfedge_index h)
  {
    if(flip_status(h, mesh) != Operation_status::possible || more_flips++ > mesh.num_edges())
      throw Numerical_error("both Delaunay triangulations differ by more than ties");
    flip_edge(h, mesh);
    flips.push_back(h);
  }

  std::vector<Halfedge_index> flips;
  Delta_complex mesh;

private:
  struct Recorder : Default_flip_visitor
  {
    Recorder(const Default_flip_visitor& base, std::vector<Halfedge_index>& flips)
      : Default_flip_visitor(base), flips(flips)
    {}
    void after_flip(Halfedge_index h) { flips.push_back(h); }
    std::vector<Halfedge_index>& flips;
  };

  std::size_t more_flips = 0;
};

// Computes the flips from T3 to T2, two triangulations over T1 with the same vertices, over the
// Delaunay triangulation of these vertices. Its edges are straight. So two edges are equal if they
// start in the same corner of T1, cross the same edges, and end at the same vertex. Because of
// ties, an edge may be in only one of both triangulations. Such edges lie in polygons without
// vertices inside, which are flipped to fans.
template <typename Traits>
class Delaunay_matching
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  explicit Delaunay_matching(Common_vertices<Traits>& common)
    : m_common(common), m_base(common.base()), m_tri(common.tri())
  {
    m_image.resize(m_tri.mesh.num_halfedges());
    m_preimage.resize(m_base.mesh.num_halfedges());
    match_edges();
    for(Halfedge_index h : m_tri.mesh.halfedges())
      if(is_open(h))
        match_fan(h);
    check();
  }

  // Returns the halfedge of T2 that replaces the halfedge `h` of T3.
  Halfedge_index image(Halfedge_index h) const { return m_image[h]; }

  // Calls `flip(h)` for the halfedges of T2 that are flipped to reach T3.
  template <typename Flip>
  void flip_to_tri(const Flip& flip) const
  {
    for(Halfedge_index h : m_base.flips)
      flip(h);
    for(auto h = m_tri.flips.rbegin(); h != m_tri.flips.rend(); ++h)
      for(int turn = 0; turn < 3; ++turn) // four flips restore the edge
        flip(m_image[*h]);
  }

private:
  typedef std::vector<std::size_t> Key;

  template <typename Number>
  static Key key(Halfedge_index h, const Triangulation& tri,
                 const Edge_courses<typename Triangulation::Traits>& courses, const Number& number)
  {
    const Delta_complex& mesh = tri.mesh();
    const auto end = [&](Halfedge_index x) {
      const Halfedge_index outgoing = tri.input_outgoing_before(x);
      return std::pair(number(mesh.source(x)).idx(), outgoing.is_valid() ? outgoing.idx() + 1 : 0);
    };
    const auto [source, source_outgoing] = end(h);
    const auto [target, target_outgoing] = end(mesh.opposite(h));
    Key result{source, source_outgoing, target, target_outgoing};
    const Edge_course course = courses(h);
    for(std::size_t m = 0; m < course.size(); ++m)
      result.push_back(course[m].idx());
    return result;
  }

  void match_edges()
  {
    const Triangulation &base = m_common.base(), &tri = m_common.tri();
    const Edge_courses<typename Triangulation::Traits> on_base(base, Concurrency()),
      on_tri(tri, Concurrency());
    std::map<Key, Halfedge_index> there;
    for(Halfedge_index h : base.mesh().halfedges())
      there.emplace(key(h, base, on_base, [](Vertex_index v) { return v; }), h);
    for(Halfedge_index h : tri.mesh().halfedges()) {
      const auto found =
        there.find(key(h, tri, on_tri, [&](Vertex_index v) { return m_common.vertex(v); }));
      if(found != there.end())
        match(h, found->second);
    }
  }

  void match(Halfedge_index h, Halfedge_index image)
  {
    m_image[h] = image;
    m_image[opposite(h)] = opposite(image);
    m_preimage[image] = h;
    m_preimage[opposite(image)] = opposite(h);
  }

  // Returns whether `h` is a side of a polygon that is still to be matched.
  bool is_open(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_tri.mesh;
    return m_image[h].is_valid() && !mesh.is_border(h) &&
           !(m_image[mesh.next(h)].is_valid() && m_image[mesh.prev(h)].is_valid());
  }

  // Turns the polygon into a fan around the source of its side `h`.
  void match_fan(Halfedge_index h)
  {
    const Delta_complex &mesh = m_tri.mesh, &other = m_base.mesh;
    for(Halfedge_index image = m_image[h];;) {
      while(!m_image[mesh.next(h)].is_valid())
        m_tri.flip(mesh.next(h));
      while(!m_preimage[other.next(image)].is_valid())
        m_base.flip(other.next(image));
      const Halfedge_index last = mesh.prev(h), last_image = other.prev(image);
      if(m_image[last].is_valid() || m_preimage[last_image].is_valid())
        return;
      match(last, last_image);
      h = mesh.opposite(last);
      image = other.opposite(last_image);
    }
  }

  void check() const
  {
    for(Halfedge_index h : m_tri.mesh.halfedges())
      if(!m_image[h].is_valid() || m_base.mesh.next(m_image[h]) != m_image[m_tri.mesh.next(h)])
        throw Numerical_error("both Delaunay triangulations differ by more than ties");
  }

  const Common_vertices<Traits>& m_common;
  Recorded_flips<Traits> m_base, m_tri;
  std::vector<Halfedge_index> m_image, m_preimage;
};

// Returns the halfedges of `whole` on constrained edges of `tri`. They are parts of these edges.
template <typename Traits>
std::vector<Halfedge_index> on_constrained_edges(const Intrinsic_triangulation<Traits>& whole,
                                                 const Intrinsic_triangulation<Traits>& tri)
{
  std::vector<bool> is_constrained(tri.input_mesh().num_edges(), false);
  for(Edge_index e : tri.mesh().edges())
    if(tri.is_constrained(e))
      is_constrained[Edge_index(tri.input_outgoing_before(first_halfedge(e)))] = true;
  std::vector<Halfedge_index> result;
  for(Edge_index e : whole.mesh().edges())
    if(whole.coordinates().is_shared(e) &&
       is_constrained[Edge_index(whole.input_outgoing_before(first_halfedge(e)))])
      result.push_back(first_halfedge(e));
  return result;
}

// Returns T3, the second triangulation of `tri`, with all vertices of T2, the second triangulation
// of `base`. The result lies over T2.
template <typename Traits>
Intrinsic_triangulation<Traits> inserted_over(const Intrinsic_triangulation<Traits>& base,
                                              const Intrinsic_triangulation<Traits>& tri)
{
  Common_vertices<Traits> common(base, tri);
  const std::vector<Halfedge_index> constrained = on_constrained_edges(common.tri(), tri);
  const Delaunay_matching<Traits> matching(common);
  Intrinsic_triangulation<Traits> result(std::move(common.over()));
  matching.flip_to_tri([&](Halfedge_index h) { result.flip(h); });
  result.recompute_lengths();
  for(Halfedge_index h : constrained)
    if(const Edge_index e(matching.image(h)); result.coordinates().is_shared(e))
      result.set_constrained(e, true);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_DELAUNAY_MATCHING_H
