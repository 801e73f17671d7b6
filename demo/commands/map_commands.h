// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_COMMANDS_H
#define INTRINSIC_MAP_COMMANDS_H

#include "commands/Command_line.h"
#include "commands/Command_run.h"
#include "commands/Statistics.h"
#include "writing/Map_part.h"
#include "writing/Mesh_writer.h"
#include "writing/Output_mesh.h"
#include "writing/map_mesh.h"

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// This file contains the common parts of commands that map surfaces.

struct Hyperbolic_options : Texture_options
{
  std::string cones;        // a file; empty for none
  std::string radii;        // a property of vertices or a file; empty for no circles
  std::string picture;      // an SVG file
  std::optional<int> depth; // of the tiling in the picture; three if not given
};

// Shows and times the stages, and counts the iterations of all minimizations.
struct Stage_visitor
{
  Command_run& run;
  std::size_t iterations = 0;

  void start(CGAL::Discrete_conformal_maps::Flattening_stage stage);
  void after_iteration(std::size_t, double gradient_norm, double)
  {
    ++iterations;
    run.show(
      [&](View_page& page) { page.add_to_curve("Greatest curvature error", gradient_norm); });
    run.progress().long_step();
  }
};

// Returns the parameters that all maps have. `radii` and `visitor` must outlive them.
inline auto map_parameters(const Mesh& mesh, double mollification, const std::vector<double>& radii,
                           Stage_visitor& visitor)
{
  namespace parameters = CGAL::Discrete_conformal_maps::parameters;
  return parameters::concurrency_tag(CGAL::Parallel_if_available_tag())
    .mollification(mollification)
    .vertex_radius_map(
      boost::make_iterator_property_map(radii.begin(), get(boost::vertex_index, mesh)))
    .visitor(std::ref(visitor));
}

// Returns the mollification and the radii of circles, which `radii` names. Times the stage "build".
std::pair<double, std::vector<double>> built(Command_run& run, const std::string& radii);

// Returns the stages of a map, in their order. `has_cones` states whether cones are placed.
Stages map_stages(bool has_cones);

void add_tiling(CLI::App& command, Hyperbolic_options& options);

// Throws Program_error if no picture is requested for the depth of its tiling.
void check_tiling(const Common_options& common, const Hyperbolic_options& options);

// Throws Map_failure, with its reason, if a map is not a success. Prints a warning instead if
// failures are to be written and a layout exists.
void check_status(Command_run& run, const Conformal_map& map, bool is_laid_out);

// Returns 0 for a success, 3 for a failure that is written.
int exit_code(const Conformal_map& map);

// Stores which parts of a map are written, and how.
struct Map_output
{
  std::string path;
  Mesh_format format;
  bool is_homogeneous = false;                // the texture
  Cones cones = {};                           // the vertices with a curvature that is not zero
  std::optional<std::size_t> iterations = {}; // those of the map if not given
  std::string precise = {}; // of a sphere: a file of positions; empty if it is not wanted
  std::string picture = {}; // of the hyperbolic plane: an SVG file; empty if it is not wanted
  int depth = 3;            // of the tiling there and on the page
  // Describes the component if components are mapped one by one, and the input has only this one.
  std::optional<Statistics> component = {};
};

Map_output map_output(const Hyperbolic_options& options, Mesh_format format,
                      const Cones& cones = {});

// Adds the numbers of cones and iterations, and the results of `describe_status()`.
void describe_minimization(Statistics& statistics, const Conformal_map& map,
                           const Map_output& output);

// Adds the status, the errors of the promises and the greatest error of curvatures.
void describe_status(Statistics& statistics, const Conformal_map& map);

// Adds the faces of the input that are too small for coordinates in double, and prints a note.
// `component` is null if the map belongs to the whole input.
void describe_crowding(Command_run& run, Statistics& statistics, const Conformal_map& map,
                       const Component_mesh* component = nullptr);

// Adds the range of the logarithmic scale factors, the numbers of flips and the size of the output.
// Vertices without faces have no scale factors.
void describe_sizes(Statistics& statistics, const Conformal_map& map, const Map_part& part,
                    const Output_mesh& result);

// Adds the radii of the circles in the image. They are zero at vertices that only the subdivision
// has.
template <class Radius>
void add_radii(Output_mesh& mesh, const Map_part& part, const Radius& radius)
{
  std::vector<double> radii(part.vertices().size(), 0.);
  for(const Mesh::Vertex_index v : part.mapped_mesh().vertices())
    radii[v] = radius(CGAL::Discrete_conformal_maps::Vertex_index(v.idx()));
  mesh.point_data.push_back({"radius", std::move(radii)});
}

// Shows the common subdivision of a map on a page, with scale factors, the curvature of the input
// and the distortion of the map, and histograms of the angles of the input and its intrinsic
// Delaunay triangulation.
void show(View_page& page, Command_run& run, const Map_part& part, Output_mesh mesh,
          Image_kind kind);

// ---- For each kind of maps ----

// Describes a map, and returns the mesh that is written for it.
Output_mesh described_mesh(Statistics& statistics, const Spherical_map& map, const Map_part& part,
                           const Map_output& output);
Output_mesh described_mesh(Statistics& statistics, const Planar_map& map, const Map_part& part,
                           const Map_output& output);
Output_mesh described_mesh(Statistics& statistics, const Hyperbolic_map& map, const Map_part& part,
                           const Map_output& output);

// Shows a map whose mesh `mesh` is written.
void show(View_page& page, Command_run& run, const Spherical_map& map, const Map_part& part,
          const Output_mesh& mesh, const Map_output& output);
void show(View_page& page, Command_run& run, const Planar_map& map, const Map_part& part,
          const Output_mesh& mesh, const Map_output& output);
void show(View_page& page, Command_run& run, const Hyperbolic_map& map, const Map_part& part,
          const Output_mesh& mesh, const Map_output& output);

// Adds all files except for the file of the mesh.
void add_files(Command_run& run, const Spherical_map& map, const Map_output& output);
void add_files(Command_run& run, const Planar_map& map, const Map_output& output);
void add_files(Command_run& run, const Hyperbolic_map& map, const Map_output& output);

// Adds the description of a map to the statistics, also as the only one of "component_maps" if
// components are mapped one by one.
void add_description(Statistics& statistics, const Statistics& map, const Map_output& output);

// Summarizes the results of `described_mesh()` in one line.
std::string summary_of(const Spherical_map& map, const Statistics& statistics);
std::string summary_of(const Planar_map& map, const Statistics& statistics);
std::string summary_of(const Hyperbolic_map& map, const Statistics& statistics);

// Ends a command: checks the map, adds it to the outputs and its properties to the statistics, and
// finishes the run. Returns the exit code. Throws Map_failure as `check_status()` does.
template <class Map>
int finish(Command_run& run, const Map_output& output, const Map& map)
{
  check_status(run, map, map.is_laid_out());
  run.timed("write", [&] {
    const Map_part part(map, run.input().mesh);
    Statistics description;
    Output_mesh mesh = described_mesh(description, map, part, output);
    describe_crowding(run, description, map);
    add_description(run.statistics(), description, output);
    run.show([&](View_page& page) { show(page, run, map, part, mesh, output); });
    add_input_data(run.input(), mesh);
    run.add_output(output.path, mesh, output.format);
    add_files(run, map, output);
  });
  run.finish(summary_of(map, run.statistics()));
  return exit_code(map);
}

#endif // INTRINSIC_MAP_COMMANDS_H
