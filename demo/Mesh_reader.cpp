// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_reader.h"

#include "Line_counting_buffer.h"
#include "Program_error.h"
#include "file_extension.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <fstream>
#include <new>
#include <string>

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason)
{
  throw Program_error(path.string() + ": " + reason);
}

void check_readable(const std::filesystem::path& path)
{
  if(!std::filesystem::exists(path))
    fail(path, "no such file");
  if(std::filesystem::is_directory(path))
    fail(path, "is a directory");
  if(!std::ifstream(path))
    fail(path, "cannot be opened");
  if(std::ifstream(path).peek() == std::ifstream::traits_type::eof())
    fail(path, "is empty");
}

// Lines mean nothing in binary files.
bool is_text(const std::filesystem::path& path)
{
  std::string start(64, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), 64);
  return start.find("binary") == std::string::npos && start.find("BINARY") == std::string::npos;
}

bool read_stream(std::istream& in, const std::string& extension, Polygon_soup& soup)
{
  if(extension == ".off")
    return CGAL::IO::read_OFF(in, soup.points, soup.polygons);
  if(extension == ".obj")
    return CGAL::IO::read_OBJ(in, soup.points, soup.polygons);
  return CGAL::IO::read_PLY(in, soup.points, soup.polygons);
}

void read_with_lines(const std::filesystem::path& path, const std::string& extension,
                     Polygon_soup& soup)
{
  std::ifstream file(path, std::ios::binary);
  Line_counting_buffer buffer(file);
  std::istream in(&buffer);
  if(read_stream(in, extension, soup))
    return;
  // At the end of an OBJ file only the indices can be wrong: the diagnosis says which.
  if(extension == ".obj" && buffer.has_ended() && !soup.points.empty())
    return;
  if(buffer.has_ended())
    fail(path, "ends too early");
  if(!is_text(path))
    fail(path, "cannot be read");
  fail(path, "line " + std::to_string(buffer.line()) +
               " cannot be understood or names a vertex that does not exist");
}

void read_stl(const std::filesystem::path& path, Polygon_soup& soup)
{
  if(!CGAL::IO::read_STL(path.string(), soup.points, soup.polygons))
    fail(path, "cannot be read");
  soup.merged_corners = 3 * soup.polygons.size() - soup.points.size();
}

void read(const std::filesystem::path& path, const std::string& extension, Polygon_soup& soup)
{
  if(extension == ".off" || extension == ".obj" || extension == ".ply")
    read_with_lines(path, extension, soup);
  else if(extension != ".stl")
    fail(path, "the extension is not one of .off, .obj, .ply and .stl");
  else
    read_stl(path, soup);
}

} // namespace

Polygon_soup read_mesh(const std::filesystem::path& path)
{
  check_readable(path);
  Polygon_soup soup;
  try {
    read(path, extension_of(path), soup);
  } catch(const std::bad_alloc&) {
    fail(path, "announces more elements than fit into memory");
  } catch(const std::length_error&) {
    fail(path, "announces more elements than fit into memory");
  }
  if(soup.polygons.empty())
    fail(path, "has no faces");
  return soup;
}
