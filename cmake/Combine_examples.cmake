# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes `output`, one program that runs the example that its first argument names: the source files
# `ARGN`, each in a namespace of its own, after all that they include.
function(combine_examples output)
  set(headers)
  set(namespaces)
  set(calls)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    file(READ "${source}" text)
    string(REGEX MATCHALL "#include [^\n]+" includes "${text}")
    list(APPEND headers ${includes})
    string(REGEX REPLACE "#include [^\n]+" "" text "${text}")
    # Only a global main() returns 0 where it ends without a word.
    string(REGEX REPLACE "}\n$" "return 0; }\n" text "${text}")
    string(APPEND namespaces "namespace ${name}_ {\n#line 1 \"${source}\"\n${text}}\n")
    string(APPEND calls "  if(name == \"${name}\")\n    return run(${name}_::main, argc - 1, argv + 1);\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "\n" headers)
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT [[
@headers@
#include <string>

@namespaces@
int run(int main(), int, char*[])
{
  return main();
}

int run(int main(int, char*[]), int argc, char* argv[])
{
  return main(argc, argv);
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "";
@calls@  return 2;
}
]])
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
endfunction()
