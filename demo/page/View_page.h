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

// What a command shows: surfaces, charts and numbers. It is written as a page of HTML, which a
// browser opens without a network; or the surfaces alone as a picture.
class View_page
{
public:
  // Returns whether three.js, with which pages draw, was there when this was built.
  static bool is_available() { return !embedded_files.empty(); }
  // Throws Program_error if pages are not available.
  static void check_available();

  // Its last points may have no data.
  void add_surface(const std::string& name, Output_mesh mesh);

  // Of the last surface: a position for each of its texture coordinates, or of its points if it has
  // none. A surface with a texture has this as its image in the plane if no other is set.
  void set_image(Image_kind kind, std::vector<std::array<double, 3>> positions);

  // Lines beside the image of the last surface.
  void set_outlines(std::vector<std::vector<std::array<double, 2>>> lines)
  {
    m_surfaces.back().outlines = std::move(lines);
  }

  // The page draws these in place of the mesh of the last surface, a common subdivision.
  void set_developed(Developed_faces faces) { m_surfaces.back().developed = std::move(faces); }

  // On the last surface, after what it is developed from. Nothing if there are none.
  void add_marks(Surface_marks marks);

  // Adds the numbers of angles, in degrees, in intervals of five; negative ones do not count.
  void add_angles(const std::string& name, const std::vector<double>& angles);

  // Continues a curve by a positive value; begins it if there is none with this name.
  void add_to_curve(const std::string& name, double value);

  void set_statistics(const Statistics& statistics) { m_statistics = statistics; }

  void write_html(Text& text) const;

  // See Surface_picture.h.
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

// Shows polygons as a file gives them, with all their defects in red. Those that name points that
// do not exist are left out.
void show(View_page& page, const std::string& name, const Polygon_soup& soup);

#endif // INTRINSIC_VIEW_PAGE_H
