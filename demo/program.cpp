// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

#include "Program_error.h"
#include "commands/Thread_limit.h"
#include "commands/command_line.h"
#include "commands/unknown_words.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

using CGAL::Intrinsic_triangulations::Numerical_error;

// Help and version are not errors.
int exit_code(const CLI::App& app, const CLI::ParseError& e, int argc, const char* const* argv)
{
  const bool is_error = e.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success);
  const std::string unknown = is_error ? unknown_word(app, argc, argv) : "";
  if(unknown.empty())
    return app.exit(e) == 0 ? 0 : 2;
  std::cerr << "intrinsic: " << unknown << "\nRun with --help for more information.\n";
  return 2;
}

int report(const std::exception& e, int code)
{
  std::cerr << "intrinsic: " << e.what() << '\n';
  return code;
}

int run_command(const CLI::App& app, const Options& options)
{
  if(app.got_subcommand("info"))
    return info(options.info);
  if(app.got_subcommand("view"))
    return view(options.view);
  if(app.got_subcommand("delaunay"))
    return delaunay(options.common, options.delaunay);
  if(app.got_subcommand("refine"))
    return refine(options.common, options.refine);
  if(app.got_subcommand("distance"))
    return distance(options.common, options.distance);
  if(app.got_subcommand("path"))
    return path(options.common, options.path);
  if(app.got_subcommand("transfer"))
    return transfer(options.common, options.transfer);
  if(app.got_subcommand("flatten"))
    return flatten(options.common, options.flatten);
  if(app.got_subcommand("hyperbolic"))
    return hyperbolic(options.common, options.hyperbolic);
  if(app.got_subcommand("uniformize"))
    return uniformize(options.common, options.hyperbolic);
  if(app.got_subcommand("sphere"))
    return sphere(options.common, options.sphere);
  if(app.got_subcommand("simplify"))
    return simplify(options.common, options.simplify);
  return operators(options.common, options.operators);
}

// Whether the lengths of the edges may be changed, where triangles that are almost flat leave no
// other way to a result.
bool can_be_mollified(const Common_options& options)
{
  return !options.is_exact && !options.is_strict && options.mollification == 0;
}

// Throws an error of the same kind with a longer message.
[[noreturn]] void throw_again(const Numerical_error& e, const std::string& more)
{
  if(dynamic_cast<const Map_failure*>(&e))
    throw Map_failure(e.what() + more);
  throw Numerical_error(e.what() + more);
}

// What rounding makes impossible is tried again with longer edges, if triangles are almost flat. If
// that fails, too, the error is that of the surface as it is.
int run_mollified_if_needed(const CLI::App& app, const Options& options)
{
  try {
    return run_command(app, options);
  } catch(const Numerical_error& e) {
    if(!can_be_mollified(options.common))
      throw;
    std::string advice;
    Options changed = options;
    changed.common.is_mollification_tried = true;
    for(const char* epsilon : {"1e-8", "1e-6"})
      try {
        changed.common.mollification = std::stod(epsilon);
        const int result = run_command(app, changed);
        std::cerr << options.common.input << ": computed with --mollify " << epsilon << ": "
                  << e.what() << '\n';
        return result;
      } catch(const Numerical_error&) {
        advice = std::string("; nor is there a result with --mollify ") + epsilon;
      } catch(const Nothing_to_mollify&) {
      }
    throw_again(e, advice);
  }
}

// A map that is no success is written only if it is wanted and there is no other.
int run_keeping_failures(const CLI::App& app, const Options& options)
{
  try {
    return run_mollified_if_needed(app, options);
  } catch(const Map_failure&) {
    if(!options.common.is_failure_kept)
      throw;
    Options changed = options;
    changed.common.is_failure_expected = true;
    return run_command(app, changed);
  }
}

// What can be tried if there is no map at all; empty for other commands.
std::string advice(const CLI::App& app)
{
  for(const char* map : {"flatten", "hyperbolic", "uniformize", "sphere"})
    if(app.got_subcommand(map))
      return "; try --repair, which removes faces without area, or --mollify 1e-6";
  return "";
}

int run(const CLI::App& app, const Options& options)
{
  const Thread_limit limit(options.common.threads);
  try {
    return run_keeping_failures(app, options);
  } catch(const Program_error& e) {
    return report(e, 2);
  } catch(const CGAL::Intrinsic_triangulations::Invalid_input& e) {
    return report(e, 2);
  } catch(const Map_failure& e) {
    return report(e, 1);
  } catch(const CGAL::Intrinsic_triangulations::Error& e) {
    return report(std::runtime_error(e.what() + advice(app)), 1);
  } catch(const std::exception& e) {
    return report(e, 1);
  }
}

} // namespace

int run_program(int argc, const char* const* argv)
{
  CLI::App app;
  Options options;
  define_command_line(app, options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& e) {
    return exit_code(app, e, argc, argv);
  }
  return run(app, options);
}
