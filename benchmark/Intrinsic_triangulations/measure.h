// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_MEASURE_H
#define INTRINSIC_BENCHMARK_MEASURE_H

#include <algorithm>
#include <ctime>
#include <vector>

#include <malloc.h>

// CPU times of one task, in milliseconds: what else the machine does is not in them.
class Samples
{
public:
  // Runs a task and returns what it returns.
  template <typename Task>
  auto time(const Task& task)
  {
    const std::clock_t start = std::clock();
    auto result = task();
    m_samples.push_back(1000. * double(std::clock() - start) / CLOCKS_PER_SEC);
    return result;
  }

  double median() const
  {
    std::vector<double> sorted(m_samples);
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

  // What other programs do to the caches is least in this one.
  double least() const { return *std::min_element(m_samples.begin(), m_samples.end()); }

private:
  std::vector<double> m_samples;
};

// Memory that has been freed stays with the process.
inline void keep_memory()
{
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
}

#endif // INTRINSIC_BENCHMARK_MEASURE_H
