// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/flattening_conditions.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"
#include "reading/map_names.h"
#include "reading/vertex_values.h"
#include "writing/Mesh_writer.h"
#include "writing/flat_triangles.h"
#include "writing/matrix_market.h"

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/charts.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#ifdef INTRINSIC_USE_CERES
#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#endif

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

constexpr const char* flatten_help =
  R"(The map is discretely conformal. By default, vertices on the boundary have the scale factor
one. An edge of the boundary keeps its length if it is an edge of the triangulation of the map.
Other edges of the boundary are flipped, in the mesh glued to its mirror image. Their images are
polylines of other lengths. A surface without boundary is cut through its cones.

Values of --boundary:
  free       vertices on the boundary have the scale factor one (the default)
  straight   all exterior angles are zero; cones are placed inside
  scale      --boundary-values FILE prescribes the logarithms of scale factors
  curvature  --boundary-values FILE prescribes exterior angles
  rectangle  each component is mapped to a rectangle. The corners are as far apart along the
             boundary as possible. Their exterior angles add up to at least nine tenths of the sum
             at the four sharpest vertices
  disk       the boundary of each component is mapped to a circle
For rectangles and disks, each component must have one boundary. Cones are then placed only with
--cones, and only inside; components with handles need them.

Cones are placed one by one at the vertices with the greatest scale factors. With --cones exchanged,
they are then dropped and moved while a linear estimate stays within the bound. This often leaves
fewer cones, and takes more time. --max-area-distortion X is the bound --max-log-scale log(X)/2.

With --radii, circles around the vertices are mapped to circles. The map is a decorated conformal
map, which keeps inversive distances instead of lengths. Circles of neighbors may touch, but not
meet. --boundary disk is refused with circles: `intrinsic sphere` maps a disk with circles to a
hemisphere. .ply and .vtp have the radii in the plane as "radius", zero at other vertices. Radii can
also be a property of the vertices of the mesh, given by its name. They are lengths on the mesh:
"radius" of `intrinsic pack` on the sphere is an angle, which --radii does not take.

A FILE has lines "index value": a vertex, counted from 0, and an angle in radians, a logarithm or a
radius. A # begins a comment. Vertices that are not listed have no circle and the curvature zero:
they are flat inside, and straight on the boundary. Values of --cones are angle defects, 2 pi minus
the sum of angles; an empty file makes a torus flat. All curvatures must add up to 2 pi times the
Euler characteristic, unless scale factors are prescribed somewhere.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the flat
triangulation. Texture coordinates u, v at the corners of its faces are lengths in the plane, not
limited to one. Charts of components stand side by side. With --linear, the default, which every
program reads, texture coordinates are interpolated linearly. The map itself is projective on each
face. With --homogeneous it is exact: u w, v w and w are interpolated linearly, and then divided.
  .obj  "vt u v", or "vt uw vw w"
  .ply  a list "texcoord" or "homogeneous_texcoord" of each face, with all numbers of its corners
  .vtp  a property of points with this name; points are repeated along seams

In .ply and .vtp, vertices have their input vertex (or -1), whether they are cones, and their
logarithmic scale factor. Faces, and edges in .ply, have the input, intrinsic and flat face or edge
that contains them. Edges with is_seam 1 are cut open.

With --exact, flips to the intrinsic Delaunay triangulation are decided exactly, on the surface of
the positions. Its lengths and curvature errors have 32 digits. "certified" in the statistics is
true if the map is a success and exact decisions, without a tolerance, confirm three facts. This
triangulation is Delaunay. The flat triangulation is ideal Delaunay with the rounded scale factors.
All crossings are in order. Otherwise "greatest_excess", "exchanged_crossings", "undecided" and
"undecided_crossings" have the reason: rounding decides ties.

Solvers:
  newton  Newton's method
  ceres   L-BFGS of the Ceres Solver: as accurate, with fewer factorizations and more evaluations
  cetm    Newton's method in the triangulation of the mesh, without flips, for comparison. Scale
          factors depend on the triangulation and often do not exist. The error names the
          violated condition, triangle_inequality or no_minimum.

Layouts, which differ by rounding only:
  least-squares  face by face; then errors of all sides are distributed
  spectral       the function with the least conformal energy
  incremental    face by face: errors add up

The file of --matrix has a sparse matrix. Its rows belong to the vertices of the output, in the
order of .obj and .ply (.vtp repeats vertices along seams). Its columns belong to the vertices of
the mesh. It maps values at vertices of the mesh, such as colors, to values at vertices of the
output, linearly on each face. Each row has one to three weights with the sum one. Rows of vertices
of the mesh come first, in their order, so the matrix begins with the identity.

The image can cover parts of the plane more than once. The last line and "overlap_area" in the
statistics have the area of these parts. "overlapping_charts" has pairs of charts that overlap; both
numbers are equal if a chart overlaps itself. With --no-overlap, charts are cut along edges of the
flat triangulation until no chart overlaps itself, and packed. With --unit-square, all texture
coordinates are multiplied by one number, "scale" in the statistics, and lie between 0 and 1.

The last line has two numbers of flips, "flips" and "ptolemy_flips" in the statistics. Flips lead to
the intrinsic Delaunay triangulation, Ptolemy flips from this one to the flat triangulation. At a
boundary, both include flips in the mirror image, as far as it is used.

A map that misses a promise is not written, and the message names what can be tried. Promises are
about curvatures, exterior angles, the shape of the boundary, length cross ratios and orientation.
With --keep-going the map is written, with exit code 3. "promises" in the statistics has all errors.

Texture coordinates are rounded such that no triangle is flipped. "flipped_triangles" in the
statistics counts triangles for which this fails. Slivers are counted by "flipped_slivers" instead:
triangles with heights in space of up to 16 units in the last place of their coordinates.
"flipped_faces" has the first ten faces with either.

Examples:
  intrinsic flatten bunny.obj -o flat.obj --cones greedy --max-log-scale 3
  intrinsic flatten bunny.obj -o atlas.obj --no-overlap --unit-square
  intrinsic flatten face.ply -o flat.ply --boundary disk --stats flat.json)";

// Returns the first option that bounds the distortion, or an empty text if none is given.
std::string bound_of_cones(const Flatten_options& options)
{
  if(options.maximum_log_scale)
    return "--max-log-scale";
  return options.maximum_area_distortion ? "--max-area-distortion" : "";
}

// Checks that bounds of the distortion are for cones that are placed. `options` are as given.
void check_bounds_of_cones(const Flatten_options& options)
{
  const std::string bound = bound_of_cones(options);
  if(bound.empty() || places_cones(options.cones))
    return;
  if(!options.cones.empty())
    throw Program_error(bound + " is for --cones greedy or exchanged, not for --cones " +
                        options.cones);
  if(is_shape(options.boundary))
    throw Program_error(bound + " places cones, and --boundary " + options.boundary +
                        " has none by default: add --cones greedy, or leave it out");
}

// Sets the default options. Cones are placed greedily, except for shapes that need no cones.
Flatten_options with_defaults(Flatten_options options, bool is_exact)
{
  check_boundary(options);
  check_circles(options, is_exact);
#ifndef INTRINSIC_USE_CERES
  if(options.solver == "ceres")
    throw Program_error("--solver ceres: this program was built without the Ceres Solver; "
                        "install libceres-dev and build again");
#endif
  if(is_exact && options.solver == "cetm")
    throw Program_error(
      "--exact: --solver cetm makes no triangulation Delaunay; leave out one of them");
  check_bounds_of_cones(options);
  if(options.cones.empty())
    options.cones = is_shape(options.boundary) ? "none" : "greedy";
  return options;
}

class Flatten_command
{
public:
  Flatten_command(const Common_options& common, const Flatten_options& options)
    : m_options(with_defaults(options, common.is_exact)),
      m_format(output_format(options.output, options, Carried::TEXTURE)),
      m_run("flatten", common, {options.output, options.matrix}),
      m_visitor{m_run}
  {
    m_run.plan({{"build"}, map_stages(true), certificate_stages(common)});
  }

  int run()
  {
    m_visitor.iterations = 0;
    m_conditions = m_run.timed("build", [&] {
      m_mollification = mollification(m_run);
      m_radii = vertex_numbers("--radii", m_options.radii, m_run.input());
      return flattening_conditions(m_options, mesh());
    });
    Planar_map map = solved();
    if(m_run.options().is_exact)
      certify(map);
    m_run.timed("write", [&] {
      arrange(map);
      if(!m_options.matrix.empty())
        m_run.add_output(
          m_options.matrix,
          matrix_market(Map_part(map, mesh()).interpolation_matrix(), Matrix_symmetry::GENERAL));
    });
    Map_output output{m_options.output, m_format, m_options.is_homogeneous, cones(map)};
    output.iterations = m_visitor.iterations;
    return finish(m_run, output, map);
  }

  Command_run& command_run() { return m_run; }

private:
  Mesh& mesh() { return m_run.input().mesh; }

  Planar_map solved()
  {
#ifdef INTRINSIC_USE_CERES
    if(m_options.solver == "ceres")
      return flattened_by(DCM::Ceres_minimizer());
#endif
    return flattened_by(DCM::Newton_minimizer());
  }

  template <class Minimizer>
  Planar_map flattened_by(const Minimizer& minimizer)
  {
    const auto conditions =
      boost::make_iterator_property_map(m_conditions.begin(), get(boost::vertex_index, mesh()));
    const auto flipping =
      m_options.solver == "cetm" ? DCM::Flipping::none : DCM::Flipping::to_Delaunay;
    const double no_bound = std::numeric_limits<double>::infinity();
    return shaped(map_parameters(mesh(), m_mollification, m_radii, m_visitor)
                    .vertex_condition_map(conditions)
                    .cones(cones_named(m_options.cones))
                    .maximum_log_scale(m_options.maximum_log_scale.value_or(
                      m_options.maximum_area_distortion ? no_bound : 5))
                    .maximum_area_distortion(m_options.maximum_area_distortion.value_or(no_bound))
                    .layout(layout_named(m_options.layout))
                    .flipping(flipping)
                    .exact_decisions(m_run.options().is_exact)
                    .minimizer(minimizer));
  }

  // Maps the mesh to a shape. Throws Program_error, which names the mesh, if it does not fit the
  // shape.
  template <class Parameters>
  Planar_map shaped(const Parameters& np)
  {
    const std::string& shape = m_options.boundary;
    if(!is_shape(shape))
      return DCM::flatten(mesh(), np);
    try {
      if(shape == "disk")
        return DCM::flatten_to_disk(mesh(), np);
      return DCM::flatten_to_rectangle(mesh(), DCM::rectangle_corners(mesh(), np), np);
    } catch(const IT::Invalid_input& e) {
      throw Program_error(m_run.options().input + ": " + e.what() + "; try --boundary free");
    }
  }

  // Certifies the triangulations of the map and the order of their crossings.
  void certify(const Planar_map& map)
  {
    check_status(m_run, map, map.is_laid_out());
    const IT::Delaunay_certificate on_B = ::certify(m_run, map.Delaunay());
    const DCM::Map_certificate rest = m_run.timed("certify", [&] { return DCM::certify(map); });
    Statistics& statistics = m_run.statistics();
    statistics["certified"] = map.status() == DCM::Map_status::success && on_B.is_Delaunay() &&
                              rest.on_C.is_Delaunay() && rest.order.is_exact();
    statistics["ties"] = on_B.ties.size() + rest.on_C.ties.size() + rest.order.ties.size();
    Statistics& decisions = statistics["decisions"];
    const auto add = [&](const char* stage, std::size_t count) {
      decisions[stage] = decisions[stage].get<std::size_t>() + count;
    };
    add("floating_point",
        rest.on_C.decided_in_floating_point + rest.order.decided_in_floating_point);
    add("multiprecision", rest.order.decided_in_multiprecision);
    add("exact", rest.on_C.decided_exactly + rest.order.decided_exactly);
    statistics["greatest_excess"] = rest.on_C.greatest_excess;
    statistics["exchanged_crossings"] = rest.order.exchanged.size();
    statistics["undecided_crossings"] = rest.order.undecided.size();
  }

  // Cuts and scales charts, if this is requested.
  void arrange(Planar_map& map)
  {
    if(!map.is_laid_out())
      return;
    if(m_options.has_no_overlap)
      DCM::cut_overlaps(map);
    if(m_options.is_in_unit_square)
      m_run.statistics()["scale"] = DCM::fit_into_unit_square(map);
  }

  // Returns the cones that were placed and the cones of the file.
  std::vector<Mesh::Vertex_index> cones(const Planar_map& map)
  {
    std::vector<Mesh::Vertex_index> result;
    for(const DCM::Vertex_index v : map.cones())
      result.emplace_back(v.idx());
    for(const Mesh::Vertex_index v : mesh().vertices())
      if(!mesh().is_border(v) && m_conditions[v].value != 0)
        result.push_back(v);
    return result;
  }

  Flatten_options m_options; // with the default ones
  Mesh_format m_format;
  Command_run m_run;
  Stage_visitor m_visitor;
  double m_mollification = 0;
  Conditions m_conditions;
  std::vector<double> m_radii;
};

// Describes where the image covers a part of the plane more than once.
void describe_overlap(Statistics& statistics, const Planar_map& map)
{
  const DCM::Chart_overlap overlap = DCM::find_overlap(map);
  statistics["charts"] = overlap.number_of_charts;
  statistics["overlap_area"] = overlap.area;
  statistics["overlapping_charts"] = Statistics::array();
  for(const DCM::Overlapping_charts& pair : overlap.charts)
    statistics["overlapping_charts"].push_back({pair.first, pair.second});
}

} // namespace

std::string summary_of(const Planar_map&, const Statistics& s)
{
  std::ostringstream text;
  text << s["cones"] << " cones, log scale factors " << s["log_scale_min"].get<double>() << " to "
       << s["log_scale_max"].get<double>() << ", " << s["flips"] << " + " << s["ptolemy_flips"]
       << " flips, " << s["flipped_triangles"] << " triangles flipped in the plane"
       << flipped_slivers(s) << first_flipped_face(s) << ", " << s["subdivision"]["faces"]
       << " faces in the common subdivision, " << s["charts"]
       << (s["charts"] == 1 ? " chart" : " charts");
  if(!s["overlapping_charts"].empty())
    text << ", an area of " << s["overlap_area"].get<double>()
         << " covered more than once (--no-overlap cuts it)";
  return text.str();
}

Output_mesh described_mesh(Statistics& statistics, const Planar_map& map, const Map_part& part,
                           const Map_output& output)
{
  Output_mesh result = flat_mesh(map, part, output.cones, output.is_homogeneous);
  if(map.has_radii())
    add_radii(result, part, [&map](auto v) { return map.scaled_radius(v); });
  describe_minimization(statistics, map, output);
  statistics["max_cross_ratio_error"] = DCM::max_cross_ratio_error(map);
  describe_triangles(statistics, result);
  describe_overlap(statistics, map);
  describe_sizes(statistics, map, part, result);
  return result;
}

void show(View_page& page, Command_run& run, const Planar_map& map, const Map_part& part,
          const Output_mesh& mesh, const Map_output& output)
{
  show(page, run, part, flat_mesh(map, part, output.cones, true), Image_kind::plane);
  page.add_marks({"flipped triangles", true, flipped_polygons(mesh), {}, {}});
}

void add_files(Command_run&, const Planar_map&, const Map_output&) {}

namespace {

void add_flattening_targets(CLI::App& command, Common_options& common, Flatten_options& options)
{
  add_read_file(command, common, "--cones", options.cones,
                "greedy, exchanged, none, or a file of angle defects; greedy by default, but none "
                "for a rectangle or a disk");
  add_number(command, "--max-log-scale", options.maximum_log_scale,
             "Place cones until the absolute values of all logarithmic scale factors inside are at "
             "most this; 5 by default. It is no bound on the boundary",
             positive_number());
  add_number(command, "--max-area-distortion", options.maximum_area_distortion,
             "Place cones until areas grow and shrink at most by this factor everywhere inside",
             number_above_one());
  command
    .add_option("--boundary", options.boundary,
                "free, straight, scale, curvature, rectangle or disk, see below")
    ->capture_default_str();
  add_read_file(command, common, "--boundary-values", options.boundary_values,
                "File of values at vertices for --boundary scale or curvature");
  add_radii(command, common, options.radii);
}

} // namespace

void define_flatten(Command_line& line)
{
  const auto [command, options] =
    line.add_with_mesh("flatten", "Map a mesh to the plane, conformally",
                       attempted<Flatten_command, Flatten_options>, flatten_help);
  add_texture_output(command, options);
  add_flattening_targets(command, line.common(), options);
  command
    .add_option("--solver", options.solver,
                "newton, ceres, or cetm, which keeps the triangulation of the mesh, see below")
    ->check(CLI::IsMember({"newton", "ceres", "cetm"}))
    ->capture_default_str();
  command
    .add_option("--layout", options.layout,
                "least-squares, spectral or incremental: how flat faces are laid out, see below")
    ->check(CLI::IsMember({"least-squares", "spectral", "incremental"}))
    ->capture_default_str();
  command.add_option(
    "--matrix", options.matrix,
    "Matrix Market file (.mtx) for the interpolation to the vertices of the output");
  add_keep_going(command, line.common());
  command.add_flag("--no-overlap", options.has_no_overlap,
                   "Cut charts where they overlap in the plane, and pack them");
  command.add_flag("--unit-square", options.is_in_unit_square,
                   "Scale the texture coordinates to the unit square");
  add_common_options(command, line.common());
  add_exact(
    command, line.common(),
    "Decide exactly about the flips to the intrinsic Delaunay triangulation, and certify it, "
    "the flat triangulation and the order of their crossings");
}
