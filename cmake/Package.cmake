# SPDX-License-Identifier: GPL-3.0-or-later
# What find_package(interphase) finds, in an installation and in this build folder.
include(CMakePackageConfigHelpers)

# <interphase/plugin.hpp>, which includes "step/solid_stress.hpp"
set(_headers "${PROJECT_BINARY_DIR}/include")
configure_file("${PROJECT_SOURCE_DIR}/coupler/engines/liggghts/plugin.hpp" "${_headers}/interphase/plugin.hpp" COPYONLY)
configure_file("${PROJECT_SOURCE_DIR}/coupler/step/solid_stress.hpp" "${_headers}/interphase/step/solid_stress.hpp" COPYONLY)
add_library(interphase_plugin INTERFACE)
add_library(interphase::plugin ALIAS interphase_plugin)
set_target_properties(interphase_plugin PROPERTIES EXPORT_NAME plugin)
target_compile_features(interphase_plugin INTERFACE cxx_std_17)
target_include_directories(interphase_plugin INTERFACE
    "$<BUILD_INTERFACE:${_headers}>" "$<INSTALL_INTERFACE:include>")
target_link_libraries(interphase_plugin INTERFACE LIGGGHTS::liggghts)

install(FILES "${_headers}/interphase/plugin.hpp" DESTINATION include/interphase)
install(FILES "${_headers}/interphase/step/solid_stress.hpp" DESTINATION include/interphase/step)
install(TARGETS interphase_plugin interphase interphase-liggghts EXPORT interphaseTargets RUNTIME DESTINATION bin)

set(_package_files
    "${PROJECT_SOURCE_DIR}/cmake/interphaseConfig.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/InterphasePlugin.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/FindLIGGGHTS.cmake")
foreach(_file IN LISTS _package_files)
    configure_file("${_file}" "${PROJECT_BINARY_DIR}" COPYONLY)
endforeach()
write_basic_package_version_file("${PROJECT_BINARY_DIR}/interphaseConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
set(_root "${LIGGGHTS_ROOT}")
if(NOT _root)
    set(_root "$ENV{LIGGGHTS_ROOT}")
endif()
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/interphaseLIGGGHTS.cmake" @ONLY CONTENT [[
if(NOT LIGGGHTS_ROOT)
    set(LIGGGHTS_ROOT "@_root@")
endif()
]])

export(EXPORT interphaseTargets NAMESPACE interphase:: FILE "${PROJECT_BINARY_DIR}/interphaseTargets.cmake")
install(EXPORT interphaseTargets NAMESPACE interphase:: DESTINATION lib/cmake/interphase)
install(FILES ${_package_files}
    "${PROJECT_BINARY_DIR}/interphaseConfigVersion.cmake" "${PROJECT_BINARY_DIR}/interphaseLIGGGHTS.cmake"
    DESTINATION lib/cmake/interphase)
