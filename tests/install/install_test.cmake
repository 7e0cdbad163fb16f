# SPDX-License-Identifier: Apache-2.0
# Called by CTest: install, configure and build the consumer, run it and the installed program.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(failed)
    message(FATAL_ERROR "${ARGN}\nended with ${failed}:\n${out}")
  endif()
  set(printed "${out}" PARENT_SCOPE)
endfunction()

set(prefix "${SCRATCH}/prefix")
file(REMOVE_RECURSE "${prefix}" "${SCRATCH}/consumer")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${SCRATCH}/consumer" -G Ninja
    -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_PREFIX_PATH=${prefix}")
run("${CMAKE_COMMAND}" --build "${SCRATCH}/consumer")
run("${SCRATCH}/consumer/consumer" "${ROBOT}")
if(NOT printed MATCHES "puppy: 20 design parameters, 4 feet, trot lifts 2 at a time")
  message(FATAL_ERROR "the consumer printed: ${printed}")
endif()
run("${prefix}/bin/legwright" doctor)
if(NOT printed MATCHES "plugin +${prefix}/bin/mujoco_plugin/liblegwright.so, loadable")
  message(FATAL_ERROR "the installed program does not find its own plugin: ${printed}")
endif()
