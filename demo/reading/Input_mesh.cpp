// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Input_mesh.h"

#include "Program_error.h"
#include "reading/Mesh_reader.h"
#include "reading/close_points.h"
#include "reading/polygon_splitting.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/local_triangulations.h>

#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

IT::Input_diagnosis diagnose(const Polygon_soup& soup)
{
  return IT::diagnose_polygon_soup(soup.points, soup.polygons);
}

// Returns whether CGAL can repair the soup. Its functions do not check numbers and indices.
bool is_repairable(const IT::Input_diagnosis& diagnosis)
{
  return diagnosis.count(IT::Defect_kind::NON_FINITE_COORDINATE) == 0 &&
         diagnosis.count(IT::Defect_kind::FACE_INDEX_OUT_OF_RANGE) == 0;
}

// Counts the defects that prevent triangles from being an oriented surface.
std::size_t number_of_soup_defects(const IT::Input_diagnosis& diagnosis)
{
  return diagnosis.count(IT::Defect_kind::NON_MANIFOLD_EDGE) +
         diagnosis.count(IT::Defect_kind::NON_MANIFOLD_VERTEX) +
         diagnosis.count(IT::Defect_kind::INCONSISTENT_ORIENTATION);
}

std::size_t number_of_polygons(const IT::Input_diagnosis& diagnosis)
{
  return diagnosis.count(IT::Defect_kind::NON_TRIANGULAR_FACE);
}

bool is_allowed(IT::Defect_kind kind, const Common_options& options)
{
  switch(kind) {
    case IT::Defect_kind::NON_MANIFOLD_EDGE:
    case IT::Defect_kind::NON_MANIFOLD_VERTEX:
    case IT::Defect_kind::NON_ORIENTABLE_COMPONENT:
    case IT::Defect_kind::INCONSISTENT_ORIENTATION: return options.are_soups_allowed;
    case IT::Defect_kind::ZERO_LENGTH_EDGE:
      return options.mollification > 0 || !options.are_positions_used;
    case IT::Defect_kind::LENGTH_OUT_OF_RANGE: return !options.are_positions_used;
    case IT::Defect_kind::NON_TRIANGULAR_FACE: return !options.is_strict;
    default: return false;
  }
}

// Returns advice about fatal defects.
const char* advice(const IT::Input_diagnosis& diagnosis, const Common_options& options)
{
  if(!is_repairable(diagnosis))
    return "; correct it in the file";
  if(diagnosis.count(IT::Defect_kind::LENGTH_OUT_OF_RANGE) > 0)
    return "; scale the mesh";
  if(number_of_soup_defects(diagnosis) > 0 && !options.are_soups_allowed && !options.is_repaired())
    return diagnosis.count(IT::Defect_kind::NON_ORIENTABLE_COMPONENT) > 0
             ? "; --repair cuts it open"
             : "; --repair makes it a surface";
  if(number_of_polygons(diagnosis) > 0 && options.is_strict)
    return "; split it, or leave out --strict";
  return options.is_repaired() ? "; `intrinsic view` shows where" : "; --repair may mend it";
}

void check_acceptable(const std::string& path, const IT::Input_diagnosis& diagnosis,
                      const Common_options& options)
{
  std::string message;
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(d.is_fatal && diagnosis.count(d.kind) > 0 && !is_allowed(d.kind, options))
      message += (message.empty() ? "" : "; ") + diagnosis.message(d.kind);
  if(message.empty())
    return;
  throw Program_error(path + ": " + message + advice(diagnosis, options));
}

void print_repairs(const std::string& path, const Repair_report& report)
{
  for(const auto& [what, count] : report)
    std::cerr << path << ": repaired: " << what << ": " << count << '\n';
}

Repair_report repair_aloud(const std::string& path, Polygon_soup& soup, double weld_distance)
{
  const Repair_report report = repair(soup, weld_distance);
  print_repairs(path, report);
  if(soup.polygons.empty())
    throw Program_error(path + ": has no faces after the repair; " +
                        (weld_distance > 0 ? "use --weld with a distance less than the edge lengths"
                                           : "`intrinsic info` lists the defects of its faces"));
  return report;
}

// Checks that no option needs faces.
void check_cloud(const Common_options& options)
{
  if(options.weld_distance > 0)
    throw Program_error(options.input +
                        ": has points only, and --weld merges points of faces; leave it out");
  if(!options.are_soups_allowed)
    throw Program_error(options.input +
                        ": has points only; exact distances and curves need a surface");
}

// Removes all points except those at the indices `kept`, which are ascending.
void keep_points(const std::vector<std::size_t>& kept, Polygon_soup& soup)
{
  const auto keep = [&](auto& values) {
    for(std::size_t i = 0; i < kept.size(); ++i)
      values[i] = values[kept[i]];
    values.resize(kept.size(), values.front());
  };
  keep(soup.points);
  for(Point_function& f : soup.data.functions)
    keep(f.values);
}

// Removes points at the position of an earlier point, which would count as neighbors.
// Throws Program_error if there are such points, but no repair is wanted.
void remove_copies(const Common_options& options, Polygon_soup& soup, Repair_report& repairs)
{
  const std::vector<std::size_t> first = first_equal_points(soup.points);
  std::vector<std::size_t> kept;
  for(std::size_t i = 0; i < first.size(); ++i)
    if(first[i] == i)
      kept.push_back(i);
    else if(!options.is_repaired())
      throw Program_error(options.input + ": points " + std::to_string(first[i]) + " and " +
                          std::to_string(i) +
                          " are at the same position; --repair merges such points");
  if(kept.size() == first.size())
    return;
  keep_points(kept, soup);
  repairs.emplace_back("points merged with an equal one", first.size() - kept.size());
  print_repairs(options.input, repairs);
}

void triangulate_cloud(const std::string& path, Polygon_soup& soup, std::size_t neighbors)
{
  for(const auto& triangle : IT::local_triangulations(soup.points, neighbors))
    soup.polygons.push_back(triangle);
  if(soup.polygons.empty())
    throw Program_error(path +
                        ": no point has neighbors in two directions; raise --neighbors unless all "
                        "points are on a line");
}

void print_notes(const std::string& path, const Polygon_soup& soup,
                 const IT::Input_diagnosis& diagnosis, bool is_cloud)
{
  const auto note = [&](const std::string& text) {
    std::cerr << path << ": note: " << text << '\n';
  };
  if(!soup.format.empty())
    note("read as " + soup.format + ", the format of its content");
  if(soup.merged_corners > 0)
    note("corners merged because the file has no indices: " + std::to_string(soup.merged_corners));
  if(is_cloud)
    return note("no faces, so the points are triangulated with their neighbors");
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0 && d.kind != IT::Defect_kind::SEVERAL_COMPONENTS)
      note(diagnosis.message(d.kind));
  if(const std::size_t n = diagnosis.statistics().components; n > 1)
    note("connected components: " + std::to_string(n));
  if(!soup.parents.empty())
    note("polygons split into triangles: " + std::to_string(number_of_polygons(diagnosis)));
  if(number_of_soup_defects(diagnosis) > 0)
    note("no oriented surface, so its tufted cover is used");
}

// Reads a soup that the command accepts, after repairs if they are requested. Records diagnosis and
// repairs in `result`.
Polygon_soup acceptable_soup(const Common_options& options, Input_mesh& result)
{
  Polygon_soup soup = read_mesh(options.input, options.number_of_neighbors > 0);
  const bool is_cloud = soup.polygons.empty();
  if(is_cloud)
    check_cloud(options);
  result.diagnosis = diagnose(soup);
  if(options.is_repaired() && is_repairable(result.diagnosis) && !is_cloud) {
    result.repairs = repair_aloud(options.input, soup, options.weld_distance);
    result.diagnosis = diagnose(soup);
  }
  check_acceptable(options.input, result.diagnosis, options);
  return soup;
}

// Splits polygons to triangles, or triangulates a cloud. Updates diagnosis and repairs in `result`.
void triangulate(const Common_options& options, Polygon_soup& soup, bool is_quiet,
                 Input_mesh& result)
{
  const bool is_cloud = soup.polygons.empty();
  if(is_cloud) {
    remove_copies(options, soup, result.repairs);
    triangulate_cloud(options.input, soup, options.number_of_neighbors);
  } else if(number_of_polygons(result.diagnosis) > 0)
    split_polygons(options.input, soup,
                   {options.are_soups_allowed && number_of_soup_defects(result.diagnosis) > 0,
                    options.is_repaired()});
  if(!is_quiet)
    print_notes(options.input, soup, result.diagnosis, is_cloud);
  if(is_cloud || !soup.parents.empty()) {
    result.diagnosis = diagnose(soup);
    check_acceptable(options.input, result.diagnosis, options);
  }
}

} // namespace

Surface_location Input_mesh::as_read(const Surface_location& p) const
{
  const auto& [f, b] = p;
  if(covered && covered->cover.is_back(f)) // from the second corner to the first
    return {Mesh::Face_index(f.idx() / 2), {b[1], b[0], b[2]}};
  if(covered)
    return {Mesh::Face_index(f.idx() / 2), b};
  if(!is_reversed.empty() && is_reversed[f.idx()])
    return {f, {b[2], b[1], b[0]}};
  return p;
}

Input_mesh read_input(const Common_options& options, bool is_quiet)
{
  Input_mesh result;
  Polygon_soup soup = acceptable_soup(options, result);
  const bool is_cloud = soup.polygons.empty();
  triangulate(options, soup, is_quiet, result);
  result.parents = soup.parents;
  result.is_reversed = soup.is_reversed;
  if(!soup.data.empty())
    result.data = {std::move(soup.data), soup.polygons};
  if(is_cloud || number_of_soup_defects(result.diagnosis) > 0) {
    auto cover = IT::tufted_cover(soup.points, soup.polygons);
    result.mesh = cover.mesh();
    result.covered.emplace(Covered_soup{std::move(soup), is_cloud, std::move(cover)});
    return result;
  }
  result.mesh = mesh_of(soup);
  result.cracks = cracks(result.mesh);
  if(!is_quiet)
    for(const std::string& message : result.cracks.messages(options.is_repaired()))
      std::cerr << options.input << ": note: " << message << '\n';
  return result;
}
