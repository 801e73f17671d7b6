// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/number_text.h>

#include <cstdint>
#include <istream>
#include <limits>
#include <new>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

constexpr const char* file_header = "intrinsic_triangulation 1";

// the number of an element in a file: -1 for none
template <typename Index>
std::string number_text(Index index)
{
  return index.is_valid() ? std::to_string(index.idx()) : "-1";
}

// What a file says of one triangulation. `write_more` adds what it has for an edge beside its length.
template <typename LengthMap, typename WriteMore>
void write_complex(std::ostream& os, const Delta_complex& mesh, const LengthMap& length,
                   const WriteMore& write_more)
{
  os << mesh.number_of_vertices() << ' ' << mesh.number_of_edges() << ' ' << mesh.number_of_faces()
     << '\n';
  for(Vertex_index v : mesh.vertices())
    os << number_text(mesh.halfedge(v)) << '\n';
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h(2 * e.idx()), o = mesh.opposite(h);
    os << mesh.target(h).idx() << ' ' << mesh.target(o).idx() << ' ' << mesh.next(h).idx() << ' '
       << mesh.next(o).idx() << ' ' << hexadecimal_text(length[e]);
    write_more(e);
    os << '\n';
  }
  for(Face_index f : mesh.faces())
    os << mesh.halfedge(f).idx() << '\n';
}

// Reads one triangulation line by line.
class Complex_reader
{
  typedef Delta_complex::size_type size_type;

public:
  explicit Complex_reader(std::istream& is) : m_lines(is) {}

  Line_reader& lines() { return m_lines; }

  // `read_more` reads what the file has for an edge beside its length.
  template <typename FT, typename ReadMore>
  Delta_complex read(const ReadMore& read_more)
  {
    Delta_complex mesh;
    m_lines.next_line();
    const size_type vertices = count(), edges = count(), faces = count();
    m_lines.end_line();
    grow(mesh, vertices, edges, faces);
    for(Vertex_index v : mesh.vertices())
      read_line([&] { mesh.set_halfedge(v, optional_halfedge(mesh)); });
    auto length = mesh.template add_property_map<Edge_index, FT>("e:length", FT(0)).first;
    auto more = read_more(mesh);
    for(Edge_index e : mesh.edges())
      read_line([&] {
        read_links(e, mesh);
        length[e] = m_lines.template hexadecimal<FT>();
        more(e);
      });
    for(Face_index f : mesh.faces())
      read_line([&] { read_face(f, mesh); });
    return mesh;
  }

private:
  template <typename Read>
  void read_line(const Read& read)
  {
    m_lines.next_line();
    read();
    m_lines.end_line();
  }

  size_type count() { return m_lines.integer<size_type>(0, Delta_complex::size_type(-1) / 4); }

  // A file that promises more than it has must not exhaust the memory first.
  void grow(Delta_complex& mesh, size_type vertices, size_type edges, size_type faces)
  {
    try {
      mesh.resize(vertices, edges, faces);
    } catch(const std::bad_alloc&) {
      m_lines.fail("not enough memory for so many elements");
    }
  }

  template <typename Index>
  Index index(size_type size)
  {
    if(size == 0)
      m_lines.fail("there is no element to refer to");
    return Index(m_lines.integer<size_type>(0, size - 1));
  }

  Halfedge_index halfedge(const Delta_complex& mesh)
  {
    return index<Halfedge_index>(mesh.num_halfedges());
  }

  Halfedge_index optional_halfedge(const Delta_complex& mesh)
  {
    const auto i = m_lines.integer<std::int64_t>(-1, std::int64_t(mesh.num_halfedges()) - 1);
    return i < 0 ? Delta_complex::null_halfedge() : Halfedge_index(static_cast<size_type>(i));
  }

  void read_links(Edge_index e, Delta_complex& mesh)
  {
    const Halfedge_index h = mesh.halfedge(e);
    for(Halfedge_index x : {h, mesh.opposite(h)})
      mesh.set_target(x, index<Vertex_index>(mesh.num_vertices()));
    for(Halfedge_index x : {h, mesh.opposite(h)})
      mesh.set_next(x, halfedge(mesh));
  }

  void read_face(Face_index f, Delta_complex& mesh)
  {
    Halfedge_index h = halfedge(mesh);
    mesh.set_halfedge(f, h);
    for(int side = 0; side < 3; ++side, h = mesh.next(h)) {
      if(!mesh.is_border(h))
        m_lines.fail("halfedge " + std::to_string(h.idx()) + " is in two faces");
      mesh.set_face(h, f);
    }
  }

  Line_reader m_lines;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIO
/// writes `tri` with its correspondence, exactly: what `read_intrinsic_triangulation()` makes of it has
/// the same elements with the same numbers, and the same lengths to the bit. The format is described in
/// the user manual (\ref Intrinsic_triangulations_file_format).
/// The number type of the traits must be a floating point type. Complexity: linear.
/// \returns whether the stream is good after that.
template <typename Traits>
bool write_intrinsic_triangulation(std::ostream& os, const Intrinsic_triangulation<Traits>& tri)
{
  os << internal::file_header << '\n';
  internal::write_complex(os, tri.input_mesh(), tri.input_length_map(), [](Edge_index) {});
  internal::write_complex(os, tri.mesh(), tri.length_map(), [&](Edge_index e) {
    const Halfedge_index h(2 * e.idx());
    os << ' ' << tri.coordinates().normal_coordinate(e) << ' ' << tri.coordinates().roundabout(h)
       << ' ' << tri.coordinates().roundabout(tri.mesh().opposite(h)) << ' '
       << tri.is_constrained(e);
  });
  return os.good();
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// reads what `write_intrinsic_triangulation()` has written, and checks it.
/// Complexity: linear in the elements and crossings.
/// \throws File_format_error if the text does not follow the format; the line is named
/// \throws Invalid_input if the text follows the format, but is no triangulation of a surface
template <typename Traits = Euclidean_geometry_traits<double>>
Intrinsic_triangulation<Traits> read_intrinsic_triangulation(std::istream& is,
                                                             const Traits& traits = Traits())
{
  typedef typename Traits::FT FT;
  typedef typename Traits::Integer Integer;
  internal::Complex_reader reader(is);
  internal::Line_reader& lines = reader.lines();
  lines.next_line();
  lines.expect(internal::file_header);
  Delta_complex input = reader.read<FT>([](const Delta_complex&) { return [](Edge_index) {}; });
  Delta_complex mesh = reader.read<FT>([&](Delta_complex& complex) {
    Integer_coordinates<Integer> coordinates(complex);
    auto is_constrained =
      complex.template add_property_map<Edge_index, bool>("e:is_constrained", false).first;
    return [=, &lines, &complex](Edge_index e) mutable {
      typedef typename Integer_coordinates<Integer>::size_type size_type;
      const Halfedge_index h = complex.halfedge(e);
      coordinates.set(e, lines.integer<Integer>(-1, (std::numeric_limits<Integer>::max)() / 16));
      for(Halfedge_index x : {h, complex.opposite(h)})
        coordinates.set(x, lines.integer<size_type>(0, (std::numeric_limits<size_type>::max)()));
      is_constrained[e] = lines.integer<int>(0, 1) == 1;
    };
  });
  return Intrinsic_triangulation<Traits>(std::move(input), std::move(mesh), traits);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_H
