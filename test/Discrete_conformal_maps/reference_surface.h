// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_REFERENCE_SURFACE_H
#define DISCRETE_CONFORMAL_MAPS_TEST_REFERENCE_SURFACE_H

#include "../Intrinsic_triangulations/generators.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Dense>

// This file computes discrete conformal maps in a hundred digits, from the positions on,
// independently of the library.
namespace Test_surfaces {

typedef boost::multiprecision::cpp_bin_float_100 Long_real;

enum class Reference_faces
{
  flat,
  hyperbolic // with sides x for scaled lengths sinh(x / 2)
};

// Represents a closed surface of triangles: a mesh, or the double of one with boundary. Halfedges
// h, h ^ 1 are the two sides of an edge.
class Reference_surface
{
public:
  explicit Reference_surface(const Mesh& mesh) : m_size(mesh.number_of_vertices())
  {
    const bool is_doubled = has_boundary(mesh);
    std::map<std::size_t, std::size_t> copy; // of vertices inside
    for(Vertex_index v : mesh.vertices()) {
      input_vertex.push_back(v);
      copy[v.idx()] = v.idx();
    }
    for(Vertex_index v : mesh.vertices())
      if(is_doubled && !mesh.is_border(v)) {
        copy[v.idx()] = input_vertex.size();
        input_vertex.push_back(v);
      }
    Known_sides known;
    for(const auto f : mesh.faces()) {
      std::array<std::size_t, 3> corner{};
      std::size_t s = 0;
      for(Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        corner[s++] = v.idx();
      add_face(corner, false, mesh, known);
      if(is_doubled)
        add_face({copy[corner[0]], copy[corner[2]], copy[corner[1]]}, true, mesh, known);
    }
    m_scale.assign(input_vertex.size(), Long_real(0));
    flip_until_Delaunay([this](std::size_t h) { return Euclidean_flip(h); });
  }

  // The vertices of the mesh come first.
  std::vector<Vertex_index> input_vertex;

  std::size_t number_of_input_vertices() const { return m_size; }
  std::size_t number_of_halfedges() const { return m_next.size(); }
  std::size_t next(std::size_t h) const { return m_next[h]; }
  std::size_t source(std::size_t h) const { return m_source[h]; }
  std::size_t target(std::size_t h) const { return m_source[h ^ 1]; }

  // Returns the scaled length of an edge.
  Long_real length(std::size_t h) const
  {
    return m_length[h / 2] * exp((m_scale[source(h)] + m_scale[target(h)]) / 2);
  }

  // Sets scale factors of the vertices of the mesh, and flips to the ideal Delaunay triangulation.
  template <typename Real>
  void scale(const std::vector<Real>& u)
  {
    for(std::size_t v = 0; v < m_scale.size(); ++v)
      m_scale[v] = u[input_vertex[v].idx()];
    flip_until_Delaunay([this](std::size_t h) {
      const std::size_t n = m_next[h], p = m_next[n], k = m_next[h ^ 1], q = m_next[k];
      return Long_real((plain(k) * plain(n) + plain(p) * plain(q)) / plain(h)); // Ptolemy
    });
  }

  // Returns curvatures; on the boundary twice the exterior angles.
  std::vector<Long_real> curvatures(Reference_faces faces = Reference_faces::flat) const
  {
    std::vector<Long_real> result(m_scale.size(), 2 * boost::math::constants::pi<Long_real>());
    for(std::size_t h = 0; h < m_next.size(); ++h)
      result[source(h)] -= angle(h, faces);
    result.resize(m_size);
    return result;
  }

  // Applies Newton's method for flat faces from the present scale factors on. Gradients have a
  // hundred digits, and directions have the digits of `double`. Fixed scale factors are kept.
  std::vector<Long_real> find_scale_factors(const std::vector<double>& rounded_curvature,
                                            const std::vector<bool>& is_fixed)
  {
    const std::vector<Long_real> curvature = balanced(rounded_curvature, is_fixed);
    std::vector<Long_real> u(m_scale.begin(), m_scale.begin() + std::ptrdiff_t(m_size));
    Long_real error = gradient_norm(curvature, is_fixed);
    for(int step = 0; step < 100 && error > Long_real("1e-25"); ++step) {
      const Eigen::VectorXd direction = Newton_direction(curvature, is_fixed);
      Long_real part = 1, reached = error;
      for(int halving = 0; halving < 40; ++halving, part /= 2) {
        std::vector<Long_real> x = u;
        for(std::size_t v = 0; v < m_size; ++v)
          x[v] -= part * direction[Eigen::Index(v)];
        scale(x);
        reached = gradient_norm(curvature, is_fixed);
        if(reached < error) {
          u = std::move(x);
          break;
        }
      }
      if(!(reached < error))
        break;
      error = reached;
    }
    EXPECT_LT(error, Long_real("1e-25"));
    scale(u);
    return u;
  }

private:
  // Stores halfedges by their ends. An edge of the second copy inside can have the ends of another
  // edge.
  typedef std::map<std::tuple<std::size_t, std::size_t, bool>, std::size_t> Known_sides;

  static bool has_boundary(const Mesh& mesh)
  {
    const auto e = mesh.edges();
    return std::any_of(e.begin(), e.end(), [&](auto x) { return mesh.is_border(x); });
  }

  void add_face(const std::array<std::size_t, 3>& corner, bool is_copy, const Mesh& mesh,
                Known_sides& known)
  {
    std::array<std::size_t, 3> side{};
    for(std::size_t s = 0; s < 3; ++s) {
      const std::size_t from = corner[s], to = corner[(s + 1) % 3], size = m_next.size();
      const Vertex_index v = input_vertex[from], w = input_vertex[to];
      const bool is_other = is_copy && !mesh.is_border(mesh.edge(mesh.halfedge(v, w)));
      side[s] = known.emplace(std::tuple(from, to, is_other), size).first->second;
      if(side[s] != size)
        continue;
      known.emplace(std::tuple(to, from, is_other), size + 1);
      m_source.insert(m_source.end(), {from, to});
      m_next.resize(size + 2);
      m_length.push_back(distance(mesh.point(v), mesh.point(w)));
    }
    for(std::size_t s = 0; s < 3; ++s)
      m_next[side[s]] = side[(s + 1) % 3];
  }

  static Long_real distance(const Point& p, const Point& q)
  {
    Long_real square = 0;
    for(int i = 0; i < 3; ++i)
      square += pow(Long_real(p[i]) - Long_real(q[i]), 2);
    return sqrt(square);
  }

  const Long_real& plain(std::size_t h) const { return m_length[h / 2]; }

  // Returns the cosine of the angle opposite to h, in the scaled lengths.
  Long_real opposite_cosine(std::size_t h) const
  {
    const Long_real a = length(h), b = length(m_next[h]), c = length(m_next[m_next[h]]);
    return (b * b + c * c - a * a) / (2 * b * c);
  }

  // Returns the length of the other diagonal, in the plane.
  Long_real Euclidean_flip(std::size_t h) const
  {
    const Long_real& a = plain(h);
    const auto apex = [&](std::size_t side) { // relative to the source of `side`
      const Long_real x =
        (a * a + pow(plain(m_next[m_next[side]]), 2) - pow(plain(m_next[side]), 2)) / (2 * a);
      return std::pair(x, Long_real(sqrt(pow(plain(m_next[m_next[side]]), 2) - x * x)));
    };
    const auto left = apex(h), right = apex(h ^ 1);
    return sqrt(pow(left.first - (a - right.first), 2) + pow(left.second + right.second, 2));
  }

  template <typename Flipped_length>
  void flip_until_Delaunay(const Flipped_length& flipped_length)
  {
    const Long_real tie("-1e-90");
    for(bool is_done = false; !is_done;) {
      is_done = true;
      for(std::size_t h = 0; h < m_next.size(); h += 2) {
        const std::size_t o = h ^ 1, n = m_next[h], p = m_next[n], k = m_next[o], q = m_next[k];
        if(n == o || p == o || opposite_cosine(h) + opposite_cosine(o) > tie)
          continue;
        is_done = false;
        m_length[h / 2] = flipped_length(h);
        m_source[h] = source(q);
        m_source[o] = source(p);
        m_next[h] = p;
        m_next[p] = k;
        m_next[k] = h;
        m_next[o] = q;
        m_next[q] = n;
        m_next[n] = o;
      }
    }
  }

  // Returns the angle at the source of h.
  Long_real angle(std::size_t h, Reference_faces faces) const
  {
    std::array<Long_real, 3> x;
    for(Long_real& side : x) {
      side = faces == Reference_faces::flat ? length(h) : Long_real(2 * asinh(length(h)));
      h = m_next[h];
    }
    const Long_real s = (x[0] + x[1] + x[2]) / 2;
    const auto part = [&](const Long_real& t) {
      return faces == Reference_faces::flat ? t : Long_real(sinh(t));
    };
    return 2 * atan(sqrt(part(s - x[0]) * part(s - x[2]) / (part(s) * part(s - x[1]))));
  }

  std::vector<int> numbers_of_copies() const
  {
    std::vector<int> result(m_size, 0);
    for(Vertex_index v : input_vertex)
      ++result[v.idx()];
    return result;
  }

  // Returns curvatures that, without fixed scale factors, sum up to 2 pi times the Euler
  // characteristic in all digits.
  std::vector<Long_real> balanced(const std::vector<double>& curvature,
                                  const std::vector<bool>& is_fixed) const
  {
    std::vector<Long_real> result(curvature.begin(), curvature.end());
    if(std::count(is_fixed.begin(), is_fixed.end(), true) != 0)
      return result;
    const std::vector<int> copies = numbers_of_copies();
    const std::vector<Long_real> present = curvatures();
    Long_real rest = 0;
    for(std::size_t v = 0; v < m_size; ++v)
      rest += copies[v] * (present[v] - result[v]);
    EXPECT_LT(abs(rest), 1e-11);
    for(Long_real& x : result)
      x += rest / Long_real(m_scale.size());
    return result;
  }

  Long_real gradient_norm(const std::vector<Long_real>& curvature,
                          const std::vector<bool>& is_fixed) const
  {
    Long_real result = 0;
    const std::vector<Long_real> present = curvatures();
    for(std::size_t v = 0; v < m_size; ++v)
      if(!is_fixed[v])
        result += pow(present[v] - curvature[v], 2);
    return sqrt(result);
  }

  // Returns Newton's direction by the cotan Laplacian, in which copies have the variables of their
  // original vertices.
  Eigen::VectorXd Newton_direction(const std::vector<Long_real>& curvature,
                                   const std::vector<bool>& is_fixed) const
  {
    const auto n = Eigen::Index(m_size);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for(std::size_t h = 0; h < m_next.size(); ++h) {
      const double c = double(opposite_cosine(h)), weight = c / std::sqrt(1 - c * c) / 2;
      const auto i = Eigen::Index(input_vertex[source(h)].idx()),
                 j = Eigen::Index(input_vertex[target(h)].idx());
      matrix(i, i) += weight;
      matrix(j, j) += weight;
      matrix(i, j) -= weight;
      matrix(j, i) -= weight;
    }
    // Rows belong to the double: the gradient of a vertex counts once for each of its copies.
    Eigen::VectorXd rest(n);
    const std::vector<Long_real> present = curvatures();
    const std::vector<int> copies = numbers_of_copies();
    for(std::size_t v = 0; v < m_size; ++v)
      rest[Eigen::Index(v)] = double(present[v] - curvature[v]) * copies[v];
    const bool is_any_fixed = std::count(is_fixed.begin(), is_fixed.end(), true) != 0;
    for(Eigen::Index v = 0; v < n; ++v)
      if(is_any_fixed ? is_fixed[std::size_t(v)] : v == 0) {
        matrix.row(v).setZero();
        matrix.col(v).setZero();
        matrix(v, v) = 1;
        rest[v] = 0;
      }
    return matrix.ldlt().solve(rest);
  }

  std::size_t m_size;
  std::vector<std::size_t> m_next, m_source; // for each halfedge
  std::vector<Long_real> m_length;           // for each edge, without scale factors
  std::vector<Long_real> m_scale;            // for each vertex, also copies
};

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_REFERENCE_SURFACE_H
