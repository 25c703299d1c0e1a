# cmake -DFASTDDSGEN= -DROOT= -DOUT= -DSCRATCH= -DNAMES=<package>/msg/<Name>;... -P generate.cmake
# fastddsgen writes all files of a run, those of included packages too, into one folder: we keep the ones asked for.
# Its preprocessed files have fixed names, so that parallel runs need a folder each.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/preprocessed)
list(TRANSFORM NAMES APPEND .idl OUTPUT_VARIABLE files)
set(ENV{JAVA_TOOL_OPTIONS} "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC")  # short runs: half the CPU time
execute_process(COMMAND ${FASTDDSGEN} -typeros2 -cs -replace -I . -d ${SCRATCH}
    -t ${SCRATCH}/preprocessed ${files}
  WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE status)
# It reports a bad file but exits with success, or the other way round.
if(NOT status EQUAL 0 OR log MATCHES "error:")
  message(FATAL_ERROR "fastddsgen failed:\n${log}")
endif()
foreach(name IN LISTS NAMES)
  get_filename_component(folder ${name} DIRECTORY)
  get_filename_component(stem ${name} NAME)
  foreach(extension h cxx)
    if(NOT EXISTS ${SCRATCH}/${stem}.${extension})
      message(FATAL_ERROR "fastddsgen made no ${stem}.${extension}:\n${log}")
    endif()
    file(MAKE_DIRECTORY ${OUT}/${folder})
    file(COPY_FILE ${SCRATCH}/${stem}.${extension} ${OUT}/${folder}/${stem}.${extension})
  endforeach()
endforeach()
file(REMOVE_RECURSE ${SCRATCH})
