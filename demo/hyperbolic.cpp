// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "disk_picture.h"
#include "flat_mesh.h"
#include "flattening_conditions.h"
#include "map_commands.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <functional>
#include <sstream>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

class Hyperbolic_command
{
public:
  Hyperbolic_command(Command_run& run, const Hyperbolic_options& options, Mesh_format format)
    : m_options(options), m_format(format), m_run(run)
  {}

  void run()
  {
    m_run.timed("build", [&] {
      m_length = edge_lengths(m_run);
      m_conditions = m_options.cones.empty() ? Conditions(mesh().number_of_vertices())
                                             : prescribed_curvatures(m_options.cones, mesh());
    });
    const CM::Hyperbolic_conformal_map map = uniformized();
    m_run.timed("write", [&] {
      describe_map(map);
      m_run.add_output(
        m_options.output,
        text_of(flat_mesh(map, mesh(), cones(), m_options.is_homogeneous), m_format));
      if(!m_options.picture.empty())
        m_run.add_output(m_options.picture, disk_picture(map, m_options.depth));
    });
    m_run.finish(summary());
  }

private:
  Mesh& mesh() { return m_run.input().mesh; }

  // Throws std::runtime_error if there is no such map.
  CM::Hyperbolic_conformal_map uniformized()
  {
    Stage_visitor visitor{m_run};
    const auto conditions =
      boost::make_iterator_property_map(m_conditions.begin(), get(boost::vertex_index, mesh()));
    CM::Hyperbolic_conformal_map result =
      CM::uniformize_hyperbolic(mesh(), CM::parameters::vertex_condition_map(conditions)
                                          .edge_length_map(m_length)
                                          .visitor(std::ref(visitor)));
    m_run.end_stage();
    check_status(result);
    return result;
  }

  std::vector<Mesh::Vertex_index> cones()
  {
    std::vector<Mesh::Vertex_index> result;
    for(const Mesh::Vertex_index v : mesh().vertices())
      if(m_conditions[v].value != 0)
        result.push_back(v);
    return result;
  }

  void describe_map(const CM::Hyperbolic_conformal_map& map)
  {
    Statistics& statistics = m_run.statistics();
    statistics["cones"] = cones().size();
    statistics["iterations"] = map.minimization().iterations;
    statistics["status"] = CM::to_string(map.status());
    statistics["max_curvature_error"] = map.max_curvature_error();
    statistics["max_gluing_error"] = map.max_gluing_error();
    statistics["area"] = map.area();
    statistics["radius"] = map.radius();
    // edges are straight in Klein's disk
    const Output_mesh straight = flat_mesh(map, mesh(), cones(), true);
    describe_triangles(statistics, straight);
    describe_sizes(statistics, map, mesh(), straight);
    statistics["groups"] = Statistics::array();
    for(std::size_t c = 0; c < map.number_of_components(); ++c)
      statistics["groups"].push_back(description(map.group(c)));
  }

  // Generators as real and imaginary parts of a and b; the relation as numbers of generators, from
  // 1, negative for inverse ones.
  static Statistics description(const CM::Fuchsian_group& group)
  {
    Statistics result{{"genus", group.genus}, {"area", group.area}};
    if(!group.relation.empty())
      result["relation_error"] = group.relation_error;
    result["generators"] = Statistics::array();
    for(const CM::Disk_motion<>& motion : group.generators)
      result["generators"].push_back(motion.entries());
    result["relation"] = Statistics::array();
    for(const auto& letter : group.relation) {
      const auto number = static_cast<std::int64_t>(letter.generator) + 1;
      result["relation"].push_back(letter.is_inverse ? -number : number);
    }
    return result;
  }

  std::string summary()
  {
    const Statistics& s = m_run.statistics();
    std::ostringstream text;
    text << "area " << s["area"].get<double>() << ", log scale factors "
         << s["log_scale_min"].get<double>() << " to " << s["log_scale_max"].get<double>() << ", "
         << s["flips"] << " + " << s["ptolemy_flips"] << " flips, curvature error "
         << s["max_curvature_error"].get<double>() << ", gluing error "
         << s["max_gluing_error"].get<double>();
    return text.str();
  }

  Hyperbolic_options m_options;
  Mesh_format m_format;
  Command_run& m_run;
  Edge_length_map m_length;
  Conditions m_conditions;
};

} // namespace

void hyperbolic(Command_run& run, const Hyperbolic_options& options, Mesh_format format)
{
  Hyperbolic_command(run, options, format).run();
}

int hyperbolic(const Common_options& common, const Hyperbolic_options& options)
{
  const Mesh_format format = format_with_texture(options.output, options.format);
  Command_run run("hyperbolic", common, {options.output, options.picture}, 6);
  hyperbolic(run, options, format);
  return 0;
}
