// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_TESTING_H
#define INTRINSIC_TRIANGULATIONS_TEST_TESTING_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// This file contains the common parts of all tests: the headers above, and loops that name their
// elements in failures.
namespace Test_surfaces {

// Represents the named elements 0, ..., size - 1 of a range. The trace of a failure in a loop over
// them has the name of the current element.
template <typename At, typename Name>
class Traced_range
{
public:
  Traced_range(std::size_t size, At at, Name name)
    : m_size(size), m_at(std::move(at)), m_name(std::move(name))
  {}

  class Iterator
  {
  public:
    Iterator(const Traced_range& range, std::size_t index) : m_range(range), m_index(index) {}

    decltype(auto) operator*()
    {
      decltype(auto) element = m_range.m_at(m_index);
      m_trace.emplace(__FILE__, __LINE__, m_range.m_name(element));
      return element;
    }

    void operator++()
    {
      m_trace.reset();
      ++m_index;
    }

    bool operator!=(const Iterator& other) const { return m_index != other.m_index; }

  private:
    const Traced_range& m_range;
    std::size_t m_index;
    std::optional<testing::ScopedTrace> m_trace;
  };

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, m_size}; }

private:
  std::size_t m_size;
  At m_at;
  Name m_name;
};

// Returns the parts of a text between white space.
inline std::vector<std::string> words(const std::string& text)
{
  std::istringstream is(text);
  return {std::istream_iterator<std::string>(is), {}};
}

template <typename T>
std::string name_of(const T& x)
{
  return x.name;
}

template <typename T>
std::string name_of(const std::pair<std::string, T>& x)
{
  return x.first;
}

constexpr auto name_and_seed = [](const auto& p) {
  return name_of(p.first) + ", seed " + std::to_string(p.second);
};

// Returns a traced range of elements that have a name.
template <typename T>
auto traced(std::vector<T> elements)
{
  const std::size_t size = elements.size();
  return Traced_range(
    size, [all = std::move(elements)](std::size_t i) -> const T& { return all[i]; },
    [](const T& x) { return name_of(x); });
}

// Returns a traced range of values that are their own names.
template <typename T>
auto traced(std::initializer_list<T> values)
{
  return Traced_range(
    values.size(), [all = std::vector<T>(values)](std::size_t i) { return all[i]; },
    [](const T& x) { return testing::PrintToString(x); });
}

// Returns the numbers from `first` to `end` - 1.
inline auto seeds(unsigned int first, unsigned int end)
{
  return Traced_range(
    end - first, [first](std::size_t i) { return first + static_cast<unsigned int>(i); },
    [](unsigned int seed) { return "seed " + std::to_string(seed); });
}

inline auto seeds(unsigned int end) { return seeds(0, end); }

// Returns each element with each of the seeds 0, ..., n - 1.
template <typename T>
auto traced(std::vector<T> elements, std::size_t n)
{
  const std::size_t size = elements.size() * n;
  return Traced_range(
    size,
    [n, all = std::move(elements)](std::size_t i) {
      return std::pair<const T&, unsigned int>(all[i / n], static_cast<unsigned int>(i % n));
    },
    name_and_seed);
}

// Returns the elements that a function makes of the seeds 0, ..., n - 1, with these seeds.
template <typename Seed, typename Element>
auto traced(std::size_t n, Element (*make)(Seed))
{
  return Traced_range(
    n,
    [make](std::size_t i) {
      return std::pair(make(static_cast<Seed>(i)), static_cast<unsigned int>(i));
    },
    name_and_seed);
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_TESTING_H
