// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/flattening_conditions.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"
#include "writing/Mesh_writer.h"
#include "writing/flat_triangles.h"
#include "writing/matrix_market.h"

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

#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// Greedy, except for shapes that need no cones.
Flatten_options with_defaults(Flatten_options options, bool is_exact)
{
  check_boundary(options);
#ifndef INTRINSIC_USE_CERES
  if(options.solver == "ceres")
    throw Program_error("--solver ceres: this program was built without the Ceres Solver; "
                        "install libceres-dev and build again");
#endif
  if(is_exact && options.solver == "cetm")
    throw Program_error(
      "--exact: --solver cetm makes no triangulation Delaunay; leave out one of them");
  if(options.cones.empty())
    options.cones = is_shape(options.boundary) ? "none" : "greedy";
  if(options.maximum_log_scale && options.cones != "greedy")
    throw Program_error("--max-log-scale is for --cones greedy; leave out one of them");
  return options;
}

class Flatten_command
{
public:
  Flatten_command(const Common_options& common, const Flatten_options& options)
    : m_options(with_defaults(options, common.is_exact)),
      m_format(format_with_texture(options)),
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
    const double bound = m_options.cones == "greedy" ? m_options.maximum_log_scale.value_or(5)
                                                     : std::numeric_limits<double>::infinity();
    const auto conditions =
      boost::make_iterator_property_map(m_conditions.begin(), get(boost::vertex_index, mesh()));
    const auto flipping =
      m_options.solver == "cetm" ? DCM::Flipping::none : DCM::Flipping::to_Delaunay;
    return shaped(DCM::parameters::concurrency_tag(CGAL::Parallel_if_available_tag())
                    .mollification(m_mollification)
                    .vertex_condition_map(conditions)
                    .maximum_log_scale(bound)
                    .flipping(flipping)
                    .exact_decisions(m_run.options().is_exact)
                    .minimizer(minimizer)
                    .visitor(std::ref(m_visitor)));
  }

  // Throws Program_error, which names the mesh, if it is not for the shape.
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
      throw Program_error(m_run.options().input + ": " + e.what() +
                          "; try --boundary free or straight");
    }
  }

  // The triangulations of the map and the order of their crossings.
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

  // Cuts and scales charts, if that is wanted.
  void arrange(Planar_map& map)
  {
    if(!map.is_laid_out())
      return;
    if(m_options.has_no_overlap)
      DCM::cut_overlaps(map);
    if(m_options.is_in_unit_square)
      m_run.statistics()["scale"] = DCM::fit_into_unit_square(map);
  }

  // Those that were placed and those of the file.
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
};

// Where the image covers a part of the plane more than once.
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
       << " flips, " << s["flipped_triangles"] << " triangles flipped in the plane, "
       << s["subdivision"]["faces"] << " faces in the common subdivision, " << s["charts"]
       << (s["charts"] == 1 ? " chart" : " charts");
  if(!s["overlapping_charts"].empty())
    text << ", an area of " << s["overlap_area"].get<double>()
         << " covered more than once (--no-overlap cuts there)";
  return text.str();
}

Output_mesh described_mesh(Statistics& statistics, const Planar_map& map, const Map_part& part,
                           const Map_output& output)
{
  const Output_mesh result = flat_mesh(map, part, output.cones, output.is_homogeneous);
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

int flatten(const Common_options& common, const Flatten_options& options)
{
  Flatten_command command(common, options);
  return attempt(command.command_run(), [&] { return command.run(); });
}
