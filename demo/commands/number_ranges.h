// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_NUMBER_RANGES_H
#define INTRINSIC_NUMBER_RANGES_H

#include "reading/Scanner.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

// Defines validators like the validators of CLI11, whose messages name a range as people write it.

namespace Number_range_details {

inline bool parse(const std::string& text, double& x)
{
  const std::optional<double> number = ::finite_number(text);
  x = number.value_or(0);
  return number.has_value();
}

// Writes the number without leading zeros, which CLI11 would take for an octal number.
inline bool parse(std::string& text, std::uint64_t& x)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  text = is_number ? std::to_string(x) : text;
  return is_number;
}

// Returns the validator of a range, which does not contain NaN.
template <class Number>
CLI::Validator range(Number least, Number most, const std::string& description)
{
  const auto check = [=](std::string& text) {
    Number x{};
    const bool is_in_range = parse(text, x) && least <= x && x <= most;
    return is_in_range ? std::string() : "'" + text + "' is not " + description;
  };
  return CLI::Validator(check, description, "");
}

inline std::string text(double x)
{
  std::ostringstream result;
  result << x;
  return result.str();
}

} // namespace Number_range_details

inline CLI::Validator number_from_to(double least, double most)
{
  namespace Details = Number_range_details;
  return Details::range(least, most,
                        "a number from " + Details::text(least) + " to " + Details::text(most));
}

inline CLI::Validator positive_number()
{
  return Number_range_details::range(std::numeric_limits<double>::denorm_min(),
                                     (std::numeric_limits<double>::max)(), "a number above 0");
}

inline CLI::Validator number_above_one()
{
  return Number_range_details::range(1 + std::numeric_limits<double>::epsilon(),
                                     (std::numeric_limits<double>::max)(), "a number above 1");
}

inline CLI::Validator nonnegative_number()
{
  return Number_range_details::range(0., (std::numeric_limits<double>::max)(),
                                     "a number from 0 upwards");
}

inline CLI::Validator finite_number()
{
  return Number_range_details::range(std::numeric_limits<double>::lowest(),
                                     (std::numeric_limits<double>::max)(), "a finite number");
}

inline CLI::Validator integer_from_to(std::uint64_t least, std::uint64_t most)
{
  return Number_range_details::range(
    least, most, "an integer from " + std::to_string(least) + " to " + std::to_string(most));
}

inline CLI::Validator integer_from(std::uint64_t least)
{
  return Number_range_details::range(least, (std::numeric_limits<std::uint64_t>::max)(),
                                     "an integer from " + std::to_string(least) + " upwards");
}

#endif // INTRINSIC_NUMBER_RANGES_H
