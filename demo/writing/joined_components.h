// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_JOINED_COMPONENTS_H
#define INTRINSIC_JOINED_COMPONENTS_H

#include "reading/Input_mesh.h"
#include "reading/component_meshes.h"
#include "writing/Output_mesh.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// Joins the meshes of maps of the components of an input in one mesh. The vertices of the input
// come first, with their indices, and keep their positions if they are in no component. Parents in
// the input have the indices of the input. Indices of parents in other triangulations continue from
// component to component.
class Joined_components
{
public:
  // `input` must outlive this object.
  explicit Joined_components(const Input_mesh& input);

  // Adds the mesh of a map, in which the vertices of the component come first, and shifts its
  // points along the x axis. Its texture is placed to the right of the previous ones.
  void add(const Component_mesh& component, Output_mesh part, double shift);

  // Returns the mesh with the data of the input. Nothing can be added afterwards.
  Output_mesh finish();

private:
  // Adds points, and returns their indices.
  std::vector<std::size_t> add_points(const Component_mesh& component, const Output_mesh& part,
                                      double shift);
  void add_texture(const Output_mesh& part);
  double texture_shift(const Corner_data& texture);
  void count_on(Attribute& a);
  void resize(Attribute& a, std::size_t size) const;
  void add_attributes(std::vector<Attribute>& from, const std::vector<std::size_t>& places,
                      std::size_t size, std::vector<Attribute>& to);

  const Input_mesh& m_input;
  Output_mesh m_result;
  std::vector<Placement::Weights> m_weights; // of each point
  std::vector<Mesh::Face_index> m_faces;     // of the input, of each polygon
  std::map<std::string, double> m_number_of_parents;
  double m_right = 0; // of the textures so far
};

#endif // INTRINSIC_JOINED_COMPONENTS_H
