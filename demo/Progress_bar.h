// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PROGRESS_BAR_H
#define INTRINSIC_PROGRESS_BAR_H

#include <cstddef>
#include <string>

// One line on the terminal that tells which of several stages is running; nothing elsewhere.
class Progress_bar
{
public:
  // Draws nothing if `is_quiet` or if standard error is not a terminal.
  Progress_bar(std::size_t number_of_stages, bool is_quiet);

  ~Progress_bar() { clear(); }

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void start_stage(const std::string& name);

  // One more step of the stage; cheap enough for inner loops.
  void step()
  {
    if(++m_steps % 4096 == 0 && m_is_shown)
      draw();
  }

  // Makes room for other text.
  void clear() const;

private:
  void draw() const;

  std::size_t m_number_of_stages;
  std::size_t m_stage = 0;
  std::size_t m_steps = 0;
  std::string m_name;
  bool m_is_shown;
};

#endif // INTRINSIC_PROGRESS_BAR_H
