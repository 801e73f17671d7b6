// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ATOMIC_FILE_H
#define INTRINSIC_ATOMIC_FILE_H

#include <filesystem>
#include <fstream>
#include <string>

// A file that appears under its name when it is complete, or not at all.
// What is not a regular file, such as a pipe, is written to directly.
class Atomic_file
{
public:
  // Throws std::runtime_error if the file cannot be created.
  explicit Atomic_file(const std::filesystem::path& path);

  ~Atomic_file();

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  std::ostream& stream() { return m_stream; }

  // Nothing is written any more. Throws std::runtime_error if not everything could be.
  void close();

  // Gives the closed file its name. Throws std::runtime_error if that fails.
  void commit();

private:
  std::filesystem::path m_path;
  std::filesystem::path m_temporary; // is m_path if that is not a regular file
  std::ofstream m_stream;
  bool m_is_committed = false;
};

#endif // INTRINSIC_ATOMIC_FILE_H
