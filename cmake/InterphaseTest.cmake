# SPDX-License-Identifier: GPL-3.0-or-later

# Surroundings of every test. Root is common in containers, and Open MPI wants to be told; ranks share cores in a
# test, so none is bound to one and none spins while it waits; the copy between processes that containers forbid
# is not tried. When one rank leaves with an error, as many tests want, mpirun ends the others at once instead of after
# a second. OpenFOAM's libraries look for their controlDict as soon as they are loaded.
set(_interphase_test_environment
    OMPI_ALLOW_RUN_AS_ROOT=1
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_rmaps_base_oversubscribe=1
    OMPI_MCA_hwloc_base_binding_policy=none
    OMPI_MCA_mpi_yield_when_idle=1
    OMPI_MCA_btl_vader_single_copy_mechanism=none
    OMPI_MCA_odls_base_sigkill_timeout=0
    OMP_NUM_THREADS=1
    "INTERPHASE_SOURCE=${PROJECT_SOURCE_DIR}"
    "INTERPHASE_BUILD=${PROJECT_BINARY_DIR}")
# Tests in Python find the package and what other folders of tests share.
set(_interphase_python_path python tests/program tests/plugins/mp_pic tests/plugins)
list(TRANSFORM _interphase_python_path PREPEND "${PROJECT_SOURCE_DIR}/")
list(JOIN _interphase_python_path ":" _interphase_python_path)
if(OpenFOAM_PROJECT_DIR)
    list(APPEND _interphase_test_environment "WM_PROJECT_DIR=${OpenFOAM_PROJECT_DIR}")
endif()
if(INTERPHASE_SANITIZE)
    list(APPEND _interphase_test_environment UBSAN_OPTIONS=print_stacktrace=1 INTERPHASE_SANITIZED=1)
    # Of the engines: they leave memory to the system at the end, and OpenFOAM's lists tell delete another size than they told new.
    if(INTERPHASE_ENGINES)
        list(APPEND _interphase_test_environment ASAN_OPTIONS=detect_leaks=0:new_delete_type_mismatch=0)
    endif()
endif()

#[[
interphase_add_test(NAME <name> SOURCES <file>... [RANKS <n>...] [LABELS <label>...] [LIBRARIES <target>...])

A GoogleTest executable as one ctest test <name>. With RANKS it is an MPI test: <name>.np1, <name>.np2, ..., one for
each number of ranks, started by mpirun; the test fails when it fails on any rank.
LIBRARIES: what is tested besides interphase_core.
]]
function(interphase_add_test)
    cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME" "SOURCES;RANKS;LABELS;LIBRARIES")
    if(NOT test_NAME OR NOT test_SOURCES OR test_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "interphase_add_test needs NAME and SOURCES; not understood: '${test_UNPARSED_ARGUMENTS}'")
    endif()

    string(REPLACE "/" "." target "test.${test_NAME}")
    add_executable(${target} ${test_SOURCES})
    set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests/bin")
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
    target_link_libraries(${target} PRIVATE
        ${test_LIBRARIES} interphase_test_support interphase_core interphase_options GTest::gtest)

    if(NOT test_RANKS)
        target_link_libraries(${target} PRIVATE GTest::gtest_main)
        add_test(NAME ${test_NAME} COMMAND ${target})
        interphase_set_test_properties(${test_NAME} LABELS ${test_LABELS})
        return()
    endif()
    target_link_libraries(${target} PRIVATE interphase_mpi_main)
    foreach(ranks IN LISTS test_RANKS)
        set(name "${test_NAME}.np${ranks}")
        add_test(NAME ${name} COMMAND
            ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} ${MPIEXEC_PREFLAGS} $<TARGET_FILE:${target}>)
        interphase_set_test_properties(${name} LABELS mpi ${test_LABELS} PROCESSORS ${ranks})
        # Open MPI leaves memory behind from modules it has unloaded by then, so that no suppression can name them.
        # Leaks of our own are looked for in the serial tests.
        if(NOT INTERPHASE_ENGINES)
            set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
        endif()
    endforeach()
endfunction()

#[[
interphase_add_python_test(NAME <name> FILE <test_*.py>)

A file of Python's unittest as one ctest test. It finds the sources and the build folder in the environment variables
INTERPHASE_SOURCE and INTERPHASE_BUILD, and python/interphase by PYTHONPATH. Comment lines of the file say how it runs:

    # label: slow        ctest label (repeatable); tools/test leaves "slow" out unless asked
    # processors: 2      cores it keeps busy
    # timeout: 1800      seconds
]]
function(interphase_add_python_test)
    cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;FILE" "")
    get_filename_component(folder "${test_FILE}" DIRECTORY)
    get_filename_component(file "${test_FILE}" NAME)
    add_test(NAME ${test_NAME} COMMAND "${INTERPHASE_PYTHON}" -m unittest discover -s "${folder}" -p "${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${test_FILE}")

    set(labels "")
    set(processors 1)
    set(timeout 600)
    file(STRINGS "${test_FILE}" lines REGEX "^# (label|processors|timeout): *[a-z0-9_-]+$")
    foreach(line IN LISTS lines)
        string(REGEX MATCH "^# ([a-z]+): *(.+)$" _ "${line}")
        if(CMAKE_MATCH_1 STREQUAL "label")
            list(APPEND labels "${CMAKE_MATCH_2}")
        else()
            set(${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
        endif()
    endforeach()
    interphase_set_test_properties(${test_NAME} LABELS python ${labels} PROCESSORS ${processors} TIMEOUT ${timeout})
    # A bytecode cache would be written into the source tree.
    set_property(TEST ${test_NAME} APPEND PROPERTY ENVIRONMENT
        PYTHONDONTWRITEBYTECODE=1 "PYTHONPATH=${_interphase_python_path}")
endfunction()

# The time limit ends tests in which a rank waits for another one that has failed; sanitizers make all slow, four ranks on two cores most.
function(interphase_set_test_properties name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "PROCESSORS;TIMEOUT" "LABELS")
    if(NOT test_TIMEOUT)
        set(test_TIMEOUT 300)
    endif()
    if(INTERPHASE_SANITIZE)
        math(EXPR test_TIMEOUT "3 * ${test_TIMEOUT}")
    endif()
    if(NOT test_PROCESSORS)
        set(test_PROCESSORS 1)
    endif()
    set_tests_properties(${name} PROPERTIES
        ENVIRONMENT "${_interphase_test_environment};INTERPHASE_TEST=${name}"
        LABELS "${test_LABELS}"
        PROCESSORS ${test_PROCESSORS}
        TIMEOUT ${test_TIMEOUT})
endfunction()
