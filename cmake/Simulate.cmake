# SPDX-License-Identifier: Apache-2.0
# MuJoCo's own viewer, unpatched, from PyPI's sdist of LEGWRIGHT_MUJOCO_VERSION. Defines the library mujoco_simulate (its
# window, for programs of ours) and the program bin/simulate, which finds our plugin in bin/mujoco_plugin/. Without
# GLFW or the sources neither is there; a status line says what to do, and the rest builds.
set(LEGWRIGHT_MUJOCO_SOURCE "" CACHE PATH
    "Unpacked MuJoCo sdist of that version (skips the download)")

# Downloads and unpacks into `destination`, which appears whole; other build trees may do the same at the same time.
# pip asks an sdist for its metadata by running its setup.py. With the hash in the requirement it refuses an archive
# that is not the pinned one before it runs anything of it.
function(legwright_download_mujoco_sdist version destination)
  legwright_find_pip(python)
  set(package "${legwright_mujoco_${version}_package}")
  set(hash "${legwright_mujoco_${version}_sdist_sha256}")
  string(RANDOM LENGTH 8 suffix)
  set(scratch "${legwright_deps}/.sdist-${suffix}")
  file(WRITE "${scratch}/requirement.txt"
       "${package}==${version} --hash=sha256:${hash}\n")
  message(STATUS "Downloading the sources ${package}==${version}")
  execute_process(
    COMMAND "${python}" -m pip download --quiet --disable-pip-version-check --no-deps
            --no-binary "${package}" --require-hashes --dest "${scratch}"
            --requirement "${scratch}/requirement.txt"
    RESULT_VARIABLE failed ERROR_VARIABLE reason)
  if(failed)
    file(REMOVE_RECURSE "${scratch}")
    if(reason MATCHES "DO NOT MATCH THE HASHES")
      message(FATAL_ERROR "The MuJoCo sources that pip found are not the pinned ones:\n${reason}\n"
              "Name sources you trust with -DLEGWRIGHT_MUJOCO_SOURCE=DIR, or do without a viewer: "
              "-DLEGWRIGHT_VIEWER=OFF.")
    endif()
    message(STATUS "pip cannot download the sources of MuJoCo: ${reason}")
    return()
  endif()
  set(archive "${legwright_mujoco_${version}_sdist}")
  file(ARCHIVE_EXTRACT INPUT "${scratch}/${archive}" DESTINATION "${scratch}"
       PATTERNS "*/mujoco/simulate/*" "*/LICENSE*")
  string(REPLACE ".tar.gz" "" folder "${archive}")
  file(RENAME "${scratch}/${folder}" "${destination}" RESULT taken)
  file(REMOVE_RECURSE "${scratch}")
endfunction()

# What stands in the way of a viewer, or nothing, into `result`; the folder of its sources into `folder`.
function(legwright_prepare_simulate result folder)
  find_package(glfw3 3.3 QUIET)
  find_path(LEGWRIGHT_LODEPNG_INCLUDE_DIR lodepng.h)
  find_library(LEGWRIGHT_LODEPNG_LIBRARY lodepng)
  if(NOT glfw3_FOUND OR NOT LEGWRIGHT_LODEPNG_INCLUDE_DIR OR NOT LEGWRIGHT_LODEPNG_LIBRARY)
    set(${result} "GLFW or lodepng is missing: run tools/setup, or apt-get install libglfw3-dev \
liblodepng-dev, and configure again" PARENT_SCOPE)
    return()
  endif()
  set(sources "${LEGWRIGHT_MUJOCO_SOURCE}")
  if(NOT sources)
    set(sources "${legwright_deps}/mujoco-${LEGWRIGHT_MUJOCO_VERSION}-source")
    if(NOT EXISTS "${sources}/mujoco/simulate/main.cc")
      legwright_download_mujoco_sdist("${LEGWRIGHT_MUJOCO_VERSION}" "${sources}")
    endif()
  endif()
  if(NOT EXISTS "${sources}/mujoco/simulate/main.cc")
    set(${result} "no sources of MuJoCo in ${sources}: configure again with a network, or name an \
unpacked sdist in LEGWRIGHT_MUJOCO_SOURCE" PARENT_SCOPE)
    return()
  endif()
  set(${result} "" PARENT_SCOPE)
  set(${folder} "${sources}/mujoco/simulate" PARENT_SCOPE)
endfunction()

if(NOT LEGWRIGHT_VIEWER)
  set(legwright_no_viewer "LEGWRIGHT_VIEWER is OFF: configure with -DLEGWRIGHT_VIEWER=ON")
  return()
endif()
legwright_prepare_simulate(legwright_no_viewer simulate)
if(legwright_no_viewer)
  message(STATUS "NO VIEWER will be built: ${legwright_no_viewer}")
  return()
endif()

find_package(glfw3 3.3 REQUIRED)
find_package(Threads REQUIRED)
# Not ours: no warnings, no sanitizers, and found by nothing but these two.
add_library(mujoco_simulate STATIC
  ${simulate}/glfw_adapter.cc
  ${simulate}/glfw_dispatch.cc
  ${simulate}/platform_ui_adapter.cc
  ${simulate}/simulate.cc)
target_include_directories(mujoco_simulate SYSTEM PUBLIC "${simulate}"
                           PRIVATE "${LEGWRIGHT_LODEPNG_INCLUDE_DIR}")
target_link_libraries(mujoco_simulate PUBLIC mujoco::mujoco Threads::Threads
                      PRIVATE glfw "${LEGWRIGHT_LODEPNG_LIBRARY}")
add_executable(simulate ${simulate}/main.cc)
target_link_libraries(simulate PRIVATE mujoco_simulate)
add_dependencies(simulate legwright_plugin)  # found beside it at run time
foreach(target mujoco_simulate simulate)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -w)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endforeach()
set_target_properties(simulate PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
