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

// What a command reports about its work, in the order in which it was reported.
// Numbers that are not finite become null.
using Statistics = nlohmann::ordered_json;

// The keys that all commands share.
Statistics common_statistics(const std::string& command, const std::string& input,
                             const CGAL::Intrinsic_triangulations::Input_diagnosis& diagnosis);

// As text; a file name that is not UTF-8 is made so.
std::string text_of(const Statistics& statistics);

// Adds the size of a common subdivision.
void describe_subdivision(Statistics& statistics, std::size_t vertices, std::size_t edges,
                          std::size_t faces);

std::size_t peak_memory_in_bytes();

class Stopwatch
{
  using Clock = std::chrono::steady_clock;

public:
  // Since the construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

private:
  Clock::time_point m_start = Clock::now();
};

#endif // INTRINSIC_STATISTICS_H
