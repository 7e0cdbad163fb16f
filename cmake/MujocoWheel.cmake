# SPDX-License-Identifier: Apache-2.0
# Defines mujoco::mujoco: the pinned PyPI wheel, downloaded once into .deps/ with its hash checked,
# or the unpacked `mujoco` package that LEGWRIGHT_MUJOCO_ROOT names.
set(LEGWRIGHT_MUJOCO_VERSION 3.17.0)  # the only place that names the version
set(LEGWRIGHT_MUJOCO_HEADER_VERSION 3017000)
set(LEGWRIGHT_MUJOCO_WHEEL_SHA256
    d66928d86a2d1b601bbaa4dc11db50214d17d5301bb8afd84721313b67ff0874)
set(LEGWRIGHT_MUJOCO_ROOT "" CACHE PATH "Unpacked mujoco package of that version (skips the download)")

set(legwright_deps "${PROJECT_SOURCE_DIR}/.deps")  # git-ignored, shared by all build trees
set(legwright_mujoco_root "${LEGWRIGHT_MUJOCO_ROOT}")

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

function(legwright_download_mujoco_wheel destination)
  legwright_find_pip(python)
  message(STATUS "Downloading the wheel mujoco==${LEGWRIGHT_MUJOCO_VERSION}")
  execute_process(
    COMMAND "${python}" -m pip download --quiet --disable-pip-version-check --no-deps
            --only-binary :all: --python-version 311 --platform manylinux_2_28_x86_64
            --dest "${legwright_deps}/wheels" "mujoco==${LEGWRIGHT_MUJOCO_VERSION}"
            COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB wheel "${legwright_deps}/wheels/mujoco-${LEGWRIGHT_MUJOCO_VERSION}-*.whl")
  file(SHA256 "${wheel}" hash)
  if(NOT hash STREQUAL LEGWRIGHT_MUJOCO_WHEEL_SHA256)
    file(REMOVE "${wheel}")
    message(FATAL_ERROR "The MuJoCo wheel ${wheel} has SHA-256 ${hash}, expected "
            "${LEGWRIGHT_MUJOCO_WHEEL_SHA256}. It was removed; configure again, or name a "
            "MuJoCo you trust with -DLEGWRIGHT_MUJOCO_ROOT=DIR.")
  endif()
  file(ARCHIVE_EXTRACT INPUT "${wheel}" DESTINATION "${destination}"
       PATTERNS "mujoco/include/*" "mujoco/libmujoco*" "mujoco/plugin/*" "*.dist-info/*")
endfunction()

if(NOT legwright_mujoco_root)
  set(unpacked "${legwright_deps}/mujoco-${LEGWRIGHT_MUJOCO_VERSION}")
  set(legwright_mujoco_root "${unpacked}/mujoco")
  if(NOT EXISTS "${legwright_mujoco_root}/include/mujoco/mujoco.h")
    legwright_download_mujoco_wheel("${unpacked}")
  endif()
endif()

file(STRINGS "${legwright_mujoco_root}/include/mujoco/mujoco.h" found
     REGEX "define mjVERSION_HEADER +[0-9]+")
if(NOT found MATCHES "${LEGWRIGHT_MUJOCO_HEADER_VERSION}")
  message(FATAL_ERROR "MuJoCo ${LEGWRIGHT_MUJOCO_VERSION} expected in ${legwright_mujoco_root}, "
          "found: ${found}. Unset LEGWRIGHT_MUJOCO_ROOT to download the right one.")
endif()

set(legwright_mujoco_library "libmujoco.so.${LEGWRIGHT_MUJOCO_VERSION}")
add_library(mujoco::mujoco SHARED IMPORTED GLOBAL)
set_target_properties(mujoco::mujoco PROPERTIES
  IMPORTED_LOCATION "${legwright_mujoco_root}/${legwright_mujoco_library}"
  IMPORTED_SONAME "${legwright_mujoco_library}"
  INTERFACE_INCLUDE_DIRECTORIES "${legwright_mujoco_root}/include")
