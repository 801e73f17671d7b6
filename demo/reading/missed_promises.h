// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MISSED_PROMISES_H
#define INTRINSIC_MISSED_PROMISES_H

#include <CGAL/Discrete_conformal_maps/Map_promise.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

// Describes the promises that a map has missed. Each part begins with "; ".
inline std::string
missed_promises(const std::vector<CGAL::Discrete_conformal_maps::Map_promise>& promises)
{
  using CGAL::Discrete_conformal_maps::Map_status;
  std::ostringstream text;
  std::string unknown;
  for(const auto& p : promises)
    if(p.is_kept())
      continue;
    else if(p.if_missed == Map_status::not_laid_out)
      text << "; nothing is laid out";
    else if(std::isnan(p.error))
      unknown +=
        (unknown.empty() ? "; errors that cannot be measured: " : ", ") + std::string(p.name);
    else
      text << "; error of " << p.name << ": " << p.error << ", at most " << p.bound;
  return text.str() + unknown;
}

#endif // INTRINSIC_MISSED_PROMISES_H
