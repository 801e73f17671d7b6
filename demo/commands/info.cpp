// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Statistics.h"
#include "page/View_page.h"
#include "pictures/Canvas.h"
#include "reading/Mesh_reader.h"
#include "reading/close_points.h"
#include "reading/polygon_splitting.h"
#include "writing/Output.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Info_options
{
  bool is_json = false;
};

constexpr const char* info_help = "Example:\n  intrinsic info bunny.obj --json\n\n"
                                  "Exit code: 0 if the mesh can be worked on, 2 if not.";

// Stores the fatal defects and the notes about a mesh that a command reads.
struct Verdict
{
  IT::Input_diagnosis diagnosis;
  std::string splitting_error; // why polygons cannot be split; empty if they can, or there are none
  Cracks cracks;

  // Returns whether the defect is fatal. Commands split polygons.
  static bool is_fatal(const IT::Defect_description& d)
  {
    return d.is_fatal && d.kind != IT::Defect_kind::NON_TRIANGULAR_FACE;
  }

  bool is_valid() const
  {
    const auto& all = IT::defect_descriptions;
    return splitting_error.empty() && std::none_of(all.begin(), all.end(), [this](const auto& d) {
             return is_fatal(d) && diagnosis.count(d.kind) > 0;
           });
  }
};

Verdict verdict_on(const std::string& path, Polygon_soup soup)
{
  Verdict result{IT::diagnose_polygon_soup(soup.points, soup.polygons), {}, {}};
  if(!result.is_valid())
    return result;
  if(result.diagnosis.count(IT::Defect_kind::NON_TRIANGULAR_FACE) > 0)
    try {
      split_polygons(path, soup, {});
    } catch(const Program_error& e) {
      result.splitting_error = e.what();
      return result;
    }
  result.cracks = cracks(mesh_of(soup));
  return result;
}

// Calls `use` for each defect. Several components are no defect: their number is in the statistics.
template <class Use>
void for_each_defect(const IT::Input_diagnosis& diagnosis, const Use& use)
{
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0 && d.kind != IT::Defect_kind::SEVERAL_COMPONENTS)
      use(d);
}

Statistics defects_of(const IT::Input_diagnosis& diagnosis)
{
  Statistics result = Statistics::array();
  for_each_defect(diagnosis, [&](const IT::Defect_description& d) {
    result.push_back({{"kind", d.name},
                      {"is_fatal", Verdict::is_fatal(d)},
                      {"count", diagnosis.count(d.kind)},
                      {"message", diagnosis.message(d.kind)}});
    if(d.element == IT::Defect_element::CORNER)
      for(const auto& place : diagnosis.occurrences(d.kind))
        result.back()["first"].push_back({{"vertex", place.vertices[0]}, {"face", place.face}});
  });
  return result;
}

Statistics statistics_of(const std::string& input, const Verdict& verdict)
{
  const IT::Input_diagnosis& diagnosis = verdict.diagnosis;
  Statistics result = common_statistics("info", input, diagnosis);
  result["min_angle_degrees"] = diagnosis.statistics().min_angle;
  result["min_edge_length"] = diagnosis.statistics().min_edge_length;
  result["max_edge_length"] = diagnosis.statistics().max_edge_length;
  result["is_valid"] = verdict.is_valid();
  result["defects"] = defects_of(diagnosis);
  if(!verdict.splitting_error.empty())
    result["splitting_error"] = verdict.splitting_error;
  if(verdict.cracks.coincident > 0)
    result["coincident_points"] = verdict.cracks.coincident;
  if(verdict.cracks.close > 0)
    result["close_points"] = verdict.cracks.close;
  return result;
}

void print_line(const char* name, double value)
{
  std::cout << std::left << std::setw(22) << name << std::setprecision(10);
  if(std::isfinite(value))
    std::cout << value << '\n';
  else
    std::cout << "none\n";
}

void print_defects(const Verdict& verdict)
{
  for_each_defect(verdict.diagnosis, [&](const IT::Defect_description& d) {
    std::cout << (Verdict::is_fatal(d) ? "error: " : "note: ") << verdict.diagnosis.message(d.kind)
              << " - "
              << (d.kind == IT::Defect_kind::NON_TRIANGULAR_FACE
                    ? "commands split it, unless --strict is given"
                    : d.sentence)
              << '\n';
  });
  if(!verdict.splitting_error.empty())
    std::cout << "error: " << verdict.splitting_error << '\n';
  for(const std::string& message : verdict.cracks.messages(false))
    std::cout << "note: " << message << '\n';
}

void print_text(const std::string& input, const Polygon_soup& soup, const Verdict& verdict)
{
  const IT::Input_diagnosis::Statistics& s = verdict.diagnosis.statistics();
  std::cout << input << '\n';
  print_line("vertices", static_cast<double>(s.vertices));
  print_line("edges", static_cast<double>(s.edges));
  print_line("faces", static_cast<double>(s.faces));
  print_line("Euler characteristic", static_cast<double>(s.euler_characteristic));
  print_line("boundary loops", static_cast<double>(s.boundary_loops));
  print_line("components", static_cast<double>(s.components));
  print_line("smallest angle", s.min_angle);
  print_line("shortest edge", s.min_edge_length);
  print_line("longest edge", s.max_edge_length);
  print_defects(verdict);
  if(!soup.format.empty())
    std::cout << "note: read as " << soup.format << ", the format of its content\n";
  if(soup.merged_corners > 0)
    std::cout << "note: corners merged because the file has no indices: " << soup.merged_corners
              << '\n';
}

// Returns the outputs, after their paths are checked.
Output checked_output(const Common_options& common)
{
  View_page::check_available("--view", common.view);
  check_picture_available("--picture", common.picture);
  return Output(common.read_files, {common.view, common.picture});
}

void write_page(Output& output, const Common_options& common, const Polygon_soup& soup,
                const Verdict& verdict)
{
  if(!common.is_shown())
    return;
  View_page page;
  show(page, "input", soup);
  page.set_statistics(statistics_of(common.input, verdict));
  output.add(common.view, [&](Text& text) { page.write_html(text); });
  output.add(common.picture, [&](Text& text) { page.write_picture(text, common.picture); });
  output.commit();
}

int info(const Common_options& common, const Info_options& options)
{
  Output output = checked_output(common);
  const Polygon_soup soup = read_mesh(common.input);
  const Verdict verdict = verdict_on(common.input, soup);
  write_page(output, common, soup, verdict);
  if(options.is_json)
    std::cout << text_of(statistics_of(common.input, verdict));
  else
    print_text(common.input, soup, verdict);
  if(!std::cout.flush())
    throw std::runtime_error("standard output could not be written completely");
  return verdict.is_valid() ? 0 : 2;
}

} // namespace

void define_info(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "info", "Print the size, the topology and the defects of a mesh", info, info_help);
  command.add_flag("--json", options.is_json, "Print JSON");
  command.add_option("--view", line.common().view,
                     "HTML file that shows the mesh, and its defects in red");
  command.add_option("--picture", line.common().picture,
                     "SVG or PNG file with a picture of the mesh");
}
