// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/internal/geodesics/Waiting_views.h>
#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace Test_view_separation {

namespace IT = CGAL::Intrinsic_triangulations;
typedef IT::internal::View<double> View;
typedef IT::internal::Entry Entry;

const double infinity = std::numeric_limits<double>::infinity();

View view(const std::complex<double>& position, double begin, double end, double before)
{
  return {position, begin, end, before, 0, 0, View::null, false, Entry::inside};
}

View random_view(CGAL::Random& random)
{
  const double a = random.get_double(), b = random.get_double();
  const std::complex<double> p(random.get_double(-2, 3), random.get_double(0, 2));
  View result = view(p, (std::min)(a, b), (std::max)(a, b), random.get_double(2, 3));
  if(random.get_int(0, 4) == 0) {
    result.is_parallel = true;
    result.position = std::polar(1., random.get_double(0.1, 3));
  }
  return result;
}

// Returns the least length of a path to the point of the edge at `x`, or infinity if it is not
// visible.
double least(const std::vector<View>& views, double x)
{
  double result = infinity;
  for(const View& v : views)
    if(v.begin <= x && x <= v.end)
      result = (std::min)(result, v.length_to(x));
  return result;
}

const auto unknown = [](const View&, const View&) { return 0; };

// No point loses a shortest path, whatever views are added in any order.
TEST(View_separation, keeps_least_lengths)
{
  CGAL::Random random(1);
  for(int i = 0; i < 3000; ++i) {
    std::vector<View> all, list;
    for(int k = random.get_int(2, 7); k > 0; --k) {
      all.push_back(random_view(random));
      IT::internal::append(all.back(), unknown, 1., list);
    }
    for(int k = 0; k < 200; ++k) {
      const double x = random.get_double(), truth = least(all, x);
      if(truth < infinity)
        EXPECT_NEAR(least(list, x), truth, 1e-11) << i;
      else
        EXPECT_EQ(least(list, x), infinity) << i;
    }
  }
}

View scaled(View v, double factor)
{
  if(!v.is_parallel)
    v.position *= factor;
  v.begin *= factor;
  v.end *= factor;
  v.before *= factor;
  return v;
}

// Powers of two change no digit of a number, so no part is left or lost at any scale.
TEST(View_separation, is_the_same_at_all_scales)
{
  for(const double factor : {std::ldexp(1, -100), std::ldexp(1, 60), std::ldexp(1, 100)}) {
    CGAL::Random random(3);
    for(int i = 0; i < 3000; ++i) {
      std::vector<View> list, large;
      for(int k = random.get_int(2, 7); k > 0; --k) {
        const View v = random_view(random);
        IT::internal::append(v, unknown, 1., list);
        IT::internal::append(scaled(v, factor), unknown, factor, large);
      }
      ASSERT_EQ(large.size(), list.size()) << i;
      for(std::size_t k = 0; k < list.size(); ++k) {
        EXPECT_EQ(large[k].begin, list[k].begin * factor) << i;
        EXPECT_EQ(large[k].end, list[k].end * factor) << i;
      }
    }
  }
}

// Returns the position at which the ray to the point of the edge at `x` passes the line at height
// 1.
double passage(const View& v, double x) { return x + (v.position.real() - x) / v.position.imag(); }

View view_of_edge(CGAL::Random& random)
{
  return view({random.get_double(-3, 4), random.get_double(1.1, 4)}, 0, 1, random.get_double(0, 2));
}

// Views of the whole edge whose rays pass a line in known order meet in at most one point.
TEST(View_separation, in_order_leaves_no_overlap)
{
  CGAL::Random random(2);
  int checked = 0, split = 0;
  while(checked < 2000) {
    const View a = view_of_edge(random), b = view_of_edge(random);
    const bool is_left = passage(a, 1) <= passage(b, 0);
    if(!is_left && passage(b, 1) > passage(a, 0))
      continue;
    ++checked;
    View first = a, last = b;
    IT::internal::separate(first, last, is_left ? -1 : 1, 1.);
    const bool is_first_seen = first.begin <= first.end, is_last_seen = last.begin <= last.end;
    ASSERT_TRUE(is_first_seen || is_last_seen);
    if(is_first_seen && is_last_seen) {
      EXPECT_EQ(is_left ? first.end : last.end, is_left ? last.begin : first.begin);
      ++split;
    }
    for(int k = 0; k < 50; ++k) {
      const double x = random.get_double();
      EXPECT_NEAR(least({first, last}, x), least({a, b}, x), 1e-11);
    }
  }
  EXPECT_GT(split, 100);
}

} // namespace Test_view_separation
