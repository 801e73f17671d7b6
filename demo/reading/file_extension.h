// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FILE_EXTENSION_H
#define INTRINSIC_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

inline std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// With its dot, in lower case.
inline std::string extension_of(const std::filesystem::path& path)
{
  return lower_case(path.extension().string());
}

#endif // INTRINSIC_FILE_EXTENSION_H
