// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_topology.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

template <class Points>
void diagnose_embedded(const Diagnosis_complex& complex, const Points& points,
                       Input_diagnosis& diagnosis)
{
  using Metric = Embedded_metric<Points>;
  Topology_diagnoser(complex, diagnosis)();
  Metric_diagnoser<Metric>(complex, Metric(complex, points, diagnosis), diagnosis)();
}

inline void diagnose_lengths(const Diagnosis_complex& complex, const std::vector<double>& lengths,
                             Input_diagnosis& diagnosis)
{
  using Metric = Abstract_metric;
  Topology_diagnoser(complex, diagnosis)();
  Metric_diagnoser<Metric>(complex, Metric(complex, lengths, diagnosis), diagnosis)();
}

template <class Graph, class NamedParameters>
void diagnose_graph_points(const Graph& g, const Diagnosis_complex& complex,
                           const NamedParameters& np, Input_diagnosis& diagnosis)
{
  const auto vpm = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(CGAL::vertex_point, g));
  using Point = typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type;
  std::vector<Point> points;
  points.reserve(complex.number_of_vertices);
  for(const auto v : vertices(g))
    points.push_back(get(vpm, v));
  diagnose_embedded(complex, points, diagnosis);
}

template <class Graph, class Length_map>
void diagnose_graph_lengths(const Graph& g, const Diagnosis_complex& complex, const Length_map& map,
                            Input_diagnosis& diagnosis)
{
  std::vector<double> lengths;
  lengths.reserve(complex.number_of_edges());
  for(const auto e : edges(g))
    lengths.push_back(CGAL::to_double(get(map, e)));
  diagnose_lengths(complex, lengths, diagnosis);
}

} // namespace internal

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

\brief finds all defects of a polygon soup, as read from a file, that prevent an intrinsic
triangulation.

A face with a repeated vertex or an index out of range is reported and left out of all other checks.
An index that is negative counts as out of range. Positions are rounded to `double`.

\tparam PointRange a model of `RandomAccessContainer` whose value type has three coordinates under
        `operator[]`, of a type that is a model of `RealEmbeddable`
\tparam PolygonRange a range of ranges of integers
\param points the points
\param polygons the faces, as indices of points
\param kept_occurrences the number of occurrences of each kind of defect that are kept
\returns the defects found and numbers about the surface

Takes time linear in the size of the soup, up to sorting the edges at each vertex and the
inverse of Ackermann's function.
\throws std::length_error if there are \f$2^{32}-1\f$ points or corners of faces, or more
*/
template <class PointRange, class PolygonRange>
Input_diagnosis
diagnose_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                      std::size_t kept_occurrences = Input_diagnosis::maximal_number_of_occurrences)
{
  Input_diagnosis result(kept_occurrences);
  const internal::Diagnosis_complex complex =
    internal::Soup_complex_builder(points.size(), result)(polygons);
  internal::diagnose_embedded(complex, points, result);
  return result;
}

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

\brief examines a graph for everything that keeps an intrinsic triangulation from being built on it.

Loops and parallel edges are no defects. A vertex with several fans of faces is one.
Elements are given by their positions in `vertices(g)` and `faces(g)`.

\tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of named parameters
\param g the graph
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the positions of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` whose value type has three coordinates under
                   `operator[]`}
    \cgalParamDefault{`get(CGAL::vertex_point, g)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_length_map}
    \cgalParamDescription{the lengths of the edges, in place of positions; rounded to `double`}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the distances of the positions}
  \cgalParamNEnd
\cgalNamedParamsEnd
\returns the defects found and numbers about the surface

Takes time linear in the size of the graph, up to the inverse of Ackermann's function.
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Input_diagnosis diagnose(const Graph& g,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  Input_diagnosis result;
  const internal::Diagnosis_complex complex = internal::Graph_complex_builder<Graph>(g)();
  using Is_embedded =
    CGAL::parameters::is_default_parameter<NamedParameters, internal_np::edge_length_map_t>;
  if constexpr(Is_embedded::value)
    internal::diagnose_graph_points(g, complex, np, result);
  else
    internal::diagnose_graph_lengths(
      g, complex, CGAL::parameters::get_parameter(np, internal_np::edge_length_map), result);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H
