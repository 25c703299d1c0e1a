# The kinds of target of this project, told apart by function and by folder:
#
#   bw_algorithm   pure: values in, result out. Any folder of components/ but those below. tests/house/check_purity.sh holds it to that.
#   bw_files       reads and writes files, no middleware          components/files/, components/<name>/files/
#   bw_component   adapts an algorithm to topics                  components/<name>/adaptor/, components/messages/
#   bw_tool        benches, experiments, training; no middleware  components/lab/, components/program/
#   bw_verb        a verb of `bandwagon` or `bandwagon-lab`       components/program/, components/lab/, runtime/cli/
#   bw_test        one GoogleTest program, one to three CTest entries   tests/

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

# A test's own code is compiled in two thirds of the time so. What it tests is in libraries, which are as they are released; of inline functions
# that both hold, the linker takes either.
add_library(bw_test_options INTERFACE)
target_compile_options(bw_test_options INTERFACE $<$<CONFIG:Release>:-Og>)

# GCC tidies its own memory while it compiles; later is 5 % of the time, and up to 1.3 GB for each compiler.
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=600000>)

# Sources of a target are compiled by sixteens: what they include is read once. Names of one target's sources must differ. Who edits much
# may prefer each by itself.
option(BANDWAGON_UNITY "Compile several sources at once" ON)
set(CMAKE_UNITY_BUILD ${BANDWAGON_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
if(BANDWAGON_UNITY)
  # Then no source is the main one, a component may have options of its source's own, and what is local may hide what is another source's.
  target_compile_options(bw_compile_options INTERFACE -Wno-subobject-linkage -Wno-shadow -Wshadow=local)
endif()

# What moves the base, or decides that it must not move: checked containers (_GLIBCXX_ASSERTIONS) in release builds too. A wrong index or an
# optional without a value then ends the process and says where, in place of driving by whatever is found there. The macro changes no
# layout, so that these mix with targets without it; functions that the compiler does not inline may come from
# those. To measure what it costs, -DBANDWAGON_CHECKED= builds without.
if(NOT DEFINED BANDWAGON_CHECKED)
  set(BANDWAGON_CHECKED
    bandwagon_runtime bw_lifecycle bw_serial bw_tty bw_model bw_laser bw_safety bw_twist_mux bw_motor_control bw_robot_base bw_base_drivers
    bw_component_laser bw_component_collision_monitor bw_component_twist_mux bw_component_motor_control bw_component_robot_base)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/precompiled.cmake)

# A library bw_<name> that knows no middleware; static unless SHARED.
macro(bw_plain_library name precompiled)
  cmake_parse_arguments(ARG "SHARED" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  if(ARG_SHARED)
    add_library(bw_${name} SHARED ${ARG_SOURCES})
    set_target_properties(bw_${name} PROPERTIES OUTPUT_NAME bandwagon_${name})
  else()
    add_library(bw_${name} STATIC ${ARG_SOURCES})
  endif()
  target_link_libraries(bw_${name}
    PRIVATE $<BUILD_INTERFACE:bw_compile_options> ${ARG_PRIVATE}
    PUBLIC Eigen3::Eigen ${ARG_LINK})
  target_include_directories(bw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(bw_${name} PUBLIC cxx_std_20)  # of its headers, for projects outside
  bw_precompiled(bw_${name} ${precompiled})
endmacro()

# bw_algorithm(<name> [SHARED] SOURCES ... [LINK ...] [PRIVATE ...]): library bw_<name>, plain C++ and Eigen (and what it links).
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

# bw_verb(<name> [LAB] SOURCES ... [LINK ...]): of the program `bandwagon`, or with LAB of `bandwagon-lab`, which no robot needs; registers
# itself with BW_VERB.
function(bw_verb name)
  if(BANDWAGON_ALGORITHMS_ONLY)
    return()
  endif()
  cmake_parse_arguments(VERB "LAB" "" "" ${ARGN})
  bw_part_of_program(bw_verb_${name} component ${VERB_UNPARSED_ARGUMENTS})
  target_link_libraries(bw_verb_${name} PUBLIC bw_cli)
  if(VERB_LAB)
    set_property(GLOBAL APPEND PROPERTY BANDWAGON_LAB_VERBS bw_verb_${name})
  else()
    set_property(GLOBAL APPEND PROPERTY BANDWAGON_VERBS bw_verb_${name})
  endif()
endfunction()

# bw_test(<name> SOURCES ... [ALONE ...] [LINK ...] [RECORDED <filter>] [SHORTFALL <filter>] [NOTHING_ELSE]): one GoogleTest program. A
# program takes a DDS domain that nobody is on (tests/test_environment.hpp), and never leaves loopback; what is no such program gets one as
# `in_test_environment COMMAND...`. Sources after ALONE have names of other sources, and are compiled each by itself. The filters name tests as --gtest_filter does, and make entries of their own:
#
#   RECORDED   tests that need recorded data: entry <name>_recorded, label `recorded`, shown as skipped where the data are not at hand
#   SHORTFALL  tests whose limits lie below what was asked: entry <name>_shortfall, label `shortfall`; they print asked and reached
#
# A test that both name is one of the shortfalls. NOTHING_ELSE: the program has no other tests, and no entry <name>.
function(bw_test name)
  cmake_parse_arguments(ARG "NOTHING_ELSE" "RECORDED;SHORTFALL" "SOURCES;ALONE;LINK" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES} ${ARG_ALONE})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(test_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 8)  # sources of tests share more names
  target_link_libraries(test_${name} PRIVATE bw_compile_options bw_test_options ${ARG_LINK} bw_test_main)
  target_compile_definitions(test_${name} PRIVATE BANDWAGON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(ARG_LINK MATCHES "bandwagon_runtime|bw_component_")
    bw_precompiled(test_${name} test_component)
  else()
    bw_precompiled(test_${name} test)
  endif()
  set(elsewhere ${ARG_RECORDED} ${ARG_SHORTFALL})
  list(JOIN elsewhere ":" elsewhere)
  if(elsewhere)
    set(elsewhere --gtest_filter=-${elsewhere})
  endif()
  set(entries)
  if(NOT ARG_NOTHING_ELSE)
    add_test(NAME ${name} COMMAND test_${name} ${elsewhere})
    list(APPEND entries ${name})
  endif()
  if(ARG_RECORDED)
    string(REGEX REPLACE "-$" "" filter "${ARG_RECORDED}-${ARG_SHORTFALL}")
    add_test(NAME ${name}_recorded COMMAND test_${name} --gtest_filter=${filter})
    set_tests_properties(${name}_recorded PROPERTIES LABELS recorded SKIP_RETURN_CODE 77)
    list(APPEND entries ${name}_recorded)
  endif()
  if(ARG_SHORTFALL)
    add_test(NAME ${name}_shortfall COMMAND test_${name} --gtest_filter=${ARG_SHORTFALL})
    set_tests_properties(${name}_shortfall PROPERTIES LABELS shortfall SKIP_RETURN_CODE 77)
    list(APPEND entries ${name}_shortfall)
  endif()
  set_tests_properties(${entries} PROPERTIES TIMEOUT 600)
endfunction()
