# What is installed, in three parts, each a Debian package too (cmake/debian.cmake): `program` (what a robot runs), `lab`, and `dev`:
# find_package(bandwagon) gives bandwagon::runtime (all that a component links), bandwagon::local_planner (all that a planner links),
# bandwagon::robot_base (all that a driver links), bandwagon::program, bandwagon_add_component(), bandwagon_add_planner() and
# bandwagon_add_driver().
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/bandwagon)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/bandwagon)
set(libraries ${CMAKE_INSTALL_LIBDIR}/bandwagon)  # a folder of their own: nobody else finds them by name
set(data ${CMAKE_INSTALL_DATADIR}/bandwagon)

# target and its name outside
set(exported bandwagon_runtime runtime bandwagon_idl idl bw_graph graph bw_lifecycle lifecycle bw_parameters parameters bw_wire wire bw_model model
  bw_local_planner local_planner bw_robot_base robot_base
  bandwagon program bandwagon_port_guardian port_guardian)
while(exported)
  list(POP_FRONT exported target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT bandwagon
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program
    LIBRARY DESTINATION ${libraries} COMPONENT program
    ARCHIVE DESTINATION ${libraries} COMPONENT dev)
  if(NOT target MATCHES "^bandwagon(_port_guardian)?$")
    target_include_directories(${target} SYSTEM INTERFACE $<INSTALL_INTERFACE:${headers}> $<INSTALL_INTERFACE:${headers}/idl>)
  endif()
endwhile()
install(TARGETS bandwagon-lab RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lab OPTIONAL)  # where it was built
set_target_properties(bandwagon_runtime bandwagon_idl bw_local_planner bw_robot_base PROPERTIES INSTALL_RPATH $ORIGIN)
file(RELATIVE_PATH from_program /${CMAKE_INSTALL_BINDIR} /${libraries})
set_target_properties(bandwagon bandwagon-lab PROPERTIES INSTALL_RPATH $ORIGIN/${from_program})

# What a component and its tests include; Fast DDS stays inside.
install(DIRECTORY runtime DESTINATION ${headers} COMPONENT dev FILES_MATCHING PATTERN "*.hpp"
  PATTERN cli EXCLUDE REGEX "/dds/(discovery_listener|fast_[a-z]+|loopback_sockets|raw_type)\\.hpp$" EXCLUDE)
install(DIRECTORY components/model components/messages DESTINATION ${headers}/components COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
# What a planner of another project includes: the registry, and what every planner shares.
file(GLOB shared_by_planners CONFIGURE_DEPENDS components/local_planner/*.hpp)
list(FILTER shared_by_planners EXCLUDE REGEX "/local_planner_parameters\\.hpp$")
install(FILES ${shared_by_planners} DESTINATION ${headers}/components/local_planner COMPONENT dev)
# What a driver of another project includes.
install(FILES components/robot_base/driver.hpp components/robot_base/driver_registry.hpp components/robot_base/readings.hpp
  components/robot_base/encoder_odometry.hpp DESTINATION ${headers}/components/robot_base COMPONENT dev)
install(DIRECTORY ${CMAKE_BINARY_DIR}/idl/ DESTINATION ${headers}/idl COMPONENT dev
  FILES_MATCHING REGEX "/(msg|srv|action)/[A-Za-z0-9_]+\\.hpp$" PATTERN CMakeFiles EXCLUDE PATTERN compiler EXCLUDE)
install(DIRECTORY idl/ DESTINATION ${data}/idl COMPONENT dev FILES_MATCHING PATTERN "*.idl" PATTERN compiler EXCLUDE)
# Graphs, robots and imports for the robot's program, suites for the lab's.
set(elsewhere PATTERN suites EXCLUDE)
if(BANDWAGON_DEBIAN)
  list(APPEND elsewhere PATTERN robots EXCLUDE PATTERN udev EXCLUDE)
endif()
install(DIRECTORY config DESTINATION ${data} COMPONENT program ${elsewhere})
install(DIRECTORY config/suites config/planners DESTINATION ${data}/config COMPONENT lab)

install(EXPORT bandwagon NAMESPACE bandwagon:: FILE bandwagonTargets.cmake DESTINATION ${package} COMPONENT dev)
configure_package_config_file(cmake/bandwagonConfig.cmake.in ${CMAKE_BINARY_DIR}/bandwagonConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/bandwagonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/bandwagonConfig.cmake ${CMAKE_BINARY_DIR}/bandwagonConfigVersion.cmake
  DESTINATION ${package} COMPONENT dev)
# A colcon workspace knows the package by these, without ament in the tree.
configure_file(cmake/package.xml.in ${CMAKE_BINARY_DIR}/package.xml @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/package.xml DESTINATION ${data} COMPONENT dev)
file(WRITE ${CMAKE_BINARY_DIR}/ament_index/bandwagon "")
install(FILES ${CMAKE_BINARY_DIR}/ament_index/bandwagon
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ament_index/resource_index/packages COMPONENT dev)
install(DIRECTORY tests/examples DESTINATION ${data} COMPONENT dev USE_SOURCE_PERMISSIONS PATTERN package_test.cmake EXCLUDE
  PATTERN __pycache__ EXCLUDE)

# A robot at boot: `bandwagon enable`.
configure_file(cmake/bandwagon@.service.in ${CMAKE_BINARY_DIR}/bandwagon@.service @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/bandwagon@.service DESTINATION lib/systemd/system COMPONENT program)

# A shell finds completion by the program's name.
install(FILES runtime/cli/completion/bandwagon DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES runtime/cli/completion/_bandwagon DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
