// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Watch.h"

namespace py = pybind11;
namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

// The pause is short enough for a person who waits, and long enough to cost nothing.
constexpr std::chrono::milliseconds least_pause(50);

} // namespace

void Watch::start_stage(const std::string& name)
{
  m_stage = name;
  m_steps = 0;
  call_python();
}

void Watch::start(DCM::Flattening_stage stage)
{
  constexpr const char* names[] = {"cones", "optimize", "layout", "trace", "subdivide"};
  start_stage(names[static_cast<std::size_t>(stage)]);
}

void Watch::look_at_clock()
{
  if(Clock::now() - m_last >= least_pause)
    call_python();
}

void Watch::call_python()
{
  m_last = Clock::now();
  const py::gil_scoped_acquire acquire;
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  if(!m_progress.is_none())
    m_progress(m_stage, m_steps);
}
