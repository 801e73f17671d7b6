// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FACE_OVERLAY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FACE_OVERLAY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/Chord_family.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

template <typename FT>
struct Overlay_corner
{
  std::size_t vertex;
  std::array<FT, 3> on_a, on_c; // coordinates in the parent faces
};

struct Overlay_face
{
  Face_index a, b, c; // the parents
  std::size_t first_corner, end_of_corners;
};

// The polygons into which the edges of T^A and T^C cut a face of T^B. The boundary of the face is a cycle of
// nodes, its corners and the marks of both families; chords of one family do not cross, those of
// different families cross once if their ends are interlaced.
template <typename Traits_AB, typename Traits_BC>
class Face_overlay
{
public:
  typedef typename Traits_AB::FT FT;
  typedef std::array<FT, 3> Coordinates;

  Face_overlay(const Intrinsic_triangulations::Correspondence<Traits_AB>& ab,
               const Intrinsic_triangulations::Correspondence<Traits_BC>& bc,
               std::vector<Overlay_face>& faces, std::vector<Overlay_corner<FT>>& corners)
    : m_mesh(ab.mesh(Intrinsic_triangulations::Side::intrinsic)),
      m_a(Intrinsic_triangulations::Side::intrinsic, ab),
      m_c(Intrinsic_triangulations::Side::input, bc),
      m_first_a(m_mesh.num_vertices()),
      m_first_c(m_first_a + ab.number_of_crossings()),
      m_number_of_vertices(m_first_c + bc.number_of_crossings()),
      m_faces(faces),
      m_corners(corners)
  {}

  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  // adds the polygons of the face `f`
  void add(Face_index f)
  {
    m_face = f;
    m_a.set_face(f);
    m_c.set_face(f);
    make_boundary();
    m_a.make_chords(m_nodes);
    m_c.make_chords(m_nodes);
    cross_chords();
    make_fans();
    trace_polygons();
  }

private:
  typedef internal::Overlay_node<FT> Node;
  typedef internal::Chord Chord;

  // a step along the boundary from node `place`, or along a chord from its node number `place`
  struct Step
  {
    Chord* chord;
    std::size_t place;
    bool is_forward;
  };

  // ---- Nodes ----

  void make_boundary()
  {
    m_nodes.clear();
    const auto side = Intrinsic_triangulations::internal::sides(m_face, m_mesh);
    for(std::size_t s = 0; s < 3; ++s) {
      m_nodes.push_back(Node::corner(m_mesh.source(side[s]).idx(), s));
      const std::size_t n = m_a.marks(s), m = m_c.marks(s);
      for(std::size_t i = 0, j = 0; i < n || j < m;) {
        const bool takes_a = j == m || (i < n && is_first(side[s], s, i, j));
        m_nodes.push_back(
          takes_a ? Node::mark(m_first_a + m_a.id(s, i), s, i + 1, j, m_a.place(s, i), true)
                  : Node::mark(m_first_c + m_c.id(s, j), s, i, j + 1, m_c.place(s, j), false));
        takes_a ? ++i : ++j;
      }
    }
    m_boundary_size = m_nodes.size();
  }

  // Whether mark `i` of T^A on side `s` comes before mark `j` of T^C. At equal places, the first is that of T^A
  // along the first halfedge of the edge, so that both faces agree.
  bool is_first(Halfedge_index h, std::size_t s, std::size_t i, std::size_t j) const
  {
    const FT a = m_a.place_on_edge(s, i), c = m_c.place_on_edge(s, j);
    const bool is_even = h.idx() % 2 == 0;
    return is_even ? a <= c : a > c;
  }

  // ---- Crossings ----

  void cross_chords()
  {
    for(Chord& a : m_a.chords()) {
      a.nodes.assign(1, a.begin);
      m_c.for_each_crossing(a, m_nodes, [&](Chord& c) {
        c.crossings.push_back({&a, m_nodes.size()});
        a.nodes.push_back(m_nodes.size());
        m_nodes.push_back(Node::crossing(m_number_of_vertices++, &a, a.nodes.size() - 1, &c,
                                         is_between(c.begin, a.begin, a.end)));
      });
      a.nodes.push_back(a.end);
      place_along(a, &Node::along_a);
    }
    for(Chord& c : m_c.chords())
      order_crossings(c);
  }

  // whether node `i` lies between `from` and `to`, counterclockwise
  bool is_between(std::size_t i, std::size_t from, std::size_t to) const
  {
    return ahead(from, i) < ahead(from, to) && i != from;
  }

  // the number of boundary nodes from one to another
  std::size_t ahead(std::size_t from, std::size_t to) const
  {
    return steps_ahead(from, to, m_boundary_size);
  }

  // Chords of T^A that cross `c` are met in the order of their ends on the right of `c`, and of the other ends
  // where these are the same.
  void order_crossings(Chord& c)
  {
    const auto key = [&](const Chord::Crossing& x) {
      const std::size_t p = ahead(c.begin, x.chord->begin), q = ahead(c.begin, x.chord->end);
      return std::make_pair((std::min)(p, q), m_boundary_size - (std::max)(p, q));
    };
    std::sort(c.crossings.begin(), c.crossings.end(),
              [&](const Chord::Crossing& x, const Chord::Crossing& y) { return key(x) < key(y); });
    c.nodes.assign(1, c.begin);
    for(const Chord::Crossing& x : c.crossings) {
      m_nodes[x.node].number_on_c = c.nodes.size();
      c.nodes.push_back(x.node);
    }
    c.nodes.push_back(c.end);
    place_along(c, &Node::along_c);
  }

  Coordinates coordinates(std::size_t node) const { return m_nodes[node].coordinates(); }

  // The places of the crossings on a chord, from 0 to 1. Rounding may move one, but never past another.
  void place_along(const Chord& chord, FT Node::*along)
  {
    FT least(0);
    for(std::size_t k = 1; k + 1 < chord.nodes.size(); ++k) {
      Node& node = m_nodes[chord.nodes[k]];
      const Chord& other = node.a == &chord ? *node.c : *node.a;
      const Coordinates p = coordinates(other.begin), q = coordinates(other.end);
      const FT from =
        CGAL::abs(Intrinsic_triangulations::internal::orientation(p, q, coordinates(chord.begin)));
      const FT to =
        CGAL::abs(Intrinsic_triangulations::internal::orientation(p, q, coordinates(chord.end)));
      const FT t = from + to > 0 ? from / (from + to) : FT(0);
      node.*along = least = (std::max)(least, t);
    }
  }

  // ---- Polygons ----

  // the chords that end at each node of the boundary, in the order of their other ends
  void make_fans()
  {
    m_fans.resize((std::max)(m_fans.size(), m_boundary_size));
    for(std::size_t k = 0; k < m_boundary_size; ++k)
      m_fans[k].clear();
    for(auto* chords : {&m_a.chords(), &m_c.chords()})
      for(Chord& chord : *chords) {
        m_fans[chord.begin].push_back(&chord);
        m_fans[chord.end].push_back(&chord);
        chord.is_done[0].assign(chord.nodes.size() - 1, 0);
        chord.is_done[1].assign(chord.nodes.size() - 1, 0);
      }
    for(std::size_t k = 0; k < m_boundary_size; ++k)
      std::sort(m_fans[k].begin(), m_fans[k].end(), [&](const Chord* x, const Chord* y) {
        return ahead(k, x->other_end(k)) < ahead(k, y->other_end(k));
      });
    for(std::size_t k = 0; k < m_boundary_size; ++k)
      for(std::size_t i = 0; i < m_fans[k].size(); ++i)
        m_fans[k][i]->fan_place[m_fans[k][i]->begin == k ? 0 : 1] = i;
  }

  void trace_polygons()
  {
    m_is_done.assign(m_boundary_size, 0);
    for(std::size_t k = 0; k < m_boundary_size; ++k)
      trace({nullptr, k, true});
    for(auto* chords : {&m_a.chords(), &m_c.chords()})
      for(Chord& chord : *chords)
        for(std::size_t k = 0; k + 1 < chord.nodes.size(); ++k)
          for(bool is_forward : {true, false})
            trace({&chord, is_forward ? k : k + 1, is_forward});
  }

  char& is_done(const Step& s)
  {
    return !s.chord       ? m_is_done[s.place]
           : s.is_forward ? s.chord->is_done[0][s.place]
                          : s.chord->is_done[1][s.place - 1];
  }

  std::size_t source(const Step& s) const { return s.chord ? s.chord->nodes[s.place] : s.place; }

  std::size_t target(const Step& s) const
  {
    if(!s.chord)
      return s.place + 1 == m_boundary_size ? 0 : s.place + 1;
    return s.chord->nodes[s.is_forward ? s.place + 1 : s.place - 1];
  }

  // the polygon on the left of a step
  void trace(const Step& start)
  {
    if(is_done(start))
      return;
    m_polygon.clear();
    std::size_t region_a = no_region, region_c = no_region;
    for(Step s = start; !is_done(s); s = next(s)) {
      is_done(s) = 1;
      m_polygon.push_back(source(s));
      note_regions(s, region_a, region_c);
    }
    const auto& in_a = m_a.region(region_a);
    const auto& in_c = m_c.region(region_c);
    m_faces.push_back(
      {in_a.face, m_face, in_c.face, m_corners.size(), m_corners.size() + m_polygon.size()});
    for(std::size_t node : m_polygon)
      m_corners.push_back({m_nodes[node].vertex, m_a.image(m_nodes[node], in_a, m_nodes),
                           m_c.image(m_nodes[node], in_c, m_nodes)});
  }

  static constexpr std::size_t no_region = static_cast<std::size_t>(-1);

  void note_regions(const Step& s, std::size_t& region_a, std::size_t& region_c) const
  {
    if(!s.chord) {
      const Node& node = m_nodes[s.place];
      region_a = m_a.region_after(node);
      region_c = m_c.region_after(node);
    } else
      (s.chord->is_of_a ? region_a : region_c) = s.is_forward ? s.chord->left : s.chord->right;
  }

  // turns as far to the left as possible
  Step next(const Step& s) const
  {
    const std::size_t node = target(s);
    if(node >= m_boundary_size)
      return turn(s, m_nodes[node]);
    const auto& fan = m_fans[node];
    const std::size_t place = s.chord ? s.chord->fan_place[s.is_forward ? 1 : 0] : fan.size();
    if(place == 0)
      return {nullptr, node, true};
    Chord* chord = fan[place - 1];
    const bool is_forward = chord->begin == node;
    return {chord, is_forward ? 0 : chord->nodes.size() - 1, is_forward};
  }

  // from one chord to the other that crosses it
  static Step turn(const Step& s, const Node& node)
  {
    if(s.chord->is_of_a)
      return {node.c, node.number_on_c, s.is_forward == node.c_goes_left};
    return {node.a, node.number_on_a, s.is_forward != node.c_goes_left};
  }

  const Delta_complex& m_mesh;
  Chord_family<Traits_AB, true> m_a;
  Chord_family<Traits_BC, false> m_c;
  std::size_t m_first_a, m_first_c, m_number_of_vertices;
  std::vector<Overlay_face>& m_faces;
  std::vector<Overlay_corner<FT>>& m_corners;

  Face_index m_face;
  std::vector<Node> m_nodes; // of the boundary first
  std::size_t m_boundary_size = 0;
  std::vector<std::vector<Chord*>> m_fans;
  std::vector<char> m_is_done;
  std::vector<std::size_t> m_polygon;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FACE_OVERLAY_H
