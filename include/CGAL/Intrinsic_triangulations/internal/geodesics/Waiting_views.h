// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores values ordered by keys up to the width of a bucket, for searches that need the order only
// for speed. They lie in memory in the order in which they are read.
template <typename FT, typename Value>
class Bucket_queue
{
public:
  explicit Bucket_queue(const FT& width) : m_per_key(1 / width) {}

  void push(const FT& key, const Value& value)
  {
    const FT place = key * m_per_key;
    const std::size_t last = maximal_number_of_buckets - 1;
    const std::size_t i = place < FT(last) ? static_cast<std::size_t>(place) : last;
    if(i >= m_bucket.size())
      m_bucket.resize(i + 1);
    if(i < m_first)
      go_back(i);
    m_bucket[i].push_back(value);
    ++m_size;
  }

  // Returns whether the queue is empty, and moves to the first bucket that contains a value.
  bool is_empty()
  {
    while(m_first < m_bucket.size() && m_next == m_bucket[m_first].size()) {
      std::vector<Value>().swap(m_bucket[m_first]);
      m_first = m_size > 0 ? m_first + 1 : m_bucket.size();
      m_next = 0;
    }
    if(m_size == 0)
      m_first = 0;
    return m_size == 0;
  }

  // Returns a lower bound of all keys, or infinity if the queue is empty.
  FT least_key()
  {
    return is_empty() ? std::numeric_limits<FT>::infinity() : FT(FT(m_first) / m_per_key);
  }

  // Removes and returns a value of the first bucket, in the order of arrival.
  // \pre !is_empty()
  Value pop()
  {
    --m_size;
    return m_bucket[m_first][m_next++];
  }

private:
  static constexpr std::size_t maximal_number_of_buckets = std::size_t(1) << 20;

  void go_back(std::size_t i)
  {
    auto& bucket = m_bucket[m_first];
    bucket.erase(bucket.begin(), bucket.begin() + static_cast<std::ptrdiff_t>(m_next));
    m_first = i;
    m_next = 0;
  }

  FT m_per_key;
  std::vector<std::vector<Value>> m_bucket;
  std::size_t m_size = 0;
  std::size_t m_first = 0, m_next = 0; // the present bucket, and the place in it
};

// Cuts off parts of two views through one side in which all paths of one view are longer than paths
// of the other. An empty part has an end before its begin.
template <typename FT>
class View_separation
{
public:
  typedef internal::View<FT> View;

  // `length` is the length of the side, to which errors of positions are proportional.
  View_separation(View& a, View& b, const FT& length)
    : m_a(a),
      m_b(b),
      m_slack(path_tolerance<FT>() * (CGAL::abs(a.before) + a.scale() + length)),
      m_overlap(a.is_parallel || b.is_parallel ? m_slack : FT(0))
  {}

  // Separates views whose rays cross before the edge, if `b` begins before the end of `a`. Suppose
  // that a ray of `a` reaches a point on a path that is not longer than a path by `b`. Then all
  // rays of `b` that cross this ray are on longer paths.
  void in_order()
  {
    if(m_a.end <= m_b.begin)
      return;
    const FT at_end = difference(m_a.end);
    if(at_end <= 0)
      return cut_begin(m_b, m_a.end);
    const FT at_begin = difference(m_b.begin);
    if(at_begin >= 0)
      return cut_end(m_a, m_b.begin);
    const FT x = crossing(m_b.begin, m_a.end, at_begin, at_end);
    const bool is_seen_by_a = m_a.begin < x, is_seen_by_b = x < m_b.end;
    if(is_seen_by_b)
      cut_end(m_a, x);
    if(is_seen_by_a)
      cut_begin(m_b, x);
  }

  // Separates other views. From an end of the common part, the view with longer paths is cut off.
  void by_points()
  {
    const FT first = (std::max)(m_a.begin, m_b.begin), last = (std::min)(m_a.end, m_b.end);
    if(!(first < last))
      return;
    const FT at_first = difference(first), at_last = difference(last);
    if(!(CGAL::abs(at_first) > m_slack || CGAL::abs(at_last) > m_slack))
      return;
    View &longer_first = at_first > 0 || (at_first == 0 && at_last > 0) ? m_a : m_b,
         &longer_last = at_last > 0 || (at_last == 0 && at_first > 0) ? m_a : m_b;
    if(&longer_first == &longer_last) {
      if(slope(first) * slope(last) > 0)
        cut(longer_first, first, last);
      return;
    }
    const FT x = crossing(first, last, at_first, at_last);
    cut(longer_first, first, x);
    cut(longer_last, x, last);
  }

private:
  FT difference(const FT& x) const { return m_a.length_to(x) - m_b.length_to(x); }
  // Returns the derivative of the difference, which has at most one extremum along the edge.
  FT slope(const FT& x) const { return m_a.slope(x) - m_b.slope(x); }

  static void cut_begin(View& v, const FT& x)
  {
    v.begin = x;
    close_if_empty(v);
  }
  static void cut_end(View& v, const FT& x)
  {
    v.end = x;
    close_if_empty(v);
  }
  static void close_if_empty(View& v)
  {
    if(v.begin == v.end)
      v.close();
  }

  // Cuts off a part at an end of the view. Rays from the end of a segment and parallel rays keep an
  // overlap, since errors of positions could leave a gap. If the end is near the edge, they are
  // large errors of directions.
  void cut(View& v, const FT& from, const FT& to) const
  {
    if(from <= v.begin && to >= v.end)
      v.close();
    else if(from <= v.begin)
      cut_begin(v, (std::max)(v.begin, FT(to - m_overlap)));
    else if(to >= v.end)
      cut_end(v, (std::min)(v.end, FT(from + m_overlap)));
  }

  // Returns the position at which both lengths are equal up to rounding, by Newton's method
  // restricted to the interval.
  // \pre the differences at its ends have different signs
  FT crossing(FT first, FT last, const FT& at_first, const FT& at_last) const
  {
    FT x = first + (last - first) * (at_first / (at_first - at_last));
    for(int i = 0; i < 60; ++i) {
      const FT d = difference(x);
      if(!(CGAL::abs(d) > m_slack / 256))
        return x;
      ((d > 0) == (at_first > 0) ? first : last) = x;
      const FT next = x - d / slope(x);
      x = first < next && next < last ? next : FT((first + last) / 2);
    }
    return x;
  }

  View &m_a, &m_b;
  FT m_slack, m_overlap;
};

// Separates two views through one side of this length. If `order` is negative, rays of `a` come
// from the left of all rays of `b`. If it is positive, they come from the right. Zero is unknown.
template <typename FT>
void separate(View<FT>& a, View<FT>& b, int order, const FT& length)
{
  if(order == 0)
    View_separation<FT>(a, b, length).by_points();
  else
    order < 0 ? View_separation<FT>(a, b, length).in_order()
              : View_separation<FT>(b, a, length).in_order();
}

// Adds a view to a list, which is sorted by begins along an edge, and separates it from the last
// views. The result of `order(a, b)` is the argument `order` of `separate()`. By rounding, each of
// two views could come before the other. So views are exchanged at most `exchanges` times, and may
// overlap afterwards.
template <typename FT, typename Order>
void append(View<FT> view, const Order& order, const FT& length, std::vector<View<FT>>& list,
            std::size_t& exchanges)
{
  while(!list.empty() && list.back().end > view.begin && exchanges > 0) {
    View<FT> last = list.back();
    separate(last, view, order(last, view), length);
    const bool is_left = last.begin <= last.end;
    if(is_left && last.begin <= view.begin) {
      list.back() = last;
      break;
    }
    list.pop_back();
    if(is_left) {
      --exchanges;
      append(view, order, length, list, exchanges);
      return append(last, order, length, list, exchanges);
    }
  }
  if(view.begin <= view.end)
    list.push_back(view);
}

template <typename FT, typename Order>
void append(const View<FT>& view, const Order& order, const FT& length, std::vector<View<FT>>& list)
{
  std::size_t exchanges = 1000;
  append(view, order, length, list, exchanges);
}

// Stores views that wait at the sides through which they look, in the order along each side. Memory
// is reused, and linear in the number of sides and of waiting views.
template <typename FT>
class Waiting_views
{
public:
  typedef internal::View<FT> View;
  typedef typename View::Index Index;
  static constexpr Index null = View::null;

  explicit Waiting_views(std::size_t sides) : m_list_at(sides, null) {}

  // Adds views in the order along side `c`, which has this length. \pre `views` is not empty
  void add(Index c, const FT& length, const std::vector<View>& views)
  {
    Index& number = m_list_at[c];
    if(number == null) {
      number = free_list();
      m_list[number].assign(views.begin(), views.end());
    } else
      merge(views, length, m_list[number]);
  }

  // Moves all views that wait at side `c` into `views`, which loses its content.
  void take(Index c, std::vector<View>& views)
  {
    views.clear();
    const Index number = m_list_at[c];
    if(number == null)
      return;
    views.swap(m_list[number]);
    m_list[number].clear();
    m_free.push_back(number);
    m_list_at[c] = null;
  }

private:
  Index free_list()
  {
    if(m_free.empty()) {
      m_list.emplace_back();
      return static_cast<Index>(m_list.size() - 1);
    }
    const Index result = m_free.back();
    m_free.pop_back();
    return result;
  }

  static bool is_before(const View& a, const View& b)
  {
    return std::tie(a.entry, a.begin) < std::tie(b.entry, b.begin);
  }

  static int order(const View& a, const View& b)
  {
    return a.entry == Entry::inside || b.entry == Entry::inside ? 0 : int(a.entry) - int(b.entry);
  }

  void merge(const std::vector<View>& views, const FT& length, std::vector<View>& list)
  {
    m_merged.clear();
    auto next = list.begin();
    for(const View& view : views) {
      for(; next != list.end() && !is_before(view, *next); ++next)
        append(*next, order, length, m_merged);
      append(view, order, length, m_merged);
    }
    for(; next != list.end(); ++next)
      append(*next, order, length, m_merged);
    list.swap(m_merged);
  }

  std::vector<Index> m_list_at; // of each side
  std::vector<std::vector<View>> m_list;
  std::vector<Index> m_free;
  std::vector<View> m_merged;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H
