# SPDX-License-Identifier: Apache-2.0
# Compiles through ccache where it is installed. Paths below the source folder count relative to it,
# so that all checkouts share one cache. The relaxations are those that its manual asks for with
# precompiled headers.
find_program(LEGWRIGHT_CCACHE ccache)
mark_as_advanced(LEGWRIGHT_CCACHE)
if(LEGWRIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
      "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      "${LEGWRIGHT_CCACHE}")
endif()
