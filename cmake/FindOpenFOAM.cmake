# SPDX-License-Identifier: GPL-3.0-or-later
#[[
OpenFOAM's headers and libraries, from one of

  INTERPHASE_OPENFOAM_SRC   a folder laid out like OpenFOAM's src/ (with <library>/lnInclude below it),
  $WM_PROJECT_DIR/src       a sourced OpenFOAM environment, where it has the headers,
  build/openfoam-headers    where tools/setup unpacks the headers of Debian's packaged OpenFOAM,

in that order. Libraries come from $FOAM_LIBBIN when the headers belong to a sourced environment, from the system else.
Makes OpenFOAM::<library> of every line of cmake/openfoam-libraries.txt that names a library which is there, and
OpenFOAM::OpenFOAM, which every other links and which carries all include paths and the compile flags.
Sets OpenFOAM_FOUND, OpenFOAM_VERSION (api number: 1912), OpenFOAM_SRC, and OpenFOAM_PROJECT_DIR: the folder with
etc/controlDict, which OpenFOAM's libraries look for in $WM_PROJECT_DIR as soon as they are loaded.
]]

set(INTERPHASE_OPENFOAM_SRC "" CACHE PATH
    "OpenFOAM's src folder (with lnInclude folders); empty: a sourced environment or what tools/setup unpacked")

set(_unpacked "${PROJECT_SOURCE_DIR}/build/openfoam-headers/src")
set(_library_folders "")
if(INTERPHASE_OPENFOAM_SRC)
    set(OpenFOAM_SRC "${INTERPHASE_OPENFOAM_SRC}")
    if(NOT IS_DIRECTORY "${OpenFOAM_SRC}/OpenFOAM/lnInclude")
        message(FATAL_ERROR "INTERPHASE_OPENFOAM_SRC is '${OpenFOAM_SRC}', which has no OpenFOAM/lnInclude. "
            "Give the src folder of a built OpenFOAM, or leave the option away and run tools/setup.")
    endif()
    if("$ENV{WM_PROJECT_DIR}/src" STREQUAL OpenFOAM_SRC)
        set(_library_folders "$ENV{FOAM_LIBBIN}" "$ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI}")
    endif()
elseif(DEFINED ENV{WM_PROJECT_DIR} AND IS_DIRECTORY "$ENV{WM_PROJECT_DIR}/src/OpenFOAM/lnInclude")
    set(OpenFOAM_SRC "$ENV{WM_PROJECT_DIR}/src")
    set(_library_folders "$ENV{FOAM_LIBBIN}" "$ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI}")
elseif(IS_DIRECTORY "${_unpacked}/OpenFOAM/lnInclude")
    set(OpenFOAM_SRC "${_unpacked}")
else()
    set(OpenFOAM_SRC OpenFOAM_SRC-NOTFOUND)
endif()

if(_library_folders)
    set(OpenFOAM_PROJECT_DIR "$ENV{WM_PROJECT_DIR}")
else()
    find_path(_etc_folder etc/controlDict PATHS /usr/share/openfoam NO_DEFAULT_PATH NO_CACHE)
    set(OpenFOAM_PROJECT_DIR "${_etc_folder}")
endif()

# The file beside src/ tells the version.
set(OpenFOAM_VERSION "")
if(OpenFOAM_SRC AND EXISTS "${OpenFOAM_SRC}/../META-INFO/api-info")
    file(STRINGS "${OpenFOAM_SRC}/../META-INFO/api-info" _api REGEX "^api=[0-9]+$")
    string(REGEX REPLACE "^api=" "" OpenFOAM_VERSION "${_api}")
elseif(OpenFOAM_SRC)
    message(WARNING "${OpenFOAM_SRC}/../META-INFO/api-info is missing; taking these headers for OpenFOAM 1912's.")
    set(OpenFOAM_VERSION 1912)
endif()

set(_include_folders "")
set(_libraries "")
file(STRINGS "${PROJECT_SOURCE_DIR}/cmake/openfoam-libraries.txt" _lines REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/cmake/openfoam-libraries.txt")
foreach(_line IN LISTS _lines)
    separate_arguments(_fields UNIX_COMMAND "${_line}")
    list(GET _fields 0 _folder)
    list(GET _fields 1 _library)
    if(IS_DIRECTORY "${OpenFOAM_SRC}/${_folder}/lnInclude")
        list(APPEND _include_folders "${OpenFOAM_SRC}/${_folder}/lnInclude")
    elseif(_library STREQUAL "plain" AND IS_DIRECTORY "${OpenFOAM_SRC}/${_folder}")
        list(APPEND _include_folders "${OpenFOAM_SRC}/${_folder}")
    endif()
    if(NOT _library MATCHES "^(-|plain)$")
        # Remembered per place, so that a build folder follows when it is pointed to another OpenFOAM.
        string(MD5 _place "${_library_folders}")
        string(SUBSTRING "${_place}" 0 8 _place)
        set(_variable OpenFOAM_${_library}_LIBRARY_${_place})
        if(_library_folders)
            find_library(${_variable} ${_library} PATHS ${_library_folders} NO_DEFAULT_PATH)
        else()
            find_library(${_variable} ${_library})
        endif()
        mark_as_advanced(${_variable})
        if(${_variable})
            list(APPEND _libraries ${_library})
            set(_${_library}_file "${${_variable}}")
        endif()
    endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenFOAM
    REQUIRED_VARS OpenFOAM_SRC OpenFOAM_PROJECT_DIR _OpenFOAM_file _finiteVolume_file _Pstream_file
    VERSION_VAR OpenFOAM_VERSION
    REASON_FAILURE_MESSAGE "Run tools/setup: it installs OpenFOAM and fetches its headers. For an OpenFOAM of your own, source its etc/bashrc or give -DINTERPHASE_OPENFOAM_SRC=<its src folder>.")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::OpenFOAM)
    if(DEFINED ENV{WM_LABEL_SIZE} AND _library_folders)
        set(_label_size $ENV{WM_LABEL_SIZE})
        set(_precision $ENV{WM_PRECISION_OPTION})
    else()
        set(_label_size 32)
        set(_precision DP)
    endif()
    foreach(_library IN LISTS _libraries)
        add_library(OpenFOAM::${_library} SHARED IMPORTED GLOBAL)
        set_target_properties(OpenFOAM::${_library} PROPERTIES IMPORTED_LOCATION "${_${_library}_file}"
            IMPORTED_NO_SONAME TRUE)
        if(NOT _library STREQUAL "OpenFOAM")
            target_link_libraries(OpenFOAM::${_library} INTERFACE OpenFOAM::OpenFOAM)
        endif()
    endforeach()
    target_include_directories(OpenFOAM::OpenFOAM INTERFACE ${_include_folders})
    target_compile_definitions(OpenFOAM::OpenFOAM INTERFACE
        OPENFOAM=${OpenFOAM_VERSION} WM_${_precision} WM_LABEL_SIZE=${_label_size} NoRepository)
    target_compile_options(OpenFOAM::OpenFOAM INTERFACE -ftemplate-depth-100)
    # Libraries that only register their classes at load time must be kept although no symbol of theirs is used.
    target_link_options(OpenFOAM::OpenFOAM INTERFACE -Wl,--no-as-needed)
    target_link_libraries(OpenFOAM::OpenFOAM INTERFACE ${CMAKE_DL_LIBS} m)
endif()
