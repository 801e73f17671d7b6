// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Output.h"

#include "Program_error.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace fs = std::filesystem;

namespace {

bool is_replaceable(const fs::path& path) { return !fs::exists(path) || fs::is_regular_file(path); }

// Returns the absolute path without links. It is unchanged if it is empty, or names a pipe.
fs::path resolved(const fs::path& path)
{
  std::error_code failed;
  const fs::path result = path.empty() ? path : fs::weakly_canonical(fs::absolute(path), failed);
  return failed ? path : result;
}

bool are_same(const fs::path& a, const fs::path& b)
{
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || resolved(a) == resolved(b);
}

void check_can_be_created(const std::string& path)
{
  const fs::path folder = fs::absolute(path).parent_path();
  if(fs::is_directory(path))
    throw Program_error(path + ": is a directory; name a file in it");
  if(!fs::is_directory(folder))
    throw Program_error(path + ": there is no directory " + folder.string() + "; create it first");
}

// Checks that the output does not replace a file that is read. Devices such as /dev/null may be
// both.
void check_is_not_read(const std::string& path, const std::vector<Read_file>& read_files)
{
  std::error_code ignored;
  for(const Read_file& file : read_files)
    if(fs::is_regular_file(path, ignored) && fs::equivalent(file.path, path, ignored))
      throw Program_error(path + ": is the input" +
                          (file.option == "mesh" ? "" : " of " + file.option) +
                          ", which is never overwritten; name another file");
}

void check(const std::vector<Read_file>& read_files, const std::string& path)
{
  if(path.empty() || path == "-")
    return;
  check_is_not_read(path, read_files);
  check_can_be_created(path);
}

} // namespace

// Writes a file that appears under its name when it is complete, or not at all. A file that is not
// regular, such as a pipe, is written to directly.
class Atomic_file
{
public:
  // Throws std::runtime_error if the file cannot be created.
  explicit Atomic_file(const fs::path& path);

  ~Atomic_file();

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  std::ostream& stream() { return m_stream; }

  // Closes the file. Throws std::runtime_error if not everything could be written.
  void close();

  // Renames the closed file. Throws std::runtime_error if this fails.
  void commit();

private:
  fs::path m_path;
  fs::path m_temporary; // is m_path if that is not a regular file
  std::ofstream m_stream;
  bool m_is_committed = false;
};

Atomic_file::Atomic_file(const fs::path& path)
  : m_path(resolved(path)), // a link stays one
    m_temporary(m_path)
{
  if(is_replaceable(m_path))
    m_temporary.replace_filename("." + m_path.filename().string() + "." +
                                 std::to_string(::getpid()) + ".part");
  m_stream.open(m_temporary, std::ios::binary);
  if(!m_stream)
    throw std::runtime_error(path.string() +
                             ": cannot be written; are you allowed to write to its directory?");
}

Atomic_file::~Atomic_file()
{
  std::error_code ignored;
  if(!m_is_committed && m_temporary != m_path)
    fs::remove(m_temporary, ignored);
}

void Atomic_file::close()
{
  m_stream.close();
  if(!m_stream)
    throw std::runtime_error(m_path.string() +
                             ": could not be written completely; is the disk full?");
}

void Atomic_file::commit()
{
  if(m_temporary != m_path)
    fs::rename(m_temporary, m_path);
  m_is_committed = true;
}

Output::Output(const std::vector<Read_file>& read_files, const std::vector<std::string>& paths)
{
  for(std::size_t i = 0; i < paths.size(); ++i) {
    check(read_files, paths[i]);
    for(std::size_t j = 0; j < i; ++j)
      if(!paths[i].empty() && (paths[i] == paths[j] || are_same(paths[i], paths[j])))
        throw Program_error(paths[i] + ": is named for two outputs; give each its own name");
  }
}

Output::~Output() = default;

void Output::clear()
{
  m_files.clear();
  m_standard_output.clear();
}

void Output::add(const std::string& path, const std::function<void(Text&)>& write)
{
  if(path.empty())
    return;
  if(path == "-") {
    Text text;
    write(text);
    m_standard_output += text.take();
    return;
  }
  m_files.push_back(std::make_unique<Atomic_file>(path));
  Text text(m_files.back()->stream());
  write(text);
}

void Output::commit()
{
  for(const std::unique_ptr<Atomic_file>& file : m_files)
    file->close();
  if(!(std::cout << m_standard_output << std::flush))
    throw std::runtime_error(
      "standard output could not be written completely; is its reader gone, or a "
      "disk full?");
  for(const std::unique_ptr<Atomic_file>& file : m_files)
    file->commit();
}
