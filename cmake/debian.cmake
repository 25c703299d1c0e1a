# The Debian packages, by CPack: bandwagon, bandwagon-lab, bandwagon-dev and bandwagon-ros2-msgs. launch_scripts/package.sh makes them, on each
# Debian for itself. What only a package holds: udev rules, manual pages, changelog, and robot files in /etc, where a
# change of the user's outlives an upgrade.
option(BANDWAGON_DEBIAN "Install what only a Debian package holds" OFF)
if(NOT BANDWAGON_DEBIAN)
  return()
endif()
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "BANDWAGON_DEBIAN needs CMAKE_INSTALL_PREFIX=/usr")
endif()
set(BANDWAGON_PACKAGE_VERSION ${PROJECT_VERSION} CACHE STRING "Version of the Debian packages")
set(debian ${PROJECT_SOURCE_DIR}/cmake/debian)
set(doc ${CMAKE_INSTALL_DATADIR}/doc)

# /usr/share/bandwagon/config/robots leads to where the robot files are.
file(CREATE_LINK /etc/bandwagon/robots ${CMAKE_BINARY_DIR}/robots SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/robots DESTINATION ${data}/config COMPONENT program)
file(GLOB robots CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/config/robots config/robots/*.yaml)
set(conffiles "")
foreach(robot IN LISTS robots)
  install(FILES config/robots/${robot} DESTINATION /etc/bandwagon/robots COMPONENT program)
  string(APPEND conffiles "/etc/bandwagon/robots/${robot}\n")
endforeach()
file(WRITE ${CMAKE_BINARY_DIR}/debian/conffiles "${conffiles}")
install(FILES config/udev/99-bandwagon.rules DESTINATION lib/udev/rules.d RENAME 60-bandwagon.rules COMPONENT program)

# Manual pages by the programs' own --help.
find_program(HELP2MAN help2man REQUIRED)
add_custom_target(bandwagon_documents)
foreach(program bandwagon bandwagon-lab)
  set(pages ${CMAKE_BINARY_DIR}/man/${program})
  add_custom_command(OUTPUT ${pages}/done
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
    COMMAND ${debian}/manual_pages.sh ${pages} ${program} ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>
    COMMAND ${CMAKE_COMMAND} -E touch ${pages}/done
    DEPENDS ${program} ${debian}/manual_pages.sh VERBATIM)
  add_custom_target(${program}_manual DEPENDS ${pages}/done)
  if(program STREQUAL bandwagon OR NOT CMAKE_CROSSCOMPILING)  # another machine's lab is not built
    add_dependencies(bandwagon_documents ${program}_manual)
  endif()
endforeach()
install(DIRECTORY ${CMAKE_BINARY_DIR}/man/bandwagon/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program FILES_MATCHING PATTERN "*.1.gz")
install(DIRECTORY ${CMAKE_BINARY_DIR}/man/bandwagon-lab/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT lab FILES_MATCHING PATTERN "*.1.gz")

# Our messages as a package of ROS 2, to be built with colcon.
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/ros2/bandwagon_msgs/package.xml
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_BINARY_DIR}/ros2
  COMMAND ${BANDWAGON_IDL_COMPILER} --ros2-package ${PROJECT_SOURCE_DIR}/idl ${CMAKE_BINARY_DIR}/ros2 bandwagon_msgs
  DEPENDS ${BANDWAGON_IDL_COMPILER} VERBATIM)
add_custom_target(bandwagon_ros2_msgs DEPENDS ${CMAKE_BINARY_DIR}/ros2/bandwagon_msgs/package.xml)
add_dependencies(bandwagon_documents bandwagon_ros2_msgs)
install(DIRECTORY ${CMAKE_BINARY_DIR}/ros2/bandwagon_msgs DESTINATION ${data}/ros2 COMPONENT ros2-msgs)

# What policy asks of every package: changelog and licence.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH where it is set
file(WRITE ${CMAKE_BINARY_DIR}/debian/changelog
  "bandwagon (${BANDWAGON_PACKAGE_VERSION}) unstable; urgency=medium\n\n  * What is new: CHANGELOG.md beside this file.\n\n -- ${BANDWAGON_MAINTAINER} <${BANDWAGON_CONTACT}>  ${now}\n")
file(WRITE ${CMAKE_BINARY_DIR}/debian/copyright
  "Copyright (C) 2026 ${BANDWAGON_MAINTAINER} <${BANDWAGON_CONTACT}>\n\nBandwagon is under the Apache License, Version 2.0.\nOn Debian systems its text is in /usr/share/common-licenses/Apache-2.0.\n")
execute_process(COMMAND gzip -9nc ${CMAKE_BINARY_DIR}/debian/changelog OUTPUT_FILE ${CMAKE_BINARY_DIR}/debian/changelog.gz)
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${CMAKE_BINARY_DIR}/debian/CHANGELOG.md.gz)
foreach(component program lab dev ros2-msgs)
  set(name bandwagon-${component})
  string(REPLACE -program "" name ${name})
  install(FILES ${CMAKE_BINARY_DIR}/debian/copyright ${CMAKE_BINARY_DIR}/debian/changelog.gz
    DESTINATION ${doc}/${name} COMPONENT ${component})
  if(EXISTS ${debian}/${name}.lintian-overrides)
    install(FILES ${debian}/${name}.lintian-overrides DESTINATION share/lintian/overrides RENAME ${name} COMPONENT ${component})
  endif()
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/debian/CHANGELOG.md.gz config/robots/README.md DESTINATION ${doc}/bandwagon COMPONENT program)

set(CPACK_GENERATOR DEB)
set(CPACK_SET_DESTDIR ON)  # robot files go to /etc
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program lab dev ros2-msgs)
if(CMAKE_CROSSCOMPILING)
  set(CPACK_COMPONENTS_ALL program dev)
endif()
set(CPACK_PACKAGE_NAME bandwagon)
set(CPACK_PACKAGE_CONTACT "${BANDWAGON_MAINTAINER} <${BANDWAGON_CONTACT}>")
set(CPACK_PACKAGE_VERSION ${BANDWAGON_PACKAGE_VERSION})
set(CPACK_DEBIAN_PACKAGE_VERSION ${BANDWAGON_PACKAGE_VERSION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME bandwagon)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA
  ${CMAKE_BINARY_DIR}/debian/conffiles ${debian}/postinst ${debian}/prerm ${debian}/postrm)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "navigation stack for wheeled robots among people
Localization, people tracking and prediction, global planning, and local
planning by timed elastic bands that anticipate where people will be. It
speaks ROS 2 on the wire, with no ROS installed, and brings a page to watch
and to command a robot. Try it: bandwagon demo")
set(CPACK_DEBIAN_LAB_PACKAGE_NAME bandwagon-lab)
set(CPACK_DEBIAN_LAB_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LAB_PACKAGE_DEPENDS "bandwagon (= ${BANDWAGON_PACKAGE_VERSION})")
set(CPACK_DEBIAN_LAB_PACKAGE_SECTION science)
set(CPACK_DEBIAN_LAB_DESCRIPTION "benchmarks of local planners and people trackers
Compares planners of bandwagon over suites, generated crowds and recordings,
regenerates published tables, and imports logs of other systems.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME bandwagon-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "bandwagon (= ${BANDWAGON_PACKAGE_VERSION}), libeigen3-dev, libfmt-dev, libyaml-cpp-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "cmake, g++")
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_DESCRIPTION "components, planners and drivers of one's own for bandwagon
Headers, CMake package, message definitions and examples.")
set(CPACK_DEBIAN_ROS2-MSGS_PACKAGE_NAME bandwagon-ros2-msgs)
set(CPACK_DEBIAN_ROS2-MSGS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_ROS2-MSGS_DESCRIPTION "messages of bandwagon as a source package of ROS 2
To be built with colcon, so that the tools of ROS 2 know their types.")
include(CPack)
