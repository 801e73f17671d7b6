// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_FACE_CUTTER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_FACE_CUTTER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Route.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_simplification/internal/maps/largest_ear.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Stores a side of a polygon: the point where it starts and the index of its line.
struct Cell_side
{
  Face_point from;
  std::size_t line;
};

// Stores a polygon inside a face, with the linear map to it from the face where it started. The map
// is given by the images of the three corners.
struct Cell
{
  Face_index face;
  std::array<Face_point, 3> image;
  std::vector<Cell_side> sides; // counterclockwise
};

// Returns whether the side with index `n` lies on an edge of the face.
inline bool is_on_edge(const Cell& cell, std::size_t n)
{
  const std::size_t next = n + 1 == cell.sides.size() ? 0 : n + 1;
  return is_pair(cell.sides[n].from.corners | cell.sides[next].from.corners);
}

// Returns the area of a polygon with `n` corners in a face, relative to the face. It is negative if
// the polygon is clockwise. `at(c)` returns the homogeneous coordinates of a corner.
template <typename At>
double polygon_area(std::size_t n, const At& at)
{
  const auto point = [&](std::size_t c) {
    Coordinates b = at(c);
    normalize(b);
    return b;
  };
  double sum = 0;
  const Coordinates a = point(0);
  for(std::size_t c = 1; c + 1 < n; ++c) {
    const Coordinates b = point(c), d = point(c + 1);
    sum += relative_area(a, b, d);
  }
  return sum;
}

// Maps a face of the fine level through the operations to the coarse level. A new edge cuts it,
// like a curve, and each cell is mapped alone. Cells on the two sides of a cut share their common
// points by index, and agree bitwise on their coordinates. So with any rounding, cells are a
// subdivision of the face.
class Face_cutter
{
public:
  explicit Face_cutter(const Surface_map& map) : m_route(map.route(true)) {}

  // Returns the cells of `f`. Faces have the indices of the evolving surface.
  const std::vector<Cell>& cut(Face_index f)
  {
    m_result.clear();
    m_crossings.clear();
    m_lines.clear();
    m_is_crease.assign(3, 1);
    m_number_of_points = 3;
    m_stack.clear();
    push(start(m_route.start().surface_face(f)), m_route.start().time());
    while(!m_stack.empty()) {
      Timed_cell c = std::move(m_stack.back());
      m_stack.pop_back();
      if(c.time == m_route.end().time())
        m_result.push_back(std::move(c.cell));
      else
        m_route.pass(c.time, [&](const auto& operation) { pass(operation, c); });
    }
    return m_result;
  }

  // Returns whether the map changes at a line, which was on an edge when the scale changed beside
  // it. The first three lines are the sides of the face.
  bool is_crease(std::size_t line) const { return m_is_crease[line] != 0; }

private:
  // Stores a cell with the time of its next operation.
  struct Timed_cell
  {
    Cell cell;
    Route::Time time;
  };

  // Stores a point of a cell before a flip, the side that starts at it, and its side of the new
  // edge.
  struct Sided_point
  {
    Patch_point point;
    std::size_t line;
    int side;
  };
  typedef std::vector<Sided_point> Part;

  static Cell start(Face_index f)
  {
    Cell result{f, {}, {}};
    for(std::size_t c = 0; c < 3; ++c) {
      Face_point p{{}, bit(c), {}, c};
      p.weight[c] = p.along[c] = 1;
      result.sides.push_back({p, c});
      p.corners = bit(0) | bit(1) | bit(2);
      result.image[c] = p;
    }
    return result;
  }

  // Pushes the cell with the time of its next operation.
  void push(Cell&& cell, Route::Time now)
  {
    const Route::Time next = m_route.next(cell.face, now);
    m_stack.push_back({std::move(cell), next});
  }

  template <typename Change>
  static void change_points(Cell& cell, const Change& change)
  {
    for(Cell_side& s : cell.sides)
      s.from = change(s.from);
    for(Face_point& p : cell.image)
      p = change(p);
  }

  void pass(const Scaling& scaling, Timed_cell& c)
  {
    for(std::size_t n = 0; n < c.cell.sides.size(); ++n)
      if(is_on_edge(c.cell, n))
        m_is_crease[c.cell.sides[n].line] = 1;
    const Coordinates factor = m_route.factors(scaling, c.cell.face);
    change_points(c.cell, [&](Face_point p) {
      for(std::size_t k = 0; k < 3; ++k)
        p.weight[k] *= factor[k];
      return p;
    });
    push(std::move(c.cell), c.time + 1);
  }

  void pass(const Vertex_sectors<>& sectors, Timed_cell& c)
  {
    if(sectors.is_insertion())
      throw Intrinsic_triangulations::Invalid_input(
        "a vertex has been inserted between the levels");
    const Patch_face sector = sectors[sectors.sector_of(c.cell.face)];
    c.cell.face = sectors.whole().face;
    change_points(c.cell, [&](const Face_point& p) {
      return sectors.whole().in_face(sectors.in_whole(sector.in_patch(p)));
    });
    push(std::move(c.cell), c.time + 1);
  }

  void pass(const Flip& flip, const Timed_cell& c)
  {
    const Recorded_flip turn(flip, true);
    const Patch_face before = turn.before(turn.has_r(c.cell.face));
    m_points.clear();
    for(const Cell_side& s : c.cell.sides) {
      Patch_point x = before.in_patch(s.from);
      if(turn.is_near_diagonal(x))
        x = numbered(turn.crossing(x, x), x.node);
      m_points.push_back({x, s.line, turn.side(x)});
    }
    for(std::size_t n = 0; n < 3; ++n)
      m_image[n] = before.in_patch(c.cell.image[n]);
    const bool has_positive = move_to_front(1), has_negative = move_to_front(-1);
    if(has_positive && has_negative)
      cut_along(turn, c.time);
    else
      add_part(turn, !has_negative, m_points, c.time);
  }

  static Patch_point numbered(Patch_point x, std::size_t node)
  {
    x.node = node;
    return x;
  }

  // Rotates the points so that the first one is on the given side. Returns whether such a point
  // exists.
  bool move_to_front(int side)
  {
    const auto first = std::find_if(m_points.begin(), m_points.end(),
                                    [&](const Sided_point& p) { return p.side == side; });
    if(first == m_points.end())
      return false;
    std::rotate(m_points.begin(), first, m_points.end());
    return true;
  }

  // Cuts the cell along the new edge. Points on the edge belong to the part of the preceding
  // points. The cell has two parts, or more if rounding has bent a side. Then the negative side is
  // cut off part by part.
  void cut_along(const Recorded_flip<>& turn, Route::Time t)
  {
    move_to_front(1); // the last that is not on the edge is negative now
    const std::size_t edge = line_of_flip(t);
    m_positive.clear();
    m_negative.clear();
    int side = 1;
    for(std::size_t n = 0; n < m_points.size(); ++n) {
      const Sided_point &p = m_points[n], &next = m_points[n + 1 == m_points.size() ? 0 : n + 1];
      Part &here = side > 0 ? m_positive : m_negative, &there = side > 0 ? m_negative : m_positive;
      if(p.side != 0 || next.side != -side)
        here.push_back(p);
      if(next.side != -side)
        continue;
      const Patch_point x = p.side == 0 ? p.point : crossing(turn, p.point, next.point);
      here.push_back({x, edge, 0});
      there.push_back({x, p.line, 0});
      if(side < 0)
        add_part(turn, false, std::exchange(m_negative, {}), t);
      side = -side;
    }
    add_part(turn, true, m_positive, t);
  }

  std::size_t line_of_flip(Route::Time t)
  {
    const auto [line, is_new] = m_lines.emplace(t, m_is_crease.size());
    if(is_new)
      m_is_crease.push_back(0);
    return line->second;
  }

  // Returns the crossing, which is bitwise equal for both cells beside it.
  Patch_point crossing(const Recorded_flip<>& turn, const Patch_point& x, const Patch_point& y)
  {
    if(x.node > y.node)
      return crossing(turn, y, x);
    const auto [entry, is_new] = m_crossings.emplace(std::pair(x.node, y.node), m_number_of_points);
    m_number_of_points += is_new;
    return numbered(turn.crossing(x, y), entry->second);
  }

  void add_part(const Recorded_flip<>& turn, bool has_p, const Part& part, Route::Time t)
  {
    const Patch_face after = turn.after(has_p);
    Cell result{after.face, {}, {}};
    for(const Sided_point& p : part)
      result.sides.push_back({after.in_face(turn.turned(p.point)), p.line});
    for(std::size_t c = 0; c < 3; ++c) {
      Patch_point image = m_image[c];
      turn.change(image.weight, has_p);
      image.corners = after.corners();
      result.image[c] = after.in_face(image);
    }
    push(std::move(result), t + 1);
  }

  Route m_route;
  std::size_t m_number_of_points = 0;
  std::vector<char> m_is_crease; // of each line
  std::map<Route::Time, std::size_t> m_lines;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_crossings; // of sides that were cut
  std::vector<Timed_cell> m_stack;
  Part m_points, m_positive, m_negative; // of the cell that is being cut
  std::array<Patch_point, 3> m_image;
  std::vector<Cell> m_result;
};

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

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_FACE_CUTTER_H
