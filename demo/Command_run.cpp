// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Command_run.h"

#include <iostream>
#include <stdexcept>
#include <utility>

namespace {

std::vector<std::string> all_outputs(std::vector<std::string> outputs,
                                     const Common_options& options)
{
  outputs.push_back(options.save);
  outputs.push_back(options.statistics);
  outputs.push_back(options.view);
  outputs.push_back(options.picture);
  return outputs;
}

} // namespace

Command_run::Command_run(const std::string& command, const Common_options& options,
                         std::vector<std::string> outputs)
  : m_options(options),
    m_output(options.input, all_outputs(std::move(outputs), options)),
    m_progress(options.is_quiet)
{
  if(!options.view.empty())
    View_page::check_available();
  if(!options.view.empty() || !options.picture.empty())
    m_page.emplace();
  read(command);
}

// Has no progress bar: repairs and notes are printed meanwhile.
void Command_run::read(const std::string& command)
{
  {
    const Timer timer(m_seconds["read"]);
    m_input = read_input(m_options.input, {m_options.is_repair_wanted, m_options.mollification > 0},
                         m_options.is_quiet);
  }
  m_statistics = common_statistics(command, m_options.input, m_input.diagnosis);
  for(const auto& [what, count] : m_input.repairs)
    m_statistics["repairs"][what] = count;
}

void Command_run::plan(const std::vector<Stages>& parts)
{
  Stages all;
  for(const Stages& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  all.push_back("write");
  m_progress.set_stages(std::move(all));
}

// Without what differs between runs.
void Command_run::write_page()
{
  show([&](View_page& page) {
    page.set_statistics(m_statistics);
    m_output.add(m_options.view, [&](Text& text) { page.write_html(text); });
    m_output.add(m_options.picture, [&](Text& text) { page.write_svg(text); });
  });
}

void Command_run::finish(const std::string& summary)
{
  for(const std::string& stage : m_progress.stages())
    if(!m_seconds.contains(stage))
      throw std::logic_error("the stage '" + stage + "' has not come");
  write_page();
  m_statistics["seconds"] = m_seconds;
  m_statistics["peak_memory_bytes"] = peak_memory_in_bytes();
  add_output(m_options.statistics, text_of(m_statistics));
  m_progress.clear();
  m_output.commit();
  if(!m_options.is_quiet)
    std::cerr << m_options.input << ": " << summary << '\n';
}
