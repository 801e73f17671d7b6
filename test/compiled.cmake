# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The compiled library and the headers alone give the same bytes.
if(TARGET Intrinsic_triangulations_compiled AND Eigen_FOUND)
  foreach(name IN ITEMS compiled header_only)
    add_executable(${name}_results compiled/results.cpp)
    target_compile_options(${name}_results PRIVATE $<$<CONFIG:Release>:-O0>) # built fast
    add_test(NAME compiled.${name}
      COMMAND ${CMAKE_COMMAND} -D program=$<TARGET_FILE:${name}_results>
        -D output=${CMAKE_CURRENT_BINARY_DIR}/${name}_results.txt
        -P "${CMAKE_CURRENT_SOURCE_DIR}/compiled/run.cmake")
    set_tests_properties(compiled.${name} PROPERTIES FIXTURES_SETUP compiled_results)
  endforeach()
  target_link_libraries(compiled_results PRIVATE Intrinsic_triangulations_compiled)
  target_link_libraries(header_only_results PRIVATE
    $<TARGET_PROPERTY:Intrinsic_triangulations_compiled,INTERFACE_LINK_LIBRARIES>)
  add_test(NAME compiled.same_bytes
    COMMAND ${CMAKE_COMMAND} -E compare_files compiled_results.txt header_only_results.txt)
  set_tests_properties(compiled.same_bytes PROPERTIES FIXTURES_REQUIRED compiled_results)
endif()
