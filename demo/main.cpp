// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Program_error.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/version.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

namespace {

constexpr const char* examples = R"(Examples:
  intrinsic info bunny.obj
  intrinsic delaunay bunny.obj -o subdivision.ply --stats bunny.json
  intrinsic delaunay scan.stl --repair -o - --format obj | gzip > scan.obj.gz

Exit code: 0 done, 1 the computation failed, 2 the input or the call was wrong.)";

constexpr const char* version = "intrinsic " INTRINSIC_VERSION " (with CGAL " CGAL_VERSION_STR ")";

void add_info(CLI::App& app, Info_options& options)
{
  CLI::App& command = *app.add_subcommand("info", "Say what a mesh is and what is wrong with it");
  command.add_option("mesh", options.input, "Mesh (.off, .obj, .ply, .stl)")->required();
  command.add_flag("--json", options.is_json, "Print JSON");
  command.footer("Example:\n  intrinsic info bunny.obj --json\n\n"
                 "Exit code: 0 if the mesh can be worked on, 2 if not.");
}

void add_delaunay_outputs(CLI::App& command, Delaunay_options& options)
{
  command
    .add_option("-o,--output", options.output,
                "Common subdivision of the mesh and its intrinsic Delaunay triangulation "
                "(.off, .obj, .ply, .vtp; - for standard output)")
    ->required();
  command.add_option("--format", options.format, "Format on standard output: off, obj, ply or vtp")
    ->capture_default_str();
  command.add_option("--save", options.save, "File for the intrinsic triangulation itself");
  command.add_option("--stats", options.statistics, "JSON file for statistics");
}

void add_delaunay(CLI::App& app, Delaunay_options& options)
{
  CLI::App& command =
    *app.add_subcommand("delaunay", "Flip a mesh to its intrinsic Delaunay triangulation");
  command.add_option("mesh", options.input, "Mesh (.off, .obj, .ply, .stl)")->required();
  add_delaunay_outputs(command, options);
  command
    .add_option("--mollify", options.mollification,
                "Lengthen all edges until every triangle inequality has this slack, "
                "relative to the mean edge length")
    ->check(CLI::Range(1e-16, 1.));
  command
    .add_option("--constrain-angle", options.constrained_angle,
                "Never flip an edge at which the normals differ by this many degrees or more")
    ->check(CLI::Range(0.001, 180.));
  command.add_flag("--repair", options.is_repair_wanted,
                   "Mend what can be mended in the mesh and tell it; indices may change");
  command.footer(
    "Example:\n  intrinsic delaunay bunny.obj -o subdivision.vtp --constrain-angle 40");
}

// Help and version are not errors.
int exit_code(const CLI::App& app, const CLI::ParseError& e) { return app.exit(e) == 0 ? 0 : 2; }

int report(const std::exception& e, int code)
{
  std::cerr << "intrinsic: " << e.what() << '\n';
  return code;
}

int run(const CLI::App& app, const Info_options& info_options,
        const Delaunay_options& delaunay_options)
{
  try {
    return app.got_subcommand("info") ? info(info_options) : delaunay(delaunay_options);
  } catch(const Program_error& e) {
    return report(e, 2);
  } catch(const CGAL::Intrinsic_triangulations::Invalid_input& e) {
    return report(e, 2);
  } catch(const std::exception& e) {
    return report(e, 1);
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Intrinsic triangulations of surface meshes");
  Info_options info_options;
  Delaunay_options delaunay_options;
  app.set_version_flag("--version", version);
  app.add_flag("-q,--quiet", delaunay_options.is_quiet, "Print errors and repairs only");
  app.footer(examples);
  app.require_subcommand(1);
  app.fallthrough();
  add_info(app, info_options);
  add_delaunay(app, delaunay_options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& e) {
    return exit_code(app, e);
  }
  return run(app, info_options, delaunay_options);
}
