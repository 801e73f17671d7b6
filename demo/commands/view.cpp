// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "page/View_page.h"
#include "reading/Mesh_reader.h"
#include "writing/Output.h"

#include <filesystem>

namespace {

struct View_options
{
  std::vector<std::string> inputs;
  std::string output;
};

constexpr const char* view_help =
  R"(The page is one file for any browser with WebGL 2, without a network. It shows the meshes side
by side, turned together, with their defects in red. A click on a point shows its position. The page
explains the keys.

Most other commands write such a page with --view FILE.html. It shows the surface with the edges of
its triangulations, and its image in the plane, on the sphere or in the Poincare disk. Colors show
scale factors, distances, curvature, functions of the input, or faces. A checkerboard shows texture
coordinates, by projective or linear interpolation. Histograms of angles and the statistics follow.
Pages of large meshes draw intrinsic edges without the common subdivision, as with --direct.

Example:
  intrinsic view bunny.obj scan.stl -o meshes.html)";

int view(const Common_options& common, const View_options& options)
{
  Output output(common.read_files, {options.output});
  View_page::check_available("--output", options.output);
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

} // namespace

void define_view(Command_line& line)
{
  const auto [command, options] =
    line.add("view", "Write a page that shows meshes in a browser", view, view_help);
  add_read_file(command, line.common(), "mesh", options.inputs,
                "Meshes (.off, .obj, .ply, .stl, .vtp)")
    ->required();
  command.add_option("-o,--output", options.output, "HTML file; - for standard output")->required();
}
