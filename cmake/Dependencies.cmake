# SPDX-License-Identifier: GPL-3.0-or-later
# What the project stands on; each message of a missing one ends with the same remedy.
set(_remedy "tools/setup installs what is missing.")

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

# The C++ bindings of MPI, removed from the standard, are not used.
set(MPI_CXX_SKIP_MPICXX TRUE)
find_package(MPI COMPONENTS C CXX)
if(NOT MPI_CXX_FOUND)
    message(FATAL_ERROR "No MPI for C++ found. ${_remedy}")
endif()

find_package(Eigen3 3.4 NO_MODULE QUIET)
if(NOT TARGET Eigen3::Eigen)
    message(FATAL_ERROR "Eigen 3.4 not found. ${_remedy}")
endif()

# HDF5 must be built on the same MPI. Debian keeps that flavour beside the serial one, under a pkg-config name of its own.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND AND NOT DEFINED HDF5_ROOT AND NOT DEFINED ENV{HDF5_ROOT})
    pkg_check_modules(HDF5_OPENMPI QUIET IMPORTED_TARGET hdf5-openmpi)
endif()
add_library(interphase_hdf5 INTERFACE)
if(TARGET PkgConfig::HDF5_OPENMPI)
    target_link_libraries(interphase_hdf5 INTERFACE PkgConfig::HDF5_OPENMPI)
else()
    set(HDF5_PREFER_PARALLEL TRUE)
    find_package(HDF5 COMPONENTS C)
    if(NOT HDF5_FOUND OR NOT HDF5_IS_PARALLEL)
        message(FATAL_ERROR "HDF5 built on MPI not found (found: '${HDF5_C_LIBRARIES}', parallel: '${HDF5_IS_PARALLEL}'). "
            "${_remedy} For one of your own give -DHDF5_ROOT=<folder>.")
    endif()
    target_link_libraries(interphase_hdf5 INTERFACE hdf5::hdf5)
endif()

find_package(OpenSSL 3 COMPONENTS Crypto QUIET)
if(NOT TARGET OpenSSL::Crypto)
    message(FATAL_ERROR "OpenSSL 3 (libcrypto) not found. ${_remedy}")
endif()

if(INTERPHASE_ENGINES)
    find_package(OpenFOAM REQUIRED)
    find_package(LIGGGHTS REQUIRED)
endif()

if(INTERPHASE_TESTS)
    find_package(GTest QUIET)
    if(NOT TARGET GTest::gtest)
        message(FATAL_ERROR "GoogleTest not found. ${_remedy} -DINTERPHASE_TESTS=OFF builds without the tests.")
    endif()
    find_package(Python3 COMPONENTS Interpreter QUIET)
endif()
