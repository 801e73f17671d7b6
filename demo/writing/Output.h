// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_H
#define INTRINSIC_OUTPUT_H

#include "commands/options.h"
#include "writing/Text.h"

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
  // Checks that no path leads to a file that is read, also by links, that no two are equal and that
  // each can be created. Empty paths are outputs that are not requested.
  // Throws Program_error if a check fails.
  Output(const std::vector<Read_file>& read_files, const std::vector<std::string>& paths);

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
