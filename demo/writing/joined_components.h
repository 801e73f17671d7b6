// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_JOINED_COMPONENTS_H
#define INTRINSIC_JOINED_COMPONENTS_H

#include "reading/Input_mesh.h"
#include "reading/component_meshes.h"
#include "writing/Map_front.h"
#include "writing/Output_mesh.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// The meshes of maps of the components of an input, in one mesh. The vertices of the input come
// first, with their indices, and stay in their places if they are in no component. Parents in the
// input have the indices of the input; those in other triangulations are counted on from component
// to component.
class Joined_components
{
public:
  // `input` must be there as long as this.
  explicit Joined_components(const Input_mesh& input);

  // Adds the mesh of a map, with the vertices of `front`, after a shift of its points along the x
  // axis. Its texture comes to the right of those before.
  void add(const Component_mesh& component, const Map_front& front, Output_mesh part, double shift);

  // The mesh with the data of the input. Nothing can be added after that.
  Output_mesh finish();

private:
  typedef CGAL::Intrinsic_triangulations::Vertex_weights<double> Weights;

  void add_points(const Component_mesh& component, const Map_front& front, const Output_mesh& part,
                  double shift);
  void add_texture(const Output_mesh& part);
  double texture_shift(const Corner_data& texture);
  std::vector<std::int64_t> parents(const Attribute& a, const Component_mesh& component);
  void add_attributes(const Component_mesh& component, std::vector<Attribute>& from,
                      const std::vector<std::size_t>& places, std::size_t size,
                      std::vector<Attribute>& to);
  void set_input_places();
  void add_input_data();

  const Input_mesh& m_input;
  Output_mesh m_result;
  std::vector<Polygons::Index> m_point; // of the component that is added last
  std::vector<Weights> m_weights;       // of each point, in vertices of the input
  std::vector<std::int64_t> m_face;     // of the input, of each polygon
  std::map<std::string, std::int64_t> m_number_of_parents;
  double m_right = 0; // of the textures so far
};

#endif // INTRINSIC_JOINED_COMPONENTS_H
