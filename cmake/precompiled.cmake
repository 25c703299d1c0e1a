# Precompiled headers: most of the time that a source takes is spent in headers that all sources of its kind share. One set for each
# kind of target (cmake/bandwagon.cmake), built once. They speed up, they do not replace an include: with BANDWAGON_PRECOMPILE=OFF
# everything builds, launch_scripts/lint.sh looks at every source that way, and tests/house/check_includes.sh knows the names that they bring.
option(BANDWAGON_PRECOMPILE "Precompiled headers" ON)

set(bw_plain_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <random> <set> <span> <string> <string_view>
  <utility> <vector> <Eigen/Dense>)

# bw_precompiled_set(<name> <kind of target> HEADERS ... [LINK ...] [CHECKED]): what bw_precompiled() takes by name. GCC accepts the set only
# where it would have compiled it alike: an OBJECT set is for libraries, an EXECUTABLE one for programs, a CHECKED one for BANDWAGON_CHECKED.
function(bw_precompiled_set name kind)
  cmake_parse_arguments(ARG "CHECKED" "" "HEADERS;LINK" ${ARGN})
  if(NOT BANDWAGON_PRECOMPILE)
    return()
  endif()
  set(source ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "int main() { return 0; }\n")
  endif()
  if(kind STREQUAL EXECUTABLE)
    add_executable(bw_precompiled_${name} EXCLUDE_FROM_ALL ${source})
    set_target_properties(bw_precompiled_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/precompiled)
  else()
    add_library(bw_precompiled_${name} OBJECT EXCLUDE_FROM_ALL ${source})
  endif()
  target_link_libraries(bw_precompiled_${name} PRIVATE bw_compile_options Eigen3::Eigen ${ARG_LINK})
  target_precompile_headers(bw_precompiled_${name} PRIVATE ${ARG_HEADERS})
  if(ARG_CHECKED)
    target_compile_definitions(bw_precompiled_${name} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
endfunction()

# bw_precompiled(<target> <name>): the target's sources begin with the named set, and with the checked one where BANDWAGON_CHECKED names the
# target.
function(bw_precompiled target name)
  if(target IN_LIST BANDWAGON_CHECKED)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
    string(APPEND name _checked)
  endif()
  if(BANDWAGON_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM bw_precompiled_${name})
    # Of a precompiled std::string, GCC 12 sees overflows that are not there in operator+ too (its bug 105329).
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  endif()
endfunction()

bw_precompiled_set(plain OBJECT HEADERS ${bw_plain_headers})
bw_precompiled_set(plain_checked OBJECT HEADERS ${bw_plain_headers} CHECKED)
bw_precompiled_set(tool OBJECT HEADERS ${bw_plain_headers} <nlohmann/json.hpp> LINK nlohmann_json::nlohmann_json)
if(BANDWAGON_TESTS)
  bw_precompiled_set(test EXECUTABLE HEADERS ${bw_plain_headers} <gmock/gmock.h> <gtest/gtest.h> LINK GTest::gmock bw_test_options)
endif()
if(NOT BANDWAGON_ALGORITHMS_ONLY)
  set(bw_component_headers ${bw_plain_headers} <fmt/format.h> <runtime/component.hpp>)
  bw_precompiled_set(component OBJECT HEADERS ${bw_component_headers} LINK bandwagon_runtime)
  bw_precompiled_set(component_checked OBJECT HEADERS ${bw_component_headers} LINK bandwagon_runtime CHECKED)
  if(BANDWAGON_TESTS)
    bw_precompiled_set(test_component EXECUTABLE HEADERS ${bw_component_headers} <gmock/gmock.h> <gtest/gtest.h>
      LINK bandwagon_runtime GTest::gmock bw_test_options)
  endif()
endif()
