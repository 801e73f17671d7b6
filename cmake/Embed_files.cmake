# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes the source file `output`, which defines `embedded_files`, see page/Embedded_file.h, from text
# files.
# Literals stay below the length that compilers must accept.
function(embed_files output)
  set(code "#include \"page/Embedded_file.h\"\n\nconst std::vector<Embedded_file> embedded_files = {\n")
  foreach(path IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    cmake_path(GET path FILENAME name)
    file(READ "${path}" text)
    string(LENGTH "${text}" size)
    string(APPEND code "{\"${name}\", {\n")
    set(begin 0)
    while(begin LESS size)
      string(SUBSTRING "${text}" ${begin} 32000 piece)
      string(APPEND code "R\"EMBEDDED(${piece})EMBEDDED\",\n")
      math(EXPR begin "${begin} + 32000")
    endwhile()
    string(APPEND code "}},\n")
  endforeach()
  string(APPEND code "};\n")
  file(CONFIGURE OUTPUT "${output}" CONTENT "@code@" @ONLY)
endfunction()
