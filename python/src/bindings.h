// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_BINDINGS_H
#define INTRINSIC_PYTHON_BINDINGS_H

#include <pybind11/pybind11.h>

// Each function adds the bindings of its file to the module.
void bind_surface(pybind11::module_& module);
void bind_triangulation(pybind11::module_& module);
void bind_operators(pybind11::module_& module);
void bind_distances(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_simplification(pybind11::module_& module);
void bind_polyhedron(pybind11::module_& module);
void bind_packing(pybind11::module_& module);
void bind_page(pybind11::module_& module);

#endif // INTRINSIC_PYTHON_BINDINGS_H
