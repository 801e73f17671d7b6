// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Map_part.h"

#include "writing/subdivision_elements.h"

#include <utility>

Placement::Weights Map_part::weights(Vertex_index v) const
{
  Placement::Weights result = m_part->input_weights(v);
  for(std::size_t c = 0; m_component && c < result.size; ++c)
    result.vertex[c] = m_component->vertices[result.vertex[c]];
  return result;
}

Point Map_part::input_point(Vertex_index v) const
{
  const auto w = weights(v);
  if(w.size == 1)
    return m_input->point(w.vertex[0]);
  Kernel::Vector_3 result = CGAL::NULL_VECTOR;
  for(std::size_t c = 0; c < w.size; ++c)
    result += w.weight[c] * (m_input->point(w.vertex[c]) - CGAL::ORIGIN);
  return CGAL::ORIGIN + result;
}

std::vector<Point> Map_part::input_points() const
{
  std::vector<Point> result;
  result.reserve(vertices().size());
  for(const Vertex_index v : vertices())
    result.push_back(input_point(v));
  return result;
}

std::vector<double> Map_part::interpolated(const std::vector<double>& values) const
{
  std::vector<double> result;
  result.reserve(vertices().size());
  for(const Vertex_index v : vertices())
    result.push_back(interpolated(v, [&](Vertex_index u) { return values[u]; }));
  return result;
}

Eigen::SparseMatrix<double> Map_part::interpolation_matrix() const
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t row = 0; row < vertices().size(); ++row) {
    const auto w = weights(vertices()[row]);
    for(std::size_t c = 0; c < w.size; ++c)
      if(w.weight[c] != 0)
        entries.emplace_back(int(row), int(w.vertex[c].idx()), w.weight[c]);
  }
  Eigen::SparseMatrix<double> result(Eigen::Index(vertices().size()),
                                     Eigen::Index(m_input->number_of_vertices()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void Map_part::add_elements(const char* last, Output_mesh& result) const
{
  add_edges_and_polygons(*this, result);
  const auto vertex = [*this](Vertex_index v) {
    return m_part->is_of_input(v) ? number_of(weights(v).vertex[0]) : -1;
  };
  add_attribute(result.point_data, "input_vertex", *this, &Map_part::vertices, vertex);
  const auto in_input = [component = m_component](auto own) {
    return number_of(component == nullptr || !own.is_valid() ? own : component->parent(own));
  };
  add_parents(*this, Layer::A, "input", in_input, result);
  const auto number = [](auto parent) { return number_of(parent); };
  add_parents(*this, Layer::B, "intrinsic", number, result);
  add_parents(*this, Layer::C, last, number, result);
  set_placement(
    *this, [*this](Vertex_index v) { return weights(v); },
    [*this](Face_index f) {
      const Face_index own = subdivision().parent_face(Layer::A, f);
      return m_component ? m_component->parent(own) : own;
    },
    result);
}
