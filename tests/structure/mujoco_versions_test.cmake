# SPDX-License-Identifier: Apache-2.0
# Called by CTest with -DTABLE=cmake/MujocoVersions.cmake: each release has all its rows, the number
# of its headers is that of its name, and a version without rows is refused with what there is.
cmake_minimum_required(VERSION 3.25)
if(DEFINED ASKED)  # a child, to be refused
  set(LEGWRIGHT_MUJOCO_VERSION "${ASKED}" CACHE STRING "")
  include("${TABLE}")
  return()
endif()

include("${TABLE}")
foreach(version IN LISTS LEGWRIGHT_MUJOCO_VERSIONS)
  set(rows "legwright_mujoco_${version}")
  foreach(archive wheel sdist)
    if(NOT "${${rows}_${archive}_sha256}" MATCHES "^[0-9a-f]+$")
      message(SEND_ERROR "MuJoCo ${version}: no SHA-256 of its ${archive}")
    endif()
    string(LENGTH "${${rows}_${archive}_sha256}" length)
    string(REPLACE "-" "_" stem "${${rows}_package}-")
    string(REGEX REPLACE "_$" "-" stem "${stem}")
    string(FIND "${${rows}_${archive}}" "${stem}${version}" start)
    if(NOT length EQUAL 64 OR NOT start EQUAL 0)
      message(SEND_ERROR "MuJoCo ${version}: ${archive} ${${rows}_${archive}}, SHA-256 of ${length} digits")
    endif()
  endforeach()
  string(REPLACE "." ";" parts "${version}")
  list(GET parts 0 major)
  list(GET parts 1 minor)
  list(GET parts 2 patch)
  math(EXPR number "1000000 * ${major} + 1000 * ${minor} + ${patch}")
  if(NOT "${${rows}_header}" EQUAL number OR NOT "${${rows}_viewer}" MATCHES "^mujoco")
    message(SEND_ERROR "MuJoCo ${version}: header ${${rows}_header}, viewer '${${rows}_viewer}'")
  endif()
endforeach()

execute_process(COMMAND "${CMAKE_COMMAND}" -DASKED=3.9.9 "-DTABLE=${TABLE}"
                        -P "${CMAKE_CURRENT_LIST_FILE}"
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
string(REGEX REPLACE "[ \n]+" " " said "${said}")
if(NOT failed OR NOT said MATCHES "asks for MuJoCo '3.9.9', expected one of .*3.17.0.*Versions.cmake")
  message(SEND_ERROR "An unknown version was answered by ${failed}: ${said}")
endif()
