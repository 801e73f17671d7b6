// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/attempts.h"

#include "Program_error.h"
#include "commands/triangulation_stages.h"

#include <iostream>
#include <string>

namespace {

using CGAL::Intrinsic_triangulations::Numerical_error;

struct Slack
{
  const char* name;
  double epsilon;
};
constexpr Slack slacks[] = {{"1e-8", 1e-8}, {"1e-6", 1e-6}};

// Returns whether the lengths of the edges may be changed.
bool can_be_mollified(const Common_options& options)
{
  return !options.is_exact && !options.is_strict && options.mollification == 0;
}

int compute_with_longer_edges(Command_run& run, const std::function<int()>& compute,
                              const Numerical_error& e)
{
  std::string advice;
  for(const auto& [name, epsilon] : slacks) {
    run.restart(epsilon);
    if(length_of_mollification(run) == 0)
      continue;
    try {
      const int result = compute();
      std::cerr << run.options().input << ": computed with --mollify " << name << ": " << e.what()
                << '\n';
      return result;
    } catch(const Numerical_error&) {
      advice = std::string("; --mollify ") + name + " gives no result either";
    }
  }
  throw Numerical_error(e.what() + advice);
}

} // namespace

int attempt(Command_run& run, const std::function<int()>& compute)
{
  if(!can_be_mollified(run.options()))
    return compute();
  try {
    return compute();
  } catch(const Map_failure& e) {
    throw Map_failure(e.what() + std::string(", or --mollify 1e-8 for slightly longer edges"));
  } catch(const Numerical_error& e) {
    return compute_with_longer_edges(run, compute, e);
  }
}
