// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/concurrency/for_each_in_chunks.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Collects the entries of a sparse matrix; entries at one place add up.
template <typename Scalar>
class Sparse_assembly
{
public:
  explicit Sparse_assembly(std::size_t expected) { m_entries.reserve(expected); }

  void add(std::size_t row, std::size_t column, const Scalar& value)
  {
    m_entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  }

  void add(Vertex_index row, Vertex_index column, const Scalar& value)
  {
    add(row.idx(), column.idx(), value);
  }

  // adds the entries of another one
  void append(const Sparse_assembly& other)
  {
    m_entries.insert(m_entries.end(), other.m_entries.begin(), other.m_entries.end());
  }

  std::size_t size() const { return m_entries.size(); }

  Eigen::SparseMatrix<Scalar> matrix(std::size_t rows, std::size_t columns) const
  {
    Eigen::SparseMatrix<Scalar> result(static_cast<int>(rows), static_cast<int>(columns));
    result.setFromTriplets(m_entries.begin(), m_entries.end());
    return result;
  }

private:
  std::vector<Eigen::Triplet<Scalar>> m_entries;
};

// Returns the symmetric matrix with `diagonal[v]` on the diagonal and `on_edge[e]` at the two
// places of the vertices of edge e. Entries at one place add up. Rows of isolated vertices are
// empty.
//
// Where many edges are parallel this is much faster than all entries in a `Sparse_assembly`.
template <typename Scalar>
Eigen::SparseMatrix<Scalar> symmetric_matrix(const Delta_complex& mesh,
                                             std::vector<Scalar> diagonal,
                                             const std::vector<Scalar>& on_edge)
{
  Sparse_assembly<Scalar> upper(mesh.number_of_edges() + mesh.number_of_vertices());
  for(Edge_index e : mesh.edges()) {
    const auto [i, j] = std::minmax({mesh.vertex(e, 0), mesh.vertex(e, 1)});
    if(i == j)
      diagonal[i.idx()] += 2 * on_edge[e.idx()];
    else
      upper.add(i, j, on_edge[e.idx()]);
  }
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      upper.add(v, v, diagonal[v.idx()]);
  return upper.matrix(diagonal.size(), diagonal.size()).template selfadjointView<Eigen::Upper>();
}

// Returns what `add(f, assembly)` adds for the faces f of `mesh`, in their order.
template <typename Scalar, typename Add>
Sparse_assembly<Scalar> assembled_by_faces(Concurrency concurrency, const Delta_complex& mesh,
                                           const Add& add)
{
  std::vector<Sparse_assembly<Scalar>> chunks(number_of_chunks(mesh.num_faces()),
                                              Sparse_assembly<Scalar>(0));
  for_each_chunk(concurrency, mesh.num_faces(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f)
      if(const Face_index face(static_cast<Delta_complex::size_type>(f)); !mesh.is_removed(face))
        add(face, chunks[begin / chunk_size]);
  });
  std::size_t size = 0;
  for(const auto& chunk : chunks)
    size += chunk.size();
  Sparse_assembly<Scalar> result(size);
  for(const auto& chunk : chunks)
    result.append(chunk);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
