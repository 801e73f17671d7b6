// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Program_error.h"
#include "commands/Command_line.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "reading/surface_points.h"
#include "reading/vertex_values.h"
#include "writing/Text.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Transfer_options
{
  std::string output;
  std::string points;           // a file; empty if functions are transferred
  std::string data;             // a file; empty if points are
  bool is_back = false;         // from the intrinsic triangulation to the mesh
  Refinement_bounds refinement; // none without an angle
};

constexpr const char* transfer_help =
  R"(With --points, each line of the output has two positions FACE:a,b,c: on the mesh and on the
intrinsic triangulation. With --back, such lines are read. With --data, the output has a value for
each vertex of the other triangulation, in lines "index value". These are the values of the closest
piecewise linear function in the L2 norm, which has the same integral. Faces and vertices of the
intrinsic triangulation are numbered as in the file of --save. The statistics have the greatest
error of points or values after mapping them to the other triangulation and back.

Examples:
  intrinsic transfer bunny.obj --points points.txt -o mapped.txt
  intrinsic transfer bunny.obj --data heights.txt --min-angle 25 -o refined.txt --stats s.json)";

using Correspondence = IT::Correspondence<Triangulation::Traits>;

void write(Text& text, const Surface_location& p)
{
  text << std::size_t(p.first.idx()) << ':' << p.second[0] << ',' << p.second[1] << ','
       << p.second[2];
}

// Calls use(text) with the point of each line. If `may_be_second`, lines may have two points, as
// this command writes them, and the last one counts. Errors name the line.
template <typename Use>
void for_each_point(const std::string& path, bool may_be_second, const Use& use)
{
  bool is_empty = true;
  for_each_line(path, [&](const std::vector<std::string>& words, std::size_t line) {
    is_empty = false;
    try {
      const bool is_pair =
        may_be_second && words.size() == 2 && words[1].find(':') != std::string::npos;
      if(words.size() > 1 && !is_pair)
        throw Program_error("'" + words[1] +
                            "' follows a point; lines of two points are for --back, and "
                            "coordinates have commas and no blanks between them, such as 1,0,2.5");
      use(words.back());
    } catch(const Program_error& e) {
      throw Program_error(path + ": line " + std::to_string(line) + ": " + e.what());
    }
  });
  if(is_empty)
    throw Program_error(path + ": has no points; write one in each line");
}

class Transfer_command
{
public:
  Transfer_command(const Common_options& common, const Transfer_options& options)
    : m_options(options),
      m_side(options.is_back ? IT::Side::intrinsic : IT::Side::input),
      m_run("transfer", common, {options.output})
  {
    if(options.points.empty() == options.data.empty())
      throw Program_error("give --points or --data, and not both");
    check_insertions(options.refinement);
    m_run.plan({delaunay_stages,
                refinement_stages(options.refinement),
                certificate_stages(common),
                {"transfer"},
                view_stages(common)});
  }

  int run()
  {
    m_points.clear();
    m_text.take();
    Triangulation triangulation = make_delaunay_triangulation(m_run);
    refine_if_wanted(m_run, triangulation, m_options.refinement);
    describe(m_run, triangulation);
    m_run.timed("transfer", [&] {
      const Correspondence correspondence(triangulation);
      m_options.data.empty() ? transfer_points(correspondence) : transfer_data(correspondence);
    });
    show(triangulation);
    m_run.timed("write", [&] {
      m_run.add_output(m_options.output, m_text.take());
      save(m_run, triangulation);
    });
    m_run.finish(summary_of_changes(m_run) + ", " + m_summary);
    return 0;
  }

  Command_run& command_run() { return m_run; }

private:
  IT::Side other() const
  {
    return m_side == IT::Side::input ? IT::Side::intrinsic : IT::Side::input;
  }

  // ---- Points ----

  Surface_location point(const std::string& text, const Correspondence& correspondence)
  {
    return m_side == IT::Side::input
             ? surface_point(text, m_run.input())
             : face_point(text, correspondence.mesh(m_side).number_of_faces());
  }

  void transfer_points(const Correspondence& correspondence)
  {
    double error = 0;
    for_each_point(m_options.points, m_options.is_back, [&](const std::string& text) {
      error = (std::max)(error, transfer_point(point(text, correspondence), correspondence));
    });
    const std::size_t number = m_points.size();
    m_run.statistics()["points"] = number;
    m_run.statistics()["greatest_error_there_and_back"] = error;
    m_summary = std::to_string(number) + " points";
  }

  // Writes a point and its image. Returns how far it is from the image of its image.
  double transfer_point(const Surface_location& here, const Correspondence& correspondence)
  {
    const Surface_location there = IT::point_across(correspondence, m_side, here);
    const Surface_location back = IT::point_across(correspondence, other(), there);
    const Surface_location& on_input = m_options.is_back ? there : here;
    const Surface_location again =
      m_options.is_back ? IT::point_across(correspondence, m_side, back) : back;
    m_points.push_back(on_input);
    write(m_text, m_run.input().as_read(on_input));
    m_text << ' ';
    write(m_text, m_options.is_back ? here : there);
    m_text << '\n';
    const Mesh& mesh = m_run.input().mesh;
    return std::sqrt(CGAL::squared_distance(position(on_input, mesh), position(again, mesh)));
  }

  // ---- Functions ----

  Eigen::VectorXd values(std::size_t size) const
  {
    const auto lines = read_vertex_values(m_options.data, size);
    if(lines.size() != size)
      throw Program_error(m_options.data + ": has values for " + std::to_string(lines.size()) +
                          " of " + std::to_string(size) + " vertices; give one to each");
    Eigen::VectorXd result(static_cast<Eigen::Index>(size));
    for(const Vertex_value& line : lines)
      result[static_cast<Eigen::Index>(line.vertex)] = line.value;
    return result;
  }

  static double integral(const Triangulation& triangulation, IT::Side side,
                         const Eigen::VectorXd& values)
  {
    return (IT::lumped_mass_matrix(triangulation.surface(side)) * values).sum();
  }

  void transfer_data(const Correspondence& correspondence)
  {
    const Triangulation& triangulation = correspondence.triangulation();
    const Eigen::VectorXd here = values(correspondence.mesh(m_side).number_of_vertices());
    const Eigen::VectorXd there = IT::transfer_function(correspondence, m_side, here);
    const Eigen::VectorXd back = IT::transfer_function(correspondence, other(), there);
    for(Eigen::Index v = 0; v < there.size(); ++v)
      m_text << static_cast<std::size_t>(v) << ' ' << there[v] << '\n';
    m_function.assign(here.begin(), here.end());
    m_transferred_function.assign(there.begin(), there.end());
    Statistics& s = m_run.statistics();
    s["values"] = here.size();
    s["transferred_values"] = there.size();
    s["integral"] = integral(triangulation, m_side, here);
    s["transferred_integral"] = integral(triangulation, other(), there);
    s["greatest_error_there_and_back"] = (back - here).cwiseAbs().maxCoeff();
    m_summary = std::to_string(there.size()) + " values";
  }

  // ---- The page ----

  // Shows the function. Points come after the points of the subdivision. Pages of large meshes have
  // one function.
  void show(const Triangulation& triangulation)
  {
    m_run.show([&](View_page& page) {
      const Subdivision subdivision = subdivide(m_run, triangulation);
      Output_mesh mesh = subdivision_mesh(subdivision);
      std::vector<Attribute> intrinsic;
      if(!m_options.data.empty()) {
        const auto add = [&](const char* name, IT::Side side, const std::vector<double>& values) {
          mesh.point_data.push_back({name, interpolated(side, values, subdivision)});
          if(side == IT::Side::intrinsic)
            intrinsic.push_back({name, values});
        };
        add("function", m_side, m_function);
        add("transferred_function", other(), m_transferred_function);
      }
      Surface_marks marks{"points", false, {}, {}, {}};
      for(const Surface_location& p : m_points) {
        marks.points.push_back(static_cast<std::int64_t>(mesh.points.size()));
        mesh.points.push_back(position(p, m_run.input().mesh));
      }
      ::show(page, m_run, triangulation, subdivision, std::move(mesh), std::move(intrinsic));
      page.add_marks(std::move(marks));
    });
  }

  const Transfer_options& m_options;
  IT::Side m_side; // of what is given
  Command_run m_run;
  std::vector<Surface_location> m_points; // on the input
  std::vector<double> m_function, m_transferred_function;
  Text m_text;
  std::string m_summary;
};

} // namespace

void define_transfer(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "transfer", "Map points or functions to the intrinsic triangulation, or back",
    attempted<Transfer_command, Transfer_options>, transfer_help);
  command.add_option("-o,--output", options.output, "Text file; - for standard output")->required();
  add_read_file(command, line.common(), "--points", options.points,
                "Text file of points, one in a line: a vertex, FACE:a,b,c (barycentric), or x,y,z "
                "(nearest)");
  add_read_file(command, line.common(), "--data", options.data,
                "Text file of values at vertices: index value");
  command.add_flag("--back", options.is_back,
                   "Map points and values from the intrinsic triangulation to the mesh");
  add_save(command, line.common());
  add_common_options(command, line.common());
  add_exact(command, line.common());
  add_angle(command, options.refinement);
}
