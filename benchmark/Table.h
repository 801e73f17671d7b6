// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_TABLE_H
#define INTRINSIC_BENCHMARK_TABLE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

// Prints a table in Markdown, which scripts/make_tables.py copies into the manual. The first
// columns are names, the others figures.
class Table
{
public:
  explicit Table(const std::vector<std::string>& headings, std::size_t names = 1)
  {
    std::vector<std::string> rule(headings.size(), "---:");
    std::fill_n(rule.begin(), names, "---");
    std::printf("\n");
    print(headings);
    print(rule);
  }

  template <typename... Cells>
  void row(const Cells&... cells) const
  {
    print({text(cells)...});
  }

  static void print(const std::vector<std::string>& cells)
  {
    for(const std::string& cell : cells)
      std::printf("| %s ", cell.c_str());
    std::printf("|\n");
    std::fflush(stdout);
  }

  // Returns an integer with separators of thousands, or a number with three digits.
  template <typename Cell>
  static std::string text(const Cell& cell)
  {
    if constexpr(std::is_integral_v<Cell>)
      return separated(std::to_string(cell));
    else if constexpr(std::is_floating_point_v<Cell>)
      return rounded(cell);
    else
      return cell;
  }

private:
  static std::string separated(std::string digits)
  {
    for(std::size_t n = 3; n + (digits[0] == '-') < digits.size(); n += 4)
      digits.insert(digits.size() - n, ",");
    return digits;
  }

  static std::string rounded(double x)
  {
    const double size = std::abs(x);
    if(!std::isfinite(x))
      return std::to_string(x);
    if(size >= 999.5)
      return separated(std::to_string(std::llround(x)));
    const int digits = x == 0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(1.0005 * size)));
    char result[32];
    std::snprintf(result, sizeof result, size >= 1e-3 || x == 0 ? "%.*f" : "%.*e",
                  size >= 1e-3 || x == 0 ? digits : 1, x);
    return result;
  }
};

// Returns the name of a mesh in a table.
inline std::string name_of(const std::string& file)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  return name.substr(0, name.find_last_of('.'));
}

#endif // INTRINSIC_BENCHMARK_TABLE_H
