// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "bindings.h"
#include "page/View_page.h"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace {

// Each function has a name and a value for each point, which the Python layer has checked.
std::string page_of(const Number_array& points, const Index_array& faces,
                    const std::vector<std::pair<std::string, Number_array>>& functions)
{
  return released([&] {
    Polygon_soup soup = soup_of(points, faces);
    for(const auto& [name, values] : functions)
      soup.data.functions.push_back({name, vector_of(values)});
    clean(soup.data, soup.points.size());
    View_page page;
    show(page, "mesh", soup);
    page.set_statistics({{"points", soup.points.size()}, {"faces", soup.polygons.size()}});
    Text text;
    page.write_html(text);
    return text.take();
  });
}

} // namespace

void bind_page(py::module_& module)
{
  module.attr("has_pages") = View_page::is_available();
  module.def("page", &page_of);
}
