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

// Stores names of stages, in their order.
using Stages = std::vector<std::string>;

// Provides the common parts of commands on intrinsic triangulations. They read a mesh, run timed
// stages, gather statistics, and let all files appear together at the end.
class Command_run
{
public:
  // Reads the input, after the paths of the command, `outputs`, and the common paths are checked.
  // It must be a surface, unless soups are allowed.
  // Throws Program_error as `Output` and `read_input()` do.
  Command_run(const std::string& command, const Common_options& options,
              std::vector<std::string> outputs, bool are_soups_allowed = false);

  // Discards all results since the input was read, in order to compute another result. Lengths of
  // edges are mollified by `epsilon` unless it is zero.
  void restart(double epsilon);

  // Sets the stages after the input has been read, except the last, "write".
  void plan(const std::vector<Stages>& parts);

  const Common_options& options() const { return m_options; }
  Input_mesh& input() { return m_input; }
  const Input_mesh& input() const { return m_input; }
  // Frees all data of the input except for points, unless a page or a picture is requested.
  void keep_points_only();
  // Throws Program_error if a vertex has no face.
  void refuse_isolated_vertices() const;
  // Returns the index of the component that the options choose, or zero.
  std::size_t index_of_component() const { return m_component; }
  // Returns the points and faces of the input, without the faces of its cover.
  Output_mesh input_as_read() const;
  Progress_bar& progress() { return m_progress; }
  Statistics& statistics() { return m_statistics; }

  // Begins a stage that lasts until the next one. The seconds of stages with the same name are
  // added up.
  void start_stage(const std::string& name);

  // Returns the result of `stage()`, which is a separate stage.
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

  // Adds the output `path`, but does nothing if the path is empty.
  void add_output(const std::string& path, const std::string& content)
  {
    m_output.add(path, [&](Text& text) { text << content; });
  }
  // Adds the output that `write(text)` writes.
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

  // Calls `add(page)`, which adds the result to a page or a picture, if one is requested.
  template <class Add>
  void show(const Add& add)
  {
    if(m_page)
      add(*m_page);
  }

  // Adds the statistics to the files, makes these appear and prints the summary.
  // Throws std::logic_error if a planned stage has not been started.
  void finish(const std::string& summary);

private:
  void read(bool is_quiet);
  void describe_input();
  void keep_chosen_component();
  void choose_section();
  void describe_cover();
  void write_page();

  // Maps faces of the cover, or faces that were kept, to faces of the input. Names the polygons
  // that contain these faces.
  Output_mesh with_input_faces(Output_mesh mesh) const;

  // Ends the stage, but does nothing if none has been started.
  void end_stage();

  const std::string m_command;
  Common_options m_options;
  Output m_output;
  Progress_bar m_progress;
  Input_mesh m_input;
  std::size_t m_component = 0; // that the options choose
  Statistics m_statistics_of_input, m_statistics;
  Statistics m_seconds;
  std::optional<View_page> m_page;          // if a page or a picture is wanted
  std::optional<Picture_section> m_section; // of the picture
  std::string m_stage;                      // that was started; empty if it has ended
  Stopwatch m_watch;                        // of the stage
};

#endif // INTRINSIC_COMMAND_RUN_H
