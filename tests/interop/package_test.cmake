# cmake -DBUILD= -DPROJECT= -DREADME= -DSTAGE= -P package_test.cmake
# What a user of the package does: installs it, builds a component of their own against it, and runs both together.
function(run what)
  execute_process(COMMAND ${ARGN} TIMEOUT 240 RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status STREQUAL "0")
    message(FATAL_ERROR "${what} failed (${status}):\n${out}")
  endif()
endfunction()

file(REMOVE_RECURSE ${STAGE})
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${STAGE}/first)
file(RENAME ${STAGE}/first ${STAGE}/prefix)  # an installed tree may move
file(COPY ${PROJECT} DESTINATION ${STAGE})
get_filename_component(name ${PROJECT} NAME)
set(project ${STAGE}/${name})
run("configuring" ${CMAKE_COMMAND} -S ${project} -B ${project}/build -DCMAKE_PREFIX_PATH=${STAGE}/prefix
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror")
run("building" ${CMAKE_COMMAND} --build ${project}/build)

foreach(attempt 1 2)
  run("running" ${STAGE}/prefix/bin/bandwagon run ${project}/graph.yaml --clock lockstep --for 1 --json ${STAGE}/run.json)
  file(READ ${STAGE}/run.json json)
  string(JSON hash_${attempt} GET ${json} samples_sha256)
endforeach()
if(NOT hash_1 STREQUAL hash_2)
  message(FATAL_ERROR "two runs of one seed differ: ${hash_1} ${hash_2}")
endif()

# The laser speaks at 10 Hz: the component heard it, and motor_control heard the component.
string(JSON last LENGTH ${json} callbacks)
math(EXPR last "${last} - 1")
foreach(wanted "wanderer scan" "motor_control cmd_vel")
  set(count 0)
  foreach(i RANGE ${last})
    string(JSON component GET ${json} callbacks ${i} component)
    string(JSON callback GET ${json} callbacks ${i} callback)
    if("${component} ${callback}" STREQUAL wanted)
      string(JSON count GET ${json} callbacks ${i} count)
    endif()
  endforeach()
  if(count LESS 9)
    message(FATAL_ERROR "${wanted}: called ${count} times in a second, expected 9 to 10:\n${json}")
  endif()
endforeach()

# README.md shows this component, and nothing that was not built here.
if(EXISTS ${README})
  file(READ ${README} readme)
  file(READ ${PROJECT}/wanderer.cpp source)
  string(FIND "${readme}" "${source}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "README.md must show ${PROJECT}/wanderer.cpp letter by letter")
  endif()
endif()
