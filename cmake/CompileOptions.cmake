# SPDX-License-Identifier: GPL-3.0-or-later
# How every file of ours is compiled. No flag relaxes IEEE arithmetic: balances are tested to round-off, and
# LIGGGHTS through the coupler to the last bit.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

add_library(interphase_options INTERFACE)
target_compile_options(interphase_options INTERFACE -Wall -Wextra)
# Off by default and in the preset that users build with: another compiler's new warning must not keep anybody from running a
# case. On in the preset sanitize, and in .ci/run for everything.
if(INTERPHASE_WERROR)
    target_compile_options(interphase_options INTERFACE -Werror)
endif()
if(INTERPHASE_NATIVE)
    target_compile_options(interphase_options INTERFACE -march=native)
endif()
if(INTERPHASE_SANITIZE)
    set(_sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined)
    target_compile_options(interphase_options INTERFACE ${_sanitizers} -fno-omit-frame-pointer)
    target_link_options(interphase_options INTERFACE ${_sanitizers})
    # OpenFOAM's headers shift negative numbers (labelBits.H); GCC takes the std::regex of the engines' parts for uninitialised where it
    # is instrumented.
    if(INTERPHASE_ENGINES)
        target_compile_options(interphase_options INTERFACE -fno-sanitize=shift -Wno-maybe-uninitialized)
    endif()
endif()
