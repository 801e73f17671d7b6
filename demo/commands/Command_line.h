// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMAND_LINE_H
#define INTRINSIC_COMMAND_LINE_H

#include "commands/number_ranges.h"
#include "commands/options.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <utility>

// Adds an option for one or several files that the command reads. No output may replace them.
template <class Paths>
CLI::Option* add_read_file(CLI::App& command, Common_options& common, const std::string& name,
                           Paths& paths, const std::string& what)
{
  return command.add_option(name, paths, what)->each([&common, name](const std::string& path) {
    common.read_files.push_back({name, path});
  });
}

// Throws Program_error if a format is given, and no mesh is written to standard output.
void check_format(const CLI::App& command);

// Stores the possible arguments of the command line, and the command that is called.
class Command_line
{
public:
  // Declares all commands.
  Command_line();

  CLI::App& app() { return m_app; }
  Common_options& common() { return m_common; }

  // Runs the command that is called, and returns its exit code.
  int run() const { return m_run(); }

  // Adds a command with its own options, which it returns. `help` follows their description.
  template <class Own_options>
  std::pair<CLI::App&, Own_options&> add(const char* name, const char* description,
                                         int (*run)(const Common_options&, const Own_options&),
                                         const char* help)
  {
    const auto options = std::make_shared<Own_options>();
    CLI::App& command = *m_app.add_subcommand(name, description);
    command.callback([=, &command] {
      m_run = [=, &command] {
        check_format(command);
        return run(m_common, *options);
      };
    });
    command.footer(help);
    return {command, *options};
  }

  // Adds a command whose input is a mesh.
  template <class Own_options>
  std::pair<CLI::App&, Own_options&>
  add_with_mesh(const char* name, const char* description,
                int (*run)(const Common_options&, const Own_options&), const char* help)
  {
    const auto result = add(name, description, run, help);
    add_read_file(result.first, m_common, "mesh", m_common.input,
                  "Mesh (.off, .obj, .ply, .stl, .vtp)")
      ->required();
    return result;
  }

private:
  CLI::App m_app;
  Common_options m_common;
  std::function<int()> m_run;
};

// ---- The commands, each of which declares itself ----

void define_info(Command_line& line);
void define_view(Command_line& line);
void define_delaunay(Command_line& line);
void define_refine(Command_line& line);
void define_distance(Command_line& line);
void define_path(Command_line& line);
void define_transfer(Command_line& line);
void define_operators(Command_line& line);
void define_flatten(Command_line& line);
void define_hyperbolic(Command_line& line);
void define_uniformize(Command_line& line);
void define_sphere(Command_line& line);
void define_convex(Command_line& line);
void define_pack(Command_line& line);
void define_simplify(Command_line& line);

// ---- Options that several commands have ----

// Adds an option with a number in a range.
template <class Number>
CLI::Option* add_number(CLI::App& command, const std::string& name, Number& number,
                        const std::string& what, const CLI::Validator& range)
{
  return command.add_option(name, number, what)->transform(range);
}

void add_output(CLI::App& command, Output_options& options, const std::string& what,
                const std::string& formats);
void add_common_options(CLI::App& command, Common_options& options);
void add_statistics(CLI::App& command, Common_options& options);
// Adds the options about the input: about its lengths, and about its triangles.
void add_mollification(CLI::App& command, Common_options& options);
void add_repair(CLI::App& command, Common_options& options);
void add_save(CLI::App& command, Common_options& options);
void add_direct(CLI::App& command, Common_options& options);
void add_exact(
  CLI::App& command, Common_options& options,
  const char* what = "Decide exactly which edges are Delaunay, and certify the triangulation");
void add_neighbors(CLI::App& command, Common_options& options);

// Adds the option for commands that map surfaces, and for commands that map each component
// separately.
void add_keep_going(CLI::App& command, Common_options& options);
void add_components(CLI::App& command, Common_options& options);
void add_texture_output(CLI::App& command, Texture_options& options);

// Adds the options for commands whose output is the common subdivision.
void add_subdivision_options(CLI::App& command, Subdivision_options& options,
                             Common_options& common);

// Adds the options for an angle and for the number of insertions, and both for commands that refine
// only optionally.
CLI::Option* add_minimum_angle(CLI::App& command, double& angle, const std::string& what);
CLI::Option* add_maximum_number_of_insertions(CLI::App& command, Refinement_bounds& bounds,
                                              const std::string& exception = "");
void add_angle(CLI::App& command, Refinement_bounds& bounds);

#endif // INTRINSIC_COMMAND_LINE_H
