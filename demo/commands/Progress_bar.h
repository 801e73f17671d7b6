// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PROGRESS_BAR_H
#define INTRINSIC_PROGRESS_BAR_H

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Shows on one line of the terminal which of several stages is running. Shows nothing elsewhere.
class Progress_bar
{
public:
  // Draws nothing if `is_quiet` or if standard error is not a terminal.
  explicit Progress_bar(bool is_quiet);

  ~Progress_bar() { clear(); }

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  // Sets the planned stages, each with its own name.
  void set_stages(std::vector<std::string> names) { m_names = std::move(names); }
  const std::vector<std::string>& stages() const { return m_names; }

  // Starts a stage. Stages may come in another order, and again. Throws std::logic_error if none
  // has this name.
  void start_stage(const std::string& name);

  // Counts one more step of the stage; cheap enough for inner loops.
  void step()
  {
    if(++m_steps % 4096 == 0 && m_is_shown)
      draw();
  }

  // Counts one more step, which takes so long that it is shown at once.
  void long_step()
  {
    ++m_steps;
    if(m_is_shown)
      draw();
  }

  // Clears the line for other text.
  void clear() const;

private:
  void draw() const;

  std::vector<std::string> m_names;
  std::size_t m_stage = 0; // the place of the running one
  std::size_t m_steps = 0;
  bool m_is_shown;
};

#endif // INTRINSIC_PROGRESS_BAR_H
