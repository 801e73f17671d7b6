// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CELL_JOINER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CELL_JOINER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Face_cutter.h>

#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Joins the cells of a face across lines, if the map is equal on both sides.
class Cell_joiner
{
public:
  // Calls `visit(cell, corners)` for each union of cells, with the largest cell, and the corners of
  // the union counterclockwise. The linear map of a cell that exists only because of rounding is as
  // inaccurate.
  template <typename Visit>
  void join(const std::vector<Cell>& cells, const Face_cutter& lines, const Visit& visit)
  {
    m_cells = &cells;
    number_sides();
    find_opposites();
    find_unions(lines);
    find_largest();
    std::vector<char> is_done(cells.size(), 0);
    for(std::size_t s = 0; s < m_place.size(); ++s)
      if(is_outer(s) && !std::exchange(is_done[union_of(s)], 1)) {
        collect_corners(s);
        visit(cells[m_largest[union_of(s)]], m_corners);
      }
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Represents a side of a cell.
  struct Place
  {
    std::size_t cell, side;
  };

  void number_sides()
  {
    m_place.clear();
    m_first_side.clear();
    for(std::size_t c = 0; c < m_cells->size(); ++c) {
      m_first_side.push_back(m_place.size());
      for(std::size_t n = 0; n < (*m_cells)[c].sides.size(); ++n)
        m_place.push_back({c, n});
    }
  }

  const Cell& cell(std::size_t s) const { return (*m_cells)[m_place[s].cell]; }
  const Cell_side& side(std::size_t s) const { return cell(s).sides[m_place[s].side]; }
  std::size_t union_of(std::size_t s) const { return m_union[m_place[s].cell]; }

  std::size_t next(std::size_t s) const
  {
    return m_place[s].side + 1 == cell(s).sides.size() ? m_first_side[m_place[s].cell] : s + 1;
  }

  void find_opposites()
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> by_ends;
    for(std::size_t s = 0; s < m_place.size(); ++s)
      by_ends.emplace(std::pair(side(s).from.node, side(next(s)).from.node), s);
    m_opposite.clear();
    for(std::size_t s = 0; s < m_place.size(); ++s) {
      const auto entry = by_ends.find({side(next(s)).from.node, side(s).from.node});
      m_opposite.push_back(entry == by_ends.end() ? none : entry->second);
    }
  }

  void find_unions(const Face_cutter& lines)
  {
    m_union.assign(m_cells->size(), none);
    std::vector<std::size_t> waiting;
    for(std::size_t first = 0; first < m_cells->size(); ++first)
      if(m_union[first] == none) {
        m_union[first] = first;
        for(waiting.push_back(first); !waiting.empty();) {
          const std::size_t c = waiting.back();
          waiting.pop_back();
          for(std::size_t n = 0; n < (*m_cells)[c].sides.size(); ++n) {
            const std::size_t s = m_first_side[c] + n;
            if(is_crossed(s, lines) &&
               std::exchange(m_union[m_place[m_opposite[s]].cell], first) == none)
              waiting.push_back(m_place[m_opposite[s]].cell);
          }
        }
      }
  }

  void find_largest()
  {
    m_largest = m_union;
    std::vector<double> area;
    for(const Cell& c : *m_cells)
      area.push_back(
        polygon_area(c.sides.size(), [&](std::size_t n) { return c.sides[n].from.along; }));
    for(std::size_t c = 0; c < m_cells->size(); ++c)
      if(area[c] > area[m_largest[m_union[c]]])
        m_largest[m_union[c]] = c;
  }

  // Returns whether the union extends beyond the side of the cell.
  bool is_crossed(std::size_t s, const Face_cutter& lines) const
  {
    return m_opposite[s] != none && !lines.is_crease(side(s).line) &&
           !is_on_edge(cell(s), m_place[s].side) && cell(s).face == cell(m_opposite[s]).face;
  }

  bool is_outer(std::size_t s) const
  {
    return m_opposite[s] == none || union_of(m_opposite[s]) != union_of(s);
  }

  // Collects the corners at which the line changes, around the union with the boundary halfedge
  // `first`.
  void collect_corners(std::size_t first)
  {
    m_corners.clear();
    std::size_t s = first;
    do {
      std::size_t after = next(s);
      while(!is_outer(after))
        after = next(m_opposite[after]);
      if(side(after).line != side(s).line)
        m_corners.push_back(&side(after).from);
      s = after;
    } while(s != first);
  }

  const std::vector<Cell>* m_cells = nullptr;
  std::vector<Place> m_place;
  std::vector<std::size_t> m_first_side; // of each cell
  std::vector<std::size_t> m_opposite;   // of each side
  std::vector<std::size_t> m_union;      // of each cell: the first cell of its union
  std::vector<std::size_t> m_largest;    // of each union
  std::vector<const Face_point*> m_corners;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CELL_JOINER_H
