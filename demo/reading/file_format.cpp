// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/format_readers.h"
#include "reading/text_encoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

namespace {

constexpr std::size_t beginning = 2000; // of a file, in which words are looked for

struct Format_name
{
  const char* name;
  const char* extension;
};

// The formats are in the order of `File_format`.
constexpr std::array<Format_name, 6> formats = {{{"OFF", ".off"},
                                                 {"OBJ", ".obj"},
                                                 {"PLY", ".ply"},
                                                 {"STL", ".stl"},
                                                 {"VTP", ".vtp"},
                                                 {"XYZ", ".xyz"}}};

// Describes a format of other programs: extensions, the begin of the content, and a converter.
struct Foreign_format
{
  std::string_view extensions;
  std::array<std::string_view, 4> beginnings;
  const char* converter;
};

constexpr Foreign_format foreign_formats[] = {
  {".msh .mesh .med .inp .cgns .bdf .nas ",
   {"$meshformat", "meshversionformatted", "", ""},
   "`meshio convert FILE out.ply`"},
  {".vtk .vtu ",
   {"# vtk datafile", "", "", ""},
   "`meshio convert FILE out.ply`, or Save Data in ParaView,"},
  {".glb .gltf .3mf .fbx .dae .3ds .x3d .wrl .usd .usdz .blend ",
   {"gltf", std::string_view("pk\3\4", 4), "kaydara fbx", "#vrml"},
   "`assimp export FILE out.obj`, or Blender,"},
  {".step .stp .iges .igs .brep ",
   {"iso-10303-21", "dbrep_drawable", "", ""},
   "`gmsh -2 FILE -o out.stl`, or FreeCAD,"}};

bool has(const std::string& text, std::string_view what) { return text.find(what) != text.npos; }

std::string lower_case_beginning(const Scanner& in)
{
  const std::string text = lower_case(std::string(in.bytes().substr(0, beginning)));
  return text.substr((std::min)(text.find_first_not_of(" \t\r\n"), text.size()));
}

bool begins(const std::string& text, std::string_view word)
{
  return !word.empty() && text.compare(0, word.size(), word) == 0;
}

// Returns the first line that is neither empty nor a comment.
std::string first_line(const std::string& text)
{
  std::size_t start = 0, end = 0;
  for(; start < text.size(); start = end + 1) {
    start = text.find_first_not_of(" \t\r\n", start);
    end = text.find('\n', start);
    if(start == text.npos || text[start] != '#' || end == text.npos)
      break;
  }
  return start < text.size() ? text.substr(start, end - start) : "";
}

bool is_off_keyword(std::string_view word)
{
  for(const std::string_view prefix : {"st", "c", "n", "4", "n"})
    if(word.substr(0, prefix.size()) == prefix)
      word.remove_prefix(prefix.size());
  word = word.substr(0, word.find_last_not_of("0123456789") + 1);
  return word == "off" || word == "skel";
}

std::optional<File_format> format_of_content(const Scanner& in)
{
  if(is_binary_stl(in.bytes()))
    return File_format::STL;
  const std::string text = lower_case_beginning(in), line = first_line(text),
                    word = line.substr(0, line.find_first_of(" \t\r#"));
  if(word == "ply" && line.find_first_not_of(" \t\r", 3) == line.npos)
    return File_format::PLY;
  if(word == "solid" && has(text, "facet"))
    return File_format::STL;
  if((word == "<?xml" || word == "<vtkfile") && has(text, "polydata"))
    return File_format::VTP;
  if(is_off_keyword(word))
    return File_format::OFF;
  constexpr std::string_view statements[] = {"v", "vt",     "vn",     "f", "o",
                                             "g", "mtllib", "usemtl", "s"};
  if(std::find(std::begin(statements), std::end(statements), word) != std::end(statements) &&
     line.size() > word.size())
    return File_format::OBJ;
  return std::nullopt;
}

std::optional<File_format> format_of_extension(const std::string& extension)
{
  for(std::size_t i = 0; i < formats.size(); ++i)
    if(extension == formats[i].extension)
      return static_cast<File_format>(i);
  return std::nullopt;
}

const Foreign_format* foreign_format(const std::string& extension, const std::string& text)
{
  const auto begins_so = [&](std::string_view word) { return begins(text, word); };
  for(const Foreign_format& f : foreign_formats)
    if(std::any_of(f.beginnings.begin(), f.beginnings.end(), begins_so) ||
       (extension.size() > 1 && f.extensions.find(extension + ' ') != f.extensions.npos))
      return &f;
  return nullptr;
}

} // namespace

bool is_binary_stl(std::string_view bytes)
{
  constexpr std::size_t header = 84, facet = 50;
  std::size_t facets = 0;
  for(std::size_t k = 0; k < 4 && bytes.size() >= header; ++k)
    facets += std::size_t(static_cast<unsigned char>(bytes[80 + k])) << 8 * k;
  return bytes.size() >= header && bytes.size() - header == facet * facets;
}

const char* name_of(File_format format) { return formats[static_cast<std::size_t>(format)].name; }

bool is_misnamed(const Scanner& in, File_format format)
{
  return format_of_extension(extension_of(in.path())) != format;
}

File_format file_format(const Scanner& in)
{
  if(const auto format = format_of_content(in))
    return *format;
  const std::string extension = extension_of(in.path());
  if(const Foreign_format* f = foreign_format(extension, lower_case_beginning(in))) {
    std::string converter = f->converter;
    converter.replace(converter.find("FILE"), 4, in.path().string());
    in.fail_as_a_whole("this format is not read; " + converter + " converts it");
  }
  if(const auto format = format_of_extension(extension))
    return *format;
  in.fail_as_a_whole("neither the extension nor the content is of .off, .obj, .ply, .stl or .vtp");
}
