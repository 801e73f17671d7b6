// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <exception>
#include <string>

namespace {

// Lets Python raise `intrinsic.errors.type(message)` with tuples or numbers as attributes.
void raise(const std::string& type, const std::string& message,
           const Element_error::Elements& elements = {})
{
  const py::object error_type = py::module_::import("intrinsic.errors").attr(type.c_str());
  const py::object error = error_type(message);
  for(const auto& [name, indices] : elements)
    if(indices.size() == 1)
      error.attr(name.c_str()) = indices.front();
    else
      error.attr(name.c_str()) = py::tuple(py::cast(indices));
  PyErr_SetObject(error_type.ptr(), error.ptr());
}

void translate(std::exception_ptr exception)
{
  try {
    if(exception)
      std::rethrow_exception(exception);
  } catch(const Element_error& e) {
    raise(e.type(), e.what(), e.elements());
  } catch(const IT::Negative_curvature& e) {
    raise("NegativeCurvatureError", e.what(), {{"vertex", {e.vertices().front()}}});
  } catch(const IT::Invalid_input& e) {
    raise("InputError", e.what());
  } catch(const IT::File_format_error& e) {
    raise("InputError", e.what());
  } catch(const IT::Underflow_error& e) {
    raise("UnderflowError", e.what());
  } catch(const IT::Numerical_error& e) {
    raise("NumericalError", e.what());
  } catch(const IT::Error& e) {
    raise("LimitError", e.what());
  }
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.doc() = "The compiled part of the package intrinsic.";
  py::register_exception_translator(translate);
  bind_surface(module);
  bind_triangulation(module);
  bind_operators(module);
  bind_distances(module);
  bind_maps(module);
  bind_simplification(module);
  bind_polyhedron(module);
  bind_packing(module);
#ifdef INTRINSIC_HAS_PAGES
  bind_page(module);
#else
  module.attr("has_pages") = false;
#endif
}
