# SPDX-License-Identifier: GPL-3.0-or-later
# What plug-ins are built with, in this tree and outside, and what find_package(interphase) finds, in an installation and in this
# build folder.
include(CMakePackageConfigHelpers)

# The headers of a plug-in: <interphase/plugin.hpp>; and what that and plug-ins of this tree include by "plugin/...", "base/..." and,
# of what plug-ins share, "contacts/...", "walls/...", "script/...", "hard_sphere/..." and "mp_pic/...".
# Links, so that whoever sees the coupler's folder, too, sees one file and not two.
set(_root "${PROJECT_BINARY_DIR}/include/interphase")
set(_headers plugin/plugin.hpp plugin/solid_stress.hpp plugin/wall_gaps.hpp plugin/method.hpp plugin/counter.hpp plugin/fingerprint.hpp base/vector.hpp base/text.hpp base/problem.hpp base/exit_code.hpp)
set(_shared_headers contacts/fix_contacts.hpp contacts/fix_contacts_with_memory.hpp contacts/contact.hpp contacts/contact_memory.hpp
    contacts/cells.hpp contacts/exchange_room.hpp contacts/ghost_reach.hpp walls/fix_wall.hpp walls/mesh_load.hpp walls/of_all_ranks.hpp walls/wall_set.hpp walls/wall.hpp walls/triangle_wall.hpp walls/place.hpp script/script.hpp
    hard_sphere/any_law.hpp hard_sphere/attraction.hpp hard_sphere/batch_builder.hpp hard_sphere/bodies.hpp hard_sphere/cell_grid.hpp hard_sphere/cluster.hpp hard_sphere/contact.hpp
    hard_sphere/contact_batch.hpp hard_sphere/contact_solver.hpp hard_sphere/cost.hpp hard_sphere/counters.hpp hard_sphere/effort.hpp hard_sphere/fix_tdhs.hpp
    hard_sphere/fix_tdhs_of.hpp hard_sphere/fix_wall_tdhs.hpp hard_sphere/impact.hpp hard_sphere/impulse_memory.hpp
    hard_sphere/lane_numbers.hpp hard_sphere/messages.hpp hard_sphere/lanes.hpp hard_sphere/law.hpp hard_sphere/law_check.hpp hard_sphere/law_functions.hpp hard_sphere/law_of.hpp hard_sphere/material.hpp
    hard_sphere/pair_search.hpp hard_sphere/processor.hpp hard_sphere/response.hpp hard_sphere/step_limits.hpp hard_sphere/sweep.hpp
    mp_pic/any_stress.hpp mp_pic/counters.hpp mp_pic/fix_mp_pic.hpp mp_pic/fix_mp_pic_of.hpp mp_pic/fix_wall_mp_pic.hpp mp_pic/stress.hpp mp_pic/wall_bounce.hpp)
function(_lay_out root)
    foreach(_header IN LISTS ARGN)
        get_filename_component(_folder "${_header}" DIRECTORY)
        file(MAKE_DIRECTORY "${_root}/${_folder}")
        file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${root}/${_header}" "${_root}/${_header}" SYMBOLIC)
        install(FILES "${PROJECT_SOURCE_DIR}/${root}/${_header}" DESTINATION "include/interphase/${_folder}")
    endforeach()
endfunction()
_lay_out(coupler ${_headers})
_lay_out(plugins ${_shared_headers})
file(CONFIGURE OUTPUT "${_root}/plugin.hpp" CONTENT
    "// SPDX-License-Identifier: GPL-3.0-or-later\n#pragma once\n\n#include \"plugin/plugin.hpp\"\n")
install(FILES "${_root}/plugin.hpp" DESTINATION include/interphase)

# What base/*.hpp of them declare; knows no engine.
add_library(interphase_base STATIC "${PROJECT_SOURCE_DIR}/coupler/base/text.cpp")
add_library(interphase::base ALIAS interphase_base)
set_target_properties(interphase_base PROPERTIES EXPORT_NAME base)
target_compile_features(interphase_base PUBLIC cxx_std_17)
target_include_directories(interphase_base PUBLIC "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include;${_root}>"
    "$<INSTALL_INTERFACE:include;include/interphase>")
target_link_libraries(interphase_base PUBLIC Eigen3::Eigen)
target_compile_options(interphase_base PRIVATE "$<TARGET_PROPERTY:interphase_options,INTERFACE_COMPILE_OPTIONS>")
add_dependencies(programs interphase_base)

add_library(interphase_plugin INTERFACE)
add_library(interphase::plugin ALIAS interphase_plugin)
set_target_properties(interphase_plugin PROPERTIES EXPORT_NAME plugin)
target_link_libraries(interphase_plugin INTERFACE interphase_base LIGGGHTS::liggghts)

install(TARGETS interphase_base interphase_plugin interphase interphase-liggghts EXPORT interphaseTargets
    RUNTIME DESTINATION bin ARCHIVE DESTINATION lib/interphase)

set(_package_files
    "${PROJECT_SOURCE_DIR}/cmake/interphaseConfig.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/InterphasePlugin.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/FindLIGGGHTS.cmake")
foreach(_file IN LISTS _package_files)
    configure_file("${_file}" "${PROJECT_BINARY_DIR}" COPYONLY)
endforeach()
write_basic_package_version_file("${PROJECT_BINARY_DIR}/interphaseConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
set(_liggghts "${LIGGGHTS_ROOT}")
if(NOT _liggghts)
    set(_liggghts "$ENV{LIGGGHTS_ROOT}")
endif()
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/interphaseLIGGGHTS.cmake" @ONLY CONTENT [[
if(NOT LIGGGHTS_ROOT)
    set(LIGGGHTS_ROOT "@_liggghts@")
endif()
]])

export(EXPORT interphaseTargets NAMESPACE interphase:: FILE "${PROJECT_BINARY_DIR}/interphaseTargets.cmake")
install(EXPORT interphaseTargets NAMESPACE interphase:: DESTINATION lib/cmake/interphase)
install(FILES ${_package_files}
    "${PROJECT_BINARY_DIR}/interphaseConfigVersion.cmake" "${PROJECT_BINARY_DIR}/interphaseLIGGGHTS.cmake"
    DESTINATION lib/cmake/interphase)
