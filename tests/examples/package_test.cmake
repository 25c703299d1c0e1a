# cmake -DBUILD= -DPROJECT= -DSTAGE= -P package_test.cmake
# What a user of the package does: installs it, builds a component, a planner and a driver of their own against it, and runs them together.
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
run("configuring" ${CMAKE_COMMAND} -G Ninja -S ${project} -B ${project}/build -DCMAKE_PREFIX_PATH=${STAGE}/prefix
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror")
run("building" ${CMAKE_COMMAND} --build ${project}/build)

foreach(attempt 1 2)
  run("running" ${STAGE}/prefix/bin/bandwagon run ${project}/component/graph.yaml --clock lockstep --for 1 --json ${STAGE}/run.json)
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

# What was installed drives from any folder.
run("the demo" ${STAGE}/prefix/bin/bandwagon demo --no-page --pace 0 --out ${STAGE}/demo)
if(NOT EXISTS ${STAGE}/demo/drive.mcap)
  message(FATAL_ERROR "the demo has recorded nothing")
endif()

# The planner drives the robot through the hallway with its boxes and people (42 s; status 0 means reached), and its name is on the
# score card.
set(graphs ${STAGE}/prefix/share/bandwagon/config/graphs)
file(READ ${graphs}/hallway.yaml hallway)
file(WRITE ${graphs}/hallway_by_pure_pursuit.yaml "plugins: [${project}/build/libpure_pursuit.so]\n${hallway}")
set(with_planner ${graphs}/hallway_by_pure_pursuit.yaml --set local_planner.algorithm=pure_pursuit)
run("driving by the planner" ${STAGE}/prefix/bin/bandwagon run ${with_planner} --set local_planner.pure_pursuit.lookahead=1.5
  --clock lockstep --seed 7 --for 120 --json ${STAGE}/drive.json)
file(READ ${STAGE}/drive.json json)
string(JSON planner GET "${json}" planner name)
string(JSON cycles GET "${json}" planner cycles)
string(JSON reached GET "${json}" reached)
if(NOT planner STREQUAL "pure_pursuit" OR cycles LESS 200 OR NOT reached)
  message(FATAL_ERROR "reached ${reached} by ${planner} in ${cycles} cycles, expected pure_pursuit in more than 20 s at 10 Hz")
endif()

# So do those that are processes of their own; the one in Python as it was installed, where there are its tools.
set(processes ${project}/build/follower)
find_program(IDLC idlc)
if(IDLC)
  list(APPEND processes ${STAGE}/prefix/share/bandwagon/examples/planner_process/follower.py)
endif()
foreach(process ${processes})
  run("driving by ${process}" ${CMAKE_COMMAND} -E env XDG_CACHE_HOME=${STAGE}/cache
    ${STAGE}/prefix/bin/bandwagon run ${graphs}/hallway.yaml --set local_planner.algorithm=${process} --clock lockstep --seed 7 --for 120)
endforeach()

# The planner's parameters are listed and read as strictly as all others.
execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon param list ${with_planner} local_planner OUTPUT_VARIABLE listed)
if(NOT listed MATCHES "pure_pursuit\\.lookahead \\(double, m; 0\\.2 to 10; default 1\\.0\\): aims at the plan this far ahead")
  message(FATAL_ERROR "param list does not show the planner's own parameters:\n${listed}")
endif()
execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon param list ${with_planner} --set local_planner.pure_pursuit.lookahed=1
  ERROR_VARIABLE refused OUTPUT_VARIABLE refused RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT refused MATCHES "local_planner\\.pure_pursuit\\.lookahed: unknown key; did you mean 'lookahead'")
  message(FATAL_ERROR "a mistyped parameter of the planner is not refused:\n${refused}")
endif()

# The driver drives the same way: its bytes go through a cable to its board, which turns the wheels of the world.
string(REPLACE "\ncomponents:\n" "\ncomponents:\n  trolley_board: {manager: none, process: world+base, lane: base}\n" on_trolley "${hallway}")
file(WRITE ${graphs}/hallway_on_trolley.yaml "plugins: [${project}/build/libtrolley.so, ${project}/build/libtrolley_board.so]\n${on_trolley}")
set(with_driver ${graphs}/hallway_on_trolley.yaml --set robot.base.driver=trolley --set robot.base.port=emulator)
run("driving by the driver" ${STAGE}/prefix/bin/bandwagon run ${with_driver} --set robot.base.answer_time=0.15
  --clock lockstep --seed 7 --for 120 --json ${STAGE}/trolley.json)
file(READ ${STAGE}/trolley.json json)
string(JSON reached GET "${json}" reached)
if(NOT reached)
  message(FATAL_ERROR "the driver's robot did not reach the goal:\n${json}")
endif()

# Its section of the robot file is read as strictly.
function(refused_with what expected)
  execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon param list ${ARGN} ERROR_VARIABLE said OUTPUT_VARIABLE said RESULT_VARIABLE status)
  if(status EQUAL 0 OR NOT said MATCHES "${expected}")
    message(FATAL_ERROR "${what} is not refused by \"${expected}\":\n${said}")
  endif()
endfunction()
refused_with("a mistyped parameter of the driver" "robot\\.base\\.answer_tme: unknown key; did you mean 'answer_time'"
  ${with_driver} --set robot.base.answer_tme=0.1)
refused_with("a parameter out of range" "robot\\.base\\.answer_time = 7: must be between 0\\.05 and 1 s" ${with_driver} --set robot.base.answer_time=7)
refused_with("a driver that nobody has" "robot\\.base\\.driver = troley: unknown driver.*did you mean 'trolley'"
  ${graphs}/hallway_on_trolley.yaml --set robot.base.driver=troley)

# A robot at boot: its file, its options and systemd's link, below another root; and systemd finds nothing wrong with the unit.
file(MAKE_DIRECTORY ${STAGE}/root ${STAGE}/maps)
file(WRITE ${STAGE}/maps/room.pgm "P2\n2 2\n255\n254 254 254 254\n")
file(WRITE ${STAGE}/maps/room.yaml "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n")
file(COPY_FILE ${STAGE}/maps/room.yaml ${STAGE}/maps/room_keepout.yaml)
run("enabling a robot" ${STAGE}/prefix/bin/bandwagon enable kobuki --map ${STAGE}/maps/room.yaml --root ${STAGE}/root)
file(READ ${STAGE}/root/etc/bandwagon/kobuki.options options)
if(NOT options MATCHES "BANDWAGON_OPTIONS=--set map_server.map=${STAGE}/maps/room.yaml --set keepout_filter_mask_server.map=${STAGE}/maps/room_keepout.yaml")
  message(FATAL_ERROR "the robot's options lack the map, or its keep-out zones:\n${options}")
endif()
if(NOT EXISTS ${STAGE}/root/etc/bandwagon/robots/kobuki.yaml OR
   NOT IS_SYMLINK ${STAGE}/root/etc/systemd/system/multi-user.target.wants/bandwagon@kobuki.service)
  message(FATAL_ERROR "enable has written no robot file, or no link")
endif()
file(MAKE_DIRECTORY "${STAGE}/my maps")
file(COPY ${STAGE}/maps/ DESTINATION "${STAGE}/my maps")
execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon enable kobuki --map "${STAGE}/my maps/room.yaml" --root ${STAGE}/root
  ERROR_VARIABLE refused OUTPUT_VARIABLE refused RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT refused MATCHES "blanks")
  message(FATAL_ERROR "a map that systemd would take apart is not refused (${status}):\n${refused}")
endif()
execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon enable jackal --root ${STAGE}/root ERROR_VARIABLE refused OUTPUT_VARIABLE refused RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT refused MATCHES "jackal.yaml: base.driver names no driver")
  message(FATAL_ERROR "a robot without a driver is not refused (${status}):\n${refused}")
endif()
run("enabling it again" ${STAGE}/prefix/bin/bandwagon enable kobuki --root ${STAGE}/root)
file(APPEND ${STAGE}/root/etc/bandwagon/robots/kobuki.yaml "# mine\n")
execute_process(COMMAND ${STAGE}/prefix/bin/bandwagon enable kobuki --root ${STAGE}/root ERROR_VARIABLE refused OUTPUT_VARIABLE refused RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT refused MATCHES "exists already and differs")
  message(FATAL_ERROR "a robot file that was changed is not kept (${status}):\n${refused}")
endif()
find_program(SYSTEMD_ANALYZE systemd-analyze)
if(SYSTEMD_ANALYZE)
  file(READ ${STAGE}/prefix/lib/systemd/system/bandwagon@.service unit)
  string(REGEX REPLACE "ExecStart=[^ ]*" "ExecStart=${STAGE}/prefix/bin/bandwagon" unit "${unit}")
  file(WRITE ${STAGE}/unit/bandwagon@kobuki.service "${unit}")
  execute_process(COMMAND ${SYSTEMD_ANALYZE} verify --man=no ${STAGE}/unit/bandwagon@kobuki.service OUTPUT_VARIABLE found ERROR_VARIABLE found RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR found MATCHES "bandwagon@")
    message(FATAL_ERROR "systemd-analyze verify (${status}):\n${found}")
  endif()
endif()
