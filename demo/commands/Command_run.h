// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMAND_RUN_H
#define INTRINSIC_COMMAND_RUN_H

#include "commands/Progress_bar.h"
#include "commands/Statistics.h"
#include "commands/options.h"
#include "page/View_page.h"
#include "reading/Input_mesh.h"
#include "writing/Mesh_writer.h"
#include "writing/Output.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// Names of stages, in their order.
using Stages = std::vector<std::string>;

// What the commands on intrinsic triangulations do alike: they read a mesh, go through stages, each
// of them timed, gather statistics, and let all files appear together at the end.
class Command_run
{
public:
  // Reads the input, after the paths of the command, `outputs`, and the common ones are checked. It
  // must be a surface, unless soups are allowed.
  // Throws Program_error as `Output` and `read_input()` do.
  Command_run(const std::string& command, const Common_options& options,
              std::vector<std::string> outputs, bool are_soups_allowed = false);

  // Forgets what came after the input had been read; another result is to be computed, with
  // lengths of edges mollified by `epsilon` unless it is zero.
  void restart(double epsilon);

  // Lets a map that is no success be written.
  void set_failure_expected(bool is_expected) { m_options.is_failure_expected = is_expected; }

  // Sets the stages after the input has been read, except the last, "write".
  void plan(const std::vector<Stages>& parts);

  const Common_options& options() const { return m_options; }
  Input_mesh& input() { return m_input; }
  const Input_mesh& input() const { return m_input; }
  // Frees what the input has beside points, unless a page or a picture is wanted.
  void keep_points_only();
  // The points and faces of the input, without the faces of its cover.
  Output_mesh input_as_read() const;
  Progress_bar& progress() { return m_progress; }
  Statistics& statistics() { return m_statistics; }

  // Begins a stage that lasts until the next. The seconds of stages with one name are added up.
  void start_stage(const std::string& name);

  // Returns what `stage()` returns, a stage of its own.
  template <class Stage>
  auto timed(const std::string& name, const Stage& stage)
  {
    struct End
    {
      Command_run& run;
      ~End() { run.end_stage(); }
    };
    start_stage(name);
    const End end{*this};
    return stage();
  }

  // Nothing if the path is empty.
  void add_output(const std::string& path, const std::string& content)
  {
    m_output.add(path, [&](Text& text) { text << content; });
  }
  // Calls `write(text)`.
  void add_output(const std::string& path, const std::function<void(Text&)>& write)
  {
    m_output.add(path, write);
  }
  void add_output(const std::string& path, const Output_mesh& mesh, Mesh_format format)
  {
    m_output.add(path, [&](Text& text) {
      if(m_input.covered || !m_input.parents.empty() || !m_input.kept_faces.empty())
        write(text, with_input_faces(mesh), format);
      else
        write(text, mesh, format);
    });
  }

  // Calls `add(page)` with what shows the result in a page or a picture, if one is wanted.
  template <class Add>
  void show(const Add& add)
  {
    if(m_page)
      add(*m_page);
  }

  // Adds the statistics to the files, makes these appear and prints the summary.
  // Throws std::logic_error if a stage that was planned has not come.
  void finish(const std::string& summary);

private:
  void read(bool is_quiet);
  void describe_input();
  void keep_chosen_component();
  void choose_section();
  void describe_cover();
  void write_page();

  // Takes faces of the cover, or those that were kept, to those of the input, and names the
  // polygons that these are parts of.
  Output_mesh with_input_faces(Output_mesh mesh) const;

  // Nothing if none has been started.
  void end_stage();

  const std::string m_command;
  Common_options m_options;
  Output m_output;
  Progress_bar m_progress;
  Input_mesh m_input;
  Statistics m_statistics_of_input, m_statistics;
  Statistics m_seconds;
  std::optional<View_page> m_page;          // if a page or a picture is wanted
  std::optional<Picture_section> m_section; // of the picture
  std::string m_stage;                      // that was started; empty if it has ended
  Stopwatch m_watch;                        // of the stage
};

#endif // INTRINSIC_COMMAND_RUN_H
