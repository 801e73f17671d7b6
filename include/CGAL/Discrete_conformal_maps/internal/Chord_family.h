// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CHORD_FAMILY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CHORD_FAMILY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/Face_map.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Halfedge_index;

// A curve through a face, from a mark to a mark or corner.
struct Chord
{
  struct Crossing
  {
    const Chord* chord;
    std::size_t node;
  };

  bool is_of_a;
  std::size_t begin, end;                   // nodes of the boundary
  std::size_t left, right;                  // regions of its family
  std::vector<std::size_t> nodes;           // from begin to end
  std::vector<Crossing> crossings;          // with chords of the other family
  std::array<std::vector<char>, 2> is_done; // whether polygons on the left and right are known
  std::array<std::size_t, 2> fan_place;     // among all chords at begin and end

  std::size_t other_end(std::size_t node) const { return node == begin ? end : begin; }
};

// A point of a face where edges of the face or chords meet.
template <typename FT>
struct Overlay_node
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t vertex;                   // its number in the subdivision
  std::size_t side = none;              // on which it lies, or the corner; none inside the face
  std::size_t marks_a = 0, marks_c = 0; // up to it on the side, itself among them
  FT t = FT(0);                         // its place on the side
  bool is_of_a = false;                 // if it is a mark
  bool is_corner = false;
  Chord *a = nullptr, *c = nullptr; // inside the face
  std::size_t number_on_a = 0, number_on_c = 0;
  FT along_a = FT(0), along_c = FT(0); // its places on them, from 0 to 1
  bool c_goes_left = false;            // of a

  static Overlay_node corner(std::size_t vertex, std::size_t side)
  {
    Overlay_node node{vertex};
    node.side = side;
    node.is_corner = true;
    return node;
  }

  static Overlay_node mark(std::size_t vertex, std::size_t side, std::size_t marks_a,
                           std::size_t marks_c, const FT& t, bool is_of_a)
  {
    Overlay_node node{vertex, side, marks_a, marks_c, t, is_of_a};
    return node;
  }

  static Overlay_node crossing(std::size_t vertex, Chord* a, std::size_t number_on_a, Chord* c,
                               bool c_goes_left)
  {
    Overlay_node node{vertex};
    node.a = a;
    node.number_on_a = number_on_a;
    node.c = c;
    node.c_goes_left = c_goes_left;
    return node;
  }

  // in the face; of a node on its boundary
  std::array<FT, 3> coordinates() const
  {
    return Intrinsic_triangulations::internal::barycentric_coordinates(side, t);
  }
};

// The number of steps counterclockwise from one node of the boundary to another.
inline std::size_t steps_ahead(std::size_t from, std::size_t to, std::size_t size)
{
  return to >= from ? to - from : to + size - from;
}

// The curves of one triangulation through a face of another, as chords, and the regions between them.
template <typename Traits, bool is_a>
class Chord_family
{
  typedef Intrinsic_triangulations::Correspondence<Traits> Correspondence;
  typedef Intrinsic_triangulations::internal::Correspondence_marks<Traits> Marks;
  typedef Intrinsic_triangulations::internal::Region Region;
  typedef Intrinsic_triangulations::internal::Region_corner Region_corner;
  typedef typename Traits::FT FT;
  typedef Intrinsic_triangulations::internal::Face_map<FT, Marks> Face_map;
  typedef Intrinsic_triangulations::Side Side;
  typedef std::array<FT, 3> Coordinates;
  typedef Overlay_node<FT> Node;

public:
  // a region with the images of its corners in a face of the other triangulation
  struct Region_image
  {
    Face_index face;
    Region region;
    std::array<Coordinates, 6> image;
  };

  Chord_family(Side side, const Correspondence& correspondence)
    : m_side(side),
      m_correspondence(correspondence),
      m_other(correspondence.mesh(side == Side::input ? Side::intrinsic : Side::input))
  {}

  void set_face(Face_index f)
  {
    m_halfedge = Intrinsic_triangulations::internal::sides(f, m_correspondence.mesh(m_side));
    m_marks.emplace(m_side, f, m_correspondence);
    m_map.emplace(*m_marks, m_other);
    m_image.assign(m_map->regions().size(), std::nullopt);
  }

  // ---- Marks ----

  std::size_t marks(std::size_t s) const { return m_marks->crossings(s); }
  FT place(std::size_t s, std::size_t i) const { return m_marks->here(s, i); }
  std::size_t id(std::size_t s, std::size_t i) const
  {
    return m_correspondence
      .crossing(m_side, m_halfedge[s], static_cast<Delta_complex::size_type>(i))
      .id;
  }

  // along the first halfedge of the edge
  FT place_on_edge(std::size_t s, std::size_t i) const
  {
    const auto c = m_correspondence.crossing(static_cast<Delta_complex::size_type>(id(s, i)));
    return m_side == Side::input ? c.on_input.t : c.on_intrinsic.t;
  }

  // ---- Chords ----

  std::vector<Chord>& chords() { return m_chords; }

  void make_chords(const std::vector<Node>& nodes)
  {
    note_marks(nodes);
    m_boundary_size = nodes.size();
    m_chords.clear();
    const auto& regions = m_map->regions();
    for(std::size_t s = 0; s < 3; ++s)
      for(std::size_t j = 0; j < regions.around(s); ++j) {
        const auto curve = regions.curve_around(s, j);
        add_chord(curve[0], node_of_mark(curve[1]));
      }
    for(std::size_t j = 0; j < regions.leaving(); ++j)
      add_chord(regions.end_of_curve(j), m_corner[regions.apex()]);
  }

  // Calls `visit(chord)` for the chords that cross one of the other family, in order along it.
  template <typename Visit>
  void for_each_crossing(const Chord& other, const std::vector<Node>& nodes, const Visit& visit)
  {
    std::size_t region = region_after(nodes[other.begin]);
    for(Chord *last = nullptr, *chord; (chord = way_out(region, other, last)); last = chord) {
      visit(*chord);
      region = chord->left == region ? chord->right : chord->left;
    }
  }

  // ---- Regions ----

  // at the piece of the boundary after a node of it
  std::size_t region_after(const Node& node) const
  {
    return m_map->regions().region_at_side(node.side, own_marks(node));
  }

  const Region_image& region(std::size_t number)
  {
    if(!m_image[number]) {
      const auto [face, map] = m_map->region_map(number);
      Region_image result{face, m_map->regions()[number], {}};
      for(std::size_t c = 0; c < map.size(); ++c)
        result.image[c] = map.image(c);
      m_image[number] = result;
    }
    return *m_image[number];
  }

  // The coordinates of a node on the boundary of a region. The map of a region is linear.
  Coordinates image(const Node& node, const Region_image& in, const std::vector<Node>& nodes) const
  {
    if(const Chord* chord = is_a ? node.a : node.c)
      return between(in.image[corner_at(nodes[chord->begin], in)],
                     in.image[corner_at(nodes[chord->end], in)],
                     is_a ? node.along_a : node.along_c);
    const std::size_t c = corner_at(node, in);
    if(node.is_corner || node.is_of_a == is_a)
      return in.image[c];
    const std::size_t d = c + 1 == in.region.size() ? 0 : c + 1;
    const FT from = place(in.region[c]),
             to = in.region[d].is_vertex() ? FT(1) : place(in.region[d]);
    const FT t = to > from ? (node.t - from) / (to - from) : FT(0);
    return between(in.image[c], in.image[d], t);
  }

private:
  std::size_t own_marks(const Node& node) const { return is_a ? node.marks_a : node.marks_c; }

  void note_marks(const std::vector<Node>& nodes)
  {
    for(auto& side : m_node_of_mark)
      side.clear();
    for(std::size_t k = 0; k < nodes.size(); ++k)
      if(nodes[k].is_corner)
        m_corner[nodes[k].side] = k;
      else if(nodes[k].is_of_a == is_a)
        m_node_of_mark[nodes[k].side].push_back(k);
  }

  std::size_t node_of_mark(const Region_corner& mark) const
  {
    return m_node_of_mark[mark.side][mark.mark];
  }

  void add_chord(const Region_corner& begin, std::size_t end)
  {
    const auto& regions = m_map->regions();
    m_chords.push_back({is_a,
                        node_of_mark(begin),
                        end,
                        regions.region_at_side(begin.side, begin.mark),
                        regions.region_at_side(begin.side, begin.mark + 1),
                        {},
                        {},
                        {},
                        {}});
  }

  // the chord between two corners of a region
  Chord& chord(const Region_corner& from, const Region_corner& to)
  {
    const auto& regions = m_map->regions();
    const auto curve = regions.curve(from, to);
    std::size_t first = 0;
    for(std::size_t s = 0; s < (curve.from_apex ? 3 : curve.corner); ++s)
      first += regions.around(s);
    return m_chords[first + curve.number];
  }

  // the chord on the boundary of a region that `other` crosses, but not `last`
  Chord* way_out(std::size_t number, const Chord& other, const Chord* last)
  {
    const Region region = m_map->regions()[number];
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows) {
        Chord& way = chord(region[c], region.next(c));
        if(&way != last && are_interlaced(way, other))
          return &way;
      }
    return nullptr;
  }

  bool are_interlaced(const Chord& x, const Chord& y) const
  {
    const auto ahead = [&](std::size_t to) { return steps_ahead(x.begin, to, m_boundary_size); };
    const std::size_t p = ahead(y.begin), q = ahead(y.end), end = ahead(x.end);
    return p != 0 && q != 0 && p != end && q != end && (p < end) != (q < end);
  }

  // the corner of the region that is the node, or its own mark or corner of the face before it
  std::size_t corner_at(const Node& node, const Region_image& in) const
  {
    const std::size_t marks = own_marks(node);
    const std::size_t mark = marks == 0 ? Region_corner::none : marks - 1;
    std::size_t c = 0;
    while(in.region[c].side != node.side || in.region[c].mark != mark)
      ++c;
    return c;
  }

  FT place(const Region_corner& corner) const
  {
    return corner.is_vertex() ? FT(0) : place(corner.side, corner.mark);
  }

  static Coordinates between(const Coordinates& p, const Coordinates& q, const FT& t)
  {
    Coordinates result;
    for(std::size_t s = 0; s < 3; ++s)
      result[s] = (1 - t) * p[s] + t * q[s];
    return result;
  }

  Side m_side;
  const Correspondence& m_correspondence;
  const Delta_complex& m_other;
  std::array<Halfedge_index, 3> m_halfedge;
  std::optional<Marks> m_marks;
  std::optional<Face_map> m_map;
  std::vector<std::optional<Region_image>> m_image;
  std::array<std::size_t, 3> m_corner{};
  std::array<std::vector<std::size_t>, 3> m_node_of_mark;
  std::size_t m_boundary_size = 0;
  std::vector<Chord> m_chords;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CHORD_FAMILY_H
