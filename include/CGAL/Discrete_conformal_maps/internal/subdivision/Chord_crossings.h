// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_CHORD_CROSSINGS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_CHORD_CROSSINGS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the crossings of chords of a disk, from the order of their ends on the boundary alone.
// The chords form two families. Chords of one family do not cross. A chord leads from its first end
// to its last end.
//
// Along the boundary, the open chords of one family form a stack. When a chord closes, it crosses
// the chords of the other family that have been opened after it.
class Chord_crossings
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  // Stores the chord that opens and closes first, and the chord that the other one crosses from
  // right to left.
  struct Crossing
  {
    std::size_t earlier, later;
    std::array<std::size_t, 2> rank; // its index along either
  };

  // Computes the crossings. Chords 0, ..., n[0] - 1 are the first family, and the next n[1] chords
  // are the second family. `ends` contains the chord of every end, in counterclockwise order.
  // Complexity: linear in the ends and crossings.
  void compute(const std::array<std::size_t, 2>& n, const std::vector<std::size_t>& ends)
  {
    m_chords.assign(n[0] + n[1], Chord());
    m_crossings.clear();
    m_next_with_same_later.clear();
    for(std::size_t position = 0; position < ends.size(); ++position)
      visit(ends[position], ends[position] < n[0] ? 0 : 1, position);
    order(ends);
  }

  std::size_t size() const { return m_crossings.size(); }
  const Crossing& operator[](std::size_t x) const { return m_crossings[x]; }

  std::size_t number_on(std::size_t chord) const { return m_chords[chord].count; }

  // Returns the crossing with number `rank` on a chord.
  std::size_t on(std::size_t chord, std::size_t rank) const
  {
    return m_order[m_chords[chord].first + rank];
  }

  // Returns whether `position` is the first end of its chord.
  bool is_first_end(std::size_t chord, std::size_t position) const
  {
    return m_chords[chord].begin == position;
  }

private:
  struct Chord
  {
    std::size_t begin = none; // its first end
    std::size_t first_found = 0,
                count = 0;                // crossings with later chords start there; all crossings
    std::size_t last_with_earlier = none; // crossing with an earlier chord
    std::size_t first = 0;                // in m_order
  };

  void visit(std::size_t c, std::size_t family, std::size_t position)
  {
    Chord& chord = m_chords[c];
    if(chord.begin == none) {
      chord.begin = position;
      m_open[family].push_back(c);
      return;
    }
    CGAL_assertion(m_open[family].back() == c);
    m_open[family].pop_back();
    chord.first_found = m_crossings.size();
    const auto& others = m_open[1 - family];
    for(auto d = others.rbegin(); d != others.rend() && m_chords[*d].begin > chord.begin; ++d)
      add(c, *d);
  }

  void add(std::size_t earlier, std::size_t later)
  {
    m_next_with_same_later.push_back(m_chords[later].last_with_earlier);
    m_chords[later].last_with_earlier = m_crossings.size();
    m_crossings.push_back({earlier, later, {}});
    ++m_chords[earlier].count;
    ++m_chords[later].count;
  }

  // Orders the crossings along each chord. On one side of a chord, the chords that cross it have
  // one end each. Along the chord, crossings are in the order of these ends.
  void order(const std::vector<std::size_t>& ends)
  {
    std::size_t first = 0;
    for(Chord& c : m_chords) {
      c.first = first;
      first += c.count;
      c.count = 0;
    }
    m_order.resize(first);
    for(std::size_t position = 0; position < ends.size(); ++position)
      if(is_first_end(ends[position], position))
        append_to_earlier(ends[position]);
      else
        append_to_later(ends[position]);
  }

  void append_to_earlier(std::size_t c)
  {
    for(std::size_t x = m_chords[c].last_with_earlier; x != none; x = m_next_with_same_later[x])
      m_crossings[x].rank[0] = append(m_crossings[x].earlier, x);
  }

  void append_to_later(std::size_t c)
  {
    for(std::size_t x = m_chords[c].first_found;
        x < m_crossings.size() && m_crossings[x].earlier == c; ++x)
      m_crossings[x].rank[1] = append(m_crossings[x].later, x);
  }

  std::size_t append(std::size_t chord, std::size_t x)
  {
    const std::size_t rank = m_chords[chord].count++;
    m_order[m_chords[chord].first + rank] = x;
    return rank;
  }

  std::vector<Chord> m_chords;
  std::array<std::vector<std::size_t>, 2> m_open;
  std::vector<Crossing> m_crossings;
  std::vector<std::size_t> m_next_with_same_later;
  std::vector<std::size_t> m_order; // crossings along each chord
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_CHORD_CROSSINGS_H
