// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/set_halfedges_of_vertices.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// the polygon mesh into which the edges of \f$T_1\f$ and \f$T_2\f$ together cut the surface
/// (Section 3.3). Its faces are convex polygons with three to six corners, each part of one face of
/// \f$T_1\f$ and one face of \f$T_2\f$.
///
/// Vertices 0 to \f$|V| - 1\f$ are the vertices of \f$T_2\f$, with their indices, and include the
/// vertices of \f$T_1\f$. Vertex \f$|V| + c\f$ is crossing \f$c\f$ of the correspondence. The
/// connectivity is exact. Positions of crossings are rounded, and in order along every edge.
///
/// The sides are the sides of the correspondence: `Side::input` for \f$T_1\f$, and
/// `Side::intrinsic` for \f$T_2\f$. The object refers to the triangulation and is valid until that
/// changes.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
/// \tparam Point the point type of the mesh
template <typename Traits_ = Euclidean_geometry_traits<double>, typename Point = No_point>
class Common_subdivision : public Subdivision_base<Common_subdivision<Traits_, Point>, Side, 2,
                                                   typename Traits_::FT, Point>
{
  typedef Subdivision_base<Common_subdivision, Side, 2, typename Traits_::FT, Point> Base;
  friend Base;

public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of lengths and barycentric coordinates.
  typedef typename Base::FT FT;
  /// the type of numbers of elements.
  typedef typename Base::size_type size_type;

  /// builds the subdivision. Complexity: linear in the vertices, edges and crossings.
  /// \tparam NamedParameters a sequence of named parameters
  /// \param correspondence the crossings
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
  ///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  ///                    `CGAL::Parallel_if_available_tag`}
  ///     \cgalParamDefault{`CGAL::Sequential_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Common_subdivision(const Correspondence<Traits>& correspondence,
                              const NamedParameters& np = CGAL::parameters::default_values())
    : Base({&correspondence.mesh(Side::input), &correspondence.mesh(Side::intrinsic)}),
      m_tri(&correspondence.triangulation())
  {
    Builder(correspondence, concurrency_of(np), *this).build();
  }

  /// returns the position of `v` on `side`. Complexity: constant.
  Surface_point<FT> place(Side side, Vertex_index v) const
  {
    const Trace_point<FT>& p = m_place[v.idx()];
    const Edge_point<FT>& on_edge = side == Side::input ? p.on_input : p.on_intrinsic;
    if(this->is_vertex(side, v))
      return Vertex_location{on_edge.halfedge};
    if(on_edge.halfedge.is_valid())
      return edge_location(on_edge);
    return m_tri->inserted_vertex(v);
  }

private:
  class Builder;

  const Intrinsic_triangulation<Traits>* m_tri;
  // The halfedges are null for isolated vertices. For vertices inserted inside faces, the halfedge
  // of T1 is null.
  std::vector<Trace_point<FT>> m_place;
};

// Cuts each face of T2 into its regions. Each piece of an edge of T2 becomes one edge. So does each
// piece of an edge of T1, unless it lies on a shared part. Parts of T1 come first.
template <typename Traits, typename Point>
class Common_subdivision<Traits, Point>::Builder
{
public:
  Builder(const Correspondence<Traits>& correspondence, Concurrency concurrency,
          Common_subdivision& result)
    : m_concurrency(concurrency),
      m_correspondence(correspondence),
      m_intrinsic(correspondence.mesh(Side::intrinsic)),
      m_input(correspondence.mesh(Side::input)),
      m_marks(correspondence.crossings_on_intrinsic()),
      m_result(result),
      m_mesh(result.mesh())
  {}

  void build()
  {
    const size_type vertices =
                      m_intrinsic.number_of_vertices() + m_correspondence.number_of_crossings(),
                    edges = m_correspondence.number_of_input_pieces() + m_marks.number_of_pieces();
    const size_type faces = number_regions();
    m_result.reserve_parents(edges, faces);
    m_result.m_place.reserve(vertices);
    run_together(
      m_concurrency,
      [&] {
        m_result.resize_parents(edges, faces);
        m_result.m_place.resize(vertices);
        set_parents();
        set_places();
      },
      [&] { m_result.resize_mesh(vertices, edges, faces); });
    for_each<Face_index>(m_intrinsic, [this](Face_index f) { add_regions(f); });
    for_each<Halfedge_index>(m_intrinsic, [this](Halfedge_index h) { link_border(h); });
    set_halfedges_of_vertices(m_mesh, m_concurrency);
  }

private:
  typedef std::array<Halfedge_index, 3> Sides;

  template <typename Index, typename Function>
  void for_each(const Delta_complex& mesh, const Function& f) const
  {
    for_each_in_chunks<Index>(m_concurrency, mesh, f);
  }

  // Returns piece `p` of the halfedge `h` of T2, counted from its source.
  Halfedge_index intrinsic_piece(Halfedge_index h, size_type p) const
  {
    return Halfedge_index(2 * m_correspondence.number_of_input_pieces() +
                          m_marks.piece(h, p).idx());
  }

  internal::Face_regions regions(const Sides& side) const
  {
    std::array<std::size_t, 3> crossings;
    for(std::size_t s = 0; s < 3; ++s)
      crossings[s] = m_marks.size(Edge_index(side[s]));
    return internal::Face_regions(crossings);
  }

  // Numbers the regions face by face, and returns their number.
  size_type number_regions()
  {
    m_first_region.assign(m_intrinsic.num_faces(), 0);
    for_each<Face_index>(m_intrinsic, [this](Face_index f) {
      m_first_region[f.idx()] = static_cast<size_type>(regions(sides(f, m_intrinsic)).size());
    });
    size_type count = 0;
    for(size_type& n : m_first_region)
      count += std::exchange(n, count);
    return count;
  }

  void set_parents()
  {
    for_each<Edge_index>(m_input, [this](Edge_index e) { set_input_parents(e); });
    for_each<Edge_index>(m_intrinsic, [this](Edge_index e) { set_intrinsic_parents(e); });
  }

  void set_input_parents(Edge_index e)
  {
    for(size_type i = 0; i < m_correspondence.number_of_parts(e); ++i) {
      const auto& part = m_correspondence.part(e, i);
      for(size_type p = 0; !part.is_shared && p <= part.count; ++p)
        m_result.set_parent(Side::input, first_halfedge(Edge_index(part.first_piece + p)),
                            first_halfedge(e));
    }
  }

  void set_intrinsic_parents(Edge_index e)
  {
    const Halfedge_index h = first_halfedge(e);
    for(size_type p = 0; p < m_marks.number_of_pieces(e); ++p)
      m_result.set_parent(Side::intrinsic, intrinsic_piece(h, p), h);
    if(m_correspondence.is_shared(Side::intrinsic, e))
      m_result.set_parent(Side::input, intrinsic_piece(h, 0),
                          m_correspondence.outgoing_before(Side::intrinsic, h));
  }

  void set_places()
  {
    const auto& tri = m_correspondence.triangulation();
    for_each<Vertex_index>(m_intrinsic, [&](Vertex_index v) {
      if(m_intrinsic.is_isolated(v))
        return;
      const Halfedge_index outgoing = first_outgoing_halfedge(v, m_intrinsic);
      m_result.m_place[v] = {tri.start_on_outgoing(outgoing), {outgoing, FT(0)}};
    });
    for_each_chunk(m_concurrency, m_correspondence.number_of_crossings(),
                   [&](std::size_t begin, std::size_t end) {
                     for(auto c = static_cast<size_type>(begin); c < end; ++c)
                       m_result.m_place[crossing_vertex(c)] = m_correspondence.crossing(c);
                   });
  }

  Vertex_index crossing_vertex(size_type id) const
  {
    return Vertex_index(m_intrinsic.number_of_vertices() + id);
  }

  typename Correspondence<Traits>::Crossing crossing(const internal::Region_corner& corner,
                                                     const Sides& side) const
  {
    return m_correspondence.crossing(Side::intrinsic, side[corner.side],
                                     static_cast<size_type>(corner.mark));
  }

  Vertex_index vertex(const internal::Region_corner& corner, const Sides& side) const
  {
    return corner.is_vertex()
             ? m_intrinsic.source(side[corner.side])
             : crossing_vertex(m_marks(side[corner.side], static_cast<size_type>(corner.mark)));
  }

  void add_regions(Face_index parent)
  {
    const Sides side = sides(parent, m_intrinsic);
    const internal::Face_regions face_regions = regions(side);
    for(std::size_t m = 0; m < face_regions.size(); ++m) {
      const Face_index f(m_first_region[parent.idx()] + static_cast<size_type>(m));
      m_result.set_parent(Side::intrinsic, f, parent);
      add_region(f, face_regions[m], side);
    }
  }

  void add_region(Face_index f, const internal::Region& region, const Sides& side)
  {
    Face_index input_face;
    std::array<Halfedge_index, 6> halfedge;
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows) {
        const Halfedge_index arc = input_arc(region[c], region.next(c), side, halfedge[c]);
        input_face = m_input.face(arc);
      } else
        halfedge[c] =
          intrinsic_piece(side[region[c].side],
                          static_cast<size_type>(region[c].is_vertex() ? 0 : region[c].mark + 1));
    for(std::size_t c = 0; c < region.size(); ++c) {
      m_mesh.set_next(halfedge[c], halfedge[c + 1 == region.size() ? 0 : c + 1]);
      m_mesh.set_face(halfedge[c], f);
      m_mesh.set_target(halfedge[c], vertex(region.next(c), side));
    }
    m_mesh.set_halfedge(f, halfedge[0]);
    m_result.set_parent(Side::input, f, input_face.is_valid() ? input_face : face_across(side[0]));
  }

  // Returns the face of T1 that contains a face of T2 which no edge of T1 crosses.
  Face_index face_across(Halfedge_index side) const
  {
    const Halfedge_index outgoing = m_correspondence.outgoing_before(Side::intrinsic, side);
    return outgoing.is_valid() ? m_input.face(outgoing)
                               : m_correspondence.triangulation().input_location(side).first;
  }

  // Returns the halfedge of T1 along the curve from one corner of a region to another, and its
  // piece between them.
  Halfedge_index input_arc(const internal::Region_corner& from, const internal::Region_corner& to,
                           const Sides& side, Halfedge_index& piece_of_arc) const
  {
    const auto c = crossing(to.is_vertex() ? from : to, side);
    const Halfedge_index outward = c.across.halfedge;
    piece_of_arc = m_correspondence.piece_to(c.id, outward);
    if(!to.is_vertex())
      return outward;
    piece_of_arc = opposite(piece_of_arc);
    return opposite(outward);
  }

  // Edges on the boundary are shared, so they have one piece each.
  void link_border(Halfedge_index h)
  {
    if(!m_intrinsic.is_border(h))
      return;
    const Halfedge_index x = intrinsic_piece(h, 0);
    m_mesh.set_next(x, intrinsic_piece(m_intrinsic.next(h), 0));
    m_mesh.set_target(x, m_intrinsic.target(h));
  }

  Concurrency m_concurrency;
  const Correspondence<Traits>& m_correspondence;
  const Delta_complex& m_intrinsic;
  const Delta_complex& m_input;
  const Edge_marks& m_marks; // the crossings on the edges of T2
  Common_subdivision& m_result;
  typename Base::Mesh& m_mesh;
  std::vector<size_type> m_first_region; // of each face of T2
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
