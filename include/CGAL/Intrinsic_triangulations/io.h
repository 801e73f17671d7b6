// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/input/number_text.h>

#include <array>
#include <cstdint>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

constexpr const char* file_header = "intrinsic_triangulation 3";

// These words introduce the data that determine the lengths of T1 exactly.
constexpr std::string_view exact_lengths = "exact lengths";
constexpr std::string_view exact_positions = "exact positions";
constexpr std::string_view exact_squared_lengths = "exact squared_lengths";

// Returns the text of a number in a file, which depends neither on the locale nor on the flags of
// the stream. The number -1 represents no element.
template <typename Number>
std::string number_text(const Number& number)
{
  return std::to_string(number);
}

inline std::string number_text(Halfedge_index h)
{
  return h.is_valid() ? std::to_string(h.idx()) : "-1";
}
inline std::string number_text(Face_index f) { return std::to_string(f.idx()); }
inline std::string number_text(Vertex_index v) { return std::to_string(v.idx()); }
inline std::string number_text(const std::string& text) { return text; }

template <typename First, typename... Rest>
void write_line(std::ostream& os, const First& first, const Rest&... rest)
{
  os << number_text(first);
  ((os << ' ' << number_text(rest)), ...);
  os << '\n';
}

// Writes the content of a file for one triangulation. `more(e)` returns the rest of the line of an
// edge.
template <typename Surface, typename More>
void write_complex(std::ostream& os, const Surface& surface, const More& more)
{
  const Delta_complex& mesh = surface.mesh();
  write_line(os, mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  for(Vertex_index v : mesh.vertices())
    write_line(os, mesh.halfedge(v));
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h(2 * e.idx()), o = mesh.opposite(h);
    write_line(os, mesh.target(h), mesh.target(o), mesh.next(h), mesh.next(o),
               hexadecimal_text(get(surface.length_map(), e)) + more(e));
  }
  for(Face_index f : mesh.faces())
    write_line(os, mesh.halfedge(f));
}

inline void write_metric(std::ostream& os, const No_metric&) { os << exact_lengths << '\n'; }

template <typename K>
void write_metric(std::ostream& os, const Input_metric<K>& metric)
{
  if constexpr(has_exact_text<K>())
    if(!metric.squared_lengths.empty()) {
      os << exact_squared_lengths << '\n';
      for(const K& square : metric.squared_lengths)
        write_line(os, exact_text(square));
      return;
    }
  os << (metric.points.empty() ? exact_lengths : exact_positions) << '\n';
  for(const auto& [x, y, z] : metric.points)
    write_line(os, hexadecimal_text(x), hexadecimal_text(y), hexadecimal_text(z));
}

// Reads triangulations line by line. Memory is allocated only for lines that were read, even if a
// file announces more.
template <typename FT, typename Integer>
class Complex_reader
{
  typedef Delta_complex::size_type size_type;

  struct Edge_line
  {
    std::array<size_type, 2> target, next;
    FT length;
    Integer normal_coordinate;
    std::array<size_type, 2> roundabout;
    bool is_constrained;
  };

public:
  explicit Complex_reader(std::istream& is) : m_lines(is) {}

  void read_header(const char* header = file_header)
  {
    m_lines.next_line();
    m_lines.expect(header);
  }

  // Returns the reader of the rest of the file, line by line.
  Line_reader& lines() { return m_lines; }

  Delta_complex read_input()
  {
    read_lines(false);
    return assembled();
  }

  // Reads T2 with the integer coordinates and constraints of its edges.
  Delta_complex read_intrinsic()
  {
    read_lines(true);
    Delta_complex mesh = assembled();
    Integer_coordinates<Integer> coordinates(mesh);
    auto is_constrained = stored_constraint_map(mesh);
    for(Edge_index e : mesh.edges()) {
      const Edge_line& line = m_edges[e];
      coordinates.set(e, line.normal_coordinate);
      for(unsigned side : {0u, 1u})
        coordinates.set(mesh.halfedge(e, side), line.roundabout[side]);
      is_constrained[e] = line.is_constrained;
    }
    return mesh;
  }

  // Reads the positions of the vertices that only T2 has.
  std::vector<Surface_point<FT>> read_inserted(const Delta_complex& input)
  {
    m_lines.next_line();
    const size_type count = number((std::numeric_limits<size_type>::max)() / 4);
    m_lines.end_line();
    std::vector<Surface_point<FT>> inserted;
    for_lines(count, [&] {
      const Halfedge_index h = read_halfedge(input.number_of_edges());
      Face_location<FT> p;
      p.first = Face_index(index(input.number_of_faces()));
      for(FT& coordinate : p.second)
        coordinate = m_lines.template hexadecimal<FT>();
      inserted.push_back(h.is_valid() ? on_halfedge(h, p, input) : Surface_point<FT>(p));
    });
    return inserted;
  }

  // Reads the data that determine the lengths of `input` exactly. Reads nothing if `K` cannot
  // represent the squares.
  template <typename K>
  Input_metric<K> read_metric(const Delta_complex& input)
  {
    Input_metric<K> result;
    m_lines.next_line();
    if(m_lines.is(exact_positions))
      for_lines(input.number_of_vertices(), [&] { result.points.push_back(read_position()); });
    else if(m_lines.is(exact_squared_lengths))
      result.squared_lengths = read_squared_lengths<K>(input.number_of_edges());
    else
      m_lines.expect(exact_lengths);
    return result;
  }

  // Reads the index of one of `count` elements.
  size_type index(size_type count)
  {
    if(count == 0)
      m_lines.fail("there is no element to refer to");
    return number(count - 1);
  }

private:
  // Returns a point of a face as the point of its side `h`.
  Surface_point<FT> on_halfedge(Halfedge_index h, const Face_location<FT>& p,
                                const Delta_complex& input) const
  {
    if(input.face(h) != p.first || coordinates_from(h, p, input)[2] != 0)
      m_lines.fail("the position of an inserted vertex is not on its halfedge");
    const auto [at_source, at_target, at_apex] = coordinates_from(h, p, input);
    return Edge_location<FT>{h, {at_source, at_target}};
  }

  template <typename K>
  std::vector<K> read_squared_lengths(size_type count)
  {
    typedef std::conditional_t<has_exact_text<K>(), K, double> Number;
    std::vector<K> result;
    bool has_all = true;
    for_lines(count, [&] {
      const auto square = m_lines.template exact<Number>();
      has_all = has_all && square;
      if(has_all)
        result.push_back(K(*square));
    });
    return has_all ? result : std::vector<K>();
  }

  void read_lines(bool with_coordinates)
  {
    m_lines.next_line();
    const size_type most = (std::numeric_limits<size_type>::max)() / 4;
    const size_type vertices = number(most), edges = number(most), faces = number(most);
    m_lines.end_line();
    m_vertices.clear();
    m_edges.clear();
    m_faces.clear();
    for_lines(vertices, [&] { m_vertices.push_back(read_halfedge(edges)); });
    for_lines(edges, [&] { m_edges.push_back(read_edge(vertices, edges, with_coordinates)); });
    for_lines(faces, [&] { m_faces.push_back(index(2 * edges)); });
  }

  template <typename Read>
  void for_lines(size_type count, const Read& read)
  {
    for(size_type line = 0; line < count; ++line) {
      m_lines.next_line();
      read();
      m_lines.end_line();
    }
  }

  size_type number(size_type most) { return m_lines.integer<size_type>(0, most); }

  Halfedge_index read_halfedge(size_type edges)
  {
    const auto i = m_lines.integer<std::int64_t>(-1, 2 * std::int64_t(edges) - 1);
    return i < 0 ? Delta_complex::null_halfedge() : Halfedge_index(static_cast<size_type>(i));
  }

  std::array<double, 3> read_position()
  {
    std::array<double, 3> result;
    for(double& coordinate : result)
      coordinate = m_lines.template hexadecimal<double>();
    return result;
  }

  Edge_line read_edge(size_type vertices, size_type edges, bool with_coordinates)
  {
    Edge_line line{};
    for(size_type& target : line.target)
      target = index(vertices);
    for(size_type& next : line.next)
      next = index(2 * edges);
    line.length = m_lines.template hexadecimal<FT>();
    if(with_coordinates) {
      line.normal_coordinate =
        m_lines.template integer<Integer>(-1, (std::numeric_limits<Integer>::max)() / 16);
      for(size_type& r : line.roundabout)
        r = number((std::numeric_limits<size_type>::max)());
      line.is_constrained = m_lines.template integer<int>(0, 1) == 1;
    }
    return line;
  }

  Delta_complex assembled() const
  {
    Delta_complex mesh;
    mesh.resize(static_cast<size_type>(m_vertices.size()), static_cast<size_type>(m_edges.size()),
                static_cast<size_type>(m_faces.size()));
    auto length = stored_length_map<FT>(mesh);
    for(Vertex_index v : mesh.vertices())
      mesh.set_halfedge(v, m_vertices[v]);
    for(Edge_index e : mesh.edges()) {
      for(unsigned side : {0u, 1u}) {
        const Halfedge_index h = mesh.halfedge(e, side);
        mesh.set_target(h, Vertex_index(m_edges[e].target[side]));
        mesh.set_next(h, Halfedge_index(m_edges[e].next[side]));
      }
      length[e] = m_edges[e].length;
    }
    for(Face_index f : mesh.faces())
      set_face(f, Halfedge_index(m_faces[f]), mesh);
    return mesh;
  }

  // Sets the face of three halfedges. The last line that was read is the line of the last face.
  void set_face(Face_index f, Halfedge_index h, Delta_complex& mesh) const
  {
    mesh.set_halfedge(f, h);
    for(int side = 0; side < 3; ++side, h = mesh.next(h)) {
      if(!mesh.is_border(h))
        throw File_format_error("halfedge " + std::to_string(h.idx()) + " is in two faces",
                                m_lines.number() + 1 + f.idx() - m_faces.size());
      mesh.set_face(h, f);
    }
  }

  Line_reader m_lines;
  std::vector<Halfedge_index> m_vertices;
  std::vector<Edge_line> m_edges;
  std::vector<size_type> m_faces;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIO
/// writes `tri` with its correspondence to the stream `os`, exactly.
/// `read_intrinsic_triangulation()` restores the same elements with the same indices, and the same
/// lengths to the bit. The format is described in the user manual (\ref
/// Intrinsic_triangulations_file_format). The number type of the traits must be a floating-point
/// type. Exact positions stay exact, and so do squared lengths that are rational. For squared
/// lengths in other fields, the lengths count as exact after reading. Complexity: linear.
/// \pre \f$T_2\f$ has no garbage, see `Intrinsic_triangulation::collect_garbage()`
/// \returns whether the stream is good afterwards.
template <typename Traits>
bool write_intrinsic_triangulation(std::ostream& os, const Intrinsic_triangulation<Traits>& tri)
{
  using internal::number_text;
  os << internal::file_header << '\n';
  internal::write_complex(os, tri.input(), [](Edge_index) { return std::string(); });
  internal::write_complex(os, tri.intrinsic(), [&](Edge_index e) {
    const auto& coordinates = tri.coordinates();
    return ' ' + number_text(coordinates.normal_coordinate(e)) + ' ' +
           number_text(coordinates.roundabout(tri.mesh().halfedge(e, 0))) + ' ' +
           number_text(coordinates.roundabout(tri.mesh().halfedge(e, 1))) +
           (tri.is_constrained(e) ? " 1" : " 0");
  });
  internal::write_line(os, tri.number_of_inserted_vertices());
  for(const auto& p : tri.inserted_vertices()) {
    const auto [f, b] = face_location(p, tri.input_mesh());
    internal::write_line(os, halfedge_of(p), f, internal::hexadecimal_text(b[0]),
                         internal::hexadecimal_text(b[1]), internal::hexadecimal_text(b[2]));
  }
  internal::write_metric(os, tri.input_metric());
  return os.good();
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// reads what `write_intrinsic_triangulation()` has written to the stream `is`, and checks it. The
/// triangulation gets `traits`.
/// Complexity: linear in the elements and crossings.
/// \throws File_format_error if the text does not follow the format; the line is named
/// \throws Invalid_input if the text follows the format, but is not a triangulation of a surface
template <typename Traits = Euclidean_geometry_traits<double>>
Intrinsic_triangulation<Traits> read_intrinsic_triangulation(std::istream& is,
                                                             const Traits& traits = Traits())
{
  internal::Complex_reader<typename Traits::FT, typename Traits::Integer> reader(is);
  reader.read_header();
  Delta_complex input = reader.read_input();
  Delta_complex mesh = reader.read_intrinsic();
  auto inserted = reader.read_inserted(input);
  internal::Input_metric_of<Traits> metric;
  if constexpr(internal::has_metric<Traits>())
    metric = reader.template read_metric<typename decltype(metric)::Number>(input);
  else
    reader.template read_metric<double>(input);
  return Intrinsic_triangulation<Traits>(std::move(input), std::move(mesh), std::move(inserted),
                                         traits, std::move(metric));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_H
