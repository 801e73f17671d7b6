// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "map_commands.h"
#include "sphere_mesh.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <functional>
#include <sstream>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

class Sphere_command
{
public:
  Sphere_command(Command_run& run, const Sphere_options& options, Mesh_format format)
    : m_options(options), m_format(format), m_run(run)
  {}

  void run()
  {
    const Edge_length_map length = m_run.timed("build", [&] { return edge_lengths(m_run); });
    const CM::Spherical_conformal_map map = mapped(length);
    m_run.timed("write", [&] {
      const Output_mesh result = sphere_mesh(map, mesh());
      describe(map, result);
      m_run.add_output(m_options.output, text_of(result, m_format));
      if(!m_options.precise.empty())
        m_run.add_output(m_options.precise, precise_positions(map, mesh()));
    });
    m_run.finish(summary());
  }

private:
  Mesh& mesh() { return m_run.input().mesh; }

  // Throws std::runtime_error if there is no such map.
  CM::Spherical_conformal_map mapped(const Edge_length_map& length)
  {
    Stage_visitor visitor{m_run};
    CM::Spherical_conformal_map result =
      CM::map_to_sphere(mesh(), CM::parameters::edge_length_map(length).visitor(std::ref(visitor)));
    m_run.end_stage();
    check_status(result);
    return result;
  }

  void describe(const CM::Spherical_conformal_map& map, const Output_mesh& result)
  {
    Statistics& statistics = m_run.statistics();
    statistics["disk"] = map.is_disk();
    statistics["iterations"] = map.minimization().iterations;
    statistics["status"] = CM::to_string(map.status());
    statistics["extended_precision"] = map.is_extended();
    statistics["max_curvature_error"] = map.max_curvature_error();
    statistics["max_cross_ratio_error"] = CM::max_cross_ratio_error(map);
    statistics["convex"] = map.certificate().is_convex();
    statistics["concave_edges"] = map.certificate().concave_edges;
    statistics["flipped_triangles"] = map.certificate().flipped_triangles;
    statistics["lost_in_output"] = map.lost_in_output();
    statistics["max_inscribed_error"] = map.max_inscribed_error();
    statistics["bound_violations"] = map.bound_violations();
    describe_sizes(statistics, map, mesh(), result);
  }

  std::string summary()
  {
    const Statistics& s = m_run.statistics();
    std::ostringstream text;
    text << (s["disk"] ? "hemisphere" : "sphere") << ", convex, log scale factors "
         << s["log_scale_min"].get<double>() << " to " << s["log_scale_max"].get<double>() << ", "
         << s["flips"] << " + " << s["ptolemy_flips"] << " flips, " << s["lost_in_output"]
         << " triangles lost by rounding, " << s["subdivision"]["faces"]
         << " faces in the common subdivision";
    return text.str();
  }

  Sphere_options m_options;
  Mesh_format m_format;
  Command_run& m_run;
};

} // namespace

void sphere(Command_run& run, const Sphere_options& options, Mesh_format format)
{
  Sphere_command(run, options, format).run();
}

int sphere(const Common_options& common, const Sphere_options& options)
{
  const Mesh_format format = output_format(options.output, options.format);
  Command_run run("sphere", common, {options.output, options.precise}, 6);
  sphere(run, options, format);
  return 0;
}
