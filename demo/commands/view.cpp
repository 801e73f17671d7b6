// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

#include "page/soup_view.h"
#include "reading/Mesh_reader.h"
#include "writing/Output.h"

#include <filesystem>

int view(const View_options& options)
{
  View_page::check_available();
  Output output(options.inputs.front(), {options.output});
  View_page page;
  Statistics statistics{{"command", "view"}, {"input", options.inputs.front()}};
  for(const std::string& input : options.inputs) {
    const Polygon_soup soup = read_mesh(input);
    const std::string name = std::filesystem::path(input).filename();
    show(page, name, soup);
    statistics[name] = {{"points", soup.points.size()}, {"polygons", soup.polygons.size()}};
  }
  page.set_statistics(statistics);
  output.add(options.output, [&](Text& text) { page.write_html(text); });
  output.commit();
  return 0;
}
