// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VIEW_PAGE_H
#define INTRINSIC_VIEW_PAGE_H

#include "commands/Statistics.h"
#include "page/Embedded_file.h"
#include "pictures/Shown_surface.h"
#include "pictures/Surface_picture.h"
#include "reading/Polygon_soup.h"
#include "writing/Text.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

// Stores the results that a command shows: surfaces, charts and numbers. It is written as an HTML
// page, which a browser opens without a network. The surfaces alone are written as a picture.
class View_page
{
public:
  // Returns whether three.js, which draws pages, was available at build time.
  static bool is_available() { return !embedded_files.empty(); }
  // Throws Program_error, with the name of the option, if the path has not the extension of a page,
  // or if pages are not available. An empty path requests no page.
  static void check_available(const std::string& option, const std::string& path);

  // Adds a surface, whose last points may have no data.
  void add_surface(const std::string& name, Output_mesh mesh);

  // Sets the image of the last surface: a position for each of its texture coordinates, or of its
  // points if it has none. If no image is set, the texture of a surface is its image in the plane.
  void set_image(Image_kind kind, std::vector<std::array<double, 3>> positions);

  // Sets lines beside the image of the last surface.
  void set_outlines(std::vector<std::vector<std::array<double, 2>>> lines)
  {
    m_surfaces.back().outlines = std::move(lines);
  }

  // Sets the faces that the page draws instead of the mesh of the last surface, a common
  // subdivision.
  void set_developed(Developed_faces faces) { m_surfaces.back().developed = std::move(faces); }

  // Adds marks on the last surface, after its developed faces are set. Does nothing without marks.
  void add_marks(Surface_marks marks);

  // Adds the numbers of angles, in degrees, in intervals of five; negative ones do not count.
  void add_angles(const std::string& name, const std::vector<double>& angles);

  // Continues a curve by a positive value. Begins it if no curve has this name.
  void add_to_curve(const std::string& name, double value);

  void set_statistics(const Statistics& statistics) { m_statistics = statistics; }

  void write_html(Text& text) const;

  // Writes a picture, see Surface_picture.h.
  void write_picture(Text& text, const std::string& path,
                     const std::optional<Picture_section>& section = {}) const
  {
    ::write_picture(text, m_surfaces, path, section);
  }

private:
  std::vector<Shown_surface> m_surfaces;
  Statistics m_angles = Statistics::array();
  Statistics m_curves = Statistics::array();
  Statistics m_statistics;
};

// Shows the polygons of a file unchanged, with all their defects in red. Polygons that name
// nonexistent points are omitted.
void show(View_page& page, const std::string& name, const Polygon_soup& soup);

#endif // INTRINSIC_VIEW_PAGE_H
