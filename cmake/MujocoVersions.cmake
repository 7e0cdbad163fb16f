# SPDX-License-Identifier: Apache-2.0
# The releases of MuJoCo that Legwright is built and tested with, newest first: the only place that
# names them. Each has its package on PyPI, its wheel (x86-64, CPython 3.11; the library in it is the
# same for all) and its sdist with their SHA-256, what mjVERSION_HEADER is in its headers, and what
# pip installs for its viewer in Python.
set(LEGWRIGHT_MUJOCO_VERSIONS 4.0.1 4.0.0 3.17.0)
set(LEGWRIGHT_MUJOCO_VERSION 4.0.1 CACHE STRING
    "The MuJoCo to build with: one of ${LEGWRIGHT_MUJOCO_VERSIONS}")
set_property(CACHE LEGWRIGHT_MUJOCO_VERSION PROPERTY STRINGS ${LEGWRIGHT_MUJOCO_VERSIONS})

set(wheel_tags cp311-cp311-manylinux_2_27_x86_64.manylinux_2_28_x86_64)

set(legwright_mujoco_4.0.1_package mujoco-core)
set(legwright_mujoco_4.0.1_header 4000001)
set(legwright_mujoco_4.0.1_viewer "mujoco-core[rendering]")
set(legwright_mujoco_4.0.1_wheel mujoco_core-4.0.1-${wheel_tags}.whl)
set(legwright_mujoco_4.0.1_wheel_sha256
    be28c0c7587347ef996b4de0487264e9da296282082b092bae211a9163e9aed6)
set(legwright_mujoco_4.0.1_sdist mujoco_core-4.0.1.tar.gz)
set(legwright_mujoco_4.0.1_sdist_sha256
    062883cac035b1b3ae6a769cccd155ecc8f06d8c1cb004c33e01d1cb0f0ccf49)

set(legwright_mujoco_4.0.0_package mujoco-core)
set(legwright_mujoco_4.0.0_header 4000000)
set(legwright_mujoco_4.0.0_viewer "mujoco-core[rendering]")
set(legwright_mujoco_4.0.0_wheel mujoco_core-4.0.0-${wheel_tags}.whl)
set(legwright_mujoco_4.0.0_wheel_sha256
    885bd9b9cc0a6b5ba1114923eb954027652a6a0c115fa46b3218b83bae72ac4f)
set(legwright_mujoco_4.0.0_sdist mujoco_core-4.0.0.tar.gz)
set(legwright_mujoco_4.0.0_sdist_sha256
    7300cc232f27ceb8694aa45b26c790667eebd4a06286156b49b9726e3bf1d7cf)

set(legwright_mujoco_3.17.0_package mujoco)
set(legwright_mujoco_3.17.0_header 3017000)
set(legwright_mujoco_3.17.0_viewer mujoco)
set(legwright_mujoco_3.17.0_wheel mujoco-3.17.0-${wheel_tags}.whl)
set(legwright_mujoco_3.17.0_wheel_sha256
    d66928d86a2d1b601bbaa4dc11db50214d17d5301bb8afd84721313b67ff0874)
set(legwright_mujoco_3.17.0_sdist mujoco-3.17.0.tar.gz)
set(legwright_mujoco_3.17.0_sdist_sha256
    5e49c15905e7a39eaa1efb1cae809a81c5f5c2439467f23e7e6e383624d957be)

# Stops at a version that the table has not; `option` is the name of what asked for it.
function(legwright_require_mujoco_version version option)
  if(NOT version IN_LIST LEGWRIGHT_MUJOCO_VERSIONS)
    list(JOIN LEGWRIGHT_MUJOCO_VERSIONS ", " known)
    message(FATAL_ERROR "${option} asks for MuJoCo '${version}', expected one of ${known}. Set it "
            "to one of these, or give '${version}' its rows in cmake/MujocoVersions.cmake.")
  endif()
endfunction()

legwright_require_mujoco_version("${LEGWRIGHT_MUJOCO_VERSION}" LEGWRIGHT_MUJOCO_VERSION)
