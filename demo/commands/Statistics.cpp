// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Statistics.h"

#include <sys/resource.h>

Statistics common_statistics(const std::string& command, const std::string& input,
                             const CGAL::Intrinsic_triangulations::Input_diagnosis& diagnosis)
{
  const auto& s = diagnosis.statistics();
  return {{"command", command},
          {"input", input},
          {"vertices", s.vertices},
          {"edges", s.edges},
          {"faces", s.faces},
          {"euler_characteristic", s.euler_characteristic},
          {"boundary_loops", s.boundary_loops},
          {"components", s.components}};
}

std::string text_of(const Statistics& statistics)
{
  return statistics.dump(2, ' ', false, Statistics::error_handler_t::replace) + "\n";
}

void describe_subdivision(Statistics& statistics, std::size_t vertices, std::size_t edges,
                          std::size_t faces)
{
  statistics["subdivision"] = {{"vertices", vertices}, {"edges", edges}, {"faces", faces}};
}

std::size_t peak_memory_in_bytes()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}
