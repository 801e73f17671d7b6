// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Mesh_reader.h"

#include "reading/format_readers.h"

#include <new>
#include <stdexcept>
#include <string>

namespace {

void read(Scanner& in, File_format format, Polygon_soup& soup)
{
  switch(format) {
    case File_format::OFF: return read_off(in, soup);
    case File_format::OBJ: return read_obj(in, soup);
    case File_format::PLY: return read_ply(in, soup);
    case File_format::STL: return read_stl(in, soup);
    case File_format::VTP: return read_vtp(in, soup);
    case File_format::XYZ: return read_xyz(in, soup);
  }
}

} // namespace

void read_xyz(Scanner& in, Polygon_soup& soup)
{
  for(in.skip_comments('#'); !in.at_end(); in.skip_comments('#')) {
    const double x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
    soup.points.emplace_back(x, y, z);
    in.skip_line(); // normals or colors
  }
}

Polygon_soup read_mesh(const std::filesystem::path& path, bool are_points_allowed)
{
  Scanner in(path == "-" ? "/dev/stdin" : path);
  Polygon_soup soup;
  try {
    const File_format format = file_format(in);
    if(is_misnamed(in, format))
      soup.format = name_of(format);
    read(in, format, soup);
    clean(soup.data, soup.points.size());
  } catch(const std::bad_alloc&) {
    in.fail_as_a_whole("has more elements than fit into memory");
  } catch(const std::length_error&) {
    in.fail_as_a_whole("has more elements than indices allow");
  }
  if(soup.polygons.empty() && (!are_points_allowed || soup.points.empty()))
    in.fail_as_a_whole(soup.points.empty() ? "has no faces"
                                           : "has no faces; `intrinsic distance` and `intrinsic "
                                             "operators` triangulate points with --neighbors 30");
  return soup;
}
