# SPDX-License-Identifier: GPL-3.0-or-later
# The package that find_package(interstice) finds: it brings its find module for OpenFOAM, whose types
# the headers name, along; LIGGGHTS stays inside the library.
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/interstice")
configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/intersticeConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/intersticeConfig.cmake"
    INSTALL_DESTINATION ${package})
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/intersticeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)

install(EXPORT intersticeTargets NAMESPACE interstice:: DESTINATION ${package})
install(FILES
    "${PROJECT_BINARY_DIR}/intersticeConfig.cmake"
    "${PROJECT_BINARY_DIR}/intersticeConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindOpenFOAM.cmake"
    DESTINATION ${package})
