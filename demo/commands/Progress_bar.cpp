// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Progress_bar.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

Progress_bar::Progress_bar(bool is_quiet) : m_is_shown(!is_quiet && ::isatty(STDERR_FILENO) == 1) {}

void Progress_bar::start_stage(const std::string& name)
{
  const auto known = std::find(m_names.begin(), m_names.end(), name);
  if(known == m_names.end())
    throw std::logic_error("the stage '" + name + "' is not planned");
  m_stage = static_cast<std::size_t>(known - m_names.begin());
  m_steps = 0;
  if(m_is_shown)
    draw();
}

void Progress_bar::clear() const
{
  if(m_is_shown)
    std::cerr << "\r\033[K" << std::flush;
}

void Progress_bar::draw() const
{
  constexpr std::size_t width = 30;
  const std::size_t done = width * m_stage / m_names.size();
  std::cerr << "\r\033[K[" << std::string(done, '#') << std::string(width - done, ' ') << "] "
            << m_names[m_stage];
  if(m_steps > 0)
    std::cerr << ": " << m_steps;
  std::cerr << std::flush;
}
