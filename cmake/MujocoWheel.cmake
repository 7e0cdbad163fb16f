# SPDX-License-Identifier: Apache-2.0
# Defines mujoco::mujoco: the PyPI wheel of LEGWRIGHT_MUJOCO_VERSION, downloaded once into .deps/ with
# its hash checked, or the unpacked `mujoco` package that LEGWRIGHT_MUJOCO_ROOT names.
set(LEGWRIGHT_MUJOCO_ROOT "" CACHE PATH "Unpacked mujoco package of that version (skips the download)")

set(legwright_deps "${PROJECT_SOURCE_DIR}/.deps")  # git-ignored, shared by all build trees

# The Python whose pip downloads, into `result`.
function(legwright_find_pip result)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(python "${Python3_EXECUTABLE}")
  execute_process(COMMAND "${python}" -m pip --version RESULT_VARIABLE no_pip
                  OUTPUT_QUIET ERROR_QUIET)
  if(no_pip)  # Debian's python3 may come without pip; a venv has it
    execute_process(COMMAND "${python}" -m venv "${legwright_deps}/pip" COMMAND_ERROR_IS_FATAL ANY)
    set(python "${legwright_deps}/pip/bin/python")
  endif()
  set(${result} "${python}" PARENT_SCOPE)
endfunction()

function(legwright_download_mujoco_wheel version destination)
  legwright_find_pip(python)
  set(requirement "${legwright_mujoco_${version}_package}==${version}")
  message(STATUS "Downloading the wheel ${requirement}")
  execute_process(
    COMMAND "${python}" -m pip download --quiet --disable-pip-version-check --no-deps
            --only-binary :all: --python-version 311 --platform manylinux_2_28_x86_64
            --dest "${legwright_deps}/wheels" "${requirement}"
            COMMAND_ERROR_IS_FATAL ANY)
  set(wheel "${legwright_deps}/wheels/${legwright_mujoco_${version}_wheel}")
  if(NOT EXISTS "${wheel}")
    message(FATAL_ERROR "pip took another wheel for ${requirement} than ${wheel}, which "
            "cmake/MujocoVersions.cmake names. Correct the name there, or name a MuJoCo you trust "
            "with -DLEGWRIGHT_MUJOCO_ROOT=DIR.")
  endif()
  set(expected "${legwright_mujoco_${version}_wheel_sha256}")
  file(SHA256 "${wheel}" hash)
  if(NOT hash STREQUAL expected)
    file(REMOVE "${wheel}")
    message(FATAL_ERROR "The MuJoCo wheel ${wheel} has SHA-256 ${hash}, expected ${expected}. It "
            "was removed; configure again, or name a MuJoCo you trust with "
            "-DLEGWRIGHT_MUJOCO_ROOT=DIR.")
  endif()
  file(ARCHIVE_EXTRACT INPUT "${wheel}" DESTINATION "${destination}"
       PATTERNS "mujoco/include/*" "mujoco/libmujoco*" "mujoco/plugin/*" "*.dist-info/*")
endfunction()

# The folder of the unpacked package `mujoco` of a version, into `result`; downloads what is missing.
function(legwright_find_mujoco version result)
  set(root "")
  if(version STREQUAL LEGWRIGHT_MUJOCO_VERSION)
    set(root "${LEGWRIGHT_MUJOCO_ROOT}")
  endif()
  if(NOT root)
    set(unpacked "${legwright_deps}/mujoco-${version}")
    set(root "${unpacked}/mujoco")
    if(NOT EXISTS "${root}/include/mujoco/mujoco.h")
      legwright_download_mujoco_wheel("${version}" "${unpacked}")
    endif()
  endif()
  file(STRINGS "${root}/include/mujoco/mujoco.h" found REGEX "define mjVERSION_HEADER +[0-9]+")
  if(NOT found MATCHES "mjVERSION_HEADER +${legwright_mujoco_${version}_header}$")
    message(FATAL_ERROR "MuJoCo ${version} expected in ${root}, found: ${found}. Unset "
            "LEGWRIGHT_MUJOCO_ROOT to download the right one, or name the version that is there "
            "with -DLEGWRIGHT_MUJOCO_VERSION=….")
  endif()
  set(${result} "${root}" PARENT_SCOPE)
endfunction()

legwright_find_mujoco("${LEGWRIGHT_MUJOCO_VERSION}" legwright_mujoco_root)
set(legwright_mujoco_library "libmujoco.so.${LEGWRIGHT_MUJOCO_VERSION}")
add_library(mujoco::mujoco SHARED IMPORTED GLOBAL)
set_target_properties(mujoco::mujoco PROPERTIES
  IMPORTED_LOCATION "${legwright_mujoco_root}/${legwright_mujoco_library}"
  IMPORTED_SONAME "${legwright_mujoco_library}"
  INTERFACE_INCLUDE_DIRECTORIES "${legwright_mujoco_root}/include")
