// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_reader.h"

#include "file_extension.h"
#include "format_readers.h"

#include <new>
#include <stdexcept>
#include <string>

namespace {

void read(Scanner& in, const std::string& extension, Polygon_soup& soup, bool are_points_allowed)
{
  if(extension == ".off")
    read_off(in, soup);
  else if(extension == ".obj")
    read_obj(in, soup);
  else if(extension == ".ply")
    read_ply(in, soup);
  else if(extension == ".stl")
    read_stl(in, soup);
  else if(extension == ".xyz" && are_points_allowed)
    read_xyz(in, soup);
  else
    in.fail_as_a_whole("the extension is not one of .off, .obj, .ply and .stl");
}

} // namespace

Polygon_soup read_mesh(const std::filesystem::path& path, bool are_points_allowed)
{
  Scanner in(path);
  Polygon_soup soup;
  try {
    read(in, extension_of(path), soup, are_points_allowed);
    clean(soup.data, soup.points.size());
  } catch(const std::bad_alloc&) {
    in.fail_as_a_whole("has more elements than fit into memory");
  } catch(const std::length_error&) {
    in.fail_as_a_whole("has more elements than there are numbers for");
  }
  if(soup.polygons.empty() && (!are_points_allowed || soup.points.empty()))
    in.fail_as_a_whole("has no faces");
  return soup;
}
