// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress_bar.h"

#include <iostream>

#include <unistd.h>

Progress_bar::Progress_bar(std::size_t number_of_stages, bool is_quiet)
  : m_number_of_stages(number_of_stages), m_is_shown(!is_quiet && ::isatty(STDERR_FILENO) == 1)
{}

void Progress_bar::start_stage(const std::string& name)
{
  ++m_stage;
  m_steps = 0;
  m_name = name;
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
  const std::size_t done = width * (m_stage - 1) / m_number_of_stages;
  std::cerr << "\r\033[K[" << std::string(done, '#') << std::string(width - done, ' ') << "] "
            << m_name;
  if(m_steps > 0)
    std::cerr << ": " << m_steps;
  std::cerr << std::flush;
}
