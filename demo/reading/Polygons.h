// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_POLYGONS_H
#define INTRINSIC_POLYGONS_H

#include <boost/iterator/iterator_facade.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

// Stores polygons, or lines, as indices of points in one array.
class Polygons
{
public:
  typedef std::uint32_t Index;

  class Polygon
  {
  public:
    Polygon(const Index* begin, const Index* end) : m_begin(begin), m_end(end) {}

    const Index* begin() const { return m_begin; }
    const Index* end() const { return m_end; }
    std::size_t size() const { return static_cast<std::size_t>(m_end - m_begin); }
    Index operator[](std::size_t i) const { return m_begin[i]; }

  private:
    const Index* m_begin;
    const Index* m_end;
  };

  class Iterator
    : public boost::iterator_facade<Iterator, Polygon, boost::forward_traversal_tag, Polygon>
  {
  public:
    Iterator(const Polygons& polygons, std::size_t i) : m_polygons(&polygons), m_i(i) {}

  private:
    friend class boost::iterator_core_access;

    Polygon dereference() const { return (*m_polygons)[m_i]; }
    bool equal(const Iterator& other) const { return m_i == other.m_i; }
    void increment() { ++m_i; }

    const Polygons* m_polygons;
    std::size_t m_i;
  };

  Polygons() = default;

  // Makes triangles of integers. Negative ones name no point.
  // Throws std::length_error if indices do not suffice for the corners.
  template <class Integer>
  static Polygons of_triangles(const Integer* first, const Integer* last)
  {
    Polygons result;
    result.m_indices.resize(static_cast<std::size_t>(last - first));
    std::transform(first, last, result.m_indices.begin(),
                   [](Integer i) { return index_of(static_cast<std::size_t>(i)); });
    result.m_ends.resize(result.m_indices.size() / 3 + 1);
    for(std::size_t i = 0; i < result.m_ends.size(); ++i)
      result.m_ends[i] = end_of(3 * i);
    return result;
  }

  // No point has this index.
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::size_t size() const { return m_ends.size() - 1; }
  bool empty() const { return size() == 0; }
  std::size_t number_of_corners() const { return m_indices.size(); }
  // Returns the polygon of a corner, counted over all polygons. Complexity: logarithmic in their
  // number.
  std::int64_t polygon_of_corner(std::size_t corner) const
  {
    return std::upper_bound(m_ends.begin(), m_ends.end(), corner) - m_ends.begin() - 1;
  }
  // Returns the corners of all polygons, in their order.
  const std::vector<Index>& corners() const { return m_indices; }

  Polygon operator[](std::size_t i) const
  {
    return {m_indices.data() + m_ends[i], m_indices.data() + m_ends[i + 1]};
  }

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  void reserve(std::size_t polygons, std::size_t corners)
  {
    m_ends.reserve(polygons + 1);
    m_indices.reserve(corners);
  }

  // Adds a corner to the polygon that is not closed yet.
  void add_corner(std::size_t index) { m_indices.push_back(index_of(index)); }

  // Closes the polygon. Throws std::length_error if indices do not suffice for the corners.
  void close() { m_ends.push_back(end_of(m_indices.size())); }

  template <class Range>
  void push_back(const Range& polygon)
  {
    for(const auto index : polygon)
      add_corner(index);
    close();
  }

private:
  static Index index_of(std::size_t i) { return i < none ? static_cast<Index>(i) : none; }

  static Index end_of(std::size_t corners)
  {
    if(corners >= none)
      throw std::length_error("too many corners");
    return static_cast<Index>(corners);
  }

  std::vector<Index> m_indices;
  std::vector<Index> m_ends = {0};
};

#endif // INTRINSIC_POLYGONS_H
