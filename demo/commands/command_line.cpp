// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/command_line.h"

#include "commands/help_texts.h"
#include "commands/number_ranges.h"

#include <CGAL/version.h>

namespace {

constexpr const char* version = "intrinsic " INTRINSIC_VERSION " (with CGAL " CGAL_VERSION_STR ")";

CLI::App& add_command(CLI::App& app, const char* name, const char* description, std::string& input)
{
  CLI::App& command = *app.add_subcommand(name, description);
  command.add_option("mesh", input, "Mesh (.off, .obj, .ply, .stl, .vtp)")->required();
  return command;
}

// Adds the output of a command, and its format.
void add_output(CLI::App& command, Output_options& options, const std::string& what,
                const std::string& formats)
{
  command.add_option("-o,--output", options.output, what + "; - for standard output)")->required();
  command.add_option("--format", options.format, "Format on standard output: " + formats)
    ->capture_default_str();
  command.add_flag("--binary", options.is_binary, "Write .ply with binary numbers");
}

// Adds an option with a number in a range.
template <class Number>
CLI::Option* add_number(CLI::App& command, const std::string& name, Number& number,
                        const std::string& what, const CLI::Validator& range)
{
  return command.add_option(name, number, what)->check(range);
}

void add_common_options(CLI::App& command, Common_options& options)
{
  command.add_option("--stats", options.statistics, "JSON file for statistics");
  command.add_option("--view", options.view,
                     "HTML file that shows the result in a browser, see `intrinsic view`");
  command.add_option("--picture", options.picture, "SVG or PNG file with a picture of the result");
  command.add_option(
    "--section", options.section,
    "What the picture shows: a point (a vertex, FACE:a,b,c or x,y,z) and a radius");
  add_number(command, "--mollify", options.mollification,
             "Lengthen all edges until every triangle inequality has this slack, "
             "relative to the mean edge length; done by itself where almost flat triangles leave "
             "no other way to a result, but not with --exact or --strict",
             number_from_to(1e-16, 1.));
  command.add_flag("--repair", options.is_repair_wanted,
                   "Repair defects of the mesh where possible and report it; indices may change");
  add_number(command, "--weld", options.weld_distance,
             "Repair the mesh, and merge points that are at most this far apart",
             positive_number());
  command.add_flag("--strict", options.is_strict,
                   "Refuse faces that are not triangles, which are split otherwise; never change "
                   "the lengths of edges");
}

void add_save(CLI::App& command, Common_options& options)
{
  command.add_option("--save", options.save, "File for the intrinsic triangulation itself");
}

void add_direct(CLI::App& command, Common_options& options)
{
  command.add_flag("--direct", options.is_direct,
                   "Let the --view page find intrinsic edges while it draws, without the common "
                   "subdivision, as it does for large meshes; not with --mollify");
}

void add_exact(
  CLI::App& command, Common_options& options,
  const char* what = "Decide exactly which edges are Delaunay, and certify the triangulation")
{
  command.add_flag("--exact", options.is_exact, what);
}

// Of the commands that map surfaces.
void add_keep_going(CLI::App& command, Common_options& options)
{
  command.add_flag("--keep-going", options.is_failure_kept,
                   "Write a map that lacks something it should have, too, and say what it lacks; "
                   "the exit code is 3 then");
}

// Of the commands that map each component on its own.
void add_components(CLI::App& command, Common_options& options)
{
  CLI::Option* const number =
    command.add_option("--component", options.component,
                       "Map only this component, counted from 0 in the order of their first faces");
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
    ->check(integer_from_to(3, 10000));
}

void add_info(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(
    app, "info", "Print the size, the topology and the defects of a mesh", options.info.input);
  command.add_flag("--json", options.info.is_json, "Print JSON");
  command.add_option("--view", options.info.view,
                     "HTML file that shows the mesh, and its defects in red");
  command.add_option("--picture", options.info.picture,
                     "SVG or PNG file with a picture of the mesh");
  command.footer("Example:\n  intrinsic info bunny.obj --json\n\n"
                 "Exit code: 0 if the mesh can be worked on, 2 if not.");
}

void add_view(CLI::App& app, Options& options)
{
  CLI::App& command = *app.add_subcommand("view", "Write a page that shows meshes in a browser");
  command.add_option("mesh", options.view.inputs, "Meshes (.off, .obj, .ply, .stl, .vtp)")
    ->required();
  command.add_option("-o,--output", options.view.output, "HTML file; - for standard output")
    ->required();
  command.footer(Help::view);
}

// Of the commands whose output is the common subdivision.
template <class Own_options>
void add_subdivision_options(CLI::App& command, Own_options& options, Common_options& common)
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

void add_maximum_number_of_insertions(CLI::App& command, Refinement_bounds& bounds,
                                      const std::string& exception = "")
{
  command
    .add_option("--max-insertions", bounds.maximum_number_of_insertions,
                "Maximum number of insertions; if not given, 1,000,000 (with angles of more than "
                "30 degrees 100,000) plus 20 for each face" +
                  exception)
    ->check(integer_from(0));
}

// For the commands that refine only if it is wanted.
void add_angle(CLI::App& command, Refinement_bounds& bounds)
{
  add_number(command, "--min-angle", bounds.minimum_angle,
             "Insert vertices until all angles have this many degrees, see `intrinsic refine`",
             number_from_to(0.001, 60.));
  add_maximum_number_of_insertions(command, bounds);
}

void add_delaunay(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(
    app, "delaunay", "Flip a mesh to its intrinsic Delaunay triangulation", options.common.input);
  add_subdivision_options(command, options.delaunay, options.common);
  add_exact(command, options.common);
  command.footer(
    "Example:\n  intrinsic delaunay bunny.obj -o subdivision.vtp --constrain-angle 40");
}

void add_bounds(CLI::App& command, Refinement_bounds& bounds)
{
  add_number(command, "--min-angle", bounds.minimum_angle,
             "Least angle of the faces in degrees, 0 for no bound", number_from_to(0., 60.))
    ->capture_default_str();
  add_number(command, "--max-circumradius", bounds.maximum_circumradius,
             "Greatest circumradius of the faces; no bound if not given", positive_number());
  add_maximum_number_of_insertions(command, bounds, ", but 10,000,000 with --max-circumradius");
}

void add_refine(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "refine", "Insert vertices until all faces obey bounds on angles and sizes",
                options.common.input);
  add_subdivision_options(command, options.refine, options.common);
  add_bounds(command, options.refine.bounds);
  command.add_flag(
    "--simplicial", options.refine.bounds.is_simplicial,
    "Insert vertices until no edge is a loop and no two have the same ends, and write "
    "the triangulation itself, its faces flat in space, in place of the subdivision");
  add_exact(command, options.common,
            "Decide exactly about edges and inserted vertices, and certify the triangulation");
  command.footer(Help::refine);
}

void add_distance_outputs(CLI::App& command, Distance_options& options)
{
  add_output(command, options, "The mesh with the vertex property \"distance\" (.ply, .vtp",
             "ply or vtp");
  command.add_option("--subdivision", options.subdivision,
                     "Common subdivision of the mesh and its intrinsic triangulation, "
                     "with the same property");
  command.add_option("--level-sets", options.level_sets,
                     "Curves of equal distance (.obj, .ply or .vtp)");
  command
    .add_option("--level", options.levels,
                "A value of the distance for --level-sets; ten values if none is given")
    ->allow_extra_args(false)
    ->check(finite_number());
}

void add_distance_method(CLI::App& command, Distance_options& options)
{
  CLI::Option* const method =
    command
      .add_option(
        "--method", options.method,
        "exact (lengths of shortest paths, up to rounding), heat (the heat method, with "
        "an estimate of its error), or auto: exact where it is expected to take less than "
        "two seconds, without --signed and --time-step")
      ->check(CLI::IsMember({"exact", "heat", "auto"}))
      ->capture_default_str();
  command
    .add_flag_callback(
      "--exact-distance", [&options] { options.method = "exact"; }, "The same as --method exact")
    ->excludes(method);
}

void add_distance(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(app, "distance", "Compute geodesic distances, exactly or by heat",
                                  options.common.input);
  Distance_options& own = options.distance;
  command
    .add_option("--source", own.sources,
                "Point to which distances are measured, with several to the nearest: a vertex "
                "counted from 0, FACE:a,b,c (barycentric), or x,y,z (nearest)")
    ->allow_extra_args(false);
  command.add_option(
    "--curve", own.curve,
    "File of polylines (.obj, .ply or .vtp, or .xyz for one) to which distances are "
    "measured");
  command.add_flag("--signed", own.is_signed,
                   "Compute signed distances to --curve: negative on its left");
  add_distance_outputs(command, own);
  add_save(command, options.common);
  add_common_options(command, options.common);
  add_exact(command, options.common);
  add_number(
    command, "--time-step", own.time_step_factor,
    "Time for which heat flows, in squared mean edge lengths, with --method heat unless another "
    "is given; by default 1, 4 with --signed, or 16 times as much as often as it takes to reach "
    "everything",
    positive_number());
  add_angle(command, own.refinement);
  add_direct(command, options.common);
  add_distance_method(command, own);
  add_neighbors(command, options.common);
  command.footer(Help::distance);
}

void add_path_points(CLI::App& command, Path_options& options)
{
  command.add_option("--from", options.from,
                     "Start: a vertex, FACE:a,b,c (barycentric), or x,y,z (nearest)");
  command.add_option("--to", options.to, "End, as the start");
  command.add_option("--via", options.via, "Vertex that the path passes before it is shortened")
    ->allow_extra_args(false);
  command.add_flag("--flips", options.is_flipped,
                   "Shorten a path along edges to a geodesic nearby, by flips");
  command.add_flag("--loop", options.is_loop,
                   "Shorten the loop from --from through all --via, by flips");
  command.add_option(
    "--straightest", options.straightest,
    "Go straight instead: the angle in degrees, counterclockwise from the first side of "
    "the face at --from or from the side that leaves a vertex, and the length");
  command.add_flag("--homology", options.is_homology_basis,
                   "Shortest geodesic loops around all handles and holes, by flips");
}

void add_path(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "path", "Find shortest paths and geodesics", options.common.input);
  add_path_points(command, options.path);
  add_output(command, options.path, "The path as a line (.obj, .ply, .vtp", "obj, ply or vtp");
  add_save(command, options.common);
  add_common_options(command, options.common);
  command.footer(Help::path);
}

void add_transfer(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "transfer", "Take points or functions to the intrinsic triangulation and back",
                options.common.input);
  Transfer_options& own = options.transfer;
  command.add_option("-o,--output", own.output, "Text file; - for standard output")->required();
  command.add_option("--points", own.points,
                     "Text file of points, one in a line: a vertex, FACE:a,b,c (barycentric), or "
                     "x,y,z (nearest)");
  command.add_option("--data", own.data, "Text file of values at vertices: index value");
  command.add_flag("--back", own.is_back,
                   "Take what is given on the intrinsic triangulation to the mesh");
  add_save(command, options.common);
  add_common_options(command, options.common);
  add_exact(command, options.common);
  add_angle(command, own.refinement);
  command.footer(Help::transfer);
}

void add_operators(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "operators", "Write matrices of the intrinsic Delaunay triangulation",
                options.common.input);
  command
    .add_option("--prefix", options.operators.prefix,
                "Start of the names of the Matrix Market files")
    ->required();
  add_save(command, options.common);
  add_common_options(command, options.common);
  add_exact(command, options.common);
  add_angle(command, options.operators.refinement);
  add_neighbors(command, options.common);
  command.footer(Help::operators);
}

// Of the commands whose output has a texture.
void add_texture_output(CLI::App& command, Texture_options& options)
{
  add_output(command, options, "Common subdivision with texture coordinates (.obj, .ply, .vtp",
             "obj, ply or vtp");
  command.add_flag("--homogeneous,!--linear", options.is_homogeneous,
                   "Write homogeneous texture coordinates, or linear ones (the default)");
}

void add_flattening_targets(CLI::App& command, Flatten_options& options)
{
  command.add_option("--cones", options.cones,
                     "greedy, none, or a file of angle defects; greedy by default, but none for a "
                     "rectangle or a disk");
  add_number(command, "--max-log-scale", options.maximum_log_scale,
             "Place greedy cones until the absolute values of all logarithmic scale factors are at "
             "most this; 5 by default",
             positive_number());
  command
    .add_option("--boundary", options.boundary,
                "free, straight, scale, curvature, rectangle or disk, see below")
    ->capture_default_str();
  command.add_option("--boundary-values", options.boundary_values,
                     "File of values at vertices for --boundary scale or curvature");
}

void add_flatten(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "flatten", "Map a mesh to the plane, conformally", options.common.input);
  Flatten_options& own = options.flatten;
  add_texture_output(command, own);
  add_flattening_targets(command, own);
  command
    .add_option("--solver", own.solver,
                "newton, ceres, or cetm, which keeps the triangulation of the mesh, see below")
    ->check(CLI::IsMember({"newton", "ceres", "cetm"}))
    ->capture_default_str();
  command.add_option(
    "--matrix", own.matrix,
    "Matrix Market file (.mtx) for the interpolation to the vertices of the output");
  add_keep_going(command, options.common);
  command.add_flag("--no-overlap", own.has_no_overlap,
                   "Cut charts where they overlap in the plane, and pack them");
  command.add_flag("--unit-square", own.is_in_unit_square,
                   "Scale the texture coordinates to the unit square");
  add_common_options(command, options.common);
  add_exact(
    command, options.common,
    "Decide exactly about the flips to the intrinsic Delaunay triangulation, and certify it, "
    "the flat triangulation and the order of their crossings");
  command.footer(Help::flatten);
}

void add_tiling(CLI::App& command, Hyperbolic_options& options)
{
  command.add_option("--svg", options.picture, "Picture of the domain and its images in the disk");
  command
    .add_option(
      "--tiles", options.depth,
      "Maximum number of sides between the domain and an image in the picture; 3 by default")
    ->check(integer_from_to(0, 100));
}

void add_hyperbolic(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(
    app, "hyperbolic", "Compute the conformal metric of curvature -1, in the Poincare disk",
    options.common.input);
  Hyperbolic_options& own = options.hyperbolic;
  add_texture_output(command, own);
  command.add_option("--cones", own.cones, "File of angle defects; zero everywhere if not given");
  add_tiling(command, own);
  add_keep_going(command, options.common);
  add_components(command, options.common);
  add_common_options(command, options.common);
  command.footer(Help::hyperbolic);
}

void add_uniformize(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(
    app, "uniformize", "Compute the conformal metric of constant curvature that suits the topology",
    options.common.input);
  Hyperbolic_options& own = options.hyperbolic;
  add_texture_output(command, own);
  add_tiling(command, own);
  add_keep_going(command, options.common);
  add_components(command, options.common);
  add_common_options(command, options.common);
  command.footer(Help::uniformize);
}

void add_sphere(CLI::App& app, Options& options)
{
  CLI::App& command = add_command(
    app, "sphere", "Map a sphere or a disk to the unit sphere, conformally", options.common.input);
  Sphere_options& own = options.sphere;
  add_output(command, own, "Common subdivision on the sphere (.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  command.add_option(
    "--precise", own.precise,
    "Text file for the positions of the input vertices with 31 digits: index x y z");
  add_keep_going(command, options.common);
  add_components(command, options.common);
  add_common_options(command, options.common);
  command.footer(Help::sphere);
}

void add_target(CLI::App& command, Simplify_options& options)
{
  CLI::App& target = *command.add_option_group("Target", "Where to stop");
  target.add_option("--vertices", options.number_of_vertices, "Number of vertices to be left")
    ->check(integer_from(1));
  add_number(target, "--ratio", options.ratio, "Part of the vertices to be left",
             number_from_to(1e-9, 1.));
  add_number(target, "--error", options.maximum_cost, "Greatest cost of a removal, a length",
             nonnegative_number());
  target.require_option(1);
}

void add_simplify_outputs(CLI::App& command, Options& options)
{
  Simplify_options& own = options.simplify;
  add_output(command, own,
             "Common subdivision with the coarse triangulation (.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  command.get_option("--output")->required(false); // or --coarse
  command.add_option(
    "--coarse", own.coarse_mesh,
    "The coarse triangulation as an ordinary mesh in space (.off, .obj, .ply, .vtp)");
  command.add_option("--prolongation", own.prolongation,
                     "Matrix Market file: from coarse vertices to those of the mesh");
  command.add_option("--save", options.common.save,
                     "File for the levels and the operations between them");
}

void add_topology(CLI::App& command, Simplify_options& own)
{
  add_number(command, "--close-loops", own.closed_length,
             "First close boundary loops up to this length by disks", nonnegative_number());
  add_number(command, "--pinch-handles", own.pinched_length,
             "First cut handles along closed curves of edges up to this length, and close both "
             "sides by disks",
             nonnegative_number());
}

void add_simplify(CLI::App& app, Options& options)
{
  CLI::App& command =
    add_command(app, "simplify", "Remove vertices, intrinsically", options.common.input);
  Simplify_options& own = options.simplify;
  add_simplify_outputs(command, options);
  add_target(command, own);
  command
    .add_option(
      "--weight", own.weights,
      "NAME=W: the share of curvature, area, area_change, boundary_change, color or a property of "
      "vertices in the cost; what is not given has none. Without --weight it is curvature=1, "
      "area=2, area_change=6 and boundary_change=12")
    ->allow_extra_args(false);
  command
    .add_option("--levels", own.number_of_levels,
                "Number of levels, each smaller by the same factor; the last is the coarse one")
    ->check(integer_from_to(1, 100))
    ->capture_default_str();
  add_number(command, "--refine", own.refinement.minimum_angle,
             "Refine to this angle in degrees first, so that there are vertices to choose from",
             number_from_to(0., 30.));
  add_number(command, "--min-angle", own.coarse_minimum_angle,
             "Insert vertices into the coarse triangulation until all its angles have this many "
             "degrees, see `intrinsic refine`",
             number_from_to(0., 60.));
  add_maximum_number_of_insertions(command, own.refinement);
  add_topology(command, own);
  add_common_options(command, options.common);
  add_exact(command, options.common,
            "Decide exactly about the intrinsic Delaunay triangulation from which vertices are "
            "removed, and about --refine, and certify it");
  command.footer(Help::simplify);
}

} // namespace

void define_command_line(CLI::App& app, Options& options)
{
  app.description("Intrinsic triangulations of surface meshes");
  app.set_version_flag("--version", version);
  app.add_flag("-q,--quiet", options.common.is_quiet, "Print errors and repairs only");
  add_number(app, "--threads", options.common.threads,
             "Maximum number of threads; the output does not depend on it",
             integer_from_to(1, 1024));
  app.footer(Help::examples);
  app.require_subcommand(1);
  app.fallthrough();
  add_info(app, options);
  add_view(app, options);
  add_delaunay(app, options);
  add_refine(app, options);
  add_distance(app, options);
  add_path(app, options);
  add_transfer(app, options);
  add_operators(app, options);
  add_flatten(app, options);
  add_hyperbolic(app, options);
  add_uniformize(app, options);
  add_sphere(app, options);
  add_simplify(app, options);
}
