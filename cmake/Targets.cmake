# SPDX-License-Identifier: Apache-2.0
# What every target of ours has in common: the standard, warnings, sanitizers, where programs land.
function(legwright_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
                        RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -ffp-contract=off  # same bits on every machine of one kind
    $<$<BOOL:${LEGWRIGHT_WARNINGS_AS_ERRORS}>:-Werror>
    $<$<CONFIG:Debug>:-D_GLIBCXX_ASSERTIONS>)
  if(LEGWRIGHT_SANITIZE)
    # GCC says itself that sanitizers make it take initialised things (std::regex) for uninitialised.
    target_compile_options(${name} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                           -fno-omit-frame-pointer -Wno-maybe-uninitialized)
    target_link_options(${name} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()
