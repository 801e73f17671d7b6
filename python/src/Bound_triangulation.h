// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_BOUND_TRIANGULATION_H
#define INTRINSIC_PYTHON_BOUND_TRIANGULATION_H

#include "Surface.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>

#include <memory>
#include <optional>
#include <utility>

// Wraps an intrinsic triangulation for Python. It stores its surface, and the correspondence of
// both, which is computed when it is first needed.
class Bound_triangulation
{
public:
  Bound_triangulation(std::shared_ptr<Surface> surface, Triangulation triangulation)
    : m_surface(std::move(surface)), m_triangulation(std::move(triangulation))
  {}

  Bound_triangulation(const Bound_triangulation&) = delete;
  Bound_triangulation& operator=(const Bound_triangulation&) = delete;

  // Returns the surface, or null if the triangulation was read from a file.
  const std::shared_ptr<Surface>& surface() const { return m_surface; }
  bool has_positions() const { return m_surface && m_surface->has_positions(); }
  const Triangulation& triangulation() const { return m_triangulation; }

  // Returns the result of `change(triangulation)`.
  template <class Change>
  auto changed(const Change& change)
  {
    m_correspondence.reset();
    return change(m_triangulation);
  }

  const IT::Correspondence<>& correspondence() const
  {
    if(!m_correspondence)
      m_correspondence.emplace(m_triangulation);
    return *m_correspondence;
  }

  // Returns `use(triangulation, paths)` of a triangulation that is the input, and paths on it.
  // Takes all flips of the paths back.
  template <class Use>
  auto with_paths(const Use& use) const
  {
    if(!m_paths)
      m_paths = std::make_unique<Paths_on_input>(m_triangulation);
    const Rewinding rewinding{m_paths->paths};
    return use(std::as_const(m_paths->triangulation), m_paths->paths);
  }

private:
  typedef IT::Edge_paths<Triangulation::Traits> Edge_paths;

  struct Paths_on_input
  {
    explicit Paths_on_input(const Triangulation& of) : triangulation(of), paths(reset()) {}

    Triangulation& reset()
    {
      triangulation.reset_to_input();
      return triangulation;
    }

    Triangulation triangulation;
    Edge_paths paths;
  };

  struct Rewinding
  {
    ~Rewinding() { paths.rewind(); }
    Edge_paths& paths;
  };

  std::shared_ptr<Surface> m_surface;
  Triangulation m_triangulation;
  mutable std::optional<IT::Correspondence<>> m_correspondence;
  mutable std::unique_ptr<Paths_on_input> m_paths; // null until paths are needed
};

#endif // INTRINSIC_PYTHON_BOUND_TRIANGULATION_H
