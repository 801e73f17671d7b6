// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_DELAUNAY_MATCHING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_DELAUNAY_MATCHING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/coordinates_over.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename Traits>
constexpr bool can_have_inserted_vertices()
{
  return Has_distance<Traits>::value && std::is_floating_point_v<typename Traits::FT>;
}

// Inserts vertices into two triangulations over one T1, so that both have the same vertices. A
// vertex inserted into the first one, T2, is also inserted into T2 over itself. So one
// triangulation has the vertices of both over the original T2.
template <typename Traits>
class Common_vertices
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef Vertex_inserter<Traits> Inserter;

public:
  Common_vertices(const Triangulation& base, const Triangulation& tri)
    : m_base(unconstrained(base)), m_tri(unconstrained(tri)), m_over(over_itself(base))
  {
    CGAL_precondition(!base.mesh().has_garbage() && !tri.mesh().has_garbage());
    for(Vertex_index v : base.input_mesh().vertices())
      m_vertex.push_back(v);
    const Vertices missing_in_tri = missing(m_base, m_tri, true);
    const Vertices missing_in_base = missing(m_tri, m_base, false);
    insert_all(missing_in_tri, m_base, m_tri, nullptr);
    insert_all(missing_in_base, m_tri, m_base, &m_over);
    if(!has_same_faces(m_base.mesh(), m_over.mesh()))
      throw Numerical_error("by rounding, vertices cannot be inserted into both triangulations");
  }

  Triangulation& base() { return m_base; }
  const Triangulation& base() const { return m_base; }
  Triangulation& tri() { return m_tri; }
  const Triangulation& tri() const { return m_tri; }
  // Returns T2 with the vertices that only T3 has, over T2.
  Triangulation& over() { return m_over; }

  // Returns the vertex of base() that is the vertex `v` of tri().
  Vertex_index vertex(Vertex_index v) const { return m_vertex[v]; }

private:
  typedef std::tuple<std::size_t, std::size_t, FT, FT, FT> Key;
  typedef std::vector<Vertex_index> Vertices;

  static Triangulation unconstrained(Triangulation tri)
  {
    for(Edge_index e : tri.mesh().edges())
      tri.set_constrained(e, false);
    return tri;
  }

  static Triangulation over_itself(const Triangulation& tri)
  {
    return Triangulation(without_maps(tri.mesh()),
                         parameters::edge_length_map(tri.length_map()).geom_traits(tri.traits()));
  }

  // Returns a key that is equal for equal points, whichever side of an edge they have been inserted
  // from.
  static Key key(Vertex_index v, const Triangulation& tri)
  {
    const Surface_point<FT>& m = tri.inserted_vertex(v);
    if(on_edge(m)) {
      const Edge_index e(halfedge_of(m));
      return {1, e.idx(), tri.place_along(first_halfedge(e), v), FT(0), FT(0)};
    }
    const auto& [f, b] = std::get<Face_location<FT>>(m);
    return {0, f.idx(), b[0], b[1], b[2]};
  }

  static bool are_in_one_element(const Key& p, const Key& q)
  {
    return std::get<0>(p) == std::get<0>(q) && std::get<1>(p) == std::get<1>(q);
  }

  typedef std::vector<std::pair<Key, Vertex_index>> Keys;

  static Keys keys_of_inserted(const Triangulation& tri)
  {
    Keys result;
    for(Vertex_index v : tri.mesh().vertices())
      if(tri.is_inserted(v))
        result.emplace_back(key(v, tri), v);
    std::sort(result.begin(), result.end());
    return result;
  }

  // Returns the vertex at `p` up to rounding, or null if none is near.
  static Vertex_index vertex_at(const Key& p, const Keys& keys)
  {
    const FT tolerance = region_tolerance<FT>();
    const auto is_near = [&](const FT& x, const FT& y) { return CGAL::abs(x - y) <= tolerance; };
    const auto& [kind, element, x, y, z] = p;
    const std::pair least(Key(kind, element, x - tolerance, FT(-1), FT(-1)), Vertex_index(0));
    for(auto q = std::lower_bound(keys.begin(), keys.end(), least);
        q != keys.end() && are_in_one_element(p, q->first) &&
        is_near(std::get<2>(q->first), std::get<2>(p));
        ++q)
      if(is_near(std::get<3>(q->first), std::get<3>(p)) &&
         is_near(std::get<4>(q->first), std::get<4>(p)))
        return q->second;
    return Vertex_index();
  }

  // Returns the vertices that have been inserted into `from` and not into `to`. Records the
  // vertices of both.
  Vertices missing(const Triangulation& from, const Triangulation& to, bool from_base)
  {
    const Keys there = keys_of_inserted(to);
    Vertices result;
    for(const auto& [p, v] : keys_of_inserted(from))
      if(const Vertex_index w = vertex_at(p, there); w.is_valid())
        note(v, w, !from_base);
      else
        result.push_back(v);
    return result;
  }

  // Inserts at most one vertex per face in every round, because all keys are computed at once.
  void insert_all(Vertices vertices, const Triangulation& from, Triangulation& to,
                  Triangulation* follower)
  {
    while(!vertices.empty()) {
      std::vector<std::pair<Vertex_index, Face_location<FT>>> located;
      const Correspondence<Traits> correspondence(to);
      for(Vertex_index v : vertices)
        located.emplace_back(
          v, point_across(correspondence, Side::input,
                          face_location(from.inserted_vertex(v), from.input_mesh())));
      vertices = insert_round(located, from, to, follower);
    }
  }

  template <typename Located>
  Vertices insert_round(const Located& located, const Triangulation& from, Triangulation& to,
                        Triangulation* follower)
  {
    Vertices rest;
    std::vector<bool> is_touched(to.mesh().num_faces(), false);
    Inserter inserter(to);
    std::optional<Inserter> following;
    if(follower != nullptr)
      following.emplace(*follower);
    for(const auto& [v, p] : located) {
      const auto faces = faces_around(p, to.mesh());
      if(std::any_of(faces.begin(), faces.end(),
                     [&](Face_index f) { return f.idx() >= is_touched.size() || is_touched[f]; })) {
        rest.push_back(v);
        continue;
      }
      for(Face_index f : faces)
        is_touched[f] = true;
      if(following)
        following->insert(p);
      note(v, insert(v, p, from, inserter), follower != nullptr);
    }
    return rest;
  }

  static std::vector<Face_index> faces_around(const Face_location<FT>& p, const Delta_complex& mesh)
  {
    std::vector<Face_index> result;
    for_each_location(surface_point(p, mesh), mesh,
                      [&](const Face_location<FT>& q) { result.push_back(q.first); });
    return result;
  }

  static Vertex_index insert(Vertex_index v, const Face_location<FT>& p, const Triangulation& from,
                             Inserter& inserter)
  {
    const Triangulation& to = inserter.triangulation();
    const auto before = to.mesh().number_of_vertices();
    const bool is_on_edge = on_edge(from.inserted_vertex(v)) != nullptr;
    FT closeness(0);
    for(Halfedge_index h : sides(p.first, to.mesh()))
      closeness = (std::max)(closeness, FT(is_on_edge ? inserted_edge_tolerance() : 0) *
                                          to.length(Edge_index(h)));
    const Vertex_index result = inserter.insert(p, closeness);
    if(to.mesh().number_of_vertices() == before ||
       !are_in_one_element(key(result, to), key(v, from)))
      throw Numerical_error("rounding has moved inserted vertex " + std::to_string(v.idx()) +
                            " to another element of the other triangulation");
    return result;
  }

  void note(Vertex_index v, Vertex_index inserted, bool into_base)
  {
    const Vertex_index in_base = into_base ? inserted : v, in_tri = into_base ? v : inserted;
    if(m_vertex.size() <= in_tri.idx())
      m_vertex.resize(in_tri.idx() + 1);
    m_vertex[in_tri] = in_base;
  }

  Triangulation m_base, m_tri, m_over;
  std::vector<Vertex_index> m_vertex;
};

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
// Omits constrained edges that are not in the input, because their parts are unknown.
template <typename Traits>
std::vector<Halfedge_index> on_constrained_edges(const Intrinsic_triangulation<Traits>& whole,
                                                 const Intrinsic_triangulation<Traits>& tri)
{
  std::vector<bool> is_constrained(tri.input_mesh().num_edges(), false);
  for(Edge_index e : tri.mesh().edges())
    if(tri.is_constrained(e) && tri.coordinates().is_shared(e))
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
