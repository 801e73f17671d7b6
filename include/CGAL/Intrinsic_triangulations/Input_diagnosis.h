// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DIAGNOSIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DIAGNOSIS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <array>
#include <cstddef>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// names defects and notable properties of an input mesh.
enum class Defect_kind : std::size_t
{
  NON_FINITE_COORDINATE,
  FACE_INDEX_OUT_OF_RANGE,
  REPEATED_VERTEX_IN_FACE,
  NON_TRIANGULAR_FACE,
  NON_MANIFOLD_EDGE,
  NON_ORIENTABLE_COMPONENT,
  INCONSISTENT_ORIENTATION,
  NON_MANIFOLD_VERTEX,
  ZERO_LENGTH_EDGE,
  INVALID_LENGTH,
  LENGTH_OUT_OF_RANGE,
  TRIANGLE_INEQUALITY_VIOLATED,
  ISOLATED_VERTEX,
  SEVERAL_COMPONENTS,
  DEGENERATE_FACE,
  NEEDLE_FACE,
  VERTEX_WITHIN_ROUNDING
};

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// the type of element that has a defect.
enum class Defect_element
{
  VERTEX,
  EDGE,
  FACE,
  CORNER ///< a vertex in a face
};

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// describes a kind of defect.
struct Defect_description
{
  Defect_kind kind;       ///< the kind described
  const char* name;       ///< a short name, without article
  bool is_fatal;          ///< `false` if the kind is only noted
  Defect_element element; ///< the type of element that has it
  const char* sentence;   ///< the meaning for the input
};

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// all kinds of defects, in the order of their enumerators, the fatal ones first.
inline constexpr std::array<Defect_description, 17> defect_descriptions = {{
  {Defect_kind::NON_FINITE_COORDINATE, "non-finite coordinate", true, Defect_element::VERTEX,
   "a coordinate is infinite or not a number"},
  {Defect_kind::FACE_INDEX_OUT_OF_RANGE, "face index out of range", true, Defect_element::FACE,
   "a face names a vertex that does not exist"},
  {Defect_kind::REPEATED_VERTEX_IN_FACE, "face with a repeated vertex", true, Defect_element::FACE,
   "a face names the same vertex twice"},
  {Defect_kind::NON_TRIANGULAR_FACE, "face that is not a triangle", true, Defect_element::FACE,
   "only triangles are accepted"},
  {Defect_kind::NON_MANIFOLD_EDGE, "non-manifold edge", true, Defect_element::EDGE,
   "an edge must have one or two faces"},
  {Defect_kind::NON_ORIENTABLE_COMPONENT, "non-orientable component", true, Defect_element::FACE,
   "the surface is one-sided, so no orientation of its faces is consistent"},
  {Defect_kind::INCONSISTENT_ORIENTATION, "inconsistent orientation", true, Defect_element::EDGE,
   "the two faces at an edge run along it in the same direction"},
  {Defect_kind::NON_MANIFOLD_VERTEX, "non-manifold vertex", true, Defect_element::VERTEX,
   "the faces at a vertex form several fans"},
  {Defect_kind::ZERO_LENGTH_EDGE, "zero-length edge", true, Defect_element::EDGE,
   "the ends of an edge coincide"},
  {Defect_kind::INVALID_LENGTH, "invalid edge length", true, Defect_element::EDGE,
   "a length is negative, infinite or not a number"},
  {Defect_kind::LENGTH_OUT_OF_RANGE, "edge length outside 2^-127 to 2^127", true,
   Defect_element::EDGE, "formulas with lengths of type double leave the range of numbers"},
  {Defect_kind::TRIANGLE_INEQUALITY_VIOLATED, "violated triangle inequality", true,
   Defect_element::FACE, "one side is longer than the other two together"},
  {Defect_kind::ISOLATED_VERTEX, "isolated vertex", false, Defect_element::VERTEX,
   "a vertex without faces is kept unchanged"},
  {Defect_kind::SEVERAL_COMPONENTS, "connected component", false, Defect_element::FACE,
   "the surface has several components"},
  {Defect_kind::DEGENERATE_FACE, "degenerate face", false, Defect_element::FACE,
   "the area of a face is zero"},
  {Defect_kind::NEEDLE_FACE, "needle face", false, Defect_element::FACE,
   "an angle is below one degree"},
  {Defect_kind::VERTEX_WITHIN_ROUNDING, "vertex within rounding of an edge", false,
   Defect_element::CORNER, "a face is not higher than the rounding of its coordinates"},
}};

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// a face that is not degenerate but has an angle of fewer degrees is noted as a needle.
inline constexpr double needle_angle_in_degrees = 1;

/// \ingroup PkgIntrinsicTriangulationsDiagnosis
/// returns the description of `kind`. Takes constant time.
inline const Defect_description& defect_description(Defect_kind kind)
{
  return defect_descriptions[static_cast<std::size_t>(kind)];
}

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

is the result of `diagnose()` and `diagnose_polygon_soup()`: the defects of a mesh with their
elements, notes, and a few numbers about the mesh.

All elements are given by their positions in the input, starting from 0.
*/
class Input_diagnosis
{
public:
  /// the index of a missing element: the face of an edge or vertex without face, and the vertex of
  /// a face.
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// the number of occurrences of a kind that are kept by default; all are
  /// counted.
  static constexpr std::size_t maximal_number_of_occurrences = 5;

  /// the elements that have a defect.
  struct Occurrence
  {
    std::array<std::size_t, 2> vertices = {none, none}; ///< the vertex, or the ends of the edge
    std::size_t face = none;                            ///< the face, or a face of the edge
  };

  /// numbers about the surface. Only edges connect faces of a component. The Euler characteristic
  /// counts a vertex once for each of its fans of faces.
  struct Statistics
  {
    std::size_t vertices = 0; ///< number of vertices, with the isolated ones
    std::size_t edges = 0;    ///< number of edges
    /// number of faces, without faces that repeat a vertex or name one that does not exist
    std::size_t faces = 0;
    long euler_characteristic = 0;  ///< of these faces with their edges and vertices
    std::size_t boundary_loops = 0; ///< number of closed curves that form the boundary
    std::size_t components = 0;     ///< number of components that have a face
    /// smallest angle of a triangle in degrees, infinite if there is none
    double min_angle = std::numeric_limits<double>::infinity();
    /// smallest finite edge length, infinite if there is none
    double min_edge_length = std::numeric_limits<double>::infinity();
    /// largest finite edge length, minus infinity if there is none
    double max_edge_length = -std::numeric_limits<double>::infinity();
  };

  /// makes a diagnosis without defects.
  Input_diagnosis() = default;

  /// makes a diagnosis without defects that will keep `kept_occurrences` of each kind.
  explicit Input_diagnosis(std::size_t kept_occurrences) : m_kept_occurrences(kept_occurrences) {}

  /// returns how often a defect of kind `kind` occurs. Takes constant time.
  std::size_t count(Defect_kind kind) const { return record(kind).count; }

  /// returns the first few occurrences of `kind`, in the order in which they were met.
  const std::vector<Occurrence>& occurrences(Defect_kind kind) const
  {
    return record(kind).occurrences;
  }

  /// returns the number of fatal defects; takes constant time.
  std::size_t number_of_fatal_defects() const
  {
    std::size_t n = 0;
    for(const Defect_description& d : defect_descriptions)
      n += d.is_fatal ? count(d.kind) : 0;
    return n;
  }

  /// returns whether there is no fatal defect; takes constant time.
  bool is_valid() const { return number_of_fatal_defects() == 0; }

  /// returns the numbers about the surface.
  const Statistics& statistics() const { return m_statistics; }

  /// returns one sentence about all defects of kind `kind`, such as "zero-length edge: 3, first
  /// between vertices 12 and 15 (face 7)". For corners, all kept occurrences are named.
  /// \pre `count(kind) > 0`
  std::string message(Defect_kind kind) const
  {
    std::ostringstream out;
    out << defect_description(kind).name << ": " << count(kind) << ", first ";
    const Defect_element element = defect_description(kind).element;
    write_place(out, element, occurrences(kind).front());
    for(std::size_t i = 1; element == Defect_element::CORNER && i < occurrences(kind).size(); ++i)
      write_place(out << ", ", element, occurrences(kind)[i]);
    return out.str();
  }

  /// returns one sentence per kind of fatal defect, separated by semicolons; empty if there is
  /// none.
  std::string message() const
  {
    std::string result;
    for(const Defect_description& d : defect_descriptions)
      if(d.is_fatal && count(d.kind) > 0)
        result += (result.empty() ? "" : "; ") + message(d.kind);
    return result;
  }

  /// writes one line per kind of defect that was found, fatal ones first.
  friend std::ostream& operator<<(std::ostream& out, const Input_diagnosis& diagnosis)
  {
    for(const Defect_description& d : defect_descriptions)
      if(diagnosis.count(d.kind) > 0)
        out << (d.is_fatal ? "error: " : "note: ") << diagnosis.message(d.kind) << " - "
            << d.sentence << '\n';
    return out;
  }

  /// counts one more defect of kind `kind`. Takes constant time.
  void add(Defect_kind kind, const Occurrence& occurrence)
  {
    Record& r = m_records[static_cast<std::size_t>(kind)];
    ++r.count;
    if(r.occurrences.size() < m_kept_occurrences)
      r.occurrences.push_back(occurrence);
  }

  /// returns the numbers about the surface, to be filled in.
  Statistics& statistics() { return m_statistics; }

private:
  struct Record
  {
    std::size_t count = 0;
    std::vector<Occurrence> occurrences;
  };

  const Record& record(Defect_kind kind) const { return m_records[static_cast<std::size_t>(kind)]; }

  static void write_place(std::ostream& out, Defect_element element, const Occurrence& o)
  {
    if(element == Defect_element::FACE)
      out << "at face " << o.face;
    else if(element == Defect_element::VERTEX || element == Defect_element::CORNER)
      out << "at vertex " << o.vertices[0];
    else
      out << "between vertices " << o.vertices[0] << " and " << o.vertices[1];
    if((element == Defect_element::EDGE || element == Defect_element::CORNER) && o.face != none)
      out << " (face " << o.face << ")";
  }

  std::array<Record, defect_descriptions.size()> m_records;
  std::size_t m_kept_occurrences = maximal_number_of_occurrences;
  Statistics m_statistics;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DIAGNOSIS_H
