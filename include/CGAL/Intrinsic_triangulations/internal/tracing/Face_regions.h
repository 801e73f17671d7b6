// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_REGIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_REGIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a corner of a region of a face. It is corner `side` of the face if `mark` is `none`,
// otherwise crossing number `mark` on side `side`. Side s leads from corner s to the next one.
struct Region_corner
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t side;
  std::size_t mark;
  bool arc_follows; // whether a curve, not a piece of a side, leads on to the next corner

  bool is_vertex() const { return mark == none; }
};

// Represents a polygon with three to six corners in counterclockwise order.
class Region
{
public:
  std::size_t size() const { return m_size; }
  const Region_corner& operator[](std::size_t c) const { return m_corners[c]; }
  const Region_corner& next(std::size_t c) const { return m_corners[c + 1 == m_size ? 0 : c + 1]; }
  const Region_corner& previous(std::size_t c) const
  {
    return m_corners[(c == 0 ? m_size : c) - 1];
  }

  void add_vertex(std::size_t corner, bool arc_follows)
  {
    m_corners[m_size++] = {corner, Region_corner::none, arc_follows};
  }
  void add_mark(std::size_t side, std::size_t mark, bool arc_follows)
  {
    m_corners[m_size++] = {side, mark, arc_follows};
  }

private:
  std::array<Region_corner, 6> m_corners;
  std::size_t m_size = 0;
};

// Returns the first of 0, ..., n - 1 that satisfies a monotone condition, otherwise n.
template <typename Size, typename Condition>
Size first_where(const Condition& condition, Size n)
{
  Size low = 0;
  for(Size high = n; low < high;) {
    const Size middle = low + (high - low) / 2;
    if(condition(middle))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

// Describes the regions into which curves cut a face (Figure 3.7), from the numbers of crossings on
// its sides. Regions around corner 0 come first (outwards from it), then around corner 1 and corner
// 2. The rest follows: one region, or a fan cut by the curves that leave a corner.
class Face_regions
{
public:
  explicit Face_regions(const std::array<std::size_t, 3>& crossings) : m_crossings(crossings)
  {
    for(std::size_t s = 0; s < 3; ++s) {
      const auto n = [&](std::size_t k) {
        return static_cast<std::ptrdiff_t>(crossings[(s + k) % 3]);
      };
      m_around[s] = static_cast<std::size_t>(curves_around(n(1), n(0), n(2)));
      const std::ptrdiff_t leaving = curves_leaving(n(1), n(0), n(2));
      if(leaving > 0) {
        m_apex = s;
        m_leaving = static_cast<std::size_t>(leaving);
      }
    }
  }

  std::size_t size() const { return m_around[0] + m_around[1] + m_around[2] + m_leaving + 1; }

  // Returns the number of curves that cut off corner `s`, and of curves that leave corner `apex()`.
  std::size_t around(std::size_t s) const { return m_around[s]; }
  std::size_t leaving() const { return m_leaving; }
  std::size_t apex() const { return m_apex; }

  // Returns the number of region `j` around corner `s` among all regions, or of the first remaining
  // region.
  std::size_t around_corner(std::size_t s, std::size_t j) const
  {
    return j + (s > 0 ? m_around[0] : 0) + (s > 1 ? m_around[1] : 0);
  }
  std::size_t first_of_rest() const { return size() - 1 - m_leaving; }

  // Returns the region of a point. `is_at_corner(s, j)` returns whether it lies before curve `j`
  // around corner `s`, as seen from the corner. `is_before_curve(j)` returns whether it lies before
  // curve `j` from the apex, as seen from the side after the apex. Each is called a logarithmic
  // number of times, also for both curves at the region.
  template <typename At_corner, typename Before_curve>
  std::size_t find(const At_corner& is_at_corner, const Before_curve& is_before_curve) const
  {
    for(std::size_t s = 0; s < 3; ++s) {
      const auto is_inside = [&](std::size_t j) { return is_at_corner(s, j); };
      const std::size_t n = m_around[s];
      if(n > 0 && is_inside(n - 1))
        return around_corner(s, first_where(is_inside, n - 1));
    }
    return first_of_rest() + first_where(is_before_curve, m_leaving);
  }

  // Returns the two marks of curve `j` around corner `s`: on the side after and before the corner.
  std::array<Region_corner, 2> curve_around(std::size_t s, std::size_t j) const
  {
    const std::size_t before = (s + 2) % 3;
    return {Region_corner{s, j, true}, Region_corner{before, m_crossings[before] - 1 - j, false}};
  }

  // Returns the mark of curve `j` from the apex on the opposite side.
  Region_corner end_of_curve(std::size_t j) const
  {
    const std::size_t near = (m_apex + 1) % 3;
    return {near, m_around[near] + j, true};
  }

  // Returns the number of curves between region `number` and each corner of the face.
  std::array<std::size_t, 3> crossings_to_corners(std::size_t number) const
  {
    for(std::size_t s = 0; s < 3; ++s) {
      if(number < m_around[s])
        return crossings_from_corner_region(s, number);
      number -= m_around[s];
    }
    std::array<std::size_t, 3> crossings = m_around;
    if(m_leaving > 0) {
      crossings[(m_apex + 1) % 3] += number;
      crossings[(m_apex + 2) % 3] += m_leaving - number;
    }
    return crossings;
  }

  // Describes the curve around corner `corner`, or, if it ends at the corner, from the apex.
  // `number` counts from the corner, or from the side after the apex. The curve enters the face at
  // `other` and leaves it at `mark`.
  struct Curve
  {
    std::size_t corner, number;
    bool from_apex;
    Region_corner mark, other;
  };

  // Returns the curve from one corner of a region to the next.
  Curve curve(const Region_corner& from, const Region_corner& to) const
  {
    if(from.is_vertex() || to.is_vertex()) {
      const Region_corner &mark = from.is_vertex() ? to : from,
                          &apex = from.is_vertex() ? from : to;
      return {m_apex, mark.mark - m_around[mark.side], true, mark, apex};
    }
    const bool leaves_at_from = to.side == (from.side + 2) % 3;
    const Region_corner &mark = leaves_at_from ? from : to, &other = leaves_at_from ? to : from;
    return {mark.side, mark.mark, false, mark, other};
  }

  // Returns the curve that leaves the face at crossing `p` of side `s`. Its other end is not set.
  Curve curve_at_side(std::size_t s, std::size_t p) const
  {
    const std::size_t t = (s + 1) % 3, from_target = m_crossings[s] - 1 - p;
    const Region_corner mark{s, p, false};
    if(p < m_around[s])
      return {s, p, false, mark, {}};
    if(from_target < m_around[t])
      return {t, from_target, false, mark, {}};
    return {m_apex, p - m_around[s], true, mark, {}};
  }

  // Returns the number of curves between a point on `curve` and each corner of the face. The number
  // is -1 for a corner at which the curve ends.
  std::array<std::ptrdiff_t, 3> crossings_to_corners(const Curve& curve) const
  {
    std::array<std::ptrdiff_t, 3> crossings;
    const std::size_t s = curve.corner, t = (s + 1) % 3, u = (s + 2) % 3, j = curve.number;
    if(curve.from_apex) {
      crossings[s] = -1;
      crossings[t] = std::ptrdiff_t(j + m_around[t]);
      crossings[u] = std::ptrdiff_t(m_leaving - 1 - j + m_around[u]);
      return crossings;
    }
    const auto beyond = crossings_from_corner_region(s, j);
    crossings[s] = std::ptrdiff_t(j);
    crossings[t] = std::ptrdiff_t(beyond[t]) - 1;
    crossings[u] = std::ptrdiff_t(beyond[u]) - 1;
    return crossings;
  }

  // Returns the region beside the piece of side `s` after `p` of its crossings.
  std::size_t region_at_side(std::size_t s, std::size_t p) const
  {
    const std::size_t t = (s + 1) % 3, from_target = m_crossings[s] - p;
    if(p < m_around[s])
      return around_corner(s, p);
    if(from_target < m_around[t])
      return around_corner(t, from_target);
    if(m_leaving == 0 || m_apex == s)
      return first_of_rest();
    return first_of_rest() + (m_apex == t ? m_leaving : p - m_around[s]);
  }

  Region operator[](std::size_t number) const
  {
    for(std::size_t s = 0; s < 3; ++s) {
      if(number < m_around[s])
        return corner_region(s, number);
      number -= m_around[s];
    }
    return m_leaving > 0 ? fan_region(number) : central_region();
  }

private:
  // All curves around another corner lie beyond the curves around `s`.
  std::array<std::size_t, 3> crossings_from_corner_region(std::size_t s, std::size_t j) const
  {
    std::array<std::size_t, 3> crossings;
    for(std::size_t t = 0; t < 3; ++t) {
      const std::size_t fan = t == m_apex ? 0 : m_leaving;
      crossings[t] = t == s ? j : m_around[s] - j + fan + m_around[t];
    }
    return crossings;
  }

  Region corner_region(std::size_t s, std::size_t j) const
  {
    const std::size_t before = (s + 2) % 3, far = m_crossings[before] - j;
    Region region;
    if(j == 0)
      region.add_vertex(s, false);
    else
      region.add_mark(s, j - 1, false);
    region.add_mark(s, j, true);
    region.add_mark(before, far - 1, false);
    if(j > 0)
      region.add_mark(before, far, true);
    return region;
  }

  Region central_region() const
  {
    Region region;
    for(std::size_t s = 0; s < 3; ++s)
      add_trimmed_corner(s, region);
    return region;
  }

  // Returns region `j` between curves from the apex, counted from the side after it to the side
  // before it.
  Region fan_region(std::size_t j) const
  {
    Region region;
    region.add_vertex(m_apex, j > 0);
    if(j == 0)
      add_trimmed_corner((m_apex + 1) % 3, region);
    else
      region.add_mark((m_apex + 1) % 3, end_of_curve(j - 1).mark, false);
    if(j == m_leaving)
      add_trimmed_corner((m_apex + 2) % 3, region);
    else
      region.add_mark((m_apex + 1) % 3, end_of_curve(j).mark, true);
    return region;
  }

  // Adds corner `s` itself, or the outermost curve that cuts it off.
  void add_trimmed_corner(std::size_t s, Region& region) const
  {
    const std::size_t before = (s + 2) % 3;
    if(m_around[s] == 0)
      region.add_vertex(s, false);
    else {
      region.add_mark(before, m_crossings[before] - m_around[s], true);
      region.add_mark(s, m_around[s] - 1, false);
    }
  }

  std::array<std::size_t, 3> m_crossings;
  std::array<std::size_t, 3> m_around{};
  std::size_t m_apex = 0;
  std::size_t m_leaving = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_REGIONS_H
