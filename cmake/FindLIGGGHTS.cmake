# SPDX-License-Identifier: GPL-3.0-or-later
#[[
LIGGGHTS as a library: Debian's package, or what -DLIGGGHTS_ROOT=<folder> points to (an installation with
include/liggghts and lib, or a source tree built as a shared library: its src folder).
Makes LIGGGHTS::liggghts, which defines INTERPHASE_LIGGGHTS_VERSION, a string. Neither SUPERQUADRIC_ACTIVE_FLAG nor LIGGGHTS_DEBUG may be defined for a library that
was built without them: they change the layout of its classes.
]]

find_path(LIGGGHTS_INCLUDE_DIR NAMES lammps.h HINTS "${LIGGGHTS_ROOT}" "${LIGGGHTS_ROOT}/src"
    PATH_SUFFIXES liggghts include/liggghts)
# The packaged file name first: the link without version belongs to the development package.
find_library(LIGGGHTS_LIBRARY NAMES libliggghts.so.3 liggghts HINTS "${LIGGGHTS_ROOT}" "${LIGGGHTS_ROOT}/src")
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)

# No header holds LIGGGHTS's own version (version.h names the LAMMPS it grew from); the library's file name does.
set(LIGGGHTS_VERSION "")
if(LIGGGHTS_LIBRARY)
    file(REAL_PATH "${LIGGGHTS_LIBRARY}" _file)
    string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+$" LIGGGHTS_VERSION "${_file}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
    REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
    VERSION_VAR LIGGGHTS_VERSION
    REASON_FAILURE_MESSAGE "Run tools/setup, which installs Debian's package, or give -DLIGGGHTS_ROOT=<folder>.")

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::liggghts)
    add_library(LIGGGHTS::liggghts SHARED IMPORTED GLOBAL)
    set_target_properties(LIGGGHTS::liggghts PROPERTIES
        IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS "INTERPHASE_LIGGGHTS_VERSION=\"${LIGGGHTS_VERSION}\"")
    target_link_libraries(LIGGGHTS::liggghts INTERFACE MPI::MPI_CXX)
endif()
