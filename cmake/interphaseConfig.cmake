# SPDX-License-Identifier: GPL-3.0-or-later
#[[
find_package(interphase), for plug-ins outside its tree: from an installation (CMAKE_PREFIX_PATH) or a build folder
(-Dinterphase_DIR=<interphase>/build/release). Makes interphase_add_plugin (InterphasePlugin.cmake), the programs
interphase::interphase and interphase::interphase-liggghts, interphase::contacts, which finds contacts for a law of one's own
(<interphase/contacts/fix_contacts.hpp>), interphase::hard_sphere and interphase::mp_pic, of which laws of impacts and stresses of the solids are made
(<interphase/hard_sphere/fix_tdhs_of.hpp>, <interphase/mp_pic/fix_mp_pic_of.hpp>), and interphase::plugin: the header <interphase/plugin.hpp>, what of the
coupler's folder base the plug-ins of interphase's own tree use (<interphase/base/text.hpp>, <interphase/base/vector.hpp>), and the
LIGGGHTS, MPI and Eigen that these need.
]]
include(CMakeFindDependencyMacro)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_dependency(Threads)
set(MPI_CXX_SKIP_MPICXX TRUE)
find_dependency(MPI COMPONENTS CXX)
find_dependency(Eigen3 3.4 NO_MODULE)

# The LIGGGHTS that interphase is built with, unless the project says otherwise.
include("${CMAKE_CURRENT_LIST_DIR}/interphaseLIGGGHTS.cmake")
set(_interphase_module_path "${CMAKE_MODULE_PATH}")
list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_dependency(LIGGGHTS)
set(CMAKE_MODULE_PATH "${_interphase_module_path}")

include("${CMAKE_CURRENT_LIST_DIR}/interphaseTargets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/InterphasePlugin.cmake")
