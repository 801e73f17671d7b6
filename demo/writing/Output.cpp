// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Output.h"

#include "Program_error.h"

#include <iostream>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace {

bool are_same(const fs::path& a, const fs::path& b)
{
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || fs::weakly_canonical(a) == fs::weakly_canonical(b);
}

void check_can_be_created(const std::string& path)
{
  const fs::path folder = fs::absolute(path).parent_path();
  if(fs::is_directory(path))
    throw Program_error(path + ": is a directory; name a file in it");
  if(!fs::is_directory(folder))
    throw Program_error(path + ": there is no directory " + folder.string() + "; create it first");
}

void check(const fs::path& input, const std::string& path)
{
  if(path.empty() || path == "-")
    return;
  if(are_same(input, path))
    throw Program_error(path + ": is the input, which is never overwritten; name another file");
  check_can_be_created(path);
}

} // namespace

Output::Output(const fs::path& input, const std::vector<std::string>& paths)
{
  for(std::size_t i = 0; i < paths.size(); ++i) {
    check(input, paths[i]);
    for(std::size_t j = 0; j < i; ++j)
      if(!paths[i].empty() && (paths[i] == paths[j] || are_same(paths[i], paths[j])))
        throw Program_error(paths[i] + ": is named for two outputs; give each its own name");
  }
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
