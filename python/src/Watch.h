// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_WATCH_H
#define INTRINSIC_PYTHON_WATCH_H

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>

// Serves as a visitor for all algorithms. From time to time it lets Python handle signals, such as
// Control-C. It also calls a function with the name of the stage and the number of its steps. An
// exception of either leaves the algorithm.
class Watch
{
  typedef CGAL::Intrinsic_triangulations::Vertex_index Vertex_index;
  typedef CGAL::Intrinsic_triangulations::Halfedge_index Halfedge_index;
  typedef CGAL::Intrinsic_triangulations::Face_index Face_index;
  typedef std::chrono::steady_clock Clock;

public:
  // `progress` may be None.
  Watch(pybind11::object progress, std::string stage)
    : m_progress(std::move(progress)), m_stage(std::move(stage)), m_last(Clock::now())
  {}

  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Begins a stage. Must be called without the lock of the interpreter, like all functions below.
  void start_stage(const std::string& name);

  // Counts one more step of the stage; cheap enough for inner loops.
  void step()
  {
    if(++m_steps % 256 == 0)
      look_at_clock();
  }

  // Counts one more step, which takes so long that the clock is read.
  void long_step()
  {
    ++m_steps;
    look_at_clock();
  }

  // ---- A model of `FlipVisitor` and `RefinementVisitor` ----

  void after_flip(Halfedge_index) { step(); }
  void before_exact_flips() {}
  template <class Inserter>
  void after_insertion(Vertex_index, const Inserter&)
  {
    step();
  }
  void after_removal(Vertex_index, Face_index) {}
  void after_renumbering() {}
  void before_exact_refinement() {}

  // ---- A model of `WindowVisitor` ----

  void after_windows(std::size_t number)
  {
    m_windows += number;
    if(m_windows >= windows_of_step) {
      m_windows = 0;
      long_step();
    }
  }

  // ---- A model of `SimplificationVisitor` ----

  template <class Star>
  void before_removal(const Star&, double)
  {}
  void after_removal(Vertex_index) { step(); }

  // ---- A model of `FlatteningVisitor` ----

  void start(CGAL::Discrete_conformal_maps::Flattening_stage stage);
  void after_iteration(std::size_t, double, double)
  {
    ++m_iterations;
    long_step();
  }

  // Returns the number of steps of all minimizations.
  std::size_t iterations() const { return m_iterations; }

private:
  void look_at_clock();
  void call_python();

  static constexpr std::size_t windows_of_step = 4096; // about a millisecond

  pybind11::object m_progress;
  std::string m_stage;
  Clock::time_point m_last;
  std::size_t m_steps = 0, m_iterations = 0, m_windows = 0;
};

#endif // INTRINSIC_PYTHON_WATCH_H
