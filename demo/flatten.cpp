// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Fixed_point_acceleration.h"
#include "Mesh_writer.h"
#include "Program_error.h"
#include "boundary_shapes.h"
#include "flat_mesh.h"
#include "flattening_conditions.h"
#include "map_commands.h"
#include "matrix_market.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flat_modulus.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/surface_type.h>
#ifdef INTRINSIC_USE_CERES
#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#endif

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <complex>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

// Greedy, except for shapes that need no cones.
Flatten_options with_defaults(Flatten_options options)
{
  check_boundary(options.boundary);
#ifndef INTRINSIC_USE_CERES
  if(options.solver == "ceres")
    throw Program_error("--solver ceres: this program was built without the Ceres Solver");
#endif
  const bool is_shape = options.boundary[0] == "rectangle" || options.boundary[0] == "disk";
  if(options.cones.empty())
    options.cones = is_shape ? "none" : "greedy";
  if(options.maximum_log_scale && options.cones != "greedy")
    throw Program_error("--max-log-scale is for --cones greedy");
  return options;
}

class Flatten_command
{
public:
  // Has the default options, and the format of the output.
  Flatten_command(Command_run& run, const Flatten_options& options, Mesh_format format)
    : m_options(options), m_format(format), m_run(run)
  {}

  void run()
  {
    m_conditions = m_run.timed("build", [&] {
      m_length = edge_lengths(m_run);
      return flattening_conditions(m_options, mesh(), m_run.options().input);
    });
    m_log_scale.resize(mesh().number_of_vertices(), 0);
    const CM::Planar_conformal_map map =
      m_options.boundary[0] == "disk" ? flattened_to_disk() : flattened();
    check_status(map);
    m_run.timed("write", [&] {
      const Output_mesh result = flat_mesh(map, mesh(), cones(map), m_options.is_homogeneous);
      describe_map(map, result);
      m_run.add_output(m_options.output, text_of(result, m_format));
      if(!m_options.matrix.empty())
        m_run.add_output(m_options.matrix, matrix_market(interpolation_matrix(map, mesh()),
                                                         Matrix_symmetry::GENERAL));
    });
    m_run.finish(summary());
  }

private:
  Mesh& mesh() { return m_run.input().mesh; }

  // Throws std::runtime_error if there is no map.
  CM::Planar_conformal_map flattened()
  {
    CM::Planar_conformal_map result = solved();
    m_run.end_stage();
    if(result.status() != CM::Map_status::layout_collapsed) // which may be so before the last round
      check_status(result);
    for(const Mesh::Vertex_index v : mesh().vertices())
      m_log_scale[v] = result.log_scale(CM::Vertex_index(v.idx()));
    return result;
  }

  CM::Planar_conformal_map solved()
  {
#ifdef INTRINSIC_USE_CERES
    if(m_options.solver == "ceres")
      return flattened_by(CM::Ceres_minimizer());
#endif
    return flattened_by(CM::Newton_minimizer());
  }

  template <class Minimizer>
  CM::Planar_conformal_map flattened_by(const Minimizer& minimizer)
  {
    Stage_visitor visitor{m_run};
    const double bound = m_options.cones == "greedy" ? m_options.maximum_log_scale.value_or(5)
                                                     : std::numeric_limits<double>::infinity();
    const auto by_vertex = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh()));
    };
    const auto flipping =
      m_options.solver == "cetm" ? CM::Flipping::none : CM::Flipping::to_Delaunay;
    return CM::flatten(mesh(), CM::parameters::edge_length_map(m_length)
                                 .vertex_condition_map(by_vertex(m_conditions))
                                 .maximum_log_scale(bound)
                                 .initial_log_scale_map(by_vertex(m_log_scale))
                                 .flipping(flipping)
                                 .minimizer(minimizer)
                                 .visitor(std::ref(visitor)));
  }

  Eigen::VectorXd prescribed() const
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(m_conditions.size()));
    for(std::size_t v = 0; v < m_conditions.size(); ++v)
      result[static_cast<Eigen::Index>(v)] = m_conditions[v].value;
    return result;
  }

  // Prescribes these exterior angles, unless one is too great for a boundary.
  void set_boundary(const Eigen::VectorXd& angle)
  {
    Conditions result = m_conditions;
    for(const Mesh::Vertex_index v : mesh().vertices())
      if(mesh().is_border(v) && !mesh().is_isolated(v)) {
        result[v].value = angle[static_cast<Eigen::Index>(v)];
        if(!(result[v].value < CGAL_PI))
          return;
      }
    m_conditions = result;
  }

  // The exterior angles that a circle has depend on the lengths in the result.
  CM::Planar_conformal_map flattened_to_disk()
  {
    constexpr int maximum_number_of_rounds = 100;
    constexpr double tolerance = 1e-10; // radians
    double change = 0;
    Fixed_point_acceleration acceleration;
    for(int i = 0; i < maximum_number_of_rounds; ++i) {
      CM::Planar_conformal_map result = flattened();
      m_iterations += result.minimization().iterations;
      const Eigen::VectorXd angles = prescribed();
      change = set_circle(m_conditions, mesh(), boundary_lengths(result));
      if(change <= tolerance)
        return result;
      set_boundary(acceleration.next(angles, prescribed()));
    }
    std::ostringstream text;
    text << "the boundary has not become a circle: after " << maximum_number_of_rounds
         << " rounds its angles still change by " << change << " radians";
    throw std::runtime_error(text.str());
  }

  // Those that were placed and those of the file.
  std::vector<Mesh::Vertex_index> cones(const CM::Planar_conformal_map& map)
  {
    std::vector<Mesh::Vertex_index> result;
    for(const CM::Vertex_index v : map.cones())
      result.emplace_back(v.idx());
    for(const Mesh::Vertex_index v : mesh().vertices())
      if(!mesh().is_border(v) && m_conditions[v].value != 0)
        result.push_back(v);
    return result;
  }

  void describe_map(const CM::Planar_conformal_map& map, const Output_mesh& result)
  {
    Statistics& statistics = m_run.statistics();
    statistics["cones"] = cones(map).size();
    statistics["iterations"] = (std::max)(m_iterations, map.minimization().iterations);
    statistics["status"] = CM::to_string(map.status());
    statistics["max_curvature_error"] = map.max_curvature_error();
    statistics["max_cross_ratio_error"] = CM::max_cross_ratio_error(map);
    describe_triangles(statistics, result);
    if(m_options.is_modulus_wanted)
      describe_modulus(map);
    describe_sizes(statistics, map, mesh(), result);
  }

  void describe_modulus(const CM::Planar_conformal_map& map)
  {
    const bool is_torus = CM::surface_type(mesh()) == CM::Surface_type::torus;
    const std::complex<double> modulus =
      is_torus ? CM::torus_modulus(map) : std::complex<double>(0, CM::annulus_modulus(map));
    m_run.statistics()["modulus"] = {modulus.real(), modulus.imag()};
  }

  std::string summary()
  {
    const Statistics& s = m_run.statistics();
    std::ostringstream text;
    text << s["cones"] << " cones, log scale factors " << s["log_scale_min"].get<double>() << " to "
         << s["log_scale_max"].get<double>() << ", " << s["flips"] << " + " << s["ptolemy_flips"]
         << " flips, " << s["flipped_triangles"] << " triangles flipped in the plane, "
         << s["subdivision"]["faces"] << " faces in the common subdivision";
    return text.str();
  }

  Flatten_options m_options;
  Mesh_format m_format;
  Command_run& m_run;
  Edge_length_map m_length;
  Conditions m_conditions;
  std::vector<double> m_log_scale; // of each vertex: what the next minimization starts from
  std::size_t m_iterations = 0;    // of all rounds, for a disk
};

} // namespace

void flatten(Command_run& run, const Flatten_options& options, Mesh_format format)
{
  Flatten_command(run, options, format).run();
}

int flatten(const Common_options& common, const Flatten_options& given)
{
  const Flatten_options options = with_defaults(given);
  const Mesh_format format = format_with_texture(options.output, options.format);
  Command_run run("flatten", common, {options.output, options.matrix}, 7);
  flatten(run, options, format);
  return 0;
}
