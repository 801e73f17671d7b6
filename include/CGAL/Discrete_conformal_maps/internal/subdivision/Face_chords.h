// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_FACE_CHORDS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_FACE_CHORDS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/subdivision/Chord_crossings.h>
#include <CGAL/Discrete_conformal_maps/internal/subdivision/Marked_edges.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents the part of an edge of A or C in a face of B, from its first end to its last.
template <typename FT>
struct Chord
{
  std::size_t family;
  Halfedge_index along;                    // the halfedge of A or C in this direction
  std::array<Vertex_index, 2> vertex;      // at the two ends
  std::array<std::array<FT, 2>, 2> weight; // of the source and target of `along`
  std::array<std::array<FT, 3>, 2> place;  // in the face of B
};

// Represents an end of a chord: mark `mark` of side `side`, or the corner at which that side
// starts.
struct Chord_end
{
  std::size_t chord, side, mark;
  bool is_first;
};

// Computes all chords in a face of B, and their crossings. An object is used for many faces, one
// after the other.
template <typename FT>
class Face_chords
{
  typedef Delta_complex::size_type size_type;
  typedef Intrinsic_triangulations::internal::Face_regions Face_regions;

public:
  explicit Face_chords(const Marked_edges<FT>& edges) : m_edges(edges) {}

  // Computes the chords of a face. Complexity: linear in the marks and crossings.
  void set_face(Face_index f)
  {
    const std::array<std::size_t, 2> n = order_ends(f);
    set_chords(n);
    intersect();
  }

  // Determines the chords of each family, and which of them cross. Returns the numbers of chords.
  std::array<std::size_t, 2> order_ends(Face_index f)
  {
    m_side = Intrinsic_triangulations::sides(f, m_edges.mesh());
    m_ends.clear();
    m_chord_at_end.clear();
    const std::array<std::size_t, 2> n = number_chords();
    for(std::size_t s = 0; s < 3; ++s) {
      m_first_at_corner[s] = m_ends.size();
      add_ends_at_corner(s);
      m_first_on_side[s] = m_ends.size();
      for(std::size_t p = 0; p < m_marks[s].size(); ++p)
        add_end(m_chord[s][p], s, p);
    }
    m_crossings.compute(n, m_chord_at_end);
    m_chords.resize(n[0] + n[1]);
    return n;
  }

  const std::array<Halfedge_index, 3>& sides() const { return m_side; }
  const std::vector<Mark<FT>>& marks(std::size_t s) const { return m_marks[s]; }

  // Returns the number of ends at corner `s`. They are ordered counterclockwise along the boundary,
  // from the side before the corner to the side after it.
  std::size_t number_at_corner(std::size_t s) const
  {
    return m_first_on_side[s] - m_first_at_corner[s];
  }
  const Chord_end& end_at_corner(std::size_t s, std::size_t i) const
  {
    return m_ends[m_first_at_corner[s] + i];
  }
  const Chord_end& end_at_mark(std::size_t s, std::size_t p) const
  {
    return m_ends[m_first_on_side[s] + p];
  }

  std::size_t size() const { return m_chords.size(); }
  const Chord<FT>& operator[](std::size_t chord) const { return m_chords[chord]; }
  const Chord_crossings& crossings() const { return m_crossings; }

  // Returns the positions of a crossing on the earlier and the later of its chords.
  const std::array<FT, 2>& places(std::size_t crossing) const { return m_places[crossing]; }

private:
  static constexpr std::size_t at_corner = static_cast<std::size_t>(-1);

  // Sets the chord of every mark, and whether this chord ends at the corner opposite to its side.
  std::array<std::size_t, 2> number_chords()
  {
    const std::array<Face_regions, 2> regions{this->regions(0), this->regions(1)};
    for(std::size_t s = 0; s < 3; ++s) {
      const std::size_t n = m_edges.numbers().size(Edge_index(m_side[s]));
      std::array<std::size_t, 2> number{};
      m_marks[s].clear();
      m_chord[s].clear();
      m_ends_at_corner[s].clear();
      for(std::size_t p = 0; p < n; ++p) {
        m_marks[s].push_back(m_edges.mark(m_side[s], static_cast<size_type>(p)));
        const std::size_t k = m_marks[s].back().family;
        const auto curve = regions[k].curve_at_side(s, number[k]++);
        m_chord[s].push_back((k == 0 ? 0 : regions[0].size() - 1) +
                             (curve.from_apex
                                ? regions[k].first_of_rest() + curve.number
                                : regions[k].around_corner(curve.corner, curve.number)));
        m_ends_at_corner[s].push_back(curve.from_apex);
      }
    }
    return {regions[0].size() - 1, regions[1].size() - 1};
  }

  Face_regions regions(std::size_t family) const
  {
    std::array<std::size_t, 3> n;
    for(std::size_t s = 0; s < 3; ++s)
      n[s] = m_edges.count(family, Edge_index(m_side[s]));
    return Face_regions(n);
  }

  // Adds the ends at a corner. Chords do not cross, so the first chord at the corner is the last
  // chord on the opposite side.
  void add_ends_at_corner(std::size_t s)
  {
    const std::size_t opposite = (s + 1) % 3;
    for(std::size_t p = m_marks[opposite].size(); p-- > 0;)
      if(m_ends_at_corner[opposite][p])
        add_end(m_chord[opposite][p], s, at_corner);
  }

  void add_end(std::size_t chord, std::size_t side, std::size_t mark)
  {
    m_ends.push_back({chord, side, mark, false});
    m_chord_at_end.push_back(chord);
  }

  void set_chords(const std::array<std::size_t, 2>& n)
  {
    for(std::size_t c = 0; c < m_chords.size(); ++c)
      m_chords[c].family = c < n[0] ? 0 : 1;
    for(std::size_t i = 0; i < m_ends.size(); ++i) {
      m_ends[i].is_first = m_crossings.is_first_end(m_ends[i].chord, i);
      set_end(m_ends[i], m_chords[m_ends[i].chord]);
    }
  }

  void set_end(const Chord_end& end, Chord<FT>& chord) const
  {
    const std::size_t i = end.is_first ? 0 : 1;
    if(end.mark == at_corner) {
      chord.vertex[i] = m_edges.mesh().source(m_side[end.side]);
      chord.weight[i] = {FT(1 - i), FT(i)};
      chord.place[i] = place(end.side, FT(0));
      return;
    }
    const Mark<FT>& mark = m_marks[end.side][end.mark];
    chord.vertex[i] = mark.vertex;
    const Edge_location<FT> across = end.is_first ? reversed(mark.across) : mark.across;
    chord.along = across.halfedge;
    chord.weight[i] = across.weight;
    chord.place[i] = place(end.side, mark.here);
  }

  static std::array<FT, 3> place(std::size_t s, const FT& t)
  {
    return Intrinsic_triangulations::barycentric_coordinates(s, t);
  }

  // Computes the crossings. Rounding may move a crossing along a chord, but never reorders
  // crossings.
  void intersect()
  {
    m_places.resize(m_crossings.size());
    for(std::size_t x = 0; x < m_crossings.size(); ++x)
      m_places[x] = intersection(m_chords[m_crossings[x].earlier], m_chords[m_crossings[x].later]);
    for(std::size_t c = 0; c < m_chords.size(); ++c) {
      FT last(0);
      for(std::size_t r = 0; r < m_crossings.number_on(c); ++r) {
        const std::size_t x = m_crossings.on(c, r);
        FT& place = m_places[x][m_crossings[x].earlier == c ? 0 : 1];
        place = last = (std::max)(last, place);
      }
    }
  }

  // Returns the positions of an intersection. Areas determine the position on the shorter chord.
  // The position on the longer chord is the projection of this point. So both positions are the
  // same point, even if the angle is almost zero.
  static std::array<FT, 2> intersection(const Chord<FT>& earlier, const Chord<FT>& later)
  {
    if(squared_length(earlier) < squared_length(later)) {
      const FT t = place_between(area(later, earlier.place[0]), -area(later, earlier.place[1]));
      return {t, projection(between(earlier.place[0], earlier.place[1], t), later)};
    }
    const FT t = place_between(-area(earlier, later.place[0]), area(earlier, later.place[1]));
    return {projection(between(later.place[0], later.place[1], t), earlier), t};
  }

  static FT squared_length(const Chord<FT>& c)
  {
    return Intrinsic_triangulations::internal::dot(c.place[0], c.place[1], c.place[0], c.place[1]);
  }

  // Returns an area that is positive if `p` is left of the chord.
  static FT area(const Chord<FT>& c, const std::array<FT, 3>& p)
  {
    return Intrinsic_triangulations::internal::orientation(c.place[0], c.place[1], p);
  }

  // Returns the position of a line on a chord whose ends have these distances from it, which should
  // not be negative.
  static FT place_between(FT first, FT last)
  {
    first = (std::max)(first, FT(0));
    last = (std::max)(last, FT(0));
    return first + last > 0 ? FT(first / (first + last)) : FT(1) / 2;
  }

  static FT projection(const std::array<FT, 3>& p, const Chord<FT>& c)
  {
    using Intrinsic_triangulations::internal::closest_between;
    return squared_length(c) > 0 ? closest_between(c.place[0], c.place[1], p) : FT(1) / 2;
  }

  const Marked_edges<FT>& m_edges;
  std::array<Halfedge_index, 3> m_side;
  std::array<std::vector<Mark<FT>>, 3> m_marks;      // of each side
  std::array<std::vector<std::size_t>, 3> m_chord;   // of each mark
  std::array<std::vector<char>, 3> m_ends_at_corner; // whether that ends at the opposite corner
  std::vector<Chord_end> m_ends;                     // around the face
  std::vector<std::size_t> m_chord_at_end;
  std::array<std::size_t, 3> m_first_at_corner, m_first_on_side;
  std::vector<Chord<FT>> m_chords;
  Chord_crossings m_crossings;
  std::vector<std::array<FT, 2>> m_places;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_FACE_CHORDS_H
