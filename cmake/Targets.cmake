# SPDX-License-Identifier: Apache-2.0
# What every target of ours has in common: the standard, warnings, sanitizers, precompiled headers,
# where programs land.
include(${CMAKE_CURRENT_LIST_DIR}/Ccache.cmake)

# legwright_target(NAME [PRECOMPILED GROUP] [OPTIMIZE LEVEL]): GROUP is one of those in
# cmake/Precompiled.cmake; LEVEL replaces the -O of the Release configuration where speed does not
# matter and compile time does; -O0 replaces that of any configuration.
function(legwright_target name)
  cmake_parse_arguments(arg "" "PRECOMPILED;OPTIMIZE" "" ${ARGN})
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
                        RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  target_include_directories(${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -ffp-contract=off  # same bits on every machine of one kind
    "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/="  # same bytes in every checkout
    -fPIC  # programs too: they share precompiled headers with the libraries
    $<$<BOOL:${LEGWRIGHT_WARNINGS_AS_ERRORS}>:-Werror>
    $<$<CONFIG:Debug>:-D_GLIBCXX_ASSERTIONS>)
  if(arg_OPTIMIZE STREQUAL "-O0")
    target_compile_options(${name} PRIVATE -O0)
  elseif(arg_OPTIMIZE)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:${arg_OPTIMIZE}>)
  endif()
  if(LEGWRIGHT_SANITIZE)
    # GCC says itself that sanitizers make it take initialised things (std::regex) for uninitialised
    # ones.
    # Left out of UBSan are the checks of each pointer before its use, a fifth of clang's compile
    # time: a null or stray one ends in AddressSanitizer's report all the same; and pointer-overflow,
    # which takes a block of one of Eigen's empty matrices for an error. Nobody checks alignment.
    target_compile_definitions(${name} PRIVATE LEGWRIGHT_SANITIZED)
    target_compile_options(${name} PRIVATE -fsanitize=address,undefined
                           -fno-sanitize=null,alignment,object-size,nonnull-attribute
                           -fno-sanitize=returns-nonnull-attribute,pointer-overflow
                           -fno-sanitize-recover=undefined -fno-omit-frame-pointer
                           $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${name} PRIVATE -fsanitize=address,undefined)
  endif()
  if(arg_PRECOMPILED AND LEGWRIGHT_PRECOMPILED_HEADERS)
    legwright_precompile(${name} ${arg_PRECOMPILED} "${arg_OPTIMIZE}")
  endif()
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/Precompiled.cmake)
