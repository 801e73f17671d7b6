// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Loop_search.h>
#include <CGAL/Intrinsic_triangulations/Loop_signatures.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Stores the homology class of a closed curve over the integers. It counts how often the curve
// crosses the curve of each generator, from one side to the other.
class Homology_coordinates
{
public:
  typedef std::vector<std::int64_t> Vector;

  explicit Homology_coordinates(const Loop_signatures& signatures)
    : m_dimension(signatures.generators().size())
  {
    for(std::size_t i = 0; i < m_dimension; ++i)
      signatures.for_each_on_curve(signatures.generators()[i], [&](Halfedge_index h) {
        m_entries.push_back({Edge_index(h), i, is_first_halfedge(h) ? 1 : -1});
      });
    std::stable_sort(m_entries.begin(), m_entries.end(),
                     [](const Entry& a, const Entry& b) { return a.edge < b.edge; });
  }

  std::size_t dimension() const { return m_dimension; }

  Vector operator()(const std::vector<Halfedge_index>& curve) const
  {
    Vector result(m_dimension, 0);
    for(Halfedge_index h : curve) {
      const Edge_index e(h);
      auto x = std::lower_bound(m_entries.begin(), m_entries.end(), e,
                                [](const Entry& a, Edge_index b) { return a.edge < b; });
      for(; x != m_entries.end() && x->edge == e; ++x)
        result[x->generator] += is_first_halfedge(h) ? x->sign : -x->sign;
    }
    return result;
  }

private:
  struct Entry
  {
    Edge_index edge;
    std::size_t generator;
    int sign;
  };

  std::size_t m_dimension;
  std::vector<Entry> m_entries;
};

// Stores integer vectors that are part of a basis of all integer vectors. Linear functions that
// vanish on all of them complete them. Each new vector is reduced by the algorithm of Euclid until
// all functions but one vanish on it, too.
class Partial_basis
{
  typedef Homology_coordinates::Vector Vector;

public:
  explicit Partial_basis(std::size_t dimension) : m_functions(dimension)
  {
    for(std::size_t i = 0; i < dimension; ++i)
      m_functions[i] = {{i, 1}};
  }

  bool is_complete() const { return m_functions.empty(); }

  // Adds a vector if the vectors remain part of a basis, and numbers remain small. Returns whether
  // it was added.
  bool add(const Vector& v)
  {
    std::vector<Function> functions = m_functions;
    Vector values;
    for(const Function& f : functions)
      values.push_back(value(f, v));
    for(;;) {
      const std::size_t pivot = least(values);
      if(pivot == values.size())
        return false;
      bool is_reduced = true;
      for(std::size_t j = 0; j < values.size(); ++j)
        if(const std::int64_t factor = values[j] / values[pivot]; j != pivot && factor != 0) {
          if(!subtract(functions[j], factor, functions[pivot]))
            return false;
          values[j] -= factor * values[pivot];
          is_reduced = is_reduced && values[j] == 0;
        }
      if(!is_reduced)
        continue;
      if(values[pivot] != 1 && values[pivot] != -1)
        return false;
      functions.erase(functions.begin() + static_cast<std::ptrdiff_t>(pivot));
      m_functions = std::move(functions);
      return true;
    }
  }

private:
  typedef std::vector<std::pair<std::size_t, std::int64_t>> Function; // coefficients, by index

  static constexpr std::int64_t greatest = std::int64_t(1) << 30;

  static std::int64_t value(const Function& f, const Vector& v)
  {
    std::int64_t sum = 0;
    for(const auto& [i, factor] : f)
      sum += factor * v[i];
    return sum;
  }

  // Returns the index of the least absolute value that is not zero, or the number of values if all
  // are zero.
  static std::size_t least(const Vector& values)
  {
    std::size_t result = values.size();
    for(std::size_t i = 0; i < values.size(); ++i)
      if(values[i] != 0 &&
         (result == values.size() || std::abs(values[i]) < std::abs(values[result])))
        result = i;
    return result;
  }

  // Returns false if a coefficient gets too large.
  static bool subtract(Function& f, std::int64_t factor, const Function& g)
  {
    Function result;
    auto x = f.begin();
    auto y = g.begin();
    while(x != f.end() || y != g.end()) {
      const bool takes_x = y == g.end() || (x != f.end() && x->first <= y->first),
                 takes_y = x == f.end() || (y != g.end() && y->first <= x->first);
      const std::size_t i = takes_x ? x->first : y->first;
      const std::int64_t c = (takes_x ? (x++)->second : 0) - (takes_y ? factor * (y++)->second : 0);
      if(std::abs(c) > greatest)
        return false;
      if(c != 0)
        result.push_back({i, c});
    }
    f = std::move(result);
    return true;
  }

  std::vector<Function> m_functions;
};

inline std::vector<std::size_t> first_indices(std::size_t n)
{
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

// Finds short loops along edges, and keeps the shortest loop of each homology class modulo 2.
//
// If a loop is the shortest of its class and not a sum of shorter ones, it is found from a center
// on it. All centers together find a shortest basis (Erickson and Whittlesey 2005). Centers within
// half of the length of the longest loop of a known basis suffice.
template <typename Surface>
class Loops_of_classes
{
  typedef Length_of<Surface> FT;
  typedef Loop_signatures::Signature Signature;

public:
  struct Loop
  {
    FT length;
    std::vector<Halfedge_index> halfedges;
  };

  // Loops are found up to `slack` times the length of the longest loop of a basis.
  Loops_of_classes(const Surface& surface, const FT& slack)
    : m_mesh(surface.mesh()),
      m_search(surface, Boundary_loops::open),
      m_coordinates(m_search.signatures()),
      m_slack(slack)
  {
    for(Edge_index e : m_search.signatures().generators())
      add(m_search.signatures().loop(e));
    if(!m_loops.empty())
      search_all();
  }

  // Returns the loops, the shortest ones first.
  const std::vector<Loop>& loops() const { return m_loops; }

  // Returns the first loops in the order of `indices` that are a basis over the integers, by their
  // indices. Returns fewer if they contain no basis.
  std::vector<std::size_t> basis(const std::vector<std::size_t>& indices) const
  {
    Partial_basis partial(dimension());
    std::vector<std::size_t> result;
    for(std::size_t i : indices)
      if(!partial.is_complete() && partial.add(m_coordinates(m_loops[i].halfedges)))
        result.push_back(i);
    return result;
  }

  std::size_t dimension() const { return m_coordinates.dimension(); }

  // Returns the halfedges of the loops of a basis. If it is not complete, returns the loops of
  // generators; this requires a class that is odd over the integers.
  std::vector<std::vector<Halfedge_index>> halfedges(const std::vector<std::size_t>& basis) const
  {
    std::vector<std::vector<Halfedge_index>> result;
    if(basis.size() == dimension())
      for(std::size_t i : basis)
        result.push_back(m_loops[i].halfedges);
    else
      for(Edge_index e : m_search.signatures().generators())
        result.push_back(m_search.signatures().loop(e));
    return result;
  }

private:
  // All searches together reach at most this number of vertices. The other number is allowed for
  // each search.
  static constexpr std::size_t greatest_number_of_visits = std::size_t(1) << 22;
  static constexpr std::size_t least_number_of_visits = 4096;

  static bool is_any(Vertex_index) { return true; }

  void search_all()
  {
    const std::vector<Vertex_index> center = m_search.centers(is_any);
    const std::size_t most =
      (std::max)(greatest_number_of_visits / center.size(), least_number_of_visits);
    const Mesh_components components(m_mesh);
    std::vector<char> is_reached(components.size(), 0);
    std::optional<FT> bound;
    std::size_t searches = 0, next = 1;
    for_each_spread(center.size(), [&](std::size_t i) {
      char& is_component_reached = is_reached[components[center[i].idx()]];
      if(m_visits > greatest_number_of_visits && is_component_reached)
        return;
      search(center[i], is_component_reached ? bound : std::nullopt,
             is_component_reached ? most : m_mesh.num_vertices());
      is_component_reached = 1;
      if(++searches == next) {
        bound = m_slack * longest_of_basis();
        next *= 2;
      }
    });
    sort();
  }

  // Calls `visit` for the numbers up to `n`: zero, numbers with the most factors of two, and so
  // on.
  template <typename Visit>
  static void for_each_spread(std::size_t n, const Visit& visit)
  {
    std::size_t step = 1;
    while(step < n)
      step *= 2;
    visit(0);
    for(; step > 1; step /= 2)
      for(std::size_t i = step / 2; i < n; i += step)
        visit(i);
  }

  void sort()
  {
    std::stable_sort(m_loops.begin(), m_loops.end(),
                     [](const Loop& a, const Loop& b) { return a.length < b.length; });
  }

  FT longest_of_basis() const
  {
    std::vector<std::size_t> order = first_indices(m_loops.size());
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return m_loops[a].length < m_loops[b].length;
    });
    FT result(0);
    for(std::size_t i : basis(order))
      result = (std::max)(result, m_loops[i].length);
    return result;
  }

  // Finds loops through `center` with at most the length `bound`.
  void search(Vertex_index center, const std::optional<FT>& bound, std::size_t most)
  {
    std::unordered_map<Signature, std::size_t> found;
    std::vector<std::pair<FT, Halfedge_index>> best; // of each class
    std::size_t visits = 0;
    m_search.search(
      center, is_any,
      [&](Vertex_index v) {
        return visits++ < most && !(bound && 2 * m_search.distance(v) > *bound);
      },
      [&](Halfedge_index h, const FT& length, Signature signature) {
        if(bound && length > *bound)
          return;
        const auto [x, is_new] = found.emplace(signature, best.size());
        if(is_new)
          best.push_back({length, h});
        else if(length < best[x->second].first)
          best[x->second] = {length, h};
      });
    m_visits += visits;
    for(const auto& [length, h] : best)
      add(m_search.loop(h));
  }

  void add(std::vector<Halfedge_index> halfedges)
  {
    const FT length = m_search.length(halfedges);
    const auto [x, is_new] = m_index.emplace(m_search.signatures().of(halfedges), m_loops.size());
    if(is_new)
      m_loops.push_back({length, std::move(halfedges)});
    else if(length < m_loops[x->second].length)
      m_loops[x->second] = {length, std::move(halfedges)};
  }

  const Delta_complex& m_mesh;
  Loop_search<Surface> m_search;
  Homology_coordinates m_coordinates;
  FT m_slack;
  std::size_t m_visits = 0;
  std::vector<Loop> m_loops;
  std::unordered_map<Signature, std::size_t> m_index; // of the loop of a class
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds short loops along edges that are a basis of the first homology group. Every closed curve
/// is homologous to exactly one integer combination of them.
///
/// The loops are chosen by increasing length; no loop is a combination of earlier ones
/// \cgalCite{EW05}. They consist of two shortest paths from a base vertex and an edge between their
/// ends. Every loop of a shortest basis meets one of the base vertices. Searches from all base
/// vertices together end after visits of \f$2^{22}\f$ vertices. If they finish before, no basis of
/// loops along edges is shorter. `Edge_paths` shortens the loops to geodesics.
///
/// \param surface a model of `IntrinsicSurface`
/// \returns the halfedges of each loop, each starting where the one before ends. For a component of
///          genus \f$g\f$ these are \f$2g\f$ loops, or \f$2g+b-1\f$ if it has \f$b>0\f$ boundary
///          components. The shortest come first.
///
/// Complexity: \f$O(n \log n)\f$ for each base vertex. The number of base vertices
/// is at most the number of edges that the generators of the dual group cross. On large surfaces
/// the visits limit it. Rounded lengths decide which loops are found. Integers decide that they are
/// a basis.
template <typename Surface>
std::vector<std::vector<Halfedge_index>> homology_basis(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const internal::Loops_of_classes<Surface> search(surface, FT(1));
  return search.halfedges(search.basis(internal::first_indices(search.loops().size())));
}

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds a basis of loops that are short in another measure, such as the length after shortening.
///
/// The shortest loops along edges are measured: at most \f$4k + 16\f$ beside a shortest basis of
/// \f$k\f$ loops. They are up to 1.5 times as long as the loops of a shortest basis. By increasing
/// measure, each loop is chosen that is no combination of chosen loops. Complexity: the complexity
/// of the function without a measure, plus at most \f$5k + 16\f$ calls of `measure`.
///
/// \param surface a model of `IntrinsicSurface`
/// \param measure a function of the halfedges of a loop that returns a number
/// \returns the loops, beginning with the least measure
template <typename Surface, typename Measure>
std::vector<std::vector<Halfedge_index>> homology_basis(const Surface& surface,
                                                        const Measure& measure)
{
  typedef Length_of<Surface> FT;
  const internal::Loops_of_classes<Surface> search(surface, FT(1.5));
  std::vector<std::size_t> measured = search.basis(internal::first_indices(search.loops().size()));
  const std::size_t dimension = search.dimension();
  for(std::size_t i = 0; i < (std::min)(search.loops().size(), 4 * dimension + 16); ++i)
    if(std::find(measured.begin(), measured.end(), i) == measured.end())
      measured.push_back(i);
  std::vector<std::pair<decltype(measure(search.loops()[0].halfedges)), std::size_t>> order;
  for(std::size_t i : measured)
    order.push_back({measure(search.loops()[i].halfedges), i});
  std::sort(order.begin(), order.end());
  std::transform(order.begin(), order.end(), measured.begin(),
                 [](const auto& x) { return x.second; });
  return search.halfedges(search.basis(measured));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H
