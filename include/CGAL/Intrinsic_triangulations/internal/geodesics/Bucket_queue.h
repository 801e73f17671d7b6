// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_BUCKET_QUEUE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_BUCKET_QUEUE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <limits>
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_BUCKET_QUEUE_H
