# SPDX-License-Identifier: Apache-2.0
# Precompiled headers: half of what compiling costs is parsing the same headers of libraries. Each
# group is compiled once for each optimisation level and shared by all targets of that kind.
# Not by clang through ccache: what clang precompiles names files of its own checkout, and another one
# could not be served from the cache.
set(LEGWRIGHT_PRECOMPILE ON)
if(LEGWRIGHT_CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(LEGWRIGHT_PRECOMPILE OFF)
endif()
option(LEGWRIGHT_PRECOMPILED_HEADERS "Precompile the headers of libraries" ${LEGWRIGHT_PRECOMPILE})

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
if(LEGWRIGHT_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()

set(standard <algorithm> <array> <cmath> <cstddef> <functional> <limits> <map> <memory> <optional>
    <span> <stdexcept> <string> <string_view> <utility> <vector>)
set(eigen <Eigen/Core> <Eigen/Geometry>)
set(tools ${standard} <filesystem> ${eigen} <fmt/format.h> <mujoco/mujoco.h> <nlohmann/json.hpp>)

# group: headers, then the targets that bring their include paths
set(legwright_headers_files ${standard} <filesystem> <fmt/format.h> <nlohmann/json.hpp>)
set(legwright_links_files fmt::fmt nlohmann_json::nlohmann_json)
set(legwright_headers_optimizer ${standard} ${eigen} <Eigen/SparseCore>)
set(legwright_links_optimizer Eigen3::Eigen)
set(legwright_headers_mjcf ${standard} <filesystem> ${eigen} <fmt/format.h> <mujoco/mujoco.h>)
set(legwright_links_mjcf Eigen3::Eigen fmt::fmt mujoco::mujoco)
set(legwright_headers_tools ${tools})
set(legwright_links_tools ${legwright_links_mjcf} nlohmann_json::nlohmann_json)
set(legwright_headers_verbs ${tools} <CLI/CLI.hpp>)
set(legwright_links_verbs ${legwright_links_tools} CLI11::CLI11)
set(legwright_headers_tests ${tools} <gtest/gtest.h>)
set(legwright_links_tests ${legwright_links_tools} GTest::gtest)

function(legwright_precompile name group optimize)
  string(MAKE_C_IDENTIFIER "${optimize}" level)
  set(shared legwright_precompiled_${group}${level})
  if(NOT TARGET ${shared})
    file(WRITE "${PROJECT_BINARY_DIR}/precompiled/empty.cpp" "")
    add_library(${shared} OBJECT "${PROJECT_BINARY_DIR}/precompiled/empty.cpp")
    legwright_target(${shared} OPTIMIZE "${optimize}")
    target_link_libraries(${shared} PRIVATE ${legwright_links_${group}})
    target_precompile_headers(${shared} PRIVATE ${legwright_headers_${group}})
    # What ccache needs to look into a precompiled header.
    target_compile_options(${shared} PRIVATE -fpch-preprocess)
  endif()
  get_target_property(type ${name} TYPE)
  if(type STREQUAL "EXECUTABLE")  # libraries say themselves what they use
    target_link_libraries(${name} PRIVATE ${legwright_links_${group}})
  endif()
  target_compile_options(${name} PRIVATE -fpch-preprocess)
  target_precompile_headers(${name} REUSE_FROM ${shared})
endfunction()
