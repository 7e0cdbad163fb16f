# SPDX-License-Identifier: Apache-2.0
# `cmake --install build --prefix DIR`: the program with its plugin, and the libraries for
# find_package(legwright). MuJoCo comes along: plugin and program hold for one version of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(private_lib "${CMAKE_INSTALL_LIBDIR}/legwright")
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/legwright")

set(programs legwright)
foreach(viewer legwright_viewer simulate)
  if(TARGET ${viewer})
    list(APPEND programs ${viewer})
  endif()
endforeach()
file(RELATIVE_PATH up "/${CMAKE_INSTALL_BINDIR}" "/${private_lib}")
set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/${up}")
install(TARGETS ${programs} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS legwright_plugin
        LIBRARY DESTINATION "${CMAKE_INSTALL_BINDIR}/mujoco_plugin")  # beside what scans it
foreach(version IN LISTS legwright_other_plugin_versions)  # for hosts with another MuJoCo
  install(TARGETS legwright_plugin_${version}
          LIBRARY DESTINATION "${CMAKE_INSTALL_BINDIR}/legwright_plugins/${version}")
endforeach()
install(FILES "${legwright_mujoco_root}/${legwright_mujoco_library}"
        DESTINATION "${private_lib}")

set_target_properties(legwright_optimizer PROPERTIES EXPORT_NAME optimizer)
set_target_properties(legwright_mjcf PROPERTIES EXPORT_NAME mjcf)
set_target_properties(legwright_trajectory PROPERTIES EXPORT_NAME trajectory)
set_target_properties(legwright_cholmod PROPERTIES EXPORT_NAME cholmod)
install(TARGETS legwright_optimizer legwright_mjcf legwright_trajectory legwright_cholmod
        EXPORT legwrightTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/legwright")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/optimizer" "${PROJECT_SOURCE_DIR}/mjcf"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/legwright" FILES_MATCHING PATTERN "*.hpp")
install(FILES plugin/trajectory.hpp plugin/spline.hpp plugin/planned_motion.hpp
              plugin/number_text.hpp
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/legwright/plugin")
install(DIRECTORY "${legwright_mujoco_root}/include/mujoco"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/legwright")

install(EXPORT legwrightTargets NAMESPACE legwright:: DESTINATION "${package_folder}")
configure_package_config_file(cmake/legwrightConfig.cmake.in
  "${PROJECT_BINARY_DIR}/legwrightConfig.cmake" INSTALL_DESTINATION "${package_folder}"
  PATH_VARS private_lib CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/legwrightConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/legwrightConfig.cmake"
              "${PROJECT_BINARY_DIR}/legwrightConfigVersion.cmake"
        DESTINATION "${package_folder}")
install(DIRECTORY modules/ DESTINATION "${CMAKE_INSTALL_DATADIR}/legwright/modules"
        FILES_MATCHING PATTERN "*.toml")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
