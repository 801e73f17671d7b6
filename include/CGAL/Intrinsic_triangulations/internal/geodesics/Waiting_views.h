// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View_separation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Adds a view to a list, which is sorted by begins along an edge, and separates it from the last
// views. The result of `order(a, b)` is the argument `order` of `separate()`.
template <typename FT, typename Order>
void append(View<FT> view, const Order& order, std::vector<View<FT>>& list)
{
  while(!list.empty() && list.back().end > view.begin) {
    View<FT> last = list.back();
    separate(last, view, order(last, view));
    const bool is_left = last.begin <= last.end;
    if(is_left && last.begin <= view.begin) {
      list.back() = last;
      break;
    }
    list.pop_back();
    if(is_left) {
      append(view, order, list);
      return append(last, order, list);
    }
  }
  if(view.begin <= view.end)
    list.push_back(view);
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

  // Adds views in the order along side `c`. \pre `views` is not empty
  void add(Index c, const std::vector<View>& views)
  {
    Index& number = m_list_at[c];
    if(number == null) {
      number = free_list();
      m_list[number].assign(views.begin(), views.end());
    } else
      merge(views, m_list[number]);
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

  void merge(const std::vector<View>& views, std::vector<View>& list)
  {
    m_merged.clear();
    auto next = list.begin();
    for(const View& view : views) {
      for(; next != list.end() && !is_before(view, *next); ++next)
        append(*next, order, m_merged);
      append(view, order, m_merged);
    }
    for(; next != list.end(); ++next)
      append(*next, order, m_merged);
    list.swap(m_merged);
  }

  std::vector<Index> m_list_at; // of each side
  std::vector<std::vector<View>> m_list;
  std::vector<Index> m_free;
  std::vector<View> m_merged;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WAITING_VIEWS_H
