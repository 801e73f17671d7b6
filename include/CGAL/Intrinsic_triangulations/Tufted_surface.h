// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_SURFACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCovers
/// a triangulation of a tufted cover, with the vertices of the soup instead of the vertices of the
/// cover. Operators, Poisson equations and the heat method accept it. Functions on it have one
/// value at each vertex of the soup, for any number of vertex fans.
///
/// `cotan_laplacian()`, `mass_matrix()`, `lumped_mass_matrix()` and `divergence_matrix()` of it
/// are sums over the cover times `share()`. By default `share()` is one half, as the cover has two
/// faces for each triangle. So areas are areas of the soup. The Laplacian is positive
/// semidefinite, as without a boundary a Delaunay triangulation has no negative weights.
/// `gradient_matrix()` has two rows for each face of the cover. `Poisson_solver` and
/// `Heat_distance` accept this surface like any other.
///
/// Around a vertex faces need not form one vertex fan, so there are no tangent spaces: vectors live
/// on the cover itself.
///
/// \tparam FT_ a floating point type
/// \cgalModels `IntrinsicSurface`, except that vertices may have several vertex fans
template <typename FT_ = double>
class Tufted_surface
{
public:
  /// the type of lengths.
  typedef FT_ FT;
  /// a readable property map from edges to their lengths.
  typedef boost::iterator_property_map<const FT*, boost::typed_identity_property_map<Edge_index>,
                                       FT, const FT&>
    Length_map;

  /// copies a triangulation of the mesh of `cover`. Edges and faces keep their indices. Inserted
  /// vertices come after the vertices of the soup. Complexity: linear.
  /// \param cover the cover
  /// \param surface a model of `IntrinsicSurface`: the second surface of an
  ///   `Intrinsic_triangulation` of the mesh of `cover`, for example
  /// \param share the factor of the operators
  /// \pre `surface` has no garbage
  template <typename P, typename Surface>
  Tufted_surface(const Tufted_cover<P>& cover, const Surface& surface, const FT& share = FT(1) / 2)
    : m_share(share)
  {
    const Delta_complex& mesh = surface.mesh();
    CGAL_precondition(!mesh.has_garbage());
    const std::size_t inserted = mesh.number_of_vertices() - cover.mesh().number_of_vertices();
    m_mesh.resize(
      static_cast<Delta_complex::size_type>(cover.number_of_input_vertices() + inserted),
      mesh.number_of_edges(), mesh.number_of_faces());
    internal::copy_connectivity(mesh, Numbering<P>{cover}, m_mesh);
    m_length.reserve(mesh.number_of_edges());
    for(Edge_index e : mesh.edges())
      m_length.push_back(get(surface.length_map(), e));
  }

  /// returns the connectivity. Its vertices are the vertices of the soup, with any number of
  /// vertex fans.
  const Delta_complex& mesh() const { return m_mesh; }
  /// returns the lengths of all edges.
  Length_map length_map() const { return Length_map(m_length.data()); }
  /// returns the factor of the operators.
  const FT& share() const { return m_share; }

private:
  template <typename P>
  struct Numbering
  {
    const Tufted_cover<P>& cover;

    Vertex_index vertex(Vertex_index v) const
    {
      return Vertex_index(static_cast<Delta_complex::size_type>(cover.input_vertex(v)));
    }
    Halfedge_index halfedge_of(Halfedge_index h) const { return h; }
    Face_index face(Face_index f) const { return f; }
  };

  Delta_complex m_mesh;
  std::vector<FT> m_length;
  FT m_share;
};

namespace internal {

// Returns the sum of the matrices of the vertex fans, multiplied by the share of the surface.
template <typename FT>
Eigen::SparseMatrix<FT> share_of(Eigen::SparseMatrix<FT> sum, const Tufted_surface<FT>& surface)
{
  sum *= surface.share();
  return sum;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes `surface.share()` times the sum of the cotan Laplacians of the vertex fans, see
/// `cotan_laplacian()`. Complexity: linear.
template <typename FT>
Eigen::SparseMatrix<FT> cotan_laplacian(const Tufted_surface<FT>& surface)
{
  return internal::share_of(cotan_laplacian(internal::view_of(surface)), surface);
}

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes `surface.share()` times the sum of the mass matrices of the vertex fans, see
/// `mass_matrix()`. Complexity: linear.
template <typename FT>
Eigen::SparseMatrix<FT> mass_matrix(const Tufted_surface<FT>& surface)
{
  return internal::share_of(mass_matrix(internal::view_of(surface)), surface);
}

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes `surface.share()` times the sum of the lumped mass matrices of the vertex fans, see
/// `lumped_mass_matrix()`. Complexity: linear.
template <typename FT>
Eigen::SparseMatrix<FT> lumped_mass_matrix(const Tufted_surface<FT>& surface)
{
  return internal::share_of(lumped_mass_matrix(internal::view_of(surface)), surface);
}

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes `surface.share()` times the divergence, see `divergence_matrix()`: its product with
/// `gradient_matrix()` is minus the Laplacian, up to rounding. Complexity: linear.
template <typename FT>
Eigen::SparseMatrix<FT> divergence_matrix(const Tufted_surface<FT>& surface)
{
  return internal::share_of(divergence_matrix(internal::view_of(surface)), surface);
}

#ifndef DOXYGEN_RUNNING
template <typename FT>
FT share_of_operators(const Tufted_surface<FT>& surface)
{
  return surface.share();
}
#endif

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_SURFACE_H
