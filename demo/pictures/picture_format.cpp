// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Program_error.h"
#include "pictures/Canvas.h"
#include "reading/text_encoding.h"

namespace {

bool is_png(const std::string& path) { return extension_of(path) == ".png"; }

bool is_svg(const std::string& path) { return path == "-" || extension_of(path) == ".svg"; }

} // namespace

std::unique_ptr<Canvas> canvas(Text& text, const std::string& path, double width, double height,
                               const std::vector<Line_style>& styles, double line_scale)
{
  return is_png(path) ? png_canvas(text, width, height, line_scale)
                      : svg_canvas(text, width, height, styles);
}

void check_picture_available(const std::string& option, const std::string& path)
{
  if(!path.empty() && !is_png(path) && !is_svg(path))
    throw Program_error(path + ": " + option + " needs a name that ends with .svg or .png");
  Text text;
  if(is_png(path) && !png_canvas(text, 1, 1))
    throw Program_error(option +
                        ": this program was built without Cairo, which draws PNG; name a .svg "
                        "file, or install libcairo2-dev and build again");
}
