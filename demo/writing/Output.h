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

// The files a command writes: all appear together at the end, none after a failure.
// The path "-" stands for standard output.
class Output
{
public:
  // Checks that the input is not among the paths, that no two are the same and that each can be
  // created; empty paths stand for outputs that are not wanted.
  // Throws Program_error if not.
  Output(const std::filesystem::path& input, const std::vector<std::string>& paths);

  ~Output();

  // `write(text)` adds the content to a text. Throws std::runtime_error if the file cannot be
  // written.
  void add(const std::string& path, const std::function<void(Text&)>& write);

  // Forgets what has been added.
  void clear();

  // Throws std::runtime_error if not everything could be written.
  void commit();

private:
  std::vector<std::unique_ptr<Atomic_file>> m_files;
  std::string m_standard_output;
};

#endif // INTRINSIC_OUTPUT_H
