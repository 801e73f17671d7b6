// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Mesh_reader.h"
#include "Output.h"
#include "Statistics.h"
#include "soup_view.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <cmath>
#include <iomanip>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

Statistics defects_of(const IT::Input_diagnosis& diagnosis)
{
  Statistics result = Statistics::array();
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0) {
      result.push_back({{"kind", d.name},
                        {"is_fatal", d.is_fatal},
                        {"count", diagnosis.count(d.kind)},
                        {"message", diagnosis.message(d.kind)}});
      if(d.element == IT::Defect_element::CORNER)
        for(const auto& place : diagnosis.occurrences(d.kind))
          result.back()["first"].push_back({{"vertex", place.vertices[0]}, {"face", place.face}});
    }
  return result;
}

Statistics statistics_of(const std::string& input, const IT::Input_diagnosis& diagnosis)
{
  Statistics result = common_statistics("info", input, diagnosis);
  result["min_angle_degrees"] = diagnosis.statistics().min_angle;
  result["min_edge_length"] = diagnosis.statistics().min_edge_length;
  result["max_edge_length"] = diagnosis.statistics().max_edge_length;
  result["is_valid"] = diagnosis.is_valid();
  result["defects"] = defects_of(diagnosis);
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

void print_text(const std::string& input, const Polygon_soup& soup,
                const IT::Input_diagnosis& diagnosis)
{
  const IT::Input_diagnosis::Statistics& s = diagnosis.statistics();
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
  std::cout << diagnosis;
  if(diagnosis.count(IT::Defect_kind::NON_TRIANGULAR_FACE) > 0)
    std::cout << "note: other commands split polygons, unless --strict is given\n";
  if(soup.merged_corners > 0)
    std::cout << "note: corners merged because the file has no indices: " << soup.merged_corners
              << '\n';
}

void write_page(const Info_options& options, const Polygon_soup& soup,
                const IT::Input_diagnosis& diagnosis)
{
  if(!options.view.empty())
    View_page::check_available();
  check_picture_available(options.picture);
  if(options.view.empty() && options.picture.empty())
    return;
  Output output(options.input, {options.view, options.picture});
  View_page page;
  show(page, "input", soup);
  page.set_statistics(statistics_of(options.input, diagnosis));
  output.add(options.view, [&](Text& text) { page.write_html(text); });
  output.add(options.picture, [&](Text& text) { page.write_picture(text, options.picture); });
  output.commit();
}

} // namespace

int info(const Info_options& options)
{
  const Polygon_soup soup = read_mesh(options.input);
  const IT::Input_diagnosis diagnosis = IT::diagnose_polygon_soup(soup.points, soup.polygons);
  write_page(options, soup, diagnosis);
  if(options.is_json)
    std::cout << text_of(statistics_of(options.input, diagnosis));
  else
    print_text(options.input, soup, diagnosis);
  if(!std::cout.flush())
    throw std::runtime_error("standard output could not be written completely");
  return diagnosis.is_valid() ? 0 : 2;
}
