# The kinds of target of this project, told apart by function and by folder:
#
#   bw_algorithm   pure: values in, result out. Any folder of components/ but those below. tests/house/check_purity.sh holds it to that.
#   bw_files       reads and writes files, no middleware          components/files/, components/<name>/files/
#   bw_component   adapts an algorithm to topics                  components/<name>/adaptor/, components/messages/
#   bw_tool        benches, experiments, training; no middleware  components/tools/<name>/
#   bw_verb        a verb of the program `bandwagon`              components/tools/<name>/, runtime/cli/
#   bw_test        one GoogleTest program, one CTest entry        tests/

add_library(bw_compile_options INTERFACE)
target_compile_features(bw_compile_options INTERFACE cxx_std_20)
target_compile_options(bw_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-field-initializers -Werror
  -Wno-restrict)  # GCC 12 sees overlaps that are not there in std::string operator+ (its bug 105651)
target_include_directories(bw_compile_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
if(BANDWAGON_SANITIZE)
  # GCC 12 warns of uninitialised memory inside its own library once code is instrumented.
  target_compile_options(bw_compile_options INTERFACE -Wno-maybe-uninitialized)
  add_compile_options(-fsanitize=${BANDWAGON_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BANDWAGON_SANITIZE})
endif()

include(${CMAKE_CURRENT_LIST_DIR}/precompiled.cmake)

# A static library bw_<name> that knows no middleware.
macro(bw_plain_library name precompiled)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(bw_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(bw_${name}
    PRIVATE $<BUILD_INTERFACE:bw_compile_options> ${ARG_PRIVATE}
    PUBLIC Eigen3::Eigen ${ARG_LINK})
  target_include_directories(bw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  bw_precompiled(bw_${name} ${precompiled})
endmacro()

# bw_algorithm(<name> SOURCES ... [LINK ...] [PRIVATE ...]): library bw_<name>, plain C++ and Eigen (and what it links).
function(bw_algorithm name)
  bw_plain_library(${name} plain ${ARGN})
  set_property(GLOBAL APPEND PROPERTY BANDWAGON_ALGORITHMS bw_${name})
endfunction()

# bw_files(<name> SOURCES ... [LINK ...] [PRIVATE ...]): library bw_<name>, between files and values.
function(bw_files name)
  bw_plain_library(${name} plain ${ARGN})
endfunction()

# bw_tool(<name> SOURCES ... [LINK ...] [PRIVATE ...]): library bw_<name>, what a verb or a program of its own does.
function(bw_tool name)
  bw_plain_library(${name} tool ${ARGN})
endfunction()

# An object library, linked into the program whole: what it registers when it is loaded must not be left out.
macro(bw_part_of_program target precompiled)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${target} OBJECT ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE bw_compile_options PUBLIC bandwagon_runtime ${ARG_LINK})
  bw_precompiled(${target} ${precompiled})
endmacro()

# bw_component(<name> SOURCES ... [LINK ...]): adaptor; registers itself with BW_COMPONENT.
function(bw_component name)
  if(BANDWAGON_ALGORITHMS_ONLY)
    return()
  endif()
  bw_part_of_program(bw_component_${name} component ${ARGN})
  set_property(GLOBAL APPEND PROPERTY BANDWAGON_COMPONENTS bw_component_${name})
endfunction()

# bw_verb(<name> SOURCES ... [LINK ...]): registers itself with BW_VERB.
function(bw_verb name)
  if(BANDWAGON_ALGORITHMS_ONLY)
    return()
  endif()
  bw_part_of_program(bw_verb_${name} component ${ARGN})
  target_link_libraries(bw_verb_${name} PUBLIC bw_cli)
  set_property(GLOBAL APPEND PROPERTY BANDWAGON_VERBS bw_verb_${name})
endfunction()

# bw_test(<name> SOURCES ... [LINK ...] [DOMAIN <id>]): one GoogleTest program, one CTest entry. A test that uses DDS names a domain id
# of its own; it never leaves loopback.
function(bw_test name)
  cmake_parse_arguments(ARG "" "DOMAIN" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE bw_compile_options ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_compile_definitions(test_${name} PRIVATE BANDWAGON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  bw_precompiled(test_${name} test)
  add_test(NAME ${name} COMMAND test_${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600)
  if(ARG_DOMAIN)
    get_property(domains GLOBAL PROPERTY BANDWAGON_TEST_DOMAINS)
    if(ARG_DOMAIN IN_LIST domains)
      message(FATAL_ERROR "test ${name}: domain ${ARG_DOMAIN} belongs to another test; tests run side by side")
    endif()
    set_property(GLOBAL APPEND PROPERTY BANDWAGON_TEST_DOMAINS ${ARG_DOMAIN})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "ROS_DOMAIN_ID=${ARG_DOMAIN}")
  endif()
endfunction()
