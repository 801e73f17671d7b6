// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STATISTICS_H
#define INTRINSIC_STATISTICS_H

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <string>

// Stores the report of a command, in the order of additions. Numbers that are not finite become
// null.
using Statistics = nlohmann::ordered_json;

// Returns the keys that all commands share.
Statistics common_statistics(const std::string& command, const std::string& input,
                             const CGAL::Intrinsic_triangulations::Input_diagnosis& diagnosis);

// Returns the statistics as text. A file name that is not UTF-8 is converted.
std::string text_of(const Statistics& statistics);

// Adds the size of a common subdivision.
void describe_subdivision(Statistics& statistics, std::size_t vertices, std::size_t edges,
                          std::size_t faces);

std::size_t peak_memory_in_bytes();

class Stopwatch
{
  using Clock = std::chrono::steady_clock;

public:
  // Returns the seconds since the construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

private:
  Clock::time_point m_start = Clock::now();
};

#endif // INTRINSIC_STATISTICS_H
