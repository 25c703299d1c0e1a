# The four kinds of target of this project. An algorithm knows no middleware; a component adapts it to topics.

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

# bw_algorithm(<name> SOURCES ... [LINK ...]): library bw_<name>, plain C++ and Eigen (and what it links).
function(bw_algorithm name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(bw_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(bw_${name} PRIVATE $<BUILD_INTERFACE:bw_compile_options> PUBLIC Eigen3::Eigen ${ARG_LINK})
  target_include_directories(bw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  set_property(GLOBAL APPEND PROPERTY BANDWAGON_ALGORITHMS bw_${name})
endfunction()

# bw_component(<name> SOURCES ... [LINK ...]): adaptor, linked into the program `bandwagon`.
function(bw_component name)
  if(BANDWAGON_ALGORITHMS_ONLY)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(bw_component_${name} OBJECT ${ARG_SOURCES})
  target_link_libraries(bw_component_${name} PRIVATE bw_compile_options PUBLIC bandwagon_runtime ${ARG_LINK})
  set_property(GLOBAL APPEND PROPERTY BANDWAGON_COMPONENTS bw_component_${name})
endfunction()

# bw_test(<name> SOURCES ... [LINK ...] [DOMAIN <id>]): one GoogleTest program, one CTest entry. A test that uses DDS names a domain id
# of its own; it never leaves loopback.
function(bw_test name)
  cmake_parse_arguments(ARG "" "DOMAIN" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE bw_compile_options ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_compile_definitions(test_${name} PRIVATE BANDWAGON_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
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
