// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_IO_H
#define CGAL_INTRINSIC_SIMPLIFICATION_IO_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/io.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// levels of an evolving surface and the operations between them, from which maps are made.
struct Surface_hierarchy
{
  Surface_history history; ///< the operations
  std::vector<Surface_level>
    levels; ///< the levels, from the first one, before all operations, to the coarsest
};

namespace internal {

constexpr const char* hierarchy_header = "intrinsic_simplification 1";

using Intrinsic_triangulations::internal::hexadecimal_text;
using Intrinsic_triangulations::internal::write_line;

inline void write_operation(std::ostream& os, const Scaling& s)
{
  write_line(os, s.code, s.vertex, s.number_of_corners > 0 ? 1 : 0, hexadecimal_text(s.factor));
}

inline void write_operation(std::ostream& os, const Flip& f)
{
  write_line(os, f.code, f.halfedge, hexadecimal_text(f.crossing_before),
             hexadecimal_text(f.crossing_after));
}

// Writes an operation. The first outgoing halfedge of the vertex determines a removal, the whole
// face an insertion.
inline void write_operation(std::ostream& os, const Vertex_change& c)
{
  const int code = Surface_operation(c).code();
  const std::string x = hexadecimal_text(c.weight[0]), y = hexadecimal_text(c.weight[1]);
  if(!c.is_insertion)
    write_line(os, code, c.corners[0].face(), c.corners[0].index(), x, y);
  else if(c.is_border)
    write_line(os, code, c.whole.face(), c.whole.index(), x);
  else
    write_line(os, code, c.whole.face(), x, y);
}

// Reads a hierarchy and repeats the operations on the connectivity.
class Hierarchy_reader
{
public:
  explicit Hierarchy_reader(std::istream& is) : m_reader(is), m_lines(m_reader.lines()) {}

  Surface_hierarchy read()
  {
    m_reader.read_header(hierarchy_header);
    m_mesh = m_reader.read_input();
    const auto length = Intrinsic_triangulations::stored_length_map<double>(m_mesh);
    m_mesh.set_recycle_garbage(false);
    if(!Intrinsic_triangulations::is_valid_Delta_complex(m_mesh))
      throw Intrinsic_triangulations::Invalid_input(
        "the first level is not a triangulated surface");
    for(Edge_index e : m_mesh.edges())
      check(is_length(length[e]), "a length is not positive and finite");
    m_result.levels.emplace_back(Intrinsic_triangulations::Surface_view(m_mesh, length), 0);
    const std::size_t levels = count();
    for(std::size_t n = 0; n < levels; ++n)
      read_level();
    return std::move(m_result);
  }

private:
  static bool is_length(double x) { return x > 0 && std::isfinite(x); }

  void check(bool condition, const char* message) const
  {
    if(!condition)
      m_lines.fail(message);
  }

  // Reads a line with a number.
  std::size_t count()
  {
    m_lines.next_line();
    const auto result =
      m_lines.integer<std::int64_t>(0, (std::numeric_limits<std::int64_t>::max)());
    m_lines.end_line();
    return static_cast<std::size_t>(result);
  }

  // Reads the operations since the previous level, and the lengths.
  void read_level()
  {
    const std::size_t operations = count();
    for(std::size_t n = 0; n < operations; ++n) {
      m_lines.next_line();
      read_operation();
      m_lines.end_line();
    }
    std::vector<double> length(m_mesh.num_edges(), 0);
    for(Edge_index e : m_mesh.edges()) {
      m_lines.next_line();
      length[e] = m_lines.hexadecimal<double>();
      check(is_length(length[e]), "a length is not positive and finite");
      m_lines.end_line();
    }
    m_result.levels.emplace_back(
      Intrinsic_triangulations::Surface_view(m_mesh, Surface_level::Length_map(length.data())),
      m_result.history.size());
  }

  void read_operation()
  {
    switch(const int code = m_lines.integer<int>(Scaling::code, Vertex_change::code + 3); code) {
      case Scaling::code: return read_scaling();
      case Flip::code: return read_flip();
      case Vertex_change::code:
      case Vertex_change::code + 1: return read_removal(code != Vertex_change::code);
      default: return read_insertion(code != Vertex_change::code + 2);
    }
  }

  double part()
  {
    const double x = m_lines.hexadecimal<double>();
    check(x >= 0 && x <= 1, "a number between 0 and 1 expected");
    return x;
  }

  void read_scaling()
  {
    const Vertex_index v(m_reader.index(m_mesh.num_vertices()));
    check(!m_mesh.is_removed(v) && !m_mesh.is_isolated(v), "there is no such vertex");
    const bool has_corners = m_lines.integer<int>(0, 1) == 1;
    const double factor = m_lines.hexadecimal<double>();
    check(is_length(factor), "a factor is not positive and finite");
    m_result.history.add_scaling(v, factor, has_corners, m_mesh);
  }

  void read_flip()
  {
    namespace IT = Intrinsic_triangulations;
    const Halfedge_index h(m_reader.index(m_mesh.num_halfedges()));
    check(!m_mesh.is_removed(h) && IT::flip_status(h, m_mesh) == IT::Operation_status::possible,
          "the edge cannot be flipped");
    const double s = part(), t = part();
    m_result.history.add_flip(h, m_mesh, s, t);
    IT::flip_edge(h, m_mesh);
  }

  Face_index read_face()
  {
    const Face_index f(m_reader.index(m_mesh.num_faces()));
    check(!m_mesh.is_removed(f), "there is no such face");
    return f;
  }

  void read_insertion(bool is_border)
  {
    namespace IT = Intrinsic_triangulations;
    const Face_index f = read_face();
    const Face_corner whole(f, is_border ? m_lines.integer<std::size_t>(0, 2) : 0);
    Halfedge_index a = IT::sides(f, m_mesh)[whole.index()];
    if(is_border)
      a = m_mesh.prev(a);
    check(!is_border || m_mesh.is_border(m_mesh.opposite(a)), "the edge is not on the boundary");
    const double w_a = part(), w_b = is_border ? 0 : part();
    if(is_border)
      IT::split_edge(a, m_mesh);
    else
      a = m_mesh.next(IT::split_face(a, m_mesh));
    m_result.history.add_insertion(a, m_mesh, whole, w_a, w_b);
  }

  void read_removal(bool is_border)
  {
    namespace IT = Intrinsic_triangulations;
    const Face_index f = read_face();
    const Halfedge_index a = IT::sides(f, m_mesh)[m_lines.integer<std::size_t>(0, 2)];
    const double w_a = part(), w_b = part();
    const Vertex_index v = m_mesh.source(a);
    check(IT::removal_status(v, m_mesh) == IT::Operation_status::possible &&
            m_mesh.is_border(v) == is_border &&
            (!is_border || m_mesh.is_border(m_mesh.opposite(a))),
          "the vertex cannot be removed");
    m_result.history.add_removal(a, m_mesh, w_a, is_border ? 0 : w_b);
    IT::remove_degree_3_vertex(v, m_mesh);
  }

  Intrinsic_triangulations::internal::Complex_reader<double, std::int64_t> m_reader;
  Intrinsic_triangulations::internal::Line_reader& m_lines;
  Delta_complex m_mesh;
  Surface_hierarchy m_result;
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// writes levels of an evolving surface and the operations between them, exactly.
/// `read_surface_hierarchy()` returns equal elements with equal indices. Lengths and maps are
/// bitwise equal. The format is described in the user manual (\ref
/// Intrinsic_simplification_file_format). Complexity: linear.
/// \param os the stream
/// \param history the history of the surface
/// \param levels its levels, in their order
/// \pre the first level is the surface before all operations
/// \returns whether the stream is good afterwards
inline bool write_surface_hierarchy(std::ostream& os, const Surface_history& history,
                                    const std::vector<const Surface_level*>& levels)
{
  using namespace internal;
  CGAL_precondition(!levels.empty() && levels.front()->time() == 0);
  os << hierarchy_header << '\n';
  Intrinsic_triangulations::internal::write_complex(os, *levels.front(),
                                                    [](Edge_index) { return std::string(); });
  write_line(os, levels.size() - 1);
  for(std::size_t n = 1; n < levels.size(); ++n) {
    const Surface_history::Time start = levels[n - 1]->time(), end = levels[n]->time();
    CGAL_precondition(start <= end && end <= history.size());
    write_line(os, end - start);
    for(Surface_history::Time t = start; t < end; ++t)
      history[t].visit([&](const auto& operation) { write_operation(os, operation); });
    for(Edge_index e : levels[n]->mesh().edges())
      write_line(os, hexadecimal_text(levels[n]->length_map()[e]));
  }
  return os.good();
}

/// \ingroup PkgIntrinsicSimplificationRef
/// reads a hierarchy from `write_surface_hierarchy()`, and checks it: the operations are repeated.
/// Complexity: linear in the operations, and in the first level for each level.
/// \throws Intrinsic_triangulations::File_format_error if the text does not follow the format, or
///   an operation is not possible. The error names the line
/// \throws Intrinsic_triangulations::Invalid_input if the first level is not a triangulation of a
///   surface
inline Surface_hierarchy read_surface_hierarchy(std::istream& is)
{
  return internal::Hierarchy_reader(is).read();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_IO_H
