// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_H
#define INTRINSIC_OUTPUT_H

#include "writing/Text.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class Atomic_file;

// Writes the files of a command: all appear together at the end, none after a failure.
// The path "-" denotes standard output.
class Output
{
public:
  // Checks that the input is not among the paths, that no two are equal and that each can be
  // created. Empty paths are outputs that are not requested.
  // Throws Program_error if a check fails.
  Output(const std::filesystem::path& input, const std::vector<std::string>& paths);

  ~Output();

  // Adds an output, whose content `write(text)` adds to a text. Throws std::runtime_error if the
  // file cannot be written.
  void add(const std::string& path, const std::function<void(Text&)>& write);

  // Discards all outputs that have been added.
  void clear();

  // Writes all outputs. Throws std::runtime_error if not everything could be written.
  void commit();

private:
  std::vector<std::unique_ptr<Atomic_file>> m_files;
  std::string m_standard_output;
};

#endif // INTRINSIC_OUTPUT_H
