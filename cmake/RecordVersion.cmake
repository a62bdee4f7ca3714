# SPDX-License-Identifier: GPL-3.0-or-later
#[[
cmake -DTEMPLATE=... -DOUTPUT=... -DSOURCE=... -DVERSION=... -DCOMPILER=... -DFLAGS=... -DBUILD_TYPE=... -P RecordVersion.cmake

Run by every build: fills TEMPLATE with what the build is made from. OUTPUT is touched only where something has changed, so
that a new commit compiles one file. A source tree that is no git checkout of its own (an unpacked archive, maybe inside
somebody's repository) has commit "unknown".
]]
set(COMMIT unknown)
set(CHANGES unknown)
find_program(GIT git)
if(GIT)
    execute_process(COMMAND "${GIT}" rev-parse --show-toplevel HEAD WORKING_DIRECTORY "${SOURCE}"
        RESULT_VARIABLE failed OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REPLACE "\n" ";" answer "${answer}")
    list(LENGTH answer lines)
    if(NOT failed AND lines EQUAL 2)
        list(GET answer 0 top)
        file(REAL_PATH "${top}" top)
        file(REAL_PATH "${SOURCE}" here)
        if(top STREQUAL here)
            list(GET answer 1 COMMIT)
            execute_process(COMMAND "${GIT}" --no-optional-locks status --porcelain --untracked-files=no WORKING_DIRECTORY "${SOURCE}"
                RESULT_VARIABLE failed OUTPUT_VARIABLE changed ERROR_QUIET)
            if(NOT failed)
                if(changed STREQUAL "")
                    set(CHANGES no)
                else()
                    set(CHANGES yes)
                endif()
            endif()
        endif()
    endif()
endif()
string(STRIP "${FLAGS}" FLAGS)
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
