// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMPONENT_MAPS_H
#define INTRINSIC_COMPONENT_MAPS_H

#include "commands/Command_run.h"
#include "commands/Statistics.h"
#include "commands/map_commands.h"
#include "reading/component_meshes.h"
#include "writing/joined_components.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Returns the values at the vertices of a component.
std::vector<double> part_of(const std::vector<double>& values, const Component_mesh& component);

// Returns the number, the sizes and the first face of the only component that is mapped.
Statistics description_of_component(const Command_run& run);

// Maps each component of the input separately, and joins the results. Plane images and spheres are
// arranged side by side.
class Component_maps
{
public:
  // Throws Program_error if a page or a picture is requested, because these show one component.
  explicit Component_maps(Command_run& run);

  std::size_t size() const { return m_components.size(); }
  Component_mesh component(std::size_t c) const;

  // Calls `map(component, statistics)` for each component. This adds its map and returns a summary.
  // The statistics contain the result of each component. Throws the first error with the number of
  // the component: Invalid_input or Map_failure. If failures are written, omits the component
  // instead.
  void for_each(const std::function<std::string(const Component_mesh&, Statistics&)>& map);

  // Adds a map, and returns its summary. Throws Map_failure as `check_status()` does.
  template <class Map>
  std::string add(const Component_mesh& component, Statistics& statistics, const Map& map,
                  const Map_output& output)
  {
    check_status(m_run, map, map.is_laid_out());
    m_exit_code = (std::max)(m_exit_code, exit_code(map));
    const Map_part part(map, m_run.input().mesh, &component);
    Output_mesh mesh = described_mesh(statistics, map, part, output);
    describe_crowding(m_run, statistics, map, &component);
    m_joined.add(component, std::move(mesh),
                 std::is_same<Map, Spherical_map>::value ? next_center(statistics) : 0);
    return summary_of(map, statistics);
  }

  // Sets the abscissa of the center of the first sphere, which is the origin by default.
  void set_first_center(double x) { m_center = x; }

  // Adds the mesh to the outputs, and ends the run. Returns the exit code. Throws Map_failure if no
  // component has a map.
  int finish(const Map_output& output);

private:
  void leave_out(std::size_t component, const std::exception& e, Statistics& statistics);
  double next_center(Statistics& statistics);
  std::string name(std::size_t component) const;

  Command_run& m_run;
  std::vector<std::vector<Mesh::Face_index>> m_components;
  Joined_components m_joined;
  double m_center = 0;
  int m_exit_code = 0;
  std::size_t m_number_left_out = 0;
  std::vector<std::string> m_summaries;
};

#endif // INTRINSIC_COMPONENT_MAPS_H
