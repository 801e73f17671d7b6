// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

#include "Program_error.h"
#include "commands/Command_line.h"
#include "commands/unknown_words.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

int report(const std::exception& e, int code)
{
  std::cerr << "intrinsic: " << e.what() << '\n';
  return code;
}

// Returns the exit code. Help and version are not errors.
int exit_code(const CLI::App& app, const CLI::ParseError& e, int argc, const char* const* argv)
{
  if(e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    return app.exit(e);
  std::string unknown = unknown_word(app, argc, argv);
  if(unknown.empty() && e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    unknown = unexpected_words(app, argc, argv);
  return report(std::runtime_error((unknown.empty() ? e.what() : unknown) +
                                   "\nRun with --help for more information."),
                2);
}

// Returns advice if no map exists at all, or an empty text for other commands.
std::string advice(const CLI::App& app)
{
  for(const char* map : {"flatten", "hyperbolic", "uniformize", "sphere"})
    if(app.got_subcommand(map))
      return "; try --repair, which removes faces without area, or --mollify 1e-6";
  return "";
}

// Limits the number of threads during its lifetime, where 0 means no limit. Without TBB, the
// program uses one thread.
class Thread_limit
{
public:
  explicit Thread_limit([[maybe_unused]] std::size_t threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(threads > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, threads);
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_control;
#endif
};

int run(Command_line& line)
{
  const Thread_limit limit(line.common().threads);
  try {
    return line.run();
  } catch(const Program_error& e) {
    return report(e, 2);
  } catch(const CGAL::Intrinsic_triangulations::Invalid_input& e) {
    return report(std::runtime_error(line.common().input + ": " + e.what()), 2);
  } catch(const Map_failure& e) {
    return report(e, 1);
  } catch(const CGAL::Intrinsic_triangulations::Error& e) {
    return report(std::runtime_error(e.what() + advice(line.app())), 1);
  } catch(const std::exception& e) {
    return report(e, 1);
  }
}

// Returns the words of the command line. "help", before a command or alone, becomes "--help".
std::vector<const char*> words(int argc, const char* const* argv)
{
  std::vector<const char*> result(argv, argv + argc);
  if(argc > 1 && result[1] == std::string("help")) {
    result.erase(result.begin() + 1);
    result.push_back("--help");
  }
  return result;
}

} // namespace

int run_program(int argc, const char* const* argv)
{
  Command_line line;
  const std::vector<const char*> given = words(argc, argv);
  try {
    line.app().parse(argc, given.data());
  } catch(const CLI::ParseError& e) {
    return exit_code(line.app(), e, argc, given.data());
  }
  return run(line);
}
