// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Polygon_soup.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;

typedef Mesh::size_type Index;

// Numbers the edges, then sets all of the connectivity at once.
template <class Mesh>
class Mesh_builder
{
public:
  Mesh_builder(std::size_t number_of_points, const Polygons& polygons)
    : m_number_of_points(static_cast<Index>(number_of_points)),
      m_polygons(polygons),
      m_halfedge(polygons.number_of_corners())
  {}

  // Returns the mesh, which must not be used if the connectivity is not a surface.
  Mesh operator()()
  {
    count_ascending_sides();
    number_ascending_sides();
    sort_edges();
    number_descending_sides();
    m_mesh.resize(m_number_of_points, static_cast<Index>(m_edges.size()),
                  static_cast<Index>(m_polygons.size()));
    set_ends();
    set_faces();
    link_border();
    return std::move(m_mesh);
  }

  bool has_proper_triangles() const
  {
    return std::all_of(m_polygons.begin(), m_polygons.end(), [&](const auto& p) {
      return p.size() == 3 && p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
             std::max({p[0], p[1], p[2]}) < m_number_of_points;
    });
  }

  // Returns whether `mesh`, which has been built, is a surface: no two faces run along an edge in
  // one direction, and each vertex has one fan.
  bool is_surface(const Mesh& mesh) const
  {
    return m_is_linked && number_of_halfedges_in_fans(mesh) == mesh.num_halfedges();
  }

private:
  typedef std::array<Index, 2> Edge;            // from the smaller vertex to the larger
  typedef std::pair<Index, Index> Numbered_end; // the larger vertex and the edge

  static Halfedge_index halfedge(std::size_t edge, bool is_descending)
  {
    return Halfedge_index(static_cast<Index>(2 * edge + is_descending));
  }

  // Calls `visit(corner, v, w)` for the sides of all polygons, from `v` to `w`.
  template <class Visit>
  void for_each_side(const Visit& visit) const
  {
    std::size_t corner = 0;
    for(const Polygons::Polygon& p : m_polygons) {
      for(std::size_t i = 1; i < p.size(); ++i)
        visit(corner++, p[i - 1], p[i]);
      visit(corner++, p[p.size() - 1], p[0]);
    }
  }

  // Counts the sides that ascend. The loops are branch-free, because ascending sides are
  // unpredictable.
  void count_ascending_sides()
  {
    m_first.assign(m_number_of_points + 2, 0);
    for_each_side([&](std::size_t, Index v, Index w) { m_first[v + 2] += v < w; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
  }

  void number_ascending_sides()
  {
    m_edges.resize(m_first.back() + 1);
    std::size_t edge = 0;
    for_each_side([&](std::size_t corner, Index v, Index w) {
      m_edges[edge] = {v, w};
      m_halfedge[corner] = halfedge(edge, false);
      edge += v < w;
    });
    m_edges.pop_back();
  }

  // Sorts the edges by the smaller vertex in linear time, then by the larger one if they are many.
  void sort_edges()
  {
    m_sorted.resize(m_edges.size());
    for(Index e = 0; e < m_edges.size(); ++e)
      m_sorted[m_first[m_edges[e][0] + 1]++] = {m_edges[e][1], e};
    for(Index v = 0; v < m_number_of_points; ++v)
      if(are_many(v))
        std::sort(m_sorted.begin() + m_first[v], m_sorted.begin() + m_first[v + 1]);
  }

  bool are_many(Index v) const { return m_first[v + 1] - m_first[v] > 8; }

  // Returns the first edge from the smaller vertex `v` to `w`. If no face ascends along it, the
  // result is another edge, or the end of the edges of `v`.
  std::vector<Numbered_end>::const_iterator find_edge(Index v, Index w) const
  {
    const auto first = m_sorted.begin() + m_first[v], end = m_sorted.begin() + m_first[v + 1];
    if(are_many(v))
      return std::lower_bound(first, end, Numbered_end(w, 0));
    return std::find_if(first, end, [w](const Numbered_end& x) { return x.first == w; });
  }

  // Returns the number of an edge from the smaller vertex `v` to `w`, which is a new one if no face
  // ascends along it.
  Index edge(Index v, Index w)
  {
    const auto e = find_edge(v, w);
    if(e != m_sorted.begin() + m_first[v + 1] && e->first == w)
      return e->second;
    m_edges.push_back({v, w});
    return static_cast<Index>(m_edges.size() - 1);
  }

  // Returns whether no other face ascends along the edge of `h`.
  bool ascends_once(Halfedge_index h) const
  {
    const Edge& e = m_edges[h.idx() / 2];
    const auto end = m_sorted.begin() + m_first[e[0] + 1];
    return std::count_if(find_edge(e[0], e[1]), end,
                         [&](const Numbered_end& x) { return x.first == e[1]; }) <= 1;
  }

  // Numbers the descending sides. The last side of each face comes first.
  void number_descending_sides()
  {
    std::size_t corner = 0;
    for(const Polygons::Polygon& p : m_polygons) {
      for(std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t from = i == 0 ? p.size() - 1 : i - 1;
        if(p[i] < p[from])
          m_halfedge[corner + from] = halfedge(edge(p[i], p[from]), true);
      }
      corner += p.size();
    }
  }

  // Sets the ends of edges. The halfedge of a vertex is on the first edge that contains it, so this
  // is written last.
  void set_ends()
  {
    for(std::size_t e = m_edges.size(); e-- > 0;)
      for(const bool is_descending : {false, true}) {
        const Vertex_index target(m_edges[e][is_descending ? 0 : 1]);
        m_mesh.set_target(halfedge(e, is_descending), target);
        m_mesh.set_halfedge(target, halfedge(e, is_descending));
      }
  }

  // Sets the faces. The halfedge of a face leaves its first corner.
  void set_faces()
  {
    auto first = m_halfedge.begin();
    for(Index f = 0; f < m_polygons.size(); ++f) {
      const auto end = first + static_cast<std::ptrdiff_t>(m_polygons[f].size());
      Halfedge_index previous = *(end - 1);
      m_mesh.set_halfedge(Face_index(f), *first);
      for(; first != end; previous = *first++) {
        m_is_linked = m_is_linked && m_mesh.is_border(*first);
        m_mesh.set_face(*first, Face_index(f));
        m_mesh.set_next(previous, *first);
      }
    }
  }

  // Links the border. At most one border halfedge leaves a vertex of a surface.
  void link_border()
  {
    if(m_halfedge.size() == m_mesh.num_halfedges())
      return;
    std::vector<Halfedge_index> leaving(m_number_of_points);
    for(const Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h)) {
        Halfedge_index& of_source = leaving[m_mesh.source(h)];
        m_is_linked = m_is_linked && !of_source.is_valid() && ascends_once(h);
        of_source = h;
      }
    for(const Halfedge_index h : leaving)
      if(h.is_valid())
        m_mesh.set_next(h, leaving[m_mesh.target(h)]);
  }

  // Counts the halfedges that a turn around each vertex meets, starting from its halfedge.
  static std::size_t number_of_halfedges_in_fans(const Mesh& mesh)
  {
    std::size_t result = 0;
    for(Index v = 0; v < mesh.num_vertices(); ++v)
      if(const Halfedge_index first = mesh.halfedge(Vertex_index(v)); first.is_valid()) {
        Halfedge_index h = first;
        do {
          h = mesh.opposite(mesh.next(h));
          ++result;
        } while(h != first);
      }
    return result;
  }

  Index m_number_of_points;
  const Polygons& m_polygons;
  Mesh m_mesh;
  std::vector<Halfedge_index> m_halfedge; // that leaves each corner
  bool m_is_linked = true; // no two faces ascend or descend along an edge, one fan at the boundary
  std::vector<Edge> m_edges;
  std::vector<Index> m_first;         // of each smaller vertex, in the next
  std::vector<Numbered_end> m_sorted; // of those edges along which a face ascends
};

} // namespace

void carry_to_parts(const Polygons& polygons, const std::vector<std::int64_t>& parents,
                    const Polygons& parts, Mesh_data& data)
{
  for(Corner_data& corners : data.corners) {
    Polygons numbers;
    for(std::size_t i = 0; i < parts.size(); ++i) {
      const auto parent = static_cast<std::size_t>(parents[i]);
      const Polygons::Polygon polygon = polygons[parent], old = corners.polygons[parent];
      for(const Polygons::Index v : parts[i])
        numbers.add_corner(old[static_cast<std::size_t>(
          std::find(polygon.begin(), polygon.end(), v) - polygon.begin())]);
      numbers.close();
    }
    corners.polygons = std::move(numbers);
  }
  data.groups.carry(parts.size(), [&](std::size_t i) { return parents[i]; });
}

Mesh mesh_of(const Polygon_soup& soup)
{
  Mesh result = Mesh_builder<Mesh>(soup.points.size(), soup.polygons)();
  std::copy(soup.points.begin(), soup.points.end(), result.points().begin());
  return result;
}

std::optional<IT::Delta_complex> complex_of(std::size_t number_of_points, const Polygons& polygons)
{
  Mesh_builder<IT::Delta_complex> builder(number_of_points, polygons);
  if(!builder.has_proper_triangles())
    return std::nullopt;
  std::optional<IT::Delta_complex> result = builder();
  if(!builder.is_surface(*result))
    result.reset();
  return result;
}
