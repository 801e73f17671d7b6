// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_MEASURE_H
#define INTRINSIC_BENCHMARK_MEASURE_H

#include <algorithm>
#include <ctime>
#include <vector>

#include <malloc.h>

// Measures CPU times of one task, in milliseconds, which exclude other processes of the machine.
class Samples
{
public:
  // Runs a task and returns its result.
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

  // Returns the least time, in which other programs affect the caches least.
  double least() const { return *std::min_element(m_samples.begin(), m_samples.end()); }

private:
  std::vector<double> m_samples;
};

// Keeps freed memory in the process.
inline void keep_memory()
{
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
}

#endif // INTRINSIC_BENCHMARK_MEASURE_H
