// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/unknown_words.h"

#include <CGAL/version.h>

#include <cstddef>

namespace {

constexpr const char* version = "intrinsic " INTRINSIC_VERSION " (with CGAL " CGAL_VERSION_STR ")";

constexpr const char* examples_help =
  R"(Examples:
  intrinsic info bunny.obj
  intrinsic view bunny.obj scan.stl -o meshes.html
  intrinsic delaunay bunny.obj -o subdivision.ply --stats bunny.json --view bunny.html
  intrinsic delaunay scan.stl --repair -o - --format obj | gzip > scan.obj.gz
  intrinsic refine bunny.obj -o refined.ply --min-angle 30
  intrinsic distance bunny.obj --source 17 -o distance.vtp
  intrinsic path bunny.obj --from 17 --to 99 -o path.obj
  intrinsic operators bunny.obj --prefix bunny
  intrinsic flatten bunny.obj -o flat.obj
  intrinsic hyperbolic pretzel.obj -o disk.obj --svg tiling.svg
  intrinsic sphere bunny.obj -o sphere.ply
  intrinsic convex dented.off -o convex.off
  intrinsic pack bunny.obj -o packing.ply --circles packing.svg
  intrinsic simplify bunny.obj -o coarse.ply --ratio 0.02

Written meshes have the colors, normals, texture coordinates and functions of the input, if their
format supports them. Groups and materials of faces are kept from .obj to .obj.

Edges must be between 2^-127 and 2^127 (5.9e-39 and 1.7e38) long.

Exit code: 0 done, 1 the computation failed, 2 the input or the call was wrong. It is 3 if
--keep-going wrote a map that failed, or left out a component.)";

// Formats the help. Options that take one value at a time are repeatable. Pairs have no brackets
// and no comma, because spaces separate their values.
class Help_formatter : public CLI::Formatter
{
public:
  std::string make_option_opts(const CLI::Option* option) const override
  {
    std::string result = CLI::Formatter::make_option_opts(option);
    if(is_repeatable(*option))
      replace(result, " ...", " (repeatable)");
    if(const std::string type = option->get_type_name(); type.compare(0, 1, "[") == 0) {
      std::string values = type.substr(1);
      replace(values, ",", " ");
      replace(values, "]", "");
      replace(result, type, values);
    }
    return result;
  }

private:
  static void replace(std::string& text, const std::string& part, const std::string& by)
  {
    if(const std::size_t position = text.find(part); position != text.npos)
      text.replace(position, part.size(), by);
  }
};

// Lets all options of an application, its commands and groups refuse empty texts.
void refuse_empty_values(CLI::App& app)
{
  const auto check = [](const std::string& text) {
    return std::string(text.empty() ? "the value is empty; give one, or leave out the option" : "");
  };
  for(CLI::Option* const option : app.get_options())
    option->check(check);
  for(CLI::App* const part : app.get_subcommands([](const CLI::App*) { return true; }))
    refuse_empty_values(*part);
}

} // namespace

Command_line::Command_line()
{
  m_app.formatter(std::make_shared<Help_formatter>());
  m_app.description("Intrinsic triangulations of surface meshes");
  m_app.set_version_flag("--version", version);
  m_app.add_flag("-q,--quiet", m_common.is_quiet, "Print errors and repairs only");
  add_number(m_app, "--threads", m_common.threads,
             "Maximum number of threads; the output does not depend on it",
             integer_from_to(1, 1024));
  m_app.footer(examples_help);
  m_app.require_subcommand(1);
  m_app.fallthrough();
  for(const auto define :
      {define_info, define_view, define_delaunay, define_refine, define_distance, define_path,
       define_transfer, define_operators, define_flatten, define_hyperbolic, define_uniformize,
       define_sphere, define_convex, define_pack, define_simplify})
    define(*this);
  refuse_empty_values(m_app);
}

void check_format(const CLI::App& command)
{
  const CLI::Option* const format = command.get_option_no_throw("--format");
  if(!format || format->empty())
    return;
  for(const char* name : {"--output", "--subdivision", "--level-sets", "--coarse"})
    if(const CLI::Option* const output = command.get_option_no_throw(name);
       output && !output->empty() && output->results().back() == "-")
      return;
  throw Program_error("--format is for standard output, and names of files determine formats; "
                      "leave it out");
}

void add_output(CLI::App& command, Output_options& options, const std::string& what,
                const std::string& formats)
{
  command.add_option("-o,--output", options.output, what + "; - for standard output)")->required();
  command.add_option("--format", options.format, "Format on standard output: " + formats)
    ->capture_default_str();
  command.add_flag("--binary", options.is_binary, "Write .ply with binary numbers");
}

void add_statistics(CLI::App& command, Common_options& options)
{
  command.add_option("--stats", options.statistics, "JSON file for statistics");
}

void add_common_options(CLI::App& command, Common_options& options)
{
  add_statistics(command, options);
  command.add_option("--view", options.view,
                     "HTML file that shows the result in a browser, see `intrinsic view`");
  command.add_option("--picture", options.picture, "SVG or PNG file with a picture of the result");
  command
    .add_option("--section", options.section,
                "Draw the surface around a point (a vertex, FACE:a,b,c or x,y,z) up to a radius")
    ->type_name("POINT RADIUS")
    ->needs(command.get_option("--picture"));
  add_mollification(command, options);
  add_repair(command, options);
}

void add_mollification(CLI::App& command, Common_options& options)
{
  add_number(command, "--mollify", options.mollification,
             "Lengthen all edges until every triangle inequality has this slack, relative to the "
             "mean edge length. Commands do so by themselves if almost flat triangles make a "
             "computation fail, except with --exact or --strict",
             number_from_to(1e-16, 1.));
}

void add_repair(CLI::App& command, Common_options& options)
{
  command.add_flag("--repair", options.is_repair_wanted,
                   "Repair defects of the mesh where possible and report it; indices may change");
  add_number(command, "--weld", options.weld_distance,
             "Repair the mesh, and merge points that are at most this far apart",
             positive_number());
  CLI::Option* const strict = command.add_flag(
    "--strict", options.is_strict,
    "Refuse faces that are not triangles, which are split otherwise; never change the lengths of "
    "edges");
  if(CLI::Option* const mollification = command.get_option_no_throw("--mollify"))
    strict->excludes(mollification);
}

void add_save(CLI::App& command, Common_options& options)
{
  command.add_option("--save", options.save, "File for the intrinsic triangulation itself");
}

void add_direct(CLI::App& command, Common_options& options)
{
  command
    .add_flag("--direct", options.is_direct,
              "Let the --view page find intrinsic edges while it draws, without the common "
              "subdivision, as it does for large meshes; not with --mollify")
    ->needs(command.get_option("--view"))
    ->excludes(command.get_option("--mollify"));
}

void add_exact(CLI::App& command, Common_options& options, const char* what)
{
  command.add_flag("--exact", options.is_exact, what);
}

void add_keep_going(CLI::App& command, Common_options& options)
{
  command.add_flag(
    "--keep-going", options.is_failure_kept,
    "Write the map even if it misses promises, and name them; the exit code is then 3");
}

void add_components(CLI::App& command, Common_options& options)
{
  CLI::Option* const number = add_number(
    command, "--component", options.component,
    "Map only this component, counted from 0 in the order of their first faces", integer_from(0));
  command
    .add_flag("--largest", options.is_largest_chosen,
              "Map only the component with the greatest area")
    ->excludes(number);
}

void add_neighbors(CLI::App& command, Common_options& options)
{
  command
    .add_option("--neighbors", options.number_of_neighbors,
                "Accept files without faces, .xyz too, and triangulate each point with this many "
                "neighbors; 30 is usual")
    ->transform(integer_from_to(3, 10000));
}

void add_subdivision_options(CLI::App& command, Subdivision_options& options,
                             Common_options& common)
{
  add_output(command, options,
             "Common subdivision of the mesh and its intrinsic triangulation "
             "(.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  add_save(command, common);
  add_common_options(command, common);
  add_direct(command, common);
  add_number(command, "--constrain-angle", options.constrained_angle,
             "Never flip an edge at which the normals differ by this many degrees or more",
             number_from_to(0.001, 180.));
}

CLI::Option* add_minimum_angle(CLI::App& command, double& angle, const std::string& what)
{
  return add_number(command, "--min-angle", angle, what, number_from_to(0., 60.));
}

CLI::Option* add_maximum_number_of_insertions(CLI::App& command, Refinement_bounds& bounds,
                                              const std::string& exception)
{
  return command
    .add_option("--max-insertions", bounds.maximum_number_of_insertions,
                "Maximum number of insertions; if not given, 1,000,000 (with angles of more than "
                "30 degrees 100,000) plus 20 for each face, but at most 10,000,000" +
                  exception)
    ->transform(integer_from(0));
}

void add_angle(CLI::App& command, Refinement_bounds& bounds)
{
  CLI::Option* const angle =
    add_minimum_angle(command, bounds.minimum_angle,
                      "Insert vertices until all angles have this many degrees, see `intrinsic "
                      "refine`; 0, the default, inserts none");
  add_maximum_number_of_insertions(command, bounds)->needs(angle);
}

void add_texture_output(CLI::App& command, Texture_options& options)
{
  add_output(command, options, "Common subdivision with texture coordinates (.obj, .ply, .vtp",
             "obj, ply or vtp");
  CLI::Option* const homogeneous = command.add_flag("--homogeneous", options.is_homogeneous,
                                                    "Write homogeneous texture coordinates");
  command.add_flag("--linear", "Write linear texture coordinates, the default")
    ->excludes(homogeneous);
}
