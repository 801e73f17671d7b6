// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Atomic_file.h"

#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace {

bool is_replaceable(const std::filesystem::path& path)
{
  return !std::filesystem::exists(path) || std::filesystem::is_regular_file(path);
}

} // namespace

Atomic_file::Atomic_file(const std::filesystem::path& path)
  : m_path(std::filesystem::weakly_canonical(path)), // a link stays one
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
    std::filesystem::remove(m_temporary, ignored);
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
    std::filesystem::rename(m_temporary, m_path);
  m_is_committed = true;
}
