// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_mesh.h"

#include "Mesh_reader.h"
#include "Program_error.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

IT::Input_diagnosis diagnose(const Polygon_soup& soup)
{
  return IT::diagnose_polygon_soup(soup.points, soup.polygons);
}

// CGAL's repair functions take numbers and indices for granted.
bool is_repairable(const IT::Input_diagnosis& diagnosis)
{
  return diagnosis.count(IT::Defect_kind::NON_FINITE_COORDINATE) == 0 &&
         diagnosis.count(IT::Defect_kind::FACE_INDEX_OUT_OF_RANGE) == 0;
}

bool is_acceptable(const IT::Input_diagnosis& diagnosis, const Input_tolerance& tolerance)
{
  const std::size_t allowed =
    tolerance.are_zero_lengths_allowed ? diagnosis.count(IT::Defect_kind::ZERO_LENGTH_EDGE) : 0;
  return diagnosis.number_of_fatal_defects() == allowed;
}

Repair_report repair_aloud(const std::string& path, Polygon_soup& soup)
{
  const Repair_report report = repair(soup);
  for(const auto& [what, count] : report)
    std::cerr << path << ": repaired: " << what << ": " << count << '\n';
  if(soup.polygons.empty())
    throw Program_error(path + ": has no faces after the repair");
  return report;
}

void print_notes(const std::string& path, const Polygon_soup& soup,
                 const IT::Input_diagnosis& diagnosis)
{
  if(soup.merged_corners > 0)
    std::cerr << path
              << ": note: corners merged because the file has no indices: " << soup.merged_corners
              << '\n';
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0)
      std::cerr << path << ": note: " << diagnosis.message(d.kind) << '\n';
}

} // namespace

Input_mesh read_input(const std::string& path, const Input_tolerance& tolerance, bool is_quiet)
{
  Polygon_soup soup = read_mesh(path);
  Input_mesh result;
  result.diagnosis = diagnose(soup);
  if(tolerance.is_repair_wanted && is_repairable(result.diagnosis)) {
    result.repairs = repair_aloud(path, soup);
    result.diagnosis = diagnose(soup);
  }
  if(!is_acceptable(result.diagnosis, tolerance))
    throw Program_error(path + ": " + result.diagnosis.message());
  if(!is_quiet)
    print_notes(path, soup, result.diagnosis);
  result.mesh = mesh_of(soup);
  return result;
}
