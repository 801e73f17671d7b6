// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// This file defines convex functions with known minima: a linear part moves the minimum to a chosen
// point.

#ifndef TEST_CONVEX_FUNCTIONS_H
#define TEST_CONVEX_FUNCTIONS_H

#include "../Intrinsic_triangulations/testing.h"

#include <Eigen/SparseCore>

namespace convex {

typedef Eigen::VectorXd Vector;
typedef Eigen::SparseMatrix<double> Matrix;

struct Quadratic
{
  static double value(double x) { return x * x / 2; }
  static double slope(double x) { return x; }
  static double curvature(double) { return 1; }
};

// Represents a function that is linear far away: its curvature is zero, as a double, from about 380
// on.
struct Log_cosh
{
  static double value(double x)
  {
    return std::abs(x) + std::log1p(std::exp(-2 * std::abs(x))) - std::log(2.);
  }
  static double slope(double x) { return std::tanh(x); }
  static double curvature(double x) { return 1 / std::cosh(x) / std::cosh(x); }
};

// Represents a bend of width 1e-3, nearly straight elsewhere.
struct Sharp_bend
{
  static double value(double x) { return std::hypot(x, 1e-3); }
  static double slope(double x) { return x / std::hypot(x, 1e-3); }
  static double curvature(double x) { return 1e-6 / std::pow(std::hypot(x, 1e-3), 3); }
};

// Represents a function that is cubic on one side, and zero on the other.
struct Cubic_ramp
{
  static double value(double x) { return x > 0 ? x * x * x / 3 : 0; }
  static double slope(double x) { return x > 0 ? x * x : 0; }
  static double curvature(double x) { return x > 0 ? 2 * x : 0; }
};

struct Link
{
  Eigen::Index i, j; // i == j: a function of one variable
  double weight = 1;
  double scale = 1;
  double offset = 0;
};

// Collects a gradient, the sums of absolute values that bound its rounding, and a Hessian.
class Accumulator
{
public:
  void start(Eigen::Index size)
  {
    m_value = 0;
    m_gradient = m_magnitude = Vector::Zero(size);
    m_triplets.clear();
  }

  void add_value(double x) { m_value += x; }

  void add_slope(Eigen::Index i, double x)
  {
    m_gradient[i] += x;
    m_magnitude[i] += std::abs(x);
  }

  void add_curvature(Eigen::Index i, Eigen::Index j, double x)
  {
    m_triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), x);
  }

  double value() const { return m_value; }
  const Vector& gradient() const { return m_gradient; }
  // Returns the error of five rounding errors per term, and the few rounding errors of the sum.
  double gradient_error() const
  {
    return 10 * std::numeric_limits<double>::epsilon() *
           (m_magnitude.size() > 0 ? m_magnitude.maxCoeff() : 0);
  }

  Matrix Hessian() const
  {
    Matrix result(m_gradient.size(), m_gradient.size());
    result.setFromTriplets(m_triplets.begin(), m_triplets.end());
    return result;
  }

private:
  double m_value = 0;
  Vector m_gradient, m_magnitude;
  std::vector<Eigen::Triplet<double>> m_triplets;
};

// Implements a model of ConvexEnergy from `Derived::add_terms()`, minus the linear function that
// moves the minimum to `minimum`.
template <typename Derived>
class Function
{
public:
  typedef double FT;

  explicit Function(Vector minimum) : m_minimum(std::move(minimum)) {}

  std::size_t size() const { return static_cast<std::size_t>(m_minimum.size()); }
  const Vector& minimum() const { return m_minimum; }
  std::size_t evaluations() const { return m_evaluations; }

  void evaluate(const Vector& u)
  {
    if(m_linear.size() == 0) {
      sum(m_minimum);
      m_linear = m_sum.gradient();
    }
    ++m_evaluations;
    sum(u);
    m_sum.add_value(-m_linear.dot(u));
    for(Eigen::Index i = 0; i < u.size(); ++i)
      m_sum.add_slope(i, -m_linear[i]);
    m_Hessian = m_sum.Hessian();
  }

  double value() const { return m_sum.value(); }
  const Vector& gradient() const { return m_sum.gradient(); }
  const Matrix& Hessian() const { return m_Hessian; }
  double gradient_error() const { return m_sum.gradient_error(); }

private:
  void sum(const Vector& u)
  {
    m_sum.start(u.size());
    static_cast<const Derived&>(*this).add_terms(u, m_sum);
  }

  Vector m_minimum, m_linear;
  Accumulator m_sum;
  Matrix m_Hessian;
  std::size_t m_evaluations = 0;
};

// Represents a sum of weight / scale * F(scale * (x - offset)), where x is u_i - u_j, or u_i.
template <typename F>
class Linked : public Function<Linked<F>>
{
public:
  Linked(std::vector<Link> links, Vector minimum)
    : Function<Linked<F>>(std::move(minimum)), m_links(std::move(links))
  {}

  void add_terms(const Vector& u, Accumulator& sum) const
  {
    for(const Link& link : m_links)
      if(link.i == link.j)
        add_single(link, u[link.i], sum);
      else
        add_pair(link, u[link.i] - u[link.j], sum);
  }

private:
  static double argument(const Link& link, double x) { return link.scale * (x - link.offset); }
  static double link_value(const Link& link, double x)
  {
    return link.weight / link.scale * F::value(argument(link, x));
  }
  static double link_slope(const Link& link, double x)
  {
    return link.weight * F::slope(argument(link, x));
  }
  static double link_curvature(const Link& link, double x)
  {
    return link.weight * link.scale * F::curvature(argument(link, x));
  }

  static void add_single(const Link& link, double x, Accumulator& sum)
  {
    sum.add_value(link_value(link, x));
    sum.add_slope(link.i, link_slope(link, x));
    sum.add_curvature(link.i, link.i, link_curvature(link, x));
  }

  static void add_pair(const Link& link, double x, Accumulator& sum)
  {
    sum.add_value(link_value(link, x));
    sum.add_slope(link.i, link_slope(link, x));
    sum.add_slope(link.j, -link_slope(link, x));
    const double curvature = link_curvature(link, x);
    if(curvature == 0)
      return; // the pattern depends on the point
    sum.add_curvature(link.i, link.i, curvature);
    sum.add_curvature(link.j, link.j, curvature);
    sum.add_curvature(link.i, link.j, -curvature);
    sum.add_curvature(link.j, link.i, -curvature);
  }

  std::vector<Link> m_links;
};

// Represents a sum of log(exp u_i + exp u_j + exp u_k), constant along constants except for its
// linear part.
class Log_sum_exp : public Function<Log_sum_exp>
{
public:
  typedef std::array<Eigen::Index, 3> Triple;

  Log_sum_exp(std::vector<Triple> triples, Vector minimum)
    : Function<Log_sum_exp>(std::move(minimum)), m_triples(std::move(triples))
  {}

  void add_terms(const Vector& u, Accumulator& sum) const
  {
    for(const Triple& t : m_triples) {
      const double top = (std::max)({u[t[0]], u[t[1]], u[t[2]]});
      std::array<double, 3> p = {std::exp(u[t[0]] - top), std::exp(u[t[1]] - top),
                                 std::exp(u[t[2]] - top)};
      const double total = p[0] + p[1] + p[2];
      sum.add_value(top + std::log(total));
      for(std::size_t a = 0; a < 3; ++a) {
        sum.add_slope(t[a], p[a] / total);
        for(std::size_t b = 0; b < 3; ++b)
          sum.add_curvature(t[a], t[b],
                            (a == b ? p[a] * (total - p[a]) : -p[a] * p[b]) / (total * total));
      }
    }
  }

private:
  std::vector<Triple> m_triples;
};

inline Vector random_vector(std::size_t size, double range, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-range, range);
  Vector result(static_cast<Eigen::Index>(size));
  for(double& x : result)
    x = number(random);
  return result;
}

// Returns a grid of side * side variables, with weights 10^[-range, range].
inline std::vector<Link> grid(Eigen::Index side, double range = 0, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-range, range);
  std::vector<Link> result;
  for(Eigen::Index y = 0; y < side; ++y)
    for(Eigen::Index x = 0; x < side; ++x) {
      const Eigen::Index i = y * side + x;
      if(x + 1 < side)
        result.push_back({i, i + 1, std::pow(10., exponent(random))});
      if(y + 1 < side)
        result.push_back({i, i + side, std::pow(10., exponent(random))});
    }
  return result;
}

// Returns that grid in triangles.
inline std::vector<Log_sum_exp::Triple> triangles(Eigen::Index side)
{
  std::vector<Log_sum_exp::Triple> result;
  for(Eigen::Index y = 0; y + 1 < side; ++y)
    for(Eigen::Index x = 0; x + 1 < side; ++x) {
      const Eigen::Index i = y * side + x;
      result.push_back({i, i + 1, i + side});
      result.push_back({i + 1, i + side + 1, i + side});
    }
  return result;
}

} // namespace convex

#endif // TEST_CONVEX_FUNCTIONS_H
