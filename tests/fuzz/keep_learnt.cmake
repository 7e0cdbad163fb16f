# SPDX-License-Identifier: Apache-2.0
# Packs the fewest inputs that reach all that a fuzz target has reached by now into LEARNT.
set(fewest "${KEPT}/fewest")
file(REMOVE_RECURSE "${fewest}")
file(MAKE_DIRECTORY "${fewest}")
execute_process(
  COMMAND "${PROGRAM}" -set_cover_merge=1 -max_len=${LONGEST} -rss_limit_mb=4096 "${fewest}"
          "${STORED}" "${KEPT}/learnt" "${KEPT}/corpus" "${KEPT}/seeds"
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB inputs RELATIVE "${fewest}" "${fewest}/*")
if(NOT inputs)
  message(FATAL_ERROR "${PROGRAM} reaches nothing: ${LEARNT} stays as it is")
endif()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E tar cJf "${KEPT}/learnt.tar.xz" --mtime=2000-01-01 -- ${inputs}
  WORKING_DIRECTORY "${fewest}" COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE "${KEPT}/learnt.tar.xz" "${LEARNT}.new")
file(RENAME "${LEARNT}.new" "${LEARNT}")
